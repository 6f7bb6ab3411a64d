"""A space of a certificate in the words of a program: names, relations, rates and maps."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from copy import deepcopy
from fractions import Fraction
from functools import reduce
from itertools import count

from kowalevski_cas.export.format import Json, identifier
from kowalevski_cas.export.polynomials.writer import Value, Writer
from kowalevski_cas.proof import checker
from kowalevski_cas.proof.trees import Tree

Values = tuple[Value, ...]
Rates = dict[str, Value]
Map = Callable[[Value], Value]


class Space:
    """It writes what defines the space, and evaluates formulas on it."""

    def __init__(
        self, writer: Writer, prefix: str, data: Json, earlier: Sequence[Space] = ()
    ) -> None:
        self.writer, self.earlier = writer, earlier
        self.prefix = prefix
        self.checked: checker.Space = checker.Space(
            [space.checked for space in earlier], **deepcopy(data)
        )
        self.at: dict[str, str] = {}
        for name in self.checked.at:
            shown = f"over_{name[2:]}" if name in self.checked.divisors else identifier(name)
            self.at[name] = writer.fresh(f"{prefix}_{shown}")
        writer.generators += self.at.values()
        plain = [*data["variables"], *data.get("constants", [])]
        self.env: dict[str, Values] = {name: (self.generator(name),) for name in plain}
        self.divisors = self._divisors([])
        self.over = [
            (name, self.writer.named(self.scalar(tree), f"{self.at[name]}_below"))
            for name, tree in zip(self.checked.divisors, self.checked.nonzero, strict=True)
        ]
        if self.over:
            self.divisors = self._divisors([(self.at[n], below.text) for n, below in self.over])
        self.squares: dict[str, Value] = {}
        for kind, name, tree in data.get("steps", []):
            self._step(kind, name, tree)
        self.rates: Rates = {}
        self.old: list[Value] = []
        if "change" in data:
            self._change(**data["change"])
        for names, factor, right in data.get("field", []):
            rows = zip(names, self.value(factor), self.value(right), strict=True)
            self.rates |= {name: above * self.inverse(below) for name, below, above in rows}
        self._settle()
        self._pairs = data.get("conjugates", [])
        self._bar: Map | None = None

    # -- what defines the space ----------------------------------------------------

    def _divisors(self, pairs: Sequence[tuple[str, str]]) -> str:
        """A name for generators with the expressions whose inverses they are."""
        name = self.writer.fresh(f"{self.prefix}_divisors")
        self.writer.say(self.writer.language.divisors(name, pairs))
        return name

    def _step(self, kind: str, name: Tree, tree: Tree) -> None:
        if kind == "root":
            self.squares[name] = self.writer.named(self.scalar(tree), f"{self.at[name]}_squared")
            self.writer.say(self.writer.language.relation(self.at[name], self.squares[name].text))
            self.env[name] = (self.generator(name),)
        else:
            wish, values = f"{self.prefix}_{identifier(name)}", self.value(tree)
            wishes = [wish] if len(values) == 1 else [f"{wish}_{k}" for k in (1, 2, 3)]
            self.env[name] = tuple(map(self.writer.named, values, wishes))

    def _change(self, old: int, formulas: Sequence[Sequence[Tree]], time: Tree) -> None:
        """The rates of new variables by the chain rule, for a change with an inverse."""
        source = self.earlier[old]
        into = source.carried({n: self.scalar(n) for n in source.checked.names}, self)
        self.old = [self.scalar(name) for name in source.checked.variables]
        scale = into(source.scalar(time))
        for name, tree in formulas:
            formula = source.scalar(tree)
            self.vanishes(f"inverse of {name}", into(formula) - self.scalar(name))
            self.rates[name] = into(source.along(formula, source.rates)) * scale

    def _settle(self) -> None:
        """Name the rates, and check those that follow from others."""
        rates = {
            name: self.writer.named(rate, f"{self.prefix}_rate_{identifier(name)}")
            for name, rate in self.rates.items()
        }
        self.rates = {name: rate for name, rate in rates.items() if name in self.at}
        for name, rate in rates.items():
            own = self.scalar(name)
            if name in self.squares:
                change = self.along(self.squares[name], self.rates)
                self.vanishes(f"rate of {name}", own * rate + own * rate - change)
            elif name not in self.at:
                self.vanishes(f"rate of {name}", self.along(own, self.rates) - rate)

    @property
    def bar(self) -> Map:
        """The map to conjugates, made when it is first asked for."""
        if self._bar is None:
            self._bar = self.carried(self.conjugates(), self)
            for own in self.old:
                self.vanishes("a real variable", own - self._bar(own))
        return self._bar

    def conjugates(self) -> dict[str, Value]:
        """The conjugates of the names."""
        swap = {a: b for pair in self._pairs for a, b in (pair, pair[::-1])}
        images = {name: self.generator(swap.get(name, name)) for name in self.checked.names}
        for name, square in self.squares.items():
            if square.element.terms == {0: -1}:
                images[name] = self.number(0) - images[name]
        return images

    # -- values --------------------------------------------------------------------

    def vanishes(self, words: str, value: Value) -> None:
        """Ask whether a value vanishes wherever the divisors do not."""
        self.writer.holds(words.replace("\\", ""), value.text, self.divisors)

    def number(self, value: int) -> Value:
        """An integer."""
        return Value(self.writer.language.number(Fraction(value)), self.checked.number(value))

    def generator(self, name: str) -> Value:
        """A name that stands for itself."""
        return Value(self.at[name], self.checked.generator(name))

    def inverse(self, value: Value) -> Value:
        """One over a value: the checker finds it, the program checks it."""
        element = value.element.inverse()
        found = Value(self.writer.polynomial(element, self.at), element)
        found = self.writer.named(found)
        self.vanishes("inverse", value * found - self.number(1))
        return found

    def along(self, value: Value, rates: Rates) -> Value:
        """The derivative; rates of roots and inverses that are not given follow, and are kept."""
        value = self.writer.named(value)
        total = self.number(0)
        for name in self.at:
            if value.element.split(name).keys() - {0}:
                if name not in rates:
                    rates[name] = self.rate(name, rates)
                if rates[name].element.terms:
                    partial = self.writer.language.derivative(value.text, self.at[name])
                    by_name = value.element.along(self._only(name))
                    total = total + Value(partial, by_name) * rates[name]
        return self.writer.named(total)

    def _only(self, name: str) -> dict[str, checker.Element]:
        """The rates by which everything but one generator is constant."""
        return {other: self.checked.number(int(other == name)) for other in self.at}

    def rate(self, name: str, rates: Rates) -> Value:
        """The rate of a generator that follows from those of others."""
        own = self.generator(name)
        if name in self.checked.divisors:
            below = dict(self.over)[name]
            return self.writer.named(self.number(0) - own * own * self.along(below, rates))
        if name in self.squares:
            change = self.along(self.squares[name], rates)
            if not change.element.vanishes():
                if (parts := change.element.split(name)).keys() == {1}:
                    return self._half(own, change, parts[1])
                half = self.inverse(self.squares[name] + self.squares[name])
                return self.writer.named(own * change * half)
            self.vanishes(f"rate of the square of {name}", change)
        return self.number(0)

    def _half(self, own: Value, change: Value, factor: checker.Element) -> Value:
        """The rate of a root whose square changes by a multiple of the root itself."""
        multiple = Value(self.writer.polynomial(factor, self.at), factor)
        multiple = self.writer.named(multiple)
        self.vanishes("rate of a square", change - own * multiple)
        return multiple * Value(
            self.writer.language.number(Fraction(1, 2)),
            checker.Element(self.checked, {0: 1}, 2),
        )

    def carried(self, images: dict[str, Value], space: Space) -> Map:
        """The map into a space that takes names to images, after checks that relations hold."""
        plain = self._map(images, space)
        for name, below in self.over:
            images[name] = space.inverse(space.writer.named(plain(below)))
        into = self._map(images, space)
        for name, square in self.squares.items():
            rest = images[name] * images[name] - into(square)
            space.vanishes(f"square of {name}", rest)
        return into

    def _map(self, images: Mapping[str, Value], space: Space) -> Map:
        texts = {self.at[name]: image.text for name, image in images.items()}
        elements = {name: image.element for name, image in images.items()}
        function = self.writer.substitution(texts)

        def apply(value: Value) -> Value:
            image = value.element.image(elements, space.checked)
            return space.writer.named(Value(f"{function}({self.writer.named(value).text})", image))

        return apply

    # -- formulas ------------------------------------------------------------------

    def scalar(self, tree: Tree) -> Value:
        """The value of a formula that is no vector."""
        (value,) = self.value(tree)
        return value

    def value(self, tree: Tree) -> Values:
        """The components of the value of a formula."""
        if isinstance(tree, str):
            return self.env[tree]
        if isinstance(tree, int):
            return (self.number(tree),)
        op, first, *rest = tree
        if op == "^":
            return (self.scalar(first) ** int(rest[0]),)
        if op == "d":
            return (self.along(self.scalar(*rest), {first: self.number(1)}),)
        values = [self.value(part) for part in tree[1:]]
        if op in ("vector", "diag"):
            return tuple(value for (value,) in values)
        if rest:
            return reduce(lambda a, b: self._binary(op, a, b), values)
        return tuple(self._unary(op, value) for value in values[0])

    def _binary(self, op: str, a: Values, b: Values) -> Values:
        if op == "+":
            return tuple(x + y for x, y in zip(a, b, strict=True))
        if op == "cross":
            (p, q, r), (x, y, z) = a, b
            return (q * z - r * y, r * x - p * z, p * y - q * x)
        checker.need(op in ("*", "/", "dot"), f"{op} is not understood")
        checker.need(op != "dot" or len(a) == len(b) > 1, "a scalar product of scalars")
        if op == "/":
            b = tuple(self.inverse(below) for below in b)
        a, b = (a * len(b) if len(a) == 1 else a), (b * len(a) if len(b) == 1 else b)
        products = tuple(x * y for x, y in zip(a, b, strict=True))
        return (reduce(Value.__add__, products),) if op == "dot" else products

    def _unary(self, op: str, value: Value) -> Value:
        if op == "D":
            return self.along(value, self.rates)
        if op == "sqrt":
            differences = ((n, square - value) for n, square in self.squares.items())
            name, rest = next((n, rest) for n, rest in differences if rest.element.vanishes())
            self.vanishes(f"square of {name}", rest)
            return self.generator(name)
        if op == "conj":
            return self.bar(value)
        checker.need(op == "-", f"{op} is not understood")
        return self.number(0) - value

    def differences(self, equations: Tree) -> list[Value]:
        """Left minus right sides, component by component, under names."""
        pairs = [zip(self.value(a), self.value(b), strict=True) for a, b in equations]
        return [self.writer.named(left - right) for pair in pairs for left, right in pair]

    # -- points --------------------------------------------------------------------

    def point(self, given: Tree, roots: Sequence[int], values: Tree) -> tuple[Map, Space]:
        """The map to numbers that an exact point is, after checks that equations hold there."""
        steps = [["root", "i", ["-", 1]], *(["root", f"\\sqrt{{{d}}}", d] for d in roots)]
        data = {"variables": [], "steps": steps}
        names = (f"p{k}" for k in count())
        numbers = Space(self.writer, self.writer.fresh(next(names)), data)
        images = {name: numbers.scalar(tree) for name, tree in values}
        at = self.carried(dict(images), numbers)
        for difference in self.differences(given):
            numbers.vanishes("at the point", at(difference))
        for name, conjugate in self.conjugates().items():
            numbers.vanishes("a real point", at(conjugate) - numbers.bar(images[name]))
        return at, numbers
