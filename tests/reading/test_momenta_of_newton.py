"""A Hamiltonian beside the equations of Newton, and momenta of which the paper speaks."""

from itertools import product

import pytest

from tests.reading.test_restated import reading, verdicts
from tests.sample import sampled

GREEN = {"PROVED", "CONDITIONAL", "CONFIRMED"}
LETTERS = [("u", "v", "H"), ("x", "y", r"\mathcal{H}"), ("q_1", "q_2", "H")]


def in_letters(text, letters):
    momenta = [f"p_{q.partition('_')[2] or q}" for q in letters[:2]]
    prints = ("@u", "@v", "@H", "@p", "@s")
    for print_, own in zip(prints, (*letters, *momenta), strict=True):
        text = text.replace(print_, own)
    return text


ENERGY = (
    r"""Let \begin{equation}@H=\tfrac12(@p^2+@s^2)+\tfrac a2@u^2+\tfrac b2@v^2 .\end{equation} """
)
NEWTON = r"""In the form of Newton, therefore, \begin{equation}\ddot @u=-a@u,\qquad \ddot @v=-b@v.\end{equation} """

TRUE = [
    r"The moment $L=@u@s-@v@p$ has $\dot L=(a-b)@u@v$, and $\{@H,@H\}=0$.",
    r"The function $K=@s^2+b@v^2$ has \[ \{@H,K\}=0 . \]",
    r"If $a=b$, then $M=@p@s+a@u@v$ is an integral, and $\{@H,@H\}=0$.",
    r"The function $K=@s^2+b@v^2$ is an integral, as $\{@H,K\}=0$.",
]
FALSE = [
    r"The moment $L=@u@s-@v@p$ has $\dot L=(a+b)@u@v$.",
    r"The function $K=@s^2-b@v^2$ has \[ \{@H,K\}=0 . \]",
    r"If $a=b$, then $M=@p@s-a@u@v$ is an integral.",
    r"The function $K=@p@s+a@u@v$ is an integral.",
    r"The function $K=@s^2+b@v^2$ has $\{@H,K\}=@v$.",
    r"Here $\dot @p=a@u$.",
    r"The moment $L=@u@s-@v@p$ is an integral.",
    r"The momenta are $\dot @u=2@p$.",
]


@pytest.mark.parametrize(("letters", "claim"), sampled(product(LETTERS, TRUE), 4))
def test_what_holds_of_momenta(letters, claim):
    text = in_letters(ENERGY + NEWTON + r"One has $\{@H,@H\}=0$. " + claim, letters)
    assert {*verdicts(text).values()} <= GREEN


@pytest.mark.parametrize(("letters", "claim"), sampled(product(LETTERS, FALSE), 8))
def test_what_does_not(letters, claim):
    text = in_letters(ENERGY + NEWTON + r"One has $\{@H,@H\}=0$. " + claim, letters)
    printed = {
        one.item.printed.tex for one in reading(in_letters(ENERGY + NEWTON, letters)).formulas
    }
    found = {tex: one for tex, one in verdicts(text).items() if tex not in printed}
    own = {tex: one for tex, one in found.items() if r"\ddot" not in tex and ",@H" not in tex}
    own.pop(in_letters(r"\{@H,@H\}=0", letters), None)
    assert own and not GREEN & {*own.values()}


OTHERS = [
    r"\ddot @u=-a@u-\dot @v,\qquad \ddot @v=-b@v+\dot @u",
    r"\ddot @u=-a@u-c\dot @u,\qquad \ddot @v=-b@v-c\dot @v",
    r"\ddot @u=-a@u,\qquad \ddot @v=-2b@v",
    r"\ddot @u=-a@u,\qquad \ddot @v=b@v",
]


@pytest.mark.parametrize(("letters", "rows"), sampled(product(LETTERS, OTHERS), 3))
def test_other_equations_than_those_of_the_hamiltonian_are_not_replaced(letters, rows):
    """Where what is printed of Newton's form does not follow, no integral of its motions is green."""
    text = rf"In the form of Newton, therefore, \begin{{equation}}{rows}.\end{{equation}} "
    text += r"As $\{@H,@H\}=0$, the function $K=@s^2+b@v^2$ is an integral."
    found = verdicts(in_letters(ENERGY + text, letters))
    assert found.get(in_letters(r"K=@s^2+b@v^2", letters)) not in GREEN


@pytest.mark.parametrize(("sign", "green"), [("-", True), ("+", False)])
def test_the_hamiltonian_in_other_letters_is_what_it_was(sign, green):
    text = ENERGY.replace("@", "").replace("p^2", "p_u^2").replace("s^2", "p_v^2")
    text += rf"""\section{{New letters}} Put $u=\xi+\eta$, $v=\xi-\eta$,
    $p_u=\frac12(p_\xi+p_\eta)$, $p_v=\frac12(p_\xi-p_\eta)$. The Hamiltonian is
    \begin{{equation}}H=\tfrac14(p_\xi^2+p_\eta^2)+\tfrac a2(\xi+\eta)^2+\tfrac b2(\xi{sign}\eta)^2
    .\end{{equation}}"""
    assert bool(GREEN & {*verdicts(text).values()}) is green
