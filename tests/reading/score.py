"""What a reading makes of a paper of which the truth is known, formula by formula."""

import json
import re
from collections import Counter
from dataclasses import dataclass, field

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.notation import Relation
from kowalevski_cas.reading import read
from kowalevski_cas.source.files import read_source
from kowalevski_cas.verify.outcome import Verdict

SAME = {
    "level": {"notation", "definition", "claim"},
    "other": {"notation", "other"},
    "notation": {"notation", "other"},
}
"""Roles of the truth that a role here may stand for."""
_LAYOUT = re.compile(
    r"[\s&.,;$]|\\label\{[^}]*\}|\\\\(\[\w+\])?|\\[,;]|\\q?quad|\\nonumber|\\(?:begin|end)\{\w+\}|\{\}"
)


@dataclass
class Score:
    """How many roles and verdicts are right, and what is wrong."""

    roles: Counter = field(default_factory=Counter)
    claims: Counter = field(default_factory=Counter)
    wrong: list = field(default_factory=list)


def score(path):
    """The score of a paper with the truth beside it."""
    reading = read(read_source(path))
    outcomes = ReadingSession(reading, timeout=5).outcomes
    truth = json.loads(path.with_suffix(".json").read_text(encoding="utf-8"))
    found = Score()
    for one in truth:
        if one.get("sentence"):
            continue
        here = matching(reading, one)
        roles = {formula.role.name for formula in here}
        right = bool(here) and all(
            r == one["role"] or one["role"] in SAME.get(r, ()) for r in roles
        )
        found.roles[right] += 1
        if not right:
            found.wrong.append((one["line"], one["tex"], one["role"], [f.role for f in here]))
        if one["role"] == "claim":
            verdicts = [outcomes[f.claim.id].verdict for f in here if f.claim is not None]
            verdict = judged(verdicts)
            truth_of = f"{one['true']}/{one.get('as_printed', '')}"
            found.claims[f"{truth_of} {verdict}"] += 1
            if not (one["true"] is True and verdict == "green"):
                messages = [
                    f.message or outcomes[f.claim.id].message if f.claim else f.message
                    for f in here
                ]
                found.wrong.append(
                    (one["line"], one["tex"], truth_of, one.get("kind"), verdict, messages)
                )
    return found


def matching(reading, one):
    """The statements of a reading that an entry of the truth is about."""
    first, last = one["line"], one.get("until", one["line"])
    wanted = bared(one["tex"])
    source = reading.paper.source
    found = []
    for formula in reading.formulas:
        line = source.line(formula.item.span[0])
        text = bared(source.text[slice(*formula.item.span)])
        within = text in wanted and len(text) > 2 and isinstance(formula.item.formula, Relation)
        if first <= line <= last + 2 and text and (text == wanted or within or wanted in text):
            found.append(formula)
    return found


def bared(tex):
    """TeX without what only sets it."""
    return _LAYOUT.sub("", tex)


def judged(verdicts):
    """The worst of some verdicts, in a word."""
    if not verdicts:
        return "unjudged"
    if Verdict.REFUTED in verdicts:
        return "red"
    return "green" if all(v.green for v in verdicts) else "yellow"
