"""What a system answers: what it has a name for, and what is claimed of it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from html import escape
from typing import Any

from kowalevski_cas.notation import Formula, print_prose, read_prose, to_plain
from kowalevski_cas.notation.mathml import to_mathml
from kowalevski_cas.notation.sympy import to_sympy
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.derivation import Derivation, Section
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.verify.outcome import Counterexample, Outcome, Verdict, in_latex
from kowalevski_cas.verify.run import Session


class HasFormulas:
    """Something with formulas: in a notebook, in LaTeX, and for SymPy."""

    formulas: tuple[Formula, ...]
    symbols: Mapping[str, Any]
    """The symbols of SymPy in which a system is written, by their names here."""

    def sympy(self) -> Any:
        """The formula as an expression of SymPy, or a list if there are several."""
        found = [to_sympy(formula, self.symbols) for formula in self.formulas]
        return found[0] if len(found) == 1 else found

    def __repr__(self) -> str:
        return ", ".join(map(to_plain, self.formulas))

    def _repr_latex_(self) -> str:
        return f"${in_latex(self.formulas)}$"


class Function(HasFormulas):
    """What a system has a name for; it stands for that name wherever LaTeX is taken."""

    def __init__(
        self, place: Printed, name: str, formula: Formula, symbols: Mapping[str, Any]
    ) -> None:
        self.place, self.name, self.symbols = place, name, symbols
        self.formulas = (formula,)
        """The equation that defines it."""


class SystemClaim(HasFormulas):
    """A claim about a system. It is decided when something is asked of it."""

    def __init__(
        self, claim: Claim, section: Section, symbols: Mapping[str, Any], seconds: float
    ) -> None:
        self.claim, self.section, self.symbols, self.seconds = claim, section, symbols, seconds

    @cached_property
    def outcome(self) -> Outcome:
        """All that a run says about it, with FLINT, in the seconds that it has."""
        derivation = Derivation("", "", "", "", (self.section,))
        return Session(derivation, ["flint"], timeout=self.seconds).run([self.claim.id]).outcomes[0]

    @property
    def verdict(self) -> Verdict:
        """Whether it is proved, perhaps under conditions, refuted, or not decided."""
        return self.outcome.verdict

    @property
    def formulas(self) -> tuple[Formula, ...]:  # type: ignore[override] # computed here, an attribute above
        """What is claimed, as it is read."""
        return self.outcome.formulas

    @property
    def conditions(self) -> tuple[Formula, ...]:
        """The expressions that are supposed not to vanish."""
        return tuple(condition.expression for condition in self.outcome.conditions)

    @property
    def counterexample(self) -> Counterexample | None:
        """An exact point at which it fails."""
        return self.outcome.counterexample

    def __repr__(self) -> str:
        return self._sentence(to_plain, str, "{}").strip()

    def _repr_html_(self) -> str:
        return f"<p>{self._sentence(in_html, escape, '<b>{}</b>')}</p>"

    def _sentence(
        self, shown: Callable[[Formula], str], said: Callable[[str], str], mark: str
    ) -> str:
        """The verdict and its conditions, what is claimed, where it fails, what is not decided."""
        own = self.outcome
        words = read_prose(own.words, vocabulary((self.claim.scene,)))
        where = ", ".join(f"{shown(formula)} ≠ 0" for formula in self.conditions)
        found = [f"where {where}"] if where else []
        found += [print_prose(words, said, shown), ", ".join(map(shown, self.formulas))]
        values = own.counterexample.point.values.items() if own.counterexample else ()
        at = ", ".join(
            f"{shown(name)} = {said(value) if isinstance(value, str) else shown(value)}"
            for name, value in values
            if name != value  # as the imaginary unit
        )
        found += [f"not at {at}"] if at else []
        if (one := own.correction) is not None:
            meant = print_prose(read_prose(one.words, vocabulary((self.claim.scene,))), said, shown)
            wrong = ", ".join(map(shown, one.blamed))
            found += [f"it holds with another formula than {wrong}" if wrong else "correct"]
            found[-1] += f": {meant}, {', '.join(map(shown, one.formulas))}"
        found += [said(own.message)] if own.message else []
        return f"{mark.format(own.verdict)}: {'; '.join(filter(None, found))}"


class ClaimInParts(SystemClaim):
    """Claims that are one print, as for both signs: it is as true as the worst of them."""

    def __init__(self, parts: tuple[SystemClaim, ...]) -> None:
        first = parts[0]
        super().__init__(first.claim, first.section, first.symbols, first.seconds)
        self.parts = parts

    @cached_property
    def outcome(self) -> Outcome:
        """That of the worst part: false, or not decided, or true under conditions."""
        order = (Verdict.PROVED, Verdict.CONDITIONAL)
        found = [part.outcome for part in self.parts]
        red = (outcome for outcome in found if outcome.verdict is Verdict.REFUTED)
        open_ones = (outcome for outcome in found if outcome.verdict not in order)
        worse = max(found, key=lambda outcome: outcome.verdict is Verdict.CONDITIONAL)
        return next(red, next(open_ones, worse))


class SystemClaims(list[SystemClaim]):
    """What a question has found, in its order; a notebook shows it as a list."""

    def _repr_html_(self) -> str:
        return "".join(claim._repr_html_() for claim in self) or "<p>nothing was found</p>"


def in_html(formula: Formula) -> str:
    """A formula in a page."""
    return f"<math>{to_mathml(formula)}</math>"
