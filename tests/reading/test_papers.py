"""Papers that are read by themselves: nothing false is green, nothing true is refuted, and drafts."""

import json
from pathlib import Path

import pytest

from kowalevski_cas.cli import main
from kowalevski_cas.notation import NotationError
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.reading import choice, read
from kowalevski_cas.reading.draft import draft
from kowalevski_cas.source.files import read_source
from kowalevski_cas.source.tokens import words
from kowalevski_cas.verify.interpretation import Interpretation
from tests.reading.score import score
from tests.sample import sampled

PAPERS = Path(__file__).parents[1] / "data" / "papers"
SHARED = Path(__file__).parents[3] / "shared" / "papers"
FIRST = [*SHARED.parent.glob("paper/*.txt")]

SMALL = r"""\documentclass{article}\begin{document}
The equations of motion are \[ A\dot p=(B-C)qr,\quad B\dot q=(C-A)rp,\quad C\dot r=(A-B)pq . \]
Their integrals are \begin{equation} H=Ap^2+Bq^2+Cr^2 \end{equation} and
\begin{equation} G=A^2p^2+B^2q^2+C^2r . \end{equation}
If $A=B$, then \[ \ddot p=0 . \]
\end{document}
"""


@pytest.mark.slow
@pytest.mark.parametrize("path", sorted(SHARED.glob("*.tex")), ids=lambda path: path.stem)
def test_a_paper_with_planted_errors(path):
    found = score(path)
    assert not found.claims["False/ green"]
    assert not found.claims["conditional/ green"]
    assert not found.claims["True/ red"]
    assert found.roles[True] >= 0.75 * found.roles.total()


@pytest.mark.slow
@pytest.mark.parametrize("path", sorted(PAPERS.parent.rglob("*.tex")), ids=lambda path: path.stem)
def test_no_paper_ends_the_reading(path):
    assert read(read_source(path)).formulas


@pytest.mark.parametrize(
    "path", sampled(sorted(PAPERS.parent.rglob("*.tex")), 30, id=lambda path: path.stem)
)
def test_no_paper_ends_the_reading_where_no_claim_holds(path, monkeypatch):
    monkeypatch.setattr(choice, "_trial", lambda *_, **__: (False, ""))
    assert read(read_source(path)).formulas


def claimed(reading):
    """Each statement with its role, its problem and the doubt: all on which verdicts depend."""
    interpretation = Interpretation(reading.derivation)
    return [
        (
            words(one.item.typed.tex),
            one.role.name,
            one.claim and problem(interpretation, one.claim),
            one.doubt,
            one.constants,
            [words(item.typed.tex) for item in one.on],
        )
        for one in reading.formulas
    ]


def problem(interpretation, claim):
    try:
        return interpretation.statement(claim).digest
    except (NotationError, Meaningless) as error:
        return type(error)


@pytest.mark.parametrize(
    "path",
    [
        pytest.param(path, marks=[] if path.stem == "dynamo" else pytest.mark.slow, id=path.stem)
        for path in (*sorted(PAPERS.glob("*.tex")), *sorted(SHARED.glob("*.tex")), *FIRST)
    ],
)
def test_a_paper_with_the_comments_that_are_drafted_makes_the_same_claims(path):
    reading = read(read_source(path))
    drafted = draft(reading)
    again = read(drafted)
    assert claimed(again) == claimed(reading)
    assert draft(again).text == drafted.text


@pytest.mark.slow
def test_with_the_comments_that_are_drafted_the_verdicts_are_the_same_byte_for_byte(
    capsys, tmp_path
):
    path = tmp_path / "paper.tex"
    path.write_text(SMALL)
    before = verdicts(path, capsys)
    assert '"refuted"' in before and '"conditional"' in before
    assert main(["audit", "--alone", "--draft", "--beside", str(path)]) == 0
    path.with_suffix(".kc").write_text(capsys.readouterr().out)
    assert verdicts(path, capsys) == before


def verdicts(path, capsys):
    """What an audit says of each formula, as it is written."""
    main(["audit", "--alone", "--format", "json", str(path)])
    found = json.loads(capsys.readouterr().out)["formulas"]
    return json.dumps([(one["tex"], one["verdict"], one["correction"], one["on"]) for one in found])
