"""Vectors of which words call letters the components, and momenta in which other letters move."""

import pytest

from tests.reading.test_reading import verdicts

VECTOR = r" Let $\mathbf K=(J_1u+g_1,J_2v+g_2,J_3w+g_3)$. Then \[ \dot{\mathbf K}=\mathbf K\times\boldsymbol\Omega. \] "
FIXED = r"The vector $\boldsymbol\gamma=(g_1,g_2,g_3)$ is constant. "
WORDS = [
    r"Let $u,v,w$ be the components of the angular velocity $\boldsymbol\Omega$ along the axes.",
    r"The angular velocity $\boldsymbol\Omega$ with components $u,v,w$ is used.",
    r"Пусть $u,v,w$ --- проекции угловой скорости $\boldsymbol\Omega$ на главные оси.",
    r"Здесь $u$, $v$ и $w$ --- компоненты вектора $\boldsymbol\Omega$.",
]


@pytest.mark.parametrize("words", WORDS)
@pytest.mark.parametrize(
    ("claim", "wrong"),
    [
        (r"J_1\dot u=(J_2-J_3)vw+g_2w-g_3v", r"J_1\dot u=(J_2-J_3)vw+g_3w-g_2v"),
        (r"h=J_1u^2+J_2v^2+J_3w^2", r"h=J_1u^2+J_2v^2-J_3w^2"),
    ],
)
def test_letters_are_components_where_words_say_so(words, claim, wrong):
    said = "The integral is" if claim[0] == "h" else "In components"
    for tex, green in ((claim, True), (wrong, False)):
        text = FIXED + words + VECTOR + rf"{said} \[ {tex}. \]"
        assert verdicts(text)[tex].green is green


def test_a_momentum_is_moved_by_the_letters_of_which_rates_are_printed():
    rows = r"""\[ J_1\dot u=(J_2-J_3)vw+g_2w-g_3v,\quad J_2\dot v=(J_3-J_1)wu+g_3u-g_1w,\quad
    J_3\dot w=(J_1-J_2)uv+THIRD. \] """
    claim = r"k=(J_1u+g_1)^2+(J_2v+g_2)^2+(J_3w+g_3)^2"
    for third, green in (("g_1v-g_2u", True), ("g_1u-g_2v", False)):
        text = FIXED + VECTOR + rows.replace("THIRD", third) + rf"The integral is \[ {claim}. \]"
        assert verdicts(text)[claim].green is green


@pytest.mark.parametrize(
    "words",
    [
        r"Let $u,v,w$ be the components of the derivative of $\boldsymbol\Omega$.",
        r"Let $u,v,w$ be the components of a vector orthogonal to $\boldsymbol\Omega$.",
        r"Here $u,v,w$ are not the components of $\boldsymbol\Omega$.",
        r"Пусть $u,v,w$ --- проекции производной вектора $\boldsymbol\Omega$.",
        r"The vector $\boldsymbol\Omega$ is given. The components of the momentum are $u,v,w$.",
    ],
)
def test_letters_are_components_of_no_other_vector(words):
    tex = r"h=J_1u^2+J_2v^2+J_3w^2"
    found = verdicts(FIXED + words + VECTOR + rf"The integral is \[ {tex}. \]")
    assert tex not in found or not found[tex].green
