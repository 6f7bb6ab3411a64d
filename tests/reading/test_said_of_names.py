"""Names of which the words before them, or behind, say that they are integrals."""

import pytest

from tests.reading.test_reading import verdicts

FREE = r"The equations of motion are \begin{equation}\label{f} \dot x=u,\quad \dot y=v,\quad \dot u=0,\quad \dot v=-y . \end{equation} "


@pytest.mark.parametrize(
    ("words", "name", "green"),
    [
        (
            r"The function $xv-yu$ is no matter, but $u^2$ is an integral, and so is the momentum $u$.",
            "u",
            True,
        ),
        (r"The function $u^2$ is an integral, and so is the momentum $v$.", "v", False),
        (r"Первым интегралом является импульс $u$.", "u", True),
        (r"Первым интегралом является импульс $v$.", "v", False),
        (r"Тогда $u$ есть интеграл уравнений \eqref{f}.", "u", True),
        (r"Тогда $v$ есть интеграл уравнений \eqref{f}.", "v", False),
        (r"The function $u^2$ is conserved. So is $u$.", "u", True),
        (r"The function $u^2$ is conserved. So is $v$.", "v", False),
    ],
)
def test_a_name_is_called_an_integral(words, name, green):
    assert verdicts(FREE + words)[name].green is green


@pytest.mark.parametrize(
    "words",
    [
        "The function $v^2$ is not conserved. So is $u$.",
        "No function of $v$ is an integral. So is $u$.",
        "The function $u^2$ is positive. So is $u$.",
        "On the line $y=0$ the function $u^2$ is conserved. So is $u$.",
        "If $y=0$ initially, the function $u^2$ is conserved. So is $u$.",
    ],
)
def test_what_was_said_of_nothing_is_not_said_again(words):
    assert "u" not in verdicts(FREE + words)


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"Hence we have the second constant \[K=v^2+y^2.\]", True),
        (r"Hence we have the second constant \[K=v^2-y^2.\]", False),
    ],
)
def test_a_further_constant_is_an_integral(words, green):
    assert (
        verdicts(FREE + words)[r"K=v^2\{}y^2".replace(r"\{}", "+" if green else "-")].green is green
    )


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"The momentum $M=xv-yu$ is not conserved, for by \eqref{f} \[\dot M=-xy.\]", True),
        (r"Put $M=xv-yu$, $N=yv$. Neither is conserved, since \[\dot N=v^2-y^2.\]", True),
        (r"Импульс $M=xv-yu$ не сохраняется, так как $$\dot M=-xy.$$", True),
        (r"The momentum $M=xv-yu$ is not conserved, for by \eqref{f} \[\dot M=xy.\]", False),
        (r"Импульс $M=xv-yu$ не сохраняется, поскольку $$\dot M=x.$$", False),
    ],
)
def test_a_rate_is_why_something_is_not_conserved(words, green):
    (found,) = (
        one for tex, one in verdicts(FREE + words).items() if "dot" in tex and "M=xv" not in tex
    )
    assert found.green is green


@pytest.mark.parametrize(
    "words",
    [
        r"The momentum $M=xv-yu$ is not conserved, since \[\dot M=-xy\] is impossible.",
        r"The momentum $M=xv-yu$ is not conserved, as it is not true that \[\dot M=-xy.\]",
        r"Импульс $M=xv-yu$ не сохраняется. Величина $xv-yu$ не постоянна.",
    ],
)
def test_a_rate_that_is_denied_itself_is_no_reason(words):
    assert not verdicts(FREE + words)


def test_the_value_of_an_invariant_is_no_invariant_set():
    text = r"""Consider the map \[x'=y,\qquad y'=-x.\] The function $I=x^2+y^2$ is an invariant of the map.
    The value of the invariant is \[I=c-1\] there."""
    assert not any(one.green for tex, one in verdicts(text).items() if tex == "I=c-1")


AREAS = r"""Let \[4\dot p=3qr,\ 4\dot q=-3pr-ac,\ \dot r=ab,\ \dot a_1=rb-qc,\ \dot b=pc-ra_1,\ \dot c=qa_1-pb .\]
The function \[ k=4pa_1+4qb+rc \] is a first integral. Let $G=r(p^2+q^2)+apc$. Then \[ \dot G=\frac a4kq .\] """


@pytest.mark.parametrize(
    ("words", "green"),
    [
        ("If $k=0$, the function $G=r(p^2+q^2)+apc$ is a first integral.", True),
        ("При $k=0$ функция $G=r(p^2+q^2)+apc$ является первым интегралом.", True),
        ("The function $G=r(p^2+q^2)+apc$ is a first integral.", False),
    ],
)
def test_a_function_that_is_printed_once_more_may_be_called_an_integral(words, green):
    *_, last = verdicts(AREAS + words).values()
    assert last.green is green


def test_a_function_that_is_printed_once_more_may_be_called_none():
    found = verdicts(AREAS + "The function $G=r(p^2+q^2)+apc$ is not a first integral.")
    assert r"G=r(p^2+q^2)+apc" not in found


DISKS = r"Two disks obey \[\dot x=-mx+zy,\quad \dot y=-my+(z-a)x,\quad \dot z=1-xy .\] "


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"If $a=0$, then $(x^2-y^2)e^{2mt}$ is an integral that depends on time.", True),
        (r"If $a=0$, then $(x^2-y^2)e^{mt}$ is an integral that depends on time.", False),
        (r"Then $(x^2-y^2)e^{2mt}$ is an integral that depends on time.", False),
    ],
)
def test_an_integral_may_depend_on_the_time_in_some_case(words, green):
    *_, last = verdicts(DISKS + words).values()
    assert last.green is green


FIELD = r"Consider \[ H=\frac12\left(p_x^2+p_y^2\right)-\frac m{\sqrt{x^2+y^2}}+fx .\] Let $L=xp_y-yp_x$. "


@pytest.mark.parametrize(("rate", "green"), [("fy", True), ("-fy", False)])
def test_only_of_a_later_clause_is_not_said_of_an_equation(rate, green):
    words = rf"We have \[ \dot L={rate} ,\] so the moment is preserved only when there is no field."
    found = verdicts(FIELD + words)
    assert found[rf"\dot L={rate}"].green is green


TRIAD = r"Let $\dot x=yz$, $\dot y=-xz$, $\dot z=-xy$. The function $x^2+y^2$ is an integral"


@pytest.mark.parametrize(
    ("words", "greens"),
    [
        (", as is $y^2-z^2$.", [True, True]),
        (", as is $y^2+z^2$.", [True, False]),
        ("; as is well known, $y^2+z^2$ is positive.", [True]),
    ],
)
def test_what_is_an_integral_as_another_function_is(words, greens):
    assert [one.green for one in verdicts(TRIAD + words).values()] == greens


@pytest.mark.parametrize("aside", ["", ", however,", ", of course,", ", therefore,"])
@pytest.mark.parametrize(("name", "green"), [("u", True), ("v", False)])
def test_words_between_commas_say_nothing(aside, name, green):
    assert [
        one.green
        for one in verdicts(FREE + f"The function ${name}$ is{aside} an integral.").values()
    ] == [green]


@pytest.mark.parametrize(("function", "green"), [("x^2+y^2", True), ("x^2-y^2", False)])
def test_a_function_that_is_invariant_under_a_map_is_named_there(function, green):
    text = rf"""Consider the map $\Phi$, \[ x'=y,\qquad y'=-x. \]
    The function \[ I={function} \] is invariant under $\Phi$."""
    assert verdicts(text)[f"I={function}"].green == green
