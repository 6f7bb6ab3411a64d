"""Each kind of claim on a small scene, where its truth is known."""

from dataclasses import replace
from itertools import product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.cli.formats.json import counterexample as in_tex
from kowalevski_cas.notation import Name, Number
from kowalevski_cas.paper.claims import (
    ChangedEquation,
    Claim,
    Coefficient,
    Definition,
    Degree,
    Dimension,
    DoubleZero,
    Equivalence,
    FirstIntegral,
    Identity,
    Implication,
    Independence,
    InvariantRelations,
    InvertibleChange,
    LastMultiplier,
    LocalDimension,
    Reality,
    Scaling,
    Unit,
)
from kowalevski_cas.paper.derivation import Change, Scene, Section
from kowalevski_cas.verify.outcome import in_latex
from tests.paper.plain import value
from tests.paper.small import (
    MOMENTUM,
    TWICE_ENERGY,
    Motion,
    Oscillator,
    Paper,
    Top,
    decide,
    verdicts,
)
from tests.sample import sampled


@pytest.fixture
def oscillator():
    return Oscillator()


@pytest.fixture
def top():
    return Top()


@pytest.mark.parametrize(
    ("tex", "verdict"),
    sampled(
        [
            (r"\dot x = v", "proved"),
            (r"\dot E = 0", "proved"),
            (r"\frac{d}{dt}(x v) = v^2 - x^2", "proved"),
            (r"\dot x = -v", "refuted"),
            (r"\frac{x^2}{x} = x", "conditional"),
            (r"2E = x^2 + v^2 = {\rm const}", "proved"),
            (r"x^2 - v^2 = {\rm const}", "refuted"),
            (r"x + v = {\rm const}", "refuted"),
            (r"y = x", "error"),
            (r"\frac{1}{x-x} = x", "error"),
        ],
        2,
    ),
)
def test_identity(oscillator, name, tex, verdict):
    assert oscillator.verdict(Identity, tex, arithmetics=(name,)) == verdict


def test_a_claim_without_a_goal_is_an_error(oscillator):
    class Nothing(Claim):
        def goals(self, on):
            return iter(())

    outcome = oscillator.outcome(Nothing)
    assert outcome.verdict == "error" and outcome.message == "t states nothing"


def test_not_equal_is_not_equal(oscillator):
    assert oscillator.verdict(Identity, r"x \ne x") != "proved"


def test_the_values_at_the_counterexample_are_those_of_the_two_sides(oscillator):
    shown = in_tex(oscillator.outcome(Identity, "x^2=3v").counterexample)
    x, v = (value(shown["point"][name]) for name in "xv")
    assert x**2 == value(shown["left"]) != value(shown["right"]) == 3 * v


# -- first integrals -----------------------------------------------------------------


@pytest.mark.parametrize(
    ("tex", "verdict"),
    sampled([(TWICE_ENERGY, "proved"), (MOMENTUM, "proved"), (r"\omega_1^2+\omega_2^2", "proved"),
     (r"\omega_1^2-\omega_2^2", "refuted"), (r"\omega_3", "refuted")], 1),
)  # fmt: skip
def test_first_integral(top, name, tex, verdict):
    assert top.verdict(FirstIntegral, tex, arithmetics=(name,)) == verdict


def test_a_partial_integral_is_constant_on_its_invariant_set(top):
    axis = top.all(r"\omega_1=0, \omega_2=0")
    partial = top.outcome(FirstIntegral, r"\omega_3", given=axis)
    assert (partial.verdict, partial.message) == ("proved", "")


def test_of_a_partial_integral_that_is_constant_everywhere_this_is_told(top):
    axis = top.all(r"\omega_1=0, \omega_2=0")
    energy = top.outcome(FirstIntegral, TWICE_ENERGY, given=axis)
    assert energy.verdict == "proved"
    assert energy.message == "it is constant along the motions off this set, too"


def test_what_stands_still_where_motions_pass_through_is_no_partial_integral(top):
    outcome = top.outcome(FirstIntegral, r"\omega_3", given=top.all(r"\omega_1=0"))
    assert outcome.verdict == "refuted"
    assert outcome.counterexample.point.values[Name(r"\omega_1")] == Number(0)


@pytest.mark.parametrize(
    ("chain", "verdict"),
    sampled(
        [
            (r"E = \frac{1}{2}(x^2+v^2) \equiv x", "refuted"),
            (r"E \equiv k", "proved"),
            ("E=1=2", "refuted"),
            ("E=2k=k", "refuted"),
            ("E=k=-k^2-1", "refuted"),
            ("E=k=1", "proved"),
            ("E=2=1+1", "proved"),
            (r"E=(k+1)^2-1=k^2+2k", "proved"),
        ],
        1,
    ),
)
def test_every_member_of_a_chain_is_constant_and_its_values_are_equal(oscillator, chain, verdict):
    assert oscillator.verdict(FirstIntegral, chain) == verdict


def test_a_variable_without_an_equation_of_motion_is_an_error():
    half = Motion(r"\dot v = -x", "x", "v")
    assert half.verdict(FirstIntegral, "x^2") == "error"


def test_a_member_that_is_no_vector_where_one_is_expected_is_an_error():
    vectors = {r"\boldsymbol{\alpha}": ("a", "b", "c")}
    moving = Motion(r"\dot{\bs\alpha}=a", "a", "b", "c", vectors=vectors)
    assert moving.verdict(FirstIntegral, "a") == "error"


# -- invariant sets ------------------------------------------------------------------


@pytest.mark.parametrize(
    ("relations", "verdict"),
    sampled(
        [
            (r"\omega_1=0, \omega_2=0", "proved"),
            (r"\omega_1=0", "refuted"),
            (rf"{MOMENTUM}=2({TWICE_ENERGY})", "proved"),  # the separatrices
            (r"\frac{\omega_1^2+\omega_2^2}{\omega_3}=\omega_3", "refuted"),
        ],
        1,
    ),
)
def test_invariant_relations(top, relations, verdict):
    outcome = top.outcome(InvariantRelations, relations=top.all(relations))
    assert outcome.verdict == verdict
    if relations == r"\omega_1=0":
        assert outcome.counterexample.point.values[Name(r"\omega_1")] == Number(0)


@pytest.mark.slow
def test_a_point_at_which_no_combination_gives_the_derivatives_denies_invariance():
    fall = Motion(r"\dot x=v, \dot v=g", "x", "v", constants=("g",))
    outcome = fall.outcome(InvariantRelations, relations=fall.all("x=0, v=0"))
    assert outcome.verdict == "refuted"
    assert outcome.counterexample.words.endswith(", and every combination of the functions is $0$")


def test_a_relation_that_says_nothing_is_no_reason_to_stop(top):
    relations = top.all(r"\omega_1=\omega_1, \omega_2=0")
    assert top.verdict(InvariantRelations, relations=relations) == "refuted"


@pytest.mark.slow
def test_last_multiplier(top):
    axis = InvariantRelations("axis", top.scene, "", relations=top.all(r"\omega_1=0, \omega_2=0"))
    assert top.verdict(LastMultiplier, relations=axis) == "proved"
    assert top.verdict(LastMultiplier, relations=axis, density=r"\omega_1") == "refuted"
    rest = top.outcome(LastMultiplier, relations=axis, density=TWICE_ENERGY)
    assert rest.verdict == "refuted"  # at rest the energy vanishes: it is no density there
    assert rest.message == "there is a real point where none is said to be"


# -- dimensions ----------------------------------------------------------------------


@pytest.mark.parametrize(("dimension", "verdict"), [(2, "proved"), (1, "refuted")])
def test_dimension(top, dimension, verdict):
    sphere = top.all(f"{MOMENTUM}=1")
    found = top.verdict(Dimension, levels=(), equations=sphere, dimension=dimension)
    assert found == verdict


@pytest.mark.parametrize(
    ("other", "verdict"), [(MOMENTUM, "proved"), (f"({TWICE_ENERGY})^2", "refuted")]
)
def test_independence(top, other, verdict):
    functions = (top(f"{TWICE_ENERGY}=1"), top(f"{other}=1"))
    assert top.verdict(Independence, levels=(), equations=(), functions=functions) == verdict


@pytest.mark.parametrize(
    ("tex", "dimension", "verdict"),
    [
        ("x=0", 1, "proved"),
        ("xv=0", 1, "proved"),
        ("x=0", 0, "refuted"),
        (r"x=0,\quad v=0", 0, "proved"),
        (r"x=0,\quad xv=0", 0, "undecided"),
        (r"x=0,\quad xv=0", 1, "undecided"),
        ("x^2+v^2=-1", 1, "undecided"),
    ],
)
def test_dimension_near_a_point(oscillator, tex, dimension, verdict):
    places = oscillator.all(tex)
    assert oscillator.verdict(LocalDimension, equations=places, dimension=dimension) == verdict


def test_functions_of_low_rank_at_a_few_points_may_be_independent():
    plane = Motion(r"\dot x=0, \dot y=0", "x", "y")
    special = "".join(f"(y-{n})(y+{n})" for n in range(1, 7))
    functions = plane.all(f"x=0, [{special}]^2=0")
    verdict = plane.verdict(Independence, levels=(), equations=(), functions=functions)
    assert verdict not in ("refuted", "error")


@pytest.mark.parametrize(("graph", "verdict"), [("y=x^2", "proved"), ("y=1", "undecided")])
def test_dependence_on_another_graph_than_the_set_refutes_nothing(graph, verdict):
    """On the line y=1 the functions depend on each other; on the parabola they do not."""
    space = Motion(r"\dot x=0, \dot y=0, \dot z=0", "x", "y", "z")
    found = space.verdict(
        Independence, levels=(), equations=space.all("y=x^2"),
        functions=space.all("y=0, z=0"), graph=space.all(graph),
    )  # fmt: skip
    assert found == verdict


# -- what follows --------------------------------------------------------------------


@pytest.mark.parametrize(
    ("given", "main", "tex", "verdict", "where"),
    [
        ("x^2=1-v^2", (), "2E=1", "proved", []),
        ("x^2=1-v^2", (), "x=1", "refuted", []),
        ("xv=0", (("v",),), "v=0", "conditional", [Name("x")]),
    ],
)
def test_implication(oscillator, given, main, tex, verdict, where):
    found = oscillator.outcome(Implication, tex, given=oscillator.all(given), main=main)
    assert found.verdict == verdict
    assert [condition.expression for condition in found.conditions] == where


@pytest.mark.parametrize(("side", "verdict"), sampled([("x", "proved"), ("2x", "refuted")], 1))
def test_an_implication_for_one_of_two_roots(oscillator, side, verdict):
    root, given = r"\sqrt{x^2+v^2}", oscillator.all("v=0")
    found = oscillator.verdict(Implication, f"{side}={root}", given=given, root=root)
    assert found == verdict


HYPOTHESES = {
    "z=0": lambda x, z, r: z == 0,
    "x=0": lambda x, z, r: x == 0,
    "z^2=y": lambda x, z, r: z * z == r * r,
    "z=2r": lambda x, z, r: z == 2 * r,
}
MEANINGS = {"u=r": lambda x, r: r, "u=x-r": lambda x, r: x - r, "u=x": lambda x, r: x}


@given(
    st.lists(st.sampled_from([*HYPOTHESES]), min_size=1, max_size=2, unique=True),
    st.sampled_from([*MEANINGS]), *[st.integers(-1, 1)] * 2,
)  # fmt: skip
def test_what_holds_for_one_of_two_roots(hypotheses, meaning, a, b):
    """With either value of r, and of what is made of it; a name that hides it is an error."""
    paper = Paper()
    paper.scene = Scene(
        "s", variables=("x", "y", "z"), roots={"r": paper("r^2=y")},
        definitions={"u": paper(meaning)},
    )  # fmt: skip
    formula, known = f"z={a}r+({b})u", tuple(map(paper, hypotheses))
    found = paper.verdict(Implication, formula, given=known, root="r")
    for x, z, r in product(range(-2, 3), repeat=3):
        if all(HYPOTHESES[one](x, z, r) for one in hypotheses):
            either = any(z == a * s + b * MEANINGS[meaning](x, s) for s in (r, -r))
            assert either or found not in ("proved", "conditional")


@pytest.mark.parametrize(
    ("root", "words"),
    sampled(
        [
            ("x", "x is no root"),
            ("2r", "2r is no root"),
            ("s", "is no root"),
            ("r", "another root"),
        ],
        1,
    ),
)
def test_a_root_that_is_none_or_stands_in_another_one(root, words):
    paper = Paper()
    roots = {"r": paper("r^2=y"), "s": paper("s^2=x+r")}
    paper.scene = Scene("s", variables=("x", "y", "z"), roots=roots)
    outcome = paper.outcome(Implication, "zs=rs", given=(paper("z=y"),), root=root)
    assert (words in outcome.message) == (root != "s")


@pytest.mark.parametrize(
    ("kind", "tex"), sampled([(Implication, "z=0"), (FirstIntegral, "z^2")], 1)
)
def test_a_condition_that_the_set_excludes_proves_nothing(kind, tex):
    moving = Motion(r"\dot x=x, \dot z=1", "x", "z")
    given = moving.all("x=0, xz=0")
    assert moving.verdict(kind, tex, given=given, main=(("z",),)) == "refuted"


@pytest.mark.parametrize(
    ("tex", "verdict", "where"),
    [("2v=2x", "proved", []), ("x^2=xv", "conditional", [Name("x")]), ("x=-v", "refuted", [])],
)
def test_equivalence(oscillator, tex, verdict, where):
    found = oscillator.outcome(Equivalence, tex, to=oscillator("x=v"))
    assert found.verdict == verdict
    assert [condition.expression for condition in found.conditions] == where


@pytest.mark.parametrize(
    ("tex", "verdict"),
    sampled(
        [
            ("(x+v)^2 - kx^2v^2", "proved"),
            ("(x-v)^2 + x^2v^2 - x^3", "proved"),
            ("x^2", "proved"),
            ("x + v^2", "refuted"),
            ("xv + 1", "refuted"),
            ("x^2 = xv^2", "proved"),
            ("x = v^2", "refuted"),
        ],
        1,
    ),
)
def test_double_zero(oscillator, name, tex, verdict):
    given = oscillator.all("x = 0, v = 0")
    assert oscillator.verdict(DoubleZero, tex, given=given, arithmetics=(name,)) == verdict


# -- coefficients --------------------------------------------------------------------


@pytest.mark.parametrize(
    ("tex", "derivative", "verdict"),
    sampled(
        [
            (r"\omega_1\omega_3+\omega_2=\omega_1\omega_3+\dots", "", "proved"),
            (r"\omega_1\omega_3=2\omega_1\omega_3+\dots", "", "refuted"),
            (r"\omega_1\omega_3+\omega_2=\omega_1\omega_3", "", "refuted"),  # no dots are printed
            (r"-\omega_2", r"\omega_1", "proved"),
            (r"\omega_2", r"\omega_1", "refuted"),
        ],
        2,
    ),
)
def test_coefficient(top, tex, derivative, verdict):
    of = {"derivative_of": top(derivative)} if derivative else {}
    assert top.verdict(Coefficient, tex, variable=r"\omega_3", **of) == verdict


@pytest.mark.parametrize(("degree", "verdict"), [(1, "proved"), (0, "refuted")])
def test_the_arithmetics_agree_on_the_degree(top, degree, verdict):
    found = top.outcome(Degree, variable=r"\omega_3", degree=degree, arithmetics=EXACT)
    assert found.verdicts == dict.fromkeys(EXACT, verdict)


# -- complex variables ---------------------------------------------------------------


@pytest.mark.parametrize(
    ("real", "imaginary", "verdict"),
    [
        (("z_1z_2", "z_1+z_2"), ("z_1-z_2",), "proved"),
        (("z_1",), (), "refuted"),
        ((), ("z_1z_2",), "refuted"),
    ],
)
def test_reality(oscillator, real, imaginary, verdict):
    found = oscillator.verdict(Reality, on=oscillator.new, real=real, imaginary=imaginary)
    assert found == verdict


def test_a_change_of_variables(oscillator):
    rows = oscillator.all(r"z_1'=-z_1,\quad z_2'=z_2,\quad z_1'=z_1")
    old, new = oscillator.old, oscillator.new
    found = decide(
        oscillator.section,
        Unit("unit", old, "", printed=oscillator.unit[1], rows=rows[:2]),
        InvertibleChange("change", new, "", old=old, pairs=(("z_1", "z_2"),)),
        *(ChangedEquation(f"row{k}", new, "", printed=row, old=old) for k, row in enumerate(rows)),
    )
    assert [str(o.verdict) for o in found] == ["proved", "proved", "proved", "proved", "refuted"]
    assert in_latex(found[-1].correction.formulas) == "z_1' = -z_1"


@pytest.mark.parametrize("second", sampled(["2x+2iv", "-x-iv", "ix-v", "0"], 2))
@pytest.mark.parametrize("pairs", [(("z_1", "z_2"),), ()])
def test_a_singular_change_is_refuted_and_gives_no_scene(oscillator, second, pairs):
    texts = {"change": rf"z_1=x+iv,\quad z_2={second}"}
    claim = InvertibleChange("change", oscillator.new, "", old=oscillator.old, pairs=pairs)
    there = ChangedEquation(
        "there", oscillator.new, "", oscillator.old, printed=oscillator("z_1'=z_1")
    )
    change, there = decide(oscillator.section, claim, there, sources=texts)
    assert change.verdict == "refuted" and there.verdict == "error"
    assert change.message == "the differentials depend on each other everywhere"
    assert there.message == "the change of variables is not invertible"


@pytest.mark.parametrize(("sign", "verdict"), [("", "proved"), ("-", "refuted")])
def test_a_derivative_by_real_time_is_conjugated_as_such(sign, verdict):
    real = Paper()
    unit, tau = real("i^2=-1"), real(r"\tau=1t")
    rows, complex_ones = real.all(r"\dot x = v, \dot v = -x"), real.all("z_1=x+iv, z_2=x-iv")
    old = Scene("old", variables=("x", "v"), field=rows, unit=unit, clock=tau)
    new = Scene(
        "new", variables=("z_1", "z_2"), field=Change(old, complex_ones, tau), time=r"\tau",
        conjugates=(("z_1", "z_2"),), unit=unit,
    )  # fmt: skip
    assert real.verdict(Identity, rf"\overline{{z_1'}}={sign}z_2'", new) == verdict


@pytest.mark.parametrize(("tex", "verdict"), [("2u'=v-u", "proved"), ("u'=v-u", "refuted")])
def test_a_change_of_real_variables_and_of_the_time_needs_no_unit(tex, verdict):
    motion = Motion(r"\dot x=y, \dot y=-x", "x", "y")
    change = Change(motion.scene, motion.all("u=x, v=x+y"), motion(r"\tau=2t"))
    new = Scene("new", variables=("u", "v"), field=change, time=r"\tau")
    assert motion.verdict(Identity, tex, new) == verdict


# -- roots and definitions -----------------------------------------------------------


def test_a_root_of_a_complex_number_is_not_real():
    paper = Paper()
    scene = Scene(
        "s", variables=("x_1", "x_2"), conjugates=(("x_1", "x_2"),),
        field=paper.all(r"\dot x_1=0, \dot x_2=0"), roots={"u": paper("u^2=x_1")},
    )  # fmt: skip
    assert paper.verdict(Identity, r"\overline{u}=u", scene) != "proved"


@pytest.mark.parametrize(
    ("tex", "verdict"), [(r"\sqrt{x^2} = -x", "proved"), (r"\sqrt{x^2} = 2x", "error")]
)
def test_a_root_with_a_printed_value_has_to_have_the_square(tex, verdict):
    paper = Paper()
    scene = Scene("root", variables=("x",), roots={r"\sqrt{x^2}": paper(tex)})
    assert paper.verdict(Identity, r"x\sqrt{x^2} = -x^2", scene) == verdict


def test_a_root_that_moves_is_differentiated_without_a_division():
    paper = Paper()
    scene = Scene(
        "circle", variables=("s",), constants=("n",), field=paper.all(r"\dot s = nC"),
        roots={"C": paper("C^2 = 1-s^2")},
    )  # fmt: skip
    assert paper.verdict(Identity, r"\dot C = -ns", scene) == "proved"


@pytest.mark.parametrize(
    ("tex", "verdict"),
    [(r"f(s) = s^2 - 1", "proved"), (r"f(s) = s^2 + 1", "refuted"), (r"f(s) = f(s)", "error")],
)
def test_definition_of_a_function(name, tex, verdict):
    section = Section("1", "A function")
    printed = section.inline("f", tex)
    equation = section.inline("e", r"f(x) - f(y) = (x-y)(x+y), \quad f(1) = 0")
    scene = Scene("f", variables=("x", "y"), definitions={"f(s)": printed[1]})
    first, second = (
        Definition(f"t.{k}", scene, "", printed=printed[1], equation=equation[k]) for k in (1, 2)
    )
    found = verdicts(section, first, second, arithmetics=(name,))
    assert found[1] == verdict and (verdict == "error" or found[0] == "proved")


@pytest.mark.parametrize(
    ("tex", "verdict"), [("D = x^2", "proved"), ("D = x^3", "refuted"), ("v = x^2", "refuted")]
)
def test_a_definition_defines_the_name_that_it_prints(oscillator, tex, verdict):
    printed, equation = oscillator(tex), oscillator(r"\dot D = 2xv")
    scene = replace(oscillator.scene, definitions={"D": printed})
    claim = Definition("t", scene, "", printed=printed, equation=equation)
    assert verdicts(oscillator.section, claim) == [verdict]


# -- scalings ------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("unit", "granted", "verdict"),
    [
        ("k", (), "conditional"),
        ("k", ("k",), "proved"),
        ("2k", ("k",), "refuted"),
        ("k-k", (), "error"),
    ],
)
def test_a_unit_of_time_is_not_zero(unit, granted, verdict):
    """x' = x becomes x' = kx in the unit k; where k = 0 there is no time in this unit."""
    paper = Paper()
    scene = Scene(
        "s", variables=("x",), constants=("k",), field=(paper(r"\dot x=x"),), nonzero=granted
    )
    simple = Scene("simple", variables=("x",), constants=("k",), field=(paper(r"\dot x=kx"),))
    measures = ((("x",), 0, "1"),)
    outcome = paper.outcome(Scaling, unit, scene, simple=simple, measures=measures)
    assert outcome.verdict == verdict
    assert in_latex([one.expression for one in outcome.conditions]) == "k" * (
        verdict == "conditional"
    )
