"""Distances with two indices are no components of vectors, and may be named by words alone."""

import pytest

from tests.audit.test_doubted import audited
from tests.sample import sampled


def verdicts(text):
    """What is said of the formulas of a text that claim something: green, red or yellow."""
    colours = {"proved": "green", "conditional": "green", "refuted": "red"}
    return [colours.get(one.verdict, "yellow") for one in audited(text).formulas if one.claims]


NEWTON = r"""There are $n$ bodies with $n=2$, \begin{equation}
m_i\ddot{\mathbf r}_i=\sum_{j\ne i}\frac{Gm_im_j(\mathbf r_j-\mathbf r_i)}{r_{ij}^3}DISTANCE
\end{equation} Then \begin{equation} CLAIM \end{equation} is constant."""
MOMENTUM = r"\mathbf p=\sum_{i=1}^nm_i\dot{\mathbf r}_i"
MOMENT = r"\mathbf c=\sum_{i=1}^nm_i\mathbf r_i\times\dot{\mathbf r}_i"
DEFINED = [
    r",\qquad r_{ij}=|\mathbf r_i-\mathbf r_j|.",
    r",\qquad r_{ij}^2=(\mathbf r_j-\mathbf r_i)^2.",
    r",\end{equation} where $r_{ij}$ is the distance of the bodies $i$ and $j$, "
    r"\begin{equation} a=G.",
    r",\end{equation} where $r_{ij}=|\mathbf r_{ij}|$, $\mathbf r_{ij}=\mathbf r_i-\mathbf r_j$,"
    r"\begin{equation} a=G.",
]


@pytest.mark.parametrize(
    ("distance", "claim", "true"),
    sampled(
        [
            *((distance, MOMENTUM, True) for distance in DEFINED),
            (DEFINED[0], MOMENT, True),
            (DEFINED[0], MOMENTUM.replace("m_i", "m_i^2"), False),
            (DEFINED[2], MOMENTUM.replace("m_i", "m_i^2"), False),
        ],
        3,
    ),
)
def test_the_distance_of_two_bodies_is_no_component(distance, claim, true):
    found = verdicts(NEWTON.replace("DISTANCE", distance).replace("CLAIM", claim))
    assert found[-1] == "green" if true else found[-1] != "green"
    assert "red" not in found[:-1]


VORTICES = r"""The vortices move by \begin{equation}
\dot x_i=-\sum_{j\ne i}\frac{\Gamma_j(y_i-y_j)}{l_{ij}^2},\quad
\dot y_i=\sum_{j\ne i}\frac{\Gamma_j(x_i-x_j)}{l_{ij}^2},\quad i=1,2SAID
\end{equation} is a first integral."""


@pytest.mark.parametrize(
    ("said", "expected"),
    [
        (",\n\\end{equation} where $l_{ij}$ denotes the distance between two of them. Hence", True),
        (",\n\\end{equation} где $l_{ij}$ — расстояние между вихрями. Тогда", True),
        (".\n\\end{equation} Hence", None),  # nothing says what it is
    ],
)
def test_words_name_the_distance_of_two_points_by_their_coordinates(said, expected):
    for claim, true in (
        (r"Q=\Gamma_1x_1+\Gamma_2x_2", True),
        (r"Q=\Gamma_1x_1-\Gamma_2x_2", False),
    ):
        text = VORTICES.replace("SAID", f"{said} \\begin{{equation}} {claim}")
        assert verdicts(text)[-1:] == ([] if expected is None else ["green" if true else "red"])


def test_components_with_two_numbers_stay_components():
    text = r"""The points $\mathbf r_1=(r_{11},r_{12})$, $\mathbf r_2=(r_{21},r_{22})$ move by
    \begin{equation}\ddot{\mathbf r}_1=\mathbf r_2-\mathbf r_1,\qquad
    \ddot{\mathbf r}_2=\mathbf r_1-\mathbf r_2.\end{equation}
    The sum $\dot r_{11}+\dot r_{21}$ is constant. The sum $\dot r_{11}+\dot r_{22}$ is constant."""
    assert verdicts(text) == ["green", "red"]


def test_a_constant_is_not_the_one_with_its_indices_in_the_other_order():
    text = r"""The system \begin{equation}\dot x_1=a_{12}x_2,\qquad\dot x_2=-a_{21}x_1,\qquad
    a_{12}=b^2.\end{equation} The function $x_1^2+x_2^2$ is a first integral."""
    assert verdicts(text)[-1] != "green"
