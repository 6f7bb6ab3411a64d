"""Maps as papers print them: what they preserve is proved, and nothing false of them is green."""

import random

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.verify.outcome import Verdict
from tests.laws.test_prints import FEW
from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected")


def in_words(text):
    """The verdicts of what sentences claim, by the names of the claims without their numbers."""
    found = reading(text)
    outcomes = ReadingSession(found, timeout=20).outcomes
    return [
        (f.claim.id.partition("-in-words")[0], outcomes[f.claim.id].verdict)
        for f in found.statements
        if f.claim is not None
    ]


def steps(chance):
    """Two variables with their images, and words before the map."""
    x, y = chance.choice([("x", "y"), ("q", "p"), ("u", "v"), (r"\xi", r"\eta")])
    n = chance.choice(["n", "k", "m", ""])
    if not n:
        words = chance.choice(
            ["Consider the map ", "We study the mapping ", "Рассмотрим отображение "]
        )
        return x, y, f"{x}'", f"{y}'", words
    words = chance.choice(["Consider the map ", "The recurrence is ", "We iterate ", ""])
    return f"{x}_{n}", f"{y}_{n}", f"{x}_{{{n}+1}}", f"{y}_{{{n}+1}}", words


@pytest.mark.slow
@FEW
def test_a_form_is_an_invariant_of_a_matrix_with_determinant_one(seed):
    chance = random.Random(seed)
    x, y, x1, y1, words = steps(chance)
    k, m = chance.sample([-3, -2, 2, 3], 2)
    a, b, c, d = 1 + k * m, k, m, 1
    rows = [f"{x1}={a}{x}{b:+}{y}", f"{y1}={c}{x}+{y}"]
    chance.shuffle(rows)
    form = f"{c}{x}^2{d - a:+}{x}{y}{-b:+}{y}^2"
    false = f"{c}{x}^2{d - a + 1:+}{x}{y}{-b:+}{y}^2"
    joined = chance.choice([r",\quad ", r",\\"])
    rows = joined.join(rows)
    law = rf"{words}\begin{{equation}}\begin{{gathered}}{rows}.\end{{gathered}}\end{{equation}} "
    printed, say = chance.choice(
        [("%s", "The function $%s$ is an invariant of the map. "),
         ("%s", "The map preserves the function $%s$. "),
         ("%s", "The function $%s$ is a first integral. "),
         ("F=%s", "The function $$%s$$ is an invariant of this map. ")]
    )  # fmt: skip
    for tex, true in ((form, True), (false, False)):
        own = printed % tex
        found = verdicts(law + say % own)
        assert own in found, (law + say % own, found)
        assert found[own] == ("proved" if true else "refuted"), (law + say % own, found)
    same = f"{x1}{y1}=({a}{x}{b:+}{y})({c}{x}+{y})"
    found = verdicts(f"{law} We have $${same}.$$ Also, $${same}+{x}.$$")
    assert [v.green for v in found.values()] == [True, False], (law, found)


@FEW
def test_what_sentences_say_of_maps(seed):
    chance = random.Random(seed)
    x, y, x1, y1, words = steps(chance)
    f = chance.choice([f"{y}^2", f"a{y}^3", rf"\frac{{a{y}}}{{1-{y}^2}}"])
    s = chance.choice([r"\ref{map}", r"\eqref{map}"])
    wide = chance.choice(["", "2"])
    law = rf"{words}\begin{{equation}}\label{{map}} {x1}={y},\quad {y1}=-{wide}{x}+{f}.\end{{equation}} "
    says = chance.sample(
        [f"The map ({s}) is symplectic. ", "The map is area-preserving. ",
         "The map preserves areas. ", "The map preserves the symplectic form. ",
         rf"The map preserves the measure $d{x}\wedge d{y}$. ", "The map preserves the measure with the density $2$. "], 3
    )  # fmt: skip
    found = in_words(law + "".join(says))
    assert len(found) == 3, (law, says, found)
    assert all(verdict.green == (not wide) for _, verdict in found), (law, says, found)
    assert not in_words(law + "".join(one.replace("preserves", "does not preserve").replace("is ", "is not ") for one in says))  # fmt: skip


@pytest.mark.slow
def test_the_map_of_lyness_preserves_a_measure_and_no_area():
    law = r"Consider the map $$x_{n+1}x_{n-1}=x_n+a.$$ "
    invariant = r"\frac{(x_n+1)(x_{n-1}+1)(x_n+x_{n-1}+a)}{x_nx_{n-1}}"
    assert verdicts(law + rf"The function $${invariant}$$ is an invariant of the map. ")[
        invariant
    ].green
    measure = r"The map preserves the measure $$\frac{dx_n\wedge dx_{n-1}}{x_nx_{n-1}}.$$ "
    ((_, true),) = in_words(law + measure)
    ((_, false),) = in_words(law + measure.replace("{x_nx_{n-1}}", "{x_n}"))
    ((_, area),) = in_words(law + "The map is area-preserving. ")
    assert true.green and not false.green and not area.green


@pytest.mark.slow
def test_a_map_is_integrable_by_the_invariants_before_it():
    law = r"Consider the mapping $$x'=y,\quad y'=-x+\frac{2ay}{1-y^2}.$$ "
    invariant = r"The function $x^2y^2-x^2-y^2+2axy$ is an invariant of the map. "
    said = "The map is integrable. "
    assert [v.green for _, v in in_words(law + invariant + said)] == [True]
    false = in_words(law + invariant.replace("2axy", "axy") + said)
    assert [v.green for _, v in false] == [False]
    assert not in_words(law + said)


@pytest.mark.parametrize("b", ["-1", "2"])
@pytest.mark.parametrize(
    "words",
    sampled(["For $b=%s$ the map is area-preserving. ", "If $b=%s$, the map is area-preserving. ",
     "Put $b=%s$. The map is area-preserving. "], 1),
)  # fmt: skip
def test_what_is_supposed_of_constants_is_supposed_of_a_map(words, b):
    law = r"Consider the map $$x_{n+1}=1-ax_n^2+y_n,\quad y_{n+1}=bx_n.$$ "
    found = in_words(law + words % b)
    assert [v.green for _, v in found] == ([b == "-1"] if found else [])
    assert not any(
        v.green for _, v in in_words(law + "The map is area-preserving. " + words % b)[:1]
    )


def test_a_comment_says_that_primes_are_images():
    law = "We study\n$$x'=y,\\quad y'=y-x.$$\nThe function $x^2-xy+y^2$ is a first integral. "
    told = law.replace("$$x'", "%kc: map\n$$x'")
    assert verdicts(told)["x^2-xy+y^2"] == "proved"
    assert verdicts(law)["x^2-xy+y^2"] == "refuted"


@pytest.mark.parametrize(
    "law",
    sampled([r"$$x_{n+1}^2=y_n,\quad y_{n+1}=x_n$$", r"$$x_{n+1}=y_n$$",
     r"$$\dot x_n=x_{n+1}-x_{n-1}$$", r"$$x_{n+1}=\sum_{n=1}^{3}a_n$$"], 1),
)  # fmt: skip
def test_what_is_no_closed_map_makes_nothing_green_or_red(law):
    found = verdicts(
        rf"Consider the map {law} The function $x_n^2+y_n^2$ is an invariant of the map."
    )
    assert not any(v.green or v == "refuted" for v in found.values()), found


GAUSS = r"\section{A recurrence} The map is given by \[ w_{m+1}=\frac{1+w_m}{w_{m-1}} . \] "


def test_the_terms_of_a_sequence_are_those_of_the_map_steps_later():
    found = verdicts(GAUSS + r"Then $w_{m+5}=w_m$, and $w_{m+4}=w_m$.")
    assert found["w_{m+5}=w_m"].green and not found["w_{m+4}=w_m"].green


def test_a_period_that_needs_a_value_is_conditional():
    general = GAUSS.replace("1+", "b+") + r"If $b=1$, then $w_{m+5}=w_m$. "
    assert verdicts(general)["w_{m+5}=w_m"] is Verdict.CONDITIONAL
    assert not verdicts(general.replace("$b=1$", "$b=0$"))["w_{m+5}=w_m"].green


QUADRATIC = r"\section{A map} Consider the map \[ u'=v,\qquad v'=-bu+v^2 . \] "


@pytest.mark.parametrize(
    ("claim", "green"),
    [
        (r"\frac{\partial(u',v')}{\partial(u,v)}=b", True),
        (r"\frac{\partial(u',v')}{\partial(u,v)}=-b", False),
        (r"du'\wedge dv'=b\,du\wedge dv", True),
        (r"\frac{du'\,dv'}{b}=du\,dv", True),
        (r"du'\,dv'=2b\,du\,dv", False),
    ],
)
def test_a_jacobian_is_that_of_the_images(claim, green):
    found = verdicts(QUADRATIC + rf"Then \[ {claim} . \]")
    assert [one.green for one in found.values()] == [green]


def test_a_measure_without_orientation_is_never_refuted():
    found = verdicts(QUADRATIC + r"Then \[ du'\,dv'=-b\,du\,dv . \]")
    assert [*found.values()] == [Verdict.UNDECIDED]


def test_a_map_may_be_named_and_its_invariant_may_cite_it():
    text = r"""\section{A map} Consider the map \begin{equation} g:(u,v)\mapsto(u',v'),\qquad u'=v,\qquad v'=-u \label{g} \end{equation}
    The function \begin{equation} N(u,v)=u^2+v^2 \label{N} \end{equation} is an invariant of the map \eqref{g}: $N(u',v')=N(u,v)$."""
    found = verdicts(text)
    assert len(found) == 2 and all(one.green for one in found.values())
    false = verdicts(text.replace("v'=-u", "v'=-2u"))
    assert not any(one.green for one in false.values())
