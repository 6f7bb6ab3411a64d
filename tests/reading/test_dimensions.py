"""What scales as nothing else in a paper does: misprints that no claim has to show."""

import pytest

from kowalevski_cas.audit.audited import GIVEN
from kowalevski_cas.notation import to_latex
from kowalevski_cas.reading import read
from kowalevski_cas.reading.dimensions import AS_THE_REST, misscaled
from kowalevski_cas.source.files import decode
from kowalevski_cas.verify.outcome import Verdict
from tests.audit.test_doubted import audited
from tests.sample import sampled

BEAD = r"""A bead of mass $\mu$ slides on a wire. Its potential energy and its equation of motion are
\[ W=\frac{\mu\nu^2}{2}s^2 , \]
\[ \mu\ddot s=-\mu\nu^2s . \]
Its kinetic energy is
\begin{equation}\label{T}K=%s . \end{equation}
The Lagrangian is
\[ \Lambda=K-W . \]
The energy is \[ E=K+W=\frac{\mu}{2}(\dot s^2+\nu^2s^2) . \]
"""


def found(text):
    source = decode("paper.tex", (r"\begin{document}" + text + r"\end{document}").encode())
    return [one for known in read(source).parts.known for one in misscaled(known)]


@pytest.mark.parametrize(
    ("wrong", "right"),
    sampled(
        [
            (r"\frac12\mu\dot s", r"K = \frac{1}{2}\mu\dot{s}^2"),
            (r"\frac12\mu^2\dot s^2", r"K = \frac{1}{2}\mu\dot{s}^2"),
            (r"\frac12\dot s^2", r"K = \frac{1}{2}\mu\dot{s}^2"),
        ],
        2,
    ),
)
def test_a_definition_that_disagrees_with_the_rest_is_told_with_what_agrees(wrong, right):
    one, *more = found(BEAD % wrong)
    assert one.item.typed.labels == ("T",) and not more
    assert right in [to_latex(formula) for _, formula in one.repairs]


ROD = r"""As the length $b$ of a rod is constant, the coordinates of its end depend on
each other: \[ \xi^2+\eta^2=b^2 . \] In terms of the angle $\chi$
\begin{equation}\label{end}\xi=%s\cos\chi,\qquad\eta=%s\sin\chi . \end{equation}"""


def test_it_is_yellow_and_nothing_is_refuted_by_it():
    wrong = [one for one in audited(ROD % ("", "")).formulas if one.label == "end"]
    assert {one.verdict for one in wrong} == {Verdict.UNDECIDED}
    assert all(AS_THE_REST in one.message and r"b\cos" in wrong[0].message for one in wrong)
    right = [one for one in audited(ROD % ("b", "b")).formulas if one.label == "end"]
    assert {one.verdict for one in right} == {GIVEN}


TRUE = [
    BEAD % r"\frac12\mu\dot s^2",
    # another quantity may have any dimension
    BEAD % r"\frac12\mu\dot s^2" + r"Put $j=\mu s\dot s$ and $n=s^3$.",
    # units in which a constant is 1
    BEAD % r"\frac12\mu\dot s^2"
    + r"We take $\mu=1$. Put \[ N=\frac12\dot s^2-\frac12\nu^2s^2 . \]",
    BEAD % r"\frac12\mu\dot s^2" + r"At $s=1$ we have $W=\frac{\mu\nu^2}2$.",
    # equations without units
    r"""The equations are \[ \dot u=w,\qquad \dot w=u-u^3-\delta w . \]
    Put $F=w^2-u^2$ and $G=uw$. Near the origin \[ \ddot v=v-\delta\dot v . \]""",
    r"""The equations are \[ \dot X=\sigma(Y-X),\quad \dot Y=X(\rho-Z)-Y,\quad \dot Z=XY-\beta Z . \]
    Put $R=X^2-2\sigma Z$ and $S=XY$. The fixed points have $X^2=\beta(\rho-1)$.""",
    # arguments and exponents are numbers
    r"""The bob of mass $m$ on a thread of length $b$ has the energy
    \[ E=\frac12mb^2\dot\chi^2-mgb\cos\chi . \] The equation is \[ \ddot\chi=-\frac gb\sin\chi . \]
    For small $\chi$ put $\chi=Ce^{i\omega t}$ and $\omega^2=\frac gb$.""",
    # what is said of momenta together is said of each
    r"""Let \[ H=\frac12(p_x^2+p_y^2)+\frac12(x^2+y^2)+x^2y+\frac13y^3 . \] The equations are
    \[ \ddot x=-x-2xy,\qquad \ddot y=-y-x^2-y^2 , \] and an integral is \[ F=p_xp_y+xy+xy^2+\frac13x^3 . \]""",
    # a raised index is no power
    r"""The scheme for $\dot f=h$, $\dot h=-\kappa f$ is
    \[ f^{n+1}=f^n+\tau h^n,\qquad h^{n+1}=h^n-\tau\kappa f^n . \]""",
    # a unit vector
    r"""Let $\mathbf e$ be vertical, $(\mathbf e,\mathbf e)=1$, and \[ \mathbf G=J\mathbf w+D\,\mathbf
    e\times(\mathbf w\times\mathbf e),\qquad B=J+D . \] Put $U=(\mathbf G,\mathbf w)$.""",
]


@pytest.mark.parametrize("text", TRUE)
def test_nothing_true_is_suspected(text):
    assert not found(text)


def test_a_law_that_disagrees_is_blamed_before_what_is_deduced_from_it():
    text = r"""Consider \[ P=\frac{n\kappa^2}2y^2+\frac{n\gamma}4y^4 . \] The motion obeys
    \begin{equation}\label{law}\ddot y=-\kappa^2y^2-\gamma y^3 .\end{equation}
    Put $\Gamma^2=\kappa^2+\gamma b^2$ and $c=\frac{\gamma b^2}{\Gamma^2}$. Then
    \begin{equation}\label{rate}\ddot y=-\Gamma^2\left((1-c)y+c\frac{y^3}{b^2}\right).\end{equation}"""
    by_label = {formula.label: formula for formula in audited(text).formulas if formula.label}
    assert by_label["law"].verdict == "suspect" and r"\kappa^2y - " in by_label["law"].message
    assert by_label["rate"].causes and by_label["rate"].correction is None


@pytest.mark.parametrize("law", [r"\ddot x=-x^3+x", r"\ddot x=x-\dot x^2", r"\dot x=x^2-1"])
def test_a_law_may_say_alone_how_the_time_scales(law):
    assert not found(
        rf"Consider ${law}$. Put \[ U(x)=\frac14x^4-\frac12x^2 .\] Then $U'(x)=x^3-x$, $U''(x)=3x^2-1$."
    )


def test_where_the_time_has_no_dimension_a_law_has_units_of_its_own():
    law = r"\dot x=s(y-x),\quad \dot y=rx-y-xz,\quad \dot z=xy-bz"
    assert not found(
        rf"Consider ${law}$. The exponents obey \[ m^3+(s+b+1)m^2+b(r+s)m+2sb(r-1)=0 .\]"
    )


HOOP = r"""A bead on a turning hoop moves by
\[ \ddot\theta=\sin\theta\,(\Omega^2\cos\theta-\nu^2) . \] An integral is
\[ \frac12\dot\theta^2-\frac12\Omega^2\sin^2\theta-\nu^2\cos\theta=h . \]
Near the lower point \[ \ddot\theta+(\nu^2-\Omega^2)\theta=0 . \] Near the upper one we put $\theta=%s$:
\[ \ddot\eta=(\nu^2+\Omega^2)\eta . \] Let $\theta=\theta_0+\xi$, where $\cos\theta_0=\nu^2/\Omega^2$. Then
\[ \ddot\xi=-\frac{\Omega^4-\nu^%s}{\Omega^2}\xi , \] with the period
\[ \tau=\frac{2\pi\Omega}{\sqrt{\Omega^4-\nu^4}} . \]"""


@pytest.mark.parametrize("shift", [r"\pi+\eta", r"\pi-\eta"])
def test_a_deviation_from_an_angle_is_not_doubted_for_what_else_is_wrong(shift):
    assert [r"\xi" in one.item.typed.tex for one in found(HOOP % (shift, 2))] == [True]
    assert not found(HOOP % (shift, 4))
