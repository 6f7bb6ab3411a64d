"""Six example papers, as they stand and with at most four lines of comments each."""

import shutil
from pathlib import Path

import pytest

from study.readings import Score, audit_entries, compare

SHARED = Path(__file__).parents[3] / "shared" / "papers"
COMMENTS = Path(__file__).parents[1] / "data" / "examples"
SECONDS = 30


def test_a_paper_has_four_lines_of_comments_at_most():
    found = [path.read_text().splitlines() for path in COMMENTS.glob("*.kc")]
    assert found and all(1 <= len(lines) <= 4 for lines in found)


@pytest.mark.slow
@pytest.mark.skipif(not SHARED.exists(), reason="the example papers are not beside the repository")
@pytest.mark.parametrize(("commented", "verdicts"), [(False, 61), (True, 77)])
def test_the_claims_that_are_judged_as_they_are(tmp_path, commented, verdicts):
    total = Score()
    for paper in sorted(SHARED.glob("*.tex")):
        for name in (paper, paper.with_suffix(".json")):
            shutil.copy(name, tmp_path)
        if commented and (comments := COMMENTS / f"{paper.stem}.kc").exists():
            shutil.copy(comments, tmp_path)
        path = tmp_path / paper.name
        total.add(compare(path, audit_entries(path, SECONDS)))
    assert not total.false_greens
    assert not total.false_reds
    assert total.roles[True] >= 0.9 * total.roles.total()
    assert total.verdicts[True] >= verdicts
