"""Write the animation of a motion: the body as it moves between the two fields.

A motion is given as for `kowalevski-cas motion`; if none is given, an example is shown. As HTML it
is a page to touch, whole in one file: the time is dragged, and other motions on N⁴ in the same
fields are chosen on their diagram.

  kowalevski-cas animation --a 1 --b 0.4 --m 0.8 --l 0.9 --output body.gif
  kowalevski-cas animation --output body.html
"""

from __future__ import annotations

import argparse
from pathlib import Path
from tempfile import TemporaryDirectory

from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, CommandError
from kowalevski_cas.cli.motion import add_motion
from kowalevski_cas.cli.pictures import choose_motion
from kowalevski_cas.files import write
from kowalevski_cas.motion import Inadmissible, MethodError, Motion
from kowalevski_cas.motion.general import AnyMotion
from kowalevski_cas.motion.pictures import animation
from kowalevski_cas.motion.pictures.page import page


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    add_motion(parser)
    session.add_output(parser, "where to write", "reports/motion/body.gif", "FILE")


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    path, motion = arguments.output, choose_motion(arguments)
    suffix = path.suffix.lower()
    if path.is_dir() or suffix not in (".gif", ".html"):
        raise CommandError(f"--output {path} does not end with .gif or .html")
    contents = _page if suffix == ".html" else _gif
    try:
        write(path, contents(motion))
    except (Inadmissible, MethodError) as error:
        raise CommandError(str(error)) from None
    print(path)
    return AS_RECORDED


def _page(motion: AnyMotion) -> str:
    """The page of a motion on N⁴."""
    if not isinstance(motion, Motion):
        raise CommandError(
            "the page is one of motions on N⁴, and this one is not; "
            "--output FILE.gif shows any motion"
        )
    return page(motion)


def _gif(motion: AnyMotion) -> bytes:
    """The frames of an animation."""
    with TemporaryDirectory() as folder:
        drawn = Path(folder) / "body.gif"
        animation.write(motion, drawn)
        return drawn.read_bytes()
