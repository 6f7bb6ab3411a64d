"""Find what nobody has printed: open questions about the scene of a derivation.

What is found is claimed, decided and certified like any other claim.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from difflib import get_close_matches
from importlib import import_module
from pathlib import Path
from time import monotonic

from kowalevski_cas.cli import plain, session
from kowalevski_cas.cli.exits import AS_RECORDED, NOTHING, UNDECIDED, CommandError
from kowalevski_cas.files import write
from kowalevski_cas.library import owner
from kowalevski_cas.limits import tell, time_limit
from kowalevski_cas.notation import NotationError, to_latex, to_plain
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.pool import Pool
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.verify.found import Finding, with_findings
from kowalevski_cas.verify.outcome import Outcome, Run
from kowalevski_cas.verify.run import verify

QUESTIONS = {
    "integrals": "polynomial first integrals, up to a degree",
    "darboux": "polynomials F with F' = KF, up to a degree, and their K",
    "closure": "an invariant set, from a function and its derivatives",
    "parameters": "values of constants for which a polynomial divides its derivative",
    "exponents": "weights, balances, their Kowalevski exponents, and the Painlevé test",
}

MANY = 2000
"""How many monomials make a search long."""

LONGEST = 400
"""How many letters of formulas are printed on a line, if not all are asked for."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command, and those of each question."""
    questions = parser.add_subparsers(title="questions", metavar="QUESTION", required=True)
    for name, summary in QUESTIONS.items():
        module = import_module(f"kowalevski_cas.cli.questions.{name}")
        one = questions.add_parser(name, help=summary, description=module.__doc__)
        one.set_defaults(search=module.search, question=name)
        one.add_argument("derivation", metavar="DERIVATION", help="name in the library, or folder")
        one.add_argument("--scene", metavar="NAME", help="the scene, by its name")
        module.add_arguments(one)
        session.add_format(one, ("pretty", "verbose", "json"), "formula")
        one.add_argument(
            "--write", action="store_true", help="append what is proved of the motion to the file"
        )
        session.add_timeout(one, 60.0, "for the search, and for each claim")
        session.add_pool(one)


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    ((_, derivation),) = session.derivations([arguments.derivation])
    scene = _scene(derivation, arguments.scene)
    forecast(scene, arguments.question, getattr(arguments, "degree", 0) or 0)
    file, name = _owner(scene) if arguments.write else (None, "")
    pool = session.pool(arguments)
    (answer,) = session.watched(lambda _: _answer(derivation, scene, arguments, name, pool), [None])
    if file is not None:
        write(file, file.read_text(encoding="utf-8") + answer.claims)
    outcomes = answer.run.outcomes
    if arguments.format == "json":
        print(json.dumps([*map(_data, answer.findings, outcomes)], indent=1))
    else:
        verbose = arguments.format == "verbose"
        for finding, outcome in zip(answer.findings, outcomes, strict=True):
            said = plain.words(outcome.words, answer.run.vocabulary)
            formulas = () if finding.steps and not verbose else outcome.formulas
            shown = _cut(", ".join(map(to_plain, formulas)), verbose)
            print(f"{outcome.verdict}  {said}{':  ' if shown else ''}{shown}")
            for one in finding.computed:
                print(f"computed  {_cut(plain.words(one, answer.run.vocabulary), verbose)}")
        print(f"{len(outcomes)} found")
    if answer.unfinished:
        raise CommandError(answer.unfinished, UNDECIDED)
    return AS_RECORDED if all(one.verdict.green for one in outcomes) else UNDECIDED


def _cut(shown: str, verbose: bool) -> str:
    """As much as can be read, or all if it is asked for."""
    if verbose or len(shown) <= LONGEST:
        return shown
    return f"{shown[:LONGEST]} … ({len(shown)} letters: -v shows all)"


@dataclass(frozen=True)
class _Answer:
    """What was found, and why nobody looked further, if something is left."""

    findings: list[Finding]
    run: Run
    unfinished: str
    claims: str
    """What is proved of the scene, in Python."""


def _answer(
    derivation: Derivation, scene: Scene, arguments: argparse.Namespace, name: str, pool: Pool
) -> _Answer:
    """The answer to a question; what was found before it had to stop is kept."""
    on = Elaborations(derivation.texts(derivation.corrected()))
    try:
        search = arguments.search(on, scene, arguments, pool)
        findings, unfinished = found(search, arguments.timeout)
    except (Meaningless, NotationError) as error:
        raise CommandError(f"scene “{scene.name}”: {error}") from None
    if not unfinished:
        pool.forget()
    claims = with_findings(derivation, findings)
    run = verify(claims, ["flint"], timeout=arguments.timeout)
    both = zip(findings, run.outcomes, strict=True)
    green = (one for one, outcome in both if outcome.verdict.green)
    kept = {line: one.kind.__name__ for one in green if (line := one.python(name, scene))}
    kinds = ", ".join(sorted({*kept.values()}))
    lines = [f"from kowalevski_cas.paper.claims import {kinds}"] if kept else []
    lines += kept
    return _Answer(findings, run, unfinished, "\n".join(["", *lines, ""]))


def found(search: Iterator[Finding], seconds: float) -> tuple[list[Finding], str]:
    """What is found in so many seconds, and why nobody looked further, if something is left."""
    from kowalevski_cas.algebra.kernels import TooLarge

    findings: list[Finding] = []
    end = monotonic() + seconds
    try:
        while True:
            with time_limit(end - monotonic()):
                findings.append(next(search))
            tell(f"{len(findings)} found", 0, 1)
    except StopIteration:
        return findings, ""
    except TimeoutError:
        return findings, f"it took more than {seconds:g} s: give it more time"
    except TooLarge as error:
        return findings, f"it would be too large: {error}"


def _owner(scene: Scene) -> tuple[Path, str]:
    found = owner(scene)
    if found is None:
        raise CommandError("--write needs a file in which a System with this scene has a name")
    return found


def forecast(scene: Scene, question: str, degree: int) -> None:
    """Say beforehand how large a question about polynomials is, if it is, and whether too large."""
    from kowalevski_cas.problem.polynomial_fields import number_of_monomials

    if not degree:
        return
    largest = import_module(f"kowalevski_cas.search.{question}").LARGEST
    width = len(scene.variables)
    if (size := number_of_monomials((1,) * width, degree)) > min(MANY, largest):
        large = f"{width} variables have {size} monomials up to degree {degree}"
        ends = "the search ends before, with what it has found"
        print(f"{large}: {ends if size > largest else 'it may take long'}", file=sys.stderr)


def _scene(derivation: Derivation, name: str | None) -> Scene:
    """The scene with a name; the only one but for more constants, if none is named."""
    scenes: dict[str, Scene] = {}
    for scene in derivation.scenes():
        if scene.field:
            scenes.setdefault(scene.name, scene)
    everyone = scenes.values()
    least = [one for one in everyone if not any(_has_more_constants(one, t) for t in everyone)]
    if name is None and len(least) == 1:
        return least[0]
    if name in scenes:
        return scenes[name]
    known = get_close_matches(name or "", scenes, 5, 0.4) or [*scenes]
    said = "name a scene" if name is None else f"there is no scene “{name}” with a motion"
    raise CommandError(f"{said}: --scene with one of {'; '.join(known)}", NOTHING)


def _has_more_constants(scene: Scene, than: Scene) -> bool:
    """Whether a scene is another one with more constants, of which its motion does not depend."""
    differing = {name for name, value in vars(scene).items() if value != vars(than)[name]}
    same = differing <= {"name", "constants"}
    return same and {*scene.constants} > {*than.constants}


def _data(finding: Finding, outcome: Outcome) -> dict[str, object]:
    return {
        "says": outcome.words,
        "computed": finding.computed,
        "formulas": [to_latex(formula) for formula in outcome.formulas],
        "verdict": str(outcome.verdict),
        "digest": outcome.digest,
    }
