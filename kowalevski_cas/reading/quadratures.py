r"""What a quadrature says: :math:`t=\int dx/\sqrt{P}` that the square of the velocity is P.

It is claimed of the square of a rate, for a root has either sign, and where a motion begins is
said by a constant, or by the lower limit.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from itertools import pairwise

from kowalevski_cas.notation.errors import NotationError
from kowalevski_cas.notation.tokens import after_group
from kowalevski_cas.paper.chains import NAME

_D = r"(?:\\mathrm\s*\{\s*d\s*\}|(?<![A-Za-z\\])d)\s*"
_GAP = r"(?:\\[,;:!]|\s)*"
_CONST = r"\\(?:mathrm|text)\s*\{\s*const\.?\s*\}"
_CONSTANT = rf"(?:{_GAP}[-+]{_GAP}(?:{_CONST}|{NAME}))?"
_TIMES = rf"(?P<open>\()?{_GAP}(?P<time>{NAME}){_CONSTANT}{_GAP}(?(open)\))"
_BEGUN = rf"(?:(?P=time)_(?:\w|\{{[^{{}}]*\}}){_GAP}(?=[-+]|\\[mp]{{2}}))?"
_FACTOR = r"(?P<factor>(?:(?!\\int|=|&|\\\\).)*?)"
_SIGN = rf"(?P<sign>\\int{_GAP}(?:\\limits{_GAP})?)"
_LEFT = re.compile(
    rf"(?P<lead>\s*(?:\\label\{{[^{{}}]*\}}\s*)?){_TIMES}{_GAP}={_GAP}{_BEGUN}{_FACTOR}{_SIGN}",
    re.DOTALL,
)
_RIGHT = re.compile(
    rf"{_GAP}{_CONSTANT}{_GAP}=(?P<factor>(?:(?!\\int|=|&|\\\\)[^=,;])*?){_TIMES}{_GAP}(?=[.;,\s]*$)",
    re.DOTALL,
)
_BEGINS = re.compile(rf"(?P<lead>\s*(?:\\label\{{[^{{}}]*\}}\s*)?)(?P<factor>){_SIGN}", re.DOTALL)
_SPACE_OR_BRACE = re.compile(r"\\[{}\\]|(?:\\q?quad(?![A-Za-z])\s*)+|[{}]")
_LINE = re.compile(r"\\[dt]?frac(?![A-Za-z])")
_VARIED = rf"{_D}(?P<by>{NAME}'?)"
_DIFFERENTIAL = rf"(?P<above>.*?){_GAP}{_VARIED}\s*"
_BEHIND = rf"{_GAP}{_VARIED}"
_ROOT = re.compile(rf"{_GAP}\\sqrt\s*")
_END = re.compile(rf"{_CONSTANT}(?P<end>[\s.,;]*)")


def without_quadrature(tex: str, times: Collection[str], moving: Collection[str] = ()) -> str:
    r"""That a rate has the square of what is below, in place of a quadrature by one of some times.

    By what is ``moving`` itself it is a quotient of rates. Several may stand in a display.

    >>> without_quadrature(r"t-t_0=\int\frac{dx}{\sqrt{2h-x^2}}.", "t")
    '\\left(\\frac{dx}{dt}\\right)^2=2h-x^2.'

    >>> without_quadrature(r"\int_{a}^{x}\frac{u\,du}{f(u)}=2t", "t")
    '\\left(\\frac{dx}{dt}\\right)^2=\\frac{\\left(2f(x)\\right)^2}{\\left(x\\right)^2}'

    Between constant limits it is a number, and of another name it is a function.

    >>> without_quadrature(r"T=\int_a^b\frac{dx}{\sqrt{2h-x^2}}", "t")
    'T=\\int_a^b\\frac{dx}{\\sqrt{2h-x^2}}'
    """
    parts = _parts(tex)
    try:
        found = [_left(part, times) or _right(part, times) for part in parts]
    except (NotationError, AssertionError):
        return tex
    new = "".join(rate or part for rate, part in zip(found, parts, strict=True))
    for time in times if new != tex else ():
        along = rf"\\frac{{\\dot{{\1}}}}{{\\dot{{{re.escape(time)}}}}}"
        slope = re.compile(rf"\\frac\{{d({NAME})\}}\{{d{re.escape(time)}\}}")
        new = slope.sub(along, new) if time in moving else new
    return new


def _parts(tex: str) -> list[str]:
    """The equations of a line, with the space between them."""
    ends, depth = [0], 0
    for found in _SPACE_OR_BRACE.finditer(tex):
        depth += {"{": 1, "}": -1}.get(found[0], 0)
        if depth == 0 and found[0] not in "{}":
            ends += found.span()
    return [tex[a:b] for a, b in pairwise([*ends, len(tex)])]


def _left(tex: str, times: Collection[str]) -> str:
    found = _LEFT.match(tex)
    if found is None or found["time"] not in times:
        return ""
    inner = _integrand(tex, found.end())
    behind = _END.fullmatch(tex, inner[-1]) if inner else None
    if inner is None or behind is None:
        return ""
    name, above, below, _ = inner
    if not _is_factor(found["factor"], name):
        return ""
    above = found["factor"].replace(r"\pm", " ").strip().lstrip("+-") + above.strip()
    return found["lead"] + _rate(name, found["time"], above, below, "") + behind["end"]


def _right(tex: str, times: Collection[str]) -> str:
    found = _BEGINS.match(tex)
    inner = _integrand(tex, found.end()) if found else None
    if found is None or inner is None:
        return ""
    name, above, below, end = inner
    behind = _RIGHT.match(tex, end)
    if behind is None or behind["time"] not in times or not _END.fullmatch(tex, behind.end()):
        return ""
    if not _is_factor(behind["factor"], name):
        return ""
    factor = behind["factor"].replace(r"\pm", " ").strip()
    rate = _rate(name, behind["time"], above, below, factor)
    return found["lead"] + rate + tex[behind.end() :]


def _is_factor(tex: str, name: str) -> bool:
    """Whether what stands before an integral, or the time, is one factor that does not vary."""
    inner = tex.strip().removeprefix("-").removeprefix("+")
    return re.search(rf"[+-]|(?<![A-Za-z\\]){re.escape(name)}(?![A-Za-z_])", inner) is None


def _integrand(tex: str, at: int) -> tuple[str, str, str, int] | None:
    """The name that varies, what stands beside its differential, what is below, and the end."""
    upper = ""
    if tex[at : at + 1] == "_":
        at = after_group(tex, at + 1)
        if tex[at : at + 1] != "^":
            return None
    if tex[at : at + 1] == "^":
        start, at = at + 1, after_group(tex, at + 1)
        upper = tex[start:at].strip("{} ")
    aboves, below, at = _fractions(tex, at)
    found = [re.fullmatch(_DIFFERENTIAL, one, re.DOTALL) for one in aboves]
    behind = re.compile(_BEHIND).match(tex, at)
    varied = [one for one in (*found, behind) if one]
    if not aboves or len(varied) != 1 or (upper and not re.fullmatch(NAME, upper)):
        return None
    at = behind.end() if behind else at
    own = varied[0]["by"].strip()
    factors = [one["above"] if one else own for one, own in zip(found, aboves, strict=True)]
    above = _product([one for one in factors if one.strip() not in ("", "1")])
    if upper and upper != own:
        above, below = (_renamed(one, own, upper) for one in (above, below))
    return upper or own, above, below, at


def _fractions(tex: str, at: int) -> tuple[list[str], str, int]:
    """What stands above the lines of some fractions, the product of what is below, and the end."""
    aboves, belows = list[str](), list[str]()
    while line := re.compile(_GAP + _LINE.pattern).match(tex, at):
        middle = after_group(tex, line.end())
        at = after_group(tex, middle)
        for side, found in ((tex[line.end() : middle], aboves), (tex[middle:at], belows)):
            inner = side.strip()
            found.append(inner[1:-1] if inner[:1] == "{" else inner)
    return aboves, _product(belows), at


def _product(factors: Sequence[str]) -> str:
    """A product; one factor needs no brackets."""
    if len(factors) < 2:
        return "".join(factors)
    return "".join(rf"\left({one}\right)" for one in factors)


def _renamed(tex: str, name: str, other: str) -> str:
    """A text with another letter for one."""
    pattern = rf"{re.escape(name)}(?![A-Za-z])|\\[A-Za-z]+|."
    return re.sub(pattern, lambda m: other if m[0] == name else m[0], tex, flags=re.DOTALL)


def _rate(name: str, time: str, above: str, below: str, factor: str) -> str:
    """The square of a rate, by what stands below and above, and a factor of the time."""
    root = _ROOT.match(below)
    if root and not factor and not _outside(below, root.end()):
        square = below[root.end() :].strip()
        square = square[1:-1] if square[:1] == "{" else square
    else:
        square = rf"\left({factor}{below}\right)^2"
    over = rf"\frac{{{square}}}{{\left({above.strip()}\right)^2}}" if above.strip() else square
    return rf"\left(\frac{{d{name}}}{{d{time}}}\right)^2={over}"


def _outside(tex: str, at: int) -> str:
    """What stands behind a group that begins here."""
    return tex[after_group(tex, at) :].strip()
