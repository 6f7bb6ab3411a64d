"""An audit of the paper: verdicts, roles and causes."""

import pytest

from kowalevski_cas.audit.audit import audit
from kowalevski_cas.audit.patch import repair_source
from kowalevski_cas.audit.session import AuditSession
from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Derivation, Section
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.source.text import Source
from kowalevski_cas.verify.outcome import in_latex
from kowalevski_cas.verify.run import Session
from study.mutants.synthetic import synthetic
from tests.audit.material import audited, base, changed, source, watched


def by_id(found):
    return {formula.id: formula for formula in found.formulas}


@pytest.mark.slow
def test_an_audit_says_what_verify_says():
    typed = {place.display.id: place.typed.tex for place in audited().places}
    derivation, decider = base().interpretation.derivation, base().decider
    kept, record = decider.archive.certificates, decider.corrector.record
    texts = derivation.texts(typed)
    run = Session(derivation, ["flint"], certificates=kept, texts=texts, record=record).run()
    said = {o.claim: (o.verdict, o.conditions, o.counterexample) for o in run.outcomes}
    found = {k: (o.verdict, o.conditions, o.counterexample) for k, o in audited().outcomes.items()}
    assert found == said
    corrected = {o.claim: o.correction and o.correction.formulas for o in run.outcomes}
    assert corrected == {
        k: o.correction and o.correction.formulas for k, o in audited().outcomes.items()
    }


@pytest.mark.slow
def test_every_claim_of_verify_is_shown_by_its_id_once_with_its_verdict():
    shown = {f.id: f.verdict for f in audited().formulas if f.id in f.claims}
    in_words = {outcome.claim: outcome.verdict for outcome in audited().statements}
    assert not shown.keys() & in_words.keys()
    assert shown | in_words == {
        id: entry["verdict"] for id, entry in base().decider.corrector.record.items()
    }
    assert [outcome.claim for outcome in audited().false] == ["critical-set"]


def test_the_misprints_of_the_paper():
    wrong = [formula.id for formula in audited().formulas if formula.wrong]
    rows = [f"eq10.{k}" for k in (1, 2, 3, 4, 7, 8)]
    assert wrong == ["eq9.i", *rows, "eq14", "eq21"]
    for formula in audited().formulas:
        if formula.wrong:
            assert formula.counterexample is not None
            assert formula.correction is not None
            assert formula.correction.verdict.green


def test_the_roles():
    roles = {formula.id: formula.role for formula in audited().formulas}
    assert roles["eq2"] == roles["eq3.1"] == "vector field"
    assert roles["eq9.i"] == "unit"
    assert roles["eq9.1"] == roles["J.1"] == roles["eq11.1"] == roles["tau"] == "definition"
    assert roles["eq10.1"] == "vector field"  # and a claim: what others rest on comes first
    assert roles["eq14"] == roles["eq21"] == "claim"
    assert roles["beta"] == roles["norm"] == "condition"


def test_the_formulas_stand_in_the_order_of_the_source():
    lines = [formula.line for formula in audited().formulas]
    assert lines == sorted(lines)
    for formula in audited().formulas:
        first = formula.tex.split()[0]
        assert first in source().text.split("\n")[formula.line - 1]


CHANGED = [
    (r"J_1  = \omega _1^2  -", r"J_1  = \omega _1^2  +", "J.1", {"eq6", "eq7"}),
    (r"\theta  = x_1 x_2", r"\theta  = x_1 x_1", "eq11.1", {"theta-prime"}),
    (
        r"{\bs \alpha} \times {\bs \omega}",
        r"{\bs \beta} \times {\bs \omega}",
        "eq3.1",
        {"energy", "eq10.1", "eq12"},
    ),
    (r"F_2  = U_1  -", r"F_2  = U_1  +", "F2.1", {"F1-prime", "eq15"}),
    (r"\tau=it", r"\tau=-it", "tau.1", {"eq10.1", "eq12"}),
    (r"{\bs \beta} = 0$", r"{\bs \beta} = {\bs \alpha}$", "beta.1", {"eq18", "eq19"}),
]
"""What is changed, the formula that is the cause, and claims that are false by it."""


@pytest.mark.slow
@pytest.mark.parametrize(("old", "new", "cause", "false"), CHANGED)
@watched
def test_a_changed_definition_is_the_cause(old, new, cause, false):
    text = source().text
    at = text.rindex(old)
    found = audit(Source("paper.tex", text[:at] + new + text[at + len(old) :]), base())
    causes = found.session.causes.places
    for claim in false:
        assert not found.outcomes[claim].verdict.green
        assert [printed.place for printed in causes[claim]] == [cause]
        assert found.outcomes[claim].correction is None
    formula = next(f for f in found.formulas if f.place is not None and f.place.place == cause)
    assert formula.wrong
    assert false <= set(formula.breaks)
    for claim, known in base().outcomes.items():  # the same problem is not decided again
        outcome = found.outcomes[claim]
        assert outcome is known or outcome.digest != known.digest or not known.verdict.green
    patched = repair_source(found).text
    if r"\bs" in old:
        assert old in patched, "macros of the author stay"
    assert not any(f.wrong for f in audit(Source("paper.tex", patched), base()).formulas)


def test_a_changed_claim_is_refuted_and_repaired():
    found = by_id(changed("2\\omega'_3 = y_2  - y_1", "2\\omega'_3 = y_2  + y_1"))
    assert found["eq10.9"].verdict == "refuted"
    assert in_latex(found["eq10.9"].correction.formulas) == "2\\omega_3' = y_2 - y_1"
    assert found["eq10.1"].verdict == "refuted"
    assert found["theta-prime"].verdict == "proved"


@pytest.mark.slow
@watched
def test_a_changed_row_of_the_change_of_variables():
    found = changed(r"z_1 = \alpha_3  + i", r"z_1 = \alpha_2  + i")
    row = by_id(found)["eq9.5"]
    assert row.wrong
    assert row.correction is not None
    assert [place.place for place in found.session.causes.places["eq9"]] == ["eq9.5"]


@pytest.mark.slow
def test_a_name_that_is_no_longer_defined():
    found = by_id(changed(r"J_2  = 2\omega _1", r"J_3  = 2\omega _1"))
    assert found["J.2"].verdict == "suspect"
    assert found["J.2"].message == "it does not define J_2"


def test_a_formula_that_cannot_be_read():
    found = by_id(changed(r"\theta  = x_1 x_2", r"\theta  = x_1 \foo"))
    assert found["eq11"].verdict == "unreadable"
    assert "\\foo" in found["eq11"].message


@pytest.mark.slow
def test_a_definition_in_a_circle():
    found = by_id(changed(r"J_1  = \omega _1^2", r"J_1  = J_1"))
    assert found["J.1"].verdict == "suspect"
    assert "defined by itself" in found["eq6"].message


def test_a_formula_that_would_take_too_long():
    found = by_id(changed(r"J_1  = \omega _1^2", r"J_1  = (\omega _1+\omega_2)^{99999999}"))
    assert found["J"].verdict == "unreadable"
    assert "degree" in found["J"].message


@watched
def test_nothing_of_an_audit_is_kept():
    audited()
    before = len(base().interpretation.elaborations._known)
    found = changed(r"2w'_2  = w_2 w_3  + z_2", r"2w'_2  = w_2 w_3  + z_1")
    assert len(found.session.interpretation.elaborations._known) > before
    assert len(base().interpretation.elaborations._known) == before


def misprinted(tex: str) -> AuditSession:
    """A run of a derivation that prints a definition like this, with two claims about it."""
    section = Section("1", "A rotation")
    motion = section.display("motion", r"\dot x=y,\quad \dot y=-x")
    energy = section.display("energy", tex)
    rate = section.display("rate", r"\dot E=0")
    value = section.display("value", "2E=x^2+y^2")
    scene = Scene(
        "rotation", variables=("x", "y"), field=(motion[1], motion[2]),
        definitions={"E": energy[1]},
    )  # fmt: skip
    section.claim(
        Identity("rate", scene, "the energy is constant", printed=rate[1]),
        Identity("value", scene, "the energy", printed=value[1]),
    )
    derivation = Derivation("rotation", "A rotation", "", "", (section,))
    return AuditSession(derivation, ["flint"], patience=600)


def test_a_misprint_in_a_definition_of_the_derivation_is_the_cause():
    run = misprinted(r"E=\frac{1}{2}(x^2-y^2)")
    found = audit(synthetic(run.interpretation.derivation), run)
    energy = by_id(found)["energy"]
    assert energy.verdict == "suspect"
    assert energy.breaks == ("rate", "value")
    assert "x^2 + y^2" in energy.message
    assert all(outcome.correction is None for outcome in found.outcomes.values())
    mended_text = repair_source(found).text
    assert r"\frac{1}{2}(x^2+y^2)" in mended_text.replace(" ", "")
    again = audit(Source("mended.tex", mended_text), run)
    assert not any(formula.wrong for formula in again.formulas)
