"""What would mend claims that are false as they were read: it is told, and corrects nothing."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence

from kowalevski_cas.audit.audited import OPEN, Audited
from kowalevski_cas.paper.transcendental import PI
from kowalevski_cas.reading import CLAIM, JudgedStatement, Reading
from kowalevski_cas.reading.known import Known
from kowalevski_cas.reading.oddities import oddities, stranger
from kowalevski_cas.reading.small_oscillations import letters_for
from kowalevski_cas.verify.blame import Blame
from kowalevski_cas.verify.outcome import FALSE_AS_READ, Correction, Outcome, Verdict, in_latex
from kowalevski_cas.verify.run import Session, correct_together

AS_FREE = "taken as free"
"""The words for letters of which nothing is known."""

OF_A_PLACE = "it does not hold always, and its words may say where, or when, it does"
"""The words for what may be said of one place, or of one time."""

OFTEN = 3
"""In so many statements a letter is no slip."""

SECONDS = 2.0
"""For the search of what would mend a claim."""


def repairs_of_doubted(
    session: Session, outcomes: Mapping[str, Outcome], explained: Collection[str]
) -> dict[str, Correction]:
    """The likeliest repair of each claim that is false as it was read, if one is proved.

    It is of what such claims share, or of the formula of one, or of another one on which it stands;
    what is ``explained`` needs none.
    """
    doubted = (one for id, one in outcomes.items() if id not in explained)
    failing = [one for one in doubted if is_false_as_read(one)]
    suspected = [one._replace(verdict=Verdict.REFUTED, message="") for one in failing]
    verdicts = {id: one.verdict for id, one in outcomes.items()}
    known = [id for id, verdict in verdicts.items() if verdict is Verdict.REFUTED]
    verdicts |= {one.claim: one.verdict for one in suspected}
    blame = Blame(session.decider.corrector, verdicts, known, SECONDS)
    found = correct_together(session, suspected, blame)
    return {one.claim: one.correction for one in found if one.correction is not None}


def how_read(formula: JudgedStatement, known: Known) -> str:
    """That a claim is false as it was read, and which of its letters were taken as free.

    These are constants that no equation defines or supposes anything of, and no law has: any value
    may stand for them. The number π is none of them, though it has no value either, nor the letter
    of what is said to be an eigenvalue.
    """
    free = free_letters(formula, known)
    if not free:
        return FALSE_AS_READ
    names = " and ".join(filter(None, [", ".join(f"${n}$" for n in free[:-1]), f"${free[-1]}$"]))
    was, them = ("was", "it") if len(free) == 1 else ("were", "them")
    ties = f" or ties {them} to the motion" if known.laws else ""
    return f"{FALSE_AS_READ}: {names} {was} {AS_FREE}, since no equation defines {them}{ties}"


def free_letters(formula: JudgedStatement, known: Known) -> list[str]:
    """The constants in a claim that were taken as free."""
    assert formula.claim is not None
    supposed = {name for one in formula.on for name in one.names}
    supposed |= letters_for(formula.item, known)
    untied = known.untied(formula.claim.scene.constants)
    return [name for name in untied if name not in supposed | {PI}]


def needs_words(formula: JudgedStatement, known: Known) -> bool:
    """Whether a claim has a letter that the paper has often, and explains in words alone.

    It is no slip, and no repair of a formula would be what was meant.
    """
    often = Counter(name for one in known.items for name in one.names)
    return any(often[name] >= OFTEN for name in free_letters(formula, known))


def is_false_as_read(outcome: Outcome) -> bool:
    """Whether a claim fails, and may have been meant otherwise."""
    return outcome.verdict is Verdict.UNDECIDED and outcome.message == FALSE_AS_READ


def point_at(found: Sequence[Audited], repairs: Mapping[str, Correction], reading: Reading) -> None:
    """Say of claims that are not decided with what they would hold, or what is strange there.

    The formula where that stands is their cause.
    """
    by_place = {formula.item.printed: formula for formula in reading.formulas}
    lines = {audited.place: audited.line for audited in found}
    for audited in found:
        failed = audited.verdict in (OPEN, Verdict.UNDECIDED)
        if audited.role != CLAIM or audited.causes or not failed or audited.place is None:
            continue
        said, formula = [audited.message], by_place[audited.place]
        known = reading.parts.of(formula.item)
        if repair := next((repairs[id] for id in audited.claims if id in repairs), None):
            said.append(f"it holds with ${in_latex(repair.formulas)}$")
            strange = [*stranger(formula.item, repair.supposed, known)]
        else:
            strange = [*oddities(formula.item, formula.on, known)]
        here = [one for one in strange if one.item.printed in lines]
        audited.causes = (*dict.fromkeys(one.item.printed.place for one in here),)
        if repair and not here:
            audited.causes = (repair.elsewhere or audited.name,)
        where: dict[str, dict[int, None]] = {}
        for one in (one for one in here if one.words != audited.message):
            where.setdefault(one.words, {})[lines[one.item.printed]] = None
        said += [
            f"{words} (line{'s' * (len(at) > 1)} {', '.join(map(str, at))})"
            for words, at in where.items()
        ]
        audited.message = "; ".join(dict.fromkeys(said))
