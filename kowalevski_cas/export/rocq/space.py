"""A space of a certificate as a module of Rocq: names, definitions, the vector field."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from copy import copy

from kowalevski_cas.export.rocq.elements import Elements, Term, sum_text
from kowalevski_cas.export.rocq.terms import Terms
from kowalevski_cas.problem import checker
from kowalevski_cas.problem.checker import Element
from kowalevski_cas.problem.trees import Tree

Sides = tuple[str, str]


class Space(Terms):
    """A space of a certificate, and its definitions in a module ``Space_k``.

    ``checked`` is the checker's space, in which the conditions are entered; ``divisors`` has
    everything by which the formulas divide, as it is written inside of the module and outside,
    with its value.
    """

    def __init__(self, checked: checker.Space, k: int, spaces: Sequence[Space]) -> None:
        super().__init__()
        self.checked, self.data, self.k, self.label = _apart(checked), checked.data, k, f"{k}"
        steps = self.data.get("steps", [])
        self.lets: dict[str, Tree] = {s[1]: s[2] for s in steps if s[0] == "let"}
        self.squares: dict[str, Tree] = {s[1]: s[2] for s in steps if s[0] == "root"}
        self.bases: dict[str, Tree] = {s[1]: s[2] for s in steps if s[0] == "power"}
        self.names = [*checked.bar]
        self.divisors: dict[str, tuple[str, Element]] = {}
        self.values: Mapping[str, Tree] = {}
        self.conjugated = "change" in self.data
        self._lines: dict[str, str] = {}
        for place, name in enumerate(self.names):
            self.define(self.new_word(name), f"Var {place}")
        for kind, name, tree, *_ in steps:
            if kind == "let":
                shown, wide = self.say(tree), self.is_vector(tree)
                self.wide |= {name} if wide else set()
                self.define(self.new_word(name), shown, "vec" if wide else "expr")
            else:
                self._note(tree)
        if checked.rates is not None:
            self.define("D", self.motion(dict(checked.rates)), "expr -> expr")
        images = [self.polynomial(image) for image in checked.bar.values()]
        self.define("bar", f"each [{'; '.join(images)}]", "nat -> expr")
        self.define("conjugate", "subst bar", "expr -> expr")
        if "change" in self.data:
            self.old = spaces[self.data["change"]["old"]]
            back = [self.term(name) for name in self.old.names]
            self.define("back", f"each [{'; '.join(back)}]", "nat -> expr")

    def local(self, checked: checker.Space, label: str, values: Mapping[str, Tree]) -> Space:
        """The same with the conditions of one goal, and with values for bound names."""
        other = copy(self)
        other.checked, other.label, other.values = _apart(checked), label, values
        other.divisors = dict(self.divisors)
        return other

    def module(self) -> str:
        """The text of the module."""
        body = "\n".join(f"  {line}" for line in self._lines.values())
        return f"Module Space_{self.k}.\n{body}\nEnd Space_{self.k}.\n"

    def define(self, word: str, term: str, kind: str = "expr") -> str:
        """Add a definition to the module; the word may be longer if it has another meaning."""
        while self._lines.get(word, line := f"Definition {word} : {kind} := {term}.") != line:
            word += "_"
        self._lines[word] = line
        return word

    # -- formulas ------------------------------------------------------------------

    def say(self, tree: Tree) -> str:
        """A tree as an expression; what it divides by is noted."""
        tree = _put(tree, self.values)
        self._note(tree)
        return self.term(tree)

    def parts(self, tree: Tree) -> list[str]:
        """The components of a tree as expressions; what it divides by is noted."""
        tree = _put(tree, self.values)
        self._note(tree)
        return self.components(tree)

    def value(self, tree: Tree) -> checker.Value:
        """The components of the value of a tree."""
        return self.checked.value(_put(tree, self.values))

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
        return next(n for n in self.squares if found.terms == self.checked.bar[n].terms)

    def partial(self, name: str) -> str:
        number = self.checked.ring.number
        fixed = dict.fromkeys((*self.checked.variables, *self.checked.constants), number(0))
        motion = self.motion(fixed | {name: number(1)})
        return self.define(f"d_{self.words[name]}", motion, "expr -> expr")

    def motion(self, rates: checker.Rates) -> str:
        """The derivative when some names have rates; those of roots and powers follow."""
        generators = (self.checked.ring.generator(name) for name in self.names)
        every = [self.polynomial(self.checked.along(own, rates)) for own in generators]
        return f"along (each [{'; '.join(every)}])"

    def polynomial(self, element: Element) -> str:
        """An element as an expression; what it divides by is noted."""
        return self.say(sum_text(self.elements.terms(element)))

    # -- conditions ----------------------------------------------------------------

    @property
    def elements(self) -> Elements:
        """How elements are written under the conditions, and those on their conjugates."""
        mirror = self.checked.mirror
        known = self.checked.known | (mirror.space.known if mirror else {})
        return Elements(self.checked.ring, known)

    def conditions(self) -> list[str]:
        """What does not vanish."""
        elements = self.elements
        return [self.term(sum_text(elements.terms(divisor))) for divisor in elements.conditions]

    def inverses(self) -> dict[str, list[Term]]:
        """Divisors as expressions, with their inverses; each may rest on those before it."""
        found, checked = self._own_inverses(), self.checked
        if self.conjugated:
            bars = {t: checked.conj(e) for t, e in found.items() if e.value() is None}
            found |= {f"subst bar ({text})": inverse for text, inverse in bars.items()}
        if "change" in self.data:
            names = {name: checked.scalar(name) for name in self.old.names}
            here = checked.carried(self.old.checked.ring, names)
            for text, inverse in self.old._own_inverses(outside=True).items():
                if inverse.value() is None:
                    with suppress(checker.Rejected):
                        found[f"subst back ({text})"] = here(inverse)
        elements = self.elements
        return {text: elements.terms(inverse) for text, inverse in found.items()}

    def _own_inverses(self, outside: bool = False) -> dict[str, Element]:
        """One over what was noted; some of it belongs to other goals, and may be zero here."""
        found = dict[str, Element]()
        with self.checked.statement(False):
            for text, (shown, divisor) in self.divisors.items():
                with suppress(checker.Rejected):
                    found[shown if outside else text] = self.checked.inverse(divisor)
        return found

    def divisors_in(self, tree: Tree) -> set[str]:
        """What a tree divides by, also in the definitions of its names."""
        if isinstance(tree, str):
            return self.divisors_in(self.lets.get(tree, 0))
        parts = tree[1:] if isinstance(tree, list) else []
        found = {text for part in parts for text in self.divisors_in(part)}
        under = parts[1:] if isinstance(tree, list) and tree[0] == "/" else []
        return found | {text for part in under for text in self.components(part)}

    def _note(self, tree: Tree) -> None:
        """Note the divisors in a tree, inner ones first."""
        if not isinstance(tree, list):
            return
        self.conjugated = self.conjugated or tree[0] == "conj"
        for part in tree[1:]:
            self._note(part)
        for part in tree[2:] if tree[0] == "/" else ():
            self.checked.over(part)
            shown = self.components(part), self.components(part, f"Space_{self.k}.")
            for text, outside, value in zip(*shown, self.checked.value(part), strict=True):
                self.divisors.setdefault(text, (outside, value))


def _apart(checked: checker.Space) -> checker.Space:
    """A copy that learns the conditions of a statement."""
    space = checked.local()
    space.stating, space.mirror = True, None
    return space


def _put(tree: Tree, values: Mapping[str, Tree]) -> Tree:
    """A formula with values for some names."""
    if isinstance(tree, list):
        return [tree[0], *(_put(part, values) for part in tree[1:])]
    return values.get(tree, tree) if isinstance(tree, str) else tree
