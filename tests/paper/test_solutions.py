"""Landen's transformations: functions that solve one system from one beginning are equal."""

import pytest

from kowalevski_cas.library import load
from kowalevski_cas.paper.claims import EqualSolutions
from kowalevski_cas.paper.derivation import Scene, Section
from tests.paper.small import decide
from tests.sample import sampled

LANDEN = load("dlmf22").sections[1].displays
ROWS = next(display.tex for display in LANDEN if display.id == "22.7.2")
MUTANTS = [("(1+k_1)", "(1-k_1)"), (r"\operatorname{dn}^2", r"\operatorname{cn}^2"), ("-(1-k_1)", "-(1+k_1)"),
           (r"1+k_1\operatorname{sn}^2", r"1-k_1\operatorname{sn}^2"), ("sn}(z,", "cn}(z,"),
           ("(z/(1+k_1),k_1)", "(z,k_1)"), ("(z/(1+k_1),k_1)", "(z/(1+k_1),k')")]  # fmt: skip


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(("old", "new"), sampled(MUTANTS, 1))
def test_a_mutant_is_never_proved(old, new):
    section = Section("1", "")
    moduli = section.display("moduli", "k^2+k'^2=1")
    smaller = section.display("smaller", r"k_1=\frac{1-k'}{1+k'}")
    scene = Scene(constants=("k'",), time="z").solving("k", moduli[1]).defining(smaller)
    rows = section.display("rows", ROWS.replace(old, new, 1))
    [outcome] = decide(section, EqualSolutions("c", scene, "", equations=(*rows,)), timeout=20)
    assert str(outcome.verdict) in ("refuted", "undecided", "error", "timeout")


RECIPROCAL = (
    r"\operatorname{sn}(z,k)=\frac1k\operatorname{sn}(kz,\frac1k),\quad"
    r"\operatorname{cn}(z,k)=\operatorname{dn}(kz,\frac1k),\quad"
    r"\operatorname{dn}(z,k)=\operatorname{cn}(kz,\frac1k)"
)


@pytest.mark.usefixtures("uncorrected")
@pytest.mark.parametrize(
    ("old", "new", "verdict"),
    sampled(
        [
            ("", "", "proved"),
            (r"=\frac1k\operatorname{sn}(", r"=k\operatorname{sn}(", "refuted"),
            ("{dn}(kz", "{cn}(kz", "refuted"),
            ("(kz,", "(z,", "refuted"),
        ],
        1,
    ),
)
def test_a_modulus_above_1_leads_to_one_below(old, new, verdict):
    section = Section("1", "")
    rows = section.display("rows", RECIPROCAL.replace(old, new, 1) if old else RECIPROCAL)
    scene = Scene(constants=("k",), time="z")
    [outcome] = decide(section, EqualSolutions("c", scene, "", equations=(*rows,)))
    assert str(outcome.verdict) == verdict
