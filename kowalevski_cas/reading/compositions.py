r"""Maps as papers print them, and what is made of them, by what they take a point to.

They are given as :math:`R(x,y)=(y,x)` and :math:`\Phi:(x,y)\mapsto(y,f(y)-x)`, and stand in
:math:`\Phi=S\circ R`, :math:`R^2=\mathrm{id}`, :math:`I\circ\Phi=I` and :math:`\det D\Phi=1`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

_LETTER = r"(?:\\[A-Za-z]+|[A-Za-z])(?:_(?:\w|\{\w+\}))?"
_SIZE = r"(?:\\(?:left|right|bigl?|bigr|Bigl?|Bigr|biggl?|biggr)\s*)?"
_ARGUMENTS = rf"{_SIZE}\(\s*(?P<by>{_LETTER}(?:\s*,\s*{_LETTER})+)\s*{_SIZE}\)"
_LABELS = re.compile(r"(?:\s*\\label\s*\{[^{}]*\})*\s*")
_NAME = rf"(?P<name>{_LETTER})(?P<inverse>\s*\^\s*\{{\s*-\s*1\s*\}})?"
_GIVEN = re.compile(rf"\s*{_NAME}\s*{_ARGUMENTS}\s*&?=\s*&?(?=\s*{_SIZE}\()")
_ARROW = re.compile(rf"\s*{_NAME}\s*:\s*{_ARGUMENTS}\s*\\mapsto(?![A-Za-z])(?=\s*{_SIZE}\()")
_SCALAR = re.compile(rf"\s*{_NAME}\s*{_ARGUMENTS}\s*&?=")
_FACTOR = re.compile(
    rf"\s*(?:(?P<id>\\(?:mathrm|operatorname|mathop|text)\s*\{{\s*[Ii]d\s*\}})|(?P<name>{_LETTER})"
    r"(?:\s*\^\s*(?:\{\s*(?P<power>-?\s*\d+)\s*\}|(?P<digit>\d)))?)\s*"
)
_DERIVED = re.compile(rf"(?<![A-Za-z\\])D\s*(?P<name>{_LETTER})(?!\s*\()")
_ENDS = re.compile(r"[\s.,;~]|\\(?:quad|qquad|label\s*\{[^{}]*\}|[,;:!])")


_BESIDE = re.compile(r",\s*\\q?quad(?![A-Za-z])")
_SIDE = ",\\quad "


class PrintedMap(NamedTuple):
    """The arguments of a map, and to what it takes them."""

    by: tuple[str, ...]
    values: tuple[str, ...]


Maps = Mapping[str, PrintedMap]
"""Maps by their names; of an inverse this is a letter with the exponent."""


def maps_in(texts: Sequence[str]) -> dict[str, PrintedMap]:
    r"""The maps that displays give by tuples, or by images with primes.

    >>> maps_in([r"R(x,y)=(y,x)"])
    {'R': PrintedMap(by=('x', 'y'), values=('y', 'x'))}
    >>> maps_in([r"T:(x,y)\mapsto(x',y'), \quad x'=y,\quad y'=\frac{a+y}{x}."])["T"].values
    ('y', '\\frac{a+y}{x}')
    """
    found: dict[str, PrintedMap] = {}
    for tex in map(_unlabelled, texts):
        for start, one in _given(tex):
            by = _listed(one["by"])
            values, end = _tuple(tex, start)
            if _are_primed(values, by):
                values = _images(by, tex[end:])
            if len(values) == len(by) == len({*by}):
                found.setdefault(_name(one), PrintedMap(by, values))
    return found


def functions_in(texts: Sequence[str]) -> dict[str, tuple[str, ...]]:
    """The functions of several arguments that displays give, with these."""
    every = (one for tex in texts if (one := _SCALAR.match(_unlabelled(tex))))
    return {one["name"]: _listed(one["by"]) for one in every if not one["inverse"]}


def gives_map(tex: str) -> bool:
    """Whether a display begins with what a map takes to what."""
    return any(pattern.match(_unlabelled(tex)) for pattern in (_GIVEN, _ARROW))


def is_of_maps(tex: str) -> bool:
    """Whether something is said of maps as such."""
    return r"\circ" in tex or _DERIVED.search(tex) is not None or gives_map(tex)


def written_out(tex: str, maps: Maps, functions: Mapping[str, tuple[str, ...]]) -> str:
    r"""What is said of maps, by that to which they take a point.

    >>> maps = maps_in(["R(x,y)=(y,x)", "S(x,y)=(x,f(x)-y)"])
    >>> written_out(r"S\circ R=T", maps, {}), written_out(r"R\circ R=\mathrm{id}.", maps, {})
    ('S\\circ R=T', '(x,y)=(x,y)')
    >>> written_out(r"I\circ R=I", maps, {"I": ("x", "y")})
    'I(y,x)=I(x,y)'
    >>> written_out(r"T:(x,y)\mapsto(y,x+1)", maps, {})
    "x'=y,\\quad y'=x+1"
    """
    labels = tex[: len(tex) - len(_unlabelled(tex))]
    return labels + _written_out(_unlabelled(tex), maps, functions)


def _unlabelled(tex: str) -> str:
    """A display without the labels before it."""
    start = _LABELS.match(tex)
    return tex[start.end() :] if start else tex


def _written_out(tex: str, maps: Maps, functions: Mapping[str, tuple[str, ...]]) -> str:
    if not maps and not _ARROW.match(tex):
        return tex
    if one := _ARROW.match(tex):
        values, _ = _tuple(tex, one.end())
        by = _listed(one["by"])
        if len(values) != len(by) or _are_primed(values, by):
            return tex
        return _SIDE.join(f"{x}'={value}" for x, value in zip(by, values, strict=True))
    if (one := _GIVEN.match(tex)) and one["inverse"] and one["name"] in maps:
        own, inverse = maps[one["name"]], maps.get(_name(one))
        return f"{_at(own, inverse)}={_point(inverse.by)}" if inverse else tex
    parts = (_statement(part, maps, functions) for part in _BESIDE.split(tex))
    return _SIDE.join(_derivatives(part, maps) for part in parts)


def _statement(tex: str, maps: Maps, functions: Mapping[str, tuple[str, ...]]) -> str:
    """An equation between maps, or functions of images, by their values; else as it is."""
    whole = _ENDS.sub(" ", tex).strip()
    members = [[*_factors(member, {*maps, *functions})] for member in whole.split("=")]
    if len(members) < 2 or not all(members) or not any(len(m) > 1 or m[0][1] != 1 for m in members):
        return tex
    first = next((maps[n] for m in members for n, _ in m if n in maps), None)
    if first is None:
        return tex
    found = [_value(member, first.by, maps, functions) for member in members]
    return "=".join(found) if all(found) else tex


def _factors(member: str, known: set[str]) -> Iterator[tuple[str, int]]:
    r"""The names in a composition, with their exponents; none if it is no composition."""
    found: list[tuple[str, int]] = []
    for part in re.split(r"\\circ(?![A-Za-z])", member):
        one = _FACTOR.fullmatch(part)
        if one is None or not (one["id"] or one["name"] in known):
            return
        power = int((one["power"] or one["digit"] or "1").replace(" ", ""))
        found.append(("", 1) if one["id"] else (one["name"], power))
    yield from found


def _value(
    factors: Sequence[tuple[str, int]],
    by: tuple[str, ...],
    maps: Maps,
    functions: Mapping[str, tuple[str, ...]],
) -> str:
    """What a composition is at a point; empty if it is not known."""
    values, outer = by, ""
    for place, (name, power) in reversed([*enumerate(factors)]):
        if not name:
            continue
        if name in functions and name not in maps:
            if place or power != 1:
                return ""
            outer = name
            continue
        own = maps.get(name if power > 0 else f"{name}^-")
        if own is None or abs(power) > 4 or len(own.by) != len(by):
            return ""
        for _ in range(abs(power)):
            values = tuple(_put(value, own.by, values) for value in own.values)
    return f"{outer}{_point(values)}"


def _derivatives(tex: str, maps: Maps) -> str:
    """The derivative of a map by its matrix."""

    def matrix(found: re.Match[str]) -> str:
        own = maps.get(found["name"])
        if own is None:
            return found[0]
        rows = (
            "&".join(rf"\frac{{\partial}}{{\partial {x}}}\left({value}\right)" for x in own.by)
            for value in own.values
        )
        table = r"\\".join(rows)
        return rf"\begin{{pmatrix}}{table}\end{{pmatrix}}"

    return _DERIVED.sub(matrix, tex)


def _are_primed(values: Sequence[str], by: Sequence[str]) -> bool:
    """Whether a map is said to take its arguments to these with primes."""
    return [*values] == [f"{x}'" for x in by]


def _at(own: PrintedMap, inner: PrintedMap) -> str:
    """The values of a map at those of another one."""
    return _point(tuple(_put(value, own.by, inner.values) for value in own.values))


def _put(value: str, by: Sequence[str], values: Sequence[str]) -> str:
    """A formula with others in the place of its letters."""
    at = {
        x: value if re.fullmatch(_LETTER, value) else rf"\left({value}\right)"
        for x, value in zip(by, values, strict=True)
    }
    letters = "|".join(re.escape(x) for x in sorted(by, key=len, reverse=True))
    return re.sub(rf"(?<![A-Za-z\\])(?:{letters})(?![A-Za-z_'])", lambda one: at[one[0]], value)


def _point(values: Sequence[str]) -> str:
    return f"({','.join(values)})"


def _given(tex: str) -> Iterator[tuple[int, re.Match[str]]]:
    for pattern in (_GIVEN, _ARROW):
        if one := pattern.match(tex):
            yield one.end(), one


def _name(one: re.Match[str]) -> str:
    return f"{one['name']}^-" if one["inverse"] else str(one["name"])


def _listed(by: str) -> tuple[str, ...]:
    return tuple(one.strip() for one in by.split(","))


def _images(by: Sequence[str], behind: str) -> tuple[str, ...]:
    """What is printed for images with primes."""
    ends = r"(?:[,.;]\s*(?:\\q|\\label|$|\s)|$)"
    printed = (
        re.search(rf"(?<![A-Za-z\\]){re.escape(x)}'\s*&?=\s*&?(.*?){ends}", behind) for x in by
    )
    found = tuple(_ENDS.sub(" ", one[1]).strip() for one in printed if one)
    return found if len(found) == len(by) else ()


def _tuple(tex: str, start: int) -> tuple[tuple[str, ...], int]:
    """The entries of the brackets that open at a place, and where these end."""
    opened = re.compile(rf"\s*{_SIZE}\(").match(tex, start)
    if opened is None:
        return (), start
    depth, last, entries = 1, opened.end(), list[str]()
    for k in range(opened.end(), len(tex)):
        depth += (tex[k] in "([{") - (tex[k] in ")]}")
        if depth == 0 or (depth == 1 and tex[k] == "," and tex[k - 1] != "\\"):
            entry = re.sub(r"\\(?:right|bigg?r?|Bigg?r?)\s*$", "", tex[last:k])
            entries.append(re.sub(r"^(?:\\[,;! ]|\s)+|(?:\\[,;! ]|\s)+$", "", entry))
            last = k + 1
        if depth == 0:
            return tuple(entries), k + 1
    return (), start
