"""Each kind of claim on a small scene, where its truth is known."""

import pytest

from kowalevski_cas.cli.formats.json import counterexample as in_tex
from kowalevski_cas.notation import Name, Number
from kowalevski_cas.paper.claims import (
    ChangedEquation,
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
    Unit,
)
from kowalevski_cas.paper.derivation import Change, Scene, Section
from kowalevski_cas.verify.outcome import in_latex
from tests.paper.plain import value
from tests.paper.small import MOMENTUM, TWICE_ENERGY, Oscillator, Top, decide, verdicts
from tests.sample import sampled


@pytest.fixture
def oscillator():
    return Oscillator()


@pytest.fixture
def top():
    return Top()


@pytest.mark.parametrize(
    ("tex", "verdict"),
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
)
def test_identity(oscillator, name, tex, verdict):
    claim = Identity("t", oscillator.scene, "", printed=oscillator(tex))
    assert verdicts(oscillator.section, claim, arithmetics=(name,)) == [verdict]


def test_the_values_at_the_counterexample_are_those_of_the_two_sides(oscillator):
    (outcome,) = decide(
        oscillator.section, Identity("t", oscillator.scene, "", printed=oscillator("x^2=3v"))
    )
    shown = in_tex(outcome.counterexample)
    left, right, x, v = (
        value(tex)
        for tex in (shown["left"], shown["right"], shown["point"]["x"], shown["point"]["v"])
    )
    assert left == x**2 and right == 3 * v and left != right


@pytest.mark.parametrize(
    ("tex", "verdict"),
    [(TWICE_ENERGY, "proved"), (MOMENTUM, "proved"), (r"\omega_1^2+\omega_2^2", "proved"),
     (r"\omega_1^2-\omega_2^2", "refuted"), (r"\omega_3", "refuted")],
)  # fmt: skip
def test_first_integral(top, name, tex, verdict):
    claim = FirstIntegral("t", top.scene, "", printed=top(tex))
    assert verdicts(top.section, claim, arithmetics=(name,)) == [verdict]


def test_a_partial_integral_is_constant_on_its_invariant_set_and_not_off_it(top):
    axis = (top(r"\omega_1=0"), top(r"\omega_2=0"))
    third = FirstIntegral("3", top.scene, "", printed=top(r"\omega_3"), given=axis)
    energy = FirstIntegral("E", top.scene, "", printed=top(TWICE_ENERGY), given=axis)
    third, energy = decide(top.section, third, energy)
    assert third.verdict == "proved"
    assert energy.verdict == "refuted"
    assert energy.message == "what is said to fail somewhere holds everywhere"


def test_what_stands_still_where_motions_pass_through_is_no_partial_integral(top):
    claim = FirstIntegral("3", top.scene, "", printed=top(r"\omega_3"), given=(top(r"\omega_1=0"),))
    (outcome,) = decide(top.section, claim)
    assert outcome.verdict == "refuted"
    assert outcome.counterexample.point.values[Name(r"\omega_1")] == Number(0)


def test_invariant_relations(top):
    axis = InvariantRelations(
        "axis",
        top.scene,
        "",
        relations=(top(r"\omega_1=0"), top(r"\omega_2=0")),
    )
    plane = InvariantRelations(
        "plane",
        top.scene,
        "",
        relations=(top(r"\omega_1=0"),),
    )
    separatrix = InvariantRelations(
        "separatrix",
        top.scene,
        "",
        relations=(top(rf"{MOMENTUM}=2({TWICE_ENERGY})"),),
    )
    pencil = InvariantRelations(
        "pencil", top.scene, "",
        relations=(top(r"\frac{\omega_1^2+\omega_2^2}{\omega_3}=\omega_3"),),
    )  # fmt: skip
    found = decide(top.section, axis, plane, separatrix, pencil)
    assert [str(o.verdict) for o in found] == ["proved", "refuted", "proved", "refuted"]
    assert found[1].counterexample.point.values[Name(r"\omega_1")] == Number(0)


def test_a_point_at_which_no_combination_gives_the_derivatives_denies_invariance():
    section = Section("1", "Free fall")
    f = section.display("f", r"\dot x=v,\quad \dot v=g")
    scene = Scene("fall", variables=("x", "v"), constants=("g",), field=(f[1], f[2]))
    still = section.display("s", "x=0, v=0")
    claim = InvariantRelations(
        "t",
        scene,
        "",
        relations=(still[1], still[2]),
    )
    (outcome,) = decide(section, claim)
    assert outcome.verdict == "refuted"
    assert outcome.counterexample.words.endswith(", and every combination of the functions is $0$")


def test_dimension_and_independence(top):
    def dimension(n, *equations):
        places = tuple(map(top, equations))
        return Dimension(
            f"d{n}{len(places)}", top.scene, "", levels=(), equations=places, dimension=n
        )

    def independence(*functions):
        printed = tuple(top(f"{function}=1") for function in functions)
        return Independence(
            f"i{len(functions[-1])}",
            top.scene,
            "",
            levels=(),
            equations=(),
            functions=printed,
        )

    sphere = rf"{MOMENTUM}=1"
    assert verdicts(top.section, dimension(2, sphere), dimension(1, sphere)) == [
        "proved",
        "refuted",
    ]
    top = Top()
    assert verdicts(
        top.section, independence(TWICE_ENERGY, MOMENTUM), independence(TWICE_ENERGY, rf"({TWICE_ENERGY})^2")
    ) == ["proved", "refuted"]  # fmt: skip


def test_implication(oscillator):
    level = oscillator("x^2=1-v^2")
    claims = [
        Implication("a", oscillator.scene, "", printed=oscillator("2E=1"), given=(level,)),
        Implication("b", oscillator.scene, "", printed=oscillator("x=1"), given=(level,)),
        Implication(
            "c",
            oscillator.scene,
            "",
            printed=oscillator("v=0"),
            given=(oscillator("xv=0"),),
            main=(("v",),),
        ),
    ]
    found = decide(oscillator.section, *claims)
    assert [str(o.verdict) for o in found] == ["proved", "refuted", "conditional"]
    assert [c.expression for c in found[2].conditions] == [Name("x")]


def test_an_implication_for_one_of_two_roots(oscillator):
    root = r"\sqrt{x^2+v^2}"
    given = oscillator("v=0")
    one = Implication(
        "1", oscillator.scene, "", printed=oscillator(f"x={root}"), given=(given,), root=root
    )
    none = Implication(
        "0", oscillator.scene, "", printed=oscillator(f"2x={root}"), given=(given,), root=root
    )
    assert verdicts(oscillator.section, one, none) == ["proved", "refuted"]


def test_equivalence(oscillator):
    to = oscillator("x=v")
    claims = [
        Equivalence("a", oscillator.scene, "", printed=oscillator("2v=2x"), to=to),
        Equivalence("b", oscillator.scene, "", printed=oscillator("x^2=xv"), to=to),
        Equivalence("c", oscillator.scene, "", printed=oscillator("x=-v"), to=to),
    ]
    found = decide(oscillator.section, *claims)
    assert [str(o.verdict) for o in found] == ["proved", "conditional", "refuted"]
    assert [c.expression for c in found[1].conditions] == [Name("x")]


def test_coefficient_and_degree(top):
    claims = [
        Coefficient(
            "a",
            top.scene,
            "",
            printed=top(r"\omega_1\omega_3+\omega_2=\omega_1\omega_3+\dots"),
            variable=r"\omega_3",
        ),
        Coefficient(
            "c",
            top.scene,
            "",
            printed=top(r"-\omega_2"),
            variable=r"\omega_3",
            derivative_of=top(r"\omega_1"),
        ),
        Degree("e", top.scene, "", variable=r"\omega_3", degree=1),
        Degree("f", top.scene, "", variable=r"\omega_3", degree=0),
    ]
    assert verdicts(top.section, *claims) == ["proved", "proved", "proved", "refuted"]


def test_reality(oscillator):
    def claim(id, real, imaginary):
        return Reality(id, oscillator.new, "", real=real, imaginary=imaginary)

    claims = [
        claim("a", ("z_1z_2", "z_1+z_2"), ("z_1-z_2",)),
        claim("b", ("z_1",), ()),
        claim("c", (), ("z_1z_2",)),
    ]
    assert verdicts(oscillator.section, *claims) == ["proved", "refuted", "refuted"]


def test_a_change_of_variables(oscillator):
    rows = oscillator.section.display("rows", r"z_1'=-z_1,\quad z_2'=z_2,\quad z_1'=z_1")
    claims = [
        Unit("unit", oscillator.old, "", printed=oscillator.unit[1], rows=(rows[1], rows[2])),
        InvertibleChange("change", oscillator.new, "", old=oscillator.old, pairs=(("z_1", "z_2"),)),
        *(
            ChangedEquation(f"row{k}", oscillator.new, "", printed=rows[k], old=oscillator.old)
            for k in (1, 2, 3)
        ),
    ]
    found = decide(oscillator.section, *claims)
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


def test_last_multiplier(top):
    axis = InvariantRelations(
        "axis",
        top.scene,
        "",
        relations=(top(r"\omega_1=0"), top(r"\omega_2=0")),
    )
    claims = [
        LastMultiplier("a", top.scene, "", relations=axis),
        LastMultiplier("b", top.scene, "", relations=axis, density=TWICE_ENERGY),
        LastMultiplier("c", top.scene, "", relations=axis, density=r"\omega_1"),
    ]
    found = decide(top.section, *claims)
    assert [str(o.verdict) for o in found] == ["proved", "refuted", "refuted"]
    # At rest the energy vanishes: it is no density there.
    assert found[1].message == "there is a real point where none is said to be"


def test_the_arithmetics_agree_on_every_kind(top):
    names = ("flint", "symengine", "sympy")
    claims = [
        FirstIntegral("E", top.scene, "", printed=top(TWICE_ENERGY)),
        FirstIntegral("F", top.scene, "", printed=top(r"\omega_1")),
        Degree("e", top.scene, "", variable=r"\omega_3", degree=1),
    ]
    for outcome in decide(top.section, *claims, arithmetics=names):
        assert set(outcome.verdicts) == set(names)
        assert set(outcome.verdicts.values()) == {outcome.verdict}


def test_a_condition_that_the_set_excludes_proves_nothing():
    section = Section("1", "A vacuous condition")
    f = section.display("f", r"\dot x=x,\quad \dot z=1")
    scene = Scene("s", variables=("x", "z"), field=(f[1], f[2]))
    g = section.display("g", "x=0, xz=0")
    t = section.display("t", r"z=0,\quad z^2")
    claims = [
        Implication("a", scene, "", printed=t[1], given=(g[1], g[2]), main=(("z",),)),
        FirstIntegral("b", scene, "", printed=t[2], given=(g[1], g[2]), main=(("z",),)),
    ]
    assert verdicts(section, *claims) == ["refuted", "refuted"]


def test_every_member_of_a_chain_is_constant(oscillator):
    claim = FirstIntegral(
        "t", oscillator.scene, "", printed=oscillator(r"E = \frac{1}{2}(x^2+v^2) \equiv x")
    )
    assert verdicts(oscillator.section, claim) == ["refuted"]


def test_a_first_integral_may_be_printed_as_a_name(oscillator):
    claim = FirstIntegral("t", oscillator.scene, "", printed=oscillator(r"E \equiv k"))
    assert verdicts(oscillator.section, claim) == ["proved"]


@pytest.mark.parametrize(
    ("chain", "verdict"),
    [
        ("E=1=2", "refuted"),
        ("E=2k=k", "refuted"),
        ("E=k=-k^2-1", "refuted"),
        ("E=k=1", "proved"),
        ("E=2=1+1", "proved"),
        (r"E=(k+1)^2-1=k^2+2k", "proved"),
    ],
)
def test_the_values_of_a_first_integral_are_equal(oscillator, chain, verdict):
    claim = FirstIntegral("t", oscillator.scene, "", printed=oscillator(chain))
    assert verdicts(oscillator.section, claim) == [verdict]


def test_not_equal_is_not_equal(oscillator):
    assert verdicts(
        oscillator.section, Identity("t", oscillator.scene, "", printed=oscillator(r"x \ne x"))
    ) != ["proved"]


def test_terms_that_are_not_printed_are_not_supposed(top):
    tex = top(r"\omega_1\omega_3+\omega_2=\omega_1\omega_3")
    assert verdicts(
        top.section, Coefficient("a", top.scene, "", printed=tex, variable=r"\omega_3")
    ) == ["refuted"]


def test_a_variable_without_an_equation_of_motion_is_an_error():
    section = Section("1", "Half an oscillator")
    f = section.display("f", r"\dot v = -x")
    scene = Scene("half", variables=("x", "v"), field=(f[1],))
    assert verdicts(
        section, FirstIntegral("t", scene, "", printed=section.display("t", "x^2")[1])
    ) == ["error"]


def test_functions_of_low_rank_at_a_few_points_may_be_independent():
    section = Section("1", "Two functions")
    f = section.display("f", r"\dot x=0,\quad \dot y=0")
    scene = Scene("plane", variables=("x", "y"), field=(f[1], f[2]))
    special = "".join(f"(y-{n})(y+{n})" for n in range(1, 7))
    g = section.display("g", rf"x=0,\quad [{special}]^2=0")
    claim = Independence("t", scene, "", levels=(), equations=(), functions=(g[1], g[2]))
    assert verdicts(section, claim) not in (["refuted"], ["error"])


def test_dependence_on_another_graph_than_the_set_refutes_nothing():
    """On the line y=1 the functions depend on each other; on the parabola they do not."""
    section = Section("1", "Two functions")
    f = section.display("f", r"\dot x=0,\quad \dot y=0,\quad \dot z=0")
    scene = Scene("space", variables=("x", "y", "z"), field=(*f,))
    parabola, line = section.display("set", "y=x^2"), section.display("graph", "y=1")
    functions = (*section.display("g", "y=0"), *section.display("h", "z=0"))
    claims = [
        Independence(
            id, scene, "",
            levels=(), equations=(*parabola,), functions=functions, graph=(*graph,),
        )
        for id, graph in (("parabola", parabola), ("line", line))
    ]  # fmt: skip
    assert verdicts(section, *claims) == ["proved", "undecided"]


def test_a_member_that_is_no_vector_where_one_is_expected_is_an_error():
    section = Section("1", "A vector")
    f = section.display("f", r"\dot{\bs\alpha}=a")
    scene = Scene(
        "s",
        vectors={r"\boldsymbol{\alpha}": ("a", "b", "c")},
        variables=("a", "b", "c"),
        field=(f[1],),
    )
    assert verdicts(
        section, FirstIntegral("t", scene, "", printed=section.display("t", "a")[1])
    ) == ["error"]


def test_a_relation_that_says_nothing_is_no_reason_to_stop(top):
    claim = InvariantRelations(
        "t",
        top.scene,
        "",
        relations=(top(r"\omega_1=\omega_1"), top(r"\omega_2=0")),
    )
    assert len(verdicts(top.section, claim)) == 1


def test_a_wrong_coefficient_is_refuted(top):
    claims = [
        Coefficient(
            "b",
            top.scene,
            "",
            printed=top(r"\omega_1\omega_3=2\omega_1\omega_3+\dots"),
            variable=r"\omega_3",
        ),
        Coefficient(
            "d",
            top.scene,
            "",
            printed=top(r"\omega_2"),
            variable=r"\omega_3",
            derivative_of=top(r"\omega_1"),
        ),
    ]
    assert verdicts(top.section, *claims) == ["refuted", "refuted"]


def test_a_derivative_by_real_time_is_conjugated_as_such():
    section = Section("1", "An oscillator in real time")
    f = section.display("f", r"\dot x = v,\quad \dot v = -x")
    unit, tau = section.inline("unit", "i^2=-1"), section.inline("tau", r"\tau=1t")
    e = section.display("e", r"z_1=x+iv,\quad z_2=x-iv")
    old = Scene("old", variables=("x", "v"), field=(f[1], f[2]), unit=unit[1], clock=tau[1])
    new = Scene(
        "new", variables=("z_1", "z_2"), field=Change(old, (e[1], e[2]), tau[1]), time=r"\tau",
        conjugates=(("z_1", "z_2"),), unit=unit[1],
    )  # fmt: skip
    t = section.display("t", r"\overline{z_1'}=z_2',\quad \overline{z_1'}=-z_2'")
    assert verdicts(
        section, Identity("a", new, "", printed=t[1]), Identity("b", new, "", printed=t[2])
    ) == [
        "proved",
        "refuted",
    ]


def test_a_root_of_a_complex_number_is_not_real():
    section = Section("1", "A root")
    f = section.display("f", r"\dot x_1=0,\quad \dot x_2=0,\quad u^2=x_1,\quad \overline{u}=u")
    scene = Scene(
        "s",
        variables=("x_1", "x_2"),
        conjugates=(("x_1", "x_2"),),
        field=(f[1], f[2]),
        roots={"u": f[3]},
    )
    assert verdicts(section, Identity("t", scene, "", printed=f[4])) != ["proved"]


@pytest.mark.parametrize(
    ("tex", "verdict"),
    [
        ("(x+v)^2 - kx^2v^2", "proved"),
        ("(x-v)^2 + x^2v^2 - x^3", "proved"),
        ("x^2", "proved"),
        ("x + v^2", "refuted"),
        ("xv + 1", "refuted"),
    ],
)
def test_double_zero(oscillator, name, tex, verdict):
    given = (oscillator("x = 0"), oscillator("v = 0"))
    claim = DoubleZero("t", oscillator.scene, "", printed=oscillator(tex), given=given)
    assert verdicts(oscillator.section, claim, arithmetics=(name,)) == [verdict]


@pytest.mark.parametrize(
    ("tex", "verdict"),
    [
        (r"f(s) = s^2 - 1", "proved"),
        (r"f(s) = s^2 + 1", "refuted"),
        (r"f(s) = f(s)", "error"),
    ],
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


def test_a_definition_defines_the_name_that_it_prints(oscillator):
    section = oscillator.section
    printed, equation = section.inline("D", "v = x^2"), section.inline("e", r"\dot D = 2xv")
    for tex, verdict in (("D = x^2", "proved"), ("D = x^3", "refuted"), ("v = x^2", "refuted")):
        section = Section("1", "")
        motion = section.display("motion", r"\dot x = v,\quad \dot v = -x")
        printed, equation = section.inline("D", tex), section.inline("e", r"\dot D = 2xv")
        scene = Scene(
            "D", variables=("x", "v"), field=(motion[1], motion[2]),
            definitions={"D": printed[1]},
        )  # fmt: skip
        claim = Definition("t", scene, "", printed=printed[1], equation=equation[1])
        assert verdicts(section, claim) == [verdict]


def test_a_root_with_a_printed_value_has_to_have_the_square():
    for tex, verdict in ((r"\sqrt{x^2} = -x", "proved"), (r"\sqrt{x^2} = 2x", "error")):
        section = Section("1", "")
        root, claim = section.inline("root", tex), section.inline("c", r"x\sqrt{x^2} = -x^2")
        scene = Scene("root", variables=("x",), roots={r"\sqrt{x^2}": root[1]})
        assert verdicts(section, Identity("t", scene, "", printed=claim[1])) == [verdict]


def test_a_root_that_moves_is_differentiated_without_a_division():
    section = Section("1", "")
    motion = section.display("motion", r"\dot s = nC, \quad C^2 = 1-s^2, \quad \dot C = -ns")
    scene = Scene(
        "circle", variables=("s",), constants=("n",), field=(motion[1],), roots={"C": motion[2]}
    )
    assert verdicts(section, Identity("t", scene, "", printed=motion[3])) == ["proved"]


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
    places = (*oscillator.section.display("set", tex),)
    claim = LocalDimension("t", oscillator.scene, "", equations=places, dimension=dimension)
    assert verdicts(oscillator.section, claim) == [verdict]
