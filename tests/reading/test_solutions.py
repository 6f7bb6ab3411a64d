"""Solutions by the time: what is missing is a rate, chains give several, others solve claims."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts
from tests.sample import sampled

PULSE = r"The equations are \[ \dot a=b,\qquad \dot b=ac,\qquad \dot c=-ab . \] A solution is "
CUBE = r"""The equations are \[ \dot x=yz-x(y+z),\quad \dot y=zx-y(z+x),\quad \dot z=xy-z(x+y) . \]
If two are equal, then """
PAIR = r"""The equations are \[ A\dot p=-(ap+bq)q,\qquad B\dot q=(ap+bq)p . \]
Put \[ u=ap+bq,\qquad v=Abp-Baq . \] Then \[ \dot u=\frac{uv}{AB},\qquad \dot v={SIGN}u^2 . \] """
BY_TIME = r"With $k=\sqrt{AB}$ we find "


def green(text):
    """Which of the solutions are green."""
    return [found.green for tex, found in verdicts(text).items() if "t" in tex.split("=")[-1]]


@pytest.mark.parametrize(
    ("a", "c", "true"),
    [
        (r"2\,\mathrm{sech}\,t", r"1-2\,\mathrm{sech}^2t", True),
        (r"3\,\mathrm{sech}\,t", r"1-2\,\mathrm{sech}^2t", False),
        (r"2\,\mathrm{sech}\,t", r"2-2\,\mathrm{sech}^2t", False),
        (r"2\,\mathrm{sech}\,t", r"1-2\,\mathrm{sech}^2(2t)", False),
    ],
)
def test_what_is_not_given_is_the_rate_of_what_is(a, c, true):
    """And all equations have to hold: one function is no solution beside a wrong one."""
    assert green(rf"{PULSE} \[ a={a},\qquad c={c} . \]") == [true, true]


def test_what_no_equation_gives_is_missing():
    assert green(rf"{PULSE} \[ c=1-2\,\mathrm{{sech}}^2t . \]") == []


TOP = r"The motion is \[ \dot x=yz,\qquad\dot y=-xz,\qquad\dot z={} . \] If $z=2$, then $x=\sin {}t$, $y=\cos {}t$."


@pytest.mark.parametrize(
    ("rate", "number", "true"), [("0", "2", True), ("0", "3", False), ("x", "2", False)]
)
def test_what_is_constant_need_not_be_given_by_the_time(rate, number, true):
    assert green(TOP.format(rate, number, number)) == [true, true]


@pytest.mark.parametrize(("power", "true"), [("^2", True), ("", False)])
def test_a_chain_gives_all_its_names(power, true):
    text = rf"{CUBE} \[ x=y=\frac1{{t-t_0}},\qquad z=\frac1{{t-t_0}}+\frac c{{(t-t_0){power}}} . \]"
    assert green(text) == [true, true]


@pytest.mark.parametrize(
    ("sign", "u", "v", "true"),
    [
        ("-", r"\frac c{\cosh\frac{ct}k}", r"-kc\tanh\frac{ct}k", True),
        ("-", r"\frac c{\cosh\frac{ct}k}", r"kc\tanh\frac{ct}k", False),
        ("-", r"\frac {2c}{\cosh\frac{ct}k}", r"-kc\tanh\frac{ct}k", False),
        # it solves the misprint, and not the law
        ("", r"\frac c{\cos\frac{ct}k}", r"kc\tan\frac{ct}k", False),
    ],
)
def test_functions_of_what_moves_solve_the_equations_that_are_claimed_of_them(sign, u, v, true):
    text = PAIR.replace("{SIGN}", sign) + rf"{BY_TIME} \[ u={u},\qquad v={v} . \]"
    assert green(text) == [true, true]


@pytest.mark.parametrize("words", ["The general solution", "Every solution", "Общее решение"])
@pytest.mark.parametrize(
    ("solution", "true"),
    [
        (r"A\cos2t+B\sin2t", [True]),
        (r"a\cos(2t+b)", [True]),
        (r"A\cos2t", []),
        (r"A\cos2t+A\sin2t", []),
        (r"A\cos3t+B\sin3t", [False]),
    ],
)
def test_the_general_solution_has_as_many_constants_as_the_order_of_its_equations(
    words, solution, true
):
    assert green(rf"{words} of \[\ddot x=-4x\] is \[x={solution}.\]") == true


@pytest.mark.parametrize(
    ("law", "solution", "greens"),
    [
        (r"\dot x=-x, \dot y=-2y", r"x=ae^{-t}, y=be^{-2t}", [True, True]),
        (r"\dot x=-x, \dot y=-2y", r"x=ae^{-t}, y=ae^{-2t}", []),
        (r"\ddot x=-x", r"x=a\cos t+b\sin t", [True]),
        (r"\ddot x=-x", r"x=a\cos t+b\cos t", []),
        (r"\ddot x=-x", r"x=ab\cos t", []),
        (r"\dot x=-y, \dot y=x, \dot z=z", r"x=a\cos t-b\sin t, y=a\sin t+b\cos t, z=ce^t", [True] * 3),
        (r"\dot x=-y, \dot y=x, \dot z=z", r"x=a\cos t-b\sin t, y=a\sin t+b\cos t, z=ae^t", []),
        (r"\ddot x=-n\dot y, \ddot y=n\dot x", r"x=x_0+a\cos(nt+b), y=y_0+a\sin(nt+b)", [True, True]),
        (r"\ddot x=-n\dot y, \ddot y=n\dot x", r"x=x_0+a\cos(nt+b), y=x_0+a\sin(nt+b)", []),
    ],
)  # fmt: skip
def test_the_constants_of_a_general_solution_are_independent(law, solution, greens):
    assert green(rf"Let \[ {law}. \] The general solution is \[ {solution}. \]") == greens


LEVELS = [
    (
        r"Consider $\dot x=y$, $\dot y=-x$. The energy $E=\frac12(x^2+y^2)$ is an integral.",
        [r"$x=\sqrt{2E}\cos t$, $y=-\sqrt{2E}\sin t$", r"$x=\sqrt{2E}\sin t$, $y=\sqrt{2E}\cos t$"],
        [r"$x=\sqrt{E}\cos t$, $y=-\sqrt{E}\sin t$", r"$x=\sqrt{2E}\cos t$, $y=\sqrt{2E}\sin t$"],
    ),
    (
        r"The motion is $\ddot x=-\omega^2x$, with the energy integral $\dot x^2+\omega^2x^2=2h$.",
        [r"$x=\frac{\sqrt{2h}}{\omega}\sin\omega t$", r"$x=\frac{\sqrt{2h}}{\omega}\cos\omega t$"],
        [r"$x=\frac{\sqrt{h}}{\omega}\sin\omega t$", r"$x=\sqrt{2h}\sin\omega t$"],
    ),
    (
        r"A body falls by $\ddot z=-g$. The function $c=\frac12\dot z^2+gz$ is constant.",
        [r"$z=\frac cg-\frac12gt^2$", r"$z=\frac{2c-g^2t^2}{2g}$"],
        [r"$z=\frac{2c}g-\frac12gt^2$", r"$z=c-\frac12gt^2$"],
    ),
]
BY_LEVELS = [
    (f"{law} A solution is {formula}.", green)
    for law, true, false in LEVELS
    for formulas, green in ((true, True), (false, False))
    for formula in formulas
]


@pytest.mark.parametrize(("text", "green"), sampled(BY_LEVELS, 6))
def test_a_solution_may_be_given_by_the_value_of_an_integral(text, green):
    """What names that value has to hold of the solution, too."""
    integral, *given = verdicts(text).values()
    assert integral.green
    assert {one.green for one in given} == {True} if green else not all(one.green for one in given)
    assert green is False or Verdict.REFUTED not in given


@pytest.mark.parametrize(("state", "green"), [("y=z=0", True), ("y=1, z=0", False)])
def test_a_motion_on_which_all_is_constant_is_a_solution(state, green):
    law = r"Let $\dot x=yz$, $\dot y=-xz$, $\dot z=xy$. "
    found = verdicts(law + rf"The state $x=A$, ${state}$ is a solution.")
    assert all(one.green for one in found.values()) is green


@pytest.mark.parametrize(("x", "green"), [(r"\frac k{t^2}", True), (r"\frac k{t^3}", False)])
@pytest.mark.parametrize("words", ["with the solution", "and its solutions are", "The solution is"])
def test_all_that_moves_may_be_given_with_a_new_constant(x, green, words):
    law = r"Let $\dot x=yz-x(y+z)$, $\dot y=zx-y(z+x)$, $\dot z=xy-z(x+y)$. On the invariant plane $y=z$ we have \[\dot y=-y^2\] "
    found = verdicts(
        law + rf"{words} \[y=z=\frac1t,\qquad x=\frac1t+{x},\] where $k$ is an arbitrary constant."
    )
    rate, *given = found.values()
    assert rate.green
    assert {one.green for one in given} == {green}


CONVECTION = r"Consider $\dot x=\sigma(y-x)$, $\dot y=\rho x-y-xz$, $\dot z=xy-bz$. "


@pytest.mark.parametrize(
    ("words", "true"),
    sampled(
        [
            (r"A particular solution is $x=0$, $y=0$, $z=e^{-bt}$.", True),
            (r"A particular solution is $x=0$, $y=0$, $z=e^{bt}$.", False),
            (r"A particular solution is $x=0$, $y=1$, $z=e^{-bt}$.", False),
            (r"The functions $x=0$, $y=0$, $z=2e^{-bt}$ are a solution.", True),
            (r"We have the solution $z=ce^{-bt}$, $x=0$, $y=0$.", True),
            (r"We have the solution $z=ce^{-bt}$, $x=0$, $y=1$.", False),
            (r"For $x=y=0$ we have $z=ce^{-bt}$.", True),
            (r"For $x=y=0$ we have $z=ce^{-2bt}$.", False),
        ],
        3,
    ),
)
def test_some_components_of_a_solution_are_constant(words, true):
    assert {one.green for one in verdicts(CONVECTION + words).values()} == {true}
