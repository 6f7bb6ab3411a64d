"""Write the animation of a motion on N⁴ or O⁴: the body as it moves between the two fields.

A motion is given as for `kowalevski-cas motion`; if none is given, an example is shown.

  kowalevski-cas animation --a 1 --b 0.4 --m 0.8 --l 0.9 --output body.gif
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
from kowalevski_cas.motion.pictures import animation


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    add_motion(parser)
    session.add_output(parser, "where to write", "reports/motion/body.gif", "FILE")


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    path, motion = arguments.output, choose_motion(arguments)
    if path.is_dir() or path.suffix.lower() != ".gif":
        raise CommandError(f"--output {path} is no file that ends with .gif")
    with TemporaryDirectory() as folder:
        drawn = Path(folder) / "body.gif"
        animation.write(motion, drawn)
        write(path, drawn.read_bytes())
    print(path)
    return AS_RECORDED
