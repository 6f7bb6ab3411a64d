"""How papers print equations of motion: by columns, by integrals, by fields, with letters of rates."""

import pytest

from tests.reading.test_reading import verdicts

COLUMN = r"The system is \[ \frac{d}{dt}\begin{pmatrix}x\\y\end{pmatrix}=\begin{pmatrix}0&1\\-k&0\end{pmatrix}\begin{pmatrix}x\\y\end{pmatrix}. \] "
LETTER = r"The equations of motion are \[ \begin{pmatrix}\dot x\\ \dot y\end{pmatrix}=A\begin{pmatrix}x\\y\end{pmatrix},\qquad A=\begin{pmatrix}0&1\\-k&0\end{pmatrix}. \] "
PENDULA = r"Two pendula joined by a spring obey \[ \begin{pmatrix}\ddot x\\ \ddot y\end{pmatrix}=-\begin{pmatrix}a&-b\\-b&a\end{pmatrix}\begin{pmatrix}x\\ y\end{pmatrix}. \] "
MASSES = r"\[ m\frac{d^2}{dt^2}\begin{pmatrix}x_1\\x_2\end{pmatrix}+k\begin{pmatrix}2&-1\\-1&2\end{pmatrix}\begin{pmatrix}x_1\\x_2\end{pmatrix}=0. \] With $Q=x_1-x_2$ we have "
CENTRAL = (
    r"In polar coordinates \[ \ddot r-r\dot\varphi^2=-\frac k{r^2},\qquad r^2\dot\varphi=h. \] "
)
CONE = r"On a cone \[ m\ddot r=mr\dot\varphi^2\sin^2\alpha-mg\cos\alpha \] with the integral of areas $r^2\dot\varphi=C$. "
MOMENTUM = (
    r"One has $p=mr^2\dot\varphi=\mathrm{const}$ and \[ m\ddot r=mr\dot\varphi^2-\frac k{r^2}. \] "
)
SPHERICAL = r"Сферический маятник: \[ \ddot\theta-\dot\varphi^2\sin\theta\cos\theta+\frac gl\sin\theta=0. \] Интеграл площадей $\dot\varphi\sin^2\theta=c$. "
ALONG = r"In the field $\vec B=B\,\vec e_z$ a charge obeys \[ m\frac{d\vec v}{dt}=q\vec v\times\vec B. \] In components $\dot v_x=\omega v_y$, where $\omega=\frac{qB}m$, and "
CROSSED = r"A charge moves by \[ m\dot{\mathbf v}=e\mathbf E+e\mathbf v\times\mathbf B. \] Let $\mathbf E\cdot\mathbf B=0$. "
DRIFT = CROSSED + r"Writing $\mathbf v=\frac{\mathbf E\times\mathbf B}{B^2}+\mathbf u$ we get "
HUBBLE = r"Let $H=\dot a/a$. The equations reduce to \[ \dot H=-3H^2. \] "
VELOCITY = r"The velocity is $v=\dot x$. It decays by \[ m\dot v=-cv. \] "
FOUCAULT = (
    r"In complex notation $z=x+iy$ the pendulum obeys \[ \ddot z+2i\Omega\dot z+\omega^2z=0. \] "
)
PENNY = r"A disc rolls with the constraints $\dot x=R\dot\varphi\cos\theta$ and $\dot y=R\dot\varphi\sin\theta$. The equations with multipliers are \[ m\ddot x=\lambda_1,\quad m\ddot y=\lambda_2,\quad I\ddot\varphi=-R(\lambda_1\cos\theta+\lambda_2\sin\theta),\quad J\ddot\theta=0. \] "

STATEMENTS = [
    (COLUMN + "The function ${}$ is constant.", "kx^2+y^2", "kx^2-y^2"),
    (LETTER + "The function ${}$ is constant.", "kx^2+y^2", "kx^2-y^2"),
    (PENDULA + r"The sum $u=x+y$ obeys ${}$.", r"\ddot u+(a-b)u=0", r"\ddot u+(a+b)u=0"),
    (PENDULA + r"The energy ${}$ is constant.",
     r"\dot x^2+\dot y^2+a(x^2+y^2)-2bxy", r"\dot x^2+\dot y^2+a(x^2+y^2)+2bxy"),
    (MASSES + "${}$.", r"m\ddot Q=-3kQ", r"m\ddot Q=-kQ"),
    (CENTRAL + "Hence ${}$.", r"\ddot r=\frac{h^2}{r^3}-\frac k{r^2}", r"\ddot r=\frac{h^2}{r^3}+\frac k{r^2}"),
    (CENTRAL + "The energy ${}$ is constant.",
     r"\frac12(\dot r^2+r^2\dot\varphi^2)-\frac kr", r"\frac12(\dot r^2+r^2\dot\varphi^2)+\frac kr"),
    (CONE + "The energy ${}$ is constant.",
     r"\frac m2\dot r^2+\frac{mC^2\sin^2\alpha}{2r^2}+mgr\cos\alpha", r"\frac m2\dot r^2+\frac{mC^2}{2r^2}+mgr\cos\alpha"),
    (MOMENTUM + "The energy ${}$ is conserved.",
     r"\frac m2\dot r^2+\frac{p^2}{2mr^2}-\frac kr", r"\frac m2\dot r^2+\frac{p^2}{mr^2}-\frac kr"),
    (SPHERICAL + "Функция ${}$ постоянна.",
     r"\dot\theta^2+\frac{c^2}{\sin^2\theta}-\frac{2g}l\cos\theta", r"\dot\theta^2+\frac{c^2}{\sin^2\theta}+\frac{2g}l\cos\theta"),
    (ALONG + "${}$.", r"\dot v_y=-\omega v_x", r"\dot v_y=\omega v_x"),
    (CROSSED + r"Then ${}$ is constant.", r"\mathbf v\cdot\mathbf B", r"\mathbf v\cdot\mathbf E"),
    (DRIFT + "${}$.", r"m\dot{\mathbf u}=e\mathbf u\times\mathbf B", r"m\dot{\mathbf u}=-e\mathbf u\times\mathbf B"),
    (HUBBLE + "Hence ${}$ is constant.", "1/H-3t", "1/H+3t"),
    (VELOCITY + "Hence ${}$ is constant.", "mv+cx", "mv-cx"),
    (FOUCAULT + "The function ${}$ is conserved.", r"|\dot z|^2+\omega^2|z|^2", r"|\dot z|^2-\omega^2|z|^2"),
    (PENNY + "They give ${}$.", r"\lambda_1=-mR\dot\varphi\dot\theta\sin\theta", r"\lambda_1=mR\dot\varphi\dot\theta\sin\theta"),
]  # fmt: skip


def last(text):
    """The verdict for the last claim of a text; empty if it has none."""
    return next((one.value for one in reversed(verdicts(text).values())), "")


@pytest.mark.parametrize(("text", "true", "false"), STATEMENTS)
def test_what_is_stated_of_such_laws(text, true, false):
    assert last(text.replace("{}", true, 1)) in ("proved", "conditional")
    assert last(text.replace("{}", false, 1)) in ("refuted", "undecided")


RADIAL = r"The radial equation is \[ m\ddot r=mr\dot\varphi^2-\frac k{r^2}, \] "
ENERGY = r"The energy $\frac m2\dot r^2+\frac m2r^2\dot\varphi^2-\frac kr$ is conserved."


@pytest.mark.parametrize(
    "text",
    [
        RADIAL + r"where $\omega=\dot\varphi$ is the angular velocity. " + ENERGY,
        RADIAL + r"where $l=mr^2\dot\varphi$ is not constant. " + ENERGY,
        RADIAL + r"$r^2\dot\varphi=h$, and there is friction. " + ENERGY,
        r"The motion obeys \[ \begin{pmatrix}\dot x\\ \dot y\end{pmatrix}=A\begin{pmatrix}x\\y\end{pmatrix}. \] The ratio $x/y$ is constant.",
        r"Let $\omega=\dot\varphi$. The body moves by \[ m\ddot r=mr\omega^2-\frac k{r^2}. \] The energy $\frac m2\dot r^2+\frac m2r^2\omega^2-\frac kr$ is conserved.",
    ],
)
def test_what_nothing_moves_is_not_judged(text):
    assert last(text) not in ("proved", "conditional", "refuted")


def test_a_column_behind_its_law_is_claimed():
    law = r"The motion obeys \[ \dot x=y,\qquad\dot y=-kx. \] In matrix form, "
    column = r"\[ \begin{pmatrix}\dot x\\ \dot y\end{pmatrix}=\begin{pmatrix}0&1\\{}&0\end{pmatrix}\begin{pmatrix}x\\y\end{pmatrix}. \]"
    assert last(law + column.replace("{}", "-k")) == "proved"
    assert last(law + column.replace("{}", "k")) not in ("proved", "conditional")
