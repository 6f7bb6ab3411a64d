"""Papers that are read by themselves: nothing false is green, nothing true is refuted."""

from pathlib import Path

import pytest

from tests.reading.score import score

SHARED = Path(__file__).parents[3] / "shared" / "papers"


@pytest.mark.slow
@pytest.mark.parametrize("path", sorted(SHARED.glob("*.tex")), ids=lambda path: path.stem)
def test_a_paper_with_planted_errors(path):
    found = score(path)
    assert not found.claims["False/ green"]
    assert not found.claims["conditional/ green"]
    assert not found.claims["True/ red"]
    assert found.roles[True] >= 0.75 * found.roles.total()
