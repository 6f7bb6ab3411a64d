"""Equations that words give by cyclic permutation, and neighbours of which nothing is said."""

import pytest

from tests.reading.test_reading import reading, verdicts

KIRCHHOFF = r"The equations \[ \dot M_1=(a_3-a_2)M_2M_3+(c_3-c_2)P_2P_3,\qquad\dot P_1=a_3P_2M_3-a_2P_3M_2 \] "
EULER = r"The equations are \[ A\dot p=(B-C)qr \] "
TEXTS = [
    (KIRCHHOFF, "(the others by cyclic permutation of the indices) have the integral ",
     "M_1P_1+M_2P_2+M_3P_3", "M_1P_1+M_2P_2-M_3P_3"),
    (KIRCHHOFF, "and their cyclic permutations have the integral ",
     "P_1^2+P_2^2+P_3^2", "P_1^2+P_2^2"),
    (EULER, "with its cyclic permutations, and have the integral ",
     "Ap^2+Bq^2+Cr^2", "Ap^2+Bq^2-Cr^2"),
    (EULER, "и две получаются циклической перестановкой букв. Интеграл энергии: ",
     "Ap^2+Bq^2+Cr^2", "Ap^2+Bq^2"),
]  # fmt: skip


@pytest.mark.parametrize("law, words, true, false", TEXTS)
def test_permuted_equations_move_the_other_letters(law, words, true, false):
    assert [*verdicts(rf"{law}{words}${true}$.").values()][-1].green
    assert not [*verdicts(rf"{law}{words}${false}$.").values()][-1].green


def test_rows_that_are_printed_are_not_permuted_once_more():
    text = r"The equations are \[ \dot x=y+z,\quad\dot y=-x+z,\quad\dot z=-x-y, \] not those by cyclic permutation."
    assert len([one for one in reading(text).formulas if one.role.name == "convention"]) == 0


def test_a_neighbour_in_a_lattice_is_no_constant():
    text = r"The lattice is \[ \dot c_k=c_k(c_{k+1}-c_{k-1}) . \] With $u_k=\ln c_k$ we have \[ \dot u_k={} . \]"
    for value in ("e^{u_{k+1}}-e^{u_{k-1}}", "c_{k+1}-c_{k-1}"):
        assert not {"proved", "refuted"} & {
            one.value for one in verdicts(text.replace("{}", value)).values()
        }


@pytest.mark.parametrize(
    "words",
    [
        "and two more",
        "and cyclic permutations with the opposite sign",
        "the others being found by Euler",
        "и аналогичные для остальных",
    ],
)
def test_a_law_of_which_not_all_is_printed_refutes_nothing(words):
    text = rf"{EULER} {words}. The function $Ap^2+Bq^2+Cr^2$ is an integral."
    assert "refuted" not in [one.value for one in verdicts(text).values()]
