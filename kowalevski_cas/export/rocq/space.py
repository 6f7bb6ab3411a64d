"""A space of a certificate as a module of Rocq: names, definitions, the vector field."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from copy import deepcopy

from kowalevski_cas.export.format import Inexpressible, Json
from kowalevski_cas.export.rocq.elements import Elements, Term, written
from kowalevski_cas.export.rocq.terms import Terms
from kowalevski_cas.proof import checker
from kowalevski_cas.proof.trees import Tree

Element = checker.Element
Sides = tuple[str, str]


class Space(Terms):
    """A space of a certificate, and its definitions in a module ``Space_k``.

    ``divisors`` has everything by which its formulas divide, as it is written inside of
    the module and outside.
    """

    def __init__(self, data: Json, k: int, spaces: Sequence[Space]) -> None:
        super().__init__()
        self.data, self.k, self.spaces = data, k, spaces
        checked: list[checker.Space] = [space.checked for space in spaces]
        self.checked: checker.Space = checker.Space(checked, **deepcopy(data))
        self.elements = Elements(self.checked)
        self.steps = data.get("steps", [])
        self.squares: dict[str, Tree] = {s[1]: s[2] for s in self.steps if s[0] == "root"}
        self.names: list[str] = self.checked.names
        self.divisors: dict[str, tuple[str, Element]] = {}
        self.images: dict[str, checker.Elements] = {}
        self.applied: set[str] = set()
        self._lines: list[str] = []
        for place, name in enumerate(self.names):
            self.define(self.new_word(name), f"Var {place}")
        for kind, name, tree in self.steps:
            if kind == "let":
                shown, wide = self.say(tree), self.is_vector(tree)
                self.wide |= {name} if wide else set()
                self.define(self.new_word(name), shown, "vec" if wide else "expr")
            elif kind == "root":
                self._note(tree)
        if self.checked.rates:
            self.define("D", self.motion(self.checked.rates), "expr -> expr")
        self._image("bar", {name: self.checked.bar[name] for name in self.names})
        self.define("conjugate", "subst bar", "expr -> expr")
        for tree in self.checked.nonzero:
            self._note(tree)
        if "change" in data:
            self.applied.add("bar")
            back = [self.term(name) for name in self.old.names]
            self.define("back", f"each [{'; '.join(back)}]", "nat -> expr")

    @property
    def old(self) -> Space:
        """The space with the variables before the change."""
        place: int = self.data["change"]["old"]
        return self.spaces[place]

    def module(self) -> str:
        """The text of the module."""
        body = "\n".join(f"  {line}" for line in self._lines)
        return f"Module Space_{self.k}.\n{body}\nEnd Space_{self.k}.\n"

    def define(self, word: str, term: str, kind: str = "expr") -> None:
        """Add a definition to the module."""
        line = f"Definition {word} : {kind} := {term}."
        if line not in self._lines:
            self._lines.append(line)

    def say(self, tree: Tree) -> str:
        """A tree as an expression; what it divides by is noted."""
        self._note(tree)
        return self.term(tree)

    def parts(self, tree: Tree) -> list[str]:
        """The components of a tree as expressions; what it divides by is noted."""
        self._note(tree)
        return self.components(tree)

    def sides(self, equations: Iterable[Sequence[Tree]]) -> list[Sides]:
        """Both sides of equations, component by component; what they divide by is noted."""
        pairs = [zip(self.parts(left), self.parts(right), strict=True) for left, right in equations]
        return [sides for pair in pairs for sides in pair]

    def outside(self, tree: Tree) -> str:
        """A tree as an expression outside of the module; what it divides by is noted."""
        self._note(tree)
        return self.term(tree, f"Space_{self.k}.")

    def root(self, tree: Tree) -> str:
        found = self.checked.unary("sqrt", self.checked.scalar(tree))
        (name,) = (n for n in self.squares if found.terms == self.checked.generator(n).terms)
        return str(name)

    def partial(self, name: str) -> str:
        word = f"d_{self.words[name]}"
        self.define(word, self.motion({name: self.checked.number(1)}), "expr -> expr")
        return word

    def motion(self, rates: checker.Elements) -> str:
        """The derivative when some names have rates; those of roots follow.

        Raises:
            Inexpressible: a root moves that may be zero.
        """
        every = []
        for name in self.names:
            try:
                every.append(self.polynomial(self.checked.generator(name).along(rates)))
            except checker.Rejected:
                reason = f"the derivative of the root {name} is divided by it, and it may be zero"
                raise Inexpressible(reason) from None
        return f"along (each [{'; '.join(every)}])"

    def polynomial(self, element: Element) -> str:
        """An element as an expression; what it divides by is noted."""
        return self.say(written(self.elements.terms(element)))

    def flip(self, name: str) -> str:
        """The word for the change of sign of a root."""
        word = f"flip_{self.words[name]}"
        self.applied.add(word)
        images = {n: self.checked.generator(n) for n in self.names}
        self._image(word, images | {name: self.checked.number(-1) * images[name]})
        return word

    def _image(self, word: str, images: checker.Elements) -> None:
        """Define other expressions for the names."""
        shown = [self.polynomial(images[name]) for name in self.names]
        self.define(word, f"each [{'; '.join(shown)}]", "nat -> expr")
        with suppress(checker.Rejected):  # not all that is divided by need have an image
            self.images[word] = self.checked.carried(dict(images), self.checked)

    def inverses(self) -> Iterator[tuple[str, list[Term]]]:
        """Divisors as expressions, with their inverses; each may rest on those before it."""
        own = [(text, divisor) for text, (_, divisor) in self.divisors.items()]
        yield from ((text, self.elements.inverse(divisor)) for text, divisor in own)
        needed = [word for word in self.images if word in self.applied]
        carried = [(f"subst {word}", self.images[word], own) for word in needed]
        if "change" in self.data:
            images = {name: self.checked.scalar(name) for name in self.old.names}
            images = self.old.checked.carried(images, self.checked)
            carried.append(("subst back", images, list(self.old.divisors.values())))
        for head, images, divisors in carried:
            for text, divisor in divisors:
                if divisor.terms.keys() != {0}:
                    with suppress(checker.Rejected):  # not all of them are divided by again
                        image = divisor.image(images, self.checked)
                        yield f"{head} ({text})", self.elements.inverse(image)

    def divisors_in(self, tree: Tree) -> set[str]:
        """What a tree divides by, also in the definitions of its names."""
        if isinstance(tree, str):
            let = next((s[2] for s in self.steps if s[:2] == ["let", tree]), None)
            return self.divisors_in(let) if let is not None else set()
        parts = tree[1:] if isinstance(tree, list) else []
        found = {text for part in parts for text in self.divisors_in(part)}
        under = parts[1:] if isinstance(tree, list) and tree[0] == "/" else []
        return found | {text for part in under for text in self.components(part)}

    def _note(self, tree: Tree) -> None:
        """Note the divisors in a tree, inner ones first."""
        if not isinstance(tree, list):
            return
        if tree[0] == "conj":
            self.applied.add("bar")
        for part in tree[1:]:
            self._note(part)
        for part in tree[2:] if tree[0] == "/" else ():
            shown = self.components(part), self.components(part, f"Space_{self.k}.")
            for text, outside, value in zip(*shown, self.checked.value(part), strict=True):
                self.divisors.setdefault(text, (outside, value))
