"""A statement about a set is about all of it: no point makes it green by itself."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kowalevski_cas.notation import to_latex
from kowalevski_cas.paper.claims import (
    ConstantRoot,
    Dimension,
    Equivalence,
    FirstIntegral,
    Independence,
    InvariantRelations,
    LastMultiplier,
    Unit,
)
from kowalevski_cas.paper.derivation import Locus, Scene
from tests.paper.small import Motion, Paper, verdicts
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

CIRCLES = r"\dot x=y, \dot y=-x"
SPACE = Scene("space", variables=("x", "y", "z"))


@pytest.fixture
def paper():
    return Paper()


def dimension(paper, number, *equations, on=SPACE):
    places = tuple(map(paper, equations))
    return paper.outcome(Dimension, on=on, levels=(), equations=places, dimension=number)


# -- dimension -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("equations", "number", "verdict"),
    sampled(
        [
            (("x^2+y^2+z^2=1",), 2, "proved"),
            (("x^2+y^2=1", "z=xy"), 1, "proved"),
            (("x^2+y^2+z^2=1", "x=2"), 1, "undecided"),  # no real point
            (("x^2+y^2=0",), 2, "undecided"),  # a line, where the differential vanishes
            (("xz=0", "yz=0"), 1, "undecided"),  # a line, and a plane
            (("xz=0", "yz=0"), 2, "refuted"),
            (("xy=0",), 2, "undecided"),  # two planes, which meet
            (("x^3=y^2",), 2, "undecided"),  # a cusp
            (("x=y", "2x=2y"), 2, "undecided"),  # a plane, with one equation too many
            (("x^2+y^2+z^2=1",), 1, "refuted"),
        ],
        3,
    ),
)
def test_a_manifold_is_one_at_each_point(paper, equations, number, verdict):
    assert dimension(paper, number, *equations).verdict == verdict


def test_a_declared_locus_is_the_condition_and_the_point_says_why(paper):
    axis = SPACE.having(loci=(Locus("$x=y=0$", ("x=0", "y=0"), "x^2+y^2"),))
    outcome = dimension(paper, 2, "xy=0", on=axis)
    assert outcome.verdict == "conditional"
    (condition,) = outcome.conditions
    assert to_latex(condition.expression) == "x^2 + y^2"
    assert to_latex(condition.witness.left) == "0" and to_latex(condition.witness.right) == "1"


@pytest.mark.parametrize(
    ("left", "said"),
    [
        ("y", "has dimension 2"),
        ("3y-z", "has dimension 2"),
        ("y^2", None),  # a plane all the same: what the rank leaves is no dimension
        ("y^2+z^2", None),  # a line
    ],
)
def test_the_dimension_on_a_locus_is_said_where_the_equations_are_independent(paper, left, said):
    scene = SPACE.having(constants=("a",), loci=(Locus("$a=0$", ("a=0",), "a"),))
    outcome = dimension(paper, 1, "ax=0", f"{left}+a(z+y)=0", on=scene)
    (condition,) = outcome.conditions
    assert to_latex(condition.expression) == "a"
    assert (said in condition.words) if said else ("has dimension" not in condition.words)
    assert ("not certified" in condition.words) == bool(said)
    assert "differentials are independent" in condition.witness.words and condition.singular


def test_complex_equations_count_twice(paper):
    scene = Scene("s", variables=("x", "y"), conjugates=(("x", "y"),))
    alone = dimension(paper, 1, "x=0", on=scene)
    assert alone.verdict == "error" and "conjugate" in alone.message
    assert dimension(paper, 0, "x=0", "y=0", on=scene).verdict == "proved"
    assert dimension(paper, 1, "xy=1", on=scene).verdict == "proved"


THREE = st.lists(st.integers(-3, 3), min_size=3, max_size=3)


@pytest.mark.slow
@settings(max_examples=settings.default.max_examples // 2)
@given(THREE, THREE)
def test_quadrics_through_a_rational_point_are_manifolds_but_for_cones(squares, point):
    """a x^2 + b y^2 + c z^2 = d is regular exactly if it does not hold where the slope vanishes."""
    a, b, c = squares
    level = sum(n * x * x for n, x in zip(squares, point, strict=True))

    def outcome(right):
        return dimension(Paper(), 2, f"{a}x^2{b:+d}y^2{c:+d}z^2={right}")

    assert outcome(level).verdict == "proved" if level else not outcome(0).verdict.green
    if all(n * level >= 0 for n in squares):  # the left side never has the other sign
        assert not outcome(-level).verdict.green


# -- independence --------------------------------------------------------------------


def test_functions_are_independent_on_a_set_that_is_a_graph(paper):
    def outcome(equations, graph, *functions):
        places = tuple(paper(f"{tex}=1") for tex in functions)
        return paper.outcome(
            Independence, on=SPACE, levels=(), equations=paper.all(equations), functions=places,
            graph=paper.all(graph),
        )  # fmt: skip

    assert outcome("z-xy=0", "z=xy", "x", "z").verdict == "proved"
    assert outcome("z-xy=0", "z=xy", "xy", "z").verdict == "refuted"
    assert outcome("xz-y=0", r"z=\frac{y}{x}", "x", "z").verdict == "conditional"
    # On the plane z=0, but not on the line x=y=0, they are independent.
    assert outcome("xz=0, yz=0", "z=0", "x", "y").verdict == "undecided"


def test_a_rank_at_a_point_is_none_of_a_set_that_may_fall_apart(paper):
    root = SPACE.solving("r", paper("r^2=x^2"))
    each = tuple(paper(f"{tex}=1") for tex in ("r+2x", "y"))
    on_each = paper.outcome(Independence, on=root, levels=(), equations=(), functions=each)
    assert on_each.verdict.green
    places = tuple(paper(f"{tex}=1") for tex in ("r+x", "y"))
    outcome = paper.outcome(Independence, on=root, levels=(), equations=(), functions=places)
    assert outcome.verdict == "undecided"


# -- integrals -----------------------------------------------------------------------


@pytest.mark.parametrize("equation", ["x=0", "x^2=0"])
def test_a_partial_integral_needs_an_invariant_set(equation):
    flow = Motion(r"\dot x=1, \dot y=x", "x", "y")
    assert not flow.outcome(FirstIntegral, "y", given=flow.all(equation)).verdict.green


@pytest.mark.parametrize("tex", ["5", "k^2", "x-x", "x^2+y^2-x^2-y^2+k"])
def test_a_constant_is_no_integral(tex):
    outcome = Motion(CIRCLES, "x", "y", constants=("k",)).outcome(FirstIntegral, tex)
    assert outcome.verdict == "refuted"
    assert outcome.message == "the function is constant by itself"


def test_what_vanishes_on_a_set_is_no_partial_integral():
    flow = Motion(r"\dot x=x, \dot y=1", "x", "y")
    assert not flow.outcome(FirstIntegral, "xy", given=flow.all("x=0")).verdict.green


@given(st.integers(1, 4), st.integers(1, 4))
def test_all_members_of_a_chain_are_the_same_integral(first, second):
    tex = rf"{first}(x^2+y^2)={second}x^2+{second}y^2 \equiv e"
    verdict = Motion(CIRCLES, "x", "y", constants=("e",)).verdict(FirstIntegral, tex)
    assert verdict == ("proved" if first == second else "refuted")


@pytest.mark.parametrize(("name", "verdict"), [("x", "proved"), ("y", "refuted")])
def test_a_constant_root_is_made_of_constants(name, verdict):
    flow = Motion(r"\dot x=0, \dot y=1", "x", "y", constants=("s",))
    assert flow.verdict(ConstantRoot, f"s^2={name}^2", unknown="s", basis=(name,)) == verdict


# -- equations, densities, units -----------------------------------------------------


def test_an_equivalence_does_not_exclude_its_set():
    """x^2 = 0 follows from x = 0, and the converse has no division by what vanishes there."""
    for own, to in (("x^2=0", "x=0"), (r"\frac{x^2}{x}=0", "x=0"), (r"\frac{1}{x}=y", "x=0")):
        paper = Paper()
        assert not paper.outcome(Equivalence, own, SPACE, to=paper(to)).verdict.green


@pytest.mark.parametrize("density", ["0", "x-x", "(x^2+y^2-1)"])
def test_a_last_multiplier_vanishes_nowhere(density):
    flow = Motion(CIRCLES, "x", "y")
    circle = InvariantRelations("circle", flow.scene, "", relations=flow.all("x^2+y^2=1"))
    assert flow.verdict(LastMultiplier, relations=circle, density=density) == "refuted"


@pytest.mark.parametrize(
    ("rows", "verdict"),
    [
        ((r"uw=x^2-y^2",), "proved"),
        ((r"uw=x^2+y^2",), "refuted"),
        ((r"u+w=2x",), "error"),  # it does not see the unit
        ((r"u+w=2x", r"uw=x^2-y^2", "u=5"), "proved"),
        ((r"uw=x^2-y^2", r"(u-w)^2=-4y^2"), "error"),  # one vote for each
        ((r"uw=x^2-y^2", r"(u-w)^2=-4y^2", r"(u-w)^2+4y^2=0"), "refuted"),
    ],
)
def test_rows_vote_for_a_unit_that_they_see(paper, rows, verdict):
    unit = paper("i^2=1")
    scene = SPACE.with_unit(unit).defining(*paper.all("u=x+iy, w=x-iy"))
    claim = Unit("t", scene, "", printed=unit, rows=tuple(map(paper, rows)))
    assert verdicts(paper.section, claim) == [verdict]
