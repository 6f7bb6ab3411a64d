"""Rings and elements of the checker that write down how they are computed."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from itertools import count

from kowalevski_cas.export.format import identifier
from kowalevski_cas.export.polynomials.language import Language
from kowalevski_cas.problem import checker

LENGTH = 80
"""An expression with more characters has a name of its own."""


class Writer:
    """The lines of a program, and the generators of the one ring in which they are meant."""

    def __init__(self, language: Language) -> None:
        self.language = language
        self.plain: list[str] = []
        self.roots: list[str] = []
        self._lines: list[str | Callable[[], str]] = []
        self._names: set[str] = set()
        self.rings, self._checks = count(), count(1)

    @property
    def generators(self) -> list[str]:
        """All generators, roots last: a square may have all the others, and earlier roots."""
        return [*self.plain, *self.roots]

    @property
    def text(self) -> str:
        """The whole file."""
        lines = (line if isinstance(line, str) else line() for line in self._lines)
        return self.language.frame(self.generators, "\n".join(lines))

    def fresh(self, wish: str) -> str:
        """A name that is not taken, as near to the wish as can be."""
        while wish in self._names:
            wish += "_"
        self._names.add(wish)
        return wish

    def say(self, line: str) -> None:
        """Write a line."""
        self._lines.append(line)

    def comment(self, words: str) -> None:
        """Write words for a reader."""
        self.say(self.language.comment.format(words))

    def define(self, text: str, wish: str = "") -> str:
        """A name for an expression."""
        name = self.fresh(wish or f"t{len(self._lines)}")
        self.say(self.language.define.format(name, text))
        return name

    def holds(self, words: str, text: str, divisors: str) -> None:
        """Ask whether an expression vanishes wherever the divisors do not."""
        said = f"{next(self._checks)} {words}"
        self.say(self.language.holds.format(said, text, divisors))

    def substitution(self, images: Mapping[str, str]) -> str:
        """The name of a map of generators to expressions; the other generators stay."""
        name = self.fresh(f"m{len(self._lines)}")
        # A language may have to name all generators, and they are not all known yet.
        self._lines.append(lambda: self.language.substitution(name, images, self.generators))
        return name


class Traced(checker.Ring):
    """A ring whose elements know how the program writes them."""

    def __init__(self, writer: Writer, budget: checker.Budget) -> None:
        super().__init__(budget)
        self.trusting = False
        self.writer = writer
        self.prefix = f"s{next(writer.rings)}"
        self.texts: dict[str, str] = {}
        self.over: dict[str, str] = {}  # generators, and what they are the inverses of
        self.below = self._divisors()

    def another(self) -> Traced:
        return Traced(self.writer, self.budget)

    def adjoin(self, name: str) -> checker.Element:
        wish = name.replace("1/", "over_") if name.startswith("1/") else identifier(name)
        self.texts[name] = self.writer.fresh(f"{self.prefix}_{wish}")
        self.writer.plain.append(self.texts[name])
        return super().adjoin(name)

    def relate(self, name: str, square: checker.Element) -> None:
        super().relate(name, square)
        own = self.texts[name]
        self.writer.plain.remove(own)
        self.writer.roots.append(own)
        shown = self.name_for(square, f"{own}_squared")
        self.writer.say(self.writer.language.relation.format(own, shown))

    def _divisors(self) -> str:
        name = self.writer.fresh(f"{self.prefix}_divisors")
        language = self.writer.language
        pairs = ", ".join(language.pair.format(*both) for both in self.over.items())
        self.writer.say(language.divisors.format(name, pairs))
        return name

    def enter_divisors(self) -> None:
        """Tell the program of divisors that are new."""
        new = [name for name in self.divisors if self.texts[name] not in self.over]
        for name in new:
            own = self.texts[name]
            self.over[own] = self.name_for(self.divisors[name], f"{own}_below")
        if new:
            self.below = self._divisors()

    def generator(self, name: str) -> Element:
        return Element(super().generator(name), self.texts[name])

    def number(self, value: int | Fraction) -> Element:
        text = self.writer.language.number(Fraction(value))
        return Element(super().number(value), text)

    def combination(
        self, parts: list[tuple[int, checker.Element]], below: int = 1
    ) -> checker.Element:
        value = super().combination(parts, below)
        texts = [f"(-{e.text})" if c < 0 else e.text for c, e in parts if isinstance(e, Element)]
        if not parts:
            return self.number(0)
        known = len(texts) == len(parts) and below == 1 and all(abs(c) == 1 for c, _ in parts)
        return Element(value, f"({'+'.join(texts)})") if known else plain(value)

    def product(self, elements: Iterable[checker.Element]) -> checker.Element:
        found = [*elements]
        if not found:
            return self.number(1)
        value, texts = super().product(found), [e.text for e in found if isinstance(e, Element)]
        return Element(value, f"({'*'.join(texts)})") if len(texts) == len(found) else plain(value)

    def text_of(self, element: checker.Element) -> Element:
        """An element with its text: as it was computed, or as a polynomial."""
        if isinstance(element, Element):
            return element
        summands, under = [], self.exponents(element.under)
        for m, c in sorted(element.terms.items(), reverse=True):
            powers = [(self.texts[name], e) for name, e in (*self.exponents(m), *under)]
            factors = [f"{text}^{e}" if e > 1 else text for text, e in powers]
            number = self.writer.language.number(Fraction(c, element.below))
            summands.append("*".join([number, *factors]))
        text = "+".join(summands) or self.writer.language.number(Fraction(0))
        return Element(element, f"({text})")

    def name_for(self, element: checker.Element, wish: str = "") -> str:
        """A name for an element."""
        text = self.text_of(element).text
        return text if text.isidentifier() and not wish else self.writer.define(text, wish)

    def vanishes(self, words: str, element: checker.Element) -> None:
        """Ask the program whether an element vanishes wherever the divisors do not."""
        self.writer.holds(words, self.text_of(element).text, self.below)


def plain(element: checker.Element) -> checker.Element:
    """The element without a text."""
    return element.with_terms(element.terms)


class Element(checker.Element):
    """An element, and how the program writes it.

    What it is decides which lines are written, never whether they hold.
    """

    __slots__ = ("text",)
    ring: Traced

    def __init__(self, element: checker.Element, text: str) -> None:
        super().__init__(element.ring, element.terms, element.below, element.bits, element.under)
        self.text = text if len(text) < LENGTH else self.ring.writer.define(text)

    def __neg__(self) -> checker.Element:
        return Element(super().__neg__(), f"(-{self.text})")

    def __mul__(self, other: checker.Element) -> checker.Element:
        return self.ring.product([self, other])

    def __pow__(self, exponent: int) -> checker.Element:
        return Element(super().__pow__(exponent), f"({self.text}^{exponent})")

    def partial(self, name: str) -> checker.Element:
        words, own = self.ring.writer.language.derivative, self.ring.name_for(self)
        return Element(super().partial(name), words.format(own, self.ring.texts[name]))

    def split(self, name: str) -> dict[int, checker.Element]:
        own = self.ring.generator(name)
        parts = {e: self.ring.text_of(part) for e, part in plain(self).split(name).items()}
        whole = self.ring.total(part * own**e for e, part in parts.items())
        self.ring.vanishes("coefficients", self - whole)
        return {**parts}

    def vanishes(self) -> bool:
        if not (self.ring.trusting or plain(self).vanishes()):
            return False
        self.ring.vanishes("equal", self)
        return True

    def differs(self) -> bool:
        other, norm = plain(self).normed()
        if not (number := norm.value()):
            return False
        inverse = self.ring.text_of(plain(other * self.ring.number(1 / number)))
        self.ring.vanishes("different", self * inverse - self.ring.number(1))
        return True

    def value(self) -> Fraction | None:
        found = super().value()
        if found is not None and self.text != (number := self.ring.number(found)).text:
            self.ring.vanishes("a number", self - number)
        return found
