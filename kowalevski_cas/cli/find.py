"""Find what nobody has printed: open questions about the scene of a derivation.

What is found is claimed, decided and certified like any other claim.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from kowalevski_cas.cli import plain, session
from kowalevski_cas.cli.exits import AS_RECORDED, NOTHING, UNDECIDED, CommandError
from kowalevski_cas.files import read, write
from kowalevski_cas.library import owner
from kowalevski_cas.notation import NotationError, to_latex, to_plain
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.pool import Pool
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.questions import QUESTIONS, collect, forecast, nothing, question
from kowalevski_cas.schema import head
from kowalevski_cas.verify.confirm import receive, received
from kowalevski_cas.verify.finding import Finding, with_findings
from kowalevski_cas.verify.outcome import Outcome, Run
from kowalevski_cas.verify.run import Session


def _number(default: int, help: str) -> dict[str, Any]:
    return {"type": session.natural, "default": default, "metavar": "N", "help": help}


ARGUMENTS: dict[str, dict[str, dict[str, Any]]] = {
    "integrals": {
        "--degree": _number(
            0, "the highest degree (2, and with --weighted the largest Kowalevski exponent)"
        ),
        "--on": {
            "action": "append",
            "default": [],
            "metavar": "RELATION",
            "help": "on the invariant set of this equation, in LaTeX, and of others given likewise",
        },
        "--weighted": {
            "action": "store_true",
            "help": "a variable counts by its weight, for which the motion is homogeneous",
        },
    },
    "darboux": {
        "--degree": _number(2, "the highest degree (2)"),
        "--cofactor": {
            "default": "",
            "metavar": "K",
            "help": "this K only, in LaTeX; that there is no other F is proved too",
        },
        "--special": {"action": "store_true", "help": "constants may have special values as well"},
    },
    "closure": {
        "seed": {"metavar": "SEED", "help": "the function, in LaTeX, in the names of the scene"},
        "--order": _number(4, "the longest chain (4)"),
    },
    "parameters": {"polynomial": {"metavar": "POLYNOMIAL", "help": "F, in LaTeX"}},
    "exponents": {},
}
"""The arguments of each question, by which its search is called."""

LONGEST = 400
"""How many letters of formulas are printed on a line, if not all are asked for."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command, and those of each question."""
    questions = parser.add_subparsers(title="questions", metavar="QUESTION", required=True)
    for name, summary in QUESTIONS.items():
        subcommand = questions.add_parser(name, help=summary, description=question(name).__doc__)
        subcommand.set_defaults(question=name)
        subcommand.add_argument(
            "derivation", metavar="DERIVATION", help="name in the library, or folder"
        )
        subcommand.add_argument("--scene", metavar="NAME", help="the scene, by its name")
        for key, options in ARGUMENTS[name].items():
            subcommand.add_argument(key, **options)
        session.add_format(subcommand, ("pretty", "verbose", "json"), "formula")
        subcommand.add_argument(
            "--write", action="store_true", help="append what is proved of the motion to the file"
        )
        session.add_timeout(subcommand, 60.0, "for the search, and for each claim")
        session.add_pool(subcommand)


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    ((_, derivation),) = session.derivations([arguments.derivation])
    scene = _scene(derivation, arguments.scene)
    forecast(scene, arguments.question, getattr(arguments, "degree", 0))
    file, name = _owner(scene) if arguments.write else (None, "")
    pool = session.pool(arguments)
    ((findings, unfinished, run),) = session.map_in_processes(
        lambda _: _find_and_decide(derivation, scene, arguments, pool), [None]
    )
    if not unfinished:
        pool.forget()
    accepted = (receive(o, arguments.timeout, jobs=arguments.jobs) for o in run.outcomes)
    run = run._replace(outcomes=(outcomes := tuple(accepted)))
    if file is not None:
        write(file, read(file) + _in_python(findings, run, name, scene))
    if arguments.format == "json":
        found = {**head("find"), "findings": [*map(_data, findings, outcomes)]}
        found["unfinished"] = unfinished or None
        print(json.dumps(found, indent=1, ensure_ascii=False))
    else:
        verbose = arguments.format == "verbose"
        for finding, outcome in zip(findings, outcomes, strict=True):
            said = plain.words(outcome.words, run.vocabulary)
            formulas = () if finding.steps and not verbose else outcome.formulas
            shown = _shorten(", ".join(map(to_plain, formulas)), verbose)
            where = ", ".join(
                f"{to_plain(condition.expression)} ≠ 0" for condition in outcome.conditions
            )
            said += f", where {where}" if where else ""
            _tell(str(outcome.verdict), f"{said}{':  ' if shown else ''}{shown}")
            for sentence in finding.computed:
                _tell("computed", _shorten(plain.words(sentence, run.vocabulary), verbose))
        checked = plain.many(len(run.certificates), "certificate")
        print(f"{len(outcomes)} found; {checked} checked")
        if not findings and not unfinished:
            print(nothing(arguments.question, **_asked(arguments)))
    if unfinished:
        raise CommandError(unfinished, UNDECIDED)
    return AS_RECORDED if all(outcome.verdict.green for outcome in outcomes) else UNDECIDED


def _tell(how: str, said: str) -> None:
    """A finding: in one line for other programs, in lines as wide as it is on a terminal."""
    lines = plain.wrap(said, f"{how}  ") if sys.stdout.isatty() else (f"{how}  {said}",)
    for line in lines:
        print(line)


def _shorten(shown: str, verbose: bool) -> str:
    """As much as can be read, or all if it is asked for."""
    if verbose or len(shown) <= LONGEST:
        return shown
    return f"{shown[:LONGEST]} … ({len(shown)} letters: -v shows all)"


def _find_and_decide(
    derivation: Derivation, scene: Scene, arguments: argparse.Namespace, pool: Pool
) -> tuple[list[Finding], str, Run]:
    """What is found, why nobody looked further, and what the judge says, which is not checked yet.

    He knows here what the search has eliminated.
    """
    findings, unfinished = _search(derivation, scene, arguments, pool)
    claims = with_findings(derivation, findings)
    deciding = Session(claims, ["flint"], timeout=arguments.timeout)
    return findings, unfinished, received(deciding.run)(())


def _search(
    derivation: Derivation, scene: Scene, arguments: argparse.Namespace, pool: Pool
) -> tuple[list[Finding], str]:
    """What is found, and why nobody looked further, if something is left."""
    on = Elaborations(derivation.texts(derivation.corrected()))
    try:
        search = question(arguments.question).search(on, scene, pool, **_asked(arguments))
        return collect(search, arguments.timeout)
    except (Meaningless, NotationError) as error:
        raise CommandError(f"scene “{scene.name}”: {error}") from None


def _asked(arguments: argparse.Namespace) -> dict[str, Any]:
    """What a question is asked with."""
    keys = (key.lstrip("-") for key in ARGUMENTS[arguments.question])
    return {key: getattr(arguments, key) for key in keys}


def _in_python(findings: Sequence[Finding], run: Run, name: str, scene: Scene) -> str:
    """What is proved of the scene, as a file of the library states it."""
    both = zip(findings, run.outcomes, strict=True)
    green = (finding for finding, outcome in both if outcome.verdict.green)
    kept = {
        line: finding.kind.__name__ for finding in green if (line := finding.python(name, scene))
    }
    kinds = ", ".join(sorted({*kept.values()}))
    lines = [f"from kowalevski_cas.paper.claims import {kinds}"] if kept else []
    return "\n".join(["", *lines, *kept, ""])


def _owner(scene: Scene) -> tuple[Path, str]:
    found = owner(scene)
    if found is None:
        raise CommandError("--write needs a file in which a System with this scene has a name")
    return found


def _scene(derivation: Derivation, name: str | None) -> Scene:
    """The scene with a name; if none is named, the one of which all others are special cases."""
    scenes: dict[str, Scene] = {}
    for scene in derivation.scenes():
        if scene.field:
            scenes.setdefault(scene.name, scene)
    if name is None:
        for scene in scenes.values():
            if all(_specialises(other, scene) for other in scenes.values()):
                if others := [*filter(scene.name.__ne__, scenes)]:
                    said = f"asked of “{scene.name}”; --scene takes: {'; '.join(others)}"
                    print(f"kowalevski-cas find: {said}", file=sys.stderr)
                return scene
    if name in scenes:
        return scenes[name]
    known = get_close_matches(name or "", scenes, 5, 0.4) or [*scenes]
    said = "name a scene" if name is None else f"there is no scene “{name}” with a motion"
    raise CommandError(f"{said}; --scene takes one of: {'; '.join(known)}", NOTHING)


def _specialises(scene: Scene, general: Scene) -> bool:
    """Whether a scene has the motion of another one, and defines or adds constants besides."""
    same = ("variables", "field", "time", "conjugates", "zero")
    return (
        all(getattr(scene, part) == getattr(general, part) for part in same)
        and {*scene.constants, *scene.definitions} >= {*general.constants, *general.definitions}
        and {*scene.definitions} >= {*general.definitions}
    )


def _data(finding: Finding, outcome: Outcome) -> dict[str, object]:
    return {
        "says": outcome.words,
        "computed": finding.computed,
        "formulas": [to_latex(formula) for formula in outcome.formulas],
        "conditions": [to_latex(condition.expression) for condition in outcome.conditions],
        "verdict": str(outcome.verdict),
        "digest": outcome.digest,
    }
