"""Draw a motion, and the bifurcation diagrams of the whole top; the reports show them.

A motion is given as for `kowalevski-cas motion`; if none is given, an example is drawn.

  kowalevski-cas pictures
  kowalevski-cas pictures torus traces --a 1 --b 0.4 --m 0.8 --l 0.9 --output portrait
  kowalevski-cas pictures hodographs --a 1.2 --b 0.7 --s 0.4 --tau=-0.5 --output third
  kowalevski-cas pictures --section --point 0.1 0.2 0.3  1 0 0  0 0.4 0.2
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, NOTHING, CommandError
from kowalevski_cas.cli.motion import CONSTANTS, add_motion, motion_of
from kowalevski_cas.files import write
from kowalevski_cas.motion import General, MethodError, Motion, MotionO4
from kowalevski_cas.motion.formulas import source
from kowalevski_cas.motion.general import AnyMotion
from kowalevski_cas.motion.pictures import OF_ANY, OF_FIELDS, ON_N4, PICTURES, load
from kowalevski_cas.motion.section import COORDINATES
from kowalevski_cas.pictures import save, save_drawing, style
from kowalevski_cas.report.figures import LIST
from kowalevski_cas.schema import head

EXAMPLE = ("1.2", "0.7", "-1.2", "0.3")
"""The constants a, b, m, ℓ of the motion that is drawn if none is given."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    words = "; ".join(f"{name}: {words}" for name, words in PICTURES.items())
    parser.add_argument(
        "pictures", nargs="*", metavar="PICTURE", help=f"all of them if none is named; {words}"
    )
    parser.add_argument(
        "--section",
        nargs="?",
        const="omega3",
        choices=COORDINATES,
        metavar="X",
        help="the picture poincare alone, of any motion: the states at which a coordinate is "
        f"largest, one of {', '.join(COORDINATES)}; omega3 if none is named",
    )
    add_motion(parser)
    session.add_output(parser, "where to write", "reports/motion")


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    unknown = [name for name in arguments.pictures if name not in PICTURES]
    if unknown:
        raise CommandError(
            f"there is no picture “{unknown[0]}”; there are {', '.join(PICTURES)}", NOTHING
        )
    motion, names = choose_motion(arguments), arguments.pictures
    coordinate = COORDINATES.index(arguments.section or "omega3")
    if arguments.section:
        if names not in ([], ["poincare"]):
            raise CommandError(f"--section draws poincare alone, not {', '.join(names)}")
        names = ["poincare"]
    names = names or _draw_all(motion)
    if missing := [name for name in names if name not in _draw_all(motion)]:
        if isinstance(motion, General):
            raise CommandError(f"{missing[0]} is drawn for motions in closed form: {motion.why}")
        raise CommandError(f"{missing[0]} is drawn for motions on N⁴ alone; this one is on O⁴")
    write(arguments.output / LIST, _figures(motion))
    with session.progress_bar() as progress:
        for done, name in enumerate(names):
            progress(name, done, len(names))
            _draw(name, motion, arguments.output, *((coordinate,) * (name == "poincare")))
    print(f"{arguments.output}: {', '.join(names)}")
    return AS_RECORDED


def _draw_all(motion: AnyMotion) -> list[str]:
    """The pictures that there are of a motion."""
    if isinstance(motion, General):
        return list(OF_ANY)
    return [name for name in PICTURES if isinstance(motion, Motion) or name not in ON_N4]


def choose_motion(arguments: argparse.Namespace) -> AnyMotion:
    """The motion that the arguments describe, or the example; in a unit of time to draw it in."""
    if not any(getattr(arguments, name) is not None for name in (*CONSTANTS, "point")):
        a, b, m, ell = EXAMPLE
        return Motion.of(a, b, m, ell=ell)
    motion = motion_of(arguments)
    if isinstance(motion, General) or abs(unit := motion.parameters.unit) <= FARTHEST:
        return motion
    motion = motion.in_unit(unit)
    print(
        f"drawn in a unit of time 2^{-unit} times as long, in which a = "
        f"{motion.constants_in_unit['a']:.6g}",
        file=sys.stderr,
    )
    return motion


FARTHEST = 3
"""The exponent of the farthest unit of time in which pictures are drawn, one in which a is 1."""

LETTERS = {"l": r"\ell", "tau": r"\tau_3"}
"""Constants whose letter is not their name."""


def _constants(motion: AnyMotion, name: str) -> str:
    """The sentence that tells the constants of what a picture shows, and their units."""
    of_motion = {Motion: ("m", "l"), MotionO4: ("s", "tau"), General: ("h", "k", "g")}[type(motion)]
    names = ("a", "b", "c", *(() if name in OF_FIELDS else of_motion))
    values = ", ".join(
        f"${LETTERS.get(name, name)}={float(value):.6g}$"
        for name, value in motion.constants.items()
        if name in names and (name != "c" or value)
    )
    return f" Here {values}; fields are measured in squares of the unit of frequencies."


def _figures(motion: AnyMotion) -> str:
    """The list of pictures for the reports of the derivations that they are about."""
    listed: dict[str, list[dict[str, str]]] = {}
    for name in OF_ANY if isinstance(motion, General) else PICTURES:
        picture = load(name)
        entry = {"name": name, "caption": picture.caption + _constants(motion, name)}
        listed.setdefault(source(picture.about).name, []).append(entry)
    value = {**head("figures"), "derivations": listed}
    return json.dumps(value, indent=1, ensure_ascii=False) + "\n"


def _draw(name: str, motion: AnyMotion, folder: Path, *how: int) -> None:
    """Draw a picture and write it."""
    try:
        with style():
            figure = load(name).draw(motion, *how)
            save(figure, folder, name)
            save_drawing(figure, folder, name)
    except (ValueError, MethodError) as error:
        raise CommandError(f"{name} cannot be drawn: {error}") from None
