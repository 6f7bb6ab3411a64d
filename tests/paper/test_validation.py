"""A scene on which anything could be shown is an error that says where, and what to do."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.paper.claims import FirstIntegral, Identity, InvariantRelations
from kowalevski_cas.paper.derivation import Change, Locus, Scene
from kowalevski_cas.verify.outcome import in_latex
from tests.paper.small import Paper, verdicts

pytestmark = pytest.mark.usefixtures("uncorrected")


@pytest.fixture
def paper():
    return Paper()


def refused(outcome, *words):
    assert outcome.verdict == "error"
    for word in words:
        assert word in outcome.message


# -- names ---------------------------------------------------------------------------


@pytest.mark.parametrize(
    "twice",
    [
        {"variables": ("x", "x")},
        {"variables": ("x",), "constants": ("x",)},
        {"constants": ("x",), "undefined": ("x",)},
        {"variables": ("x", "y"), "vectors": {r"\boldsymbol{\alpha}": ("x", "x", "y")}},
        {"variables": ("x",), "powers": (("x", "m"), ("x", "m"))},
    ],
)
def test_a_name_is_given_once(twice):
    with pytest.raises(ValueError, match=r"the scene “s”: .* has a meaning already, a"):
        Scene("s", **twice)


def test_a_name_is_not_defined_and_something_else(paper):
    square, line, unit = map(paper, ("r^2=x", "r=2x", "i^2=-1"))
    for more in (
        {"roots": {"r": square}, "definitions": {"r": line}},
        {"definitions": {"x": line}},
        {"constants": ("i",), "unit": unit},
        {"constants": ("f",), "definitions": {"f(s)": line}},
    ):
        with pytest.raises(ValueError, match="choose another name, or leave one out"):
            Scene("s", variables=("x",), **more)


def test_a_display_is_no_tuple_and_no_statement(paper):
    pair = paper.display("x=0, y=0")
    scene = Scene("s", variables=("x", "y"))
    for make in (
        lambda: InvariantRelations("t", scene, "", relations=pair),
        lambda: FirstIntegral("t", scene, "", printed=pair[1], given=pair),
        lambda: FirstIntegral("t", scene, "", printed=pair[1], given=pair[2]),
        lambda: Identity("t", scene, "", printed=pair),
        lambda: Scene("s", variables="xy"),
        lambda: Scene("s", field=pair),
        lambda: Change(scene, pair, pair[1]),
        lambda: Locus("x=0", "x=0", "x"),
    ):
        with pytest.raises(TypeError, match=r"is to (hold statements|be a tuple)"):
            make()


# -- conjugation ---------------------------------------------------------------------


@given(st.lists(st.tuples(*[st.sampled_from(["x", "y", "z", "c", "d"])] * 2), max_size=3))
def test_a_conjugation_is_an_involution_that_keeps_variables_and_constants(pairs):
    """The conjugate of the conjugate of each name is the name, or there is an error."""
    paper = Paper()
    scene = Scene("s", variables=("x", "y", "z"), constants=("c", "d"), conjugates=(*pairs,))
    outcome = paper.outcome(Identity, r"\overline{\overline{x+2y+3z+4c+5d}}=x+2y+3z+4c+5d", scene)
    names = [name for pair in pairs for name in pair]
    odd = len(set(names)) < len(names) or any((a in "cd") != (b in "cd") for a, b in pairs)
    assert (outcome.verdict == "error") == odd
    assert outcome.verdict in ("error", "proved")


def test_conjugate_roots_have_conjugate_squares():
    for second, verdict in (("w^2=y", "proved"), ("w^2=2y", "error")):
        paper = Paper()
        scene = Scene(
            "s", variables=("x", "y"), roots={"u": paper("u^2=x"), "w": paper(second)},
            conjugates=(("x", "y"), ("u", "w")),
        )  # fmt: skip
        assert paper.outcome(Identity, r"\overline{u}=w", scene).verdict == verdict


def test_a_motion_keeps_the_conjugation_in_real_or_imaginary_time():
    """The time t is real, and another one may be imaginary."""
    for time, second, verdict in (
        ("t", "-iy", "proved"),
        ("t", "iy", "error"),
        (r"\tau", "-iy", "proved"),
        (r"\tau", "iy", "proved"),
        (r"\tau", "y", "error"),
    ):
        paper = Paper()
        rate = "{}'" if time == r"\tau" else r"\dot {}"
        field = paper.all(rf"{rate.format('x')}=ix, \quad {rate.format('y')}={second}")
        scene = Scene(
            "s", variables=("x", "y"), field=field, conjugates=(("x", "y"),),
            unit=paper("i^2=-1"), time=time,
        )  # fmt: skip
        assert paper.outcome(Identity, rf"{rate.format('x')}=ix", scene).verdict == verdict
        assert paper.outcome(Identity, r"\overline{x}=y", scene).verdict == (
            "error" if (time, verdict) == ("t", "error") else "proved"
        )


# -- motion and time -----------------------------------------------------------------


def test_each_variable_moves_by_one_equation(paper):
    field = paper.all(r"\dot x=x, \quad \dot x=0")
    outcome = paper.outcome(Identity, r"\dot x=0", Scene("s", variables=("x",), field=field))
    refused(outcome, "“s”", "d0.1", "d0.2", "leave one out")


def test_a_root_moves_as_its_square_does():
    for rate, verdict in ((r"\frac{1}{2u}", "conditional"), ("1", "error")):
        paper = Paper()
        field = paper.all(rf"\dot x=1, \quad \dot u={rate}")
        scene = Scene(
            "s", variables=("x",), roots={"u": paper("u^2=x")}, field=field
        )  # fmt: skip
        assert paper.outcome(Identity, r"\dot u u=\frac12", scene).verdict == verdict


@pytest.mark.parametrize("scale", ["0", "x", "(k-k)"])
def test_another_time_is_a_constant_multiple_that_is_not_zero(paper, scale):
    clock = paper(rf"\tau={scale}t")
    slow = Scene(
        "slow", variables=("x",), constants=("k",), field=paper.all("x'=x"), time=r"\tau",
        clock=clock,
    )  # fmt: skip
    refused(paper.outcome(Identity, r"\dot x=0", slow), "“slow”", "d0.1", "other than zero")
    old = Scene("old", variables=("x",), constants=("k",), field=paper.all(r"\dot x=x"))
    new = Scene(
        "new", variables=("y",), constants=("k",), field=Change(old, (paper("y=2x"),), clock),
        time=r"\tau",
    )  # fmt: skip
    refused(paper.outcome(Identity, "y'=y", new), "“old”", "other than zero")


# -- roots and assumptions -----------------------------------------------------------


@given(st.lists(st.integers(-2, 2), min_size=1, max_size=5))
def test_the_square_of_a_root_is_found_exactly_or_not_at_all(coefficients):
    """For r^2 + p(r) = x nothing but x - p(0) is the square, and that only if p is constant."""
    paper = Paper()
    terms = "".join(f"{c:+d}r^{{{k}}}" for k, c in enumerate(coefficients))
    scene = Scene("s", variables=("x",), roots={"r": paper(f"r^2{terms}=x")})
    outcome = paper.outcome(Identity, f"r^2=x-({coefficients[0]})", scene)
    factor = 1 + (coefficients[2] if len(coefficients) > 2 else 0)
    even = factor and not any(c for k, c in enumerate(coefficients) if k not in (0, 2))
    assert outcome.verdict == ("error" if not even else "proved" if factor == 1 else "refuted")


def test_a_polynomial_that_is_a_square_at_some_numbers_is_none(paper):
    scene = Scene("s", variables=("x",), roots={"r": paper("r^2+r(r-1)(r+1)(r-2)=x")})
    refused(paper.outcome(Identity, "r^2=x", scene), "d0.1", "does not give r^2")


def test_a_root_by_which_is_divided_is_not_solved_for(paper):
    scene = Scene("s", variables=("x",), roots={"r": paper(r"\frac{r^4}{r^2}=x")})
    refused(paper.outcome(Identity, "r^2=x", scene), "d0.1", "does not give r^2")


def test_all_members_of_a_chain_give_the_same_square():
    for tex, verdict in (("r^2+x=y=x+y^2", "error"), ("r^2+x=y=y+x-x", "proved")):
        paper = Paper()
        scene = Scene("s", variables=("x", "y"), roots={"r": paper(tex)})
        assert paper.outcome(Identity, "r^2=y-x", scene).verdict == verdict


def test_a_root_is_not_divided_by_what_may_vanish(paper):
    place = paper("xr^2=xy")
    scene = Scene("s", variables=("x", "y"), roots={"r": place})
    refused(paper.outcome(Identity, "r^2=y", scene), "“s”", "x is not zero", "nonzero")
    assert paper.outcome(Identity, "r^2=y", scene.having(nonzero=("x",))).verdict == "proved"


def test_a_root_is_not_divided_by_what_is_granted_with_the_other_sign_of_a_root(paper):
    roots = {"s": paper("s^2=z"), "r": paper("(x-s)r^2=(x-s)y")}
    scene = Scene("s", variables=("x", "y", "z"), roots=roots)
    refused(paper.outcome(Identity, "r^2=y", scene.having(nonzero=("x+s",))), "nonzero")
    assert paper.outcome(Identity, "r^2=y", scene.having(nonzero=("x^2-z",))).verdict == "proved"


@given(st.lists(st.integers(-3, 3), min_size=3, max_size=3))
def test_a_real_root_has_a_square_that_is_positive_somewhere(numbers):
    a, b, c = numbers
    paper = Paper()
    place = paper(f"r^2={a}x^2{b:+d}y^2{c:+d}")
    scene = Scene("s", variables=("x", "y"), roots={"r": place})
    outcome = paper.outcome(Identity, r"\overline{r}=r", scene)
    assert (outcome.verdict == "error") == (max(numbers) <= 0 and any(numbers))


def test_a_value_that_is_printed_for_a_root_is_said_with_the_verdict(paper):
    place = paper(r"\sqrt{x^2}=-x")
    scene = Scene("s", variables=("x",), roots={r"\sqrt{x^2}": place})
    outcome = paper.outcome(Identity, r"x\sqrt{x^2}=-x^2", scene)
    assert outcome.verdict == "proved"
    assert in_latex(outcome.branches) == r"\sqrt{x^2} = -x"


@pytest.mark.parametrize("assumed", [("x-x",), ("r^2-x^2-1",), ("r-x", "y", "r+x-r-x")])
def test_what_is_assumed_is_not_zero_by_the_relations(paper, assumed):
    place = paper("r^2=x^2+1")
    scene = Scene("s", variables=("x", "y"), roots={"r": place}, nonzero=assumed)
    refused(paper.outcome(Identity, "x=x", scene), "“s”", assumed[-1], "taken for granted")


def test_two_assumptions_may_contradict_each_other(paper):
    scene = Scene("s", variables=("x",), roots={"r": paper("r^2=x^2")})
    assert paper.outcome(Identity, "r=-x", scene.having(nonzero=("r-x",))).verdict != "proved"
    refused(paper.outcome(Identity, "x=x", scene.having(nonzero=("r-x", "r+x"))), "r+x")


def test_a_scene_is_refused_for_each_claim_on_it(paper):
    scene = Scene("s", variables=("x",), nonzero=("x-x",))
    claims = [Identity(f"t{k}", scene, "", printed=paper("x=x")) for k in (1, 2)]
    assert verdicts(paper.section, *claims) == ["error", "error"]


@pytest.mark.parametrize("tex", ["i^2=1", "i^2=x", "i^2=2"])
def test_the_letter_i_is_no_root_but_the_imaginary_unit(tex, paper):
    with pytest.raises(ValueError, match="i is the imaginary unit, and no other root"):
        Scene("s", variables=("x",)).adjoining(paper(tex))


@pytest.mark.parametrize(
    ("attribute", "value"),
    [
        ("definitions", {"F": "x^2"}),
        ("roots", {"r": "x^2"}),
        ("unit", "i^2=-1"),
        ("clock", r"\tau=it"),
        ("zero", ("x=0",)),
        ("field", ("x'=y",)),
        ("variables", ("x", 3)),
        ("constants", "c"),
        ("time", 0),
        ("name", None),
        ("vectors", {"v": ("x", 1)}),
        ("conjugates", (("x", 2),)),
    ],
)
def test_an_attribute_of_another_type_is_refused_by_name(attribute, value):
    with pytest.raises(TypeError, match=f"the scene “.*”: {attribute} is to "):
        Scene(**{attribute: value})


def test_what_names_something_is_a_place_and_no_tex():
    with pytest.raises(TypeError, match="definitions is to hold a statement, as display"):
        Scene("s", variables=("x",)).naming("F", "x^2")
