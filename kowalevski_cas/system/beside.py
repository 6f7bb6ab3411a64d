r"""What authors print of equations of motion in passing: initial values, chains of equalities.

Names that are all said to be equal, :math:`m_1=m_2=m`, are given by the last one. A chain, :math:`\dot q=\partial H/\partial p=p/m` or :math:`L=T-V=…`, gives what stands first by
what stands last; what stands between has to be equal to that, and is passed over if it only gives
names that stand nowhere else.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from typing import NamedTuple

from kowalevski_cas.notation import NotationError, defined_names, split_display
from kowalevski_cas.notation.cursor import Cursor
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.vocabulary import Vocabulary

_NAME = r"(?:\\[A-Za-z]+|[A-Za-z])(?:_(?:\w|\{[^{}]*\}))?"
_RATE = rf"\\d?dot\s*(?:\{{\s*{_NAME}\s*\}}(?:_(?:\w|\{{[^{{}}]*\}}))?|\s{_NAME}|\\[A-Za-z]+(?:_\w)?)"
_START = r"\(\s*(?:[A-Za-z]_\{?[0A-Za-z]\}?|0)\s*\)"
_INITIAL = re.compile(
    rf"(?P<left>{_RATE}|{_NAME})\s*{_START}\s*=\s*(?P<value>{_RATE}|{_NAME})", re.ASCII
)
_IS_RATE = re.compile(rf"{_RATE}|\\frac\s*\{{\s*d(?:\^\d)?\s*{_NAME}\s*\}}\s*\{{[^{{}}]*\}}")
_CALLED = re.compile(rf"(?P<name>{_NAME})\s*(?:\\left\s*)?\([^()]*\)")


def without_initial_values(tex: str, moving: Collection[str]) -> str:
    r"""A display without the names of initial values, which may be any.

    >>> without_initial_values(r"\ddot x=-x, x(t_0)=x_0, \dot x(t_0)=\dot x_0", {"x"})
    '\\ddot x=-x, , '
    """
    found = [
        (start, end, match)
        for start, end in {*split_display(tex)}
        if (match := _INITIAL.fullmatch(tex[start:end].strip(" .;~\n")))
        and _names(match["left"]) <= {*moving}
    ]
    rest = _without(tex, [(start, end) for start, end, _ in found])
    free = [one for one in found if _names(one[2]["value"]).isdisjoint(_names(rest))]
    return _without(tex, [(start, end) for start, end, _ in free])


_UPRIGHT = re.compile(r"\\(?:mathrm|operatorname|rm)\s*(?:\{\s*i\s*\}|i(?![A-Za-z]))")


def with_upright_unit(tex: str) -> str:
    r"""A display that says what an upright i is: the imaginary unit, and no constant.

    >>> with_upright_unit(r"\dot z=\mathrm{i}kz")
    '\\dot z=ikz,\\quad i^2=-1'
    """
    if not _UPRIGHT.search(tex):
        return tex
    said = "" if re.search(r"i\s*\^\s*\{?2\}?\s*=", tex) else r",\quad i^2=-1"
    return _UPRIGHT.sub("i", tex) + said


_COLUMN = re.compile(
    r"\\d?dot\s*(?:\{\s*(?P<braced>[A-Za-z])\s*\}|\s(?P<name>[A-Za-z]))\s*&?\s*=(?P<force>.*)", re.DOTALL
)


def columns(tex: str) -> dict[str, tuple[str, ...]]:
    r"""The vectors that are printed in italics beside their components, with these.

    They are those of which the rate is a gradient, perhaps times a matrix.

    >>> columns(r"\dot q=J\nabla H, H=q_1^2+q_2^2"), columns(r"\dot q=-\nabla V")
    ({'q': ('q_1', 'q_2')}, {})
    """
    found = dict[str, tuple[str, ...]]()
    for start, end in {*split_display(tex)} if r"\nabla" in tex else ():
        column = _COLUMN.match(tex[start:end].strip())
        if column is not None and r"\nabla" in column["force"]:
            name = column["braced"] or column["name"]
            index = rf"(?<![A-Za-z\\]){name}\s*_\s*\{{?\s*(\d)"
            numbers = sorted({int(number) for number in re.findall(index, tex)})
            if numbers and numbers == [*range(1, len(numbers) + 1)]:
                found[name] = tuple(f"{name}_{number}" for number in numbers)
    return found


def with_columns_in_bold(tex: str, names: Collection[str]) -> str:
    r"""A formula with these names in bold; a function of them is one of their components.

    >>> with_columns_in_bold(r"\dot q=J\nabla H(q)", ["q"])
    '\\dot {\\mathbf{q}}=J\\nabla H'
    """
    for name in names:
        tex = re.sub(rf"(?<![A-Za-z\\])([A-Z])\s*\(\s*{name}\s*\)", r"\1", tex)
        bare = rf"(?<![A-Za-z\\{{]){name}(?![A-Za-z])(?!\s*_)|\{{\s*{name}\s*\}}(?!\s*_)"
        tex = re.sub(bare, rf"{{\\mathbf{{{name}}}}}", tex)
    return tex


class Chains(NamedTuple):
    """A display without chains, and the equalities of what stood in them."""

    tex: str
    equalities: tuple[tuple[str, str], ...]


def without_chains(tex: str, moving: Collection[str] = ()) -> Chains:
    r"""A display where each name and each rate is given once.

    >>> without_chains(r"\dot q=\frac{\partial H}{\partial p}=p, \dot p=-q, H=T-V=p^2+q^2")
    Chains(tex='\\dot q=p, \\dot p=-q, H=p^2+q^2', equalities=(('\\frac{\\partial H}{\\partial p}', 'p'),))
    """
    places = sorted({*split_display(tex)}, reverse=True)
    equalities = list[tuple[str, str]]()
    changed = tex
    for start, end in places:
        members = _members(tex[start:end])
        rest = _names(_without(tex, [(start, end)])) | {*moving}
        given, others = _sides(members, rest)
        if not others and not any(map(_is_indexed, members)):
            if moving and all(_head(one) not in {*map(_head, moving)} for one in members):
                rows = [f"{one}=+{members[-1]}" for one in members[:-1]]
                changed = changed[:start] + r",\quad ".join(rows) + changed[end:]
            continue
        rates = [one for one in given if _IS_RATE.fullmatch(one)]
        if not given or len(others) < (1 if rates and len(given) > 1 else 2):
            continue
        *between, last = others
        known = rest | _names(" , ".join((*given, last)))
        equalities += [(one, last) for one in between if _names(one) & known]
        rows = [f"{one}={last}" for one in given]
        changed = changed[:start] + r",\quad ".join(rows) + changed[end:]
    return Chains(changed, tuple(reversed(equalities)))


def _members(statement: str) -> list[str]:
    """What the signs of equality of a statement stand between, without marks of alignment."""
    found, depth, last = list[str](), 0, 0
    for token in scan(statement):
        depth += token.kind in ("{", "open") or token.kind == "begin"
        depth -= token.kind in ("}", "close") or token.kind == "end"
        if token.text == "=" and not depth:
            found.append(statement[last : token.start])
            last = token.end
    return [one.strip(" &\n\t.;") for one in (*found, statement[last:])]


def _sides(members: list[str], known: Collection[str]) -> tuple[list[str], list[str]]:
    """What a chain gives, and by what: rates, and names before all else; no new name behind."""
    given, others = list[str](), list[str]()
    for member in members:
        is_rate = bool(_IS_RATE.fullmatch(member))
        if _is_constant(member):
            continue
        if is_rate or (_is_given(member) and not others and not any(map(_IS_RATE.fullmatch, given))):
            given.append(member)
        elif not re.fullmatch(_NAME, member) or not {*known}.isdisjoint(_names(member)):
            others.append(member)
    return (given, others) if members and members[0] in given else ([], others)


def _is_given(member: str) -> bool:
    """Whether it is a rate, a name, or a name at arguments."""
    return any(pattern.fullmatch(member) for pattern in (_IS_RATE, _CALLED, re.compile(_NAME)))


def _is_indexed(member: str) -> bool:
    """Whether a letter runs in it, or it is a bracket or a name at arguments."""
    return bool(re.search(r"_\{?[^}]*[i-n]|\(", member)) or bool(_IS_RATE.fullmatch(member))


def _head(name: str) -> str:
    return name.partition("_")[0].strip()


def _is_constant(member: str) -> bool:
    return not member or r"\mathrm{const}" in member or r"\text{const}" in member


def _names(tex: str) -> set[str]:
    """The names that stand in a formula."""
    try:
        return {letter + index for letter, index in Cursor(tex, scan(tex), Vocabulary()).letters()}
    except NotationError:
        return set()


def _without(tex: str, places: list[tuple[int, int]]) -> str:
    for start, end in sorted(places, reverse=True):
        tex = tex[:start] + tex[end:]
    return tex
