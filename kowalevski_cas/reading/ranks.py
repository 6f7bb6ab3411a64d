r"""Letters in plain type that are vectors or matrices, as what they are set equal to is one.

So :math:`e=(1,1,1)^T` is a vector, and :math:`N=L^+L^-` a matrix where these are. A letter is
taken for one only if no formula that has it can be read no longer.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

from kowalevski_cas.notation import Name, NotationError, Relation, Vocabulary, rank
from kowalevski_cas.notation.layout import statements
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.notation.vocabulary import MATRIX, SCALAR, VECTOR
from kowalevski_cas.source.displays import TypedFormula

_MOST = 5
"""So often is asked again: what is made of a matrix that is made of others is one, too."""

Readable = Callable[[TypedFormula, Vocabulary], bool]


def with_ranks(
    formulas: Sequence[TypedFormula], words: Vocabulary, readable: Readable
) -> Vocabulary:
    """The vocabulary with the letters that are vectors or matrices by what they are equal to."""
    for _ in range(_MOST):
        found = words
        for name, own in {pair for one in formulas for pair in _given(one, words)}:
            new = _taken(words, name, own)
            letter = re.compile(rf"(?<![A-Za-z\\]){re.escape(_stem(name))}(?![A-Za-z])")
            mine = [one for one in formulas if letter.search(one.tex)]
            if sum(readable(one, new) for one in mine) >= sum(readable(one, words) for one in mine):
                found = _taken(found, name, own)
        if found == words:
            break
        words = found
    return words


def _given(formula: TypedFormula, words: Vocabulary) -> Iterator[tuple[str, int]]:
    """The scalars that a formula sets equal to a vector or a matrix, with the rank of this."""
    with suppress(NotationError, RecursionError, IndexError):
        for tokens, *_ in statements(formula.tex):
            cut = next((k for k, one in enumerate(tokens) if one.kind == "relation"), 0)
            if not cut or tokens[cut].text != "=" or tokens[0].kind != "letter":
                continue
            left = OpenParser(formula.tex, [*tokens[:cut]], words).statement()[0]
            right = OpenParser(formula.tex, [*tokens[cut + 1 :]], words).statement()[0]
            first = right.members[0] if isinstance(right, Relation) else right
            if isinstance(left, Name) and words.ranks.get(left.name, SCALAR) == SCALAR:
                if own := rank(first, words):
                    yield left.name, own


def _taken(words: Vocabulary, name: str, own: int) -> Vocabulary:
    """The vocabulary in which a scalar is a vector, or a matrix; nothing is derived by one."""
    vectors, matrices = ({name} if own == one else set() for one in (VECTOR, MATRIX))
    return replace(
        words,
        scalars=words.scalars - {name},
        vectors=words.vectors | vectors,
        matrices=words.matrices | matrices,
        times=words.times - {name},
        moving=words.moving - vectors,
    )


def _stem(name: str) -> str:
    """The letter of a name, as it is printed."""
    return re.split(r"[_^]", name)[0]
