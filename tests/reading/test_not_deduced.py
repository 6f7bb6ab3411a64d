"""Rates of what the law moves, with no words that deduce them, may be of another case: never red."""

import pytest

from kowalevski_cas.audit.audited import SUSPECT
from kowalevski_cas.verify.outcome import FALSE_AS_READ, Verdict
from tests.audit.test_doubted import audited
from tests.reading.test_reading import verdicts
from tests.sample import sampled

FLOW = r"The equations of motion are \[ \dot u=kv+uw,\qquad \dot v=-nu,\qquad \dot w=-sw . \] "
SWING = r"The equation of motion is \[ \ddot\psi+2g\dot\psi+n^2\sin\psi=0 . \] "
LINE = r"The equation of motion is \[ m\ddot u=-nu . \] "
OTHERWISE = [
    FLOW + r"Averaging over the fast motion, \[ \dot u=kv . \]",
    FLOW + r"To leading order \[ \dot u=kv . \]",
    FLOW + r"Backwards in time \[ \dot v=nu . \]",
    FLOW + r"Reversing the arrow of time we obtain \[ \dot v=nu . \]",
    FLOW + r"A beginner might think that \[ \dot v=nu . \]",
    FLOW + r"Some books print \[ \dot v=nu . \]",
    FLOW + r"At equilibrium \[ \dot u=0 . \]",
    FLOW + r"In the steady state \[ \dot w=0 . \]",
    FLOW + r"For the twin system the roles of $k$ and $n$ are exchanged: \[ \dot u=nv . \]",
    SWING + r"In the overdamped regime \[ 2g\dot\psi=-n^2\sin\psi . \]",
    SWING + r"Measured from the upper position the angle obeys \[ \ddot\psi=-2g\dot\psi+n^2\sin\psi . \]",
    SWING + r"At a turning point \[ \dot\psi=0 . \]",
    SWING + r"We neglect the first derivative: \[ \ddot\psi=-n^2\sin\psi . \]",
    SWING + r"Для линейного осциллятора \[ \ddot\psi=-2g\dot\psi-n^2\psi . \]",
    LINE + r"In dimensionless time it reads \[ \ddot u=-u . \]",
    LINE + r"In suitable units we have \[ \ddot u=-u . \]",
    LINE + r"Measuring time in units of $\sqrt{m/n}$ we obtain \[ \ddot u=-u . \]",
    LINE + r"В безразмерных переменных получаем \[ \ddot u=-u . \]",
]  # fmt: skip
ENERGY = SWING + r"Put \[ E=\frac12\dot\psi^2-n^2\cos\psi . \] "
IDEAL = [
    ENERGY + r"Without friction $E$ is an integral.",
    ENERGY + r"For the undamped pendulum \[ \dot E=0 . \]",
    ENERGY + r"If friction is absent, \[ \frac{dE}{dt}=0 . \]",
    ENERGY + r"Between the kicks the energy is constant, $E=h$.",
    ENERGY + r"On the average \[ \dot E=-g\dot\psi^2 . \]",
    ENERGY + r"The linear oscillator has the integral \[ \frac12\dot\psi^2+\frac12n^2\psi^2=h . \]",
    ENERGY + r"In the absence of damping the separatrix is \[ \dot\psi^2=2n^2(1+\cos\psi) . \]",
    ENERGY + r"В консервативном случае имеем \[ \dot E=0 . \]",
]
DEDUCED = [
    SWING + r"Hence \[ \ddot\psi=-g\dot\psi-n^2\sin\psi . \]",
    FLOW + r"It follows that \[ \dot u=kv-uw . \]",
    ENERGY + r"Hence \[ \dot E=0 . \]",
    FLOW + r"Отсюда получаем \[ \dot v=nu . \]",
]


@pytest.mark.parametrize("text", sampled([*OTHERWISE, *IDEAL], 13))
def test_what_may_be_another_case_is_not_red(text):
    assert [*verdicts(text).values()][-1:] in ([], [Verdict.UNDECIDED])


@pytest.mark.parametrize("text", DEDUCED)
def test_what_is_deduced_is(text):
    assert [*verdicts(text).values()][-1] is Verdict.REFUTED


def test_another_thing_may_have_the_same_letter():
    text = r"The kinetic energy of the first rod is \[ T=\frac16ml^2\dot\psi^2 . \] "
    text += r"The second one has twice the mass, hence \[ T=\frac13ml^2\dot\psi^2 . \]"
    assert [*verdicts(text).values()] == [Verdict.UNDECIDED]


TURN = r"The equations of motion are \[ \dot x=y-z,\quad \dot y=z-x,\quad \dot z=x-y . \] "


@pytest.mark.parametrize(
    ("words", "verdict"),
    [("Then", None), ("Hence", Verdict.REFUTED), ("All is at rest:", None), ("At rest", None)],
)
def test_rates_that_vanish_side_by_side_are_no_set(words, verdict):
    found = verdicts(TURN + words + r"\[ \dot x=0,\quad \dot y=0,\quad \dot z=0 . \]")
    assert not any(one.green for one in found.values())
    assert verdict is None or verdict in found.values()


TENSION = r"""The pendulum obeys \[\ddot\theta=-\frac gl\sin\theta,\] and the tension of its rod is
\[T=mg\cos\theta+ml\dot\theta^2.\] """


@pytest.mark.parametrize(
    "words",
    sampled(
        [
            "At the lowest point",
            "In its lowest position it equals",
            "When the rod is vertical,",
            "Hence, at the bottom,",
            "It is largest at the lowest point, where",
            "В нижней точке",
            "При вертикальном положении получаем",
        ],
        2,
    ),
)
def test_a_name_that_is_given_once_more_may_be_its_value_somewhere(words):
    found = audited(TENSION + words + r" \[T=mg+ml\dot\theta^2.\]").formulas
    assert [f.verdict for f in found if f.claims] == [Verdict.UNDECIDED]
    assert not any(FALSE_AS_READ in f.message or f.verdict == SUSPECT for f in found)


def test_what_is_deduced_of_a_name_for_all_times_is_refuted():
    found = audited(TENSION + r"Hence \[\frac Tm=g\cos\theta-l\dot\theta^2.\]").formulas
    assert [f.verdict for f in found if f.claims] == [Verdict.REFUTED]


@pytest.mark.parametrize("words", ["At the end", "When the rod is vertical,", "В нижней точке"])
def test_what_gives_a_name_at_one_place_defines_it_nowhere(words):
    text = r"The kinetic energy is \[K=\frac12m(\dot x^2+\dot y^2).\] WORDS $x=b\sin\theta$, $y=-b\cos\theta$. Then \[K=\frac12mb^2\dot\theta^2.\]"
    assert not any(f.verdict == "proved" for f in audited(text.replace("WORDS", words)).formulas)
    assert audited(text.replace("WORDS", "With")).formulas[-1].verdict == "proved"


@pytest.mark.parametrize(
    ("end", "judged"),
    [("so that $x^2+y^2$ is constant, a contradiction.", False),
     ("a contradiction. The function $bx^2+ay^2$ is constant.", True)],
)  # fmt: skip
def test_what_follows_from_the_contrary_is_not_claimed(end, judged):
    text = r"Let \[\dot x=ay,\qquad\dot y=-bx.\] Assume the contrary, $a=b$. Then $x\dot x+y\dot y=0$, "
    found = audited(text + end).formulas
    assert [f.verdict for f in found if f.claims] == [Verdict.PROVED] * judged
    assert not any(f.verdict == SUSPECT for f in found)


@pytest.mark.parametrize(
    "words",
    [
        r"The turning points are given by $\dot x=0$.",
        r"The vertical isocline is $\dot x=0$.",
        r"The maximum of $x$ is attained when $\dot x=0$.",
        r"The velocity of the drift is found from $\ddot x=\ddot y=0$.",
    ],
)
def test_where_rates_vanish_is_no_claim_that_they_do(words):
    text = r"Let \[\ddot x=-n\dot y+a,\qquad\ddot y=n\dot x.\] "
    assert not [f for f in audited(text + words).formulas if f.claims]


@pytest.mark.parametrize(
    "words",
    [
        r"The set $p=0$ is invariant.",
        r"The eigenvalues at the point $p=0$, $q=0$, $r=1$ are $\pm1$.",
        r"The function $V=p^2$ satisfies $\dot V\le0$.",
    ],
)
def test_one_false_claim_of_a_set_or_a_point_suspects_no_law(words):
    text = r"Let \[A\dot p=(B-C)qr,\qquad B\dot q=(C-A)rp,\qquad C\dot r=(A-B)pq.\] "
    found = audited(text + words).formulas
    assert not any(f.verdict == SUSPECT for f in found)
    assert not {f.verdict for f in found if f.claims} & {Verdict.PROVED, Verdict.CONDITIONAL}
