"""Follow a motion: the states at equal steps of time, the invariants, M⁴, N⁴, O⁴, the regime.

A motion is given by a state, any one; or by the two fields with m and the energy or ℓ as one on N⁴,
with s and τ₃ as one on O⁴. Then it is at the first roots of the arcs at the times --origins, or
by the angles --angles away from them.

  kowalevski-cas motion --a 1 --b 0.4 --m 0.8 --l 0.9 --until 1e6
  kowalevski-cas motion --a 1 --b 0.4 --m -0.3 --h 1.2 --method ball --format csv --output orbit
  kowalevski-cas motion --a 1 --b 1 --c 0.4 --m -0.5 --l 0.1 --torus 2 --origins 0 1/3
  kowalevski-cas motion --a 1.2 --b 0.7 --s 0.4 --tau -0.5 --torus 2
  kowalevski-cas motion --point 0.1 0.2 0.3  1 0 0  0 0.4 0.2
"""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Collection
from typing import Any

import numpy as np

from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, UNDECIDED, CommandError
from kowalevski_cas.cli.motion_formats import FORMATS
from kowalevski_cas.files import write
from kowalevski_cas.limits import time_limit
from kowalevski_cas.motion import General, Motion, MotionO4, through
from kowalevski_cas.motion.arrays import Array
from kowalevski_cas.motion.formulas import source
from kowalevski_cas.motion.general import AnyMotion, with_constants_of_O4
from kowalevski_cas.motion.methods import METHODS, load
from kowalevski_cas.motion.methods.ball import enclose
from kowalevski_cas.motion.parameters import Inadmissible, MethodError, exact
from kowalevski_cas.motion.point import KNOWN
from kowalevski_cas.motion.result import Trajectory
from kowalevski_cas.processes import each

LARGEST_COUNT = 10_000_000

ON_N4, ON_O4 = ("m", "l", "h", "origins"), ("s", "tau", "angles")
CONSTANTS = ("a", "b", "c", *ON_N4, *ON_O4, "torus")
"""The options that describe a motion by its constants and phases."""

MOST_BALLS = 2000
"""How many states are enclosed one by one where the closed form loses digits."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    add_motion(parser)
    parser.add_argument("--until", default="10", metavar="T", help="the last time, default 10")
    parser.add_argument(
        "--samples", type=int, default=101, metavar="N", help="how many states, default 101"
    )
    words = "; ".join(f"{name}: {words}" for name, words in METHODS.items())
    parser.add_argument(
        "--method",
        choices=METHODS,
        help=f"{words}. If none is named: closed where there is a closed form, else dop853",
    )
    parser.add_argument(
        "--frequencies",
        action="store_true",
        help="the frequencies, rotation number and actions of the torus as well, on N⁴ or O⁴",
    )
    parser.add_argument(
        "--attitude",
        action="store_true",
        help="at each state a unit quaternion as well, that turns the body's axes into those of "
        "space: the first along α, the third along α × β",
    )
    session.add_timeout(parser, 60, "for the method")
    parser.add_argument(
        "--format", choices=FORMATS, help="if none is named: table on a terminal, else json"
    )
    session.add_output(parser, "write DIR/motion.FORMAT instead of printing")


def add_motion(parser: argparse.ArgumentParser) -> None:
    """The arguments that describe a motion, for every command about one."""
    # Numbers are decimals, -1e-3, or quotients, -1/3; argparse knows the plain ones only.
    parser._negative_number_matcher = re.compile(r"^-([.\d]|inf|nan)")
    parser.add_argument("--a", metavar="A", help="the length of the field α")
    parser.add_argument("--b", metavar="B", help="the length of the field β")
    parser.add_argument("--c", metavar="C", help="their scalar product, 0 if not given")
    parser.add_argument("--m", metavar="M", help="the constant m, not zero")
    parser.add_argument("--l", metavar="L", help="the constant ℓ")
    parser.add_argument("--h", metavar="H", help="the energy, instead of ℓ")
    parser.add_argument(
        "--origins",
        nargs=2,
        metavar="T",
        help="when s1, s2 are at the first root, 0 0 if not given",
    )
    parser.add_argument("--s", metavar="S", help="the constant s of a motion on O⁴, with τ₃")
    parser.add_argument("--tau", metavar="T", help="the constant τ₃ of a motion on O⁴")
    parser.add_argument(
        "--angles", nargs=2, metavar="PHI", help="where u1, u2 are at t = 0, 0 0 if not given"
    )
    parser.add_argument("--torus", type=int, metavar="N", help="which of the tori, 1 if not given")
    parser.add_argument(
        "--point",
        nargs="+",
        metavar="X",
        help="the state at t = 0 instead: ω, α, β, nine numbers, whatever they are",
    )


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    if arguments.format is None:
        reads = arguments.output is None and sys.stdout.isatty()
        arguments.format = "table" if reads else "json"
    binary = arguments.format == "npz" and arguments.output is None
    if binary and sys.stdout.isatty():
        raise CommandError("npz is not for a terminal; give --output DIR, or send it to a file")
    trajectory = _follow(arguments)
    try:
        contents = FORMATS[arguments.format](trajectory)
    except Inadmissible as error:
        raise CommandError(str(error)) from None
    if arguments.output is not None:
        path = arguments.output / f"motion.{arguments.format}"
        write(path, contents)
        print(path)
    elif binary:
        sys.stdout.buffer.write(contents)
    else:
        sys.stdout.write(contents.decode())
    return AS_RECORDED


def _follow(arguments: argparse.Namespace) -> Trajectory:
    if not 1 <= arguments.samples <= LARGEST_COUNT:
        raise CommandError(f"--samples has to be from 1 to {LARGEST_COUNT}")
    try:
        until = float(exact(arguments.until))
    except (ValueError, OverflowError):
        raise CommandError(f"--until {arguments.until} is not a finite number") from None
    motion = motion_of(arguments)
    beside = motion.off > KNOWN  # whoever has a closed form begins elsewhere
    method = arguments.method or ("dop853" if isinstance(motion, General) or beside else "closed")
    if beside and arguments.method in (None, "closed", "ball"):
        name = "O⁴" if isinstance(motion, MotionO4) else "N⁴"
        begins = "begins" if method in ("closed", "ball") else "follows it; --method closed begins"
        print(
            f"the state is not quite on {name}: {method} {begins} {motion.off:.3g} of its "
            f"size away from it, on {name}",
            file=sys.stderr,
        )
    times = np.linspace(0.0, until, arguments.samples)
    source()  # loaded here, the process that follows the motion has it as well
    limit = f"t = {until:g} within {arguments.timeout:g} s"
    if sys.stderr.isatty():
        print(f"following the motion by {method}, to {limit} ...", file=sys.stderr)

    def states(motion: AnyMotion) -> tuple[Array, ...]:
        with time_limit(arguments.timeout):
            return _states(motion, times, method, arguments.method is None)

    try:
        (found,) = each(states, [motion])
    except TimeoutError:
        raise CommandError(
            f"{method} has not come to {limit}; --timeout allows it more"
            + (not isinstance(motion, General)) * ", and the closed form takes no longer there",
            UNDECIDED,
        ) from None
    except MethodError as error:
        raise CommandError(str(error), UNDECIDED) from None
    except ValueError as error:
        raise CommandError(str(error)) from None
    also = tuple(name for name in ("frequencies", "attitude") if getattr(arguments, name))
    rows, *radii = found
    if motion.point is not None and method == "closed" and not beside:
        rows[times == 0] = motion.point  # to its last digit, however small ω is beside the fields
    return Trajectory(motion, times, rows, radii[0] if radii else None, also)


def _states(motion: AnyMotion, times: Array, method: str, free: bool) -> tuple[Array, ...]:
    """The states by a method, or, if nobody named it, as accurate as is promised; with radii."""
    if method == "ball" and not isinstance(motion, General):
        return enclose(motion, times)
    if free and method == "closed" and isinstance(motion, MotionO4):
        return _as_promised(motion, times)
    return (load(method)(motion, times),)


def _as_promised(motion: MotionO4, times: Array) -> tuple[Array, ...]:
    """States on O⁴ as accurate as is promised: in closed form, or else otherwise, and said so."""
    try:
        return (load("closed")(motion, times),)
    except (MethodError, Inadmissible) as error:
        many = len(times) > MOST_BALLS or isinstance(error, Inadmissible)
        name = "dop853" if many else "ball"
        print(f"{error}: {name} follows the motion", file=sys.stderr)
    return (load("dop853")(motion, times),) if many else enclose(motion, times)


def motion_of(arguments: argparse.Namespace) -> AnyMotion:
    """The motion that the arguments describe; a message for every way in which they do not."""
    given = {name: value for name in CONSTANTS if (value := getattr(arguments, name)) is not None}
    try:
        if arguments.point is None:
            return _by_constants(given)
        _refuse(given, "--point says it all")
        return through([x for word in arguments.point for x in word.split(",") if x])
    except ValueError as error:
        raise CommandError(str(error)) from None


def _by_constants(given: dict[str, Any]) -> AnyMotion:
    """The motion on O⁴ or on N⁴ with these constants."""
    third = any(name in given for name in ON_O4)
    needed = ("a", "b", *(("s", "tau") if third else ("m",)))
    missing = [f"--{name}" for name in needed if name not in given]
    if missing:
        raise CommandError(f"{', '.join(missing)} missing; or give a state by --point")
    if third:
        _refuse([name for name in ON_N4 if name in given], "--s and --tau are those of O⁴")
        return with_constants_of_O4(**given)
    if ("l" in given) == ("h" in given):
        raise CommandError("one of --l and --h is needed" + ", not both" * ("l" in given))
    return Motion.of(**{"ell" if name == "l" else name: value for name, value in given.items()})


def _refuse(given: Collection[str], why: str) -> None:
    """Refuse options beside others."""
    if given:
        names = ", ".join(f"--{name}" for name in given)
        raise CommandError(f"{why}; {names} cannot stand beside it")
