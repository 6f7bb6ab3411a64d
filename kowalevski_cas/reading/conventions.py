"""What papers use and do not print: a letter in bold and its length, the imaginary unit."""

from __future__ import annotations

import re
from collections.abc import Iterator

from kowalevski_cas.notation import read
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.paper.texts import Display
from kowalevski_cas.reading.known import CONVENTION, Known, StatementRole
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.source.displays import TypedFormula

SOURCE = "the usual convention"


def conventions(known: Known) -> Iterator[tuple[SourceStatement, StatementRole]]:
    r"""What names without a definition stand for, as :math:`L=|\mathbf L|`, :math:`i^2=-1`."""
    paper = known.paper
    scalars = sorted(paper.words.scalars - paper.times)
    for vector in sorted(known.names.vectors):
        letter = vector[vector.index("{") + 1 :].replace("}", "", 1)
        if letter in scalars and not known.is_defined(letter) and not known.moves(letter):
            if known.is_defined(vector) or known.moves(vector):
                role = StatementRole(
                    CONVENTION, "the length of the vector with this letter", "", (letter,)
                )
                name = re.sub(r"\W+", "-", letter).strip("-")
                yield _item(known, f"length-of-{name}", f"{letter}=|{vector}|"), role
    if "i" in scalars and not known.units and not known.moves("i"):
        yield (
            _item(known, "unit", "i^2=-1"),
            StatementRole(CONVENTION, "the imaginary unit", "unit", ("i",)),
        )


def _item(known: Known, id: str, tex: str) -> SourceStatement:
    """A statement that the paper does not print."""
    display = Display(id, tex, known.paper.displays[0][0].section, source=SOURCE)
    formula = read(tex, known.paper.words, OpenParser)
    start = known.paper.prose.start
    return SourceStatement(
        display[1], TypedFormula(tex, start, start, ""), formula, "", -1, (start, start),
        "", "", "", "", 0, known.paper.prose.path(start), None,
    )  # fmt: skip
