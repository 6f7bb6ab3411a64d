r"""A bar makes a new name where an equation gives it and nothing is complex, or a conjugate."""

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts

TURNING = r"We consider the equations \[\dot x=y,\qquad\dot y=-x.\] "
GIVEN = (
    r"In the new variables \[\bar x=x+y,\qquad\bar y=x-y\] we have $@$.",
    r"Put $\bar x=x+y$ and $\bar y=x-y$. Then \[@.\]",
    r"The letter $\bar x$ is used for a sum: $\bar x=x+y$, $\bar y=x-y$. Hence $@$.",
)


@pytest.mark.parametrize("words", GIVEN)
@pytest.mark.parametrize("tex", [r"\dot{\bar x}=-\bar y", r"\dot{\bar x}=\bar y"])
def test_what_has_a_new_name_with_a_bar_is_not_judged(words, tex):
    found = verdicts(TURNING + words.replace("@", tex))
    assert not any(one.green or one is Verdict.REFUTED for one in found.values())


@pytest.mark.parametrize(
    ("tex", "green"), [(r"\dot{\tilde x}=-\tilde y", True), (r"\dot{\tilde x}=\tilde y", False)]
)
def test_with_a_tilde_it_is(tex, green):
    found = verdicts(TURNING + GIVEN[0].replace(r"\bar", r"\tilde").replace("@", tex))
    assert found[tex].green == green


def test_what_has_no_bar_is_judged_beside_it():
    found = verdicts(TURNING + GIVEN[0].replace("@", r"\dot x=y") + " $x^2+y^2$ is an integral.")
    assert found["x^2+y^2"].green


@pytest.mark.parametrize(("function", "green"), [(r"z\bar z", True), (r"z^2\bar z", False)])
def test_a_conjugate_is_one_still(function, green):
    text = rf"Let \[\dot z=iz.\] The function ${function}$ is an integral. For real $a$ let $\bar z=a$."
    assert verdicts(text)[function].green == green
