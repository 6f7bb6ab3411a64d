"""Corrections are proposals: nothing rests on one that the derivation does not accept."""

import json
from pathlib import Path
from time import sleep

import pytest

from kowalevski_cas import System
from kowalevski_cas.paper.claims import (
    Definition,
    Equilibria,
    Identity,
    Implication,
    InvariantRelations,
    Neighbour,
    RestPoint,
    RestPoints,
)
from kowalevski_cas.paper.derivation import Derivation, Scene, Section
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.verify import corrections
from kowalevski_cas.verify.blame import Blame
from kowalevski_cas.verify.certificate import Stored
from kowalevski_cas.verify.corrections import (
    formulas_printed_by,
    passes,
    recorded_correction,
    true_ones,
)
from kowalevski_cas.verify.outcome import in_latex
from kowalevski_cas.verify.record import describe
from kowalevski_cas.verify.run import Session
from kowalevski_cas.verify.statement import Statement
from tests.paper.small import Oscillator, decide, derivation
from tests.sample import sampled


class Slow(Definition):
    """A definition of which the corrections come late."""

    def neighbours(self, texts, wanted=None):
        sleep(60)
        yield from super().neighbours(texts, wanted)


@pytest.fixture
def small():
    return Oscillator()


def claims(small):
    wrong, right = small(r"v=-\dot x"), small(r"\dot v=-x")
    return Identity("wrong", small.scene, "", printed=wrong), Identity(
        "right", small.scene, "", printed=right
    )


def test_a_correction_is_proposed_and_proved(small):
    found = decide(small.section, *claims(small))
    assert [str(o.verdict) for o in found] == ["refuted", "proved"]
    assert found[0].correction.verdict == "proved"
    assert in_latex(found[0].correction.formulas) == r"v = \dot{x}"


def scene_with(tex):
    """A scene on which D is defined by a printed formula, the claim of it, and one that uses it."""
    section = Section("1", "")
    motion = section.display("motion", r"\dot x = v,\quad \dot v = -x")
    printed, rate = section.inline("D", tex), section.inline("rate", r"\dot D = 2xv")
    use = section.inline("use", "D - x^2 = 0")
    scene = Scene(
        "D", variables=("x", "v"), field=(motion[1], motion[2]), definitions={"D": printed[1]}
    )
    own = Definition("own", scene, "", printed=printed[1], equation=rate[1])
    return section, printed, (own, Identity("use", scene, "", printed=use[1]))


def test_without_acceptance_the_print_stands():
    section, _, both = scene_with("D = x^3")
    own, use = decide(section, *both)
    assert (own.verdict, use.verdict) == ("refuted", "refuted")
    assert in_latex(own.correction.formulas) == "D = x^2"
    assert use.corrected == ()


def test_with_acceptance_what_follows_rests_on_it_and_says_so():
    section, printed, both = scene_with("D = x^3")
    section.accept(printed[1], "D = x^2")
    own, use = decide(section, *both)
    assert (own.verdict, use.verdict) == ("refuted", "proved")
    assert own.corrected == () and use.corrected == ("own",)


@pytest.mark.parametrize("tex", ["D = x^2 + 1", "D = x^4", "D = D", "D = v"])
def test_what_is_accepted_has_to_be_proved(tex):
    section, printed, both = scene_with("D = x^3")
    section.accept(printed[1], tex)
    own, _ = decide(section, *both)
    assert own.verdict == "error"
    assert own.message == "what the derivation accepts at D.1 has not been proved"


def test_a_recorded_correction_leaves_true_what_was_true():
    """It is looked at again in each run; the other claim is true as it is printed."""
    section, _, both = scene_with("D = x^3")
    recorded = {"own": {"correction": "D = x^2"}}
    own, _ = decide(section, *both, record=recorded)
    assert in_latex(own.correction.formulas) == "D = x^2"
    cube = section.inline("cube", "D - x^3 = 0")
    section.claim(Identity("cube", both[0].scene, "", printed=cube[1]))
    own, _, other = Session(derivation(section), ["flint"], record=recorded).run().outcomes
    assert (own.verdict, own.correction, other.verdict) == ("refuted", None, "proved")


def test_what_is_accepted_in_place_of_what_is_right():
    section, printed, both = scene_with("D = x^2")
    section.accept(printed[1], "D = x^2")
    own, _ = decide(section, *both)
    assert own.verdict == "proved"
    section, printed, both = scene_with("D = x^2")
    section.accept(printed[1], "D = x^3")
    own, use = decide(section, *both)
    assert own.verdict == "error"
    assert (use.verdict, use.message) == ("undecided", "rests on own")


def test_what_is_accepted_and_claimed_nowhere_proves_nothing():
    section, printed, (_, use) = scene_with("D = x^3")
    section.accept(printed[1], "D = x^2")
    (use,) = decide(section, use)
    assert (use.verdict, use.message) == ("undecided", "rests on D.1")


@pytest.mark.parametrize(
    ("printed", "accepted", "claimed", "verdict"),
    [
        ("D = x^3", "D = x^2", True, "proved"),
        ("D = x^3", "D = x^2", False, "undecided"),
        ("D = x^2", "D = x^3", True, "undecided"),
        ("D = x^3", "D = x^3+v", True, "undecided"),
    ],
)
def test_what_another_derivation_accepts_is_said_and_has_to_be_proved_there(
    printed, accepted, claimed, verdict
):
    section, display, (own, use) = scene_with(printed)
    section.accept(display[1], accepted)
    section.claim(*([own] if claimed else []))
    base = Derivation("base", "", "", "", (section,))
    later = Section("1", "")
    side = later.inline("side", f"D = {accepted.partition('=')[2]}")
    later.claim(Identity("use", use.scene, "", printed=side[1]))
    (found,) = Session(Derivation("later", "", "", "", (later,), (base,)), ["flint"]).run().outcomes
    name = "own" if claimed else "D.1"
    assert found.corrected == (f"base/{name}",)
    said = f"rests on base/{name}" if verdict == "undecided" else ""
    assert (found.verdict, found.message) == (verdict, said)


def test_a_claim_by_itself_is_decided_with_what_it_rests_on():
    section, printed, both = scene_with("D = x^3")
    section.accept(printed[1], "D = x^2")
    section.claim(*both)
    (use,) = Session(derivation(section), ["flint"]).run(["use"]).outcomes
    assert use.verdict == "proved"
    section.accept(printed[1], "D = 2x^2")
    (use,) = Session(derivation(section), ["flint"]).run(["use"]).outcomes
    assert (use.verdict, use.message) == ("undecided", "rests on own")


def test_what_rests_on_a_correction_for_which_there_was_no_time_is_undecided():
    section, printed, (own, use) = scene_with("D = x^3")
    section.accept(printed[1], "D = x^2")
    own = Slow(own.id, own.scene, own.words, own.equation, printed=own.printed)
    own, use = decide(section, own, use, timeout=0.5)
    assert (own.verdict, own.message) == ("timeout", "no correction was found within the time")
    assert (use.verdict, use.message) == ("undecided", "rests on own")
    assert use.counterexample is None and use.correction is None


def test_a_hopeless_formula_has_none(small):
    outcome = small.outcome(Identity, "x^5+7=v^3-x+2")
    assert outcome.verdict == "refuted" and outcome.correction is None


@pytest.mark.parametrize(
    ("changed", "kept", "searches"),
    sampled(
        [
            ({}, True, 0),
            ({"statement": "0"}, True, 1),
            ({"correction": "v=x"}, True, 1),
            ({}, False, 1),
        ],
        2,
    ),
)
def test_a_search_that_found_none_is_made_again_for_another_statement_or_anew(
    small, monkeypatch, changed, kept, searches
):
    hopeless = Identity("hopeless", small.scene, "", printed=small("x^5+7=v^3-x+2"))
    (first,) = decide(small.section, hopeless)
    record = {"hopeless": describe(first) | changed}
    stored = Stored(Path("hopeless.json"), json.loads(first.certificate))
    asked = []
    monkeypatch.setattr(Blame, "alone", lambda _, claim: asked.append(claim) or ())
    session = Session(
        derivation(small.section), ["flint"], record=record,
        certificates={"hopeless": stored} if kept else {},
    )  # fmt: skip
    (again,) = session.run().outcomes
    assert describe(again) == describe(first) and len(asked) == searches


@pytest.mark.slow
@pytest.mark.parametrize("name", sampled(["F", r"\rho", "G"], 1))
def test_what_does_not_move_is_no_correction_of_what_does(name):
    """In the system of Lorenz the zeros of x² − 2σz move on it for b = 2σ only, and σ = 0 does."""
    section = Section("1", "Lorenz")
    motion = section.display(
        "motion", r"\dot x=\sigma(y-x),\quad \dot y=rx-y-xz,\quad \dot z=xy-bz"
    )
    scene = Scene(
        "Lorenz", variables=("x", "y", "z"), constants=(r"\sigma", "r", "b"),
        field=(motion[1], motion[2], motion[3]),
    )  # fmt: skip
    scene = scene.defining(section.display("function", rf"{name}=x^2-2\sigma z"))
    zeros = section.inline("zeros", f"{name}=0")
    claim = InvariantRelations("t", scene, "", relations=(zeros[1],))
    assert r"\sigma = 0" in true_neighbours(section, claim)
    (outcome,) = decide(section, claim)
    assert outcome.verdict == "refuted" and outcome.correction is None


def true_neighbours(section, claim):
    """What is true one edit away from a claim, in LaTeX, be it vacuous or not."""
    texts = derivation(section).texts(None, *claim.scenes())
    return {
        in_latex(formulas_printed_by(n))
        for n in true_ones(claim.neighbours(texts), Elaborations(texts))
    }


VACUOUS = {
    "the same sides": ("xE=vE", "vE = vE"),
    "a constant does not move": (r"\dot x=0", r"\dot{k} = 0"),
    "a function that vanishes as a factor": ("x+k=0", "E(x + k) = 0"),
}


@pytest.mark.slow
@pytest.mark.parametrize(("printed", "proposed"), sampled(VACUOUS.values(), 1, seed=4))
def test_what_is_true_of_itself_is_not_proposed(small, printed, proposed):
    level = small.section.inline("level", "E=0")
    claim = Implication("t", small.scene, "", printed=small(printed), given=(level[1],))
    assert proposed in true_neighbours(small.section, claim)
    (outcome,) = decide(small.section, claim)
    assert outcome.correction is None or in_latex(outcome.correction.formulas) != proposed


def test_a_correction_leaves_true_what_was_true():
    section, _, (own, _) = scene_with("D = x^3")
    keeps = section.inline("keeps", "xD = x^4")
    keeping = Identity("keeps", own.scene, "", printed=keeps[1])
    own, keeping = decide(section, own, keeping)
    assert (own.verdict, own.correction) == ("refuted", None)
    assert keeping.verdict == "proved"


@pytest.mark.parametrize(
    ("F", "cofactor", "right"),
    sampled(
        [
            ("x", "2x+y", "x,\\ 3x + y"),
            ("x", "3x-y", "x,\\ 3x + y"),
            ("y", "x-2y", "y,\\ x - y"),
            ("xy", "3x", "xy,\\ 4x"),
            ("xy", "4y", "xy,\\ 4x"),
            (r"x^2y", "7x+2y", "x^2y,\\ 7x + y"),
        ],
        1,
    ),
)
def test_a_misprint_in_a_cofactor_is_corrected_like_one_in_the_polynomial(F, cofactor, right):
    outcome = System(r"\dot x=x(3x+y),\quad \dot y=y(x-y)").darboux(F, cofactor).outcome
    assert outcome.verdict == "refuted"
    assert in_latex(outcome.correction.formulas) == right


E3 = r"""\dot{\mathbf M}=\{\mathbf M,H\},\ \dot{\mathbf p}=\{\mathbf p,H\},\ H=\frac12\mathbf M^2,\
\{M_i,M_j\}=\varepsilon_{ijk}M_k,\ \{M_i,p_j\}=\varepsilon_{ijk}p_k,\ \{p_i,p_j\}=0,\
\mathbf M=(M_1,M_2,M_3),\ \mathbf p=(p_1,p_2,p_3)"""


@pytest.mark.slow
def test_what_fails_at_points_is_not_decided_in_full(monkeypatch):
    """Not even if the claim says more than identities, as that a Casimir function is not constant.

    So only what is true is decided, and it is the same as of all that is decided.
    """
    claim = System(E3).casimir("M_1p_1+M_2p_2+M_3p_2")
    texts = derivation(claim.section).texts()
    on = Elaborations(texts)
    held, holds = [], Statement.holds
    monkeypatch.setattr(Statement, "holds", lambda self: held.append(self) or holds(self))
    screened = [
        in_latex(formulas_printed_by(n)) for n in true_ones(claim.claim.neighbours(texts), on)
    ]
    assert len(held) == len(screened) == 1
    monkeypatch.setattr(corrections, "_is_identity", lambda _: False)
    every = [in_latex(formulas_printed_by(n)) for n in true_ones(claim.claim.neighbours(texts), on)]
    assert every == screened == ["M_1p_1 + M_2p_2 + M_3p_3"]
    assert len(held) > 50


REST = {"fixed": (), "levels": ()}

FALSE = [
    lambda: System(r"\dot x=x(3x+y),\quad \dot y=y(x-y)").darboux("x", "2x+y"),
    lambda: System(r"\dot x=x(3x+y),\quad \dot y=y(x-y)").darboux("y", "x-2y"),
    lambda: System(r"\dot x=y,\quad \dot y=-x").integral("x^2+2y^2"),
    lambda: System(r"\dot x=y,\quad \dot y=-x").identity(r"\ddot x=x"),
    lambda: System(r"\dot x=x-h").states(Equilibria, "rest", "", count=2, **REST),
    lambda: System(r"\dot x=x-h").states(Equilibria, "rest", "", count=0, **REST),
    lambda: System(r"\dot x=x^2-h").states(Equilibria, "rest", "", count=1, **REST),
]


@pytest.mark.parametrize("false", FALSE)
def test_what_is_recorded_of_a_correction_finds_it_again(false):
    claim = false()
    outcome = claim.outcome
    assert outcome.correction is not None
    on = Elaborations(derivation(claim.section).texts())
    found = recorded_correction(claim.claim, on, describe(outcome)["correction"])
    assert found[1].digest == outcome.correction.digest


@pytest.mark.parametrize(
    ("kind", "about", "passing"),
    [
        (RestPoint, {"printed": "(1,2)"}, True),
        (RestPoint, {"printed": "(1,1)"}, False),
        (RestPoint, {"printed": "(0,a)"}, False),
        (RestPoints, {"relations": ("x=1", "y=2")}, True),
        (RestPoints, {"relations": ("x=1", "y=x+2")}, None),  # a given name gives another
        (RestPoints, {"relations": ("x^2=x", "y=2")}, None),  # it gives no name
    ],
)
def test_points_are_tried_where_given_equations_give_names(kind, about, passing):
    plane = System(r"\dot x=x(1-x),\quad \dot y=y(2-y)")
    plane.states(kind, "rest", "", **about)
    session = Session(derivation(plane.section), ["flint"])
    (claim,) = session.derivation.claims
    on = session.on(claim)
    assert passes(Neighbour("", claim, on.texts), on, {}) is passing
