"""Functions that a paper leaves free: what holds is claimed of all of them, and nothing else."""

import pytest

from kowalevski_cas.reading import CLAIM
from kowalevski_cas.verify.outcome import Verdict
from tests.audit.test_doubted import audited
from tests.reading.test_reading import reading, verdicts

LINE = r"""A particle moves in the potential $U(x)$ by $$\ddot x=-U'(x).$$ """
PLANE = r"""In polar coordinates, with a potential $W(r)$, $$\ddot r-r\dot\theta^2=-W'(r),\qquad
r\ddot\theta+2\dot r\dot\theta=0 .$$ Put $h=\tfrac12(\dot r^2+r^2\dot\theta^2)+W(r)$ and $c=r^2\dot\theta$. """
FIELD = r"""The field $f=f(x)$ depends on $x$ only, and $$\ddot x=f(x)\dot y,\qquad \ddot y=-f(x)\dot x.$$
Let $g(x)$ be a primitive, $g'(x)=f(x)$. """
RADIAL = r"""By $k=k(r)$ we have $$\ddot r-r\dot\varphi^2=k(r)\,r\dot\varphi,\qquad r\ddot\varphi+2\dot r\dot\varphi=-k(r)\,\dot r .$$
Let $a'(r)=r\,k(r)$. """
TWO = r"""With the potential $V(x,y)$ let $$\ddot x=-\frac{\partial V}{\partial x},\qquad \ddot y=-\frac{\partial V}{\partial y}.$$ """
TIMED = r"""The stiffness $k(t)$ is given, and $$\ddot x=-k(t)x.$$ Put $E=\tfrac12\dot x^2+\tfrac12k(t)x^2$. """


@pytest.mark.parametrize(
    ("law", "true", "false"),
    [
        (LINE, r"\frac{d}{dt}\left(\tfrac12\dot x^2+U(x)\right)=0", r"\frac{d}{dt}\left(\tfrac12\dot x^2-U(x)\right)=0"),
        (LINE, r"\frac{d}{dt}U(x)=U'(x)\dot x", r"\frac{d}{dt}U(x)=U'(x)x"),
        (LINE, r"\frac{d^2}{dt^2}U(x)=U''(x)\dot x^2-U'(x)^2", r"\frac{d^2}{dt^2}U(x)=U''(x)\dot x^2+U'(x)^2"),
        (LINE, r"\frac{d}{dt}(x\dot x)=\dot x^2-xU'(x)", r"\frac{d}{dt}(x\dot x)=\dot x^2-xU(x)"),
        (LINE, r"\frac{d}{dt}\dot x^2=-2\frac{dU}{dx}\dot x", r"\frac{d}{dt}\dot x^2=-\frac{dU}{dx}\dot x"),
        (PLANE, r"\dot h=0", r"\dot h=\dot r"),
        (PLANE, r"\dot r^2=2h-2W(r)-\frac{c^2}{r^2}", r"\dot r^2=2h-2W(r)+\frac{c^2}{r^2}"),
        (PLANE, r"\ddot r=\frac{c^2}{r^3}-W'(r)", r"\ddot r=\frac{c^2}{r^3}-W(r)"),
        (FIELD, r"\frac{d}{dt}(\dot y+g(x))=0", r"\frac{d}{dt}(\dot y-g(x))=0"),
        (FIELD, r"\frac{d}{dt}(\dot x^2+\dot y^2)=0", r"\frac{d}{dt}(\dot x^2-\dot y^2)=0"),
        (RADIAL, r"\frac{d}{dt}(r^2\dot\varphi+a(r))=0", r"\frac{d}{dt}(r^2\dot\varphi-a(r))=0"),
        (TWO, r"\frac{d}{dt}\left(\tfrac12(\dot x^2+\dot y^2)+V(x,y)\right)=0", r"\frac{d}{dt}(x\dot y-y\dot x)=0"),
        (TIMED, r"\dot E=\tfrac12k'(t)x^2", r"\dot E=0"),
    ],
)  # fmt: skip
def test_what_holds_for_all_functions_is_proved_and_nothing_else(law, true, false):
    assert [one.green for one in verdicts(rf"{law}Then $${true}.$$").values()] == [True]
    found = [*verdicts(rf"{law}Then $${false}.$$").values()]
    assert found and not any(one.green for one in found)
    assert Verdict.REFUTED not in found  # words may say which functions are meant


@pytest.mark.parametrize(
    "words",
    [
        r"Then $U''(x)=k$. Hence $$\frac{d}{dt}\ddot x=-k\dot x.$$",
        r"Then $U''(x)=k$ and $$\frac{d}{dt}U'(x)=k\dot x.$$",
        r"Let $A=\oint\dot x\,dx$, and $c=\tfrac12\dot x^2+U(x)$. Then $$\frac{dA}{dc}=2T.$$ Hence $$\frac{d}{dt}A=2Tx.$$",
        r"Then $\tfrac12kx^2=U(x)$. Hence $$\ddot x=-kx.$$",
        r"We obtain $2U(x)=kx^2$. Hence $$\frac{d}{dt}(\dot x^2+kx^2)=0.$$",
        r"From this $U'(x)=kx$. Hence $$\frac{d}{dt}(\dot x^2+kx^2)=0.$$",
        r"If $U'(x)=kx$, then $x^3$ is constant.",
        r"Here $U(x)$ is even. Then $$\frac{d}{dt}U(x)=-U'(x)\dot x.$$",
    ],
)
def test_what_is_printed_of_a_function_later_is_not_its_definition(words):
    assert not any(one.green for one in verdicts(LINE + words).values())


@pytest.mark.parametrize(
    "claim",
    [
        r"U(-x)=U(x)",
        r"U(0)=0",
        r"\frac{d}{dt}\left(\tfrac12\dot x^2+U(a)\right)=0",
        r"\frac{d}{dt}\left(\tfrac12\dot x^2+U(x+a)\right)=0",
        r"\frac{d}{dt}\left(\tfrac12\dot x^2+U(2x)\right)=0",
        r"U'(x)=kx",
        r"U'(x)=U(x)",
        r"\ddot x=-kx",
        r"\frac{d}{dt}(\dot x^2+kx^2)=0",
        r"U(x)=U",
        r"\dot U=0",
        r"\frac{d}{dt}\tilde U(x)=0",
        r"\frac{d}{dt}\mathcal U(x)=0",
        r"U''(x)>0",
    ],
)
def test_what_holds_for_some_functions_is_not_proved(claim):
    text = rf"{LINE}Hence $${claim}.$$"
    assert not any(one.green for tex, one in verdicts(text).items() if tex != "U=U")


GENERAL = (
    LINE
    + r"""Put $E=\tfrac12\dot x^2+U(x)$. Then $$\dot E=0,\qquad \dot x^2=2E-2U(x).$$ {}

{} Then {}."""
)


@pytest.mark.parametrize(
    ("words", "claim"),
    [
        (r"For example, let $U(x)=\tfrac12kx^2$.", r"$\ddot x=-kx$"),
        (r"Consider the case $U=\tfrac12kx^2$.", r"$\frac{d}{dt}(\dot x^2+kx^2)=0$"),
        (r"If $U(x)=gx$, the fall is free.", r"$\ddot x=-g$"),
        (r"When $$U(x)=-\frac kx,$$ it falls.", r"$$\ddot x=-\frac{k}{x^2}$$"),
        (r"В частном случае $U(x)=gx$ тело падает.", r"$\ddot x=-g$"),
        (r"The special case $U=0$ is that of a free particle.", r"$\ddot x=0$"),
        (r"In particular for $U(x)=a$ nothing happens.", r"$$\frac{d}{dt}\dot x=0$$"),
        (r"For instance, when $U(x)=x^3$ it escapes.", r"$\ddot x=-3x^2$"),
    ],
)
def test_what_holds_for_an_example_is_claimed_of_no_other_function(words, claim):
    """General claims before an example hold for all functions, those behind it for the example."""
    found = verdicts(GENERAL.format("", words, claim))
    assert [one.green for one in found.values()][:2] == [True, True]
    assert Verdict.REFUTED not in found.values()
    found = verdicts(GENERAL.format(f"Hence {claim}.", words, r"$\dot E=E$"))
    assert not any(one.green for one in [*found.values()][2:])


@pytest.mark.parametrize(
    ("words", "true", "false"),
    [
        (r"For example, let $U(x)=\tfrac12kx^2$.", r"$\ddot x=-kx$", r"$\ddot x=-2kx$"),
        (r"\paragraph{Fall.} Let now $U(x)=gx$.", r"$\ddot x=-g$", r"$\ddot x=g$"),
        (r"Пусть теперь $U(x)=gx$.", r"$\ddot x=-g$", r"$\ddot x=-gx$"),
        (r"Take $U(x)=\cos x$.", r"$\dddot x=\dot x\cos x$", r"$\dddot x=\dot x\sin x$"),
        (r"\section{Gravity} For $U(x)=gx$ the fall is free.", r"$\ddot x=-g$", r"$\ddot x=0$"),
    ],
)
def test_an_example_is_supposed_of_what_follows(words, true, false):
    assert [one.green for one in verdicts(GENERAL.format("", words, true)).values()] == [True] * 3
    assert not [*verdicts(GENERAL.format("", words, false)).values()][-1].green


def test_another_example_takes_its_place_and_a_new_section_ends_it():
    fall, spring = r"\subsection{Fall} Let $U(x)=gx$.", r"\subsection{Spring} Let $U(x)=kx^2$."
    words = rf"{fall} Then $\ddot x=-g$. {spring} Then $\ddot x=-2kx$. Then $\dddot x=0$."
    found = [*verdicts(GENERAL.format("", words, r"$x=x$")).values()]
    assert [one.green for one in found[2:5]] == [True, True, False]
    found = verdicts(GENERAL.format("", fall, r"$x=x$ \subsection{All} Then $\dddot x=0$"))
    assert not found[r"\dddot x=0"].green


SURFACE = r"""A particle on a surface of revolution, \[ \mathbf X(u,v)=(f(u)\cos v,f(u)\sin v,g(u)), \]
moves by \[ \begin{cases} \ddot u-f(u)f'(u)\dot v^2=0,\\[4pt] \ddot v+\dfrac{2f'(u)}{f(u)}\dot u\dot v=0.
\end{cases} \] The prime is the derivative with respect to $u$. """


@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"The quantity \[ f(u)^2\dot v \] is constant.", True),
        (r"The quantity \[ \dot u^2+f(u)^2\dot v^2 \] is constant.", True),
        (r"The quantity \[ f(u)\dot v \] is constant.", False),
        (r"Hence \[ f^2\ddot v+2ff'\dot u\dot v=0. \]", True),
        (r"Hence \[ f^2\ddot v+ff'\dot u\dot v=0. \]", False),
    ],
)
def test_the_radius_of_a_surface_of_revolution_is_any_function(claim, green):
    assert [*verdicts(SURFACE + claim).values()][-1].green == green


def test_a_value_at_a_number_leaves_the_function_what_it_is():
    text = SURFACE + r"Let $c=f(u_0)$. The quantity \[ f(u)^2\dot v \] is constant."
    assert [*verdicts(text).values()][-1].green


def test_a_function_that_is_given_is_not_any():
    text = rf"{LINE}Here $U(x)=\tfrac12kx^2$. Hence $$\frac{{d}}{{dt}}(\dot x^2+kx^2)=0.$$"
    assert not reading(text).paper.functions
    assert not reading(r"The motion is $$\ddot u=-u.$$ Here $u(t)$ is the height.").paper.functions
    assert not reading(r"The motion is $$u''=-u.$$ Here $u(t)$ is the height.").paper.functions


def test_a_letter_may_be_a_function_of_something_else_in_another_section():
    text = rf"\section{{One}} {FIELD} \section{{Two}} Let $f=f(r)$. In polar coordinates the equations of motion are {{}}"
    rows = r"$$\ddot r-r\dot\varphi^2=f(r)\,r\dot\varphi,\qquad r\ddot\varphi+2\dot r\dot\varphi=-f(r)\,\dot r.$$"
    claim = r"The square $$\dot r^2+{}r^2\dot\varphi^2$$ is constant."
    assert [*verdicts(text.replace("{}", rows) + claim.replace("{}", "")).values()][-1].green
    assert not [*verdicts(text.replace("{}", rows) + claim.replace("{}", "2")).values()][-1].green


@pytest.mark.parametrize(
    "words",
    [
        "The set $x=0$ is invariant.",
        r"The functions $\tfrac12\dot x^2+U(x)$ and $x$ are dependent.",
        "The point $x=0$ is an equilibrium.",
        r"On the set $\tfrac12\dot x^2+U(x)=0$ the function $x$ is constant.",
    ],
)
def test_sets_are_not_judged_where_a_function_may_be_any(words):
    assert not any(one.green for one in verdicts(LINE + words).values())


HILL = r"""Let \[ \ddot u+k^2(t)u=0, \] where $k(t)$ is a given function of the time. """
ROPE = r"""The length $s(t)$ of the rope is a given function. \[ \ddot\psi+2\frac{\dot s}{s(t)}\dot\psi
+\frac{g}{s(t)}\sin\psi=0. \] With $P=s^2\dot\psi$ one has """


@pytest.mark.parametrize(
    ("text", "claim", "wrong"),
    [
        (HILL + r"The energy $E=\frac12(\dot u^2+k^2u^2)$ satisfies ",
         r"\frac{dE}{dt}=k\dot ku^2", r"\frac{dE}{dt}=2k\dot ku^2"),
        (ROPE, r"\dot P=-gs\sin\psi", r"\dot P=-gs\dot s\sin\psi"),
        (r"The force $F(t)$ is a periodic function and \[ \ddot q+q=F(t). \] "
         r"The energy $E=\frac12(\dot q^2+q^2)$ changes by ", r"\dot E=F\dot q", r"\dot E=\dot Fq"),
    ],
)  # fmt: skip
def test_functions_of_the_time_stand_alone_and_have_rates(text, claim, wrong):
    for tex, green in ((claim, True), (wrong, False)):
        assert [v.green for v in verdicts(text + rf"\[ {tex}. \]").values()] == [green]


@pytest.mark.parametrize(
    "text",
    [
        r"The equation is \[ m\dot v+kv(t)=0, \] where $v(t)$ is a smooth function. The function $v$ is an integral.",
        HILL + r"The energy $\frac12(\dot u^2+k^2u^2)$ is an integral.",
        r"Let \[ \dot x=y(t),\quad\dot y=-2x(t), \] where $x(t)$ is a function. The function $x^2+y^2$ is an integral.",
    ],
)  # fmt: skip
def test_what_moves_is_no_function_that_may_be_any(text):
    assert not any(v.green for v in verdicts(text).values())


@pytest.mark.parametrize(
    ("text", "green"),
    [
        (r"Let $\ddot x=-k^2x$, where $k$ varies slowly with time. The function $\dot x^2+k^2x^2$ is an integral.", False),
        (r"Пусть $\ddot x=-k^2x$, где $k$ медленно зависит от времени. Функция $\dot x^2+k^2x^2$ есть интеграл.", False),
        (r"A body of variable mass $m=m(t)$ moves by $m\ddot x=-kx$. The function $m\dot x^2+kx^2$ is constant.", False),
        (r"Let $\ddot x=-x+f$, where $f$ is a periodic function of time. The function $\dot x^2+x^2-2fx$ is an integral.", False),
        (r"Let $\dot x=y$, $\dot y=-kx$, where $k$ depends on $x$. The function $y^2+kx^2$ is an integral.", False),
        (r"In a field $B$ that depends on $x$ we have $\ddot x=B\dot y$, $\ddot y=-B\dot x$. The function $\dot y+Bx$ is constant.", False),
        (r"In a field $B$ that depends on $x$ we have $\ddot x=B\dot y$, $\ddot y=-B\dot x$. The function $\dot x^2+\dot y^2$ is constant.", True),
        (r"Let $\ddot x=-k^2x$, where $k$ does not depend on time. The function $\dot x^2+k^2x^2$ is an integral.", True),
        (r"Let $\ddot x=-k^2x$, where $k$ is not constant. The function $\dot x^2+k^2x^2$ is an integral.", False),
        (r"Let $\ddot x=-k^2x$, where $k$ is time-dependent. The function $\dot x^2+k^2x^2$ is an integral.", False),
        (r"Let $\ddot x=-k^2x$, where $k$ slowly increases. The function $\dot x^2+k^2x^2$ is an integral.", False),
        (r"Let $\ddot x=-k^2x$, where $k$ changes with time. The function $\dot x^2+k^2x^2$ is an integral.", False),
        (r"Let $\ddot x=-k^2x$, where the frequency $k$ is variable. The function $\dot x^2+k^2x^2$ is an integral.", False),
        (r"Let $\ddot x=-k^2x$, where $k$ need not be constant. The function $\dot x^2+k^2x^2$ is an integral.", False),
        (r"Let $\ddot x=-k^2x$, where $k$, a function of time, is given. The function $\dot x^2+k^2x^2$ is an integral.", False),
        (r"Let $\ddot x=-k^2x$, where die Frequenz $k$ ist eine Funktion der Zeit. The function $\dot x^2+k^2x^2$ is an integral.", False),
        (r"Let $\ddot x=-k^2x$, where la fréquence $k$ varie avec le temps. The function $\dot x^2+k^2x^2$ is an integral.", False),
        (r"Let $\ddot x=-k^2x$, where частота $k$ переменна. The function $\dot x^2+k^2x^2$ is an integral.", False),
        (r"Let $\ddot x=-k^2x$, where $k$ does not vary with time. The function $\dot x^2+k^2x^2$ is an integral.", True),
        (r"Let $\ddot x=-k^2x$, where $k$ changes from one oscillator to another. The function $\dot x^2+k^2x^2$ is an integral.", True),
        (r"Let $\ddot x=-k^2x$, where the amplitude decreases if $k$ increases. The function $\dot x^2+k^2x^2$ is an integral.", True),
        (r"Let $\ddot x=-k^2x$, where $k$ is not variable. The function $\dot x^2+k^2x^2$ is an integral.", True),
        (r"Let $\ddot x=-k^2x$, where частота $k$ не зависит от времени. The function $\dot x^2+k^2x^2$ is an integral.", True),
        (r"Let $\ddot x=-k^2x$. The period depends on $k$. The function $\dot x^2+k^2x^2$ is an integral.", True),
    ],
)  # fmt: skip
def test_words_say_on_what_a_letter_depends(text, green):
    assert [v.green for v in verdicts(text).values()] == [green]


@pytest.mark.parametrize(("rate", "green"), [(r"k\dot kx^2", True), (r"2k\dot kx^2", False)])
def test_a_letter_that_depends_on_the_time_has_a_rate(rate, green):
    text = (
        r"Let $\ddot x=-k^2x$, where $k$ depends on time, and $E=\frac12(\dot x^2+k^2x^2)$. Then "
    )
    assert [v.green for v in verdicts(rf"{text}$\dot E={rate}$.").values()] == [green]


FIRST = r"""\section{Constant} The motion is \[ \ddot x=-k^2x. \] The function $\dot x^2+k^2x^2$ is an integral. """
SECOND = r"""\section{Variable} %s let $x$ and $y$ satisfy \[ \ddot x+k^2(t)x=0,\qquad \ddot y+k^2(t)y=0. \]
The function $x\dot y-y\dot x$ is an integral. The function $\dot x^2+k^2x^2$ is a first integral.
"""


@pytest.mark.parametrize(
    "said", ["With an arbitrary function $k(t)$", r"Let $k$ depend on the time and", "With $k(t)$"]
)
def test_a_letter_that_a_later_system_makes_a_function_was_a_constant_before(said):
    claims = [one for one in audited(FIRST + SECOND % said).formulas if one.role == CLAIM]
    assert [one.verdict in ("proved", "conditional") for one in claims] == [True, True, False]


def test_what_varies_by_words_of_the_same_system_varies_everywhere():
    later = r"\section{Remark} The stiffness $k$ varies with time."
    assert [one.green for one in verdicts(FIRST + later).values()] == [False]


BODY = r"""With $\mathbf M=(M_1,M_2,M_3)$ and $\mathbf P=(P_1,P_2,P_3)$ Kirchhoff's equations are
\[ \dot{\mathbf M}=\mathbf M\times\frac{\partial H}{\partial\mathbf M}+\mathbf P\times\frac{\partial H}{\partial\mathbf P},\qquad
\dot{\mathbf P}=\mathbf P\times\frac{\partial H}{\partial\mathbf M} .\]
%s \[ H=\frac12\left(a_1M_1^2+a_2M_2^2+a_3M_3^2\right)+\frac12\left(c_1P_1^2+c_2P_2^2+c_3P_3^2\right) .\] """


@pytest.mark.parametrize(
    ("words", "green"), [("If $a_1=a_2$ and $c_1=c_2$,", True), ("If $a_1=a_2$,", False)]
)
def test_the_only_function_that_is_considered_is_that_of_the_law(words, green):
    claim = rf"\begin{{theorem}} {words} then $M_3$ is an integral. \end{{theorem}}"
    assert [one.green for one in verdicts(BODY % "We consider" + claim).values()] == [green]


OSCILLATOR = (
    r"""The oscillator \[ \ddot q+\omega^2(t)q=0 \] has $E=\tfrac12(\dot q^2+\omega^2q^2)$. """
)
SWING = (
    r"""The swing moves by \[ \frac{d}{dt}\left(l^2(t)\dot\theta\right)+g\,l(t)\sin\theta=0. \] """
)
LARMOR = r"""In a variable field \[ \ddot x=\Omega(t)\dot y+\tfrac12\dot\Omega(t)y,\qquad
\ddot y=-\Omega(t)\dot x-\tfrac12\dot\Omega(t)x. \] """


@pytest.mark.parametrize(
    ("law", "true", "false"),
    [
        (OSCILLATOR, r"\dot E=\omega\dot\omega q^2", r"\dot E=2\omega\dot\omega q^2"),
        (OSCILLATOR, r"\dddot q=-\omega^2\dot q-2\omega\dot\omega q", r"\dddot q=-\omega^2\dot q"),
        (
            SWING,
            r"\ddot\theta+\frac{2\dot l}{l}\dot\theta+\frac{g}{l}\sin\theta=0",
            r"\ddot\theta+\frac{\dot l}{l}\dot\theta+\frac{g}{l}\sin\theta=0",
        ),
        (
            LARMOR,
            r"\frac{d}{dt}\left(x\dot y-y\dot x+\tfrac12\Omega(t)(x^2+y^2)\right)=0",
            r"\frac{d}{dt}\left(x\dot y-y\dot x+\Omega(t)(x^2+y^2)\right)=0",
        ),
    ],
)
def test_what_stands_at_the_time_in_equations_for_something_else_is_any_function(law, true, false):
    assert [one.green for one in verdicts(rf"{law} Then \[ {true}. \]").values()] == [True]
    assert not any(one.green for one in verdicts(rf"{law} Then \[ {false}. \]").values())


@pytest.mark.parametrize(
    "text",
    [
        r"The rocket moves by \[ m(t)\dot v=-u\dot m. \] Hence \[ \dot v=0. \]",
        r"Let \[ \dot x=y(t)z(t),\qquad \dot y+\dot z=0,\qquad \dot y-\dot z=x. \] Then $xy$ is constant.",
        r"Let \[ \ddot x=a(t),\qquad a(t)=kt. \] Then \[ \dddot x=a. \]",
        r"Let \[ \ddot x=a^2(x+t). \] Then \[ \dddot x=a^2. \]",
    ],
)
def test_what_moves_or_is_given_or_a_factor_is_none_at_the_time(text):
    assert not reading(text).paper.functions
    assert not any(one.green for one in verdicts(text).values())


@pytest.mark.parametrize("d", ["d", r"\mathrm{d}", r"\mathrm d "])
def test_derivatives_by_the_argument_have_any_d(d):
    law = rf"In a field, \[ \ddot x=-\frac{{{d}U}}{{{d}x}} \] with the potential $U(x)$. "
    general = r"Put $E=\tfrac12\dot x^2+U(x)$. Then \[ \dot E=0,\qquad \dot x^2=2E-2U(x). \] "
    found = verdicts(law + general + r"Let now $U(x)=gx$. Then \[ \ddot x=-g. \]")
    assert [one.green for one in found.values()] == [True] * 3
