"""The charts that a report shows, with what it says about them."""

from __future__ import annotations

import json
from pathlib import Path

from kowalevski_cas.files import write
from kowalevski_cas.report.plates import LIST

DERIVATION = "kharlamov2002"

PLATES = {
    "speed-accuracy": (
        "How long a method takes for a statement, and how wrong it can be. Each was put to "
        "identities of the derivations, and to misprints, mutants and near misses of them; three "
        "exact arithmetics, which agree, say which are true. A bar spans eight of ten times. "
        "Slow methods were put to fewer statements. "
        "Methods whose answers are proofs, and of which none was seen to be wrong, stand on the "
        "rail below. A full square is a measured share of errors, a triangle a guaranteed bound. "
        "An open square means that no error was seen and none is excluded; a larger share would "
        "have been seen with a chance of 95 %. Points of equal height are drawn a little apart."
    ),
    "growth": (
        "How cost grows: the $k$-th derivatives of the relations (15) and (16) are compared with "
        "those that the matrix of $F'=MF$ implies, $M_{k+1}=M_k'+M_kM$. The line of python-flint "
        "alone is the same operations on polynomials without this program around them; Singular "
        "and PARI/GP do the same operations as well."
    ),
}


def write_plates(folder: Path) -> None:
    """List the charts that are in a folder, for the report of the derivation."""
    plates = [
        {"name": name, "caption": caption}
        for name, caption in PLATES.items()
        if (folder / f"{name}.png").is_file()
    ]
    if plates:
        listed = {"derivation": DERIVATION, "plates": plates}
        text = json.dumps(listed, indent=1, ensure_ascii=False) + "\n"
        write(folder / LIST, text)
