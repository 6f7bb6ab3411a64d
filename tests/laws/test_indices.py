"""Indices in the prints of many authors: their sets, what is summed over, and where no values stand."""

import random
import re

import pytest
from sympy import Symbol

from kowalevski_cas import System
from tests.laws.test_prints import FEW, differ
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected")


# -- sets of values --------------------------------------------------------------------------------


def volterra(seed):
    """A closed chain with neighbours, as it is printed but for the set of its index."""
    chance = random.Random(seed)
    a, b = chance.sample([-2, -1, 1, 3], 2)
    letter, index, size = chance.choice("uxa"), chance.choice("ikn"), chance.choice([2, 3, 4, 5])
    before, here, behind = (f"{letter}_{{{index}{k}}}" for k in ("-1", "", "+1"))
    tex = rf"\dot {{{letter}}}_{index}={here}({a}{behind}{b:+}{before})"

    def link(k):
        return Symbol(f"{letter}_{k % size or size}")

    meant = {str(link(k)): link(k) * (a * link(k + 1) + b * link(k - 1)) for k in range(size)}
    return chance, tex, letter, index, size, meant


@FEW
def test_indices_modulo_a_number_are_those_of_a_closed_chain(seed):
    chance, tex, letter, index, size, meant = volterra(seed)
    sets = [r"\mathbf Z/{0}\mathbf Z", r"\mathbb{{Z}}/{0}\mathbb{{Z}}", r"\mathbb Z_{0}"]
    form = chance.choice([r",\qquad {}\in ", r"\quad({}\in "]).format(index)
    close = ")" * form.startswith(r"\quad(")
    set_ = chance.choice(sets)
    system = System(f"{tex}{form}{set_.format(size)}{close}")
    assert not differ(system, meant, seed), tex
    product = "".join(f"{letter}_{k}" for k in range(1, size + 1))
    balanced = all(sum(pair) == 0 for pair in _factors(tex))
    assert (system.integral(product).verdict == "proved") == balanced
    longer = System(f"{tex}{form}{set_.format(size + 1)}{close}")
    assert {*longer.scene.variables} == {f"{letter}_{k}" for k in range(1, size + 2)}


def _factors(tex):
    """The factors of both neighbours."""
    inner = tex[tex.index("(") + 1 : -1]
    first, second = inner.split("{", 1)[0][:-2], inner[inner.index("}") + 1 :].split("{", 1)[0][:-2]
    yield int(first), int(second)


def test_a_set_without_a_number_is_refused_with_what_to_print():
    with pytest.raises(ValueError, match="print how many"):
        System(r"\dot x_i=x_{i+1}, i\in\mathbb Z/n\mathbb Z")
    with pytest.raises(ValueError, match="print i=1,2,3"):
        System(r"\dot x_i=x_{i+1}, i\in\mathbb Z")


@FEW
def test_a_listed_set_has_its_values(seed):
    chance = random.Random(seed)
    size, factor = chance.choice([2, 3, 4]), chance.choice([2, 3, -1])
    values = ",".join(map(str, range(1, size + 1)))
    system = System(rf"\dot x_i={factor}c_ix_i^2,\quad i\in\{{{values}\}}")
    c, x = ([Symbol(f"{letter}_{k}") for k in range(1, size + 1)] for letter in "cx")
    meant = {f"x_{k + 1}": factor * c[k] * x[k] ** 2 for k in range(size)}
    assert not differ(system, meant, seed)


# -- conditions below a sign -----------------------------------------------------------------------


@FEW
def test_rows_below_a_sum_are_its_conditions(seed):
    chance = random.Random(seed)
    size, power = chance.choice([2, 3, 4]), chance.choice([1, 2, 3])
    i, j = chance.choice(["ij", "kl", "ab"])
    differ_ = rf"{j}\ne {i}" if chance.random() < 0.5 else rf"{i}\neq {j}"
    below = chance.choice(
        [rf"\substack{{{j}=1\\{differ_}}}", rf"\substack{{{j}=1 \\ {differ_}}}", f"{j}=1,{differ_}"]
    )
    tex = rf"\dot x_{i}=\sum_{{{below}}}^{{{size}}}m_{j}(x_{j}-x_{i})^{power}"
    ranges = rf",\quad {i}=1,2" if size == 2 else rf",\quad {i}=1,\dots,{size}"
    x, m = ([Symbol(f"{letter}_{k}") for k in range(1, size + 1)] for letter in "xm")
    meant = {
        f"x_{p + 1}": sum(m[q] * (x[q] - x[p]) ** power for q in range(size) if q != p)
        for p in range(size)
    }
    assert not differ(System(tex + ranges), meant, seed), tex
    other = tex.replace(r"\neq", "<").replace(r"\ne ", "<")
    assert differ(System(other + ranges), meant, seed), other


# -- sums without values ---------------------------------------------------------------------------


def particles(size):
    """The equations of particles with forces between each two of them."""
    rows = ",".join(map(str, range(1, size + 1)))
    return System(rf"\ddot q_i=2g\sum_{{k\ne i}}\frac{{m_k}}{{(q_i-q_k)^3}},\quad i={rows}")


@pytest.mark.slow
@FEW
def test_a_sum_is_over_all_names_that_have_its_index(seed):
    chance = random.Random(seed)
    size, (j, k) = chance.choice([2, 3]), chance.choice(["jk", "ik", "ab", "ls"])
    first = chance.choice([rf"\sum_{j} ", rf"\sum_{{{j}}}", r"\sum "])
    pairs = chance.choice([rf"\sum_{{{j}<{k}}}", rf"\frac12\sum_{{{j}\ne {k}}}"])
    kinetic = rf"\frac12{first}m_{j}\dot q_{j}^2"
    energy = rf"{kinetic}+g{pairs}\frac{{m_{j}m_{k}}}{{(q_{j}-q_{k})^2}}"
    law = particles(size)
    assert law.integral(rf"{first}m_{j}\dot q_{j}").verdict.green
    assert law.integral(energy).verdict.green, energy
    assert law.integral(f"{energy}=h+1").verdict.green, energy
    assert law.integral(energy.replace("+g", "-g")).verdict == "refuted"
    assert law.integral(rf"{first}\dot q_{j}").verdict == "refuted"
    but = rf"\sum_{{{j}\ne 1}}"
    assert law.integral(rf"m_1\dot q_1+{but}m_{j}\dot q_{j}").verdict.green
    assert law.integral(rf"{but}m_{j}\dot q_{j}").verdict == "refuted"


def test_a_sum_over_names_of_which_there_are_not_as_many_is_not_guessed():
    law = System(r"\dot x_1=a_1x_2,\ \dot x_2=-a_2x_1+a_3x_2^2")
    claim = law.integral(r"\sum_i a_ix_i^2")
    assert claim.verdict == "error" and "print where the sum" in claim.outcome.message


@pytest.mark.slow
@FEW
def test_indices_that_stand_twice_are_summed_over_where_the_equations_are_printed_so(seed):
    chance = random.Random(seed)
    i = chance.choice("iklab")
    sign = chance.choice(["", "-"])
    law = System(
        rf"\dot M_i={sign}\varepsilon_{{ijk}}M_j\omega_k+{sign}\varepsilon_{{ijk}}\gamma_je_k,\ "
        rf"\dot\gamma_i={sign}\varepsilon_{{ijk}}\gamma_j\omega_k,\ "
        r"\omega_1=M_1,\ \omega_2=M_2,\ \omega_3=aM_3"
    )
    for true in (
        rf"M_{i}\gamma_{i}",
        rf"3\gamma_{i}\gamma_{i}=c+1",
        rf"2h=M_{i}\omega_{i}-2e_{i}\gamma_{i}",
    ):
        green = (
            law.integral(true).verdict.green
            or law.integral(true.replace("-2e", "+2e")).verdict.green
        )
        assert green, true
    assert law.integral(rf"M_{i}M_{i}").verdict == "refuted"
    assert law.integral(rf"M_{i}\gamma_1").verdict == "error"


def test_indices_that_stand_twice_are_names_where_no_permutation_is_printed():
    law = System(r"\dot x_1=x_2,\ \dot x_2=-x_1")
    assert law.integral("x_ix_i").verdict == "error"
    assert law.integral(r"\sum_ix_ix_i").verdict == "proved"


@pytest.mark.parametrize(
    ("chain", "verdict"),
    sampled([
        (r"\sum_{i=1}^2x_i^2=c+1", "proved"), (r"2T=\sum_ix_i^2=2h", "proved"),
        (r"2T=x_1^2+x_2^2=2h", "proved"), (r"T=\sum x_i^2=2h", "proved"),
        (r"\sum_{i=1}^2x_i^2=-1", "refuted"), (r"2T=x_1^2-x_2^2=2h", "refuted"),
        (r"\sum_{i=1}^2x_i^2=x_1", "refuted"),
    ], 1),
)  # fmt: skip
def test_a_sum_in_a_chain_is_no_value(chain, verdict):
    assert System(r"\dot x_1=x_2,\ \dot x_2=-x_1").integral(chain).verdict == verdict


# -- zero among vectors ----------------------------------------------------------------------------


@pytest.mark.parametrize("zero", sampled(["0", r"\mathbf 0", r"\boldsymbol{0}", r"\vec 0"], 1))
def test_a_zero_among_vectors_is_one(zero):
    inertia = r"\mathbf I=\operatorname{diag}(a,b,c),\ \mathbf k=(k_1,k_2,k_3)"
    sides = r"\mathbf I\dot{\boldsymbol\omega}+\boldsymbol\omega\times(\mathbf I\boldsymbol\omega+\mathbf k)"
    body = System(rf"{sides}={zero},\ {inertia}")
    assert body.integral(r"|\mathbf I\boldsymbol\omega+\mathbf k|^2").verdict.green
    assert body.integral(r"|\mathbf I\boldsymbol\omega-\mathbf k|^2").verdict == "refuted"
    assert body.integral(r"\boldsymbol\omega\cdot\mathbf I\boldsymbol\omega").verdict.green


# -- vectors with indices --------------------------------------------------------------------------


@pytest.mark.slow
@FEW
def test_vectors_have_indices_with_ranges(seed):
    chance = random.Random(seed)
    i, j = chance.choice(["ij", "kl", "ab"])
    names = chance.choice([f"(x_{i},y_{i})", f"(x_{i},y_{i},z_{i})"])
    power = chance.choice([1, 2])
    force = rf"m_{j}|\mathbf r_{j}-\mathbf r_{i}|^{2 * power}(\mathbf r_{j}-\mathbf r_{i})"
    rows = rf"\ddot{{\mathbf r}}_{i}=\sum_{{{j}\ne {i}}}{force},\quad {i}=1,2"
    law = System(rf"{rows},\quad\mathbf r_{i}={names}")
    assert len(law.scene.variables) == 2 * len(names.split(","))
    assert law.integral(rf"\sum_{i} m_{i}\dot{{\mathbf r}}_{i}").verdict.green
    assert law.integral(rf"\sum_{i}\dot{{\mathbf r}}_{i}").verdict == "refuted"
    kinetic = rf"\frac12\sum_{i} m_{i}|\dot{{\mathbf r}}_{i}|^2"
    potential = rf"\frac{{m_1m_2}}{{{2 * power + 2}}}|\mathbf r_1-\mathbf r_2|^{2 * power + 2}"
    potential = potential.replace("|^4", "|^{4}").replace("|^6", "|^{6}")
    assert law.integral(f"{kinetic}+{potential}").verdict.green
    assert law.integral(f"{kinetic}-{potential}").verdict == "refuted"


@pytest.mark.parametrize(
    ("print_", "low"),
    [
        (r"\dot x^1=x^2,\quad\dot x^2=-x^1", "x_1"),
        (r"\frac{dx^1}{dt}=y,\ \dot y=1", "x_1"),
        (r"\dot{\theta}^{1}=y,\ \dot y=1", r"\theta_1"),
        (r"\dot x^i=a^ix^i,\quad i=1,2", "x_i"),
        (r"\dot q^k=p_k,\quad\dot p_k=-q^k,\quad k=1,2,3", "q_k"),
        (r"H=\frac12\sum_{i=1}^2(p_i^2+(q^i)^2)", "q_i"),
        (r"\dot x_1=\sum_{k=1}^2a_kx^k,\ \dot x_2=1", "x_k"),
    ],
)
def test_an_index_that_is_raised_is_no_power(print_, low):
    with pytest.raises(ValueError, match=re.escape(low)):
        System(print_)


@pytest.mark.parametrize(
    "print_",
    [r"\dot x=\sum_{i=1}^3a_ix^i", r"\dot x=x^{10}+x^2", r"\dot x=\prod_{k=1}^1(x-a_k)",
     r"\dot x_i=x_i^2,\ i=1,2", r"\dot x=e^{1}x,\ \dot y=x"],
)  # fmt: skip
def test_a_power_is_none(print_):
    assert System(print_).scene.variables


@pytest.mark.parametrize(
    "range_",
    [r",\quad i=1,2,3\pmod 3", r",\quad i=1,2,3\pmod{3}", r"\quad(i=1,2,3\bmod3)",
     r",\quad i=1,\ldots,3\ (\bmod 3)", r",\quad i\in\mathbf Z/3\mathbf Z"],
)  # fmt: skip
def test_values_that_are_counted_modulo_their_number_close_a_chain(range_):
    law = System(rf"\dot x_i=x_{{i+1}}x_{{i+2}}{range_}")
    assert {*law.scene.variables} == {"x_1", "x_2", "x_3"} and not law.scene.constants
    assert law.integral("x_1^2-x_2^2").verdict == "proved"
    assert law.integral("x_1^2+x_2^2").verdict == "refuted"


@pytest.mark.parametrize(
    "print_",
    [r"\dot x=y\pmod 3,\ \dot y=1", r"\dot x_i=x_{i+1},\ i=1,2\pmod3", r"\dot x_i=x_{i+1}\pmod3"],
)
def test_what_is_counted_otherwise_is_refused(print_):
    with pytest.raises(ValueError, match="print the values before"):
        System(print_)
