"""Spaces of the checker over rings that write down how their elements are computed."""

from __future__ import annotations

from typing import cast

from kowalevski_cas.export.format import identifier
from kowalevski_cas.export.polynomials.trace import Element, Traced, plain
from kowalevski_cas.problem import checker


class Space(checker.Space):
    """A space: definitions have names, and each inverse is tested."""

    ring: Traced

    def step(
        self, kind: checker.Json, name: checker.Json, tree: checker.Json, more: checker.Json = None
    ) -> None:
        super().step(kind, name, tree, more)
        if kind == "let":
            wish = f"{self.ring.prefix}_{identifier(name)}"
            self.env[name] = tuple(Element(e, self.ring.name_for(e, wish)) for e in self.env[name])

    def unary(self, op: str, element: checker.Element) -> checker.Element:
        trusting, self.ring.trusting = self.ring.trusting, False  # which root it is is a question
        try:
            return super().unary(op, element)
        finally:
            self.ring.trusting = trusting

    def derivative(self, element: checker.Element) -> checker.Element:
        """The derivative with a text: what stands in a goal is for the program to compare."""
        return self.ring.text_of(super().derivative(element))

    def inverse(self, element: checker.Element, words: str = "") -> checker.Element:
        found = plain(super().inverse(plain(element), words))
        self.ring.enter_divisors()
        inverse = Element(found, self.ring.name_for(found))
        product = self.ring.text_of(element) * inverse
        self.ring.vanishes("inverse", product - self.ring.number(1))
        return inverse

    def carried(self, ring: checker.Ring, images: dict[str, checker.Element]) -> checker.Map:
        return Carried(ring, images, self)


class Carried(checker.Map):
    """A map that the program applies by itself."""

    _images: dict[str, str] | None = None
    _function = ""

    def __call__(self, element: checker.Element) -> checker.Element:
        image = super().__call__(element)
        source, target = cast(Traced, self.ring), cast(Traced, self.space.ring)
        for name, own in self.images.items():
            self.images[name] = Element(own, target.name_for(own))
        images = {source.texts[name]: target.name_for(own) for name, own in self.images.items()}
        if images != self._images:
            self._images, self._function = images, target.writer.substitution(images)
        named = source.writer.define(source.text_of(element).text)
        return Element(image, f"{self._function}({named})")
