"""The letters that stand for vectors without being bold."""

from __future__ import annotations

import re
from collections.abc import Sequence

from kowalevski_cas.reading.crosses import beside, factors_of_crosses
from kowalevski_cas.source.displays import TypedFormula

_LIST = re.compile(
    r"(?<!\\boldsymbol\s)(?<!\\mathbf\s)(?<!\\bm\s)(?<!\\vec\s)(?<![\w}\\])(?P<name>[A-Za-z]|\\[A-Za-z]+)\s*=\s*\(\s*"
    r"(?P<entries>(?:[A-Za-z]|\\[A-Za-z]+)(?:_\{?\w\}?)?"
    r"(?:\s*,\s*(?:[A-Za-z]|\\[A-Za-z]+)(?:_\{?\w\}?)?)+)\s*\)\s*[.,;]?\s*"
)
r"""A letter that is a list of names, as :math:`x=(x_1,x_2,x_3)`: it is a vector."""
_SLOT = r"(?:[A-Z](?:\^(?:\w|\{[^{}]*\}))?\s*)?(?P<%s>[a-zA-Z]|\\[A-Za-z]+)\s*"
_ANGULAR = re.compile(rf"\\langle\s*{_SLOT % 'first'},\s*{_SLOT % 'second'}\\rangle")
r"""A scalar product of letters, the first or the second perhaps behind a matrix."""
_COMPONENT = r"(\\[A-Za-z]+|[A-Za-z])\s*_\s*\{?\s*[a-z]\s*\}?\s*"
_TURNED = re.compile(
    rf"\\\{{\s*{_COMPONENT},\s*{_COMPONENT}\\\}}\s*=\s*-?\s*\\(?:var)?epsilon(?![A-Za-z])"
)
r"""Components of vectors, as in :math:`\{M_i,\gamma_j\}=\varepsilon_{ijk}\gamma_k`."""
_BOLD = re.compile(r"\\(?:mathbf|boldsymbol|bm|bf|vec)(?![A-Za-z])\s*\{?\s*(\\[A-Za-z]+|[A-Za-z])")
"""A bold letter: then it has the components with this letter."""
_MEMBERS = re.compile(
    r"(?P<names>(?:[A-Za-z]|\\[A-Za-z]+)(?:\s*,\s*(?:[A-Za-z]|\\[A-Za-z]+))*)\s*\\in\s*"
    r"(?:\\(?:mathbb|mathbf|mathrm|bf|Bbb)\b\s*)?\{?\s*(?:\\bf\s+)?R\s*\}?\s*\^\s*\{?\s*(?P<size>[2-9])\s*\}?"
)
r"""Letters that are points of a space of so many dimensions: :math:`x,y\in\mathbb R^3`."""


def letters_of_vectors(formulas: Sequence[TypedFormula]) -> frozenset[str]:
    r"""The letters that are lists of names, and those of which the product with one is printed.

    Those in :math:`\langle A^{-1}x,y\rangle`, points of a space, factors of vector products, and
    what turns in Poisson brackets are vectors as well.
    """
    texts = [formula.tex for formula in formulas]
    members = {name for tex in texts for name in members_of_spaces(tex)}
    angular = {letter for tex in texts for pair in _ANGULAR.findall(tex) for letter in pair}
    found = {match["name"] for tex in texts for match in _LIST.finditer(tex)}
    turned = {letter for tex in texts for pair in _TURNED.findall(tex) for letter in pair}
    found |= turned - {letter for tex in texts for letter in bold_letters(tex)}
    listed = found | beside(found, texts)
    return frozenset(
        name for name in listed if any(re.search(rf"{re.escape(name)}_\{{?\w", t) for t in texts)
    ) | frozenset(angular | members | factors_of_crosses(texts))


def bold_letters(tex: str) -> list[str]:
    """The letters that are bold in a formula."""
    return _BOLD.findall(tex)


def members_of_spaces(tex: str) -> dict[str, int]:
    """The letters that a formula says to be vectors, with the numbers of their components."""
    found = _MEMBERS.fullmatch(tex.strip().rstrip(".,;"))
    names = found["names"].split(",") if found else []
    return {name.strip(): int(found["size"]) for name in names if found}
