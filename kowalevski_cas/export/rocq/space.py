"""A space of a certificate as a module of Rocq: names, definitions, the vector field."""

from __future__ import annotations

from collections.abc import Sequence
from copy import deepcopy
from typing import Any

from kowalevski_cas.export.format import Inexpressible, Json, identifier
from kowalevski_cas.proof import checker
from kowalevski_cas.proof.trees import Tree

RESERVED = {"in", "at", "as", "fun", "let", "if", "then", "else", "Var", "Num", "S", "R", "v", "E"}


def word(name: str) -> str:
    """A name that Rocq understands."""
    name = identifier(name)
    return f"{name}_" if name in RESERVED else name


class Space:
    """A space of a certificate as a module."""

    def __init__(self, data: Json, module: str, spaces: list[Space]) -> None:
        self.data, self.module, self.spaces = data, module, spaces
        self.roots = [step[1] for step in data.get("steps", []) if step[0] == "root"]
        self.names = [*data["variables"], *data.get("constants", []), *self.roots]
        self.squares = {s[1]: s[2] for s in data.get("steps", []) if s[0] == "root"}
        self.wide: set[str] = set()
        self.still: list[str] = []
        self.lines: list[str] = []
        checked = [space.checked for space in spaces]
        self.checked: checker.Space = checker.Space(checked, deepcopy(data))
        for k, name in enumerate(self.names):
            self._define(name, "expr", f"Var {k}")
        for kind, name, tree in data.get("steps", []):
            if kind == "let":
                vector = self.is_vector(tree)
                if vector:
                    self.wide.add(name)
                self._define(name, "vec" if vector else "expr", self.term(tree))
        if "change" in data:
            self._change(data["change"])
        elif "field" in data:
            self._motion({})
        if "conjugates" in data:
            swap = {a: b for pair in data["conjugates"] for a, b in (pair, pair[::-1])}
            bars = [
                f"Opp {self.q('i')}" if n == "i" else self.q(swap.get(n, n)) for n in self.names
            ]
            self._add("bar", "nat -> expr", f"from [{'; '.join(bars)}] Var")

    def text(self) -> str:
        """The module."""
        body = "\n".join(f"  {line}" for line in self.lines)
        return f"Module {self.module}.\n{body}\nEnd {self.module}.\n"

    def q(self, name: str) -> str:
        """A name with its module."""
        return f"{self.module}.{word(name)}"

    def _define(self, name: str, kind: str, term: str) -> None:
        self._add(word(name), kind, term)

    def _add(self, name: str, kind: str, term: str) -> None:
        self.lines.append(f"Definition {name} : {kind} := {self._inside(term)}.")

    def _inside(self, term: str) -> str:
        return term.replace(f"{self.module}.", "")

    # -- the field ---------------------------------------------------------------

    def _change(self, change: dict[str, Any]) -> None:
        old = self.spaces[change["old"]]
        back = "; ".join(self.q(name) for name in old.names)
        self._add("back", "nat -> expr", f"from [{back}] Var")
        rates = {}
        for name, tree in change["formulas"]:
            rate = f"subst back (along {old.module}.motion {old.term(tree)})"
            rates[name] = f"Mul ({rate}) (subst back {old.term(change['time'])})"
        self._motion(rates)

    def _motion(self, rates: dict[str, str]) -> None:
        """The rates of all names in their order, those of roots by their squares."""
        entries: dict[str, str] = dict(rates)
        for name, rate in rates.items():
            self._add(f"rate_{word(name)}", "expr", rate)
            entries[name] = f"rate_{word(name)}"
        powers = []
        for k, (names, factor, right) in enumerate(self.data.get("field", [])):
            if any(_has(right, "D") for _ in names):
                powers.append((names[0], factor, right))
                continue
            if len(names) == 1 and not self.is_vector(right):
                self._add(f"equation_{k}", "expr", f"Div {self.term(right)} {self.term(factor)}")
                entries[names[0]] = f"equation_{k}"
                continue
            below, above = self.term(factor), self.term(right)
            self._add(f"equation_{k}", "vec", f"zip3 Div {above} {below}")
            for name, place in zip(names, ("fst3", "snd3", "thd3"), strict=True):
                entries[name] = f"({place} equation_{k})"
        shown = [entries.get(n, "(Num 0)") for n in self.names if n not in self.roots]
        self._add("motion", "nat -> expr", f"from [{'; '.join(shown)}] constant")
        for name, factor, right in powers:
            rate = f"Div {self.term(right)} {self.term(factor)}"
            self._add(f"rate_{word(name)}", "expr", rate)
            entries[name] = f"rate_{word(name)}"
        for root in self.roots:
            if root not in entries and self._stays(root):
                entries[root] = "(Num 0)"
                self.still.append(root)
            elif root not in entries:
                below = f"(Mul (Num 2) {self.q(root)})"
                rate = f"Div (along motion {self.term(self.squares[root])}) {below}"
                self._add(f"rate_{word(root)}", "expr", rate)
                entries[root] = f"rate_{word(root)}"
        if powers or self.roots:
            self.lines = [line.replace(" motion ", " motion_0 ") for line in self.lines]
            shown = [entries.get(n, "(Num 0)") for n in self.names]
            self._add("motion", "nat -> expr", f"from [{'; '.join(shown)}] constant")

    def _stays(self, root: str) -> bool:
        """Whether the square of a root is constant: then its rate is zero, a theorem."""
        return self.checked.roots[root].along(self.checked.rates).vanishes()

    def over(self, root: str) -> tuple[str, str] | None:
        """For a root of a fraction: what it has to be multiplied by, and the square then."""
        element, below = self.checked.roots[root], self.checked.number(1)
        for name, divisor in self.checked.divisors.items():
            parts = element.split(name)
            if most := max(parts, default=0):
                each = (part * divisor ** (most - e) for e, part in parts.items())
                element = sum(each, self.checked.number(0))
                below = below * divisor**most
        if below.terms.keys() == {0}:
            return None
        return self.term(_polynomial(below)), self.term(_polynomial(element * below))

    # -- terms -------------------------------------------------------------------

    def is_vector(self, tree: Tree) -> bool:
        """Whether a tree stands for three components."""
        if isinstance(tree, str):
            return tree in self.wide
        if not isinstance(tree, list) or tree[0] in ("dot", "d", "^", "sqrt"):
            return False
        return tree[0] in ("vector", "diag", "cross") or any(map(self.is_vector, tree[1:]))

    def term(self, tree: Tree) -> str:
        """A formula as an expression of Rocq."""
        if isinstance(tree, str):
            return self.q(tree)
        if isinstance(tree, int):
            return f"(Num {tree})" if tree >= 0 else f"(Num ({tree}))"
        op, *rest = tree
        if op == "^":
            return f"(Pow {self.term(rest[0])} {rest[1]})"
        if op == "sqrt":
            return self.q(self.root(rest[0]))
        if op == "d":
            return f"(along {self.partial(rest[0])} {self.term(rest[1])})"
        terms = [self.term(part) for part in rest]
        if op in ("vector", "diag"):
            if len(terms) != 3:
                raise Inexpressible("a vector has not three components")
            return f"({', '.join(terms)})"
        if op in ("dot", "cross"):
            return f"({op} {' '.join(terms)})"
        if len(rest) == 1:
            return self._unary(op, rest[0], terms[0])
        result, vector = terms[0], self.is_vector(rest[0])
        for part, term in zip(rest[1:], terms[1:], strict=True):
            name = {"+": "Add", "*": "Mul", "/": "Div"}[op]
            wide = self.is_vector(part)
            if vector and wide:
                result = f"(zip3 {name} {result} {term})"
            elif vector:
                result = f"(map3 (fun x => {name} x {term}) {result})"
            elif wide:
                result = f"(map3 ({name} {result}) {term})"
            else:
                result = f"({name} {result} {term})"
            vector = vector or wide
        return result

    def _unary(self, op: str, part: Tree, term: str) -> str:
        heads = {
            "-": "Opp",
            "D": f"along {self.module}.motion",
            "conj": f"subst {self.module}.bar",
        }
        wide = self.is_vector(part)
        return f"(map3 ({heads[op]}) {term})" if wide else f"({heads[op]} {term})"

    def root(self, argument: Tree) -> str:
        """The name of the root of an expression."""
        found = self.checked.unary("sqrt", self.checked.scalar(argument))
        names = [name for name in self.roots if found.terms == {self.checked.unit[name]: 1}]
        return str(names[0])

    def partial(self, name: str) -> str:
        """The field that moves one name only, and the roots that depend on it."""
        rates = []
        for other in self.names:
            if other == name:
                rates.append("Num 1")
            elif other in self.squares and self._depends(self.squares[other], name):
                raise Inexpressible("a partial derivative moves a root")
            else:
                rates.append("Num 0")
        return f"(from [{'; '.join(rates)}] constant)"

    def _depends(self, tree: Tree, name: str) -> bool:
        element = self.checked.scalar(tree)
        return bool(element.along({name: self.checked.number(1)}).terms)

    def components(self, tree: Tree) -> list[str]:
        """The components of a formula."""
        term = self.term(tree)
        if not self.is_vector(tree):
            return [term]
        return [f"({place} {term})" for place in ("fst3", "snd3", "thd3")]

    def pairs(self, equations: Sequence[Sequence[Tree]]) -> list[tuple[str, str]]:
        """Both sides of equations, component by component."""
        found = []
        for left, right in equations:
            found += list(zip(self.components(left), self.components(right), strict=True))
        return found


def _polynomial(element: checker.Element) -> Tree:
    """A polynomial of the checker as a tree."""
    summands: list[Tree] = [0]
    for monomial, value in sorted(element.terms.items(), reverse=True):
        top, below = value.as_integer_ratio()
        shifts = element.space.at.items()
        powers = ((name, monomial >> shift & checker.MASK) for name, shift in shifts)
        factors = [["^", name, e] for name, e in powers if e]
        summands.append(["*", ["/", top, below], *factors] if factors else ["/", top, below])
    return ["+", *summands]


def _has(tree: Tree, op: str) -> bool:
    return isinstance(tree, list) and (tree[0] == op or any(_has(part, op) for part in tree[1:]))
