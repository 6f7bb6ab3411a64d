"""Results claim by claim, with the evidence against what is false, at a terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kowalevski_cas.cli import plain
from kowalevski_cas.cli.formats import Result
from kowalevski_cas.cli.formats.pretty import contents_of, told
from kowalevski_cas.report import Contents, Evidence, Phrases
from kowalevski_cas.verify.outcome import Outcome, Verdict


def render(results: Sequence[Result]) -> str:
    """Each derivation with all its claims, section by section."""
    return "\n".join(told(result, _claims(result)) for result in results)


def _claims(result: Result) -> Iterator[str]:
    contents = contents_of(result)
    for section in contents.sections:
        name = contents.phrases.words(f"{section.number}. {section.title}")
        yield from ("", *plain.wrapped(plain.text(name)))
        for outcome in section.outcomes:
            yield from _claim(outcome, contents)


def _claim(outcome: Outcome, contents: Contents) -> Iterator[str]:
    """A line with the time that it took, and what a reader has to know of it."""
    time = f"{1000 * sum(outcome.seconds.values()):8.1f} ms"
    first = f"{plain.sign(outcome.verdict, f'{outcome.claim:<22}')} {time}  "
    yield from plain.wrapped("; ".join(_notes(outcome, contents.phrases)), first, 4)
    if outcome.verdict is not Verdict.ERROR:
        yield from plain.lines(Evidence(contents.phrases, (outcome,)).first(), 8)


def _notes(outcome: Outcome, phrases: Phrases) -> Iterator[str]:
    """What a verdict depends on."""
    yield str(outcome.verdict)
    where = [c for c in outcome.conditions if c.witness is None]
    if where:
        yield plain.text(("valid for ", *phrases.where(where)))
    if outcome.branches:
        yield f"with {plain.formulas(outcome.branches)}"
    if outcome.corrected:
        yield f"with the correction of {', '.join(outcome.corrected)}"
    if outcome.chance is not None:
        yield f"wrong with probability below {outcome.chance:.0e}"
    if outcome.radius is not None:
        yield f"within {outcome.radius:.0e}"
