r"""Under a central force the constant of areas says how the angle turns: the equation of the orbit."""

import pytest

from tests.reading.test_reading import verdicts

BODY = r"A body of mass $\mu$ moves under the central force $G(\varrho)$ with the angular momentum "
LAW = r"\[\ddot\varrho-\frac{k^2}{\mu^2\varrho^3}=\frac{G(\varrho)}\mu .\] "
RUSSIAN = r"Точка массы $\mu$ движется под действием центральной силы $G(\varrho)$ с моментом "
AREAS = r"$k=\mu\varrho^2\dot\chi$. "


def found(claimed, text=BODY + AREAS + LAW):
    """The verdict for a claim with the reciprocal of the distance."""
    said = verdicts(text + rf"With $w=1/\varrho$ we have \[{claimed} .\]")
    return [one.value for one in said.values()]


BINET = r"\frac{k^2}\mu w^2\left(\frac{d^2w}{d\chi^2}+w\right)=-G(1/w)"


@pytest.mark.parametrize("text", [BODY + AREAS + LAW, RUSSIAN + AREAS + LAW])
def test_the_equation_of_binet(text):
    assert found(BINET, text) == ["conditional"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("claimed", "true"),
    [
        (r"\frac{d^2w}{d\chi^2}+w=-\frac{\mu}{k^2w^2}G\left(\frac1w\right)", True),
        (r"\frac{d^2w}{d\chi^2}+w=-\frac{\mu}{k^2w^2}G(w^{-1})", True),
        (r"\dot\varrho=-\frac k\mu\frac{dw}{d\chi}", True),
        (r"\dot\varrho=-\frac k{\mu\varrho}\frac{dw}{d\chi}", False),
        (r"\frac{k^2}\mu w^2\left(\frac{d^2w}{d\chi^2}+w\right)=G(1/w)", False),
        (r"\frac{k^2}\mu w^2\left(\frac{d^2w}{d\chi^2}-w\right)=-G(1/w)", False),
        (r"\frac{k^2}\mu w\left(\frac{d^2w}{d\chi^2}+w\right)=-G(1/w)", False),
        (r"\frac{d^2w}{d\chi^2}+w=-\frac{\mu}{k^2}G(1/w)", False),
    ],
)
def test_the_equation_of_the_orbit(claimed, true):
    (verdict,) = found(claimed)
    assert (verdict in ("proved", "conditional")) is true


@pytest.mark.parametrize(
    "text",
    [
        BODY.replace("the central", "no central") + AREAS + LAW,
        BODY.replace("the central force", "the force") + AREAS + LAW,
        BODY.replace("A body", "If a body") + AREAS + LAW,
        BODY.replace("moves under the", "would move under a") + AREAS + LAW,
        BODY.replace("the central", "what is not a central") + AREAS + LAW,
        BODY + AREAS + LAW + "There is a tangential part too. ",
        BODY + AREAS + LAW + "The angular momentum slowly grows. ",
        BODY + AREAS + LAW + r"It decreases by friction. ",
        BODY + AREAS + LAW + r"There is a drag, $\dot k=-ak$. ",
        BODY + AREAS + LAW.replace("=", r"-\cos\chi="),
        BODY + AREAS + LAW.replace("k^2", "c^2"),
    ],
)
def test_without_it_nothing_says_how_the_angle_turns(text):
    assert not {"proved", "conditional", "refuted"} & {*found(BINET, text)}


@pytest.mark.parametrize(
    ("named", "argument"),
    [
        (r"$w=2/\varrho$", "1/w"),
        (r"$w=1/\varrho^2$", "1/w"),
        (r"$w=1/\varrho$", "2/w"),
        (r"$w=-1/\varrho$", "1/w"),
        (r"$w=1/\varrho$", "w"),
    ],
)
def test_a_function_at_another_argument_is_not_that_function(named, argument):
    text = BODY + AREAS + LAW + rf"With {named} we have "
    claimed = r"\[\frac{d^2w}{d\chi^2}+w=-\frac{\mu}{k^2w^2}G(1/w) .\]".replace("1/w", argument)
    assert not any(one.green for one in verdicts(text + claimed).values())
