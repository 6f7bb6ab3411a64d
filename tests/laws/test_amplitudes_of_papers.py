"""Complex amplitudes as papers print them: their conjugates move too, and i is no constant."""

import random

import pytest

from tests.laws.test_chains import resonance
from tests.laws.test_prints import FEW
from tests.reading.test_reading import verdicts

pytestmark = pytest.mark.usefixtures("uncorrected")


def claimed(law, functions):
    """The verdicts of functions that are called first integrals."""
    text = rf"The equations of motion are $${law}.$$ "
    text += "".join(f"The function ${one}$ is a first integral. " for one in functions)
    found = verdicts(text)
    return [found[one.strip()] for one in functions]


@FEW
def test_amplitudes_of_a_paper_move_by_their_hamiltonian(seed):
    tex, _, true, false = resonance(random.Random(seed))
    found = claimed(tex, [*true, *false])
    assert all(verdict.green for verdict in found[: len(true)]), (tex, true, found)
    assert all(verdict == "refuted" for verdict in found[len(true) :]), (tex, false, found)


def test_what_is_real_beside_amplitudes_stays_real():
    law = r"\dot z=iz+rz,\quad \dot r=-z\bar z"
    true, false = claimed(law, [r"r^2+z\bar z", r"r^2-z\bar z"])
    assert true.green and false == "refuted"


def test_constants_under_bars_are_complex_in_papers():
    law = r"i\dot a=\Delta a+%sb,\quad i\dot b=ca-\Delta b"
    (true,) = claimed(law % r"\bar c", [r"|a|^2+|b|^2"])
    (false,) = claimed((law % r"\bar c").replace("=ca", r"=\bar ca"), [r"|a|^2+|b|^2"])
    assert true.green and false == "refuted"


def test_a_system_without_amplitudes_has_no_conjugates():
    """The letter i counts there, or is the unit of what is said beside."""
    law = r"\dot x_i=y_i,\quad\dot y_i=-x_i,\quad i=1,2"
    text = rf"The equations of motion are $${law}.$$ Put $z=x_1+iy_1$, where $i^2=-1$. "
    found = verdicts(text + r"Then $$\dot z=-iz.$$ Also, $$\dot z=iz.$$")
    assert found[r"\dot z=-iz"].green and not found[r"\dot z=iz"].green
