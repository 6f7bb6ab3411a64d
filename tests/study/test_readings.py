"""How an audit is compared with what is known of each formula."""

import json

import pytest

from kowalevski_cas.cli.exits import CommandError
from study.readings import audit_entries, compare, places

SOURCE = r"""\documentclass{article}
\begin{document}
Let
\begin{equation}\label{law}
\dot x=y,\qquad
\dot y=-x,
\end{equation}
then $x^2+y^2$ and $x^2+2y^2$ are integrals, and so is $x^2+y^2$ on $x=0$.
\end{document}
"""
ERROR = {"printed": "2y^2", "right": "y^2", "class": "factor"}
TRUTH = [
    {"line": 5, "until": 6, "tex": r"\dot x=y,\qquad \dot y=-x,", "role": "law", "true": None},
    {"line": 8, "tex": "x^2+y^2", "role": "claim", "kind": "integral", "true": True},
    {
        "line": 8,
        "tex": "x^2+2y^2",
        "role": "claim",
        "kind": "integral",
        "true": False,
        "error": ERROR,
    },
    {"line": 8, "tex": "x^2+y^2", "role": "claim", "kind": "integral", "true": True},
    {"line": 8, "tex": "x=0", "role": "assumption", "true": None},
]


def said(line, column, role, verdict, **more):
    return {
        "id": f"{line}-{column}", "line": line, "column": column, "role": role, "verdict": verdict,
        "reason": "", "causes": [], "correction": None, "message": "", **more,
    }  # fmt: skip


@pytest.fixture
def path(tmp_path):
    (tmp_path / "paper.json").write_text(json.dumps(TRUTH))
    (tmp_path / "paper.tex").write_text(SOURCE)
    return tmp_path / "paper.tex"


def columns():
    """The columns of the formulas of the last line."""
    start = SOURCE.index("then $")
    return [begin - start + 1 for begin, _ in list(places(SOURCE, TRUTH))[1:]]


def right():
    first, second, third, last = columns()
    return [
        said(5, 1, "law", "given"),
        said(6, 1, "law", "given"),
        said(8, first, "claim", "proved"),
        said(8, second, "claim", "refuted"),
        said(8, third, "claim", "conditional"),
        said(8, last, "assumption", "given"),
    ]


def test_the_same_formula_twice_in_a_line_has_two_places():
    spans = list(places(SOURCE, TRUTH))
    assert spans == sorted(spans) and len(set(spans)) == len(TRUTH)
    assert SOURCE[slice(*spans[0])].split() == TRUTH[0]["tex"].split()


def test_an_audit_that_says_the_truth_has_all_points(path):
    score = compare(path, right())
    assert (score.roles, score.verdicts, score.errors) == ({True: 5}, {True: 3}, {True: 1})
    assert score.false_greens == score.false_reds == score.misread == score.missed == []


@pytest.mark.parametrize("verdict", ["proved", "conditional"])
def test_what_is_false_and_green_is_a_false_green(path, verdict):
    audit = right()
    audit[3]["verdict"] = verdict
    score = compare(path, audit)
    assert score.false_greens == ["paper:8 x^2+2y^2"]
    assert score.errors == {False: 1} and score.verdicts == {True: 2, False: 1}


def test_what_is_true_and_red_is_a_false_red(path):
    audit = right()
    audit[2]["verdict"] = "refuted"
    assert compare(path, audit).false_reds == ["paper:8 x^2+y^2"]


def test_a_law_that_is_read_as_a_claim_and_refuted_is_a_false_red(path):
    audit = right()
    audit[1] |= {"role": "claim", "verdict": "refuted"}
    score = compare(path, audit)
    assert len(score.false_reds) == len(score.misread) == 1


@pytest.mark.parametrize("verdict", ["undecided", "open", "error", "timeout"])
def test_what_is_not_decided_is_missed_and_neither_green_nor_red(path, verdict):
    audit = right()
    audit[2]["verdict"] = verdict
    score = compare(path, audit)
    assert len(score.missed) == 1 and score.false_greens == score.false_reds == []
    assert score.timeouts == (verdict == "timeout")


def test_a_formula_that_is_not_listed_is_misread(path):
    score = compare(path, right()[:-1])
    assert score.misread == ["paper:8 assumption: not listed"]


@pytest.mark.slow
def test_without_an_answer_there_is_no_score(tmp_path):
    with pytest.raises(CommandError, match="exit code 2"):
        audit_entries(tmp_path / "none.tex", 1)


def test_what_is_yellow_as_false_is_noticed_if_it_is_false_and_doubted_if_it_is_true(path):
    audit = right()
    for one in audit[2:5]:
        one |= {"verdict": "undecided", "message": "false as it was read"}
    score = compare(path, audit)
    assert score.errors == {True: 1}
    assert score.doubted == {True: 2}
    audit[3] |= {"message": "no certificate was found"}
    assert compare(path, audit).errors == {False: 1}
