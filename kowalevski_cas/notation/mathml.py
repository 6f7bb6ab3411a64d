"""Formula to MathML Core, which browsers set and screen readers read."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from html import escape

from kowalevski_cas.notation.brackets import is_unmarked
from kowalevski_cas.notation.decorations import ACCENTS, RATES, raised_sign
from kowalevski_cas.notation.formula import Conjugate, Formula, Name, Number
from kowalevski_cas.notation.printer import Printer
from kowalevski_cas.notation.unicode import SIGNS, glyphs, styled_letter

_DOTS = {1: "˙", 2: "¨", 3: "⃛", 4: "⃜"}
_ATOM = re.compile(r"<(m[ion])>[^<]*</\1>")
_TALL = re.compile("<m(frac|table|underover)")
_PRIMES = '<mo lspace="0" rspace="0">{}</mo>'
_AS_IT_IS = ' stretchy="false"'


class MathML(Printer):
    """Each part is a run of elements; brackets grow with fractions and matrices."""

    plus, minus, times, cross = (f"<mo>{sign}</mo>" for sign in "+−·×")
    d, partial_d, dots, const = (f"<mi>{text}</mi>" for text in ("d", "∂", "…", "const"))
    prime = "′"
    word_form, root_form = "<mi>{}</mi>", "<msqrt>{}</msqrt>"
    radical_form = "<mroot><mrow>{1}</mrow><mn>{0}</mn></mroot>"
    change_forms = ('<mrow class="meant">{}</mrow>', '<mrow class="slip">{}</mrow>')
    comma, thin = "<mo>,</mo>", '<mspace width="0.17em"></mspace>'
    round, square, braces, bars = (
        (f"<mo{_AS_IT_IS}>{left}</mo>", f"<mo{_AS_IT_IS}>{right}</mo>")
        for left, right in ("()", "[]", "{}", "||")
    )

    def begins_with_number(self, text: str) -> bool:
        return text.startswith("<mn>")

    def number(self, formula: Number) -> str:
        return f"<mn>{formula.value}</mn>"

    def name(self, formula: Name) -> str:
        return self._name(formula)

    def _name(self, formula: Name, dots: int = 0, primes: str = "") -> str:
        """A letter under dots, with primes and its index."""
        parts = glyphs(formula.name)
        upright = parts.font == r"\mathrm" and len(parts.letter) == 1
        letter = escape(styled_letter(parts.letter, parts.font))
        text = f'<mi mathvariant="normal">{letter}</mi>' if upright else f"<mi>{letter}</mi>"
        for accent in reversed(parts.accents):
            sign = (ACCENTS | RATES)[accent].mathml
            text = _over(text, sign) if sign else _under(text)
        while dots:
            text = _over(text, _DOTS[min(dots, 4)])
            dots -= min(dots, 4)
        primes = primes or (parts.primes and _PRIMES.format(parts.primes))
        index = "".join(map(_atom, parts.indices))
        sign = f"<mo>{raised_sign(parts.raised).shown}</mo>" if parts.raised else ""
        if index and primes:
            primes = f'<mpadded width="0">{primes}</mpadded>'
        text += primes
        if parts.raised and index:
            return f"<msubsup>{_one(text)}{_one(index)}{sign}</msubsup>"
        if parts.raised:
            return f"<msup>{_one(text)}{sign}</msup>"
        return f"<msub>{_one(text)}{_one(index)}</msub>" if index else text

    def sign(self, sign: str) -> str:
        return f"<mo>{escape(SIGNS[sign])}</mo>"

    def prefix(self, sign: str) -> str:
        # By itself a browser takes only the first sign of a row for one.
        return sign.replace("<mo>", '<mo form="prefix">')

    def side_by_side(self, parts: Iterable[str]) -> str:
        return "".join(parts)

    def is_round(self, text: str) -> bool:
        return ">(</mo>" in text and ">[</mo>" not in text

    def between(self, opening: str, text: str, closing: str) -> str:
        if _TALL.search(text):
            opening, closing = grow_bracket(opening), grow_bracket(closing)
        return f"<mrow>{opening}{text}{closing}</mrow>"

    def fraction(self, above: str, below: str) -> str:
        return f"<mfrac>{_one(above)}{_one(below)}</mfrac>"

    def superscript(self, base: str, exponent: str) -> str:
        """A power; it stands above an index, and at the height of the bracket before it."""
        if base.startswith("<msub>") and base.find("</msub>") == len(base) - len("</msub>"):
            inner = base.removeprefix("<msub>").removesuffix("</msub>")
            return f"<msubsup>{inner}{_one(exponent)}</msubsup>"
        if base.startswith(f"<mrow><mo{_AS_IT_IS}>"):
            inner, bracket = base.removesuffix("</mrow>").rsplit("<mo", 1)
            return f"{inner}<msup><mo{bracket}{_one(exponent)}</msup></mrow>"
        return f"<msup>{_one(base)}{_one(exponent)}</msup>"

    def with_primes(self, argument: Formula, order: int) -> str:
        """Primes as letters above the index, which has no room for them: fonts raise them."""
        primes = _PRIMES.format(self.prime * order)
        if isinstance(argument, Name) and is_unmarked(argument):
            return self._name(argument, primes=primes)
        return self.enclose(argument) + primes

    def conjugate(self, formula: Conjugate) -> str:
        """An accent over a letter, a border over all else: no browser stretches a bar."""
        text = self(formula.argument)
        return _over(text, "¯") if _ATOM.fullmatch(text) else f'<mrow class="bar">{text}</mrow>'

    def with_dots(self, argument: Formula, order: int) -> str:
        if isinstance(argument, Name):
            return self._name(argument, order)
        return _over(self.enclose(argument), _DOTS[min(order, 4)])

    def over(self, index: str, first: str, last: str) -> str:
        below = f"<mrow>{index}<mo>=</mo>{first}</mrow>"
        return f"<munderover><mo>∑</mo>{below}{_one(last)}</munderover>"

    def rows(self, rows: Sequence[Sequence[str]]) -> str:
        cells = "".join(f"<mtr><mtd>{'</mtd><mtd>'.join(row)}</mtd></mtr>" for row in rows)
        return self.between(self.round[0], f"<mtable>{cells}</mtable>", self.round[1])


def grow_bracket(bracket: str) -> str:
    """A bracket that grows with what stands beside it; below a power it is tall by itself."""
    return bracket.replace(_AS_IT_IS, ' minsize="2.4em"' if "<msup>" in bracket else "", 1)


def _under(text: str) -> str:
    return f'<munder accentunder="true">{_one(text)}<mo>_</mo></munder>'


def _over(text: str, accent: str) -> str:
    return f'<mover accent="true">{_one(text)}<mo>{accent}</mo></mover>'


def _atom(text: str) -> str:
    return f"<mn>{text}</mn>" if text.isdigit() else f"<mi>{escape(text)}</mi>"


def _one(text: str) -> str:
    """The text as one element, where the place has room for one only."""
    return text if _ATOM.fullmatch(text) else f"<mrow>{text}</mrow>"


MATHML = MathML()


def to_mathml(formula: Formula) -> str:
    r"""The formula in MathML, without the element ``math`` around it.

    >>> from kowalevski_cas.notation import Name, Number, Quotient
    >>> to_mathml(Quotient(Name(r"\omega_1"), Number(2)))
    '<mfrac><mrow><msub><mi>ω</mi><mn>1</mn></msub></mrow><mn>2</mn></mfrac>'
    """
    return MATHML(formula)
