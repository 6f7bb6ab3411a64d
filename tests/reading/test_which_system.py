"""Where several systems are printed in the same letters, words say which is meant."""

import pytest

from tests.reading.test_reading import verdicts

SYSTEMS = r"""The first system is \[ \dot x=y,\qquad\dot y=-x. \]
The second system is \[ \dot x=y,\qquad\dot y=x. \] """


@pytest.mark.parametrize(
    ("words", "green"),
    [
        ("The function $FUNCTION$ is an integral of the first system.", "x^2+y^2"),
        ("The function $FUNCTION$ is an integral of the second system.", "x^2-y^2"),
        ("For the first system $FUNCTION$ is an integral.", "x^2+y^2"),
        ("For the second one $FUNCTION$ is an integral of the system.", "x^2-y^2"),
        ("In the latter $FUNCTION$ is conserved.", "x^2-y^2"),
        ("The function $FUNCTION$ is an integral of both systems.", ""),
        ("The function $FUNCTION$ is an integral of either of them.", ""),
        ("Each of the two systems has the integral $FUNCTION$.", ""),
    ],
)
def test_a_claim_is_of_the_system_that_its_words_name(words, green):
    for function in ("x^2+y^2", "x^2-y^2"):
        found = verdicts(SYSTEMS + words.replace("FUNCTION", function)).get(function)
        assert (found is not None and found.green) == (function == green)


def test_an_integral_has_a_number_too():
    found = verdicts(SYSTEMS + "The first integral $x^2-y^2$ of this system is constant.")
    assert found["x^2-y^2"].green


def test_systems_that_words_set_up_in_another_order():
    swapped = (
        SYSTEMS.replace("first", "THIRD").replace("second", "first").replace("THIRD", "second")
    )
    for function, true in (("x^2-y^2", True), ("x^2+y^2", False)):
        words = f"The function ${function}$ is an integral of the first system."
        found = verdicts(swapped + words).get(function)
        assert found is None or found.green == true
