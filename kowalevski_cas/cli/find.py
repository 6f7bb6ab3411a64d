"""Find the polynomial first integrals of a scene of a derivation, up to a degree.

What is found is claimed and decided like any other claim. What is a polynomial in what was found
before is left out.
"""

from __future__ import annotations

import argparse
import json
from difflib import get_close_matches

from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, NOTHING, UNDECIDED, CommandError
from kowalevski_cas.notation import NotationError, to_latex, to_plain
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.processes import each, time_limit
from kowalevski_cas.verify.found import with_integrals
from kowalevski_cas.verify.outcome import Outcome
from kowalevski_cas.verify.run import verify


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument("derivation", metavar="DERIVATION", help="name in the library, or folder")
    parser.add_argument("--scene", metavar="NAME", help="the scene, by its name")
    parser.add_argument(
        "--degree", type=_natural, default=2, metavar="N", help="the highest degree (2)"
    )
    parser.add_argument(
        "--constants",
        type=_natural,
        default=0,
        metavar="N",
        help="the highest degree of coefficients in the constants of the scene (0)",
    )
    parser.add_argument("--format", choices=("pretty", "json"), default="pretty")
    parser.add_argument(
        "--timeout", type=float, default=60.0, metavar="SECONDS", help="for the search (60)"
    )


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    ((_, derivation),) = session.derivations([arguments.derivation])
    scene = _scene(derivation, arguments.scene)
    (found,) = each(lambda _: _found(derivation, scene, arguments), [None])
    if found is None:
        late = f"not found within {arguments.timeout:g} s; a lower --degree takes less"
        raise CommandError(late, UNDECIDED)
    if arguments.format == "json":
        print(json.dumps([_data(outcome) for outcome in found], indent=1))
    else:
        for outcome in found:
            print(f"{outcome.verdict}  {', '.join(map(to_plain, outcome.formulas))}")
        constants = f", {arguments.constants} in the constants" if arguments.constants else ""
        print(f"{len(found)} first integrals up to degree {arguments.degree}{constants}")
    return AS_RECORDED if all(outcome.verdict.green for outcome in found) else UNDECIDED


def _found(
    derivation: Derivation, scene: Scene, arguments: argparse.Namespace
) -> list[Outcome] | None:
    """The outcomes for what is found; ``None`` if there was not time enough."""
    from kowalevski_cas.search.integrals import first_integrals

    try:
        with time_limit(arguments.timeout):
            texts = derivation.texts(derivation.corrected())
            at = Elaborations(texts)(scene).finder
            elements = [*first_integrals(at, arguments.degree, constants=arguments.constants)]
            claims = with_integrals(derivation, scene, elements)
            return list(verify(claims, ["flint"]).outcomes)
    except TimeoutError:
        return None
    except (Meaningless, NotationError) as error:
        raise CommandError(f"scene “{scene.name}”: {error}") from None


def _scene(derivation: Derivation, name: str | None) -> Scene:
    """The scene with a name; the only one, if none is named."""
    scenes: dict[str, Scene] = {}
    for scene in derivation.scenes():
        if scene.field:
            scenes.setdefault(scene.name, scene)
    if name is None and len(scenes) == 1:
        return next(iter(scenes.values()))
    if name in scenes:
        return scenes[name]
    known = get_close_matches(name or "", scenes, 5, 0.4) or [*scenes]
    said = "name a scene" if name is None else f"there is no scene “{name}” with a motion"
    raise CommandError(f"{said}: --scene with one of {'; '.join(known)}", NOTHING)


def _natural(text: str) -> int:
    if not text.isdecimal():
        raise argparse.ArgumentTypeError(f"a whole number is expected, not “{text}”")
    return int(text)


def _data(outcome: Outcome) -> dict[str, object]:
    return {
        "integral": [to_latex(formula) for formula in outcome.formulas],
        "verdict": str(outcome.verdict),
        "digest": outcome.digest,
    }
