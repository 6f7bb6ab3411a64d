"""Inequalities, supposed and claimed: green only what is true up to the edges, red only what fails.

The truth is found without the program: on a line by the signs between all zeros and ends, and of
several constants at the points of a grid that has all edges.
"""

from fractions import Fraction
from itertools import chain, pairwise, product

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas import System
from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.notation import to_latex
from kowalevski_cas.reading import read
from kowalevski_cas.source.files import decode
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected", "here")

ENDS = st.integers(-2, 2)
SIGNS = {"<": lambda a, b: a < b, r"\le": lambda a, b: a <= b, ">": lambda a, b: a > b,
         r"\ge": lambda a, b: a >= b, r"\ne": lambda a, b: a != b}  # fmt: skip


def plane():
    system = System(r"\dot x=y,\quad \dot y=-ax+b-c")
    system.seconds = 20
    return system


@st.composite
def products(draw):
    """A product of linear factors, perhaps times what is positive, with its value and its zeros."""
    zeros = draw(st.lists(ENDS, max_size=3))
    factor = draw(st.sampled_from([1, -1, 2]))
    plus = draw(st.sampled_from([None, 1, 3]))
    tex = f"{factor}" + "".join(f"(a-({zero}))" for zero in zeros)
    tex += f"(a^2+{plus})" if plus else ""

    def value(a):
        result = Fraction(factor)
        for zero in zeros:
            result *= a - zero
        return result * (a**2 + plus) if plus else result

    return tex, value, zeros


def points(marks):
    """All marks, and a point between each two, and beyond the last ones."""
    marks = sorted({*map(Fraction, marks)})
    between = ((a + b) / 2 for a, b in pairwise(marks))
    return [marks[0] - 1, *chain(marks, between), marks[-1] + 1]


@pytest.mark.slow
@given(products(), ENDS, ENDS, *[st.sampled_from(["<", r"\le"])] * 2, st.sampled_from([*SIGNS]))
def test_on_an_interval_an_inequality_is_decided_by_the_signs_between_its_zeros(
    made, low, high, left, right, sign
):
    tex, value, zeros = made
    interval = plane().where(f"{low}{left} a{right} {high}") if low != high else None
    if interval is None:
        return
    inside = [
        a for a in points([low, high, *zeros]) if SIGNS[left](low, a) and SIGNS[right](a, high)
    ]
    claim = interval.inequality(f"{tex}{sign} 0")
    if not inside:
        assert claim.verdict in ("undecided", "error"), claim
        return
    true = all(SIGNS[sign](value(a), 0) for a in inside)
    assert claim.verdict in (
        ("proved", "conditional", "undecided") if true else ("refuted", "undecided")
    )


ORDERS = ["a<b", r"a\le b", "0<a", r"0\le a", r"a\le b\le c", "0<a<b<c", r"0\le a\le b, b\ne c"]
CLAIMS = [r"a\le c", "a<c", "a^2<b^2", r"a^2\le b^2", r"ab\ge a^2", "a+b>0", r"(a-b)(b-c)\ge0",
          r"|a|=a", r"\sqrt{a^2}=-a", r"|a|\le|b|", "b>0", r"b\ge0", r"a+b\ge c", r"\frac1a>\frac1b"]  # fmt: skip
GRID = [*map(Fraction, (-2, -1, 0, 1, 2)), Fraction(1, 2)]


def holds(tex, a, b, c):
    """Whether a chain of Python's is true; ``None`` where it is not defined."""
    for old, new in ((r"\le", "<="), (r"\ge", ">="), (r"\ne", "!="), ("^2", "**2"), ("ab", "a*b"),
                     (")(", ")*("), (r"|a|", "abs(a)"), ("|b|", "abs(b)"), (r"\sqrt{a**2}", "abs(a)"),
                     (r"\frac1a", "1/a"), (r"\frac1b", "1/b")):  # fmt: skip
        tex = tex.replace(old, new)
    tex = tex.replace("=-a", "==-a").replace("=a", "==a") if "abs(a)=" in tex else tex
    try:
        return all(eval(part, {"a": a, "b": b, "c": c}) for part in tex.split(","))
    except ZeroDivisionError:
        return None


@pytest.mark.slow
@given(st.sampled_from(ORDERS), st.sampled_from(CLAIMS))
def test_what_is_green_is_true_on_a_grid_with_all_edges_and_what_is_red_fails(order, tex):
    system = plane().where(order)
    equation = "=" in tex.replace(r"\le", "").replace(r"\ge", "")
    claim = system.identity(tex) if equation else system.inequality(tex)
    there = [p for p in product(GRID, repeat=3) if holds(order, *p)]
    fails = [p for p in there if holds(tex, *p) is False]
    verdict = claim.verdict
    assert not (verdict.green and fails), (claim, fails[0])
    if verdict == "refuted":
        at = {repr(name): value for name, value in claim.counterexample.point.values.items()}
        assert fails or at, claim


@pytest.mark.parametrize(
    ("order", "true", "false"),
    sampled(
        [
            ("0<k<1", "k^2<1", r"k\ge\frac12"),
            (r"0\le k\le1", r"k^2\le1", "k^2<1"),
            (r"I_1\le I_2\le I_3", r"I_1\le I_3", "I_1<I_3"),
            (r"I_1<I_2\le I_3", "I_1<I_3", "I_2<I_3"),
            ("0<A<B", r"\frac1A>\frac1B", "A^2>B"),
            ("|a|<1", "2a<3", "a^2>b^2"),
            (r"|a|\le b", r"a^2\le b^2", "|a|<b"),
            (r"|a-\sqrt{b^2+1}|<2", r"a-3<\sqrt{b^2+1}", "a>1"),
            ("", r"a^2+x^2\ge2ax", "a^2+x^2>2ax"),
            ("", r"|x|\ge x", "|x|>x"),
            ("", r"\sqrt{x^2+1}>|x|", r"\sqrt{x^2+1}>1"),
            ("a<0", "|a|>0", "|a|>1"),
            ("a>0", r"\sqrt a>0", r"\sqrt a>1"),
            ("a>0", r"\frac1{\sqrt a}>0", r"\frac1{\sqrt a}>1"),
            ("0<a<1", r"\sqrt{1-a^2}>0", r"\sqrt{1-a^2}>\frac12"),
            ("a,b>0", r"\frac{a+b}2\ge\sqrt{ab}", r"\frac{a+b}2>\sqrt{ab}"),
            ("a,b<0", r"a+b\le-2\sqrt{ab}", r"a+b<-2\sqrt{ab}"),
            ("0<a<b", r"a<\sqrt{ab}<b", r"\sqrt{ab}<a"),
            (r"0<a\le b", r"\sqrt{ab}\le b", r"\sqrt{ab}<b"),
            ("0<a<b", r"\sqrt{ab}<\frac{a+b}2", r"\frac{2ab}{a+b}>\sqrt{ab}"),
        ],
        1,
    ),
)
def test_an_edge_tells_a_weak_inequality_from_a_strict_one(order, true, false):
    system = plane().where(order) if order else plane()
    assert system.inequality(true).verdict.green
    assert system.inequality(false).verdict == "refuted"


@pytest.mark.slow
def test_the_polynomial_of_motzkin_is_a_sum_of_squares_times_a_positive_one():
    motzkin = "x^4y^2+x^2y^4+1-3x^2y^2"
    assert plane().inequality(rf"{motzkin}\ge0").verdict == "proved"


@pytest.mark.slow
def test_which_has_zeros():
    assert plane().inequality("x^4y^2+x^2y^4+1-3x^2y^2>0").verdict == "refuted"


@pytest.mark.parametrize(
    "order", sampled(["b<0, b>0", r"a<b, b<c, c\le a", r"a^2\le-1", "a>1, a^2<1"], 1)
)
def test_contradictory_hypotheses_prove_nothing(order):
    for tex in (r"b\ge0", "b<0", "a>2"):
        try:
            verdict = plane().where(order).inequality(f"{tex}+c-c+a-a+b-b").verdict
        except ValueError:
            continue
        assert not verdict.green
    with pytest.raises(ValueError, match="no inequality that can be supposed"):
        _ = plane().where("2<1").inequality("a>0").verdict


@pytest.mark.parametrize(
    ("given_", "tex", "verdict"),
    sampled(
        [
            ("x^2+y^2=1", r"x\le1", "proved"),
            ("x^2+y^2=1", "x<1", "refuted"),
            ("x^2+y^2=-1", "x>0", "undecided"),
            ("x^2+y^2=-1", r"x\ne0", "undecided"),
            ("xy=1", r"x\ne0", "proved"),
        ],
        1,
    ),
)
def test_on_a_set_an_inequality_speaks_of_its_real_points(given_, tex, verdict):
    assert plane().inequality(tex, given=given_).verdict == verdict


def test_the_sign_of_a_root_follows_from_what_is_supposed():
    assert plane().identity(r"\sqrt{a^2}=a").verdict == "refuted"
    assert plane().where(r"a\ge0").identity(r"\sqrt{a^2}=a").verdict == "proved"
    assert plane().where("a<0").identity(r"\sqrt{a^2}=-a").verdict == "proved"
    assert plane().where("a<0").identity(r"\sqrt{a^2}=a").verdict == "refuted"
    assert plane().where("0<a<b").identity(r"|a-b|=b-a").verdict == "proved"


@pytest.mark.parametrize("relation", ["a=d^2", "d^2=a"])
def test_a_constant_that_is_a_square_is_not_negative(relation):
    assert plane().where(relation).identity("|a|=a").verdict == "proved"
    assert plane().where(relation).identity("|a|=-a").verdict == "refuted"
    assert plane().where(relation).inequality(r"a\ge0").verdict == "proved"
    assert plane().where(relation).inequality("a>0").verdict == "refuted"


@pytest.mark.parametrize(
    ("order", "left"),
    sampled(
        [
            ([r"0\le a\le0"], "a=0"),
            ([r"a\ge0", r"a\le0"], "a=0"),
            ([r"a\ge b", r"b\ge c", r"c\ge a"], "a=c"),
            ([r"a^2\le1", r"b^2\le1", "a+b=2"], "a=b"),
        ],
        1,
    ),
)
def test_weak_inequalities_may_leave_an_edge(order, left):
    system = plane()
    for one in order:
        system = system.where(one)
    assert system.identity(left).verdict == "proved"
    assert system.identity(f"{left}+1").verdict == "refuted"
    name = left.partition("=")[0]
    assert system.inequality(left.replace("=", r"\le ")).verdict == "proved"
    assert system.inequality(left.replace("=", "<")).verdict == "refuted"
    beyond = system.where(left.replace("=", ">")).identity(f"{name}=7").verdict
    assert beyond in ("undecided", "error")  # of nothing nothing is said


def test_an_inequality_is_never_taken_for_an_equality():
    assert plane().identity(r"a\le a").verdict == "error"
    assert plane().where(r"a\ge0").integral(r"y^2+ax^2").verdict == "refuted"
    oscillator = System(r"\dot x=y,\quad \dot y=-ax").where("a>0")
    assert oscillator.integral("y^2+ax^2").verdict == "proved"


BODY = r"""\documentclass{article}\begin{document}
Let the moments of inertia obey $ORDER$. The equations of motion are
$$A\dot p=(B-C)qr,\quad B\dot q=(C-A)rp,\quad C\dot r=(A-B)pq.$$
It is easy to see that
$$CLAIM.$$
\end{document}
"""


@pytest.mark.parametrize(
    ("order", "tex", "verdict"),
    sampled(
        [
            ("0<A<B<C", r"A^2p^2+B^2q^2+C^2r^2\ge A(Ap^2+Bq^2+Cr^2)", "proved"),
            ("0<A<B<C", r"A^2p^2+B^2q^2+C^2r^2\le B(Ap^2+Bq^2+Cr^2)", "red"),
            ("0<A<B<C", r"\sqrt{(A-B)^2}=B-A", "proved"),
            ("0<A<B<C", r"\sqrt{(A-B)^2}=A-B", "red"),
            (r"A\le B\le C", "A<C", "red"),
            (r"A\le B<C", "A<C", "proved"),
        ],
        1,
    ),
)
def test_a_paper_supposes_and_claims_them(order, tex, verdict):
    paper = decode("body.tex", BODY.replace("ORDER", order).replace("CLAIM", tex).encode())
    (outcome,) = ReadingSession(read(paper), timeout=20).outcomes.values()
    assert outcome.verdict.green == (verdict == "proved"), outcome


@pytest.mark.slow
def test_a_multiple_of_a_name_defines_it():
    body = System(r"A\dot p=(B-C)qr,\ B\dot q=(C-A)rp,\ C\dot r=(A-B)pq").where("A>0, B>0, C>0")
    T = body.define(r"2T=Ap^2+Bq^2+Cr^2")
    assert body.integral(T).verdict == "proved"
    assert body.identity(r"T=\frac12(Ap^2+Bq^2+Cr^2)").verdict == "proved"
    assert body.identity(r"T=Ap^2+Bq^2+Cr^2").verdict == "refuted"
    assert body.inequality(r"T\ge0").verdict == "proved"
    assert body.inequality(r"T>0").verdict == "refuted"


def test_what_is_defined_may_be_said_to_be_constant():
    oscillator = System(r"\dot x=y,\quad \dot y=-x")
    assert oscillator.integral(oscillator.define(r"H=x^2+y^2=\mathrm{const}")).verdict == "proved"
    assert oscillator.integral(oscillator.define(r"F=x^2-y^2=\mathrm{const}")).verdict == "refuted"


@pytest.mark.parametrize(
    ("hypothesis", "claim", "verdict"),
    sampled(
        [
            (r"\frac4a>b", "b<5", "refuted"),
            (r"\frac4a>b", r"\frac4a\ge b", "conditional"),
            (r"\frac4a>b", r"\frac{x^2}{a^2}\ge0", "conditional"),
        ],
        1,
    ),
)
def test_what_a_hypothesis_is_divided_by_does_not_vanish(hypothesis, claim, verdict):
    system = System(r"\dot x=ax+b").where(hypothesis)
    outcome = system.inequality(claim).outcome
    assert outcome.verdict == verdict, outcome.message
    assert [to_latex(c.expression) for c in outcome.conditions] == ["a"] * (
        verdict == "conditional"
    )


@given(st.sampled_from(["a", "a-1", "a+x", "a^2+1"]), st.sampled_from(["<", r"\le", r"\ne"]))
def test_an_identity_has_the_conditions_of_its_hypotheses(below, sign):
    r"""Judge and checker have the same, also where nothing else is divided by it.

    That something is not zero is left aside where nothing needs it.
    """
    system = System(r"\dot x=ax+b").where(rf"b{sign}\frac4{{{below}}}")
    outcome = system.identity(r"x=\frac{xa}a").outcome
    conditions = {to_latex(c.expression) for c in outcome.conditions}
    assert outcome.verdict == "conditional", outcome.message
    left_aside = sign == r"\ne" or below in ("a", "a^2+1")
    assert "a" in conditions and len(conditions) == (1 if left_aside else 2)


@pytest.mark.parametrize(
    ("supposed", "is_empty"),
    [
        (["0<b<-1"], True),
        (["b>1", r"2b\le2"], True),
        ([r"b\ge1", r"2b\le2"], False),
        (["b<c", "c<b"], True),
        (["a^2+b<1", "a^2>1-b"], True),
        (["b<c", "c<d", "d<b"], True),
        (["b<c", "2c<d+b", r"d\le b-1"], True),
        ([r"b\le c", r"c\le d", r"d\le b"], False),
        (["|b|<1", "|b|>1"], True),
        (["0<b<1", r"\frac12<b"], False),
        ([r"b\ne0", r"b\le0"], False),
    ],
)
def test_what_contradicts_itself_is_an_error_whatever_is_claimed(supposed, is_empty):
    system = System(r"\dot x=ax+b")
    for one in supposed:
        system = system.where(one)
    claim = system.inequality(r"x^2\ge0")
    assert claim.verdict == ("error" if is_empty else "proved")
    assert not is_empty or "contradicts itself" in claim.outcome.message


@pytest.mark.slow
def test_what_is_supposed_of_other_letters_is_no_hypothesis():
    """A claim that does not speak of b stands by itself, even where there is no such b."""
    system = System(r"\dot x=ax+b").where("b^2<c").where("c<-1")
    assert system.inequality(r"x^2\ge0").verdict == "proved"
    assert system.inequality(r"x^4\ge x").verdict == "refuted"
    for claim in (r"(x+b)^2\ge0", r"x^4\ge x+b"):  # of nothing nothing is said
        assert system.inequality(claim).verdict == "undecided"


@given(st.sampled_from(["b^2=-ac", "b^2+ac=0", r"\frac ab+\frac bc=0"]))
def test_what_is_a_square_is_not_negative_where_its_root_is_not_spoken_of(relation):
    system = plane().where(relation)
    assert system.inequality(r"ac\le0").verdict.green
    assert system.inequality(r"ac<0").verdict == "refuted"
    assert system.inequality(r"ac\ge0").verdict == "refuted"


@pytest.mark.parametrize("square", ["x^2", "b^2", "(x-a)^2"])
@pytest.mark.parametrize("below", ["a", "a^2", "a-1", "a+x"])
def test_what_is_added_to_a_positive_fraction_may_be_a_square(below, square):
    system = System(r"\dot x=ax+b").where(rf"\frac4{{{below}}}>b")
    outcome = system.inequality(rf"\frac4{{{below}}}-b+{square}>0").outcome
    assert outcome.verdict == "conditional", outcome.message


@pytest.mark.slow
def test_and_none_is_taken_away():
    system = System(r"\dot x=ax+b").where(r"\frac4a>b")
    assert system.inequality(r"\frac4a-b-b^2>0").verdict == "refuted"


@pytest.mark.parametrize("supposed", [[r"\frac4a>b", "a>0"], ["a>0", r"\frac4a>b"]])
def test_a_fraction_is_cleared_by_the_sign_of_its_denominator(supposed):
    system = System(r"\dot x=ax+b")
    for relation in supposed:
        system = system.where(relation)
    assert system.inequality("ab<4").verdict == "proved"
    assert system.inequality("ab<3").verdict == "refuted"


def test_and_turned_round_where_that_is_negative():
    system = System(r"\dot x=ax+b").where(r"\frac4a>b").where("a<0")
    assert system.inequality("ab>4").verdict == "proved"
    assert system.inequality("ab<4").verdict == "refuted"


def test_products_of_inequalities_bound_what_is_in_two_of_them():
    system = System(r"\dot x=ax+b").where("b>1").where("a>0").where(r"\frac1a>b")
    assert system.inequality("a<1").verdict == "proved"


@given(
    st.lists(
        st.tuples(ENDS, ENDS, ENDS, st.sampled_from(["<", r"\le", ">", r"\ge"])),
        min_size=1, max_size=4,
    )
)  # fmt: skip
def test_what_has_a_point_is_not_said_to_contradict_itself(supposed):
    """And half-planes of which each point of a large grid is outside of one are empty, or edges."""
    rows = [(f"{a}a+({b})b{sign}{c}", a, b, c, SIGNS[sign]) for a, b, c, sign in supposed if a or b]
    quarters = [Fraction(k, 4) for k in range(-24, 25)]
    inside = any(
        all(holds(a * x + b * y, c) for _, a, b, c, holds in rows)
        for x, y in product(quarters, quarters)
    )
    system = plane()
    try:
        for tex, *_ in rows:
            system = system.where(tex)
        outcome = system.inequality(r"x^2\ge0").outcome
    except ValueError as error:
        assert not inside, error
    else:
        assert not inside or outcome.verdict == "proved", outcome.message
