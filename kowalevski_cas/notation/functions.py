r"""The functions that need no declaration, a line each: how they are printed and what they are.

Functions of a :class:`Family` are rational in a few generators, of which everything follows that is
proved of them: their squares, where these are given, their rates by the argument, and their values
where the argument is zero. Of all other functions only the derivative is known. Each is printed as
in LaTeX, or in upright letters; the first of several names is the one in which it is read.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True, eq=False)
class Family:
    r"""Functions of one argument that are rational in a few generators; all formulas are LaTeX.

    ``functions``
        names, the first of several is the one in which they are read, and formulas in generators.
    ``rates``
        the generators, with their derivatives by the argument, which is x where it stands there.
    ``squares``
        those generators that are either root of something.
    ``zero``
        the values of the generators where the argument is zero, if they have some.
    ``minus``, ``sum``
        the generators that are others at the opposite argument, and all of them at the sum of two
        arguments, where :math:`s_1` is at the second one, if there is an addition theorem.
    ``double``
        all of them at twice an argument, if they are not known there by that theorem.
    ``parameters``, ``place``
        what stands behind the argument, as the modulus, and how many of them before it.
    ``by``
        the derivatives by a parameter; by all others these functions are not derived.
    ``angles``
        the values of the generators at a part of :math:`\pi`, by that part.
    ``nonzero``
        generators that vanish nowhere.
    ``covers``
        whether the generators take all real values that their squares allow.
    ``argument``
        the part of the argument at which the generators are taken.
    ``imaginary``
        the generators at i times an argument, by those at it of the family in :data:`ROTATED`.
    ``degenerate``
        the generators for special parameters, by functions of the argument x.
    ``discriminant``
        what vanishes for the parameters for which the functions are others.
    ``integrals``
        further generators, of which nothing is known but their derivatives.
    ``printed``
        how generators are printed at an argument x that are no functions of the family.
    """

    functions: Mapping[str, str]
    rates: Mapping[str, str]
    zero: Mapping[str, str] = field(default_factory=dict)
    sum: Mapping[str, str] = field(default_factory=dict)
    minus: Mapping[str, str] = field(default_factory=dict)
    double: Mapping[str, str] = field(default_factory=dict)
    squares: Mapping[str, str] = field(default_factory=dict)
    integrals: Mapping[str, str] = field(default_factory=dict)
    parameters: tuple[str, ...] = ()
    place: int = 0
    by: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    angles: Mapping[int, Mapping[str, str]] = field(default_factory=dict)
    nonzero: tuple[str, ...] = ()
    covers: bool = True
    argument: int = 1
    imaginary: Mapping[str, str] = field(default_factory=dict)
    degenerate: Mapping[tuple[int, ...], Mapping[str, str]] = field(default_factory=dict)
    discriminant: str = "1"
    printed: Mapping[str, str] = field(default_factory=dict)

    @property
    def is_explicit(self) -> bool:
        """Whether the argument stands in the derivatives."""
        return any("x" in rate for rate in self.rates.values())


CIRCULAR = Family(
    functions={
        "sin": "s",
        "cos": "c",
        "tan tg": r"\frac{s}{c}",
        "cot ctg cotg": r"\frac{c}{s}",
        "sec": r"\frac{1}{c}",
        "csc cosec": r"\frac{1}{s}",
    },
    rates={"s": "c", "c": "-s"},
    squares={"c": "1-s^2"},
    zero={"s": "0", "c": "1"},
    minus={"s": "-s"},
    sum={"s": "sc_1+cs_1", "c": "cc_1-ss_1"},
    angles={
        1: {"s": "0", "c": "-1"},
        2: {"s": "1", "c": "0"},
        3: {"s": r"\frac{\sqrt{3}}{2}", "c": r"\frac{1}{2}"},
        4: {"s": r"\frac{\sqrt{2}}{2}", "c": r"\frac{\sqrt{2}}{2}"},
        6: {"s": r"\frac{1}{2}", "c": r"\frac{\sqrt{3}}{2}"},
    },
    imaginary={"s": r"\frac{i}{2}(e^2-\frac{1}{e^2})", "c": r"\frac{1}{2}(e^2+\frac{1}{e^2})"},
)

# The generator is e to half of the argument: it is real, so that its square is positive.
EXPONENTIAL = Family(
    functions={
        "exp": "e^2",
        "sinh sh": r"\frac{1}{2}(e^2-\frac{1}{e^2})",
        "cosh ch": r"\frac{1}{2}(e^2+\frac{1}{e^2})",
        "tanh th": r"\frac{e^4-1}{e^4+1}",
        "coth cth": r"\frac{e^4+1}{e^4-1}",
        "sech": r"\frac{2e^2}{e^4+1}",
        "csch": r"\frac{2e^2}{e^4-1}",
    },
    rates={"e": "e"},
    zero={"e": "1"},
    minus={"e": r"\frac{1}{e}"},
    sum={"e": "ee_1"},
    nonzero=("e",),
    argument=2,
    imaginary={"e": "c+is"},
)

_SECH = r"\frac{1}{\cosh x}"
_BELOW = "1-k^2s^2s_1^2"
JACOBI = Family(
    functions={
        "sn": "s",
        "cn": "c",
        "dn": "d",
        "ns": r"\frac{1}{s}",
        "nc": r"\frac{1}{c}",
        "nd": r"\frac{1}{d}",
        "sc": r"\frac{s}{c}",
        "sd": r"\frac{s}{d}",
        "cs": r"\frac{c}{s}",
        "cd": r"\frac{c}{d}",
        "ds": r"\frac{d}{s}",
        "dc": r"\frac{d}{c}",
        "am": "a",
    },
    rates={"s": "cd", "c": "-sd", "d": "-k^2sc"},
    squares={"c": "1-s^2", "d": "1-k^2s^2"},
    integrals={"a": "d"},
    zero={"s": "0", "c": "1", "d": "1"},
    minus={"s": "-s"},
    sum={
        "s": rf"\frac{{sc_1d_1+s_1cd}}{{{_BELOW}}}",
        "c": rf"\frac{{cc_1-sds_1d_1}}{{{_BELOW}}}",
        "d": rf"\frac{{dd_1-k^2scs_1c_1}}{{{_BELOW}}}",
    },
    parameters=("k",),
    discriminant="k^2(1-k^2)",
    covers=False,
    imaginary={"s": r"\frac{is}{c}", "c": r"\frac{1}{c}", "d": r"\frac{d}{c}"},
    degenerate={
        (0,): {"s": r"\sin x", "c": r"\cos x", "d": "1"},
        **{(sign,): {"s": r"\tanh x", "c": _SECH, "d": _SECH} for sign in (1, -1)},
    },
)

# The generators are 1/℘ and its derivative: they are regular at zero, where ℘ has its pole.
_SUM = r"(2(1-\frac{g_2rr_1}{4})(r+r_1)-g_3r^2r_1^2-tt_1)"
_SUM_RATE = r"(t(2-g_2rr_1-\frac{g_2}{2}r_1^2-2g_3rr_1^2)-t_1(2-\frac{3}{2}g_2r^2-2g_3r^3))"
_DOUBLE = "(16+8g_2r^2+32g_3r^3+g_2^2r^4)"
_DOUBLE_RATE = rf"((4-3g_2r^2-4g_3r^3){_DOUBLE}-4t^2(4g_2r+24g_3r^2+g_2^2r^3))"
WEIERSTRASS = Family(
    functions={"wp": r"\frac{1}{r}", "wp'": r"-\frac{t}{r^2}", "zeta": "z", "sigma": "s"},
    rates={"r": "t", "t": r"2-\frac{3}{2}g_2r^2-2g_3r^3"},
    squares={"t": "4r-g_2r^3-g_3r^4"},
    integrals={"z": r"-\frac{1}{r}", "s": "zs"},
    zero={"r": "0", "t": "0"},
    minus={"t": "-t"},
    sum={
        "r": rf"\frac{{2(r-r_1)^2}}{{{_SUM}}}",
        "t": rf"\frac{{2(r-r_1)(2t{_SUM}-(r-r_1){_SUM_RATE})}}{{{_SUM}^2}}",
    },
    double={
        "r": rf"\frac{{16t^2}}{{{_DOUBLE}}}",
        "t": rf"\frac{{8t{_DOUBLE_RATE}}}{{{_DOUBLE}^2}}",
    },
    parameters=("g_2", "g_3"),
    discriminant="g_2^3-27g_3^2",
    covers=False,
    degenerate={(0, 0): {"r": "x^2", "t": "2x", "z": r"\frac{1}{x}", "s": "x"}},
    printed={"r": r"\frac{1}{\wp{(x)}}", "t": r"\frac{-\wp{'(x)}}{\wp{(x)}^2}"},
)

# The complete integrals, by the modulus.
LEGENDRE = Family(
    functions={"K": "p", "E": "q"},
    rates={"p": r"\frac{q-(1-x^2)p}{x(1-x^2)}", "q": r"\frac{q-p}{x}"},
    covers=False,
)

_BY_N = r"\mathrm{E}(x)+\frac{(x^2-n)\mathrm{K}(x)}{n}+\frac{(n^2-x^2)w}{n}"
THIRD_KIND = Family(
    functions={"Pi": "w"},
    rates={"w": r"\frac{x}{n-x^2}(w-\frac{\mathrm{E}(x)}{1-x^2})"},
    parameters=("n",),
    place=1,
    by={"n": {"w": rf"\frac{{{_BY_N}}}{{2(x^2-n)(n-1)}}"}},
    covers=False,
    degenerate={(0,): {"w": r"\mathrm{K}(x)"}},
)

ROTATED = {CIRCULAR: EXPONENTIAL, EXPONENTIAL: CIRCULAR, JACOBI: JACOBI}
"""By which families those at i times an argument are known, with the complementary modulus."""

FAMILIES = (CIRCULAR, EXPONENTIAL, JACOBI, WEIERSTRASS, LEGENDRE, THIRD_KIND)

DERIVATIVES = {
    "ln log": r"\frac{1}{\sqrt{x}^2}",
    "arcsin": r"\frac{1}{\sqrt{1-x^2}}",
    "arccos": r"-\frac{1}{\sqrt{1-x^2}}",
    "arctan arctg": r"\frac{1}{1+x^2}",
    "arccot arcctg": r"-\frac{1}{1+x^2}",
    "arsinh arcsinh arsh": r"\frac{1}{\sqrt{1+x^2}}",
    "arcosh arccosh arch": r"\frac{1}{\sqrt{x-1}\sqrt{x+1}}",
    "artanh arctanh arth": r"\frac{1}{\sqrt{1-x^2}^2}",
    "arcoth arccoth arcth": r"-\frac{1}{\sqrt{x^2-1}^2}",
}
"""Functions of which only the derivatives are known, by their argument x.

They are real where the roots in these are.
"""

AT_AMPLITUDE = {
    r"\mathrm{\Pi}": r"\frac{1}{1-n\operatorname{sn}^2(x,k)}",
    r"\mathrm{E}": r"\operatorname{dn}^2(x,k)",
}
"""Derivatives of incomplete integrals at the amplitude of x, as E of am(x, k) and k."""

SIGN = r"\mathrm{sign}"
"""The sign of what is not zero."""

EXTREMES = (r"\max", r"\min")
"""The largest and the smallest of some numbers."""

OF_A_MATRIX = frozenset({r"\det", r"\mathrm{tr}"})
"""The functions of a matrix: they reach over a product of matrices that stands behind them."""

_OTHERS = ("max", "min", "det", "tr Tr Sp trace", "sign sgn sg")
_MACROS = frozenset(
    """sin cos tan cot sec csc sinh cosh tanh coth arcsin arccos arctan exp ln log max min
    det""".split()
)
_SYMBOLS = frozenset(["wp", "wp'"])
_GREEK = frozenset(["zeta", "sigma", "Pi"])
_SHORT = frozenset(
    "tg ctg cotg cosec sh ch th cth sech csch arctg arcctg arsh arch arth arcth".split()
)
"""Names that authors print as macros, though LaTeX has none."""


def canonical(word: str) -> str:
    r"""How the first name of a function is read.

    >>> canonical("sin"), canonical("sn"), canonical("zeta")
    ('\\sin', '\\mathrm{sn}', '\\mathrm{\\zeta}')
    """
    word = rf"\{word}" if word in _GREEK else word
    return rf"\{word}" if word in _MACROS | _SYMBOLS else rf"\mathrm{{{word}}}"


_LINES = [name.split() for family in FAMILIES for name in family.functions]
_LINES += [line.split() for line in (*DERIVATIVES, *_OTHERS)]

LETTERS = {
    printed: canonical(word)
    for word in ("K", "E", *_GREEK)
    for printed in (rf"\{word}" if word in _GREEK else word, canonical(word))
}
"""Functions of which the names are letters, which are often those of something else.

They are read before brackets, where nothing else has this name, and are upright then: so they have
no name that is declared.
"""

_LINES = [names for names in _LINES if canonical(names[0]) not in LETTERS]

FUNCTIONS = frozenset(canonical(names[0]) for names in _LINES)
"""The functions that need no declaration: upright, with one factor behind if not with brackets."""

SPELLING = {
    printed: canonical(names[0])
    for names in _LINES
    for name in names
    for printed in [rf"\mathrm{{{name}}}", *([rf"\{name}"] if name in _SHORT | _MACROS else [])]
    if printed != canonical(names[0])
}
"""How they are read, by the other ways to print them."""

FAMILY_OF = {
    canonical(names.split()[0]): family for family in FAMILIES for names in family.functions
}
"""The family of a function."""

MEANING = {
    canonical(names.split()[0]): tex
    for family in FAMILIES
    for names, tex in family.functions.items()
}
"""A function of a family in its generators."""

DERIVATIVE_OF = {canonical(names.split()[0]): tex for names, tex in DERIVATIVES.items()}
"""The derivative of a function of which only that is known."""
