"""Results for a reader at a terminal."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Sequence

from kowalevski_cas.cli import plain
from kowalevski_cas.cli.formats import Result
from kowalevski_cas.verify.outcome import Outcome, Run, Verdict

MARKS = {
    Verdict.PROVED: ("✓", "32"),
    Verdict.CONDITIONAL: ("◐", "36"),
    Verdict.REFUTED: ("✗", "31"),
    Verdict.PROBABLE: ("≈", "34"),
    Verdict.ENCLOSED: ("≈", "34"),
}
"""Mark and colour; everything else is a question."""


def render(results: Sequence[Result]) -> str:
    """Each derivation: its claims by section, the errata, and a summary."""
    colour = sys.stdout.isatty()
    return "\n".join(_derivation(result, colour) for result in results)


def _derivation(result: Result, colour: bool) -> str:
    run = result.run
    title = plain.words(run.title, run.vocabulary)
    lines = [". ".join(filter(None, (run.author, title))), run.source]
    for number, title in run.sections:
        outcomes = [o for o in run.outcomes if o.section == number]
        if outcomes:
            head = f"{number}. {plain.words(title, run.vocabulary)}"
            lines += ["", head, *(_line(o, colour) for o in outcomes)]
    lines += _errors(result)
    lines += _errata(run)
    lines += _restrictions(run)
    lines += ["", _summary(result)]
    return "\n".join(lines) + "\n"


def _line(outcome: Outcome, colour: bool) -> str:
    mark, code = MARKS.get(outcome.verdict, ("?", "33"))
    head = f"{mark} {outcome.verdict:<11}"
    if colour:
        head = f"\x1b[{code}m{head}\x1b[0m"
    notes = [plain.where(outcome.conditions)] if outcome.conditions else []
    if outcome.verdict is Verdict.REFUTED:
        notes = ["see the errata"]
    if outcome.branches:
        notes.append(f"with {plain.formulas(outcome.branches)}")
    if outcome.corrected:
        notes.append(f"with the correction of {', '.join(outcome.corrected)}")
    if outcome.chance is not None:
        notes.append(f"wrong with probability below {outcome.chance:.0e}")
    if outcome.radius is not None:
        notes.append(f"within {outcome.radius:.0e}")
    if outcome.message and outcome.verdict is not Verdict.REFUTED and not outcome.verdict.green:
        notes.append(outcome.message if "\n" not in outcome.message else "see the errors")
    time = f"{1000 * sum(outcome.seconds.values()):8.1f} ms"
    return f"  {outcome.claim:<20} {head} {time}  {'; '.join(notes)}".rstrip()


def _errors(result: Result) -> list[str]:
    """Formulas that cannot be read, with the place where they stand."""
    lines: list[str] = []
    for outcome in result.run.outcomes:
        if outcome.verdict is Verdict.ERROR:
            file, number = result.line(outcome.claim)
            first, *rest = outcome.message.splitlines()
            lines += [f"  {file}:{number}: {first}", *(f"    {line}" for line in rest)]
    if not lines:
        return []
    advice = "  Mend the formula, or declare its names on the scene of the claim."
    return ["", "Errors", *lines, advice]


def _errata(run: Run) -> list[str]:
    wrong = [o for o in run.outcomes if o.verdict is Verdict.REFUTED]
    if not wrong:
        return []
    lines = ["", "Errata"]
    for outcome in wrong:
        said = f"  ({plain.words(outcome.words, run.vocabulary)})" if outcome.words else ""
        lines.append(f"  {outcome.claim}{said}")
        lines.append(f"    printed   {plain.formulas(outcome.formulas, outcome.source)}")
        correction = outcome.correction
        if correction is None:
            lines.append("    correct   no true statement was found one edit away")
        else:
            where = [plain.where(correction.conditions)] if correction.conditions else []
            accepted = ["accepted by the derivation"] if correction.accepted else []
            status = ", ".join([correction.verdict, *where, *accepted])
            shown = f"{plain.formulas(correction.formulas)}   ({status})"
            said = plain.words(correction.words, run.vocabulary)
            lines += [f"    correct   {shown}", f"    that is   {said}"]
        if outcome.counterexample is not None:
            lines += plain.evidence(outcome.counterexample, run.vocabulary)
    return lines


def _restrictions(run: Run) -> list[str]:
    """Statements that fail somewhere, with a point where they do."""
    lines: list[str] = []
    for outcome in run.outcomes:
        for condition in outcome.conditions:
            if condition.witness is not None:
                lines.append(f"  {outcome.claim}  {plain.needs(condition, run.vocabulary)}")
                lines += plain.evidence(condition.witness, run.vocabulary)
    return ["", "Conditions that are not stated", *lines] if lines else []


def _summary(result: Result) -> str:
    run = result.run
    counts = Counter(o.verdict for o in run.outcomes)
    shown = ", ".join(f"{count} {verdict}" for verdict, count in counts.items())
    seconds = sum(sum(o.seconds.values()) for o in run.outcomes)
    head = f"{len(run.outcomes)} claims: {shown}; {', '.join(run.arithmetics)}; {seconds:.2f} s"
    noun, other = (
        ("recorded", "THE RECORD") if result.recorded else ("expected", "WHAT IS EXPECTED")
    )
    if not result.differences:
        none = "; there is no record to compare with (`kowalevski-cas record`)"
        return f"{head}; as {noun}{'' if result.recorded else none}"
    lines = [f"{head}; DIFFERENT FROM {other}:"]
    lines += [f"  {d.claim}: {noun} {d.recorded}, found {d.found}" for d in result.differences]
    return "\n".join(lines)
