"""Counts and lists in words, and the two sentences with which a report begins."""

from __future__ import annotations

from collections.abc import Sequence

from kowalevski_cas.report.sections import count
from kowalevski_cas.systems import title
from kowalevski_cas.verify.outcome import Run, Verdict


def listed(items: Sequence[str], last: str = "and") -> str:
    """A list in words.

    >>> listed(["one", "two", "three"])
    'one, two and three'
    """
    return f" {last} ".join(filter(None, [", ".join(items[:-1]), *items[-1:]]))


def number(many: int) -> str:
    """A number in words, as far as they are shorter."""
    names = "no one two three four five six seven eight nine ten eleven twelve".split()
    return names[many] if many < len(names) else str(many)


def _are(many: int) -> str:
    return f"{many} is" if many == 1 else f"{many} are"


def opening(run: Run) -> tuple[str, str]:
    """What was found, and how."""
    return _found(run), _how(run)


def _found(run: Run) -> str:
    counts = count(run.outcomes)
    total = len(run.outcomes)
    proved, conditional = counts[Verdict.PROVED], counts[Verdict.CONDITIONAL]
    refuted = counts[Verdict.REFUTED]
    if not total:
        return "Nothing was selected, so nothing is said."
    if proved == total:
        many = "The one statement is" if total == 1 else f"All {total} formulas and statements are"
        return f"{many} proved as printed."
    parts = [f"{_are(proved)} proved as printed"]
    if conditional:
        hold = "holds" if conditional == 1 else "hold"
        parts.append(f"{conditional} {hold} under a condition that is named here")
    if refuted:
        parts.append(f"{_are(refuted)} refuted by an exact point")
    for verdict, what in (
        (Verdict.PROBABLE, "established but for a named chance of error"),
        (Verdict.ENCLOSED, "established within a named radius"),
    ):
        if counts[verdict]:
            parts.append(f"{_are(counts[verdict])} {what}")
    if open_ := sum(counts[v] for v in (Verdict.UNDECIDED, Verdict.TIMEOUT, Verdict.ERROR)):
        parts.append(f"{_are(open_)} left undecided")
    return f"Of {total} formulas and statements, {listed(parts)}."


def _how(run: Run) -> str:
    refuted = [o for o in run.outcomes if o.verdict is Verdict.REFUTED]
    mended = sum(o.correction is not None and o.correction.verdict.green for o in refuted)
    names = listed([title(a) for a in run.arithmetics])
    decided = [o for o in run.outcomes if o.verdicts]
    agreed = [o for o in decided if len(set(o.verdicts.values())) == 1]
    if len(decided) > len(agreed):
        disputed = listed([o.claim for o in decided if o not in agreed])
        how = f"the arithmetics disagree about {disputed}"
    elif len(run.arithmetics) > 1:
        every = [o for o in agreed if set(o.verdicts) >= set(run.arithmetics)]
        if len(run.outcomes) == 1:
            what = "the verdict was"
        elif len(every) == len(run.outcomes):
            what = "every verdict was"
        else:
            what = f"{len(every)} of the verdicts {'was' if len(every) == 1 else 'were'}"
        how = f"{what} reached by each of {names} on its own, without a disagreement"
    else:
        how = f"the arithmetic is {names or 'exact'}"
    if not refuted:
        return how[0].upper() + how[1:] + "."
    if mended == len(refuted):
        which = "the refuted one" if len(refuted) == 1 else "each of the refuted ones"
    else:
        which = f"{mended or 'none'} of the {len(refuted)} refuted"
    return f"For {which} the nearest true statement was found and proved; {how}."
