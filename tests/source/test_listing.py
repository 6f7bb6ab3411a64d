"""Of any article it is listed which formulas can be read, in the names that they use."""

import pytest

from kowalevski_cas.source.files import decode
from kowalevski_cas.source.listing import list_formulas


def troubles(text: str) -> list[str]:
    return [formula.trouble for formula in list_formulas(decode("paper.tex", text.encode()))[0]]


@pytest.mark.parametrize(
    "tex",
    [
        r"$m\ddot{\mathbf r} = -\frac{\partial U}{\partial\mathbf r}$",
        "$V(r,\\theta) = 0$, $x^2 + V(r,\\theta)$",
        "$f(P_1)\\cos Q + f(P_1)$",
        r"$\mathbf{P} = m\mathbf{v}, \quad \mathbf{R}\times\mathbf{P} = \mathbf{L}$",
        r"$\dot{\mathbf L} = [\mathbf{L}, \mathbf{M}]$",
        r"$r \leqslant r_0, \quad \lambda \in \mathbb{R}, \quad \mathscr{L} \to 0$",
        r"\begin{align} \dot x &= y \\ \dot y &= -\sin x \end{align}",
    ],
)
def test_what_is_read(tex):
    assert not any(troubles(tex))


def test_a_formula_in_macros_is_read_with_their_definitions():
    assert any(troubles(r"$\od{x}{t} = \R x$"))
    assert not any(troubles(r"\newcommand\od[2]{d#1/d#2}\def\R{\rho} $\od{x}{t} = \R x$"))


@pytest.mark.parametrize(
    ("tex", "trouble"),
    [
        (r"$\int_0^1 x\,dx$", "an integral cannot be read: write the derivative that it has"),
        ("$a(b+c)$, $a(b,c+1)$", "a product, or a at this argument?"),
        ("$ab^{(2)}$", "is this a power? then it needs no brackets"),
        ("$ $", "there is no formula here"),
    ],
)
def test_why_a_formula_is_not_read(tex, trouble):
    assert troubles(tex)[-1].startswith(trouble)
