"""Papers that are read by themselves: nothing false is green, nothing true is refuted, and drafts."""

from pathlib import Path

import pytest

from kowalevski_cas.reading import read
from kowalevski_cas.reading.draft import draft
from kowalevski_cas.source.files import read_source
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


def claimed(reading):
    """Each statement with its role, its claim and the hypotheses: all on which verdicts depend."""
    return [
        (
            one.item.typed.tex,
            one.role.name,
            type(one.claim),
            one.claim and one.claim.scene.variables,
            one.claim and tuple(one.claim.scene.definitions),
            one.constants,
            [item.typed.tex for item in one.on],
        )
        for one in reading.formulas
    ]


@pytest.mark.parametrize(
    "path",
    [
        pytest.param(path, marks=[] if path.stem == "dynamo" else pytest.mark.slow, id=path.stem)
        for path in sorted((Path(__file__).parents[1] / "data" / "papers").glob("*.tex"))
    ],
)
def test_a_paper_with_the_comments_that_are_drafted_makes_the_same_claims(path):
    reading = read(read_source(path))
    assert claimed(read(draft(reading))) == claimed(reading)
