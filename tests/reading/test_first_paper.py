"""The first paper by itself: its misprints, and where it is read otherwise than by hand."""

import json

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading import first_paper

DIFFERENCES = json.loads((first_paper.DATA / "differences.json").read_text(encoding="utf-8"))

needs_paper = pytest.mark.skipif(not first_paper.PAPERS.is_dir(), reason="the paper is elsewhere")


@pytest.mark.parametrize("table", DIFFERENCES.values(), ids=list(DIFFERENCES))
def test_each_difference_is_explained_once(table):
    ids = [id for entry in table.values() for id in entry["claims"]]
    assert len({*ids}) == len(ids) and {*ids} <= first_paper.recorded().keys()
    assert all(entry["why"] for entry in table.values())


def test_thirty_comments_are_the_most():
    lines = first_paper.COMMENTS.read_text(encoding="utf-8").splitlines()
    assert len(lines) <= 30 and all("%kc: " in line for line in lines)


@needs_paper
@pytest.mark.slow
@pytest.mark.parametrize(
    ("table", "comments"), [("bare", None), ("with comments", first_paper.COMMENTS)]
)
def test_it_agrees_with_the_derivation_or_the_difference_is_explained(table, comments):
    run, recorded = first_paper.session(comments, timeout=60), first_paper.recorded()
    found = first_paper.beside_each_other(run)
    differing = {id for id, verdict in recorded.items() if found[id] != verdict}
    assert differing == {id for one in DIFFERENCES[table].values() for id in one["claims"]}


@needs_paper
@pytest.mark.slow
def test_bare_its_four_misprints_are_mended_and_nothing_else_is_red():
    run = first_paper.session()
    outcomes, causes = run.outcomes, run.causes
    assert [place.tex for place in causes.misprints] == ["i^2=1"]
    mended = {id.partition(".")[0] for id, one in outcomes.items() if one.correction}
    assert mended == {"eq10", "eq14", "eq21"}
    for id, outcome in outcomes.items():
        red = outcome.verdict is Verdict.REFUTED
        assert outcome.verdict.green or (red and (outcome.correction or id in causes.places))
