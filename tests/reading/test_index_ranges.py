"""Indices of which the range stands elsewhere, letters that are lists, and sums without limits."""

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.reading import CLAIM, LAW, index_ranges, read
from kowalevski_cas.source.files import decode
from tests.sample import sampled

CHAIN = r"""
Let $x=(x_1,x_2)$ and $y=(y_1,y_2)$. The equations of motion are
\begin{equation} \dot x_i=y_i,\qquad \dot y_i=-a_ix_i, \end{equation}
RANGE. Here $H=\frac12|y|^2+\frac12\sum a_ix_i^2$.
"""


def reading(text):
    return read(decode("paper.tex", (r"\begin{document}" + text + r"\end{document}").encode()))


def verdicts(text):
    found = reading(text)
    outcomes = ReadingSession(found, timeout=20).outcomes
    return [
        (f.item.printed.tex.strip(" .,\n"), outcomes[f.claim.id].verdict)
        for f in found.formulas
        if f.claim is not None
    ]


@pytest.mark.parametrize("words", [r"$i=1,2$", r"$i=1,\ldots,2$", "as usual"])
def test_an_index_runs_where_the_text_says_or_as_its_letters_are_numbered(words):
    found = reading(CHAIN.replace("RANGE", words))
    assert found.parts.laws[0].variables == ("x_1", "x_2", "y_1", "y_2")
    assert sum(f.role.name == LAW for f in found.formulas) == 4


def test_what_is_claimed_for_all_values_is_judged_for_each():
    text = CHAIN.replace("RANGE", "$i=1,2$")
    found = verdicts(text + r"Then $\dot H=0$ and $\frac{d}{dt}x_i^2=2x_iy_i$.")
    assert [tex for tex, _ in found] == [r"\dot H=0", *[r"\frac{d}{dt}x_i^2=2x_iy_i"] * 2]
    assert all(verdict.green for _, verdict in found)
    found = verdicts(text + r"Then $\frac{d}{dt}x_i^2=2x_iy_i+x_1-x_i$.")
    assert [verdict.green for _, verdict in found] == [True, False]


@pytest.mark.parametrize(
    "text",
    [
        r"where $i=1,\ldots,n$ with odd $n$, and $q_1,q_2$ are two. \[\dot q_i=p_i,\ \dot p_i=-q_i.\]",
        r"for $i=1,2$ with \[\dot q_i=p_i,\qquad \dot p_i=q_{i+1}-q_i.\]",
    ],
)
def test_what_nobody_says_is_not_written_out(text):
    found = reading("The equations " + text)
    assert not any("q_1" in law.variables for law in found.parts.laws)


@pytest.mark.parametrize(
    "words",
    [
        "The energy is",
        "Two integrals are seen at once,",
        r"The equations have the integrals \[G=x_1y_2-x_2y_1\] and",
    ],
)
def test_a_display_that_is_called_an_integral_is_claimed(words):
    text = CHAIN.replace("RANGE. Here", "$i=1,2$. Let").replace("a_i", "a")
    found = reading(text + words + r"\[ E=y_1^2+y_2^2+ax_1^2+ax_2^2 .\]")
    assert found.formulas[-1].role.name == CLAIM


def test_an_energy_of_which_a_rate_is_printed_is_a_definition():
    text = CHAIN.replace("RANGE. Here", "$i=1,2$. Let")
    found = reading(text + r"The energy is \[E=x_1y_1 .\] It obeys $\dot E=y_1^2-a_1x_1^2$.")
    assert [f.role.name for f in found.formulas][-2:] == ["definition", CLAIM]


@pytest.mark.parametrize("behind", [",", r",\\quad", "."])
def test_a_range_may_have_a_comma_behind_it(behind):
    text = r"\dot q_j=p_j,\qquad j=1,2,3" + behind
    assert index_ranges._said(text) == {"j": (1, 2, 3)}


@pytest.mark.parametrize("text", ["j=1,2,3,n", "j=1,2,4", r"j=1,2,3,\ldots,n"])
def test_a_list_that_goes_on_is_no_range(text):
    assert index_ranges._said(text) == {}


@pytest.mark.parametrize("sum_of_all", ["n_1n_2n_3", "n_1+n_2+n_3", "n_{1}-n_{2}-n_{3}"])
def test_an_index_without_braces_is_one_sign(sum_of_all):
    assert index_ranges._by_numbers([sum_of_all, "n_j=0"]) == {"j": (1, 2, 3)}
    assert index_ranges._by_numbers(["n_{1+k}+n_{12}", "n_j=0"]) == {}


HALPHEN = r"""
The equations of motion are \[\dot x_1=x_2x_3-x_1(x_2+x_3),\quad \dot x_2=x_3x_1-x_2(x_3+x_1),
\quad \dot x_3=x_1x_2-x_3(x_1+x_2).\] """


@pytest.mark.parametrize(
    "said",
    sampled(
        [
            r"Then \[\frac{d}{dt}(x_j+x_k)=FACTORx_jx_k\qquad(j\ne k).\]",
            r"Then \[\frac{d}{dt}(x_j+x_k)=FACTORx_jx_k\ (j<k).\]",
            r"Then \[\frac{d}{dt}(x_j+x_k)=FACTORx_jx_k\] for $j\neq k$.",
            r"For $j\neq k$ we have $\frac{d}{dt}(x_j+x_k)=FACTORx_jx_k$.",
        ],
        1,
    ),
)
def test_what_is_said_of_indices_alone_says_for_which_values(said):
    found = verdicts(HALPHEN + said.replace("FACTOR", "-2"))
    assert len(found) == (3 if "<" in said else 6)
    assert all(verdict.green for _, verdict in found)
    assert not any(v.green for _, v in verdicts(HALPHEN + said.replace("FACTOR", "-3")))


@pytest.mark.parametrize(
    "said",
    [
        r"Let us look at $j<k$. Then $x_j-x_k=x_1-x_2$.",
        r"It is $x_j-x_k=x_1-x_2$. For $j<k$ more is known.",
    ],
)
def test_a_condition_of_another_sentence_leaves_out_no_value(said):
    assert len(verdicts(HALPHEN + said)) == 9


@pytest.mark.parametrize(
    "form", [r"x_1^{-1}dx_1\,dx_2\,dx_3", r"d x_1\wedge dx_2\wedge dx_3", r"x_2\,dx_1"]
)
def test_a_differential_form_is_no_function(form):
    found = reading(HALPHEN + rf"The form ${form}$ is preserved, and $d$ is the differential.")
    (role,) = [f.role for f in found.formulas if f.item.typed.tex == form]
    assert "differential" in role.reason or "read" in role.name
    assert not any(v.value == "refuted" for _, v in verdicts(HALPHEN + rf"${form}$ is preserved."))


VORTICES = r"""
Let $(x_a,y_a)$, $a=1,2,3$, be the places. With $l_{ab}^2=(x_a-x_b)^2+(y_a-y_b)^2$ the motion is
\[ \dot x_a=-\sum_{b\ne a}k_b\frac{y_a-y_b}{l_{ab}^2},\qquad
\dot y_a=\sum_{b\ne a}k_b\frac{x_a-x_b}{l_{ab}^2}. \]
"""


def test_an_index_that_is_compared_with_another_one_has_its_values():
    found = verdicts(VORTICES + r"The quantity $\sum_ak_ax_a$ is an integral.")
    assert [verdict.green for _, verdict in found] == [True]
    found = verdicts(VORTICES + r"The quantity $\sum_ax_a$ is an integral.")
    assert [verdict.green for _, verdict in found] == [False]
    found = verdicts(VORTICES + r"The quantity $k_1x_1+k_2x_2$ is an integral.")
    assert [verdict.green for _, verdict in found] == [False]


def test_letters_beside_each_other_in_an_index_are_not_compared():
    found = reading(r"For $a=1,2$ the equations are \[ \dot x_a=v_{as}x_a. \]")
    assert found.parts.laws[0].mentions == {"x_1", "x_2", "v_{1s}", "v_{2s}"}
