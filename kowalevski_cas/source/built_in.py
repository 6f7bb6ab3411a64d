r"""What LaTeX and its packages make of arguments: choices that can be made, and those that cannot.

Each function takes the arguments that come next and returns what stands for all of it. Where a
choice cannot be made, both stand there, in a conditional that nothing decides.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from kowalevski_cas.source.conditionals import UNDECIDED
from kowalevski_cas.source.mouth import Mouth
from kowalevski_cas.source.parameters import FALSE, NO_VALUE, TRUE
from kowalevski_cas.source.tex import TypedToken, strip

Choice = Callable[[Mouth], "bool | None"]

_LAYOUT = frozenset(
    rf"\{name}"
    for name in "limits nolimits displaystyle textstyle scriptstyle scriptscriptstyle".split()
) | {" ", "{", "}"}


def _boolean(mouth: Mouth) -> bool | None:
    flag = [token.text for token in strip(mouth.argument())]
    return True if flag == [TRUE] else False if flag == [FALSE] else None


def _without_argument(mouth: Mouth) -> bool:
    return [token.text for token in strip(mouth.argument())] == [NO_VALUE]


def _there(mouth: Mouth) -> bool:
    return not _without_argument(mouth)


def _empty(mouth: Mouth) -> bool:
    return not mouth.argument()


def _blank(mouth: Mouth) -> bool:
    return not strip(mouth.argument())


def _equal(mouth: Mouth) -> bool:
    first, second = ([token.text for token in mouth.argument()] for _ in range(2))
    return first == second


def _untold(number: int) -> Choice:
    def choose(mouth: Mouth) -> None:
        for _ in range(number):
            mouth.argument()

    return choose


def _choose(
    choice: Choice, yes: bool = True, no: bool = True
) -> Callable[[Mouth], list[TypedToken]]:
    """What a choice leaves of what follows it, where there is something for each answer."""

    def read(mouth: Mouth) -> list[TypedToken]:
        value = choice(mouth)
        first = mouth.argument() if yes else []
        second = mouth.argument() if no else []
        return all_branches(first, second) if value is None else first if value else second

    return read


def all_branches(*alternatives: Sequence[TypedToken]) -> list[TypedToken]:
    """All that may stand there."""
    at = next((tokens[0] for tokens in alternatives if tokens), TypedToken(""))
    inside = [token for tokens in alternatives for token in tokens]
    begin, end = (TypedToken(text, at.start, at.start) for text in (UNDECIDED, r"\fi"))
    return [begin, *inside, end]


def _next(mouth: Mouth) -> list[TypedToken]:
    """One of two, by the character that comes next."""
    (wanted,), yes, no = mouth.argument()[:1], mouth.argument(), mouth.argument()
    return yes if mouth.peek() == wanted.text else no


def _star(mouth: Mouth) -> list[TypedToken]:
    """One of two, by whether a star comes next, which is taken then."""
    yes, no = mouth.argument(), mouth.argument()
    return yes if mouth.skips("*") else no


def _styles(mouth: Mouth) -> list[TypedToken]:
    """What is printed in each style of formulas, if it is the same but for its layout."""
    four = [mouth.argument() for _ in range(4)]
    kinds = {tuple(t.text for t in tokens if t.text not in _LAYOUT) for tokens in four}
    return four[1] if len(kinds) == 1 else all_branches(*four)


def _one_of(number: int, place: int | None) -> Callable[[Mouth], list[TypedToken]]:
    """One of some arguments, or none of them."""

    def read(mouth: Mouth) -> list[TypedToken]:
        found = [mouth.argument() for _ in range(number)]
        return [] if place is None else found[place]

    return read


BUILT_IN: dict[str, Callable[[Mouth], list[TypedToken]]] = {
    r"\@ifnextchar": _next,
    r"\@ifstar": _star,
    r"\mathchoice": _styles,
    r"\@firstofone": _one_of(1, 0),
    r"\@firstoftwo": _one_of(2, 0),
    r"\@secondoftwo": _one_of(2, 1),
    r"\texorpdfstring": _one_of(2, 0),
    r"\unexpanded": _one_of(1, 0),
    r"\@gobble": _one_of(1, None),
    r"\vphantom": _one_of(1, None),
    r"\noexpand": _one_of(0, None),
    r"\ifstrempty": _choose(_empty),
    r"\ifblank": _choose(_blank),
    r"\ifstrequal": _choose(_equal),
    **{
        rf"\{name}": _choose(_untold(1))
        for name in "ifthenelse ifbool iftoggle @ifundefined ifdef ifundef ifcsdef ifcsundef"
        " IfFileExists @ifpackageloaded @ifclassloaded".split()
    },
    **{
        rf"\If{name}{ending}": _choose(choice, "T" in ending, "F" in ending)
        for name, choice in (
            ("Boolean", _boolean),
            ("NoValue", _without_argument),
            ("Value", _there),
        )
        for ending in ("TF", "T", "F")
    },
}
