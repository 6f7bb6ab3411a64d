"""What papers and lectures usually state of a law, in the words that are usual for it."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from tests.reading.test_reading import reading
from tests.sample import sampled

PREY = r"Volterra's model reads \[ \dot x=x(a-by),\qquad\dot y=y(kx-c) . \] "
ENZYME = r"The law of mass action is \[ \dot s=-kes+lc,\quad\dot c=kes-(l+n)c,\quad\dot e=-kes+(l+n)c,\quad\dot p=nc . \] "
DOUBLE = r"For small angles the pendulum moves by \[ 2\ddot\theta_1+\ddot\theta_2+\frac{2g}l\theta_1=0,\qquad\ddot\theta_1+\ddot\theta_2+\frac gl\theta_2=0 . \] "
TOP = r"The angular momentum $\mathbf M=(M_1,M_2,M_3)$ of the body satisfies \[ \dot{\mathbf M}=\mathbf M\times\boldsymbol\Omega,\qquad M_i=I_i\Omega_i\quad(i=1,2,3) . \] "
FLUID = r"Kirchhoff found \[ \dot{\mathbf M}=\mathbf M\times\frac{\partial H}{\partial\mathbf M}+\mathbf P\times\frac{\partial H}{\partial\mathbf P},\qquad\dot{\mathbf P}=\mathbf P\times\frac{\partial H}{\partial\mathbf M}, \] where $H(\mathbf M,\mathbf P)$ is a quadratic form. "
BRUSSELATOR = r"The Brusselator is the system \[ \dot x=A-(B+1)x+x^2y,\qquad\dot y=Bx-x^2y\qquad(A,B>0) . \] It has a single steady state, $(x_0,y_0)=(A,B/A)$. "
PLANE = r"A particle moves in the plane: \[ L=\tfrac12m(\dot r^2+r^2\dot\varphi^2)-V(r) . \] "
POISSON = r"Let $\{x_i,p_j\}=\delta_{ij}$, $\{x_i,x_j\}=\{p_i,p_j\}=0$ and $\mathbf M=\mathbf x\times\mathbf p$. Then $\{M_1,M_2\}=M_3$ and "
OSCILLATOR = r"Consider \[ \ddot x+\omega^2x=0 . \] "
LADDER = r"A ladder makes the angle $\theta$ with the wall and is released from rest at $\theta=\theta_0$. Then \[ \ddot\theta=\frac{3g}{4l}\sin\theta,\qquad "

STATEMENTS = [
    (PREY + r"In the quadrant $x,y>0$ the function \[ V(x,y)={} \] is constant along solutions.",
     r"kx-c\ln x+by-a\ln y", r"kx-c\ln x+by+a\ln y"),
    (PREY + r"The only interior equilibrium is $(x^*,y^*)={}$.", r"(c/k,a/b)", r"(c/k,b/a)"),
    (PREY + r"The interior equilibrium is $(x^*,y^*)=(c/k,a/b)$, and small oscillations about it "
     r"have the angular frequency $\omega={}$.", r"\sqrt{ac}", r"2\sqrt{ac}"),
    (ENZYME + r"Two quantities are conserved: the total enzyme, $e+c=e_0$, and the total substrate, ${}=s_0$.",
     "s+c+p", "s+e+p"),
    (ENZYME + r"The functions $e+c$ and ${}$ are conserved.", "s+c+p", "s+e+p"),
    (r"The kinetic energy is \[ K=\tfrac12m(\dot x^2+\dot y^2) . \] With $x=r\cos\varphi$, $y=r\sin\varphi$ "
     r"it becomes \[ K=\tfrac12m(\dot r^2+{}\dot\varphi^2) . \]", "r^2", "r"),
    (r"The kinetic energy is \[ K=\tfrac12m(\dot x^2+\dot y^2) . \] Since $x=b\sin\vartheta$, $y=-b\cos\vartheta$, "
     r"we get \[ K=\tfrac12mb{}\dot\vartheta^2 . \]", "^2", ""),
    (ENZYME + r"There are the integrals of the enzyme $e+c=e_0$ and of the substrate ${}=s_0$.",
     "s+c+p", "s+e+p"),
    (ENZYME + r"Then $e+c=e_0$ is constant. Putting $\dot c=0$ (quasi-steady state) one finds "
     r"$c={}$, where $K=\frac{l+n}k$ is the constant of Michaelis.",
     r"\frac{e_0s}{K+s}", r"\frac{e_0s}{K-s}"),
    (DOUBLE + r"The secular equation reads ${}=0$.",
     r"l^2\omega^4-4gl\omega^2+2g^2", r"l^2\omega^4-4gl\omega^2+g^2"),
    (DOUBLE + r"The frequency equation is $l^2\omega^4-4gl\omega^2+2g^2=0$, and its roots are $\omega_{1,2}^2=(2\mp{})g/l$.",
     r"\sqrt2", r"\sqrt3"),
    (DOUBLE + r"In the slower mode $\theta_2=\sqrt2\,\theta_1$, in the faster one $\theta_2={}\theta_1$.",
     r"-\sqrt2\,", "-2"),
    (r"The motion obeys \[ \ddot x=-x+z^2,\qquad\ddot z=-z(1+x) . \] The plane ${}=0$ is invariant.",
     "z", "x"),
    (TOP + r"The energy ${}$ is a first integral.",
     r"\tfrac12\mathbf M\cdot\boldsymbol\Omega", r"I_1\Omega_1^2+I_2\Omega_2^2-I_3\Omega_3^2"),
    (FLUID + r"If the body has an axis of symmetry, \[ H=a(M_1^2+M_2^2)+bM_3^2+c(P_1^2+P_2^2), \] then $M_{}=\mathrm{const}$.",
     "3", "1"),
    (BRUSSELATOR + r"The Jacobian matrix there has trace ${}$; so it is stable at $B=0$.",
     "B-1-A^2", "B-1+A^2"),
    (BRUSSELATOR + r"The determinant of the linear part at this point is ${}$.", "A^2", "-A^2"),
    (r"Consider \[ \dot v=v-v^3-w,\quad\dot w=b(v-aw) . \] At the origin the Jacobian matrix has the "
     r"determinant $b(1-a)$. The eigenvalues there satisfy ${}=0$.",
     r"\lambda^2-(1-ab)\lambda+b(1-a)", r"\lambda^2-(1-ab)\lambda+b(1+a)"),
    (r"Consider \[ \dot x=A\sin z+C\cos y,\ \dot y=B\sin x+A\cos z,\ \dot z=C\sin y+{} . \] The "
     r"field $\mathbf v$ on the right is divergence-free, $\nabla\cdot\mathbf v=0$.",
     r"B\cos x", r"B\cos z"),
    (PLANE + r"The momentum $\ell=mr^2\dot\varphi$ is conserved. With $U(r)=\frac{\ell^2}{{}mr^2}+V(r)$ "
     r"the radial equation is $m\ddot r=-\frac{dU}{dr}$.", "2", "3"),
    (PLANE + r"Let $\ell=mr^2\dot\varphi$ and $U(r)=\frac{\ell^2}{2mr^2}+V(r)$. Then $m\ddot r={}U'(r)$.",
     "-", ""),
    (PLANE + r"The momentum is $\ell=mr^2\dot\varphi=\mathrm{const}$. With $U(r)=\frac{\ell^2}{{}mr^2}+V(r)$ "
     r"the radial equation is $m\ddot r=-\frac{dU}{dr}$.", "2", "3"),
    (PLANE + r"The momentum $\ell=mr^2\dot\varphi$ is constant. The energy is $E=\frac12m\dot r^2+U(r)$ "
     r"with $U(r)={}\frac{\ell^2}{2mr^2}+V(r)$, and $E$ is constant.", "", "2"),
    (POISSON + r"$\{M_1,p_2\}={}$.", "p_3", "-p_3"),
    (POISSON + r"$\{\mathbf x^2,\mathbf p^2\}={}\,\mathbf x\cdot\mathbf p$.", "4", "2"),
    (LADDER + r"\dot\theta^2={}(\cos\theta_0-\cos\theta) . \]", r"\frac{3g}{2l}", r"\frac g{2l}"),
    (OSCILLATOR + r"Its solution is $x=A\sin{}\omega(t-t_0)$.", "", "2"),
    (OSCILLATOR + r"It has the integral $\dot x^2+k^2x^2$ with $k={}\omega$.", "", "2"),
    (r"The hoop turns: \[ \ddot\theta=\sin\theta\left(\omega^2\cos\theta-\frac ga\right) . \] The "
     r"energy $\dot\theta^2-{}\omega^2\sin^2\theta-\frac{2g}a\cos\theta$ is constant.", "", "2"),
    (r"Consider \[ \dot x=y,\quad\dot y=x-x^3 . \] The Hamiltonian is $H=\frac12y^2{}\frac12x^2+\frac14x^4$.",
     "-", "+"),
    (r"Let the frequency depend on time, \[ \dot x=\frac pm,\quad\dot p=-m\omega^2x, \] where $\omega(t)$ "
     r"is a given function. Put \[ x=\sqrt{\frac{2J}{m\omega}}\,\sin\theta,\qquad p=\sqrt{2m\omega J}\,\cos\theta . \] "
     r"Then \[ \dot J=-\frac{\dot\omega}\omega J\cos{}\theta . \]", "2", "3"),
    (r"The profile satisfies \[ f''=\sin f,\qquad\text{with the integral}\qquad\tfrac12f'^2{}\cos f=h . \]",
     "+", "-"),
    (r"The model is \[ \dot v=v-v^3-w,\quad\dot w=b(v+a), \] with $0<b\ll1$. Then $\ddot v-(1-{}v^2)\dot v+b(v+a)=0$.",
     "3", ""),
    (r"Friction is in a Lagrangian with the time, \[ L=e^{kt}(\dot x^2-x^2) . \] The equation of Euler and "
     r"Lagrange is $\ddot x+{}\dot x+x=0$.", "k", "2k"),
    (r"In these angles \[ L=\dot x^2+\dot y^2-2xy . \] The energy $\dot x^2+\dot y^2{}2xy$ is an integral.",
     "+", "-"),
    (r"The kinetic and the potential energy are $T=\frac12m(\dot r^2+r^2\dot\varphi^2)$ and $V=-k/r$. The "
     r"quantity $T{}V$ is an integral.", "+", "-"),
]  # fmt: skip


def verdicts(text):
    found = reading(text)
    outcomes = ReadingSession(found, timeout=20).outcomes
    claims = [one.claim for one in (*found.formulas, *found.statements) if one.claim is not None]
    return [outcomes[claim.id].verdict for claim in claims]


@pytest.mark.parametrize("text, right, wrong", sampled(STATEMENTS, 8))
def test_what_is_right_is_green_and_what_is_wrong_is_not(text, right, wrong):
    assert verdicts(text.replace("{}", right, 1))[-1].green
    assert not verdicts(text.replace("{}", wrong, 1))[-1].green


EQUATIONS = [
    r"The kinetic energy is $T=\frac12ml^2\dot\varphi^2$, the potential energy $V=-mgl\cos\varphi$. Hence "
    r"\[ \ddot\varphi+\frac{{}g}l\sin\varphi=0 . \]",
    r"With \[ T=\tfrac12m\dot x^2,\qquad U=\tfrac12kx^2, \] one has \[ \ddot x+\frac{{}k}mx=0 . \]",
    r"Then \[ L=\tfrac12m\dot x^2-\tfrac12kx^2 \] and \[ \ddot x+\frac{{}k}mx=0 . \]",
]  # fmt: skip


@pytest.mark.parametrize("text", EQUATIONS)
def test_equations_of_motion_are_those_of_the_energies_before_them(text):
    assert [one.green for one in verdicts(text.replace("{}", ""))] == [True]
    assert not any(one.green for one in verdicts(text.replace("{}", "2")))


NOT_JUDGED = [
    r"A spin obeys $\dot{\vec M}=\vec M\times\vec B$, so that $\vec M^2$ does not change. With relaxation \[ \dot M_x=M_y-M_x,\quad\dot M_y=-M_x-M_y,\quad\dot M_z=-M_z . \]",
    r"With the function of forces \[ U=\frac kx,\qquad T=\tfrac12\dot x^2, \] we have \[ \ddot x=-\frac k{x^2} . \]",
    PLANE + r"Let $\ell=mr^2\dot\varphi$ and $U(r)=\frac{\ell^2}{2mr^2}+V(r)$.",
    r"With \[ T=\tfrac12\dot x^2,\qquad U=\frac kx, \] the quantity $T-U$ is an integral.",
    r"Small arcs obey \[ \ddot x=-\frac glx, \] where $x=l\theta$. The energy $\dot x^2+\frac glx^2$ is an integral.",
]  # fmt: skip


@pytest.mark.parametrize("text", NOT_JUDGED)
def test_nothing_is_red_where_another_law_or_another_function_is_meant(text):
    assert not any(one.value == "refuted" for one in verdicts(text))


def test_friction_beside_a_driven_lagrangian_is_not_in_it():
    text = r"The driven oscillator has \[ L=\tfrac12\dot x^2-\tfrac12x^2+x\cos t . \] There is friction. The Lagrangian gives $\ddot x+x=\cos t$."
    assert not any(one.green for one in verdicts(text))
