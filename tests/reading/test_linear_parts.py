"""Eigenvalues of linear parts, at points of which words speak."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.reading import CLAIM
from tests.audit.test_doubted import audited
from tests.reading.test_reading import reading, verdicts

CONVECTION = r"""The equations of motion are \begin{equation}\label{a}
\dot u=s(v-u),\qquad \dot v=ru-v-uw,\qquad \dot w=uv-bw \end{equation} with constants $s$, $r$, $b$. """
PREY = r"""The equations of motion are \[ \dot a=a(1-a-kb),\qquad \dot b=b(1-b-ka) . \]
Let $e=(1,0)$ and $c=\frac1{1+k}(1,1)$. """


@pytest.mark.parametrize(
    ("words", "verdict"),
    [
        (r"The eigenvalues of the linear part at the origin are $-b$.", "proved"),
        (r"The eigenvalues at the origin are $b$.", "refuted"),
        (
            r"The eigenvalues at the origin are \[\mu=\tfrac12\left(-s-1+\sqrt{(s-1)^2+4rs}\right) .\]",
            "proved",
        ),
        (
            r"The eigenvalues at the origin are \[\mu=\tfrac12\left(-s-1+\sqrt{(s+1)^2+4rs}\right) .\]",
            "refuted",
        ),
        (r"Собственные значения линейной части в начале координат суть $-b$.", "proved"),
    ],
)
def test_at_the_origin(words, verdict):
    assert [one.value for one in verdicts(CONVECTION + words).values()] == [verdict]


@pytest.mark.parametrize(
    ("words", "greens"),
    [
        (r"The eigenvalues at $e$ are $-1$ and $1-k$.", [True, True]),
        (r"The eigenvalues at $e$ are $-1$ and $1+k$.", [True, False]),
        (
            r"The eigenvalues at $e$ are $-1$ and $1-k$, and those at $c$ are \[-1,\qquad \frac{k-1}{k+1} .\]",
            [True, True, True],
        ),
        (
            r"The eigenvalues at $e$ are $-1$ and $1-k$, and those at $c$ are \[-1,\qquad \frac{1-k}{k+1} .\]",
            [True, True, False],
        ),
        (r"The eigenvalues at $a=1$, $b=0$ are $-1$.", [True]),
        (r"The eigenvalues at $a=1$, $b=0$ are $-2$.", [False]),
        (r"The eigenvalues at $a=1$ are $-1$.", []),
        (r"Linearization at $e$ gives the exponents $-1$ and $1-k$.", [True, True]),
        (r"Linearization at $e$ gives the exponents $-1$ and $1+k$.", [True, False]),
        (r"At $e$ we have the eigenvalues \[\mu=-1,\quad\mu=k-1.\]", [True, False]),
    ],
)
def test_at_points_with_names(words, greens):
    found = [one.green for one in verdicts(PREY + words).values()]  # one for each that is printed
    assert sorted(found) == sorted(greens)


@pytest.mark.parametrize(
    "words",
    [
        r"The eigenvalues of $L$ are $b$.",
        r"The eigenvalues of the moments at the origin are $b$.",
        r"The eigenvalues at the origin are \[ -b\ \text{ in the direction of }w .\]",
        r"Are the eigenvalues at the origin $-b$?",
        r"The eigenvalues at the saddle are $-b$.",
    ],
)
def test_what_is_said_of_something_else_is_no_such_claim(words):
    found = reading(CONVECTION + words).formulas
    assert not any(one.role.kind == "eigenvalue" and one.role.name == CLAIM for one in found)


def test_where_nothing_rests_there_is_no_linear_part():
    text = r"The equations of motion are \[\dot u=1+v,\qquad \dot v=-u .\] The eigenvalues at the origin are $0$."
    assert not any(one.green for one in verdicts(text).values())


CUBIC = r"The system is \[ \dot u=v,\qquad\dot v=u-u^3-kv .\] "
NUMBERS = [
    (r"The Jacobian at $(1,0)$ has trace $NUMBER$ and determinant $2$.", "-k", "k"),
    (r"At $(1,0)$ the trace of the Jacobian is $-k$, and its determinant is $NUMBER$.", "2", "-1"),
    (r"The trace of the linearization at the origin equals $NUMBER$.", "-k", "-2k"),
    (r"The determinant of the Jacobian matrix at the origin is $NUMBER$.", "-1", "1"),
    (r"The origin is a saddle with the eigenvalues $NUMBER$.", r"\frac{-k\pm\sqrt{k^2+4}}2",
     r"\frac{-k\pm\sqrt{k^2+2}}2"),
    (r"The point $(0,0)$ is a saddle with eigenvalues $NUMBER$.", r"\frac{-k\pm\sqrt{k^2+4}}2",
     r"\frac{k\pm\sqrt{k^2+4}}2"),
    (r"The origin is an equilibrium. Its eigenvalues are $NUMBER$.", r"\frac{-k\pm\sqrt{k^2+4}}2",
     r"\frac{-k\pm\sqrt{k^2-4}}2"),
    (r"A stationary point is $u=1$, $v=0$, and the Jacobian there is \[ NUMBER .\]",
     r"\begin{pmatrix}0&1\\-2&-k\end{pmatrix}", r"\begin{pmatrix}0&1\\1&-k\end{pmatrix}"),
]  # fmt: skip


@pytest.mark.parametrize("words, true, false", NUMBERS)
def test_numbers_of_the_linear_part(words, true, false):
    printed, wrong = (verdicts(CUBIC + words.replace("NUMBER", one))[one] for one in (true, false))
    assert printed.green and not wrong.green


@pytest.mark.parametrize(
    "words",
    [
        r"At $(1,0)$ the trace of the Jacobian of the reversed flow is $k$.",
        r"The trace of the Jacobian is $-k$ at the origin, and its determinant is $2$ at $(1,0)$.",
        r"At $(1,0)$ the trace of the inertia matrix is $-k$; the Jacobian is known.",
        r"The trace of the Jacobian at $(1,0)$ is not $-k$.",
        r"The origin is studied. The matrix at $(1,0)$ is known. Its eigenvalues are $-k$, $0$.",
    ],
)
def test_numbers_of_other_matrices_are_not_judged(words):
    assert not any(verdict for tex, verdict in verdicts(CUBIC + words).items() if "k" in tex)


@pytest.mark.parametrize(
    ("words", "green"),
    [
        (r"At $(0,0)$ the trace of the Jacobian is $3$.", True),
        (r"At the points $(0,0)$ and $(1,1)$ the Jacobian has the trace $3$.", False),
        (r"At the points $(0,0)$, $(1,0)$ the Jacobian has the trace $3$.", False),
    ],
)
def test_what_is_said_of_several_points_is_not_judged_at_the_first(words, green):
    law = r"The system is $$\dot x=x(1-x),\qquad\dot y=2y(1-y).$$ "
    assert any(one.green for one in verdicts(law + words).values()) is green


@pytest.mark.parametrize(
    ("text", "greens"),
    [
        (r"The system $\dot x=y$, $\dot y=-k^2x$ has the eigenvalues $\mu=\pm ik$.", [True, True]),
        (r"The system $\dot x=y$, $\dot y=-k^2x$ has the eigenvalues $\mu=\pm k$.", [False, False]),
        (r"Let $\ddot x+2b\dot x+k^2x=0$. The roots of the characteristic equation are "
         r"$\mu_1=-b+\sqrt{b^2-k^2}$.", [True]),
        (r"Let $\ddot x+2b\dot x+k^2x=0$. The characteristic roots are $\mu_1=b+\sqrt{b^2-k^2}$.", [False]),
        (r"Let $\dot x=-x$, $\dot y=-2y$. The eigenvalues are $-1$ and $-2$.", [True, True]),
        (r"Let $\dot x=-x$, $\dot y=-2y$. The eigenvalues are $-1$ and $2$.", [True, False]),
        (r"Let $\dot x=x-xy$, $\dot y=xy-y$. The eigenvalues are $\pm1$.", []),  # at which point?
    ],
)  # fmt: skip
def test_a_linear_system_has_eigenvalues_without_a_place(text, greens):
    found = reading(text)
    outcomes = ReadingSession(found, timeout=20).outcomes
    assert [outcomes[f.claim.id].verdict.green for f in found.formulas if f.claim] == greens


@pytest.mark.parametrize(("value", "green"), [(r"\pm i\sqrt{ac}", True), (r"\pm\sqrt{ac}", False)])
def test_at_a_point_of_marked_letters(value, green):
    text = r"""Let $\dot x=x(a-by)$, $\dot y=y(x-c)$. There are two points of rest, the origin and
    \[ (x_*,y_*)=\left(c,\frac ab\right). \] The Jacobian matrix at the point $(x_*,y_*)$ has the
    eigenvalues \[ \mu_{1,2}=VALUE. \]""".replace("VALUE", value)
    found = verdicts(text)
    assert [one.green for tex, one in found.items() if "mu" in tex] == [green]
    assert [one.green for tex, one in found.items() if "_*" in tex] == [True]


DAMPED = r"Let \[ \dot x=-ax,\qquad \dot y=-by+x^2 \] with positive constants $a$, $b$. "


@pytest.mark.parametrize(
    ("words", "greens"),
    [
        (r"The eigenvalues at the origin are $-a<0$ and $-b<0$.", [True, True]),
        (r"The eigenvalues at the origin are $-2a<0$ and $-b>0$.", [False, False]),
        (
            r"The eigenvalues at the origin are $\lambda=-a<0$ and $\mu=-2b<0$.",
            [True, True, False, False],
        ),
        (r"The trace of the linear part at the origin is $-a-b<0$.", [True]),
        (r"The trace of the linear part at the origin is $-a-2b<0$.", [False]),
        (r"The determinant of the linear part at the origin is $D=ab>0$.", [True, True]),
        (r"The determinant of the linear part at the origin is $D=a>0$.", [False, False]),
    ],
)
def test_what_has_a_sign_is_still_what_words_call_it(words, greens):
    assert [one.green for one in verdicts(DAMPED + words).values()] == greens


GAIN = r"We consider \[ \dot x=y,\qquad\dot y=xz,\qquad\dot z=-xy . \] "
AT_POINTS = [
    (GAIN + r"The equilibrium $(0,0,z_0)$ is unstable when $z_0>0$: its eigenvalues are "
     r"\[ 0,\quad VALUE,\quad-\sqrt{z_0} . \]", r"\sqrt{z_0}", r"2\sqrt{z_0}"),
    (GAIN + r"The eigenvalues at $(0,0,z_0)$ are $0$ and $\pm\sqrt{z_0}$. For the equilibrium $(x_0,0,0)$ "
     r"they are $0$ and $VALUE$.", r"\pm ix_0", r"\pm x_0"),
    (CUBIC + r"The point $(1,0)$ is stable if $k>0$. Its eigenvalues are $VALUE$.",
     r"\frac{-k\pm\sqrt{k^2-8}}2", r"\frac{-k\pm\sqrt{k^2+8}}2"),
    (CUBIC + r"The equilibrium $(1,0)$ has the eigenvalues $VALUE$.",
     r"\frac{-k\pm\sqrt{k^2-8}}2", r"\frac{k\pm\sqrt{k^2-8}}2"),
    (CUBIC + r"For $k=3$ the equilibrium $(1,0)$ is stable, since its eigenvalues are $-1$ and $VALUE$.",
     "-2", "2"),
    (CUBIC + r"There is an equilibrium at $(1,0)$. The linearization there has the eigenvalues "
     r"$VALUE$.", r"\frac{-k\pm\sqrt{k^2-8}}2", r"\frac{-k\pm\sqrt{k^2-4}}2"),
    (CUBIC + r"The origin is a saddle. The eigenvalues there are $VALUE$.",
     r"\frac{-k\pm\sqrt{k^2+4}}2", r"\frac{-k\pm\sqrt{k^2-4}}2"),
    (CUBIC + r"Точка $(1,0)$ устойчива, так как её собственные числа равны $VALUE$.",
     r"\frac{-k\pm\sqrt{k^2-8}}2", r"\frac{-k\pm\sqrt{k^2+8}}2"),
    (CUBIC + r"Положение равновесия есть $u=1$, $v=0$. Один корень характеристического уравнения "
     r"для этого равновесия равен $VALUE$.", r"\frac{-k+\sqrt{k^2-8}}2", r"\frac{k+\sqrt{k^2-8}}2"),
]  # fmt: skip


@pytest.mark.parametrize("text, true, false", AT_POINTS)
def test_eigenvalues_at_the_point_of_which_the_clause_before_speaks(text, true, false):
    printed, wrong = (verdicts(text.replace("VALUE", one))[one] for one in (true, false))
    assert printed.green and not wrong.green


@pytest.mark.parametrize(
    "words",
    [
        r"The sum of the eigenvalues at $(1,0)$ is $-k$.",
        r"The real parts of the eigenvalues at $(1,0)$ are $-k/2$.",
        r"The eigenvalues at $(1,0)$ are $\lambda_k$ and $\mu_k$.",
        r"For the reversed flow the equilibrium $(1,0)$ is unstable: its eigenvalues are $k$.",
        r"The equilibrium $(1,0)$ is stable. At $k=1$ they are $-k$.",
        r"Near the equilibrium $(1,0)$ the matrix $M$ is known, and its eigenvalues are $k$.",
    ],
)
def test_what_is_no_eigenvalue_at_that_point_is_not_judged(words):
    assert not any(one for tex, one in verdicts(CUBIC + words).items() if "k" in tex)


@pytest.mark.parametrize("wrong", [r"\pm\sqrt{ab}", r"\pm2i\sqrt{ab}"])
def test_two_eigenvalues_of_one_formula_do_not_make_the_law_suspect(wrong):
    text = rf"Let $\dot x=ay$, $\dot y=-bx$. The eigenvalues at the origin are ${wrong}$."
    assert {one.verdict for one in audited(text).formulas if one.role == "law"} == {"given"}
    assert not any(one.green for one in verdicts(text).values())


def test_what_is_so_at_one_of_two_points_is_not_green_at_both():
    law = r"Let \[\dot x=y,\qquad \dot y=x^2-1 .\] The points $(\pm1,0)$ are equilibria. "
    found = verdicts(law + r"The eigenvalues at $(\pm1,0)$ are $\pm\sqrt2$.")
    assert [one.green for tex, one in found.items() if "sqrt" in tex] in ([], [False])


WELL = r"Consider \[\dot x=y,\qquad\dot y=x-x^3.\] "


@pytest.mark.parametrize(
    ("place", "value", "true"),
    [
        ("$x=1$, $y=0$", r"\pm i\sqrt2", True),
        ("$x=1$, $y=0$", r"\pm2i", False),
        ("$x=0$ and $y=0$", r"\pm1", True),
        ("$x=0$ and $y=0$", r"\pm2", False),
    ],
)
def test_a_point_is_read_from_the_equations_of_its_coordinates(place, value, true):
    found = reading(rf"{WELL}At the equilibrium {place} the eigenvalues are ${value}$.")
    outcomes = ReadingSession(found, timeout=20).outcomes
    own = [f.claim for f in found.formulas if f.item.printed.tex.strip() == value]
    assert [outcomes[claim.id].verdict.green for claim in own] == [true] * 2


@pytest.mark.parametrize("value", [r"\pm1", r"\pm i\sqrt2"])
def test_where_a_coordinate_is_left_out_an_eigenvalue_has_no_verdict(value):
    found = reading(rf"{WELL}At $x=1$ the eigenvalues are ${value}$.")
    own = [f for f in found.formulas if f.item.printed.tex.strip() == value]
    assert own and all(f.role.name == CLAIM and f.claim is None and f.message for f in own)


PENDULUM_UP = (
    r"Consider the system $\dot x=y$, $\dot y=-\sin x-\mu y$. At the equilibrium $(\pi,0)$ "
)


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        (r"the eigenvalues are $\lambda=\frac12(-\mu\pm\sqrt{\mu^2+4})$.", ("+4", "-4")),
        (r"the characteristic equation is $\lambda^2+\mu\lambda-1=0$.", ("-1", "+1")),
        (
            r"the matrix of the linearized system is \[\begin{pmatrix}0&1\\1&-\mu\end{pmatrix} .\]",
            (r"\\1", r"\\-1"),
        ),
    ],
)
def test_a_linear_part_may_be_one_at_a_multiple_of_the_right_angle(right, wrong):
    assert all(one.green for one in verdicts(PENDULUM_UP + right).values())
    assert not all(one.green for one in verdicts(PENDULUM_UP + right.replace(*wrong)).values())
    quarter = PENDULUM_UP.replace(r"\sin x", r"\cos x").replace(r"\pi", r"\frac\pi2")
    assert all(one.green for one in verdicts(quarter + right).values())


def test_the_place_of_a_matrix_may_stand_before_it():
    text = r"Consider the system $\dot x=x(1-y)$, $\dot y=y(x-1)$. At the point $(1,1)$ the Jacobian matrix is "
    true, false = (
        r"\[\begin{pmatrix}0&-1\\1&0\end{pmatrix} .\]",
        r"\[\begin{pmatrix}0&1\\1&0\end{pmatrix} .\]",
    )
    assert [one.green for one in verdicts(text + true).values()] == [True]
    assert [one.green for one in verdicts(text + false).values()] == [False]


def test_the_place_of_a_deviation_may_be_spoken_of_in_its_sentence():
    text = r"""Consider $\ddot x+x-x^3=0$. Setting $x=1+\xi$ and keeping terms of first order in $\xi$, we obtain
    $\ddot\xi-2\xi=0$, so that $x=1$ is unstable."""
    assert verdicts(text)[r"\ddot\xi-2\xi=0"].green
    assert not verdicts(text.replace("2\\xi", "3\\xi"))[r"\ddot\xi-3\xi=0"].green
