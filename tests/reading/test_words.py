"""Sentences put together of wordings, of which it is known whether what they say is true.

A formula that needs a condition is said under it, without it, where it is over, or of some motions.
Nothing false is green, and nothing true is red; what is said of some motions only is neither.
"""

import random
from typing import NamedTuple

import pytest

from kowalevski_cas.verify.outcome import Verdict
from tests.reading.test_reading import verdicts
from tests.sample import sampled


class System(NamedTuple):
    """A law with what it defines, a condition, and formulas: true under it, always, and never."""

    text: str
    condition: str
    special: str
    always: str
    never: str


SYSTEMS = (
    System(
        r"The equation of motion is \[ \ddot x=-ax-b\dot x. \] Here $a$ and $b$ are constants. "
        r"Let $E=\frac12\dot x^2+\frac12ax^2$. ",
        "b=0", r"\dot E=0", r"\dot E=-b\dot x^2", r"\dot E=\dot x^2",
    ),
    System(
        r"The equations of motion are \[ \ddot x=-ax,\quad \ddot y=-by. \] "
        r"Let $L=x\dot y-y\dot x$. ",
        "a=b", r"\dot L=0", r"\dot L=(a-b)xy", r"\dot L=xy",
    ),
    System(
        r"The equations of motion are \[ A\dot p=(B-C)qr,\quad B\dot q=(C-A)rp,\quad "
        r"C\dot r=(A-B)pq. \] ",
        "A=B", r"\dot r=0", r"C\dot r=(A-B)pq", r"C\dot r=pq",
    ),
    System(
        r"The system is \[ \dot x=y,\quad \dot y=-cy-x^3. \] Let $H=\frac12y^2+\frac14x^4$. ",
        "c=0", r"\dot H=0", r"\dot H=-cy^2", r"\dot H=y^2",
    ),
)  # fmt: skip
LINKS = (
    "Then", "Hence", "We have", "It follows that", "Then we find", "One easily finds that", "Along the motion",
    "For all motions", "By differentiation we get", "In virtue of the equations of motion", "Therefore",
    "Тогда", "Имеем", "Dann ist", "Alors",
)  # fmt: skip
SUPPOSE = (
    "Let $@$.", "Suppose that $@$.", "Assume $@$.", "In what follows $@$.", "We consider the case $@$.",
    "From now on we put $@$.", "Let us restrict ourselves to the case $@$.", "Пусть $@$.", "Sei $@$.",
)  # fmt: skip
FILL = (
    "",
    "Then the motion is simple.",
    "This case is well known.",
    "The motion is then periodic.",
)
BESIDE = (
    "If $@$, then $#$.", "For $@$ we have $#$.", "In the case $@$ we find $#$.", "We have $#$ if $@$.",
    "When $@$, one has $#$.", "Under the condition $@$ we get $#$.", "При $@$ имеем $#$.",
    "If $@$, the motion is simple. Then $#$.", "Suppose that $@$. Under this assumption $#$.",
    "Suppose that $@$. In this case $#$.",
)  # fmt: skip
LEAVE = (
    "Otherwise", "In general", "In the opposite case", "If this is not the case,", "If not, then", "In the other case",
    "Now drop this assumption. Then", "We no longer assume this. Then", "The assumption is not needed:",
    "This restriction is inessential, and", "Return to the general case. We have", "Without this condition",
    "Suppose now that this is not so. Then", "In the remaining cases", "More generally,", "Else", "This holds always:",
    "In the presence of the other forces", "If the wind is strong,", "We now allow for more. Then",
    "В общем случае", "В противном случае", "Без этого предположения", "Andernfalls ist", "Sinon", "Dans le cas g\\'en\\'eral",
)  # fmt: skip
UNSAID = (
    "We have $#$.", "It follows that $#$.", "Then $#$.", "We do not assume that $@$. Then $#$.",
    "We exclude the case $@$. Then $#$.", "In [3] it was assumed that $@$. We have $#$.",
    r"The case $@$ is simple\footnote{Here $@$.}. We have $#$.", "If not $@$, then $#$.",
    r"\section{A case} Let $@$. It is simple. \section{The other} We have $#$.",
    "One could put $@$. We have $#$.", "The assumption $@$ is too strong. We have $#$.",
    r"\begin{proof} Let $@$. Then it is clear. \end{proof} We have $#$.",
)  # fmt: skip
OF_SOME = (
    "For some motions $#$.", "At the turning points $#$.", "At a certain moment $#$.", "Initially $#$.",
    "If the body is at rest, then $#$.", "In equilibrium $#$.", "There are motions for which $#$.", "On the equilibrium solution $#$.",
    "While the body rests, $#$.", "Suppose, on the contrary, that $#$.", "We ask whether $#$.", "Many authors write $#$.",
    "The case $#$ is excluded.", "We require $#$.", "We do not have $#$.", "Motions with $#$ are special.",
    "Approximately, $#$.", "One might think that $#$.", "В положении равновесия $#$.", "Im Gleichgewicht ist $#$.",
    "Neglecting small terms, $#$.", "À l'équilibre $#$.",
    "Assume otherwise. Then $#$.", "Suppose that the theorem is false. Then $#$.", "Допустим обратное. Тогда $#$.",
    "Roughly, $#$.", "Almost, $#$.", "To a good accuracy $#$.", "Keeping only the leading terms we get $#$.",
    "The equality $#$ means that it is simple.", "It would be convenient to have $#$.",
)  # fmt: skip


def texts(seed):
    """Texts without end: words of a kind, with a formula, and whether it is true; or neither."""
    chance = random.Random(seed)
    while True:
        system, one = chance.choice(SYSTEMS), chance.choice
        kind = one(("said", "beside", "left", "unsaid", "of some"))
        if kind == "said":
            words = f"{one(SUPPOSE)} {one(FILL)} {one(LINKS)} $#$."
        elif kind == "left":
            words = f"{one(SUPPOSE)} {one(FILL)} {one(LEAVE)} $#$."
        else:
            words = one({"beside": BESIDE, "unsaid": UNSAID, "of some": OF_SOME}[kind])
        tex, true = one(
            [(system.special, None)]
            if kind == "of some"
            else [
                (system.special, kind in ("said", "beside")),
                (system.always, True),
                (system.never, False),
            ]
        )
        yield system.text + words.replace("@", system.condition).replace("#", tex), tex, true


def many(count, seed=0):
    return [one for one, _ in zip(texts(seed), range(count), strict=False)]


@pytest.mark.parametrize("text, tex, true", sampled(many(300), 8))
def test_nothing_false_is_green_and_nothing_true_is_red(text, tex, true):
    verdict = verdicts(text).get(tex)
    assert true or verdict is None or not verdict.green
    assert true is False or verdict is not Verdict.REFUTED
