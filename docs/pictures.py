"""Make the pictures that the README shows: the erratum to (14), and those of the example motion.

``python docs/pictures.py [DIR]`` writes them into a folder, by default this one.
"""

import sys
import tempfile
from pathlib import Path

import typst
from scipy.optimize import brentq

from kowalevski_cas.cli import main
from kowalevski_cas.library import load
from kowalevski_cas.motion import Motion, frequencies
from kowalevski_cas.motion.pictures import animation
from kowalevski_cas.report.contents import Contents
from kowalevski_cas.report.document import Document, Link
from kowalevski_cas.report.places import sections
from kowalevski_cas.report.typst import render_typst
from kowalevski_cas.verify.run import Session

MOTION = {"traces": "motion.png", "sections": "diagram.png"}
FRAMES, DOTS = 120, 70
PAGE = "#set page(width: 150mm, height: auto, margin: (x: 4mm, y: 3mm), header: none)\n"


def erratum(folder: Path) -> bytes:
    """Equation (14) as printed and as it was meant, as the report has it."""
    derivation = load("kharlamov2002")
    run = Session(derivation, ("flint",)).run(["eq14"])
    paper = sections(run, derivation, derivation.texts())
    _, slip, *_ = Contents(run, paper).findings.blocks()
    flat = [part.text if isinstance(part, Link) else (part,) for part in slip.head]
    alone = slip._replace(head=tuple(part for text in flat for part in text))
    source = render_typst(Document("", "", (), (alone,)))
    title = source.index("#block(below: 1.2em, text(1.6em")
    file = folder / "erratum.typ"
    file.write_text(source[:title] + PAGE + source[source.index("\n", title) :], encoding="utf-8")
    return typst.compile(file, format="png", ppi=160, ignore_system_fonts=True)


def body(target: Path) -> None:
    """The body as it moves, for ever: a motion whose frequencies are as three to two."""

    def motion(ell: float) -> Motion:
        return Motion.of("1.2", "0.7", "0.5", ell=ell)

    def beside(ell: float) -> float:
        return frequencies(motion(ell)).rotation_number - 1.5

    animation.write(motion(brentq(beside, 1.38, 1.44)), target / "body.gif", FRAMES, DOTS)


def pictures(target: Path) -> None:
    """Write all of them."""
    with tempfile.TemporaryDirectory() as folder:
        main(["pictures", *MOTION, "--output", folder])
        for picture, name in MOTION.items():
            Path(folder, f"{picture}.png").replace(target / name)
        (target / "erratum.png").write_bytes(erratum(Path(folder)))
    body(target)


if __name__ == "__main__":
    pictures(Path(*sys.argv[1:]) if sys.argv[1:] else Path(__file__).parent)
