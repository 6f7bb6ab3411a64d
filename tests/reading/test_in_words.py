"""What sentences claim of formulas that they cite or name: claims in words, with verdicts."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession, audit_reading
from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import reading
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("here")

LAW = r"""
The equations are $$\dot p=-qr,\quad \dot q=2rp,\quad \dot r=-pq.$$
The functions \begin{equation}\label{T} T=2p^2+q^2 \end{equation} and
\begin{equation}\label{G} G=p^2-r^2\end{equation} are first integrals.
"""


def said(text):
    """What the sentences claim, and what became of it."""
    found = reading(LAW + text)
    outcomes = ReadingSession(found, timeout=20).outcomes
    return [
        (one.role.kind, outcomes[one.claim.id].verdict) for one in found.statements if one.claim
    ]


PROVED, REFUTED = Verdict.PROVED, Verdict.REFUTED


@pytest.mark.parametrize(
    ("words", "verdict"),
    [
        (r"The integrals \eqref{T} and \eqref{G} are independent.", PROVED),
        (r"$T$ and $G$ are functionally independent.", PROVED),
        (r"The functions $T$, $G$, $F=2T-G^2$ are independent.", REFUTED),
        (r"The two integrals $T$, $G$ are independent at every point.", REFUTED),
        (r"$T$, $G$ are independent at each point other than the origin.", REFUTED),
        (r"Функции $T$ и $G$ являются независимыми.", PROVED),
    ],
)
def test_independence(words, verdict):
    assert said(words) == [("independence", verdict)]


@pytest.mark.parametrize(
    "words",
    [
        r"$T$ and $G$ are not independent.",
        r"Are $T$ and $G$ independent?",
        r"If $p=0$, then $T$ and $G$ are independent.",
        r"$T$ and $G$ are independent at every point of the octant.",
        r"$T$ and $G$ are independent everywhere except on the line of rest.",
        r"The integral $T$ is known; independent ones are sought.",
        r"$T$, $G$ and $F=\ldots$ are independent.",
        r"$T$, $G$ and $K$ are independent.",
        r"The three integrals $T$, $G$ are independent.",
        r"The square of $T$ and $G$ are independent.",
        r"The energy, $T$ and $G$ are independent.",
    ],
)
def test_what_is_denied_asked_or_conditioned_is_not_judged(words):
    assert said(words) == []


@pytest.mark.parametrize(
    ("relations", "verdict"), sampled([("p=0,\\quad q=0", PROVED), ("p=0", Verdict.UNDECIDED)], 1)
)
def test_cited_relations_define_an_invariant_set(relations, verdict):
    text = rf"Consider the relations \begin{{equation}}\label{{s}} {relations}. \end{{equation}} "
    assert said(text + r"Equations \eqref{s} define an invariant set.") == [("invariant", verdict)]


def test_a_number_of_states_of_rest_is_claimed():
    law = r"The equations are $$\dot p=p^2-1,\quad \dot q=-q.$$ "
    for number, green in (("two", True), ("three", False)):
        found = reading(law + rf"The system has exactly {number} equilibria.")
        (outcome,) = ReadingSession(found, timeout=20).outcomes.values()
        assert outcome.verdict.green is green


def test_a_claim_in_words_has_its_place_and_is_covered():
    words = r"$T$ and $G$ are independent."
    found = audit_reading(ReadingSession(reading(LAW + words), timeout=20))
    (region,) = found.sentences.values()
    assert region.line == 5
    assert not [one for one in found.uncovered if "independen" in one.words]


@pytest.mark.parametrize(
    "words",
    [
        r"\section{Integrals and invariant sets}",
        r"\title{Integrals\thanks{All points of the manifold are singular}}",
        r"Here we take a constant $a$.",
    ],
)
def test_headings_and_names_of_constants_claim_nothing(words):
    before = audit_reading(ReadingSession(reading(LAW), timeout=20)).uncovered
    found = audit_reading(ReadingSession(reading(LAW + words), timeout=20)).uncovered
    assert [one.words for one in found] == [one.words for one in before]


BRACKETS = r"""
The equations are $$\dot u=v,\quad \dot v=-u,\quad \dot x=y,\quad \dot y=-x$$
with the brackets $\{u,v\}=1$, $\{x,y\}=1$, $\{u,x\}=\{u,y\}=\{v,x\}=\{v,y\}=0$. Put $S=u^2+v^2$ and $W=x^2+y^2$.
"""


def test_what_moves_is_in_involution_or_is_not():
    found = reading(BRACKETS + r"The functions $S$ and $W$ are in involution.")
    assert [one.role.kind for one in found.statements if one.claim] == ["involution"]


def test_brackets_with_names_that_nothing_explains_are_not_claimed_to_vanish():
    text = r"In other letters $B=\rho^2+\pi_\varphi^2$. The functions $S$, $W$ and $B$ are in involution."
    found = reading(BRACKETS + text)
    assert not [one for one in found.statements if one.claim]


ON_A_SPHERE = r"The brackets are \[ \{p,q\}=r,\quad \{q,r\}=p,\quad \{r,p\}=q . \] "


@pytest.mark.parametrize(
    ("words", "verdicts"),
    [
        (r"The Casimir function is $C=p^2+q^2+r^2$.", [PROVED]),
        (r"The only Casimir function of this bracket is \[ C=p^2+q^2+r^2 . \]", [PROVED]),
        (r"The Casimir functions are $C=p^2+q^2+r^2$ and $D=C^2+C$.", [PROVED, PROVED]),
        (r"Функция Казимира есть $C=p^2+q^2+r^2$.", [PROVED]),
        (r"The Casimir function is $C=p^2+q^2-r^2$.", [Verdict.UNDECIDED]),
        (r"The Casimir functions are $C=p^2+q^2+r^2$ and $D=p$.", [PROVED, Verdict.UNDECIDED]),
        (r"There is no Casimir function $C=p$.", []),
        (r"Is the Casimir function $C=p$?", []),
        (r"If $r=0$, the Casimir function is $C=p$.", []),
    ],
)
def test_casimir_functions_behind_their_name(words, verdicts):
    assert [verdict for _, verdict in said(ON_A_SPHERE + words)] == verdicts


def test_what_a_bracket_is_does_not_define_what_moves():
    rows = r"The equations are \[ \dot p=-qr,\quad \dot q=2rp,\quad \dot r=-pq . \] "
    found = reading(ON_A_SPHERE + r"With $H=p^2-r^2$ we have the equations of motion. " + rows)
    assert [law.variables for law in found.parts.laws] == [("p", "q", "r")]


@pytest.mark.parametrize(
    "where",
    [
        "on the axis $y=z=0$", "at the point $x=1$, $y=z=0$", "for $x=0$", "wherever $x\\ne0$",
        "even at the equilibria", "if $x\\ne0$", "almost everywhere on $x=0$",
    ],
)  # fmt: skip
def test_independence_at_a_place_is_not_that_in_general(where):
    text = rf"""The motion is \[ \dot x=yz,\qquad\dot y=-2xz,\qquad\dot z=xy. \]
    The integrals $F=2x^2+y^2$, $G=x^2-z^2$ are independent {where}."""
    found = reading(text)
    outcomes = ReadingSession(found).outcomes
    told = [one for one in found.statements if one.claim and outcomes[one.claim.id].verdict.green]
    assert not told
    assert audit_reading(ReadingSession(found)).uncovered or found.statements
