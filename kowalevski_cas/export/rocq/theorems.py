"""The theorems of a certificate, and their proofs."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations_with_replacement
from typing import Any

from kowalevski_cas.export.format import Inexpressible, Json, identifier
from kowalevski_cas.export.rocq.space import Space
from kowalevski_cas.proof import checker
from kowalevski_cas.proof.trees import Tree

HEADER = """(** {title}: the formulas as printed, and what holds of them. Generated. *)

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


class Theorems:
    """The theorems of one certificate."""

    def __init__(self, data: Json) -> None:
        self.claim = identifier(data["claim"])
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
            else:
                raise Inexpressible("a rank at a point is no identity")
        self.title = data["claim"]

    def text(self) -> str:
        """The file."""
        head = HEADER.format(title=self.title)
        body = [SECTION, *self.parts, "End Claims.\n"]
        printed = [f"Print Assumptions {name}." for name in self.names]
        return "\n".join([head, *(space.text() for space in self.spaces), *body, *printed]) + "\n"

    def _inverse(self, space: Space) -> None:
        change = space.data.get("change")
        if change is None:
            return
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
        raise Inexpressible("a refuted equation between vectors")


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
        f"  assert (X{k} : exists h, mul h h = val v {square} /\\ "
        f"val v {own} = div h (val v {below})).",
        f"  {{ exists (mul (val v {own}) (val v {below})). split.",
        f"    - transitivity (mul (val v (Mul {own} {own})) "
        f"(mul (val v {below}) (val v {below}))).",
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
        raise Inexpressible("a coordinate is no Gaussian rational")
    return f"({', '.join(parts)})"
