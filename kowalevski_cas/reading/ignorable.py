r"""What words say of coordinates and momenta: that one is cyclic, that the other is an integral.

A coordinate is cyclic if it does not stand in the Lagrangian or the Hamiltonian, which may have its
velocity: :math:`\partial L/\partial\theta=0`.
"""

from __future__ import annotations

from collections.abc import Iterator

from kowalevski_cas.notation import Name
from kowalevski_cas.paper.claims import FirstIntegral, Identity
from kowalevski_cas.paper.implied import HAMILTONIANS, LAGRANGIANS
from kowalevski_cas.reading.in_words import InWords, is_unsure
from kowalevski_cas.reading.known import DEFINITION, Known
from kowalevski_cas.reading.momenta_of_energies import OF_COORDINATE
from kowalevski_cas.reading.parts import Parts
from kowalevski_cas.reading.phrases import CYCLIC, integral_words
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

IS_CYCLIC = "symmetry"
"""How these claims are called."""


def claims_of_ignorable(parts: Parts) -> Iterator[InWords]:
    """That coordinates which sentences call cyclic are, and that momenta are constant."""
    for known in parts.known:
        for item in known.items:
            value: dict[str, object] = {"printed": item.printed}
            if parts.roles[item].kind == OF_COORDINATE and (said := integral_words(item)):
                span = _up_to(said, item, parts)
                says = "this is constant along every motion"
                yield InWords(span, FirstIntegral, (item,), value, "integral", says, item)
            elif isinstance(item.formula, Name) and (said := _called_cyclic(item)):
                if (energy := _energy(item, known)) is None or not known.moves(item.formula.name):
                    continue
                letter, name = energy.bare[0], item.formula.name
                tex = rf"\frac{{\partial {letter}}}{{\partial {name}}}=0"
                found = unprinted(parts.paper, f"cyclic-{item.order}", tex, item, "these words")
                parts.places[found] = parts.places[item]
                values: dict[str, object] = {"printed": found.printed}
                span = _up_to(said, item, parts)
                says = "this coordinate does not stand in it"
                yield InWords(span, Identity, (found,), values, IS_CYCLIC, says, item)


def _up_to(said: str, item: SourceStatement, parts: Parts) -> tuple[int, int]:
    """Where a statement stands with the words that say something of it, if they are behind it."""
    at = parts.paper.prose.text.find(said, item.typed.end, item.sentence[1])
    return item.typed.start, max(item.typed.end, at + len(said))


def _called_cyclic(item: SourceStatement) -> str:
    """The word right beside a name that calls it cyclic, in a sentence that is sure."""
    around = f"{item.lead} § {item.tail}"
    at = len(item.lead) + 1
    found = [one for one in CYCLIC.finditer(around) if one.start() <= at < one.end()]
    return "" if is_unsure(item.words) or not found else found[0][0].strip("§ ~").split()[-1]


def _energy(item: SourceStatement, known: Known) -> SourceStatement | None:
    """The last Lagrangian, or Hamiltonian, that is defined before a statement."""
    letters = (*HAMILTONIANS, *LAGRANGIANS)
    found = [
        one
        for one in known.items
        if one.order < item.order
        and one.bare[:1]
        and one.bare[0] in letters
        and known.roles[one].name == DEFINITION
        and one.members[0] == Name(one.bare[0])
    ]
    return found[-1] if found else None
