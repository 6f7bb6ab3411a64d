"""What is called constant, and has its value by the equations of motion, is true."""

import pytest

from tests.reading.test_distances import verdicts

LAW = r"""The system \begin{equation}\dot x=y,\qquad\dot y=k-y,\qquad\dot z=-x,\qquad\dot u=z
\end{equation} is simple. """
CENTRE = r"""Two points move by \begin{equation}\dot x_1=-\frac{c(y_1-y_2)}{s},\quad
\dot y_1=\frac{c(x_1-x_2)}{s},\quad\dot x_2=\frac{c(y_1-y_2)}{s},\quad
\dot y_2=-\frac{c(x_1-x_2)}{s},\end{equation} where $s=(x_1-x_2)^2+(y_1-y_2)^2$. """


@pytest.mark.parametrize(
    ("text", "green"),
    [
        (LAW + r"The sum \[\dot y+\dot x=k\] is constant.", True),
        (LAW + r"The sum \[\dot y-\dot x=k\] is constant.", False),
        (LAW + r"Also constant is the sum \[x\dot u+z\dot z+\dot x+\dot y=k.\]", True),
        (LAW + r"Also constant is the sum \[x\dot u+z\dot z+\dot x+\dot y=2k.\]", False),
        (CENTRE + r"Constant is also \[\sum_{i=1}^2(x_i\dot y_i-y_i\dot x_i)=c.\]", True),
        (CENTRE + r"Constant is also \[\sum_{i=1}^2(x_i\dot y_i-y_i\dot x_i)=c^2.\]", False),
    ],
)
def test_a_value_by_the_law_is_the_value_of_a_constant(text, green):
    assert (verdicts(text)[-1] == "green") is green
