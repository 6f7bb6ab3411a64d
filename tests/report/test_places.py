"""The paper in its order: every display, and every claim at what it is about."""

import pytest

from kowalevski_cas.library import available, load
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.report.places import ClaimName, PaperSection, names, sections
from kowalevski_cas.verify.outcome import Outcome, Run, Verdict
from tests.sample import sampled


def undecided(derivation: Derivation) -> Run:
    """A run that decides nothing."""
    outcomes = tuple(
        Outcome(claim.id, section.number, "", (), "", "", Verdict.UNDECIDED)
        for section in derivation.sections
        for claim in section.claims
    )
    words = derivation.texts().vocabulary
    return Run(derivation.name, "", "", "", (), outcomes, (), {}, words)


@pytest.fixture(scope="module")
def kharlamov() -> tuple[PaperSection, ...]:
    derivation = load("kharlamov2002")
    return sections(undecided(derivation), derivation, derivation.texts())


@pytest.mark.parametrize("name", sampled(available(), 3))
def test_every_claim_and_every_display_stands_once(name: str) -> None:
    derivation = load(name)
    found = sections(undecided(derivation), derivation, derivation.texts())
    claims = [outcome.claim for section in found for outcome in section.outcomes]
    assert sorted(claims) == sorted(claim.id for claim in derivation.claims)
    shown = [
        f for section in found for item in section.items for row in item.rows for f in row.formulas
    ]
    texts = derivation.texts()
    for display in derivation.displays():
        for statement in texts.statements(display):
            assert statement.formula in shown


def test_displays_keep_their_order(kharlamov: tuple[PaperSection, ...]) -> None:
    labels = [item.label for section in kharlamov for item in section.items]
    numbers = [int(label.strip("()")) for label in labels if label]
    assert numbers == sorted(numbers) == list(range(1, 23))


def test_a_claim_about_a_display_stands_at_it(kharlamov: tuple[PaperSection, ...]) -> None:
    items = {item.label: item for section in kharlamov for item in section.items}
    assert [o.claim for o in items["(7)"].outcomes] == ["eq7"]
    (conjugate,) = items["(13)"].stated
    assert [row.outcome and row.outcome.claim for row in conjugate.rows] == [
        None,
        None,
        "eq13.conjugate",
    ]
    together = [[o.claim for o in one.outcomes] for one in items["(16)"].stated]
    assert together == [["eq16.1", "eq16.2"], ["eq16.invariance"]]


def test_a_claim_is_called_by_the_number_of_the_paper_or_by_one_of_the_report(
    kharlamov: tuple[PaperSection, ...],
) -> None:
    called = names(kharlamov)
    assert called["eq14"] == ClaimName("(14)")
    assert called["eq10.7"] == ClaimName("(10)", place=7, several=9)
    assert called["eq9.i"] == ClaimName("2.2", "before (9)")
    assert called["critical-set"].near == "after (22)"
    assert called["equilibria"].near == ""  # it stands in no formula
    stated = [one.number for section in kharlamov for i in section.items for one in i.stated]
    assert len(set(stated)) == len(stated)


@pytest.mark.parametrize("name", available())
def test_claims_have_names_of_their_own(name: str) -> None:
    derivation = load(name)
    called = names(sections(undecided(derivation), derivation, derivation.texts()))
    assert called.keys() == {claim.id for claim in derivation.claims}
    assert len({(name.number, name.place) for name in called.values()}) == len(called)


def test_a_claim_about_no_display_follows_what_it_mentions(
    kharlamov: tuple[PaperSection, ...],
) -> None:
    first = [item.label or "".join(o.claim for o in item.outcomes) for item in kharlamov[0].items]
    assert first.index("(8)") < first.index("M4-independence")
    assert first.index("(7)") < first.index("M4-dimension") < first.index("(8)")


def test_what_nobody_claims_has_a_role(kharlamov: tuple[PaperSection, ...]) -> None:
    items = {item.label: item for section in kharlamov for item in section.items}
    assert items["(2)"].role == "vector field" and items["(11)"].role == "definition"


def test_what_the_paper_does_not_print_has_a_source(kharlamov: tuple[PaperSection, ...]) -> None:
    items = {item.display: item for section in kharlamov for item in section.items}
    assert items["over-M4"].source == "the relations (7) solved for two variables"
    assert items["eq7"].source == ""


def test_claims_that_were_not_run_leave_their_displays() -> None:
    derivation = load("kharlamov2002")
    whole = undecided(derivation)
    (only,) = [outcome for outcome in whole.outcomes if outcome.claim == "eq14"]
    (section,) = sections(whole._replace(outcomes=(only,)), derivation, derivation.texts())
    assert section.number == "2" and section.outcomes == (only,)
    assert {"(9)", "(16)"} < {item.label for item in section.items}
