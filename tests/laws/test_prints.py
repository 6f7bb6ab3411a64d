r"""One law of motion in the prints of many authors: each is read as it is meant, or refused.

What a print means is computed here by SymPy, from its parts; the package reads the print.
"""

import random
import re
from itertools import permutations

import pytest
from sympy import LeviCivita, Rational, Symbol, latex, sympify

from kowalevski_cas import System
from kowalevski_cas.algebra.present import formula_in
from kowalevski_cas.notation import Name, NotationError
from kowalevski_cas.notation.sympy import to_sympy
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.texts import Texts
from kowalevski_cas.paper.vocabulary import vocabulary
from kowalevski_cas.verify.outcome import Verdict
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected")

FEW = pytest.mark.parametrize("seed", [*range(2), *(pytest.param(k, marks=pytest.mark.slow) for k in range(2, 60))])  # fmt: skip


def field(system):
    """The rates of a system as it is read, by its variables."""
    space = Elaborations(Texts(vocabulary((system.scene,))))(system.scene)
    at = space.finder
    rates = {name: at.derivative(at.scalar(Name(name))) for name in space.variables}
    return {re.sub(r"[\\{}]", "", n): to_sympy(formula_in(r), {}) for n, r in rates.items()}


def differ(system, expected, seed):
    """The variables that move otherwise than is expected, at a random point."""
    found = field(system)
    assert {*found} == {*expected}
    values = {
        s: Rational(random.Random(f"{seed}{s}").randint(2, 99), 7)
        for one in (*found.values(), *map(sympify, expected.values()))
        for s in one.free_symbols
    }
    return {name for name in found if (found[name] - expected[name]).subs(values).simplify() != 0}


def vector(letter):
    return [Symbol(f"{letter}_{k}") for k in (1, 2, 3)]


# -- the sign of a permutation -------------------------------------------------------------------


def permuted(seed):
    """A print with the sign of a permutation, what it means, and the print with another sign."""
    chance = random.Random(seed)
    letters = chance.choice(["ijk", "abc", "lmn", "pqr", "jki"])
    i, j, k = letters
    sign = chance.choice([r"\varepsilon", r"\epsilon"])
    order = chance.choice([*permutations(letters)])
    second, third = chance.choice(["MM", "Mg", "gM", "gh", "hM"])
    factor = chance.choice(["", "2", "-", r"\frac{1}{2}", "c"])
    behind = chance.choice(["", f"+g_{i}", f"-cM_{i}"])
    ranges = chance.choice(
        ["", f",\\ {i}=1,2,3", f",\\ {i},{j},{k}=1,2,3", f"\\quad({i}=1,\\dots,3)"]
    )
    sums = chance.choice(["", "", rf"\sum_{{{j},{k}=1}}^3", rf"\sum_{{{j}=1}}^3\sum_{{{k}=1}}^3"])

    def tex(order):
        tensor = f"{sign}_{{{''.join(order)}}}{second}_{j}{third}_{k}"
        return rf"\dot M_{i}={factor}{sums}{tensor}{behind}{ranges}"

    place = {letter: order.index(letter) for letter in letters}
    named = {one: vector(one) for one in "Mgh"}
    scale = {"": 1, "2": 2, "-": -1, r"\frac{1}{2}": Symbol("c") * 0 + 1, "c": Symbol("c")}[factor]
    meant = {}
    for a in range(3):
        value = 0
        for b in range(3):
            for c in range(3):
                index = [0, 0, 0]
                index[place[i]], index[place[j]], index[place[k]] = a, b, c
                value += LeviCivita(*index) * named[second][b] * named[third][c]
        value = value / 2 if "frac" in factor else value * scale
        value += {"": 0, "+": named["g"][a], "-": -Symbol("c") * named["M"][a]}[behind[:1]]
        meant[f"M_{a + 1}"] = value
    odd = (order[1], order[0], order[2])
    return tex(order), tex(odd), meant, second == third


@FEW
def test_indices_of_the_sign_of_a_permutation_are_summed_over(seed):
    tex, other, meant, symmetric = permuted(seed)
    assert not differ(System(tex), meant, seed), tex
    assert symmetric or differ(System(other), meant, seed), other


# -- what a Hamiltonian and a Lagrangian imply -----------------------------------------------------

NAMES = [
    [("q", "p")], [("x", "p")], [(r"\theta", "p")], [("q_1", "p_1"), ("q_2", "p_2")],
    [("x", "p_x"), ("y", "p_y")], [("r", "p_r"), (r"\varphi", r"p_\varphi")], [("Q", "P")],
    [("x_1", "p_1"), ("x_2", "p_2")],
]  # fmt: skip


def plain(name):
    return Symbol(name.replace("\\", ""))


def energy(chance, pairs, momenta):
    """A polynomial as it is printed, and for SymPy; other signs in the first give another print."""
    names = [name for pair in pairs for name in pair]
    printed, value, other = "", 0, ""
    squares = [([p, p], chance.choice([1, 2])) for p in momenta]
    terms = squares + [
        ([*chance.sample(names, 2), chance.choice(names)], chance.choice([-3, -1, 2]))
        for _ in range(3)
    ]
    for factors, number in terms:
        printed += f"{number:+}{' '.join(factors)}"
        other += f"{-number if factors == terms[-1][0] else number:+}{' '.join(factors)}"
        term = number
        for one in factors:
            term *= plain(one)
        value += term
    return printed.lstrip("+"), value, other.lstrip("+")


@FEW
def test_a_hamiltonian_implies_the_canonical_equations(seed):
    chance = random.Random(seed)
    pairs = chance.choice(NAMES)
    printed, value, other = energy(chance, pairs, [p for _, p in pairs])
    name = chance.choice(["H", r"\mathcal H", r"\mathcal{H}"])
    brackets = ",\\ ".join(rf"\{{{q},{p}\}}=1" for q, p in pairs)
    rates = ",\\ ".join(rf"\dot {x}=\{{{x},{name}\}}" for pair in pairs for x in pair)
    gradient = ",\\ ".join(
        rf"\dot {q}=\frac{{\partial {name}}}{{\partial {p}}},\ \dot {p}=-\frac{{\partial {name}}}{{\partial {q}}}"
        for q, p in pairs
    )
    beside = chance.choice(["", brackets, rates, f"{brackets},\\ {rates}", gradient])
    meant = {}
    for q, p in pairs:
        meant |= {str(plain(q)): value.diff(plain(p)), str(plain(p)): -value.diff(plain(q))}

    def system(H):
        parts = [f"{name}={H}", *([beside] if beside else [])]
        return System(",\\ ".join(chance.sample(parts, len(parts))))

    law = system(printed)
    assert not differ(law, meant, seed), law
    assert law.integral(name).verdict == "proved"
    q, p = pairs[0]
    assert law.identity(rf"\{{{q},{p}\}}=1").verdict == "proved"
    assert law.identity(rf"\{{{p},{q}\}}=1").verdict == "refuted"
    assert differ(system(other), meant, seed), other


@FEW
def test_a_lagrangian_implies_the_equations_of_lagrange(seed):
    chance = random.Random(seed)
    names = chance.choice([["q"], ["x", "y"], ["r", r"\varphi"], ["q_1", "q_2"]])
    printed, value, other = energy(chance, [(name,) * 2 for name in names], [])
    kinetic = "".join(rf"+\frac12\dot {name}^2" for name in names).lstrip("+")
    name = chance.choice(["L", r"\mathcal L"])
    form = chance.choice(
        [
            "{name}={kinetic}-({U})",
            "{name}=T-U, T={kinetic}, U={U}",
            "T={kinetic},\\ {name}=T-({U})",
        ]
    )
    law = System(form.format(name=name, kinetic=kinetic, U=printed))
    found = field(law)
    assert len(found) == 2 * len(names)
    forces = [-value.diff(plain(one)) for one in names]
    assert all(any((own - one).expand() == 0 for own in found.values()) for one in forces)
    assert law.integral(f"{kinetic}+{printed}").verdict == "proved"
    assert law.integral(f"{kinetic}+{other}").verdict == "refuted"


@pytest.mark.parametrize(
    "tex", ["H=x^2+y^2", "H=p^2+P^2+q", "H=p_1^2+p^2+x_1", "H=ab", "L=q^2", r"K=\frac12p^2"]
)
def test_what_belongs_to_a_momentum_is_not_guessed(tex):
    with pytest.raises(ValueError, match="print"):
        System(tex)


REFUSED = [
    (r"\dot x_i=a_{ij}x_j", "print the sums"),
    (r"\dot M_i=\varepsilon_{ijk}M_jM_k/I_k", "over what is summed"),
    (r"\dot M_i=(\varepsilon_{ijk}M_jg_k)^2", "over what is summed"),
    (r"\dot M_i=\varepsilon_{ijk}M_jg_k+g_j", "which indices are free"),
    (r"\dot a=b-ia,\ \dot b=-ia", "i\\^2=-1"),
    (r"\dot a=-ib,\ \dot b=-ia", "i\\^2=-1"),
    (r"I\dot\omega=I\omega\times\omega", "in bold"),
    (r"\dot M=(M+\lambda)\times\omega", "in bold"),
    (r"\ddot x=-\frac{x}{\|x\|^3}", "the vector in bold"),
    (r"\ddot x=-x/\left\|x\right\|^3", "the vector in bold"),
    (r"\dot x=y,\ \dot y=-sin x", "print .sin"),
    (r"\dot x=-(x-\bar x)", "rename it, or print i"),
    (r"\dot x=\delta_{ij}x", "print the sums"),
    (r"\dot x=x'+y,\ \dot y=x", "a prime is a derivative too"),
    (r"\frac{dx}{dt}=y,\ \frac{dy}{dt}=-x+y'", "a prime is a derivative too"),
    (r"where\ \dot x=y,\ \dot y=-x", "words outside"),
]


@pytest.mark.parametrize(("tex", "instead"), REFUSED)
@pytest.mark.parametrize("name", [str, lambda tex: tex.replace("x", "u").replace("M", "L")])
def test_what_would_be_misread_is_refused_with_what_to_print(tex, instead, name):
    with pytest.raises(ValueError, match=instead):
        System(name(tex) if "sin x" not in tex else tex)


@pytest.mark.parametrize(
    "tex",
    [
        r"\dot x=3\times10y,\ \dot y=-x", "\\dot x=(a+b)\\\\ \\times(c+d)y", r"\dot q_i=p_i,\ \dot p_i=-q_i",
        r"\dot x=x_{\text{for}},\ \dot y=sx", r"\dot x=\mathrm{i}y,\ i^2=-1,\ \dot y=x",
    ],
)  # fmt: skip
def test_what_is_clear_is_not_refused(tex):
    assert System(tex).scene.field


@pytest.mark.slow
@FEW
def test_an_absolute_value_is_the_positive_root_of_the_square(seed):
    chance = random.Random(seed)
    bars = chance.choice(["|x|", r"\left|x\right|", r"\lvert x\rvert", r"\vert x\vert"])
    power, scale = chance.choice([1, 2, 3]), chance.choice([1, 2, 3])
    law = System(rf"\ddot x=-{scale}x{bars}^{power}")
    energy = rf"(\dot x)^2+\frac{{{2 * scale}}}{{{power + 2}}}x^2{bars}^{power}"
    assert law.integral(energy).verdict.green, energy
    assert law.integral(energy.replace(bars, "x")).verdict == (
        "proved" if power == 2 else "refuted"
    )
    assert law.integral(energy.replace("+", "-")).verdict == "refuted"


# -- a vector by another one, and matrices ---------------------------------------------------------


@pytest.mark.slow
@FEW
def test_the_moment_of_a_body_is_its_tensor_times_its_velocity(seed):
    """The equations of Euler in one of the vectors, however tensor and vectors are printed."""
    chance = random.Random(seed)
    M, w = chance.choice([(r"\mathbf M", r"\boldsymbol\omega"), (r"\mathbf K", r"{\bf w}")])
    tensor = chance.choice(["I", r"\mathbf I", r"\mathbf J", "A"])
    diagonal = chance.choice(
        [
            rf"{tensor}=\operatorname{{diag}}(a,b,c)",
            rf"{tensor}=\begin{{pmatrix}}a&0&0\\0&b&0\\0&0&c\end{{pmatrix}}",
        ]
    )
    torque = chance.choice(["", r"+\boldsymbol\gamma\times\mathbf e"])
    rows = rf"\dot{{{M}}}={M}\times {w}{torque}"
    if torque:
        rows += rf",\ \dot{{\boldsymbol\gamma}}=\boldsymbol\gamma\times {w}"
    by = chance.choice([f"{M}={tensor}{w}", f"{w}={tensor}^{{-1}}{M}"])
    energy = rf"\frac12{M}\cdot {w}" + (r"+\mathbf e\cdot\boldsymbol\gamma" if torque else "")
    system = System(rf"{rows},\ {by},\ {diagonal}")
    assert system.integral(energy).verdict == "conditional", system
    assert system.integral(rf"{w}\cdot {w}").verdict == "refuted"
    square = rf"{M}\cdot\boldsymbol\gamma" if torque else rf"{M}\cdot {M}"
    assert system.integral(square).verdict == "conditional"
    assert system.identity(f"{M}={tensor}{w}").verdict.green
    doubled = rows.replace(rf"{M}\times", rf"2{M}\times", 1)
    wrong = System(rf"{doubled},\ {by},\ {diagonal}")
    assert not torque or wrong.integral(square).verdict == "refuted"


@pytest.mark.parametrize(
    ("mark", "by"),
    sampled([
        ("{}'", r"\frac{d}{ds}"), ("'", r"d/d\tau"), (r"\left({}'", r"\frac{d}{d\varphi}\right)"),
        ("'", r"\frac{d}{dt}"), (r"\dot{\ }", r"\frac{d}{dt}"),
    ], 1),
)  # fmt: skip
@pytest.mark.parametrize("sign", ["=", r"\equiv "])
def test_it_may_be_said_by_what_a_prime_or_a_dot_derives(mark, by, sign):
    dot = "dot" in mark
    rate, second = (r"\dot u", r"\ddot u") if dot else ("u'", "u''")
    law = System(rf"2{second}-hu=0,\qquad {mark}{sign}{by}")
    assert law.scene.time in by
    assert law.integral(f"2({rate})^2-hu^2").verdict == "proved"
    assert law.integral(f"2({rate})^2+hu^2").verdict == "refuted"


@FEW
def test_a_matrix_may_be_given_by_its_inverse(seed):
    chance = random.Random(seed)
    inverse = chance.choice(
        [r"\operatorname{diag}(a,b,c)", r"\begin{pmatrix}a&0&0\\0&b&0\\0&0&c\end{pmatrix}"]
    )
    tensor = chance.choice([r"\mathbf J", "J", r"\mathbf{I}"])
    by = rf"\mathbf M={tensor}\boldsymbol\omega"
    body = System(
        rf"\dot{{\mathbf M}}=\mathbf M\times\boldsymbol\omega,\ {by},\ {tensor}^{{-1}}={inverse}"
    )
    energy = r"aM_1^2+bM_2^2+cM_3^2"
    assert body.integral(energy).verdict.green
    assert body.integral(energy.replace("+c", "-c")).verdict == "refuted"
    assert body.identity(r"M_1=\frac{\omega_1}{a}").verdict.green
    assert body.identity(r"M_1=a\omega_1").verdict == "refuted"


@FEW
def test_a_momentum_is_a_multiple_of_a_velocity(seed):
    chance = random.Random(seed)
    p, q, m = chance.choice([("p", "q", "m"), ("y", "x", "a"), ("L", r"\varphi", "I")])
    rows = [rf"{p}={m}\dot {q}", rf"\dot {p}=-k{q}"]
    chance.shuffle(rows)
    system = System(",\\ ".join(rows))
    assert system.integral(rf"{p}^2+k{m}{q}^2").verdict == "conditional"
    assert system.integral(rf"{p}^2-k{m}{q}^2").verdict == "refuted"


@pytest.mark.slow
def test_a_bracket_that_is_printed_takes_the_place_of_the_one_that_is_implied():
    tex = (
        r"\dot x=\frac{\partial H}{\partial p},\ \dot y=\frac{\partial H}{\partial q},\ "
        r"\dot p=-\frac{\partial H}{\partial x},\ \dot q=-\frac{\partial H}{\partial y},\ "
        r"H=\frac12(p^2+q^2)+2x^2"
    )
    for *printed, verdict in (
        ["proved"],
        [r"\{x,p\}=1,\ \{y,q\}=1", "proved"],
        [r"\{x,p\}=1", "refuted"],
        [r"\{x,p\}=1", r"\{y,q\}=1", "proved"],
        [r"\{x,p\}=2,\ \{y,q\}=2", "refuted"],
    ):
        system = System(tex)
        for brackets in printed:
            system.define(brackets)
        assert system.integrable("H", "q").verdict == verdict


CASIMIR = r"M_1^2+M_2^2+M_3^2"


@pytest.mark.parametrize(
    ("tex", "verdict"),
    sampled([
        (CASIMIR, "proved"), (f"2K={CASIMIR}", "proved"), (f"K={CASIMIR}", "proved"),
        (rf"{CASIMIR}=\mathrm{{const}}", "proved"), (f"{CASIMIR}=c^2", "proved"),
        (f"2h={CASIMIR}", "proved"), (f"{CASIMIR}=1", "proved"),
        (f"{CASIMIR}=-1", "refuted"), ("M_1^2+M_2^2=c^2", "refuted"), ("2K=M_1^2+M_2^2", "refuted"),
        (r"M_1=\mathrm{const}", "refuted"), ("M_1-M_1=0", "refuted"),
    ], 1),
)  # fmt: skip
def test_a_casimir_function_may_have_a_name_or_a_value(tex, verdict):
    system = System(r"\{M_i,M_j\}=\varepsilon_{ijk}M_k,\ H=aM_1^2+bM_2^2+cM_3^2")
    assert system.casimir(tex).verdict == verdict


KOWALEVSKI = (
    r"2\frac{dp}{dt}=qr,\ 2\frac{dq}{dt}=-pr-c_0\gamma'',\ \frac{dr}{dt}=c_0\gamma',\ "
    r"\frac{d\gamma}{dt}=r\gamma'-q\gamma'',\ \frac{d\gamma'}{dt}=p\gamma''-r\gamma,\ "
    r"\frac{d\gamma''}{dt}=q\gamma-p\gamma'"
)


@pytest.mark.parametrize("mark", sampled([r"\frac{{d{}}}{{dt}}", r"\dot {}"], 1))
def test_names_with_primes_are_names_where_they_have_rates(mark):
    """The equations of Kowalevski's memoir, with the direction cosines as she prints them."""
    tex = re.sub(r"\\frac\{d([^}]*)\}\{dt\}", lambda rate: mark.format(rate[1]), KOWALEVSKI)
    top = System(tex)
    assert {*top.scene.variables} == {"p", "q", "r", r"\gamma", r"\gamma'", r"\gamma''"}
    fourth = r"(p^2-q^2+c_0\gamma)^2+(2pq+c_0\gamma')^2"
    for true in (fourth, r"\gamma^2+\gamma'^2+\gamma''^2", r"2(p\gamma+q\gamma')+r\gamma''"):
        assert top.integral(true).verdict == "proved"
    for false in (fourth.replace("+c_0", "-c_0"), r"\gamma^2+\gamma'^2-\gamma''^2"):
        assert top.integral(false).verdict == "refuted"


@FEW
def test_ratios_of_differentials_are_rates(seed):
    chance = random.Random(seed)
    names = chance.choice(
        [["x", "y", "z"], ["x_1", "x_2", "x_3"], ["p", "q", r"\varphi"], ["u", "v"]]
    )
    symbols = [plain(one) for one in names]
    rate = [
        chance.choice([1, 2, -1]) * chance.choice(symbols) * chance.choice([*symbols, Symbol("a")])
        + chance.choice([0, 1, *symbols])
        for _ in names
    ]
    texts = [latex(one) for one in rate]
    form = chance.choice([r"\frac{{d{}}}{{{}}}", r"\frac{{\,d{}}}{{\displaystyle {}}}", "d{}/({})"])
    time, by = chance.choice([("", 1), ("dt", 1), (r"\frac{dt}{a}", Symbol("a"))])
    members = [form.format(n, t) for n, t in zip(names, texts, strict=True)] + [time] * bool(time)
    chance.shuffle(members)
    law = System("=".join(members))
    meant = {str(one): force / by for one, force in zip(symbols, rate, strict=True)}
    assert not differ(law, meant, seed), law
    scaled = System("=".join(members).replace(texts[0], f"2({texts[0]})"))
    assert differ(scaled, meant, seed)


@FEW
def test_a_letter_beside_the_vector_is_its_length(seed):
    chance = random.Random(seed)
    letter, bold = chance.choice([("r", r"\mathbf r"), ("q", r"\boldsymbol q"), ("x", r"\vec x")])
    names = chance.choice(["(u,v,w)", "(u,v)"])
    n = chance.choice([1, 2, 3, 4])
    beside = chance.choice(["", rf",\ {letter}=|{bold}|"])
    force = chance.choice([rf"-\frac{{{bold}}}{{{letter}^{n}}}", rf"-{letter}^{n}{bold}"])
    law = System(rf"\ddot{{{bold}}}={force},\ {bold}={names}{beside}")
    assert letter not in law.scene.constants
    assert law.integral(r"u\dot v-v\dot u").verdict.green
    power = 2 - n if "frac" in force else n + 2
    if power:
        U = (
            rf"\frac{{1}}{{{power}}}{letter}^{{{power}}}"
            if power > 0
            else rf"-\frac{{1}}{{{-power}{letter}^{-power}}}"
        )
        kinetic = rf"\frac12|\dot{{{bold}}}|^2"
        assert law.integral(f"{kinetic}+{U}").verdict.green, (law, U)
        assert law.integral(f"{kinetic}-2{U}".replace("-2-", "+2")).verdict == "refuted"


@pytest.mark.parametrize("tex", [r"\dot{\mathbf M}=M\mathbf M\times\boldsymbol\omega"])
def test_a_capital_beside_its_vector_may_be_a_mass(tex):
    with pytest.raises(ValueError, match="if it is the length"):
        System(tex)


@pytest.mark.parametrize(
    ("relations", "true", "false"),
    sampled(
        [
            (("a=b=1",), "3y^2+3x^2-2x^3", "3y^2-3x^2-2x^3"),
            ((r"a=1,\ b=2",), "3y^2+6x^2-4x^3", "3y^2+6x^2+4x^3"),
            (("ab+1=0",), "aby^2+b^2x^2+\\frac{2b}{3}x^3", "aby^2+b^2x^2-\\frac{2b}{3}x^3"),
            ((r"\frac1a+\frac1b=0",), r"3y^2-3x^2-2bx^3", r"3y^2-3x^2+2bx^3"),
            (("a^2+b^2=5",), "3ay^2+3bx^2-2abx^3", "3ay^2+3bx^2-2x^3"),
            (("a=kc,\\ b=kd",), "3cy^2+3dx^2-2dkcx^3", "3cy^2+3dx^2-2dx^3"),
            (("b(a-1)s^2=a",), "3ay^2+3bx^2-2abx^3", "3ay^2-3bx^2-2abx^3"),
        ],
        1,
    ),
)
def test_any_relation_of_constants_is_supposed(relations, true, false):
    system = System(r"\dot x=ay,\ \dot y=-bx+abx^2").where(*relations)
    assert system.integral(true).verdict.green
    assert system.integral(false).verdict == "refuted"


def test_what_a_constant_is_divided_by_is_a_condition():
    """Of ab=0 one of two cases is supposed, and that is said."""
    special = System(r"\dot x=ay,\ \dot y=-bx").where("ab=0")
    claim = special.integral("y^2")
    assert not claim.verdict.green or claim.conditions


def test_functions_in_a_sum_are_those_of_its_terms():
    """The open lattice of Toda by its Hamiltonian, as it is printed everywhere."""
    toda = System(r"H=\frac12\sum_{i=1}^3p_i^2+\sum_{i=1}^{2}e^{q_i-q_{i+1}}")
    assert toda.integral("p_1+p_2+p_3").verdict is Verdict.PROVED
    assert toda.integral("p_1p_2p_3-p_1e^{q_2-q_3}-p_3e^{q_1-q_2}").verdict is Verdict.PROVED
    assert toda.integral("p_1p_2p_3-p_1e^{q_2-q_3}+p_3e^{q_1-q_2}").verdict is Verdict.REFUTED


def test_a_correction_in_which_the_rates_rest_on_themselves_is_none():
    """A dot in the Hamiltonian is tried, where the equations of motion are its derivatives."""
    toda = System(r"H=\frac12(p_1^2+p_2^2+p_3^2)+e^{q_1-q_2}+e^{q_2-q_3}")
    assert toda.integral("p_1p_2p_3").verdict is Verdict.REFUTED


@FEW
def test_rates_beside_the_sign_of_a_permutation_have_its_indices(seed):
    chance = random.Random(seed)
    sign, i, j, k = chance.choice([1, -1]), *"ijk"
    a, b, c = (chance.randint(1, 4) for _ in range(3))
    minus = "-" if sign < 0 else ""
    tex = (
        rf"\{{M_{i},M_{j}\}}={minus}\varepsilon_{{{i}{j}{k}}}M_{k},\ H={a}M_1^2+{b}M_2^2+{c}M_3M_1"
    )
    index = chance.choice([i, j])
    m = vector("M")
    energy = a * m[0] ** 2 + b * m[1] ** 2 + c * m[2] * m[0]
    meant = {
        f"M_{p + 1}": sum(
            sign * LeviCivita(p, q, r) * m[r] * energy.diff(m[q])
            for q in range(3)
            for r in range(3)
        )
        for p in range(3)
    }
    assert not differ(System(rf"{tex},\ \dot M_{index}=\{{M_{index},H\}}"), meant, seed), tex
    other = System(rf"{tex},\ \dot M_{index}=-\{{M_{index},H\}}")
    assert differ(other, meant, seed), tex
    with pytest.raises(ValueError, match="print l=1,2,3"):
        System(rf"{tex},\ \dot M_l=\{{M_l,H\}}")


@FEW
def test_a_partial_derivative_may_stand_in_an_index(seed):
    chance = random.Random(seed)
    (q, p), (r, s) = chance.sample([("q_1", "p_1"), ("x", "p_x"), (r"\theta", r"p_\theta"), ("Q", "P")], 2)  # fmt: skip
    H = rf"{p}^2 {s}+{q}^3 {s}^2+{chance.randint(1, 4)} {r} {q} {p}"

    def law(by):
        rows = [rf"\dot{{{one}}}={by(sign, two)}" for one, sign, two in
                ((q, "", p), (r, "", s), (p, "-", q), (s, "-", r))]  # fmt: skip
        return System(",\\ ".join([f"H={H}", *rows]))

    plain = law(lambda sign, x: rf"{sign}\frac{{\partial H}}{{\partial {x}}}")
    index = law(lambda sign, x: rf"{sign}\partial_{{{x}}}H")
    other = law(lambda sign, x: rf"-{sign}\partial_{{{x}}}H" if x == s else rf"{sign}\partial_{{{x}}}H")  # fmt: skip
    assert field(index) == field(plain) != field(other)


def test_the_order_of_a_partial_derivative_is_that_of_its_index():
    system = System(r"\dot x=\partial_{yy}F+\partial_x\partial_yF-\partial_x^2F,\ \dot y=x,\ F=x^2y^3")  # fmt: skip
    assert system.identity(r"\dot x=6x^2y+6xy^2-2y^3").verdict == "proved"
    assert system.identity(r"\dot x=6x^2y+6xy^2+2y^3").verdict == "refuted"
    with pytest.raises(NotationError, match="how far"):
        System(r"\dot x=\partial_yFx,\ \dot y=x,\ F=xy^3")


@pytest.mark.parametrize("seed", range(2))
def test_what_is_defined_may_be_printed_at_its_arguments(seed):
    chance = random.Random(seed)
    V = rf"{chance.randint(2, 4)}q_1^2q_2+q_2^{chance.randint(3, 4)}"
    alone = System(rf"H=\frac12(p_1^2+p_2^2)+V,\ V={V}")
    applied = System(rf"H=\frac12(p_1^2+p_2^2)+V(q_1,q_2),\ V={V}")
    assert field(alone) == field(applied)
    assert applied.identity(rf"V(q_1, q_2)={V}").verdict == "proved"
    with pytest.raises(ValueError, match="another argument"):
        applied.identity(rf"V(q_2,q_1)={V}")
