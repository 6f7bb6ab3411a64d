"""The note on the free rigid body in Jacobi's functions: what is wrong there, and what is changed."""

import json
from pathlib import Path

import pytest

import derivations.leroy2020 as note
from kowalevski_cas.verify.run import Session
from tests.sample import sampled

RECORD = Path(note.__file__).parent / "record.json"
FALSE = {"article-i", "article-ii", "complementary.2", "angle-article"}
"""The signs of the article, the unit of the angle, and a factor with a dimension."""


def test_what_is_wrong_is_what_the_record_says():
    claims = json.loads(RECORD.read_text(encoding="utf-8"))["claims"]
    assert {id for id, one in claims.items() if one["verdict"] == "refuted"} == FALSE
    others = {one["verdict"] for id, one in claims.items() if id not in FALSE}
    assert others <= {"proved", "conditional"}


@pytest.mark.parametrize(
    ("claim", "printed", "wrong"),
    sampled(
        [
            ("solneuleriii.2", r"\lambda G =", r"-\lambda G ="),
            ("integralsech", r"u+\frac{2a}", r"u-\frac{2a}"),
            ("integraldn", r"\frac{a^2k^2}{a^2-1}", r"\frac{a^2k^2}{1-a^2}"),
            ("angle-mended", r"-\frac{B_{31}}{G}", r"+\frac{B_{31}}{G}"),
            ("Delta.1", r"\frac{I_{21}}{I_2}", r"\frac{I_{12}}{I_2}"),
        ],
        1,
    ),
)
def test_what_is_changed_is_refuted(claim, printed, wrong, uncorrected):
    sources = {
        display.id: tex.replace(printed, wrong)
        for display in note.derivation.displays()
        if printed in (tex := display.tex.replace("\n", ""))
    }
    assert sources
    session = Session(note.derivation, ["flint"], texts=note.derivation.texts(sources))
    assert session.run([claim]).outcomes[0].verdict == "refuted"
