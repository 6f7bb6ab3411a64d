"""What is said of any number of bodies is read for three, and the audit says so."""

import pytest

from kowalevski_cas.audit.assumed import assumptions_of
from kowalevski_cas.reading import read
from kowalevski_cas.reading.counted import counts
from kowalevski_cas.report.annotated import _with_reasons
from kowalevski_cas.source.files import decode
from kowalevski_cas.source.formulas import typed_formulas
from tests.audit.test_doubted import audited
from tests.sample import sampled


def source(text):
    return decode("paper.tex", (r"\begin{document}" + text + r"\end{document}").encode())


def numbers(text):
    expanded, typed = typed_formulas(source(text))
    return counts(typed, expanded.text)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (r"$\dot q_i=p_i$, $i=1,\dots,N$", {"N": 3}),
        (r"$H=\frac12\sum_{i=1}^np_i^2$", {"n": 3}),
        (r"$H=\sum_{1\le i<j\le n}(x_i-x_j)^2$", {"n": 3}),
        (r"the masses $m_1,\dots,m_N$", {"N": 3}),
        (r"indices mod $n$, $\dot a_k=a_{k+1}$", {"n": 4}),
        (r"$c_{k+n}=c_k$, $\dot c_k=c_{k+1}$, $n\ge5$", {"n": 5}),
        (r"$\sum_{i=1}^nx_i$ with $n=2$", {"n": 2}),
        (r"$\sum_{i=1}^nx_i$ for $n=4$, and for $n=2$, and for $n=4$", {"n": 4}),
        (r"$\sum_{i=1}^nx_i$, for one body ($n=1$) it is $x$", {"n": 3}),
        (r"$\sum_{i=1}^nx_i$ on $\mathbb R^{2n}$ and $TS^{n-1}$", {"n": 3}),
        (r"$\sum_{i=1}^nx_i$ and $n^nC\le H^n$", {"n": 3}),
        (r"$\sum_{k=1}^nx_k$, $y_k=\cos\frac{2\pi k}{n}$", {"n": 3}),
    ],
)
def test_a_letter_counts_with_which_a_range_a_sum_or_a_list_ends(text, expected):
    assert numbers(text) == expected


@pytest.mark.parametrize(
    "text",
    [
        r"$\sum_{i=1}^nx_i$ and $n^2a^3=\mu$",  # a mean motion may have the same letter
        r"$\ddot x_i=-n^2x_i$, $i=1,\dots,n$",  # a frequency may have it, too
        r"$\ddot x_i=-n^2x_i,\quad i=1,\dots,n$",
        r"$\sum_{i=1}^n\dot n_i$",
        r"$\sum_{i=1}^nx_i$ with $n=2m$",
        r"$\sum_{i=1}^nx_i$ for odd $n$",
        r"$\sum_{i=1}^nx_i$, where $n$ is even",
        r"сумма $\sum_{i=1}^nx_i$ при чётном $n$",
        r"$\sum_{i=1}^nx_i$ as $n\to\infty$",
        r"$\sum_{i=1}^nx_i$, $n\ge100$",
        r"$E_n=n+\frac12$, $n=0,1,2,\dots$",
        r"$\sum_{n=0}^\infty a_n$",
        r"$x_1=x_2$",
    ],
)
def test_a_letter_that_may_be_more_than_a_number_stays_a_letter(text):
    assert not numbers(text)


PARTICLES = r"""
The particles $q_1<q_2<\dots<q_N$ move on a line by the Hamiltonian
\[ H=\frac12\sum_{i=1}^Np_i^2+\sum_{i<j}\frac{a}{(q_i-q_j)^2}, \]
so that \[ \dot q_i=p_i,\qquad \dot p_i=2a\sum_{j\ne i}\frac{1}{(q_i-q_j)^3},\quad i=1,\dots,N. \]
"""
LATTICE = r"""
In the periodic lattice of Toda (indices mod $n$, $n\ge3$)
\[ \dot a_k=a_k(b_{k+1}-b_k),\qquad \dot b_k=2(a_k^2-a_{k-1}^2). \]
"""
VOLTERRA = r"""
The lattice with the periodic condition $c_{k+n}=c_k$, $n\ge3$, is
\[ \dot c_k=c_k(c_{k+1}-c_{k-1}). \]
"""


def decided(text):
    """Whether the last formula of a text that claims something is green, and what is said of it."""
    *_, last = (formula for formula in audited(text).formulas if formula.claims)
    return last.verdict in ("proved", "conditional"), last.message


@pytest.mark.parametrize(
    ("text", "true", "false"),
    sampled(
        [
            (
                PARTICLES + r"The momentum \[P=TERMp_N\] is an integral.",
                r"p_1+\dots+", r"p_1-p_2+",
            ),
            (
                PARTICLES + r"The centre $X=\frac1N\sum_iq_i$ has \[\ddot X=TERM.\]",
                "0", r"\frac1N",
            ),
            (
                PARTICLES + r"It follows that \[\frac{d^2}{dt^2}\sum_iq_i^2=TERMH.\]",
                "4", "N",
            ),
            (
                LATTICE + r"The function \[\sum_k\left(\tfrac12b_k^2+TERM\right)\] is an integral.",
                "a_k^2", r"a_ka_{k+1}",
            ),
            (
                LATTICE + r"The function \[\sum_k\left(\tfrac13b_k^3+a_k^2TERM\right)\]"
                " is an integral.",
                "(b_k+b_{k+1})", "(b_k+b_{k+2})",
            ),
            (
                VOLTERRA + r"The function \[\sum_k\left(\tfrac12c_k^2+TERM\right)\] is an integral.",
                "c_kc_{k+1}", "c_kc_{k+2}",
            ),
        ],
        2,
    ),
)  # fmt: skip
def test_claims_are_decided_for_a_number_and_each_says_for_which(text, true, false):
    green, message = decided(text.replace("TERM", true))
    assert green and message in ("for $N=3$", "for $n=4$")
    green, _ = decided(text.replace("TERM", false))
    assert not green


@pytest.mark.parametrize(
    ("words", "judged"),
    [
        (r"For $N=3$ it follows that \[\dot P=q_1.\]", True),
        (r"For $N=2$ it follows that \[\dot P=q_1.\]", False),
        (r"For two, \[\dot P=q_1\qquad(N=2).\]", False),
        (r"Let $N=2$. It is simple. It follows that \[\dot P=q_1.\]", False),
        ("Let $N=2$. It is simple.\n\nFor all \\[\\dot P=q_1.\\]", True),
    ],
)
def test_what_is_said_for_another_number_is_not_judged_for_this_one(words, judged):
    momentum = r"The momentum is \[P=p_1+\dots+p_N.\] Let $N=3$. It is one for $N=3$. "
    found = audited(PARTICLES + momentum + words)
    last = next(one for one in found.formulas if r"\dot P=q_1" in one.tex)
    assert bool(last.claims) == judged


def test_what_has_no_such_letter_says_nothing_of_it():
    text = (
        r"""\section{Others} The equations $\dot x=y$, $\dot y=-x$ have the integral \[x^2+y^2.\]"""
    )
    assert decided(r"\section{Particles}" + PARTICLES + text) == (True, "")


def test_the_number_stands_among_what_is_assumed_with_all_that_rests_on_it():
    found = audited(PARTICLES + r"The momentum \[P=p_1+\dots+p_N\] is an integral.")
    (one,) = (one for one in assumptions_of(found) if one.kind == "number")
    assert one.words == "$N=3$"
    assert {*one.claims} == {claim for formula in found.formulas for claim in formula.claims}


def test_each_verdict_of_the_page_and_the_text_that_was_read_say_the_number():
    found = audited(
        PARTICLES + r"The momentum \[P=p_1+\dots+p_N\] is an integral, and so is $p_1$."
    )
    assert [one.message for one in _with_reasons(found).outcomes] == ["for $N=3$"] * 2
    assert found.reading.derivation.edition == "paper.tex, for $N=3$"
    none = audited(r"The equations $\dot x=y$, $\dot y=-x$ have the integral \[x^2+y^2.\]")
    assert not none.reading.derivation.edition
    assert [one.message for one in _with_reasons(none).outcomes] == [""]


def test_the_elements_of_a_matrix_are_not_divided_by_zero_on_its_diagonal():
    lax = r"""Moser's matrix is
    \[ L_{jk}=p_j\delta_{jk}+\frac{i(1-\delta_{jk})}{q_j-q_k}, \] and \[ H=FACTOR\operatorname{tr}L^2. \]"""
    text = PARTICLES.replace("{a}", "1").replace("2a", "2") + lax
    assert decided(text.replace("FACTOR", r"\frac12"))[0]
    assert not decided(text.replace("FACTOR", r"\frac13"))[0]


def test_a_numerator_with_more_than_the_complement_of_delta_is_no_zero():
    found = read(source(r"Let $a_{jk}=\frac{c(1-\delta_{jk})x_j+1}{x_j-x_k}$, $j,k=1,2$."))
    first = found.paper.items[0].formula
    assert {"x_1"} <= first.names()


LINE = r"""$n$ particles have $\ddot x_i=\sum_{j\ne i}\frac{1}{(x_i-x_j)^3}$, $i=1,\dots,n$. """
SOLVED = r"\[\ddot x_1=\frac1{(x_1-x_2)^3},\quad\ddot x_2=\frac1{(x_2-x_1)^3}.\]"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (LINE + r"\section{Two} For $n=2$ they are easy.", 3),
        (r"\section{Two} For $n=2$ it is easy. \section{Any} " + LINE, 3),
        ("For $n=2$ it is easy. In general, " + LINE, 3),
        (r"\section{Two} Let $n=2$. " + SOLVED + r"\section{Any} " + LINE, 3),
        ("Let $n=2$. " + LINE, 2),
        (LINE + "Throughout, $n=2$.", 2),
        (LINE + "В этой работе $n=2$.", 2),
        (LINE + "Let $n=4$.", 4),
        (r"Masses $m_1,\dots,m_n$ are given. Let $n=2$. " + SOLVED, 2),
    ],
)
def test_a_small_number_of_a_special_case_is_not_that_of_the_paper(text, expected):
    assert numbers(text) == {"n": expected}


@pytest.mark.parametrize(
    ("text", "colours"),
    sampled(
        [
            (LINE + r"For $n=2$ they part. In general, $\dot x_1+\dot x_2$ is constant.", "r"),
            (LINE + r"For $n=2$ they part. In general, $\sum_{i=1}^n\dot x_i$ is constant.", "g"),
            (LINE + r"For $n=2$ the sum $\dot x_1+\dot x_2$ is constant.", ""),
            ("We restrict ourselves to $n=2$. " + LINE + r"$\dot x_1+\dot x_2$ is constant.", "g"),
            (
                rf"\section{{Any}} {LINE} Here $\sum_i\dot x_i$ is constant."
                r"\section{Two} Let $n=2$. Then $\dot x_1+\dot x_2$ is constant. It is simple."
                "\n\n" r"Moreover, $x_1-x_2-\frac t2(\dot x_1-\dot x_2)$ moves, $\ddot x_1=-\ddot x_2$."
                r"\section{Again} For every $n$ the function $\dot x_1+\dot x_2$ is constant.",
                "gr",
            ),
            (  # the law of two bodies is none of any number
                rf"\section{{Two}} Let $n=2$. {SOLVED} \section{{Any}} {LINE}"
                r"The sum $\dot x_1+\dot x_2$ is constant.",
                "",
            ),
        ],
        2,
    ),
)  # fmt: skip
def test_what_is_said_of_any_number_is_not_decided_in_a_special_case(text, colours):
    found = [one.verdict for one in audited(text).formulas if one.claims]
    seen = {"proved": "g", "conditional": "g", "refuted": "r"}
    assert "".join(seen.get(verdict, "y") for verdict in found) == colours


@pytest.mark.parametrize(
    ("term", "expected"),
    [
        ("u_i", True),
        (r"\left(\frac13u_i^3+u_iu_{i+1}(u_i+u_{i+1}+u_{i+2})\right)", True),
        ("u_iu_{i+2}", False),  # it is one of four and of five
        pytest.param("u_{i-1}u_{i+1}", False, marks=pytest.mark.slow),
    ],
)
def test_a_chain_is_so_long_that_different_terms_do_not_coincide(term, expected):
    chain = r"The chain $\dot u_i=u_i(u_{i+1}-u_{i-1})$, indices modulo $n$, has for every $n$ the "
    assert decided(rf"{chain} integral $J=\sum_{{i=1}}^n{term}$.")[0] is expected
