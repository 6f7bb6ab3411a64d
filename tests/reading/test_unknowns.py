"""Equations for letters that nothing else gives, and what follows for these."""

import pytest

from tests.reading.test_reading import reading, verdicts
from tests.sample import sampled

PULLEY = r"""Two weights hang on a string over a pulley of radius $R$ and moment of inertia $J$.
Let $a$ be the acceleration of $m_1$. Newton's law gives
\[ m_1a=m_1g-T_1,\qquad m_2a=T_2-m_2g,\qquad J\frac aR=(T_1-T_2)R . \]
Eliminating the tensions, """
INCLINE = r"""A block of mass $m$ lies on an incline with the angle $\alpha$. The forces satisfy
\[ N-mg\cos\alpha=0,\qquad mg\sin\alpha-\mu N=mb . \] Therefore """
LADDER = r"""Für die Leiter gilt \[ S-\mu N=0,\qquad N+\mu S=P . \] Also """
ROOTS = r"""The motion is $\ddot x=-x$. The equation \[ \lambda^2+2h\lambda+1=0 \] has the roots """
INLINE = r"""Das folgt aus $\ddot x=-x$. From the equation $az^2+bz+c=0$ we get """
CASES = [
    (ROOTS, r"\lambda=-h\pm\sqrt{h^2-1}", r"\lambda=-h\pm\sqrt{h^2+1}"),
    (INLINE, r"z=\frac{-b+\sqrt{b^2-4ac}}{2a}", r"z=\frac{-b+\sqrt{b^2-2ac}}{2a}"),
    (PULLEY, r"a=\frac{(m_1-m_2)g}{m_1+m_2+J/R^2}", r"a=\frac{(m_1-m_2)g}{m_1+m_2-J/R^2}"),
    (PULLEY, r"T_1=m_1g\frac{2m_2+J/R^2}{m_1+m_2+J/R^2}", r"T_1=m_1g\frac{m_2+J/R^2}{m_1+m_2+J/R^2}"),
    (INCLINE, r"b=g(\sin\alpha-\mu\cos\alpha)", r"b=g(\sin\alpha+\mu\cos\alpha)"),
    (INCLINE, r"N=mg\cos\alpha", r"N=mg\sin\alpha"),
    (LADDER, r"N=\frac{P}{1+\mu^2}", r"N=\frac{P}{1-\mu^2}"),
    (LADDER, r"S=\frac{\mu P}{1+\mu^2}", r"S=\frac{P}{1+\mu^2}"),
]  # fmt: skip


@pytest.mark.parametrize("words, true, false", sampled(CASES, 2))
def test_what_follows_for_unknowns(words, true, false):
    right, wrong = ([*verdicts(rf"{words} \[ {one} .\]").values()] for one in (true, false))
    assert right and all(one.green for one in right)
    assert wrong and not any(one.green for one in wrong)


@pytest.mark.parametrize(
    "text",
    [
        r"The motion is $\ddot x=-k^2x$. Put \[ p=k^2,\qquad q=2k . \] Then \[ p=\frac{q^2}{4} . \]",
        r"The motion is $\ddot x=-k^2x$. We have \[ x\dot x+k=c,\qquad kc=2 . \] Then \[ c=\frac2k . \]",
        r"The motion is $\ddot x=-k^2x$ with \[ ab=k,\qquad a+b=2k . \] So the period is \[ T=\frac{2\pi}k . \]",
    ],
)
def test_definitions_what_moves_and_what_nothing_gives_later_are_no_unknowns(text):
    assert not [one for one in reading(text).formulas if "nothing gives before" in one.role.reason]


@pytest.mark.parametrize(
    "words",
    [
        r"The exponents satisfy \[ \lambda^2+k\lambda+1=0 . \]",
        r"For $\lambda$ we get the equation $\lambda^3-2k=0$.",
        r"The multipliers of the map are found from \[ \lambda^2-2k\lambda+1=0 . \]",
    ],
)
def test_an_equation_for_a_letter_is_no_statement_on_all_its_values(words):
    found = reading(r"The motion is $\ddot x=-k^2x$. " + words)
    (one,) = [f for f in found.formulas if "lambda^" in f.item.printed.tex]
    assert one.claim is None and "equation" in one.role.reason
