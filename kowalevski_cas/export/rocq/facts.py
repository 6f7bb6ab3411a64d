"""The hypotheses about a space or a goal, and what proofs know of its roots and divisors."""

from __future__ import annotations

from kowalevski_cas.export.rocq.elements import Plain, Term, number, polynomial_text, sum_text
from kowalevski_cas.export.rocq.space import Space

AT = "R zero one add mul sub opp div inv R_field v"
"""What each lemma about values takes first."""

VALUES = "R zero one add mul opp div v"
"""What each statement about values takes first."""


class Facts:
    """Hypotheses, lemmas and a tactic at the beginning of a section.

    The facts are equations whose left sides are monomials: a root times itself, and a
    number or name that is not zero times its inverse. They bring polynomials into normal
    forms, since each has a product of its own. Where other polynomials are divided by,
    equations are multiplied by powers of them, which are not zero.
    """

    def __init__(self, space: Space) -> None:
        self.space, self.k = space, space.label
        self._lines: list[str] = []
        self._facts = self._under = 0

    def text(self) -> str:
        """The hypotheses, lemmas and the tactic."""
        space, k = self.space, self.k
        inverses = dict(space.inverses())
        squares = {name: space.elements.terms(e) for name, e in space.checked.ring.roots.items()}
        self._number = number(
            [t for terms in (*inverses.values(), *squares.values()) for t in terms]
        )
        if self._number > 1:
            self._lines.append(f"Hypothesis number_{k} : val {self._number} <> zero.")
        for j, text in enumerate(space.conditions()):
            self._lines.append(f"Hypothesis nonzero_{k}_{j} : val ({text}) <> zero.")
        for j, (name, square) in enumerate(space.squares.items()):
            own = space.term(name)
            equation = f"val ({own} * {own}) = val ({space.term(square)})"
            self._lines.append(f"Hypothesis root_{k}_{j} : {equation}.")
        self._lines += [
            f"\nDefinition order_{k} : list expr :=\n  [{'; '.join(self._unknowns())}].",
            f"Definition facts_{k}_0 : equations := [].",
            f"Lemma hold_{k}_0 : hold {VALUES} facts_{k}_0.\nProof. exact I. Qed.",
            f"Definition under_{k}_0 : table := [].",
            f"Lemma sound_under_{k}_0 : sound {VALUES} under_{k}_0.\nProof. exact I. Qed.\n",
        ]
        if self._number > 1:
            proof = f"exact (reciprocal {AT} _ number_{k})."
            self._fact(f"{self._number} * (1 / {self._number})", "1", proof)
        numbers = {text: terms for text, terms in inverses.items() if not any(map(_moves, terms))}
        self._table("numbers", numbers)
        for j, plain in enumerate(space.elements.plain):
            self._plain(j, plain)
        for j, (name, terms) in enumerate(squares.items()):
            within = space.divisors_in(space.squares[name])
            self._table(f"over_{j}", {text: inverses[text] for text in inverses if text in within})
            own, equal = space.term(name), self._equal(f"over_{j}")
            proof = f"etransitivity; [exact root_{k}_{j}|{equal}]."
            self._fact(f"{own} * {own}", self._without_division(terms), proof)
        self._table("known", inverses)
        self._lines.append(f"Ltac by_known_{k} := {self._equal('known')}.\n")
        return "\n".join(self._lines)

    def _without_division(self, terms: list[Term]) -> str:
        return self.space.term(polynomial_text(terms, self._number))

    def _unknowns(self) -> list[str]:
        """In what all is a polynomial: roots, names after their inverses, one over a number."""
        space = self.space
        divided = {plain.tree for plain in space.elements.plain if isinstance(plain.tree, str)}
        found = list[str]()
        for name in sorted(space.names, key=lambda name: name not in space.squares):
            shown = space.term(name)
            found += [f"1 / {shown}", shown] if name in divided else [shown]
        return [*found, f"1 / {self._number}"] if self._number > 1 else found

    def _fact(self, left: str, right: str, proof: str) -> None:
        """One more equation that holds."""
        old, self._facts = self._facts, self._facts + 1
        k, n = self.k, self._facts
        self._lines += [
            f"Definition facts_{k}_{n} : equations :=\n  ({left}, {right}) :: facts_{k}_{old}.",
            f"Lemma hold_{k}_{n} : hold {VALUES} facts_{k}_{n}.",
            f"Proof. split; [{proof[:-1]}|exact hold_{k}_{old}]. Qed.\n",
        ]

    def _plain(self, j: int, plain: Plain) -> None:
        """What is not zero by a condition has an inverse."""
        space, k, shown = self.space, self.k, self.space.term(plain.tree)
        cofactor = space.term(sum_text(space.elements.terms(plain.cofactor)))
        self._lines += [
            f"Lemma plain_{k}_{j} : val ({shown}) <> zero.",
            f"Proof. apply (factor {AT} _ ({cofactor}) _ nonzero_{k}_{plain.condition}); "
            f"{self._equal('numbers')}. Qed.",
        ]
        if isinstance(plain.tree, str):
            proof = f"exact (reciprocal {AT} _ plain_{k}_{j})."
            self._fact(f"{shown} * (1 / {shown})", "1", proof)
            return
        old, self._under = self._under, self._under + 1
        n, terms = self._under, self._without_division(space.elements.terms(plain.element))
        self._lines += [
            f"Definition under_{k}_{n} : table :=\n  ({terms}, 1 / ({shown})) :: under_{k}_{old}.",
            f"Lemma sound_under_{k}_{n} : sound {VALUES} under_{k}_{n}.",
            f"Proof. split; [apply (inverted {AT} _ _ plain_{k}_{j}); "
            f"{self._equal('numbers', old)}|exact sound_under_{k}_{old}]. Qed.\n",
        ]

    def _table(self, label: str, inverses: dict[str, list[Term]]) -> None:
        """Divisors with their inverses."""
        k, name = self.k, f"{label}_{self.k}"
        rows = [
            f"({text}, {self._without_division(terms)})"
            for text, terms in reversed(inverses.items())
        ]
        self._lines += [
            f"Definition {name} : table :=\n  [" + ";\n   ".join(rows) + "].",
            f"Lemma sound_{name} : sound {VALUES} {name}.",
            f"Proof. apply (all_sound {AT} under_{k}_{self._under} order_{k} "
            f"facts_{k}_{self._facts} _ sound_under_{k}_{self._under} hold_{k}_{self._facts}); "
            "vm_compute; reflexivity. Qed.\n",
        ]

    def _equal(self, label: str, under: int | None = None) -> str:
        """The tactic that proves equations with a table of divisors, and with all facts so far."""
        k, name, u = self.k, f"{label}_{self.k}", self._under if under is None else under
        return (
            f"apply (decided {AT} under_{k}_{u} order_{k} facts_{k}_{self._facts} {name} "
            f"_ _ sound_under_{k}_{u} hold_{k}_{self._facts} sound_{name}); vm_compute; reflexivity"
        )


def _moves(term: Term) -> bool:
    """Whether a term is more than a number."""
    return bool(term.powers or term.under)
