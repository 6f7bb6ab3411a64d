"""Inequalities of papers: supposed where they are first said, and claimed of what is known."""

import random

import pytest

from tests.laws.test_prints import FEW
from tests.reading.test_reading import roles, verdicts
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected")

LAW = (
    r"The equations of motion are $$A\dot p=(B-C)qr,\quad B\dot q=(C-A)rp,\quad "
    r"C\dot r=(A-B)pq.$$ "
)


@pytest.mark.slow
@FEW
def test_what_is_claimed_of_constants_follows_from_what_is_supposed(seed):
    chance = random.Random(seed)
    a, b, c = chance.sample("ABC", 3)
    weak = chance.choice([True, False])
    less = r"\le" if weak else "<"
    one, two = rf"{a}{less} {b}", rf"{b}{less} {c}"
    supposed = chance.choice(
        [f"Let ${one[:-1]}{two}$. ", f"Let ${one}$ and ${two}$. ", f"Let ${one}$. Let ${two}$. ",
         f"The moments satisfy ${one[:-1]}{two}$. "]
    )  # fmt: skip
    true = chance.choice([rf"({c}-{a})({c}-{b})\ge0", rf"{a}+{b}\le 2{c}", rf"2{a}\le {b}+{c}"])
    if chance.random() < 0.5:
        false = rf"({c}-{a})({b}-{c})>0"
    else:
        false = rf"2{b}\le {a}+{c}"
    opens = chance.choice(["Then ", "Also, ", "Moreover, ", "Hence "])
    ends = chance.choice(["Besides, ", "Furthermore, ", "We have "])
    text = rf"{LAW}{supposed}{opens}$${true}.$$ {ends}$${false}.$$"
    found = verdicts(text)
    assert {true, false} <= {*found}, (text, roles(text))
    assert found[true].green and not found[false].green, (text, found)


@pytest.mark.parametrize(
    ("words", "green"),
    sampled([(r"If $\Delta\ge0$, then $$AB\ge0.$$", True), (r"If $\Delta\le0$, then $$AB\ge0.$$", False),
     (r"If $\Delta\ge0$, then $$A\ge0.$$", False), (r"Then $$AB\ge0.$$", False)], 1),
)  # fmt: skip
def test_a_condition_on_what_is_defined_is_one_of_what_defines_it(words, green):
    text = rf"{LAW}Put $\Delta=AB-C^2$. {words}"
    found = {tex: verdict.green for tex, verdict in verdicts(text).items() if r"\ge0" in tex}
    assert [*found.values()] == [green], (text, found)


def test_a_later_inequality_of_the_same_letters_takes_the_place_of_an_earlier_one():
    text = LAW + r"Let $A>0$. Then $$\sqrt{A^2}=A.$$ Now let $A<0$. Then $$\sqrt{A^2}=-A.$$"
    assert all(verdict.green for verdict in verdicts(text).values())


@FEW
def test_a_multiple_defines_what_is_new(seed):
    """In a display or among words, as twice the energy is printed."""
    chance = random.Random(seed)
    n, T = chance.choice([2, 3]), chance.choice(["T", "E", r"\mathcal T"])
    true = chance.random() < 0.5
    energy = "Ap^2+Bq^2+Cr^2" if true else "Ap^2+Bq^2+2Cr^2"
    gives = f"{n}{T}={energy}"
    given = chance.choice([f"Put ${gives}$. ", f"Let $${gives}.$$ ", f"Here $${gives}$$ is new. "])
    claim = chance.choice(
        [rf"Then $$\dot{{{T}}}=0.$$", rf"The function ${T}+A^2p^2+B^2q^2+C^2r^2$ is a first integral."]
    )  # fmt: skip
    found = verdicts(LAW + given + claim)
    (verdict,) = (v for tex, v in found.items() if tex != gives)
    assert verdict.green == true, (given, claim, found)
