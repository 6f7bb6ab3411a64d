"""The hypotheses about a space, and what ``ring`` has to know of its roots and divisors."""

from __future__ import annotations

from kowalevski_cas.export.rocq.elements import Plain, Term, number, undivided, written
from kowalevski_cas.export.rocq.space import Space

AT = "R zero one add mul sub opp div inv R_field v"
"""What each lemma about values takes first."""


class Facts:
    """Hypotheses, lemmas and tactics at the beginning of a section.

    The facts are equations whose left sides are monomials: a root times itself, and
    what is not zero times its inverse. With them ``ring`` finds normal forms, if the
    names in such a product follow one another in its list of names: otherwise it does
    not see the product in others. An equation of something with itself makes the list so.
    """

    def __init__(self, space: Space) -> None:
        self.space, self.k = space, space.k
        self._lines: list[str] = []
        self._facts: list[str] = []
        self._inverses: dict[str, list[str]] = {}

    def text(self) -> str:
        """The hypotheses, lemmas and tactics."""
        space, k = self.space, self.k
        inverses = dict(space.inverses())
        squares = {name: space.elements.terms(e) for name, e in space.checked.roots.items()}
        self._number = number(
            [t for terms in (*inverses.values(), *squares.values()) for t in terms]
        )
        one_over = self._number
        if one_over > 1:
            self._lines.append(f"Hypothesis number_{k} : val {one_over} <> zero.")
        for j, tree in enumerate(space.checked.nonzero):
            self._lines.append(f"Hypothesis nonzero_{k}_{j} : val ({space.term(tree)}) <> zero.")
        for j, (name, square) in enumerate(space.squares.items()):
            own = space.term(name)
            equation = f"val ({own} * {own}) = val ({space.term(square)})"
            self._lines.append(f"Hypothesis root_{k}_{j} : {equation}.")
        self._lines.append("")
        if one_over > 1:
            proof = f"exact (reciprocal {AT} _ number_{k})."
            self._fact(f"{one_over} * (1 / {one_over})", "1", proof)
        numbers = {text: terms for text, terms in inverses.items() if not any(map(_moves, terms))}
        self._table("numbers", numbers)
        for plain in sorted(space.elements.plain, key=lambda plain: isinstance(plain.tree, str)):
            self._plain(plain)
        for j, (name, terms) in enumerate(squares.items()):
            under = space.divisors_in(space.squares[name])
            self._table(f"under_{j}", {text: inverses[text] for text in inverses if text in under})
            own, equal = space.term(name), self._equal(f"under_{j}")
            proof = f"etransitivity; [exact root_{k}_{j}|{equal}]."
            self._fact(f"{own} * {own}", self._undivided(terms), proof)
        self._table("known", inverses)
        self._lines.append(f"Ltac by_known_{k} := {self._equal('known')}.\n")
        return "\n".join(self._lines)

    def _undivided(self, terms: list[Term]) -> str:
        return self.space.term(undivided(terms, self._number))

    def _fact(self, left: str, right: str, proof: str) -> None:
        name = f"fact_{self.k}_{len(self._facts)}"
        self._facts.append(name)
        self._lines.append(f"Lemma {name} : val ({left}) = val ({right}).\nProof. {proof} Qed.")

    def _plain(self, plain: Plain) -> None:
        """What is not zero by a condition, times its inverse: one, or its leading part."""
        space, shown = self.space, self.space.term(plain.tree)
        condition = f"plain_{self.k}_{len(self._facts)}"
        cofactor = space.term(written(space.elements.terms(plain.cofactor)))
        self._lines.append(
            f"Lemma {condition} : val ({shown}) <> zero.\n"
            f"Proof. intros H; apply nonzero_{self.k}_{plain.condition}; "
            f"transitivity (val (({shown}) * ({cofactor}))); [{self._equal('numbers')}|"
            f"change (mul (val ({shown})) (val ({cofactor})) = zero); rewrite H; ring]. Qed."
        )
        if isinstance(plain.tree, str):
            self._inverses.setdefault(plain.tree, []).append(f"1 / {shown}")
            self._fact(f"{shown} * (1 / {shown})", "1", f"exact (reciprocal {AT} _ {condition}).")
            return
        terms = space.elements.terms(plain.element)
        terms.sort(key=self._unfit)
        for name in terms[0].powers:
            self._inverses.setdefault(name, []).append(f"1 / ({shown})")
        lead, rest = self._undivided(terms[:1]), self._undivided(terms[1:])
        proof = (
            f"etransitivity; [|exact (reciprocal {AT} _ {condition})]; {self._equal('numbers')}."
        )
        self._fact(
            f"({lead}) * (1 / ({shown}))",
            f"1 - ({rest}) * (1 / ({shown}))",
            f"apply (leading {AT}); {proof}",
        )

    def _unfit(self, term: Term) -> tuple[bool, int, int]:
        """How little a term is fit to be the leading one: best is a power of a fresh name."""
        others = [len(self._inverses.get(name, ())) for name in term.powers]
        return abs(term.coefficient) != 1, abs(len(others) - 1), sum(others)

    def _table(self, label: str, inverses: dict[str, list[Term]]) -> None:
        """Divisors with their inverses."""
        k = self.k
        rows = [f"({text}, {self._undivided(terms)})" for text, terms in reversed(inverses.items())]
        self._lines += [
            f"Definition {label}_{k} : table :=\n  [" + ";\n   ".join(rows) + "].",
            f"Lemma sound_{label}_{k} : sound R zero one add mul opp div v {label}_{k}.",
            f"Proof. unfold {label}_{k}. "
            f"repeat (apply (sound_more {AT}); [|{self._ring()}]). exact I. Qed.\n",
        ]

    def _equal(self, label: str) -> str:
        """The tactic that proves equations with a table of divisors."""
        name = f"{label}_{self.k}"
        return f"apply (plainly {AT} {name} _ _ sound_{name}); {self._ring()}"

    def _ring(self) -> str:
        """The tactic that proves equations with all facts so far."""
        if not self._facts:
            return "cbv; ring"
        facts = list(self._facts)
        if self._inverses:
            rows = ([*i[:1], self.space.term(n), *i[1:]] for n, i in self._inverses.items())
            order = " * ".join(f"({text})" for row in rows for text in row)
            facts.append(f"(eq_refl (mul w (val ({order}))))")
        names = [f"H{j}" for j in range(len(facts))]
        posed = "".join(f"pose proof {f} as {h}; " for f, h in zip(facts, names, strict=True))
        return f"{posed}cbv in {', '.join(names)} |- *; ring [{' '.join(names)}]"


def _moves(term: Term) -> bool:
    """Whether a term is more than a number."""
    return bool(term.powers or term.under)
