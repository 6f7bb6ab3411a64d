r"""Conventions of authors: each print means what the plain one means, and a false one is refuted."""

import random

import pytest

from kowalevski_cas import System
from kowalevski_cas.problem.space import Meaningless
from tests.laws.test_prints import FEW, differ, field

pytestmark = pytest.mark.usefixtures("uncorrected")


def same(one, other, seed):
    """Whether two systems have one field."""
    return not differ(one, field(other), seed)


@FEW
def test_an_inequality_is_one_of_all_names_before_it(seed):
    chance = random.Random(seed)
    names = chance.sample([r"\mu", "k", r"\ell", "c_1", "C"], chance.randint(2, 3))
    sign = chance.choice([">0", r"\ge0", "<0", r"\ne0", ">1"])
    law = System(rf"\ddot x=-({'+'.join(names)})x")
    together = law.where(rf"{','.join(names)}{sign}")
    assert repr(together) == repr(law.where(*(name + sign for name in names)))
    each = law.where(f"{','.join(names)}=1")
    assert repr(each) == repr(law.where(*(f"{name}=1" for name in names)))


@FEW
def test_square_brackets_of_vectors_are_their_product(seed):
    chance = random.Random(seed)
    M, w = chance.choice([(r"\mathbf M", r"\boldsymbol\omega"), (r"\vec x", r"\vec a")])
    letter = M[-1]
    parts = [f"{letter}_{k}" for k in (1, 2, 3)]
    given = rf"{M}=({','.join(parts)}),\ {w}=({','.join(f'{a}{p}' for a, p in zip('abc', parts, strict=True))})"
    said = chance.choice(["", r",\ [\cdot,\cdot]\text{ the vector product}"])
    brackets = System(rf"\dot{{{M}}}=[{M},{w}],\ {given}{said}")
    assert same(brackets, System(rf"\dot{{{M}}}={M}\times{w},\ {given}"), seed)
    assert not same(brackets, System(rf"\dot{{{M}}}=[{w},{M}],\ {given}"), seed)
    assert brackets.integral(rf"({M},{M})").verdict.green
    assert brackets.integral(rf"{parts[0]}^2-{parts[1]}^2").verdict == "refuted"


@pytest.mark.parametrize(
    "tex",
    [
        r"\dot{\mathbf L}=[\mathbf L,\mathbf A]",
        r"\dot{\mathbf x}=[\mathbf x,\mathbf a],\ \mathbf x=(x,y),\ \mathbf a=(a,b)",
        r"\dot{\mathbf x}=\mathbf x\times\mathbf a,\ \mathbf x=(x,y),\ \mathbf a=(a,b)",
        r"\dot{\mathbf x}=\mathbf x\times\mathbf a,\ \mathbf x=(x,y,z,w),\ \mathbf a=(a,b,c,d)",
        r"\dot{\mathbf x}=[\mathbf x,\mathbf a],\ \mathbf x=(x,y,z),\ \mathbf a=(a,b,c),"
        r"\ [\cdot,\cdot]\text{ the commutator}",
    ],
)
def test_what_may_be_matrices_or_lies_in_no_space_has_no_vector_product(tex):
    with pytest.raises((ValueError, Meaningless), match=r"component|not expected"):
        System(tex)


@FEW
def test_tildes_and_hats_stand_over_images_as_primes_behind_them(seed):
    chance = random.Random(seed)
    over = chance.choice([r"\widetilde", r"\tilde", r"\hat", r"\overline"])
    x, y = chance.choice([("x", "y"), ("q_1", "q_2"), (r"\xi", r"\eta")])
    new_x, new_y = (
        f"{over}{{{name[:1]}}}{name[1:]}" if name[0] != "\\" else f"{over}{{{name}}}"
        for name in (x, y)
    )
    a, c = chance.randint(2, 5), chance.choice(["c", r"\varepsilon"])
    rows = rf"{{X}}-{x}={c}({{Y}}+{y}),\qquad {{Y}}={a}{x}-{y}"
    accents = System(rows.format(X=new_x, Y=new_y), map=True)
    primes = System(rows.format(X=f"{x}'", Y=f"{y}'"), map=True)
    assert repr(accents) == repr(primes)
    true, false = rf"{new_y}+{y}={a}{x}", rf"{new_y}-{y}={a}{x}"
    assert accents.identity(true).verdict.green
    assert accents.identity(false).verdict == "refuted"
    with pytest.raises(ValueError, match="no map"):
        System(r"\tilde x=\hat ay,\ \tilde y=x", map=True)


@FEW
def test_behind_a_comma_an_index_derives(seed):
    chance = random.Random(seed)
    x, t = chance.choice(["x", r"\alpha"]), chance.choice(["t", r"\tau", "s"])
    twice = chance.choice([f",{t},{t}", f",{t} {t}"])
    said = chance.choice(["", rf",\ {{}}_{{,{t}}}=\frac{{d}}{{d{t}}}"])
    law = System(rf"2{x}_{{{twice}}}=-k{x}{said}")
    assert same(law, System(rf"2\frac{{d^2{x}}}{{d{t}^2}}=-k{x}"), seed)
    assert law.integral(rf"2{x}_{{,{t}}}^2+k{x}^2").verdict.green
    assert law.integral(rf"2{x}_{{,{t}}}^2-k{x}^2").verdict == "refuted"


@FEW
def test_a_negative_power_of_a_function_is_one_over_the_power(seed):
    chance = random.Random(seed)
    function = chance.choice([r"\sin", r"\operatorname{sh}", r"\cosh", r"\tan", r"\tg"])
    power = chance.randint(2, 4)
    law = System(rf"H=\frac12p^2+g^2{function}^{{-{power}}}(q)")
    assert same(law, System(rf"H=\frac12p^2+\frac{{g^2}}{{{function}^{power}q}}"), seed)
    assert law.integral(rf"p^2+\frac{{2g^2}}{{{function}^{power}q}}").verdict.green
    assert law.integral(rf"p^2-2g^2{function}^{{-{power}}}(q)").verdict == "refuted"
    with pytest.raises(ValueError, match="negative power"):
        System(rf"H=\frac12p^2+{function}^{{-1}}(q)")


@pytest.mark.slow
@FEW
def test_a_potential_may_be_a_logarithm(seed):
    chance = random.Random(seed)
    inner = chance.choice(["q", "2q", "(q^2+1)", r"\frac{q^2+1}{q^2+4}", "(q+1)"])
    c = chance.choice(["c", "3", r"\Gamma^2"])
    law = System(rf"H=\frac12p^2+{c}\ln {inner}")
    assert law.integral("H").verdict.green
    assert law.integral(rf"\frac{{p^2}}2+{c}\ln {inner}").verdict.green
    assert law.integral(rf"\frac{{p^2}}2-{c}\ln {inner}").verdict == "refuted"


@FEW
def test_it_may_be_said_what_something_is_a_function_of(seed):
    chance = random.Random(seed)
    k, t = chance.choice([("k", "t"), (r"\omega", "t"), ("f", "t")])
    power = chance.choice(["", "^2"])
    said = System(rf"\ddot x=-{k}{power} x,\ \ddot y=-{k}{power} y,\ {k}={k}({t})")
    assert said.integral(r"x\dot y-y\dot x").verdict.green
    assert said.integral(rf"\dot x^2+{k}{power} x^2").verdict == "refuted"
    constant = System(rf"\ddot x=-{k}{power} x,\ x=x({t})")
    assert constant.integral(rf"\dot x^2+{k}{power} x^2").verdict.green
    with pytest.raises(ValueError, match="said to be a function"):
        System(r"\ddot x=-\lambda x,\ \lambda=\lambda(t)")


@pytest.mark.slow
@FEW
def test_a_blade_glides_where_it_points(seed):
    """Constraints with sines are read back as they are derived."""
    chance = random.Random(seed)
    angle, slope = chance.choice([r"\varphi", r"\theta"]), chance.choice([r"\alpha", r"\beta"])
    weight = chance.choice([rf"mg\sin{slope}", "F", rf"2m\cos{slope}"])
    said = chance.choice(["", r",\ \lambda=\lambda(t)"])
    blade = System(
        rf"m\ddot x=\lambda\sin{angle}+{weight},\ m\ddot y=-\lambda\cos{angle},\ I\ddot{angle}=0,"
        rf"\ \dot x\sin{angle}-\dot y\cos{angle}=0{said}"
    )
    assert blade.integral(rf"\frac m2(\dot x^2+\dot y^2)-x{weight}").verdict.green
    assert blade.integral(rf"\frac m2(\dot x^2+\dot y^2)+x{weight}").verdict == "refuted"


@FEW
def test_a_chain_of_amplitudes_is_closed_with_its_conjugates(seed):
    chance = random.Random(seed)
    size, q = chance.choice([3, 4]), chance.choice(["q", "a", r"\psi"])
    more = chance.choice(["", rf"+|{q}_n|^2{q}_n", rf"-2{q}_n"])
    law = System(
        rf"i\dot {q}_n={q}_{{n+1}}+{q}_{{n-1}}{more},\ n=1,\ldots,{size},\ {q}_{{n+{size}}}={q}_n"
    )
    assert len(law.scene.variables) == 2 * size
    assert law.integral(rf"\sum_{{n=1}}^{size}|{q}_n|^2").verdict.green
    assert law.integral(rf"\sum_{{n=1}}^{size}n|{q}_n|^2").verdict == "refuted"


def test_several_equations_of_a_set_may_stand_in_one_list():
    law = System(r"\ddot z=-z")
    assert law.invariant(r"z=0,\ \dot z=0").verdict == "proved"
    assert law.invariant(r"z=0,\ \dot z=1").verdict == "refuted"


def test_remarks_in_brackets_describe_unless_they_suppose():
    law = r"\ddot x=-kx,\ k=2\text{{ {} }}"
    assert not System(law.format("(isotropic case)")).scene.constants
    for supposing in ("(if x is small)", "(not always)", "(k positive)"):
        with pytest.raises(ValueError, match=r"text|words"):
            System(law.format(supposing))


def test_a_vector_may_be_said_to_be_constant_under_an_arrow():
    tex = r"\ddot{\vec r}=\vec F,\ \vec r=(x,y),\ \vec F=(F_1,F_2)="
    assert repr(System(tex + r"\overrightarrow{\mathrm{const}}")) == repr(
        System(tex + r"\mathrm{const}")
    )
