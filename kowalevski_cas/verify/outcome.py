"""What a run says about one claim: the verdict and the evidence behind it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from enum import StrEnum
from hashlib import sha256
from typing import NamedTuple

from kowalevski_cas.algebra import POINTS
from kowalevski_cas.notation import Edit, Formula, Name, Relation, Vocabulary, to_latex
from kowalevski_cas.paper.texts import Printed

CORRECTED = "corrected"
"""Before the names of certificates of corrections, and their folder."""

FALSE_AS_READ = "false as it was read"
"""The words for a claim that fails, and that may have been meant otherwise."""

Divided = tuple[tuple[Formula, ...], ...]
"""What is divided by, goal by goal."""

Value = Formula | str
"""A value at a point: exact, or what an arithmetic of points shows in place of that."""


class Verdict(StrEnum):
    """How sure the tool is. Only the first two are green; points say the next two."""

    PROVED = "proved"
    CONDITIONAL = "conditional"
    PROBABLE = "probable"
    ENCLOSED = "enclosed"
    REFUTED = "refuted"
    UNDECIDED = "undecided"
    TIMEOUT = "timeout"
    ERROR = "error"

    @property
    def green(self) -> bool:
        """Whether the statement is established, perhaps under named conditions."""
        return self in (Verdict.PROVED, Verdict.CONDITIONAL)

    @property
    def likely(self) -> bool:
        """Whether the statement is established, or nothing was seen at points that denies it."""
        return self.green or self in (Verdict.PROBABLE, Verdict.ENCLOSED)


DECIDED = (Verdict.PROVED, Verdict.CONDITIONAL, Verdict.REFUTED)
"""The verdicts that have a certificate."""

WORST = (
    Verdict.ERROR, Verdict.REFUTED, Verdict.TIMEOUT, Verdict.UNDECIDED, Verdict.PROBABLE,
    Verdict.ENCLOSED, Verdict.CONDITIONAL, Verdict.PROVED,
)  # fmt: skip


class PrintedPoint(NamedTuple):
    """A point: names, printed roots and levels, each with its value (rationals, i, roots)."""

    values: dict[Formula, Value]

    def __hash__(self) -> int:
        # a named tuple would hash its dictionary, which has no hash
        return hash(tuple(self.values.items()))


class Counterexample(NamedTuple):
    """An exact point on the constraints where the statement fails.

    ``left`` and ``right`` are the two values there; ``words`` says what fails
    when they are not the two sides of the equation that is claimed. By what is ``defined`` at
    these places they are computed from the coordinates.
    """

    point: PrintedPoint
    left: Value
    right: Value
    words: str = ""
    defined: tuple[tuple[Formula, Printed], ...] = ()


class Screened(NamedTuple):
    """What an arithmetic of points says about a statement."""

    verdict: Verdict
    message: str = ""
    counterexample: Counterexample | None = None
    chance: float | None = None
    radius: float | None = None


class Condition(NamedTuple):
    """An expression assumed non-zero, and what happens where it vanishes.

    ``zeros`` are equations that hold together exactly there, where these say it better. Where it is
    ``singular``, the differentials of a set are dependent there, by which it may be no manifold.
    """

    expression: Formula
    words: str
    witness: Counterexample | None = None
    zeros: tuple[Formula, ...] = ()
    singular: bool = False


class ReportedStep(NamedTuple):
    """One step that the program took, for the report: a sentence and what is displayed.

    With a ``point``, the sentence is about this point; what it speaks of and is ``withheld``,
    since it is too long, stands in the certificate.
    """

    words: str
    formulas: tuple[Formula, ...] = ()
    point: PrintedPoint | None = None
    withheld: bool = False


class Correction(NamedTuple):
    """The nearest true statement: its formulas, what was changed, its verdict, its digest.

    ``printed`` and ``edit`` say where, if one printed formula was changed, and ``accepted``
    that the derivation reads it in place of what is printed. ``certificate`` is the text that the
    checker has accepted, and ``divided`` what the judge divides by, goal by goal. If it is no
    formula of the claim that is wrong, but one on which it stands, ``blamed`` is what is printed
    there, and ``formulas`` are what should be; ``others`` are the true claims that stand on it as
    well, and stay true; ``besides`` are other misprints, which are to be mended with it for the
    claim to be true. A relation of constants that is to be supposed stands at a place of its own.
    """

    formulas: tuple[Formula, ...]
    words: str
    verdict: Verdict
    conditions: tuple[Condition, ...] = ()
    digest: str = ""
    printed: Printed | None = None
    edit: Edit | None = None
    accepted: bool = False
    certificate: str = ""
    divided: Divided = ()
    blamed: tuple[Formula, ...] = ()
    others: tuple[str, ...] = ()
    besides: tuple[Printed, ...] = ()

    @property
    def elsewhere(self) -> str:
        """The place that is mended, if it is none of the claim's own."""
        in_place = self.printed is None or (self.edit is not None and not self.blamed)
        return "" if in_place or self.printed is None else self.printed.place

    @property
    def supposed(self) -> str:
        """The constant that it gives by others, if it supposes a relation of these."""
        formula = self.formulas[0] if self.printed is not None and self.edit is None else None
        first = formula.members[0] if isinstance(formula, Relation) else None
        return first.name if isinstance(first, Name) else ""


class Outcome(NamedTuple):
    """Everything a run says about one claim.

    ``seconds`` and ``verdicts`` hold the measured time and the verdict of each arithmetic.
    ``chance`` bounds the probability that ``probable`` is wrong, ``radius`` that of the ball of
    ``enclosed``. ``formulas`` are those of the claim and ``source`` is how the paper prints them,
    which stands in for them where they cannot be read. ``granted`` lists what the scenes of the
    claim suppose not to vanish, ``branches`` the equations by which they choose one of the two
    values of a printed root, ``cites`` the claims whose displays the paper cites for it, and
    ``corrected`` the claims whose accepted corrections it rests on. What
    the paper does not claim is ``ours``. ``certificate`` is the text that the checker has accepted;
    without one nothing is proved, conditional or refuted; ``divided`` is what the judge divides by,
    goal by goal, in the names of the problem. A ``note`` is about a stored certificate
    that was rejected. An error that nobody expected has the ``stack`` of the process in which it
    arose. Words have mathematics between dollars.
    """

    claim: str
    section: str
    scene: str
    formulas: tuple[Formula, ...]
    source: str
    words: str
    verdict: Verdict
    conditions: tuple[Condition, ...] = ()
    steps: tuple[ReportedStep, ...] = ()
    counterexample: Counterexample | None = None
    correction: Correction | None = None
    alternatives: tuple[Correction, ...] = ()
    rests_on: tuple[str, ...] = ()
    cites: tuple[str, ...] = ()
    digest: str = ""
    message: str = ""
    seconds: Mapping[str, float] = {}
    verdicts: Mapping[str, Verdict] = {}
    chance: float | None = None
    radius: float | None = None
    granted: tuple[Formula, ...] = ()
    branches: tuple[Formula, ...] = ()
    corrected: tuple[str, ...] = ()
    ours: bool = False
    certificate: str = ""
    divided: Divided = ()
    note: str = ""
    stack: str = ""

    @property
    def needs_certificate(self) -> bool:
        """Whether there has to be a certificate; what points say has none."""
        return self.verdict in DECIDED and not self.verdicts.keys() & {*POINTS}

    @property
    def certificates(self) -> dict[str, str]:
        """The texts that the checker has accepted, by the names of their files."""
        found = {self.claim: self.certificate}
        if self.correction is not None:
            found[f"{CORRECTED}/{self.claim}"] = self.correction.certificate
        return found if self.needs_certificate else {}

    @property
    def misprinted(self) -> bool:
        """Whether a formula of the claim itself is to be corrected."""
        correction = self.correction
        return correction is not None and correction.edit is not None and not correction.blamed

    @property
    def spoiled(self) -> bool:
        """Whether it fails as printed, and is true as it stands once another formula is mended."""
        return self.correction is not None and bool(self.correction.blamed)

    def corrected_by(self, corrections: Sequence[Correction]) -> Outcome:
        """The outcome with the likeliest of some corrections, and the others as alternatives."""
        first, *others = (*corrections, None)
        return self._replace(correction=first, alternatives=tuple(filter(None, others)))


class Run(NamedTuple):
    """The outcomes of one derivation, in the order of the paper.

    ``sections`` lists number and heading; ``versions`` the programs and
    libraries that took part; in ``vocabulary`` the words of all outcomes can be read. ``edition``
    says which text was read, ``main`` which claims are the main results, and ``expected`` which
    verdicts the derivation itself expects.
    """

    derivation: str
    title: str
    author: str
    source: str
    sections: tuple[tuple[str, str], ...]
    outcomes: tuple[Outcome, ...]
    arithmetics: tuple[str, ...]
    versions: dict[str, str]
    vocabulary: Vocabulary
    edition: str = ""
    main: tuple[str, ...] = ()
    expected: Mapping[str, str] = {}

    @property
    def certificates(self) -> dict[str, str]:
        """The texts that the checker has accepted, by the names of their files."""
        return {n: text for outcome in self.outcomes for n, text in outcome.certificates.items()}

    @property
    def digest(self) -> str:
        """What binds the statements that were decided."""
        text = "\n".join(f"{outcome.claim} {outcome.digest}" for outcome in self.outcomes)
        return sha256(text.encode()).hexdigest()[:16]


def in_latex(formulas: Iterable[Formula]) -> str:
    """Formulas of one display in LaTeX."""
    return r",\ ".join(map(to_latex, formulas))


def as_recorded(formulas: tuple[Formula, ...], words: str, own: tuple[Formula, ...]) -> str:
    """A correction in LaTeX; in words if the formulas are the claim's ``own``, as for a number."""
    return words if formulas == own else in_latex(formulas)
