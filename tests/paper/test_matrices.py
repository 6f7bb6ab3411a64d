"""Matrices by their rows: what is equal entry by entry, and what has no meaning."""

import pytest

from kowalevski_cas.paper.derivation import Derivation, Scene, Section
from kowalevski_cas.verify.outcome import Verdict
from kowalevski_cas.verify.run import Session

pytestmark = pytest.mark.usefixtures("uncorrected")

ROTATION = r"""
{\bf R} = \begin{pmatrix} x & -y \\ y & x \end{pmatrix}, \quad
{\bf J} = \begin{pmatrix} 0 & -1 \\ 1 & 0 \end{pmatrix}, \quad
{\bf C} = \begin{pmatrix} x & y & 0 \\ y & x & 0 \end{pmatrix}"""


def verdict(tex):
    """The verdict on an identity in x and y, which turn uniformly."""
    section = Section("1", "Matrices", copied=False)
    matrices = section.lemma("matrices", ROTATION, "for the test")
    motion = section.lemma("motion", r"\dot x = -y, \quad \dot y = x", "for the test")
    scene = Scene("plane", variables=("x", "y"), constants=(r"\mu",))
    section.identity("claim", tex, on=scene.moving(motion).defining(matrices), says="it holds")
    derivation = Derivation("matrices", "matrices", "nobody", "none", (section,))
    (outcome,) = Session(derivation, ["flint"]).run().outcomes
    return outcome.verdict, outcome.message


@pytest.mark.parametrize(
    "number", ["x^2-y^2", "x^2", "x+y+1", "-(x+y)", r"\frac{x}{y}", "0", "xy-x"]
)
def test_a_matrix_is_no_number_but_zero(number):
    found, message = verdict(rf"\begin{{pmatrix}}x&y\\y&x\end{{pmatrix}}={number}")
    assert found is (Verdict.REFUTED if number == "0" else Verdict.ERROR)
    assert number == "0" or "is no matrix" in message


@pytest.mark.parametrize(
    "tex",
    [
        r"\dot{\bf R} = {\bf J}{\bf R}",
        r"{\bf R}{\bf J} = {\bf J}{\bf R}",
        r"{\bf R}-{\bf J}{\bf R}{\bf J} = 2{\bf R}",
        r"{\bf R} = x+y{\bf J}",
        r"{\rm det}({\bf R}) = x^2+y^2",
        r"{\rm det}({\bf R}-\mu) = \mu^2-2x\mu+x^2+y^2",
        r"{\rm det}({\bf R}{\bf J}) = {\rm det}({\bf R})",
    ],
)
def test_what_holds_for_all_entries_is_proved(tex):
    assert verdict(tex)[0] is Verdict.PROVED


@pytest.mark.parametrize(
    "tex",
    [
        r"\dot{\bf R} = -{\bf J}{\bf R}",
        r"{\bf R} = x-y{\bf J}",
        r"{\rm det}({\bf R}-\mu) = \mu^2+2x\mu+x^2+y^2",
        r"{\bf J}{\bf C} = {\bf C}",
    ],
)
def test_what_fails_in_one_entry_is_refuted(tex):
    assert verdict(tex)[0] is Verdict.REFUTED


@pytest.mark.parametrize(
    ("tex", "why"),
    [
        (r"{\bf R} = {\bf C}", "differ in size"),
        (r"{\bf R}+{\bf C} = {\bf R}", "differ in size"),
        (r"{\bf C}{\bf R} = {\bf C}", "do not fit"),
        (r"{\rm det}({\bf C}) = 0", "not square"),
        (r"{\bf R} = x", "no matrix"),
        (r"{\rm det}(x) = x", "no matrix"),
    ],
)
def test_what_has_no_meaning_says_so(tex, why):
    found, message = verdict(tex)
    assert found is Verdict.ERROR
    assert why in message
