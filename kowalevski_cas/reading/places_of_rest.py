r"""Places where words say that nothing moves, and the velocities are not printed.

So :math:`x=1` is an equilibrium of :math:`\dot x=y,\ \dot y=f(x)`: there :math:`y=0`, for else x
would move.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from kowalevski_cas.notation import Derivative, Name, to_latex
from kowalevski_cas.reading.cues import cue
from kowalevski_cas.reading.degrees import degrees
from kowalevski_cas.reading.hypotheses import is_value
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.law import Law
from kowalevski_cas.reading.sets import SetOfEquations
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.reading.unprinted import unprinted

_FAMILY = re.compile(
    r"\b(?:lines?|ax[ie]s|curves?|circles?|planes?|surfaces?|manifolds?|sets?|famil\w+|rays?"
    r"|whatever|regardless|independent\w*|velocit\w+|speeds?|moment(?:um|a)|whole|entire|every|each|all|any|consist\w*|fill\w*|made|composed|arbitrary|for|with|if"
    r"|прям\w+|ос[иьей]\w*|крив\w+|окружност\w+|плоскост\w+|множеств\w+|семейств\w+|вс[еёяю]\w*|люб\w+"
    r"|кажд\w+|состо\w+|заполн\w+|произвольн\w+|скорост\w+|импульс\w*|независимо|при|если)\b",
    re.IGNORECASE,
)
"""Words that may speak of all the states at some places, or tell which they are."""


def velocities_at_rest(places: SetOfEquations, law: Law, known: Known) -> list[SourceStatement]:
    """The equations that give the velocities at some places where words say that nothing moves.

    Each is that what moves a coordinate vanishes: one name, in the first degree, of which the
    sentence says nothing. There are none if the words may be about other states there as well.
    """
    words = places[0].words
    if not cue("equilibrium", words) or _FAMILY.search(words):
        return []
    if not all(is_value(one, known) for one in places):
        return []
    beside = known.of_sentence(places[0].sentence)
    told = {*known.names.scalars(name for one in beside for name in one.names)}
    every = [*_velocities(law, known)]
    found = {tex: name for one, tex, name in every if one in told}
    if known.bound:  # other coordinates are what the constraints make them
        found |= {tex: name for one, tex, name in every if one not in (*told, *found.values())}
    moving = {*known.names.scalars(found.values())}
    if told & moving or ({*law.variables} - told - moving and not known.bound):
        return []
    why = "nothing moves there"
    return [
        unprinted(known.paper, f"still-{k}-{places[0].order}", tex, places[0], why)
        for k, tex in enumerate(found, 1)
    ]


def _velocities(law: Law, known: Known) -> Iterator[tuple[str, str, str]]:
    """The coordinates, each with the equation that it does not move, and the one name in this."""
    for row in law.rows:
        match row.members:
            case (Derivative(Name(coordinate)), force) if {*row.rates.values()} == {1}:
                names = known.varying(force.names())
                if len(names) == 1 and coordinate not in names and degrees(force, known) <= {0, 1}:
                    yield coordinate, f"{to_latex(force)}=0", names[0]
