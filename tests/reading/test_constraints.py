r"""Constraints with a printed multiplier: the motion is on them, and the printed law has to keep them."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.verify.outcome import Verdict
from tests.audit.test_doubted import audited
from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

SUM = r"""The point moves on the sphere $$x_1^2+x_2^2+x_3^2=1.$$ The equations of motion are
$$\ddot x_i=-a_ix_i+\lambda x_i,\quad i=1,2,3,$$ with the multiplier $$\lambda=\sum_{i=1}^3(a_ix_i^2-\dot x_i^2).$$ """
VECTORS = r"""The equations of motion are
$$\dot x=y,\qquad\dot y=-Ax+\lambda x,\qquad\lambda=(Ax,x)-(y,y),$$ where $x,y\in\mathbb R^3$,
$A=\operatorname{diag}(a_1,a_2,a_3)$ and $(x,x)=1$, $(x,y)=0$. """
LENGTH = r"""A point $q\in R^3$ moves on the unit sphere $|q|=1$. The equations of motion are
$$\ddot q=-Aq+\mu q,\qquad\mu=(Aq,q)-(\dot q,\dot q),$$ where $A=\operatorname{diag}(a_1,a_2,a_3)$. """
LISTED = r"""A point $q=(q_1,q_2)$ moves on the circle $|q|^2=1$. The equations of motion are
$$\ddot q=-Aq+\mu q,\qquad\mu=(Aq,q)-(\dot q,\dot q),$$ where $A=\operatorname{diag}(a,b)$. """
FREE = r"""A point moves freely on the sphere $$x^2+y^2+z^2=1,$$ so that
$$\ddot x=-v^2x,\quad\ddot y=-v^2y,\quad\ddot z=-v^2z,$$ where $v^2=\dot x^2+\dot y^2+\dot z^2$. """


def judged(text):
    """Whether what formulas claim is green, and whether the motion is found to keep its constraints."""
    found = reading(text)
    outcomes = ReadingSession(found, timeout=20).outcomes
    return tuple(
        [outcomes[one.claim.id].verdict.green for one in every if one.claim is not None]
        for every in (found.formulas, found.statements)
    )


@pytest.mark.slow
@pytest.mark.parametrize(
    ("law", "true", "false"),
    [
        (SUM, r"$\sum_{i=1}^3(\dot x_i^2+a_ix_i^2)$", r"$\sum_{i=1}^3(\dot x_i^2-a_ix_i^2)$"),
        (VECTORS, r"$H=\frac12(y,y)+\frac12(Ax,x)$", r"$H=\frac12(y,y)-\frac12(Ax,x)$"),
        (LENGTH, r"$H=\frac12(\dot q,\dot q)+\frac12(Aq,q)$", r"$H=\frac12(\dot q,\dot q)+(Aq,q)$"),
        (LISTED, r"$H=(\dot q,\dot q)+(Aq,q)$", r"$H=(\dot q,\dot q)+(q,q)(Aq,q)^2$"),
        (FREE, r"$v$", r"$x\dot y+y\dot x$"),
    ],
)  # fmt: skip
def test_integrals_are_claimed_on_the_constraint_and_the_law_keeps_it(law, true, false):
    assert judged(rf"{law}The function {true} is an integral.") == ([True], [True])
    assert judged(rf"{law}The function {false} is an integral.") == ([False], [True])


@pytest.mark.parametrize(
    ("law", "printed", "misprinted"),
    [
        (SUM, r"(a_ix_i^2-\dot x_i^2)", r"(a_ix_i^2+\dot x_i^2)"),
        (VECTORS, "(Ax,x)-(y,y)", "(x,x)-(y,y)"),
        (LENGTH, r"-(\dot q,\dot q)", r"-2(\dot q,\dot q)"),
        (LISTED, "(Aq,q)-", "(q,q)-"),
        (FREE, r"\ddot y=-v^2y", r"\ddot y=-2v^2y"),
    ],
)
def test_a_misprinted_multiplier_does_not_keep_the_constraint(law, printed, misprinted):
    assert printed in law
    formulas, kept = judged(law.replace(printed, misprinted))
    assert [*formulas, *kept] == [False]


@pytest.mark.parametrize(
    "words",
    [
        r"Consider $$\ddot x=-x,\quad\ddot y=-2y.$$ The point stays on the circle $x^2+y^2=1$. Hence $x\dot x+y\dot y$ is an integral.",
        r"A point moves on the circle $$x^2+y^2=1$$ so that $$\dot x=y,\quad\dot y=-2x.$$ The function $x^2+y^2$ is an integral.",
        r"A point moves on the line $x=y$ so that $$\ddot x=-x,\quad\ddot y=-2y.$$ The function $x\dot y-y\dot x$ is an integral.",
        r"If it starts on the circle $x^2+y^2=1$, then by $$\ddot x=-x,\quad\ddot y=-2y$$ the function $x\dot x+y\dot y$ is an integral.",
    ],
)  # fmt: skip
def test_what_a_law_without_multiplier_is_said_to_keep_is_no_constraint(words):
    assert not any(one.green for one in verdicts(words).values())


@pytest.mark.parametrize("of", [r"x,y\in\mathbb R^3", r"x,y\in R^3", r"x, y \in \mathbb{R}^{3}"])
def test_points_of_a_space_are_vectors(of):
    found = reading(
        rf"$$\dot x=y,\qquad\dot y=-x,$$ where ${of}$. The function $(x,x)+(y,y)$ is an integral."
    )
    assert found.parts.paper.words.vectors == {"x", "y"}


FIRST_ORDER = r"""On the sphere $x_1^2+x_2^2+x_3^2=1$ there moves a point. With a multiplier $\lambda$ the equations are
$$\dot x_i=y_i,\qquad \dot y_i=-a_ix_i+\lambda x_i\qquad(i=1,2,3),\qquad \lambda=\sum_{k}(a_kx_k^2-y_k^2).$$ """


def test_of_velocities_the_constraint_gives_one_equation_more():
    found = judged(
        FIRST_ORDER
        + r"They keep $\sum x_iy_i=0$. The function $\sum_k(y_k^2+a_kx_k^2)$ is an integral."
    )
    assert found == ([True, True], [True])
    found = judged(
        FIRST_ORDER
        + r"They keep $\sum x_iy_i=1$. The function $\sum_k(y_k^2-a_kx_k^2)$ is an integral."
    )
    assert found == ([False, False], [True])


def test_a_constraint_is_the_same_in_new_variables():
    text = r"""A point moves on the surface \[ u^2+v^2=2qw. \] With the multiplier $\lambda$
    \[ \ddot u=\lambda u,\qquad\ddot v=\lambda v,\qquad\ddot w=-g-\lambda q. \]
    Let $u=\rho\cos\psi,\quad v=\rho\sin\psi$. Then \[ \rho\ddot\psi+2\dot\rho\dot\psi=0. \]"""
    assert verdicts(text)[r"\rho\ddot\psi+2\dot\rho\dot\psi=0"].green


BLADES = [
    (r"It does not slip sideways:", r"The equations of motion with the multiplier $N$ are"),
    (r"Лезвие не скользит в сторону:", r"Уравнения движения с множителем $N$ имеют вид"),
    (r"It is subject to the constraint", r"With the multiplier $N$ the equations of motion are"),
]
SKATE = r"""{} $$\dot u\sin\alpha-\dot w\cos\alpha=0.$$ {}
$$M\ddot u=N\sin\alpha,\qquad M\ddot w=-N\cos\alpha,\qquad\ddot\alpha=0.$$ Let $v=\dot u\cos\alpha+\dot w\sin\alpha$. Then """


@pytest.mark.parametrize(("binds", "law"), BLADES)
@pytest.mark.parametrize(
    ("true", "false"),
    [
        (r"\dot u=v\cos\alpha", r"\dot u=v\sin\alpha"),
        (r"\dot v=0", r"\dot v=v\dot\alpha"),
        (r"N=-Mv\dot\alpha", r"N=Mv\dot\alpha"),
    ],
)
def test_velocities_may_be_bound(binds, law, true, false):
    blade = SKATE.format(binds, law)
    assert verdicts(rf"{blade} $${true}.$$")[true].green
    assert not verdicts(rf"{blade} $${false}.$$")[false].green


@pytest.mark.parametrize(
    "binds",
    [
        "It slips sideways when",
        "It may slip:",
        "One sees that",
        "Lie claims that it does not slip:",
        "In the case of ice it does not slip:",
    ],
)
def test_what_no_words_call_a_constraint_binds_nothing(binds):
    blade = SKATE.format(binds, r"The equations with the multiplier $N$ are")
    assert not any(one.green for one in verdicts(rf"{blade} $$\dot v=0.$$").values())


SPHERE = r"""Let a particle be {} the sphere $x^2+y^2+z^2=1$. The equations of motion are
\[ \ddot x=-ax+\lambda x,\quad \ddot y=-by+\lambda y,\quad \ddot z=-cz+\lambda z \] with a multiplier. {}"""


BOUND = [
    (SPHERE.format(binds, rf"We find \[ {claim}. \] {place}"), claim, green)
    for binds in ("bound to", "confined to", "attached to", "tied to")
    for place in ("", r"There $p=\dot x$ is a velocity.")
    for claim, green in (
        (r"\lambda=ax^2+by^2+cz^2-\dot x^2-\dot y^2-\dot z^2", True),
        (r"\lambda=ax^2+by^2+cz^2+\dot x^2+\dot y^2+\dot z^2", False),
    )
]


@pytest.mark.parametrize(("text", "claim", "green"), sampled(BOUND, 4))
def test_a_particle_may_be_bound_to_what_constrains_it(text, claim, green):
    found = verdicts(text)
    assert found[claim].green == green


AT_POLES = r"""{} The energy $H=\frac12(\dot x^2+\dot y^2+\dot z^2+ax^2+by^2+cz^2)$ is constant.
At the points $e_k$ the multiplier is $\lambda=c$."""


@pytest.mark.parametrize(("term", "green"), [("cz^2", True), ("2cz^2", False)])
def test_a_value_of_a_multiplier_at_some_place_leaves_it_one(term, green):
    found = r"Differentiating, we find \[ \lambda=ax^2+by^2+cz^2-\dot x^2-\dot y^2-\dot z^2. \]"
    text = AT_POLES.format(SPHERE.format("bound to", found)).replace("by^2+cz^2)", f"by^2+{term})")
    energy = next(one for tex, one in verdicts(text).items() if tex.startswith("H"))
    assert energy.green == green


PENDULUM = r"""\section{Equations} A particle moves on the sphere $x^2+y^2+z^2=l^2$. Its equations are
\begin{equation}\ddot x=\lambda x,\qquad\ddot y=\lambda y,\qquad\ddot z=\lambda z-g.\end{equation}
The energy \begin{equation}h=\frac12(\dot x^2+\dot y^2+\dot z^2)SIGNgz\end{equation} is constant. """


@pytest.mark.parametrize(
    "special",
    [
        r"\section{Cone} On the horizontal circle $z=-l\cos\alpha$ it moves uniformly.",
        r"\section{Cone} The particle moves uniformly on the circle $z=-\frac12l$.",
        r"\section{Meridian} There are motions on the great circle $y=0$.",
        r"\section{Конус} Частица равномерно движется по окружности $z=c$.",
    ],
)
def test_what_special_motions_satisfy_is_no_constraint_of_all(special):
    for sign, expected in (("+", "conditional"), ("-", "refuted")):
        found = audited(PENDULUM.replace("SIGN", sign) + special)
        energy = next(one for one in found.formulas if one.tex.strip().startswith("h="))
        assert energy.verdict == expected
        assert not any(one.verdict == "refuted" for one in found.formulas if one is not energy)


def test_a_constraint_may_stand_behind_the_law():
    text = r"""The bead has \begin{equation}\ddot x=\lambda x,\qquad\ddot y=\lambda y-g.\end{equation}
    It moves on the circle $x^2+y^2=1$. The energy $h=\frac12(\dot x^2+\dot y^2)+gy$ is constant."""
    assert [one.verdict for one in audited(text).formulas if one.claims] == ["conditional"]


TOGETHER = r"""The equations of motion are \[\dot x_i=y_i,\quad \dot y_i=-a_ix_i+\nu x_i,\quad i=1,2,\]
\[\nu=a_1x_1^2+a_2x_2^2-y_1^2-y_2^2,\] together with the constraints $x_1^2+x_2^2=1$ and $x_1y_1+x_2y_2=0$. """


@pytest.mark.parametrize(("sign", "green"), [("+", True), ("-", False)])
def test_the_motion_is_on_what_words_behind_a_law_call_constraints(sign, green):
    claim = rf"\section{{Energy}} The energy \[H=\frac12(y_1^2+y_2^2{sign}a_1x_1^2{sign}a_2x_2^2)\] is conserved."
    *_, last = verdicts(TOGETHER + claim).values()
    assert last.green is green


def test_rates_that_words_call_linear_near_a_place_are_no_equations_of_motion():
    claim = r"\section{Rest} Near $x=(1,0)$ the linear equation is \[\ddot x_2=-(a_2-a_1)x_2 .\]"
    assert not any(one is Verdict.REFUTED for one in verdicts(TOGETHER + claim).values())


BOUND = r"Let $m\ddot x=\lambda x$, $m\ddot y=\lambda y$ and $x^2+y^2=1$. "


@pytest.mark.parametrize(
    ("claim", "true"),
    [
        (r"Then $\frac m2(\dot x^2+\dot y^2)$ is constant.", True),
        (r"Then $\frac m2(\dot x^2-\dot y^2)$ is constant.", False),
        (r"Then $\lambda=-m(\dot x^2+\dot y^2)$.", True),
        (r"Then $\lambda=m(\dot x^2+\dot y^2)$.", False),
    ],
)
def test_equations_for_one_coordinate_each_have_one_multiplier(claim, true):
    assert [one.green for one in verdicts(BOUND + claim).values()] == [true]


def test_what_binds_the_coordinates_of_two_systems_is_read():
    text = r"Let $m\ddot x=\lambda x$. Let $m\ddot y=\lambda y$. Here $x^2+y^2=1$. "
    found = verdicts(rf"{text}Then $\frac m2(\dot x^2-\dot y^2)$ is constant.")
    assert not any(one.green for one in found.values())


def test_a_constraint_of_a_later_section_holds_nowhere_before():
    law = r"\section{One} The equation of motion is \[a\ddot\varphi=-g\sin\varphi .\] Then \[\frac{d}{dt}(a\dot\varphi^2-2g\cos\varphi)=0 .\] "
    later = r"""\section{Two} Consider now the constraint \[r\dot\theta-a\dot\varphi=0 .\] With the multiplier $\lambda$
    \[ma^2\ddot\varphi=-mga\sin\varphi+\lambda a,\qquad J\ddot\theta=-\lambda r .\]"""
    found = verdicts(law + later)
    assert next(iter(found.values())).green


THREAD = r"""A heavy particle is subject to the constraint $$x^2+y^2=l^2.$$ Its equations of motion are
$$m\ddot x=2\lambda x,\qquad m\ddot y=2\lambda y-mg.$$ """
WIRES = [
    r"A bead slides on the curve $y=kx^3$. We have \begin{align} m\ddot x&=-3k\lambda x^2,\\ m\ddot y&=\lambda-mg, \end{align} hence ",
    r"Бусинка скользит по кривой $y=kx^3$. Имеем $$m\ddot x=-3k\lambda x^2,\quad m\ddot y=\lambda-mg,\quad y=kx^3,$$ откуда ",
    r"With a multiplier $$m\ddot x=-3k\lambda x^2,\quad m\ddot y=\lambda-mg,\quad y=kx^3,$$ hence ",
]  # fmt: skip
HEADINGS = [r"\paragraph{%s}", "\n\n\\textbf{%s}", "\n\n\\noindent{\\bf %s}", r"\subsection{%s}"]


@pytest.mark.parametrize(("g", "true"), [("3g", True), ("2g", False)])
@pytest.mark.parametrize("wire", WIRES)
def test_a_coordinate_that_others_give_is_bound_beside_a_multiplier(wire, g, true):
    found = verdicts(wire + rf"$$(1+9k^2x^4)\ddot x+18k^2x^3\dot x^2+{g}kx^2=0.$$")
    assert [one.green for one in found.values()] == [true]


@pytest.mark.parametrize("heading", HEADINGS)
def test_below_another_heading_a_constraint_binds_another_motion(heading):
    first = heading % "1. A pendulum." + THREAD
    text = first + heading % "2. A wire." + WIRES[0]
    found = reading(text + r"$$(1+9k^2x^4)\ddot x+18k^2x^3\dot x^2+3gkx^2=0.$$")
    assert judged(text + r"$$(1+9k^2x^4)\ddot x+18k^2x^3\dot x^2+3gkx^2=0.$$")[0] == [True]
    assert len(found.parts.known) == 2
    assert judged(text + r"$$(1+9k^2x^4)\ddot x+18k^2x^3\dot x^2+gkx^2=0.$$")[0] == [False]
    assert judged(text + r"$$x\dot x+y\dot y=0.$$")[0] == [False]


DISC = r"""The constraints of a disc that rolls are
$$\dot x=R\dot\psi\cos\theta,\qquad\dot y=R\dot\psi\sin\theta.$$ The equations of motion are
\begin{align} m\ddot x&=\lambda_1,& m\ddot y&=\lambda_2,\\ A\ddot\theta&=0,& C\ddot\psi&=-R(\lambda_1\cos\theta+\lambda_2\sin\theta). \end{align} """


@pytest.mark.parametrize(
    "first", ["", HEADINGS[0] % "1. A pendulum." + THREAD + HEADINGS[0] % "2. A disc."]
)
@pytest.mark.parametrize(
    ("claim", "true"),
    [
        (r"\lambda_1=-mR\dot\theta\dot\psi\sin\theta", True),
        (r"\lambda_2=-mR\dot\theta\dot\psi\cos\theta", False),
        (r"\ddot\psi=0", True),
        (r"\ddot x=R\ddot\psi\cos\theta+R\dot\theta\dot\psi\sin\theta", False),
    ],
)
def test_a_multiplier_alone_on_a_side_is_no_name(first, claim, true):
    assert judged(first + DISC + rf"Hence $${claim}.$$")[0] == [true]


def test_rates_that_are_said_to_be_constant_are_integrals():
    words = r"So the angular velocities $\dot\theta=\Omega$, $\dot\psi=\omega$ are constant, and the reactions are"
    found = verdicts(DISC + rf"{words} $$\lambda_1=-mR\omega\Omega\sin\theta.$$")
    assert len(found) == 3 and all(one.green for one in found.values())
    found = verdicts(DISC + rf"{words} $$\lambda_1=mR\omega\Omega\sin\theta.$$")
    assert [one.green for one in found.values()] == [True, True, False]
    found = verdicts(DISC + r"So the velocities $\dot x=u$, $\dot\psi=\omega$ are constant.")
    assert [one.green for one in found.values()] == [False, True]


def test_a_sum_of_what_moves_has_its_own_equation_by_a_constant():
    """What is given before equations with a parameter is a name, and its own equation a claim."""
    law = r"With $z=x+y$ we have $$\ddot x=-\lambda x,\quad\ddot y=-\lambda y,\quad\ddot z={}\lambda z.$$"
    assert verdicts(law.format("-"))[r"\ddot z=-\lambda z"].green
    assert not verdicts(law.format("-2"))[r"\ddot z=-2\lambda z"].green


@pytest.mark.parametrize(("sign", "true"), [("+", True), ("-", False)])
@pytest.mark.parametrize(
    "words",
    [
        r"On an inclined plane the first of the equations (\ref{law}) is replaced by",
        r"Наклоним плоскость. Тогда первое из уравнений (\ref{law}) заменится на",
    ],
)
def test_a_constraint_stays_where_an_equation_of_motion_is_replaced(words, sign, true):
    labelled = DISC.replace(r"\begin{align}", r"\begin{align}\label{law}")
    more = r"$$m\ddot x=\lambda_1+mg\sin\alpha,$$ and we get $$(C+mR^2)\ddot\psi={}mgR\sin\alpha\cos\theta.$$"
    first = r"\paragraph{1. A plane.} " + labelled + r"\paragraph{2. A slope.} "
    assert judged(first + words + more.replace("{}", sign.strip("+")))[0] == [true]
