"""Rates of a related law in the same letters are not those of the printed one.

So is the comparison equation, the inverse flow, and what an interchange of letters gives. The law
that is printed is judged as before, and so is what is deduced from it.
"""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts
from tests.sample import sampled

PENDULUM = r"A pendulum obeys \[\ddot\theta=-\sin\theta.\] "
TURNING = r"We consider the equations \[\dot x=y,\qquad\dot y=-x.\] "
RELATED = (
    (PENDULUM, "The comparison equation is @.", r"\ddot\theta=-\theta"),
    (PENDULUM, "The corresponding linear equation reads @.", r"\ddot\theta=-\theta"),
    (PENDULUM, "The truncated equation of our pendulum is @.", r"\ddot\theta=-\theta+\frac16\theta^3"),
    (PENDULUM, "The free motion is @.", r"\ddot\theta=0"),
    (PENDULUM, "Its dual equation has the form @.", r"\ddot\theta=\sin\theta"),
    (PENDULUM, "Линейное уравнение имеет вид @.", r"\ddot\theta=-\theta"),
    (PENDULUM, "In dimensional form we have @.", r"\ddot\theta=-2\sin\theta"),
    (r"The population obeys \[\dot x=x-x^2.\] ", "The linear part of the equation is @.", r"\dot x=x"),
    (r"Let \[\dot x=y,\qquad\dot y=-x-y.\] ", "The adjoint equation is @.", r"\ddot x=-x+\dot x"),
    (TURNING, r"The inverse flow is @, $\dot y=x$.", r"\dot x=-y"),
    (TURNING, r"The reversed system reads @ and $\dot x=-y$.", r"\dot y=x"),
    (TURNING, r"Interchanging $x$ and $y$ we get @, $\dot x=-y$.", r"\dot y=x"),
    (TURNING, r"Reversing the time, we get $\dot x=-y$, @.", r"\dot y=x"),
    (TURNING, r"Обращая время, получим @, $\dot y=x$.", r"\dot x=-y"),
)  # fmt: skip
OF_THE_LAW = (
    (PENDULUM, "Hence @.", r"\ddot\theta=\sin\theta", r"\ddot\theta=-\sin\theta"),
    (PENDULUM, "Differentiating, we find @.", r"\dddot\theta=-\dot\theta\sin\theta", r"\dddot\theta=-\dot\theta\cos\theta"),
    (PENDULUM, "From the equation of motion we have @.", r"\ddot\theta=\sin\theta", r"\ddot\theta=-\sin\theta"),
    (TURNING, "Therefore @.", r"\ddot x=x", r"\ddot x=-x"),
    (r"The harmonic oscillator obeys \[\ddot x=-x.\] ", "Hence the harmonic oscillator has @.", r"\dddot x=\dot x", r"\dddot x=-\dot x"),
    (r"The linear system is \[\dot x=y,\qquad\dot y=-x.\] ", "Hence for the linear system @.", r"\ddot x=x", r"\ddot x=-x"),
)  # fmt: skip


@pytest.mark.parametrize(("law", "words", "rates"), sampled(RELATED, 8))
def test_rates_of_a_related_law_are_not_judged(law, words, rates):
    found = verdicts(law + words.replace("@", f"${rates}$")).get(rates)
    assert found is None or not (found.green or found is Verdict.REFUTED)


@pytest.mark.parametrize(("law", "words", "false", "true"), sampled(OF_THE_LAW, 3))
def test_what_is_deduced_from_the_law_is_judged(law, words, false, true):
    assert verdicts(law + words.replace("@", f"${true}$"))[true].green
    assert not verdicts(law + words.replace("@", f"${false}$"))[false].green


@pytest.mark.parametrize(
    "words",
    [
        "@. It has the integral $T$.", "@. Its energy $T$ is constant.", "@, with the integral $T$.",
        "@. For the comparison equation $T$ is constant.",
    ],
)  # fmt: skip
@pytest.mark.parametrize("function", [r"\dot\theta^2+\theta^2", r"\dot\theta^2-2\cos\theta"])
def test_what_is_said_of_it_is_not_judged_by_the_printed_law(words, function):
    said = words.replace("@", r"The comparison equation is $\ddot\theta=-\theta$")
    found = verdicts(PENDULUM + said.replace("$T$", f"${function}$")).get(function)
    assert found is None or not (found.green or found is Verdict.REFUTED)


def test_what_is_said_behind_it_of_the_pendulum_is_judged():
    said = (
        PENDULUM
        + r"The comparison equation is $\ddot\theta=-\theta$. The energy $T$ is an integral of the pendulum."
    )
    for function, green in ((r"\dot\theta^2-2\cos\theta", True), (r"\dot\theta^2+2\cos\theta", False)):  # fmt: skip
        assert verdicts(said.replace("$T$", f"${function}$"))[function].green == green


CANONICAL = r"Let $\{q,p\}=1$, $H=\frac12p^2+\frac14q^4$, so that \[\dot q=p,\qquad\dot p=-q^3.\] "


@pytest.mark.parametrize(
    ("words", "rates"),
    [
        (r"The Hamiltonian flow of $F=q^2$ is $\dot q=0$, @.", r"\dot p=-2q"),
        (r"The flow of $F=p$ is @, $\dot p=0$.", r"\dot q=1"),
        (r"Let $F=qp$. The flow of $F$ is @, $\dot p=-p$.", r"\dot q=q"),
        (r"The function $F=p^2$ generates the flow @, $\dot p=0$.", r"\dot q=2p"),
        (r"Поток функции $F=q$ есть $\dot q=0$, @.", r"\dot p=-1"),
    ],
)
def test_the_flow_of_another_function_is_not_that_of_the_energy(words, rates):
    found = verdicts(CANONICAL + words.replace("@", f"${rates}$")).get(rates)
    assert not (found and (found.green or found is Verdict.REFUTED))


@pytest.mark.parametrize(("rates", "green"), [(r"\dot p=-q^3", True), (r"\dot p=q^3", False)])
def test_the_flow_of_the_energy_is(rates, green):
    found = verdicts(CANONICAL + rf"The flow of $H$ is $\dot q=p$, ${rates}$.")
    assert found[rates].green == green


def test_what_comes_out_of_the_law_in_a_case_follows_from_it():
    text = r"""The motion is \[ \ddot x=-kx,\qquad\ddot y=-ly . \] When $k=l$, one has two harmonic oscillators
    \[ \ddot x=-kx,\qquad\ddot y=SIGNky . \]"""
    assert verdicts(text.replace("SIGN", "-"))[r"\ddot y=-ky"].green
    found = verdicts(text.replace("SIGN", ""))
    assert not found[r"\ddot y=ky"].green


ELLIPSE = r"""
\noindent\textbf{Problem 1.} A planet moves according to $\ddot{\mathbf r}=-\mu\mathbf r/r^3$.

\noindent\textbf{Problem 2.} We print the ellipse as $r=a(1-e\cos E)$. Find $\dot E$, and $\dot r$.

\noindent\textit{Solution.} Differentiating,
\[\dot E=\frac{n}{1-e\cos E},\qquad \dot r=\frac{nae\sin E}{1-e\cos E}.\]
"""


@pytest.mark.parametrize(("factor", "true"), [("", True), ("2", False)])
def test_what_a_formula_gives_before_equations_moves_by_it(factor, true):
    found = [*verdicts(rf"{ELLIPSE}It follows that $r\dot r={factor}na^2e\sin E$.").values()]
    assert [one.green for one in found] == [True, true]
