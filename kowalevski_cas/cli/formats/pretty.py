"""Results for a reader at a terminal: the answer, what is wrong, and a summary."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

from kowalevski_cas.cli import plain
from kowalevski_cas.cli.formats import Result
from kowalevski_cas.report import Contents
from kowalevski_cas.report.places import names
from kowalevski_cas.verify.outcome import Verdict


def render(results: Sequence[Result]) -> str:
    """Each derivation with what was found in it, each slip once."""
    return "\n".join(told(result) for result in results)


def told(result: Result, claims: Iterable[str] = ()) -> str:
    """A derivation; lines on its ``claims`` stand before the summary."""
    run, contents = result.run, contents_of(result)
    named = filter(None, (run.author, run.title, run.source))
    title = contents.phrases.words("".join(f"{part}. " for part in named))
    lines = [
        *plain.wrapped(plain.text(title)),
        "",
        *plain.wrapped(contents.findings.lead()),
        *plain.lines(contents.findings.blocks()),
        *_errors(result),
        *claims,
        "",
        *_summary(result),
    ]
    return "\n".join(lines) + "\n"


def contents_of(result: Result) -> Contents:
    """What a report of the results would say, where claims without a number have their ids."""
    known = names(result.paper).items()
    called = {claim: name for claim, name in known if name.near or name.number.startswith("(")}
    return Contents(result.run, result.paper, called, {}, ())


def _errors(result: Result) -> Iterator[str]:
    """Formulas that cannot be read, with the place where they stand."""
    wrong = [o for o in result.run.outcomes if o.verdict is Verdict.ERROR]
    if wrong:
        yield from ("", "Errors")
    for outcome in wrong:
        file, number = result.line(outcome.claim)
        first, *rest = outcome.message.splitlines()
        yield f"  {file}:{number}: {first}"
        yield from (f"    {line}" for line in rest)
    if wrong:
        yield "  Mend the formula, or declare its names on the scene of the claim."


def _summary(result: Result) -> Iterator[str]:
    run = result.run
    counts = Counter(o.verdict for o in run.outcomes)
    shown = ", ".join(f"{count} {verdict}" for verdict, count in counts.items())
    seconds = sum(sum(o.seconds.values()) for o in run.outcomes)
    claims = f"{len(run.outcomes)} claim{'s' * (len(run.outcomes) != 1)}"
    head = f"{claims}: {shown}; {', '.join(run.arithmetics)}; {seconds:.2f} s"
    noun, other = (
        ("recorded", "THE RECORD") if result.recorded else ("expected", "WHAT IS EXPECTED")
    )
    if not result.differences:
        none = "; there is no record to compare with (`kowalevski-cas record`)"
        yield f"{head}; as {noun}{'' if result.recorded else none}"
    else:
        yield f"{head}; DIFFERENT FROM {other}:"
        for one in result.differences:
            yield f"  {one.claim}: {noun} {one.recorded}, found {one.found}"
