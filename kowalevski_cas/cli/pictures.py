"""Draw a motion, and the bifurcation diagrams of the whole top; the reports show them.

A motion is given as for `kowalevski-cas motion`; if none is given, an example is drawn.

  kowalevski-cas pictures
  kowalevski-cas pictures torus traces --a 1 --b 0.4 --m 0.8 --l 0.9 --output portrait
  kowalevski-cas pictures hodographs --a 1.2 --b 0.7 --s 0.4 --tau=-0.5 --output third
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, NOTHING, CommandError
from kowalevski_cas.cli.motion import CONSTANTS, add_motion, motion_of
from kowalevski_cas.files import write
from kowalevski_cas.motion import General, Motion, MotionO4
from kowalevski_cas.motion.formulas import source
from kowalevski_cas.motion.general import AnyMotion
from kowalevski_cas.motion.pictures import OF_FIELDS, ON_N4, PICTURES, load
from kowalevski_cas.pictures import save, style
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
    add_motion(parser)
    session.add_output(parser, "where to write", "reports/motion")


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    unknown = [name for name in arguments.pictures if name not in PICTURES]
    if unknown:
        raise CommandError(
            f"there is no picture “{unknown[0]}”; there are {', '.join(PICTURES)}", NOTHING
        )
    motion = choose_motion(arguments)
    if isinstance(motion, General):
        raise CommandError(f"only motions in closed form are drawn: {motion.why}")
    names = arguments.pictures or _draw_all(motion)
    if missing := [name for name in names if name not in _draw_all(motion)]:
        raise CommandError(f"{missing[0]} is drawn for motions on N⁴ alone; this one is on O⁴")
    write(arguments.output / LIST, _figures(motion))
    with session.progress_bar() as progress:
        for done, name in enumerate(names):
            progress(name, done, len(names))
            _draw(name, motion, arguments.output)
    print(f"{arguments.output}: {', '.join(names)}")
    return AS_RECORDED


def _draw_all(motion: Motion | MotionO4) -> list[str]:
    """The pictures that there are of a motion."""
    return [name for name in PICTURES if isinstance(motion, Motion) or name not in ON_N4]


def choose_motion(arguments: argparse.Namespace) -> AnyMotion:
    """The motion that the arguments describe, or the example."""
    if any(getattr(arguments, name) is not None for name in (*CONSTANTS, "point")):
        return motion_of(arguments)
    a, b, m, ell = EXAMPLE
    return Motion.of(a, b, m, ell=ell)


LETTERS = {"l": r"\ell", "tau": r"\tau_3"}
"""Constants whose letter is not their name."""


def _constants(motion: Motion | MotionO4, name: str) -> str:
    """The sentence that tells the constants of what a picture shows, and their units."""
    of_motion = ("m", "l") if isinstance(motion, Motion) else ("s", "tau")
    names = ("a", "b", "c", *(() if name in OF_FIELDS else of_motion))
    values = ", ".join(
        f"${LETTERS.get(name, name)}={value:.6g}$"
        for name, value in motion.constants.items()
        if name in names and (name != "c" or value)
    )
    return f" Here {values}; fields are measured in squares of the unit of frequencies."


def _figures(motion: Motion | MotionO4) -> str:
    """The list of pictures for the reports of the derivations that they are about."""
    listed: dict[str, list[dict[str, str]]] = {}
    for name in PICTURES:
        picture = load(name)
        entry = {"name": name, "caption": picture.caption + _constants(motion, name)}
        listed.setdefault(source(picture.about).name, []).append(entry)
    value = {**head("figures"), "derivations": listed}
    return json.dumps(value, indent=1, ensure_ascii=False) + "\n"


def _draw(name: str, motion: Motion | MotionO4, folder: Path) -> None:
    """Draw a picture and write it."""
    try:
        with style():
            save(load(name).draw(motion), folder, name)
    except ValueError as error:
        raise CommandError(f"{name} cannot be drawn: {error}") from None
