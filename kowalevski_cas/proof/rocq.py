"""Certificates for Rocq: it differentiates and proves, this only prints.

Every space becomes a module with its definitions as expressions, every equation that
holds a theorem over any field in which 2 is not zero, every refuted one a theorem about
two numbers that Rocq computes. Ranks are left out.
"""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from importlib.resources import files
from itertools import combinations_with_replacement
from typing import Any

from kowalevski_cas.proof import checker
from kowalevski_cas.proof.trees import CertificateError, Tree

THEORY = "Derivation.v"
HEADER = """(** {title}, generated: the formulas of {name} as printed, and their proofs. *)

From Coq Require Import ZArith QArith List Field.
Require Import Derivation.
Import ListNotations.

"""

SECTION = """
Section Claims.

Variable R : Type.
Variables zero one : R.
Variables add mul sub : R -> R -> R.
Variable opp : R -> R.
Variable div : R -> R -> R.
Variable inv : R -> R.
Variable R_field : field_theory zero one add mul sub opp div inv (@eq R).
Add Field R_as_field : R_field.
Hypothesis two_nonzero : add one one <> zero.

Notation val := (value R zero one add mul opp div).

Ltac norm H p q other ring_by :=
  let E := fresh in
  intro E; apply H; transitivity (mul (add p q) other); [ring_by tt | rewrite E; ring].

Ltac nonzero ring_by :=
  repeat match goal with |- _ /\\ _ => split end;
  repeat first
    [ assumption
    | exact (F_1_neq_0 R_field)
    | apply (opposite_nonzero R zero one add mul sub opp div inv R_field)
    | apply (product_nonzero R zero one add mul sub opp div inv R_field)
    | match goal with H : ?a <> zero |- ?b <> zero =>
        let E := fresh in
        intro E; apply H;
        first
          [ rewrite <- E; ring
          | transitivity (opp zero); [rewrite <- E; ring | ring]
          | rewrite E; ring ]
      end
    | match goal with H : ?a <> zero |- ?b <> zero =>
        replace b with (mul (add one one) a) by ring
      end
    | match goal with
      | H : _ <> zero |- add ?p (opp ?q) <> zero => norm H p (opp q) (add p q) ring_by
      | H : _ <> zero |- add ?p ?q <> zero => norm H p q (add p (opp q)) ring_by
      end ].
"""


def theory() -> str:
    """The file about expressions on which the others rest."""
    return (files("kowalevski_cas.proof") / THEORY).read_text(encoding="utf-8")


def identifier(name: str) -> str:
    r"""A name that Rocq understands: ``\sqrt{x_1x_2}`` becomes ``sqrt_x_1x_2``.

    >>> identifier(r"\omega_1"), identifier(r"\omega_1^*"), identifier("i")
    ('omega_1', 'omega_1_star', 'i')
    """
    name = name.replace("*", "_star").replace(r"\mathbf", "bold").replace(r"\boldsymbol", "bold")
    name = re.sub(r"\\text|\\mathrm", "", name)
    name = re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_")
    return name if name not in RESERVED else f"{name}_"


RESERVED = {"in", "at", "as", "fun", "let", "if", "then", "else", "Var", "Num", "S", "R", "v", "E"}


class Space:
    """A space of a certificate as a module."""

    def __init__(self, data: dict[str, Any], module: str, spaces: list[Space]) -> None:
        self.data, self.module, self.spaces = data, module, spaces
        self.roots = [step[1] for step in data.get("steps", []) if step[0] == "root"]
        self.names = [*data["variables"], *data.get("constants", []), *self.roots]
        self.squares = {s[1]: s[2] for s in data.get("steps", []) if s[0] == "root"}
        self.wide: set[str] = set()
        self.still: list[str] = []
        self.lines: list[str] = []
        self.checked = checker.Space([space.checked for space in spaces], _copy(data))
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
        return f"{self.module}.{identifier(name)}"

    def _define(self, name: str, kind: str, term: str) -> None:
        self._add(identifier(name), kind, term)

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
            self._add(f"rate_{identifier(name)}", "expr", rate)
            entries[name] = f"rate_{identifier(name)}"
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
            self._add(f"rate_{identifier(name)}", "expr", rate)
            entries[name] = f"rate_{identifier(name)}"
        for root in self.roots:
            if root not in entries and self._stays(root):
                entries[root] = "(Num 0)"
                self.still.append(root)
            elif root not in entries:
                below = f"(Mul (Num 2) {self.q(root)})"
                rate = f"Div (along motion {self.term(self.squares[root])}) {below}"
                self._add(f"rate_{identifier(root)}", "expr", rate)
                entries[root] = f"rate_{identifier(root)}"
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
            if most := max(parts):
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
                raise CertificateError("a vector has not three components")
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
        head = {
            "-": "Opp",
            "D": f"along {self.module}.motion",
            "conj": f"subst {self.module}.bar",
        }[op]
        return f"(map3 ({head}) {term})" if self.is_vector(part) else f"({head} {term})"

    def root(self, argument: Tree) -> str:
        """The name of the root of an expression."""
        found = self.checked.unary("sqrt", self.checked.scalar(argument))
        return next(name for name in self.roots if found.terms == {self.checked.unit[name]: 1})

    def partial(self, name: str) -> str:
        """The field that moves one name only, and the roots that depend on it."""
        rates = []
        for other in self.names:
            if other == name:
                rates.append("Num 1")
            elif other in self.squares and self._depends(self.squares[other], name):
                raise CertificateError("a partial derivative moves a root")
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


def _copy(data: Any) -> Any:
    return json.loads(json.dumps(data))


class Theorems:
    """The theorems of one certificate."""

    def __init__(self, data: dict[str, Any], inverted: set[str]) -> None:
        self.inverted = inverted
        self.claim = identifier(data["claim"].replace(".", "_"))
        self.spaces: list[Space] = []
        for k, space in enumerate(data["spaces"]):
            self.spaces.append(Space(space, f"{self.claim}_space_{k}", self.spaces))
        self.names: list[str] = []
        self.parts: list[str] = []
        for space in self.spaces:
            self._inverse(space)
            for root in space.still:
                rate = f"(along {space.module}.motion {space.term(space.squares[root])})"
                self._theorem(space, [], rate, "(Num 0)")
        for part in data["parts"]:
            space = self.spaces[part["space"]]
            if part["shows"] == "follows":
                self._follows(space, part)
            elif part["shows"] == "differ":
                self._differ(space, part)

    def text(self) -> str:
        """The theorems."""
        return "\n".join(self.parts)

    def _inverse(self, space: Space) -> None:
        change = space.data.get("change")
        key = json.dumps(change, sort_keys=True)
        if change is None or key in self.inverted:
            return
        self.inverted.add(key)
        old = space.spaces[change["old"]]
        for name, tree in change["formulas"]:
            left = f"(subst {space.module}.back {old.term(tree)})"
            self._theorem(space, [], left, space.q(name))

    def _follows(self, space: Space, part: dict[str, Any]) -> None:
        pairs = space.pairs(part["equations"])
        given = space.pairs(part.get("given", []))
        root = part.get("root")
        if root is None:
            targets = [f"(Sub {a} {b})" for a, b in pairs] if given else []
        else:
            flips = [f"Opp {space.q(n)}" if n == root else space.q(n) for n in space.names]
            flip = f"(from [{'; '.join(flips)}] Var)"
            single = [f"(Sub {a} {b})" for a, b in pairs]
            both = combinations_with_replacement(single, 2)
            targets = [f"(Mul {a} (subst {flip} {b}))" for a, b in both]
        if not given:
            for left, right in pairs:
                self._theorem(space, [], left, right)
            return
        for target, row in zip(targets, part["cofactors"], strict=True):
            self._theorem(space, given, target, "(Num 0)", [space.term(tree) for tree in row])

    def _theorem(
        self,
        space: Space,
        given: list[tuple[str, str]],
        left: str,
        right: str,
        cofactors: Sequence[str] = (),
    ) -> None:
        name = f"{self.claim}_{len(self.names) + 1}"
        self.names.append(name)
        hypotheses, intros, rewriting = [], ["v"], []
        facts = []
        assumed: list[str] = []
        for k, root in enumerate(space.roots):
            own = space.q(root)
            square = space.term(space.squares[root])
            hypotheses.append(f"val v (Mul {own} {own}) = val v {square}")
            intros.append(f"S{k}")
            rewriting.append(f"S{k}" if space.over(root) is None else f"T{k}")
        for k, tree in enumerate(space.data.get("nonzero", [])):
            hypotheses.append(f"val v {space.term(tree)} <> zero")
            intros.append(f"N{k}")
            assumed.append(f"N{k}")
        for k, (a, b) in enumerate(given):
            hypotheses.append(f"val v {a} = val v {b}")
            intros.append(f"G{k}")
        for k, root in enumerate(space.roots):
            facts.append(
                f"  try assert (val v {space.q(root)} <> zero) by "
                f"(refine (root_nonzero R zero one add mul sub opp div inv R_field _ _ S{k} _); "
                f"cbv -[not] in *; nonzero {_ring(rewriting)})."
            )
        for k, root in enumerate(space.roots):
            facts += _fraction(space, k, root, rewriting[:k])
        quotients = [f"Y{k}" for k, name in enumerate(rewriting) if name.startswith("T")]
        statement = " ->\n  ".join([*hypotheses, f"val v {left} = val v {right}"])
        proof = [f"  intros {' '.join(intros)}.", *facts]
        if given:
            sums = "(Num 0)"
            for cofactor, (a, b) in zip(cofactors, given, strict=True):
                sums = f"(Add {sums} (Mul {cofactor} (Sub {a} {b})))"
            proof.append(f"  transitivity (val v {sums}).")
            clear = " ".join(f"G{k}" for k in range(len(given)))
            proof.append(f"  - clear {clear}. {_field(rewriting, assumed, quotients)}")
            proof.append(
                "  - repeat (etransitivity; [eapply (vanishing R zero one add mul sub opp div inv "
                "R_field); eassumption |]). reflexivity."
            )
        else:
            proof.append(f"  {_field(rewriting, assumed, quotients)}")
        self.parts.append(
            f"Theorem {name} : forall v : nat -> R,\n  {statement}.\nProof.\n"
            + "\n".join(proof)
            + "\nQed.\n"
        )

    def _differ(self, space: Space, part: dict[str, Any]) -> None:
        name = f"{self.claim}_{len(self.names) + 1}"
        self.names.append(name)
        values = dict(part["point"]["values"])
        shown = "; ".join(_gauss(values[n]) for n in space.names)
        point = f"(point [{shown}])"
        holds = []
        for root in space.roots:
            own, square = space.q(root), space.term(space.squares[root])
            holds.append(f"same (at_point {point} (Mul {own} {own})) (at_point {point} {square})")
        for a, b in space.pairs(part.get("given", [])):
            holds.append(f"same (at_point {point} {a}) (at_point {point} {b})")
        pairs = space.pairs([part["equation"]])
        a, b = pairs[0] if len(pairs) == 1 else self._apart(space, part)
        holds.append(f"~ same (at_point {point} {a}) (at_point {point} {b})")
        self.parts.append(
            f"Theorem {name} :\n  " + " /\\\n  ".join(holds) + ".\nProof.\n"
            "  repeat split; try (vm_compute; reflexivity);\n"
            "  intros [H1 H2]; vm_compute in H1, H2; discriminate.\nQed.\n"
        )

    @staticmethod
    def _apart(space: Space, part: dict[str, Any]) -> tuple[str, str]:
        raise CertificateError("a refuted equation between vectors")


def _fraction(space: Space, k: int, root: str, earlier: list[str]) -> list[str]:
    """Steps after which the root of a fraction is a root of a polynomial over another one."""
    found = space.over(root)
    if found is None:
        return []
    below, square = found
    own = space.q(root)
    squares = f" [{' '.join(earlier)}]" if earlier else ""
    done = f"field{squares}; nonzero {_ring(earlier)}"
    return [
        f"  assert (X{k} : exists h, mul h h = val v {square} /\\ val v {own} = div h (val v {below})).",
        f"  {{ exists (mul (val v {own}) (val v {below})). split.",
        f"    - transitivity (mul (val v (Mul {own} {own})) (mul (val v {below}) (val v {below}))).",
        "      + cbn [value]. ring.",
        f"      + rewrite S{k}. cbv -[not] in *. {done}.",
        f"    - cbv -[not] in *. {done}. }}",
        f"  destruct X{k} as [h{k} [T{k} Y{k}]]. clear S{k}.",
    ]


def _field(rewriting: list[str], assumed: list[str], quotients: list[str]) -> str:
    names = ", ".join([*rewriting, *assumed, *quotients])
    inside = f" in {names} |- *" if names else ""
    squares = f" [{' '.join(rewriting)}]" if rewriting else ""
    rewrites = "".join(f"rewrite ?{name}; " for name in quotients)
    return (
        "apply (simplified R zero one add mul sub opp div inv R_field); "
        f"cbv -[not]{inside}; {rewrites}field{squares}; nonzero {_ring(rewriting)}."
    )


def _ring(rewriting: list[str]) -> str:
    squares = f" [{' '.join(rewriting)}]" if rewriting else ""
    return f"ltac:(fun _ => ring{squares})"


def _gauss(tree: Tree) -> str:
    """A Gaussian rational number."""
    numbers = checker.Space([], {"variables": [], "steps": [["root", "i", ["-", 1]]]})
    element = numbers.scalar(tree)
    parts = []
    for monomial in (0, numbers.unit["i"]):
        top, below = element.terms.get(monomial, 0).as_integer_ratio()
        parts.append(f"({top} # {below})")
    if set(element.terms) - {0, numbers.unit["i"]}:
        raise CertificateError("a coordinate is no Gaussian rational")
    return f"({', '.join(parts)})"


def export(name: str, title: str, certificates: Sequence[dict[str, Any]]) -> tuple[str, list[str]]:
    """A file with the theorems of certificates, and the claims that have one."""
    head, body = [HEADER.format(name=name, title=title)], [SECTION.replace("{{", "{")]
    names: list[str] = []
    claims, inverted = [], set[str]()
    for data in certificates:
        theorems = Theorems(data, inverted)
        if theorems.names:
            head.append(f"(** * {data['claim']} *)\n")
            head += [space.text() for space in theorems.spaces]
            body.append(f"(** * {data['claim']} *)\n")
            body.append(theorems.text())
            names += theorems.names
            claims.append(data["claim"])
    printed = [f"Print Assumptions {name}." for name in names]
    return "\n".join([*head, *body, "End Claims.\n", *printed]) + "\n", claims
