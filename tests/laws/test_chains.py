"""Chains and amplitudes in the prints of many authors: read as they are meant, or refused."""

import random

import pytest
from sympy import Integer, Poly, Symbol

from kowalevski_cas import System
from tests.laws.test_prints import FEW, differ
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected")


# -- chains, of which the ends are printed -----------------------------------------------------


def chain(chance):
    """The rows of a chain with neighbours, their number, and the rate of each link by a function."""
    a, b = chance.sample([-2, -1, 1, 3], 2)
    letter, index = chance.choice("uxq"), chance.choice("ikn")
    size = chance.choice([2, 3, 4])
    before, here, behind = (f"{letter}_{{{index}{k}}}" for k in ("-1", "", "+1"))
    tex = rf"\dot {here}={here}({a}{behind}{b:+}{before})"
    values = [f"{index}=1,\\ldots,{size}", f"{index}={','.join(map(str, range(1, size + 1)))}"]
    values = values if size > 2 else values[1:]
    tex = tex + chance.choice([",\\ {}", "\\quad({})"]).format(chance.choice(values))

    def rate(at, k):
        return at(k) * (a * at(k + 1) + b * at(k - 1))

    return tex, letter, index, size, rate


@FEW
def test_a_chain_has_the_ends_that_are_printed(seed):
    chance = random.Random(seed)
    tex, letter, index, size, rate = chain(chance)
    left, right = f"{letter}_0", f"{letter}_{size + 1}"
    with pytest.raises(ValueError, match=rf"{letter}_.* ends a chain.*print"):
        System(tex)

    def meant(at):
        return {f"{letter}_{k}": rate(at, k) for k in range(1, size + 1)}

    def link(k):
        return Symbol(f"{letter}_{k}")

    fixed = chance.choice([f"{left}=0,\\ {right}=0", f"{left}={right}=0"])
    opened = meant(lambda k: link(k) if 1 <= k <= size else 0)
    assert not differ(System(f"{tex},\\ {fixed}"), opened, seed)
    closed = meant(lambda k: link((k - 1) % size + 1))
    period = rf"{letter}_{{{index}+{size}}}={letter}_{index}"
    assert not differ(System(f"{tex},\\ {period}"), closed, seed)
    constant = meant(link) | {left: Integer(0), right: Integer(0)}
    still = rf"\dot {left}=0,\ \dot {right}=0"
    assert not differ(System(f"{tex},\\ {still}"), constant, seed)


@FEW
def test_a_sum_over_a_chain_has_each_link_once(seed):
    chance = random.Random(seed)
    tex, letter, index, size, _ = chain(chance)
    left, right = f"{letter}_0", f"{letter}_{size + 1}"
    ends = [
        rf"{letter}_{{{index}+{size}}}={letter}_{index}",
        rf"{left}={letter}_{size},\ {right}={letter}_1",
        rf"{left}={right}=0",
    ]
    closed = System(f"{tex},\\ {chance.choice(ends)}")
    power = chance.choice(["", "^2"])
    links = [f"{letter}_{k}{power}" for k in range(1, size + 1)]
    here = chance.choice([index, "j"])
    whole = chance.choice([rf"\sum {letter}_{here}{power}", rf"\sum_{here}{letter}_{here}{power}"])
    assert closed.identity(f"{whole}={'+'.join(links)}").verdict == "proved"
    assert closed.identity(f"{whole}={'+'.join(links[1:])}").verdict == "refuted"
    assert closed.identity(f"{whole}={'+'.join([*links, links[0]])}").verdict == "refuted"


# -- complex amplitudes -------------------------------------------------------------------------


class Amplitude:
    """A name with its conjugate, for SymPy and as they are printed."""

    def __init__(self, tex, bar):
        key = tex.replace("\\", "")
        letter, low, index = key.partition("_")
        self.symbols = Symbol(key), Symbol(f"{letter}^*{low}{index}")
        self.texts = f"{tex} ", bar.format(tex) + " "


def latex_of(polynomial, amplitudes):
    """A polynomial with whole coefficients in amplitudes and their conjugates."""
    tex = dict(pair for one in amplitudes for pair in zip(one.symbols, one.texts, strict=True))
    symbols = [*tex]
    terms = Poly(polynomial, symbols).terms()
    return "".join(
        f"{int(factor):+} " + "".join(tex[x] * n for x, n in zip(symbols, powers, strict=True))
        for powers, factor in terms
    ).lstrip("+")


def resonance(chance):
    """Equations of two amplitudes, the rates that they mean, integrals, and a function that moves.

    The norm is constant too if each term has as many amplitudes as conjugates.
    """
    names = chance.choice([["a", "b"], ["z_1", "z_2"], [r"\alpha", r"\beta"]])
    bar = chance.choice([r"\bar {}", r"\overline{{{}}}", "{}^*"])
    amplitudes = [Amplitude(name, bar) for name in names]
    (a, a_), (b, b_) = (one.symbols for one in amplitudes)
    free = chance.random() < 0.5
    terms = [a * b_, a**2 * b_**2, a * a_ * a * b_] if free else [a**2 * b_, a**3, a * b * b_]
    term = chance.choice(terms)
    swap = {a: a_, a_: a, b: b_, b_: b}
    H = chance.choice([1, -2, 3]) * (term + term.xreplace(swap)) + 2 * a * a_ + 3 * b * b_
    i, meant, rows = Symbol("i"), {}, []
    for name, one in zip(names, amplitudes, strict=True):
        own, conjugate = one.symbols
        meant |= {str(own): -i * H.diff(conjugate), str(conjugate): i * H.diff(own)}
        force = latex_of(H.diff(conjugate), amplitudes)
        rows.append(rf"i\dot {name}={force}")
    norm = "+".join(f"|{name}|^2" for name in names)
    true, false = [latex_of(H, amplitudes)], [latex_of(H + a * a_, amplitudes)]
    (true if free else false).append(norm)
    tex = ",\\ ".join(rows) + chance.choice(["", r",\ i^2=-1"])
    return tex, meant, true, [*false, norm.replace("+", "-")]


@pytest.mark.slow
@FEW
def test_amplitudes_move_by_their_hamiltonian(seed):
    tex, meant, true, false = resonance(random.Random(seed))
    law = System(tex)
    assert not differ(law, meant, seed), law
    assert all(law.integral(one).verdict == "proved" for one in true), law
    assert all(law.integral(one).verdict == "refuted" for one in false), law


def test_what_moves_by_an_equation_that_is_its_own_conjugate_is_real():
    law = System(r"\dot z=iz+rz,\ \dot r=-z\bar z")
    assert law.scene.conjugates == (("z", "z^*"),)
    assert law.integral(r"r^2+z\bar z").verdict == "proved"
    assert law.integral(r"r^2-z\bar z").verdict == "refuted"


def test_constants_under_bars_are_complex():
    law = System(r"i\dot a=\Delta a+\bar cb,\ i\dot b=ca-\Delta b")
    assert law.integral(r"|a|^2+|b|^2").verdict == "proved"
    real = System(r"i\dot a=\Delta a+\bar cb,\ i\dot b=\bar ca-\Delta b")
    assert real.integral(r"|a|^2+|b|^2").verdict == "refuted"


def test_an_amplitude_may_have_its_modulus_in_its_own_equation():
    law = System(r"i\dot\psi=|\psi|^2\psi")
    assert law.integral(r"|\psi|^2").verdict == law.integral(r"|\psi|").verdict == "proved"
    assert law.integral(r"\psi").verdict == law.integral(r"\psi^2").verdict == "refuted"


@pytest.mark.parametrize("size", sampled([3, 4, 5], 1))
def test_brackets_of_a_chain_are_closed_as_it_is(size):
    tex = (
        rf"\{{u_i,u_{{i+1}}\}}=u_iu_{{i+1}},\ u_{{i+{size}}}=u_i,\ i=1,\dots,{size},\ "
        rf"H=\sum_{{i=1}}^{size}u_i"
    )
    chain = System(tex)
    assert chain.integral(rf"\prod_{{i=1}}^{size}u_i").verdict == "proved"
    assert chain.integral("u_1u_2").verdict == "refuted"
    assert chain.identity(rf"\dot u_1=u_1(u_2-u_{size})").verdict == "proved"
    assert chain.identity(rf"\dot u_1=u_1(u_2+u_{size})").verdict == "refuted"
    assert chain.jacobi().verdict == "proved"
