r"""Forms of solutions that are tried, as :math:`x=Ae^{\lambda t}`, and what follows for them.

They hold for some exponents and amplitudes only: an equation behind them says for which. In
equations that are linear an exponential drops out, and amplitudes are left.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from kowalevski_cas.notation import (
    Application,
    Derivative,
    Formula,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Relation,
    Vector,
    times,
    to_latex,
)
from kowalevski_cas.reading.known import OTHER, Known, StatementRole
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.phrases import plain
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

TRIED = "tried"
"""The kind of the role of such a form."""

_EXPONENTIAL = (
    r"(?:e\s*\^\s*\{{|\\exp\s*(?:\\left\s*)?\(?)\s*[-+]?\s*"
    r"(?P<i>i(?![A-Za-z])|\\mathrm\s*\{{\s*i\s*\}})?\s*(?:\\,)?\s*{0}\s*(?:\\,)?\s*{1}(?![A-Za-z])"
)
"""An exponential of the time with a factor, which may be imaginary."""


def variable_of(item: SourceStatement, known: Known) -> str:
    """The only letter of a statement that no law has, and nothing before: λ; else none.

    Letters of coordinates in its sentence, or before it in its paragraph, are those of a place.
    """
    if isinstance(item.formula, Relation) and not item.members:
        return ""
    mentioned = {n for law in known.laws for name in law.mentions for n in known.below(name)}
    fresh = [
        name
        for name in sorted(item.names - mentioned)
        if not (known.is_defined(name) or known.moves(name) or name in known.times)
    ]
    if len(fresh) > 1:
        here = {n for one in known.items if _may_place(one, item) for n in one.names}
        fresh = [name for name in fresh if name not in here]
    return fresh[0] if len(fresh) == 1 else ""


def _may_place(one: SourceStatement, item: SourceStatement) -> bool:
    """Whether a statement may list the coordinates of a place at which another one is said."""
    listed = one.members[-1] if one.members else one.formula
    before = one.order < item.order and one.paragraph == item.paragraph
    return (one.sentence == item.sentence or before) and isinstance(listed, Vector)


def exponential(name: str, item: SourceStatement, known: Known) -> re.Match[str] | None:
    """The exponential of the time with a factor that was tried last before a statement."""
    time = "|".join(map(re.escape, sorted(known.times | {"t", r"\tau"})))
    own = re.compile(_EXPONENTIAL.format(re.escape(name), f"(?:{time})"))
    before = [
        found
        for one in known.items
        if one.order < item.order
        and one.paragraph == item.paragraph
        and one.typed is not item.typed
        and (found := own.search(one.typed.tex))
    ]
    return before[-1] if before else None


def tried(item: SourceStatement, known: Known) -> StatementRole | None:
    """A solution as an exponential of the time: an equation behind it says with which exponents."""
    if len(item.members) != 2 or not any(map(known.moves, item.bare)):
        return None
    for one in known.items:
        if one.order > item.order and one.paragraph == item.paragraph and len(one.members) == 2:
            name = variable_of(one, known)
            square = Power(Name(name), Number(2)) in one.members and Number(0) not in one.members
            gives = one.derives or known.varying(one.names) or Name(name) in one.members or square
            if name in item.names and not gives and exponential(name, one, known):
                why = f"is tried: an equation is printed for {plain(name)}"
                return StatementRole(OTHER, why, TRIED)
    return None


def amplitude_equations(item: SourceStatement, known: Known) -> tuple[SourceStatement, ...]:
    """What is left of the law where all that moves is tried as an exponential before a statement.

    There is nothing where something else stands in the law that moves. A row is left out that only
    complex numbers may satisfy: each has an amplitude by which no exponent is multiplied.
    """
    forms = {
        name: form
        for one, role in known.roles.items()
        if role.kind == TRIED and one.order < item.order and one.paragraph == item.paragraph
        for name in one.bare
        if (form := _amplitude(one, known))
    }
    laws = [law for law in known.laws if law.order < item.order and not law.images]
    if len(laws) != 1 or not forms.keys() >= {*laws[0].variables} or known.varying(item.names):
        return ()
    return tuple(_rows(item, laws[0], forms, known))


def _rows(
    item: SourceStatement, law: Law, forms: Mapping[str, tuple[Formula, Formula]], known: Known
) -> Iterator[SourceStatement]:
    """The equations of a law between amplitudes, if it is linear in what moves."""
    for number, row in enumerate(law.rows):
        if (
            row.formula is None
            or known.times & row.names
            or not {*forms} & row.names - {*row.rates}
        ):
            continue
        tex = to_latex(_put(row.formula, forms))
        yield unprinted(known.paper, f"tried-{number}-{item.order}", tex, item, "by what is tried")


def _put(formula: Formula, forms: Mapping[str, tuple[Formula, Formula]]) -> Formula:
    """A formula with amplitudes for what moves, and powers of the exponent for derivatives."""
    order, inner = 0, formula
    while isinstance(inner, Derivative):
        order, inner = order + 1, inner.argument
    if not isinstance(inner, Name) or inner.name not in forms:
        return formula.map_children(lambda one: _put(one, forms))
    amplitude, exponent = forms[inner.name]
    power: tuple[Formula, ...] = (exponent,) if order == 1 else (Power(exponent, Number(order)),)
    return times(*(power if order else ()), amplitude)


def _amplitude(item: SourceStatement, known: Known) -> tuple[Formula, Formula] | None:
    r"""What stands before the exponential of a form, and the factor of the time in it.

    Of a sum there is none.
    """
    right = item.members[-1]
    factors = list(right.factors) if isinstance(right, Product) else [right]
    found = [one for one in factors if isinstance(one, Application) and one.function == r"\exp"]
    if len(found) != 1 or len(found[0].arguments) != 1:
        return None
    rest = [one for one in factors if one is not found[0]]
    argument, negative = found[0].arguments[0], False
    if isinstance(argument, Negative):
        argument, negative = argument.argument, True
    inner = list(argument.factors) if isinstance(argument, Product) else [argument]
    time = [one for one in inner if isinstance(one, Name) and one.name in known.times | {"t"}]
    others = [one for one in inner if one not in time]
    if len(time) != 1 or any(known.varying(one.names()) for one in (*rest, *others)):
        return None
    exponent = times(*others) if others else Number(1)
    amplitude = times(*rest) if rest else Number(1)
    return amplitude, Negative(exponent) if negative else exponent
