"""What products of letters tell of them: which are vectors, and which matrices act on vectors."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence

from kowalevski_cas.notation.macros import GREEK, TYPED

_PRODUCT = re.compile(r"\(\s*([A-Za-z]|\\[A-Za-z]+)\s*,\s*([A-Za-z]|\\[A-Za-z]+)\s*\)")
_BOLD = re.compile(r"\\(?:mathbf|boldsymbol|bm|bf|vec)\b(?!\s*\{?\s*R\b)")
_RATE = re.compile(r"\\d?dot\b|\\frac\s*\{?\s*d\b")
_DERIVED = re.compile(
    r"\\d{1,3}ot(?![A-Za-z])\s*(?:\{(?:[^{}]|\{[^{}]*\})*\}|\\?[A-Za-z]+)"
    r"|(?:\\(?:mathbf|boldsymbol|bm|vec)\s*(?:\{[^{}]*\}|\\?[A-Za-z]+)|\\?[A-Za-z])\s*(?:'|\^\s*\\prime)+"
)
"""A letter with dots, or with primes."""
_SIGNS = GREEK | {r"\times": "×", r"\cdot": "·", r"\langle": "(", r"\rangle": ")"}
_NOTHING = r"\dot \ddot \mathbf \boldsymbol \bm \bf \vec \left \right \bigl \bigr \big".split()
_LETTER = r"[^\W\d_]"
_CROSS = re.compile(
    rf"(?:(?P<before>[A-Z])?(?P<left>{_LETTER})|\))×"
    rf"(?:\(|(?P<behind>[A-Z](?={_LETTER}))?(?P<right>{_LETTER})(?![_^]))"
)
r"""A cross between letters, perhaps with a matrix before one of them, or brackets."""
_IMAGE = re.compile(rf"(?<!{_LETTER})({_LETTER})=([A-Z])({_LETTER})(?![\w(^])")
r"""What a matrix makes of a letter: :math:`M=I\omega`."""


def beside(vectors: Collection[str], texts: Iterable[str]) -> set[str]:
    """The letters of which the scalar product with a vector is printed."""
    pairs = {pair.groups() for tex in texts for pair in _PRODUCT.finditer(tex)}
    return {other for pair in pairs for other in pair if {*pair} & {*vectors}}


def factors_of_crosses(texts: Sequence[str]) -> set[str]:
    r"""The factors of vector products in a paper without bold letters, and what is beside them.

    They are those of which a rate is given by such products, as :math:`\dot M=M\times\omega`:
    letters between crosses may be numbers of rows and columns, or sets. Where no length, component
    or scalar product of one is printed, a cross may be a sign of multiplication.
    """
    equations = {tex: _letters(tex) for tex in texts if "=" in tex and r"\times" in tex}
    if any(map(_BOLD.search, texts)) or not any(map(_RATE.search, equations)):
        return set()
    crosses = [match for text in equations.values() for match in _CROSS.finditer(text)]
    found = {name for match in crosses for name in match.group("left", "right") if name}
    letters = [*map(_letters, texts)]
    images = (match.groups() for text in letters for match in _IMAGE.finditer(text))
    found |= {vector for vector, _, argument in images if argument in found}
    if not any(_is_measured(name, text) for name in found for text in letters):
        return set()
    names = {TYPED.get(letter, letter) for letter in found}
    return names | beside(names, texts)


def matrices_on_vectors(texts: Iterable[str]) -> frozenset[str]:
    r"""The capitals that make another vector of a vector: the product of the two is printed.

    As in :math:`I\omega\times\omega`, or in :math:`M=I\omega` beside :math:`M\times\omega`: numbers
    would make all this zero. A vector and its derivative are two.
    """
    letters = [_letters(_DERIVED.sub(";", tex)) for tex in texts]
    crosses = [match for text in letters for match in _CROSS.finditer(text)]
    pairs = {frozenset(match.group("left", "right")) for match in crosses}
    acting = {
        match["before"] or match["behind"]
        for match in crosses
        if match["left"] == match["right"] and bool(match["before"]) != bool(match["behind"])
    }
    images = (match.groups() for text in letters for match in _IMAGE.finditer(text))
    return frozenset(acting | {A for image, A, v in images if frozenset((image, v)) in pairs})


def _letters(tex: str) -> str:
    """A formula in single letters, without dots, types and braces."""
    found = re.sub(
        r"\\[A-Za-z]+", lambda word: "" if word[0] in _NOTHING else _SIGNS.get(word[0], ";"), tex
    )
    return re.sub(r"[{}\s]|\\[,;!]", "", found)


def _is_measured(name: str, text: str) -> bool:
    """Whether a length, a component or a scalar product of a vector is printed."""
    return any(
        re.search(pattern.replace("v", name), text)
        for pattern in (r"v_[1-3ijkxyz]", r"[(|]v[,|]", r",v\)", r"·v", r"v·", r"v=\(")
    )
