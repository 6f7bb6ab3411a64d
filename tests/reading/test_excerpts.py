"""Short pieces of lectures and papers, with their truth: nothing wrong is green, nothing true red."""

import json
import re
from pathlib import Path

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.notation import NotationError
from kowalevski_cas.reading import read
from kowalevski_cas.source.files import decode
from tests.sample import sampled

FOLDER = Path(__file__).parents[1] / "data" / "excerpts"
_LAYOUT = re.compile(r"\\(?:[,;:! ]|q?quad(?![A-Za-z])|left|right|[dt]frac)|[\s~.,;{}&]")
SHORTEST = 4
"""Signs by which a statement is known inside of another one."""


def bare(tex):
    """LaTeX without what does not print, and without braces."""
    return _LAYOUT.sub("", tex.replace(r"\dfrac", r"\frac").replace(r"\tfrac", r"\frac"))


def printed(item):
    try:
        return bare(item.printed.tex)
    except NotationError:
        return bare(item.typed.tex)


def verdicts(name):
    """The verdicts on what an excerpt prints, by that."""
    found = read(decode(f"{name}.tex", (FOLDER / f"{name}.tex").read_bytes()))
    outcomes = ReadingSession(found, timeout=5).outcomes
    return [
        (printed(one.item), outcomes[one.claim.id].verdict)
        for one in (*found.formulas, *found.statements)
        if one.claim is not None
    ]


NAMES = sorted(path.stem for path in FOLDER.glob("*.json"))


@pytest.mark.parametrize("name", sampled(NAMES, 4))
def test_no_wrong_statement_is_green_and_no_true_one_red(name):
    judged = verdicts(name)
    for claim in json.loads((FOLDER / f"{name}.json").read_text())["claims"]:
        own = bare(claim["tex"])
        same = [verdict for tex, verdict in judged if tex == own] or [
            verdict
            for tex, verdict in judged
            if len(tex) >= SHORTEST and (tex in own or own in tex)
        ]
        if claim["true"]:
            assert "refuted" not in [one.value for one in same], claim["tex"]
        else:
            assert not any(one.green for one in same), claim["tex"]


def test_they_are_there():
    assert len(NAMES) == 120
