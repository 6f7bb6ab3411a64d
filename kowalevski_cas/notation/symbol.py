r"""A name by its parts: letter, font, accents, raised sign, index, primes.

The name of a formula is a string, for it is a key everywhere; what stands in the string is known
here, and nobody else takes it apart.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from functools import cache

from kowalevski_cas.notation.decorations import ACCENTS, RAISED, RATES

DIACRITICS = (*ACCENTS,)
"""Marks over a letter that make another name of it."""

DOTS = (*RATES,)
"""Marks over a letter that make it the name of a rate."""

FONTS = (
    r"\mathbf", r"\boldsymbol", r"\mathrm", r"\mathcal", r"\mathscr", r"\mathfrak", r"\mathbb",
    r"\mathsf",
)  # fmt: skip

BOLD = (r"\mathbf", r"\boldsymbol")

STAR = "^*"

_ACCENTS = "|".join(map(re.escape, (*DOTS, *DIACRITICS)))
_RAISED = "|".join(rf"{re.escape(sign)}(?![A-Za-z])" for sign in RAISED)
_ACCENT = re.compile(rf"({_ACCENTS})\{{")
_FRAME = r"\{\\math(?:cal|scr)\{[A-Za-z]\}\}"
"""The name of a frame that is raised on a letter: no power is printed in such type."""
_SYMBOL = re.compile(
    rf"""(?P<accents>(?:(?:{_ACCENTS})\{{)*)
    (?:(?P<font>{"|".join(map(re.escape, FONTS))})\{{(?P<styled>[^{{}}]+)\}}
      | (?P<letter>\\[A-Za-z]+|[A-Za-z]))
    (?P<closing>\}}*)(?P<raised>\^(?:{_RAISED}|{_FRAME}))?(?:_(?:\{{(?P<low>.+)\}}|(?P<sign>[^{{])))?(?P<primes>'*)""",
    re.VERBOSE | re.DOTALL,
)
_VALUE = re.compile(
    r"(?P<letter>(?:[^_{]|\{[^{}]*\}|\{)*)(?:_(?:\{(?P<low>.*)\}|(?P<sign>.*)))?", re.DOTALL
)
"""What is no letter, but the name of a value."""


@dataclass(frozen=True)
class Symbol:
    r"""The parts of a name; the accents from the outermost to the innermost.

    The name of a value, as ``\sin{\theta}``, is a letter as a whole.
    """

    letter: str
    font: str = ""
    accents: tuple[str, ...] = ()
    raised: str = ""
    index: str = ""
    primes: str = ""

    @property
    def name(self) -> str:
        r"""The name in canonical LaTeX, each of which has other parts.

        >>> Symbol("x", r"\mathbf", (r"\hat",), "^*", "12").name
        '\\hat{\\mathbf{x}}^*_{12}'
        """
        text = f"{self.font}{{{self.letter}}}" if self.font else self.letter
        for accent in reversed(self.accents):
            text = f"{accent}{{{text}}}"
        low = self.index if len(self.index) < 2 else f"{{{self.index}}}"
        return text + self.raised + (low and f"_{low}") + self.primes

    @property
    def head(self) -> str:
        r"""All but the index and the primes, as ``\hat{x}`` of ``\hat{x}_1``."""
        return replace(self, index="", primes="").name

    @property
    def is_bold(self) -> bool:
        """Whether it is printed as vectors and matrices are, in bold type or with an arrow."""
        return self.font in BOLD or r"\vec" in self.accents

    @property
    def without_type(self) -> Symbol:
        r"""The symbol in no type that vectors have: :math:`x_1` for :math:`\mathbf x_1`."""
        accents = tuple(accent for accent in self.accents if accent != r"\vec")
        return replace(self, font="", accents=accents)

    def component(self, axis: int | str) -> Symbol:
        r"""A component of a vector, as :math:`p_1` or :math:`p_x` of :math:`\mathbf p`."""
        return replace(self.without_type, index=f"{self.index}{axis}")

    def in_other_types(self) -> list[Symbol]:
        r"""The symbols for the same vector in the other types in use for vectors.

        >>> [other.name for other in symbol(r"\hat{\mathbf{x}}_1").in_other_types()]
        ['\\hat{\\boldsymbol{x}}_1', '\\hat{\\vec{x}}_1']
        """
        plain = self.without_type
        types = [
            *(replace(plain, font=font) for font in BOLD),
            replace(plain, accents=(*plain.accents, r"\vec")),
        ]
        return [other for other in types if other != self] if self in types else []


def is_frame(text: str) -> bool:
    r"""Whether a letter is the name of a frame where it is raised.

    >>> is_frame(r"\mathcal{P}"), is_frame(r"\mathrm{T}"), is_frame("n")
    (True, False, False)
    """
    return re.fullmatch(_FRAME, f"{{{text}}}") is not None


@cache
def symbol(name: str) -> Symbol:
    r"""The parts of a name.

    >>> symbol(r"\hat{\mathbf{x}}_{12}")
    Symbol(letter='x', font='\\mathbf', accents=('\\hat',), raised='', index='12', primes='')
    >>> symbol(r"U^*_1").index, symbol("k'_1").primes, symbol(r"\sin{\theta_1}").letter
    ('1', '', '\\sin{\\theta_1}')
    """
    found = _SYMBOL.fullmatch(name)
    accents = _ACCENT.findall(found["accents"]) if found else []
    if found is None or len(found["closing"]) != len(accents):
        found = _VALUE.fullmatch(name)
        assert found is not None  # it matches anything
        return Symbol(found["letter"], index=found["low"] or found["sign"] or "")
    return Symbol(
        found["letter"] or found["styled"],
        found["font"] or "",
        tuple(accents),
        found["raised"] or "",
        found["low"] or found["sign"] or "",
        found["primes"],
    )


def rate_name(name: str) -> str:
    r"""The name of the derivative of a variable, as it is printed.

    >>> rate_name(r"\omega_1"), rate_name(r"\dot{x}")
    ('\\dot{\\omega}_1', '\\ddot{x}')
    """
    parts = symbol(name)
    outer, *inner = parts.accents or ("",)
    if outer in DOTS[:-1]:  # a dot more
        return replace(parts, accents=(DOTS[DOTS.index(outer) + 1], *inner)).name
    return replace(parts, accents=(DOTS[0], *parts.accents)).name


def name_of_rate(name: str) -> str:
    r"""The variable of which a name is the derivative; the name itself, if it is no such one.

    >>> name_of_rate(r"\dot{\omega}_1"), name_of_rate(r"\dot{\mathbf{r}}"), name_of_rate("x_1")
    ('\\omega_1', '\\mathbf{r}', 'x_1')
    """
    parts = symbol(name)
    return replace(parts, accents=parts.accents[1:]).name if parts.accents[:1] == DOTS[:1] else name
