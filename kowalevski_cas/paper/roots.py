"""Roots that a printed equation gives by their square."""

from __future__ import annotations

from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.notation import Constant, Formula, Name, Number, Power
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.space import Adjoined, Meaningless


def solved(setting: Meaning, name: str, printed: Printed) -> Adjoined:
    r"""A root by a printed equation in which its square stands.

    The equation is solved for the square: ``a^2`` in :math:`(\alpha,\alpha)=a^2`,
    ``z_1^2`` in :math:`z_1^2+x_1y_2=c_1`. Members with names that the scene does
    not have are passed over.
    """
    setting.places[name] = (printed,)
    members = [m for m in setting.texts.relation(printed).members if not isinstance(m, Constant)]
    own = Power(Name(name), Number(2))
    if len(members) == 2 and own in members:
        other = members[members[0] == own]
        if not _mentions(other, name):
            return Adjoined(name, setting.plain(other))
    sides = [plain for m in members if (plain := _known(setting, m, name)) is not None]
    if len(sides) < 2:
        raise Meaningless(f"the equation at {printed.place} does not give {name}^2", name)
    left, right = sides[0], sides[-1]
    at = [setting.at_root(name, k, left) - setting.at_root(name, k, right) for k in (0, 1, -1, 2)]
    factor = at[1] - at[0]
    even = (at[2] - at[1]).is_zero
    quadratic = (at[3] - at[0] - factor * factor.ring.number(4)).is_zero
    if factor.is_zero or not even or not quadratic:
        raise Meaningless(f"the equation at {printed.place} does not give {name}^2", name)
    square = formula_in(-at[0] / factor)
    return Adjoined(name, square, (left, right))


def _known(setting: Meaning, member: Formula, root: str) -> Formula | None:
    """A member written out; ``None`` if the scene does not know what it is."""
    try:
        plain = setting.plain(member)
        setting.at_root(root, 0, plain)
    except Meaningless:
        return None
    return plain


def _mentions(formula: Formula, name: str) -> bool:
    return formula == Name(name) or any(_mentions(child, name) for child in formula.children())
