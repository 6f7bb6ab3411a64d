"""Formula to the mathematics of Typst."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from kowalevski_cas.notation.brackets import is_unmarked
from kowalevski_cas.notation.decorations import ACCENTS, RATES
from kowalevski_cas.notation.formula import Application, Formula, Name
from kowalevski_cas.notation.printer import Printer
from kowalevski_cas.notation.unicode import glyphs

_FONTS = {
    r"\mathbf": "upright(bold({}))", r"\boldsymbol": "bold({})", r"\mathrm": "upright({})",
    r"\mathcal": "cal({})", r"\mathbb": "bb({})", r"\mathfrak": "frak({})", r"\mathsf": "sans({})",
    r"\mathscr": "scr({})",
}  # fmt: skip
# Brackets that group and are not printed; they become round ones when all is printed, so that
# until then a round bracket is one that stands on the paper.
_GROUPING, _PRINTED = str.maketrans("()", "⟮⟯"), str.maketrans("⟮⟯", "()")
_DOTS = {1: "dot", 2: "dot.double", 3: "dot.triple", 4: "dot.quad"}


class Typst(Printer):
    """Parts are set apart by spaces, which Typst does not print; brackets grow by themselves."""

    minus, times, cross, prime, partial_d = "-", "⋅ ", "×", "'", "∂"
    dots, const, braces = "…", 'upright("const")', ("{", "}")
    bars, thin = ("abs⟮", "⟯"), "thin "
    word_form, fraction_form, root_form = 'op⟮"{}"⟯', "frac⟮{}, {}⟯", "sqrt⟮{}⟯"
    radical_form = "root⟮{}, {}⟯"
    bar_form, sum_form = "overline⟮{}⟯", "sum_⟮{} = {}⟯^⟮{}⟯"
    change_forms = ("meant⟮{}⟯", "slip⟮{}⟯")

    def finish(self, text: str) -> str:
        return text.translate(_PRINTED)

    def name(self, formula: Name) -> str:
        return self._name(formula, "{}")

    def _name(self, formula: Name, accent: str) -> str:
        parts = glyphs(formula.name)
        letter = _atom(parts.letter)
        if parts.font:
            letter = _FONTS[parts.font].format(letter)
        for mark in reversed(parts.accents):
            letter = (ACCENTS | RATES)[mark].typst.format(letter)
        index = f"_({' '.join(map(_atom, parts.indices))})" if parts.indices else ""
        raised = f"^({parts.raised})" if parts.raised else ""
        primes = self.prime * len(parts.primes)
        return (accent.format(letter) + primes + index + raised).translate(_GROUPING)

    def side_by_side(self, parts: Iterable[str]) -> str:
        return " ".join(parts)

    def application(self, formula: Application) -> str:
        # Between a word and its argument Typst would print the space.
        return self(Name(formula.function)) + self.comma_list(formula.arguments)

    def superscript(self, base: str, exponent: str) -> str:
        return f"{base}^⟮{exponent}⟯"

    def with_primes(self, argument: Formula, order: int) -> str:
        """Primes; those of a name stand before its index, or they would be a part of that."""
        if isinstance(argument, Name) and is_unmarked(argument):
            return self._name(argument, "{}" + self.prime * order)
        return super().with_primes(argument, order)

    def with_dots(self, argument: Formula, order: int) -> str:
        accent = "{}"
        while order:
            accent = f"{_DOTS[min(order, 4)]}({accent})"
            order -= min(order, 4)
        if isinstance(argument, Name):
            return self._name(argument, accent)
        return accent.translate(_GROUPING).format(self.enclose(argument))

    def rows(self, rows: Sequence[Sequence[str]]) -> str:
        return f"mat⟮{'; '.join(map(', '.join, rows))}⟯"


def _atom(text: str) -> str:
    """A letter or number as it is, a word in quotes."""
    return text if len(text) == 1 else f'"{text}"'


TYPST = Typst()


def to_typst(formula: Formula) -> str:
    r"""The formula in the mathematics of Typst, without dollar signs.

    >>> from kowalevski_cas.notation import Name, Quotient, Root
    >>> to_typst(Quotient(Name(r"\omega_1"), Root(Name("x"))))
    'frac(ω_(1), sqrt(x))'
    """
    return TYPST.finish(TYPST(formula))
