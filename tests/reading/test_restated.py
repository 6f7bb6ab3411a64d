"""Laws that are printed anew: what is no law of the same motion is none of them."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.reading import read
from kowalevski_cas.source.files import decode
from tests.sample import sampled

PENDULUM = r"""
\section{Motion} The equation of motion is
\begin{equation}\label{law} \ddot u=a\sin u\cos u-b\sin u. \end{equation}
"""


def reading(text):
    return read(decode("paper.tex", (r"\begin{document}" + text + r"\end{document}").encode()))


def verdicts(text, timeout=20):
    found = reading(text)
    outcomes = ReadingSession(found, timeout=timeout).outcomes
    return {
        f.item.printed.tex.strip(): outcomes[f.claim.id].verdict.name
        for f in found.formulas
        if f.claim is not None
    }


@pytest.mark.parametrize(
    "text",
    [
        r"The normal force has the part \[ K=2m\dot u\cos u. \]",
        r"With $\tau=ct$ it becomes \[ u''=\frac{\sin u}{c^2}(a\cos u-b). \]",
        r"Its square obeys \[ \dot u^2=2h+2b\cos u+a\sin^2u. \]",
    ],
)
def test_other_orders_and_other_times_print_no_law_anew(text):
    (known,) = reading(PENDULUM + text).parts.known
    assert known.restated == []


def test_a_law_for_special_constants_is_printed_anew():
    text = r"Let $a=2b$. Then \[ \ddot u=2b\sin u\cos u-b\sin u. \]"
    (known,) = reading(PENDULUM + text).parts.known
    assert [law.restates for law in known.restated] == known.laws


def test_one_equation_for_two_rates_prints_no_law_of_both_anew():
    text = r"\[ \dot x=cy,\quad \dot y=-cx. \] We note in passing \[ x\dot y-y\dot x=-cs. \]"
    (known,) = reading("The equations of motion are" + text).parts.known
    assert known.restated == []


def test_rates_by_the_first_time_are_those_of_the_first_law():
    text = r"""\section{Time} Put $\tau=ct$. If $a=b$, equation \eqref{law} becomes
    \[ u''=\frac{b}{c^2}\sin u(\cos u-1). \]
    \section{Energy} The energy is $E=\frac12\dot u^2-\frac12a\sin^2u-b\cos u$. We have \[ RATE \]"""
    true = r"\dot E=0"
    false = r"\dot E=\dot u"
    assert verdicts(PENDULUM + text.replace("RATE", true))[true] in ("PROVED", "CONDITIONAL")
    assert verdicts(PENDULUM + text.replace("RATE", false))[false] in ("REFUTED", "UNDECIDED")


DISPLACED = r"""
The equations of motion are \[ \dot x=y,\qquad \dot y=-x. \]
\section{Near the circle} Let $r^2=x^2+y^2$ and $g=r^2$.
"""


@pytest.mark.parametrize("sign", "+-")
def test_what_follows_from_what_is_cited_is_claimed(sign):
    text = (
        rf"\[ x^2+y^2=c \label{{c}} \] Put $g=s+v$, and from \eqref{{c}} \[ \ddot v{sign}kv=0. \]"
    )
    laws = reading(DISPLACED + text).parts.laws
    assert [law.variables for law in laws] == [("x", "y")]


def test_a_new_variable_has_a_law_where_nothing_is_cited():
    text = r"The angle $v$ turns by \[ \dot v=2g. \]"
    laws = reading(DISPLACED + text).parts.laws
    assert laws[-1].variables == ("x", "y", "v")


FREE = r"""The equations of motion are
\begin{equation}\label{free} \dot a=u,\quad \dot b=v,\quad \dot u=kv,\quad \dot v=-ku. \end{equation}
Put $T=\frac12(u^2+v^2)$.
\section{A field} """
FIELD = r"\[ \dot u=kv,\qquad \dot v=-ku+f. \]"


@pytest.mark.parametrize(
    "words",
    [
        r"Now the last two of the equations \eqref{free} are replaced by",
        r"In place of the last two equations \eqref{free} we have",
        r"Последние два из уравнений \eqref{free} заменяются на",
        r"In another problem the last two of these are replaced by",
    ],
)
def test_a_law_goes_on_with_the_equations_that_take_the_place_of_others(words):
    found = verdicts(FREE + words + FIELD + r"Then $\frac{d}{dt}(T-fb)=0$ and $\dot T=fv$.")
    assert {*found.values()} == {"PROVED"}
    found = verdicts(FREE + words + FIELD + r"Then $\frac{d}{dt}(T+fb)=0$ and $\dot T=fu$.")
    assert "PROVED" not in found.values()


@pytest.mark.parametrize(
    "words",
    [
        r"The equations \eqref{free} cannot be replaced by",
        r"If $k$ is replaced by $g$ in \eqref{free}, we find",
        r"If the last two of \eqref{free} were replaced by",
        r"The last two of these cannot be replaced by",
        r"The last two are replaced by",
    ],
)
def test_other_words_replace_no_law(words):
    laws = reading(FREE + words + FIELD).parts.laws
    assert not any(len(law.items) == 4 and law.begins is not None for law in laws)


NEAR = r"""The equation of motion is \[ \ddot q=-cq-eq^3. \] WORDS
The energy is $E=\frac12\dot q^2+\frac c2q^2+\frac e4q^4$, and \[ RATE \]"""


@pytest.mark.parametrize(
    "words", [r"Approximately, $q\approx q_0\cos t$.", r"We have $c\simeq1$ approximately."]
)
@pytest.mark.parametrize("rate, verdict", [(r"\dot E=0", "PROVED"), (r"\dot E=q", "REFUTED")])
def test_words_beside_an_approximation_speak_of_it(words, rate, verdict):
    assert verdicts(NEAR.replace("WORDS", words).replace("RATE", rate))[rate] == verdict


def test_what_cannot_be_read_is_no_approximation():
    text = NEAR.replace("WORDS", r"Let $i=1,2,3$, approximately.").replace("RATE", r"\dot E=0")
    assert r"\dot E=0" in verdicts(text)


def test_other_words_reach_further():
    text = NEAR.replace("WORDS", "We neglect terms of higher order.").replace("RATE", r"\dot E=q")
    assert "REFUTED" not in verdicts(text).values()


TOP = r"""\section{A body} The motion is \begin{equation}\label{free}
\dot p=aqr,\quad\dot q=brp,\quad\dot r=cpq. \end{equation}
It has the integrals $bp^2-aq^2=k$ and $cq^2-br^2=h$.
\section{A rotor} {SAID} \[ \dot p=aqr-sq,\quad \dot q=brp+sp. \] {CLAIM}"""
SAID = [
    r"The first two equations \eqref{free} have to be replaced by",
    r"Let us replace the first equations \eqref{free} with",
    r"Первые два уравнения \eqref{free} надо заменить на",
    r"Теперь вместо первых двух уравнений \eqref{free} имеем",
]
OF_ROTOR = [
    (r"Then $\frac{d}{dt}(p^2+q^2)=2(a+b)pqr$.", True),
    (r"Then $\frac{d}{dt}(p^2+q^2)=2(a+b)pqr+s$.", False),
    (r"The second integral becomes $cq^2-br^2=h$.", False),
    (r"The first integral takes the form $c(p^2+q^2)-(a+b)r^2=k$.", True),
    (r"The first integral takes the form $c(p^2+q^2)-(a-b)r^2=k$.", False),
]


@pytest.mark.parametrize(
    ("said", "claim", "green"), sampled([(said, *of) for said in SAID for of in OF_ROTOR], 5)
)
def test_rows_that_words_replace_make_another_law(said, claim, green):
    found = [*verdicts(TOP.replace("{SAID}", said).replace("{CLAIM}", claim)).values()]
    assert (found[2:] in (["PROVED"], ["CONDITIONAL"])) == green


@pytest.mark.parametrize(
    ("words", "rate", "green"),
    sampled(
        [
            (r"We return to the body without a rotor.", "aqr", True),
            (r"Let us now come back to the first problem.", "aqr", True),
            (r"Returning to equations \eqref{free} we have a simple motion.", "aqr", True),
            (r"Теперь вернемся к телу без ротора.", "aqr", True),
            (r"We return to the body without a rotor.", "aqr-sq", False),
            (r"The body returns to the same place.", "aqr", False),
            (r"We shall return to the body without a rotor in another paper.", "aqr", False),
            (r"Вернемся к телу без ротора.", "bqr", False),
        ],
        4,
    ),
)
def test_words_return_to_the_law_before(words, rate, green):
    last = rf"\section{{Motion}} {words} Put $n=2p$. Then $\dot n=2({rate})$."
    found = verdicts(TOP.replace("{SAID}", SAID[0]).replace("{CLAIM}", last))
    assert (found[rf"\dot n=2({rate})"] in ("PROVED", "CONDITIONAL")) == green
