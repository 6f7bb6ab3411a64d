"""Trees of a certificate as expressions of Rocq."""

from __future__ import annotations

import re
from collections.abc import Callable

from kowalevski_cas.export.format import Inexpressible, identifier
from kowalevski_cas.problem.trees import Tree

WORDS = set(
    "Add Axiom Claims D Definition Div End Fixpoint I Import Lemma Let Module Mul Notation Num "
    "Opp Pow Prop R R_field Section Set Sub Theorem Type Var Variable add all_sound along andb as "
    "at at_point back bar cofix combined conj conjugate cross decided div dot each else end "
    "equal equations exists exists2 expr factor false fix for forall fst3 fun gauss gbar hold if "
    "in inv inverted let list map map3 match minor mod mul nat one opp p partials point proved "
    "reciprocal return snd3 sound sub subst table thd3 then true using v val value vanishes vec "
    "where with zero zip3".split()
)
NUMBERED = re.compile(
    r"(back|by|chain_rule|claim|conjugate_roots|d|facts|field|hold|known|moving_roots|nonzero"
    r"|numbers?|order|over|plain|printed|real|root|sound|under|Space)_.*|G\d*"
)
PLACES = ("fst3", "snd3", "thd3")
TIGHT, POWER, MINUS, TIMES, PLUS, LOOSE = 0, 30, 35, 40, 50, 100
"""The levels at which Rocq reads expressions."""


class Terms:
    """Names with their words, and how trees with these names are printed."""

    root: Callable[[Tree], str]
    """The name of the root of a tree."""
    partial: Callable[[str], str]
    """The word for the partial derivative by a name."""

    def __init__(self) -> None:
        self.words: dict[str, str] = {}
        self.wide: set[str] = set()

    def new_word(self, name: str) -> str:
        """A word for a name, neither Rocq's nor one that the files use themselves."""
        word = identifier(name)
        while word in WORDS or NUMBERED.fullmatch(word) or word in self.words.values():
            word = f"the_{word}"
        self.words[name] = word
        return word

    def is_vector(self, tree: Tree) -> bool:
        """Whether a tree has three components."""
        if isinstance(tree, str):
            return tree in self.wide
        if not isinstance(tree, list) or tree[0] in ("dot", "d", "^", "sqrt"):
            return False
        return tree[0] in ("vector", "diag", "cross") or any(map(self.is_vector, tree[1:]))

    def components(self, tree: Tree, module: str = "") -> list[str]:
        """The components of a tree as expressions: one, or three."""
        if not self.is_vector(tree):
            return [self.term(tree, module)]
        text = self.term(tree, module, TIGHT)
        return [f"{place} {text}" for place in PLACES]

    def term(self, tree: Tree, module: str = "", level: int = LOOSE) -> str:
        """A tree as an expression, or a triple, that is read at a level.

        ``module`` is the module with the definitions, and a dot.
        """
        text, own = self._term(tree, module)
        return text if own <= level else f"({text})"

    def _term(self, tree: Tree, module: str) -> tuple[str, int]:
        if isinstance(tree, str):
            return module + self.words[tree], TIGHT
        if isinstance(tree, int):
            return (str(tree), TIGHT) if tree >= 0 else (f"- {-tree}", MINUS)
        op, *parts = tree
        if op in ("^", "sqrt", "d"):
            return self._scalar(op, parts, module)
        if op in ("vector", "diag", "dot", "cross"):
            return self._triple(op, parts, module)
        if len(parts) == 1:
            return self._unary(op, parts[0], module)
        if any(map(self.is_vector, parts)):
            return self._vectors(op, parts, module), POWER
        return self._sum(parts, module) if op == "+" else self._product(op, parts, module)

    def _scalar(self, op: str, parts: list[Tree], module: str) -> tuple[str, int]:
        """A power, a root or a partial derivative."""
        if op == "sqrt":
            return self._term(self.root(parts[0]), module)
        if op == "^":
            return f"{self.term(parts[0], module, TIGHT)} ^ {parts[1]}", POWER
        return f"{module}{self.partial(parts[0])} {self.term(parts[1], module, TIGHT)}", POWER

    def _triple(self, op: str, parts: list[Tree], module: str) -> tuple[str, int]:
        """A vector by its components, or a product of two vectors."""
        if op in ("dot", "cross"):
            return f"{op} {' '.join(self.term(part, module, TIGHT) for part in parts)}", POWER
        if len(parts) != 3:
            raise Inexpressible("a vector has not three components")
        return f"({', '.join(self.term(part, module) for part in parts)})", TIGHT

    def _sum(self, parts: list[Tree], module: str) -> tuple[str, int]:
        text = self.term(parts[0], module, PLUS)
        for part in parts[1:]:
            minus = isinstance(part, list) and part[0] == "-" and len(part) == 2
            shown = self.term(part[1] if minus else part, module, TIMES)
            text += f" - {shown}" if minus else f" + {shown}"
        return text, PLUS

    def _product(self, op: str, parts: list[Tree], module: str) -> tuple[str, int]:
        factors = [self.term(parts[0], module, TIMES)]
        factors += [self.term(part, module, MINUS) for part in parts[1:]]
        return f" {op} ".join(factors), TIMES

    def _unary(self, op: str, part: Tree, module: str) -> tuple[str, int]:
        if op == "-" and not self.is_vector(part):
            return f"- {self.term(part, module, MINUS)}", MINUS
        head = "Opp" if op == "-" else module + {"D": "D", "conj": "conjugate"}[op]
        map3 = f"map3 {head}" if self.is_vector(part) else head
        return f"{map3} {self.term(part, module, TIGHT)}", POWER

    def _vectors(self, op: str, parts: list[Tree], module: str) -> str:
        """Operations component by component, also with numbers."""
        name = {"+": "Add", "*": "Mul", "/": "Div"}[op]
        text, vector = self.term(parts[0], module, TIGHT), self.is_vector(parts[0])
        for part in parts[1:]:
            shown, wide = self.term(part, module, TIGHT), self.is_vector(part)
            if vector and wide:
                text = f"(zip3 {name} {text} {shown})"
            elif vector:
                text = f"(map3 (fun e => {name} e {shown}) {text})"
            elif wide:
                text = f"(map3 ({name} {text}) {shown})"
            else:
                text = f"({name} {text} {shown})"
            vector = vector or wide
        return text[1:-1]
