"""Maps as they are printed: what they preserve is proved, and what they do not is refuted."""

import json
import random
from contextlib import suppress
from hashlib import sha256

import pytest

from kowalevski_cas import System
from kowalevski_cas.paper.claims import AllInvariantsOfMap
from kowalevski_cas.problem import checker
from kowalevski_cas.verify.outcome import Verdict
from tests.laws.test_prints import FEW
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("uncorrected")


def names(chance):
    """Two variables with their images, and whether it has to be said that it is a map."""
    x, y = chance.choice([("x", "y"), ("q", "p"), (r"\theta", "I"), ("u", "v")])
    n = chance.choice(["n", "k", "m", ""])
    if not n:
        return x, y, f"{x}'", f"{y}'", True
    return f"{x}_{n}", f"{y}_{n}", f"{x}_{{{n}+1}}", f"{y}_{{{n}+1}}", False


@pytest.mark.slow
@FEW
def test_a_matrix_with_determinant_one_preserves_a_form(seed):
    chance = random.Random(seed)
    x, y, x1, y1, told = names(chance)
    k, m = chance.sample([-3, -2, 2, 3], 2)
    a, b, c, d = 1 + k * m, k, m, 1  # two shears
    rows = [f"{x1}={a}{x}{b:+}{y}", f"{y1}={c}{x}+{y}"]
    chance.shuffle(rows)
    law = System(",\\ ".join(rows), map=told)
    assert {*law.scene.variables} == {x, y} and not law.scene.constants
    form = f"{c}{x}^2{d - a:+}{x} {y}{-b:+}{y}^2"
    assert law.integral(form).verdict == "proved", law
    assert law.integral(f"({form})^2").verdict == "proved"
    assert law.integral(f"{c + 1}{x}^2{d - a:+}{x} {y}{-b:+}{y}^2").verdict == "refuted"
    assert law.integral("7").verdict == "refuted"
    assert law.symplectic().verdict == law.measure().verdict == "proved"
    assert law.integrable(form).verdict == "proved"
    assert law.integrable(f"{form}+{x}").verdict == "refuted"
    wide = System(",\\ ".join(rows).replace(f"{a}{x}", f"{a + 1}{x}"), map=told)
    assert wide.symplectic().verdict == wide.measure().verdict == "refuted"


@pytest.mark.slow
@FEW
def test_the_symmetric_map_of_quispel_roberts_and_thompson_has_its_invariant(seed):
    r"""Of :math:`x_{n+1}+x_{n-1}=-(\beta x^2+\epsilon x+\xi)/(\alpha x^2+\beta x+\gamma)`."""
    chance = random.Random(seed)
    letter, n = chance.choice("xuw"), chance.choice("nkm")
    x, y, new = f"{letter}_{n}", f"{letter}_{{{n}-1}}", f"{letter}_{{{n}+1}}"
    al, be, ga, ep, xi = (chance.choice([-2, -1, 1, 2, 3]) for _ in range(5))
    right = (
        rf"-\frac{{{be}{x}^2{ep:+}{x}{xi:+}}}{{{al}{x}^2{be:+}{x}{ga:+}}}"  # the print of the paper
    )
    form = chance.choice([f"{new}+{y}={right}", f"{new}={right}-{y}"])
    law = System(form)
    assert law.scene.variables == (x, y)
    invariant = (
        f"{al}{x}^2{y}^2{be:+}({x}^2{y}+{x} {y}^2){ga:+}({x}^2+{y}^2){ep:+}{x} {y}{xi:+}({x}+{y})"
    )
    assert law.integral(invariant).verdict.green, law
    assert (
        law.integral(invariant.replace(f"{ep:+}{x} {y}", f"{ep + 1:+}{x} {y}")).verdict == "refuted"
    )
    assert law.symplectic().verdict.green and law.measure().verdict.green
    assert law.integral(invariant.replace(y, new)).verdict.green
    assert law.integrable(invariant).verdict.green


@pytest.mark.slow
def test_a_map_with_a_sine_preserves_the_area():
    law = System(r"p_{n+1}=p_n+K\sin x_n,\ x_{n+1}=x_n+p_{n+1}")
    assert law.symplectic().verdict == law.measure().verdict == "proved"
    assert law.integral("p_n").verdict == "refuted"
    rough = System(r"p_{n+1}=bp_n+K\sin x_n,\ x_{n+1}=x_n+p_{n+1}")
    assert rough.symplectic().verdict == rough.measure().verdict == "refuted"


@pytest.mark.slow
def test_a_density_and_a_bracket_are_those_that_are_printed():
    law = System(r"x_{n+1}x_{n-1}=x_n+a")
    assert law.measure(r"\frac1{x_nx_{n-1}}").verdict == "conditional"
    assert law.measure(r"\frac1{x_n}").verdict == law.measure().verdict == "refuted"
    own = System(r"x_{n+1}x_{n-1}=x_n+a,\ \{x_n,x_{n-1}\}=x_nx_{n-1}")
    assert own.symplectic().verdict == "conditional"
    other = System(r"x_{n+1}x_{n-1}=x_n+a,\ \{x_n,x_{n-1}\}=x_n")
    assert other.symplectic().verdict == "refuted"


def test_images_that_need_each_other_are_solved_for():
    law = System(r"x_{n+1}=x_n+y_{n+1},\ y_{n+1}=y_n+2x_{n+1}")
    assert law.identity(r"x_{n+1}=-x_n-y_n").verdict == "proved"
    assert law.measure().verdict == "proved"


@pytest.mark.parametrize("tex", [r"x'=y,\ y'=-x", r"x'=1-ax^2+y,\ y'=bx"])
def test_primes_are_rates_unless_it_is_said(tex):
    assert "move" in repr(System(tex)) and "are mapped" in repr(System(tex, map=True))
    with pytest.raises(ValueError, match="no map, but a motion"):
        System(tex).measure()


@pytest.mark.parametrize(
    ("tex", "message"),
    [
        (r"x_{n+1}^2=y_n,\ y_{n+1}=x_n", "not linear"),
        (r"x_{n+1}+y_{n+1}=y_n,\ x_n=1", "print one for each"),
        (r"x=y", "is no map"),
    ],
)
def test_what_is_no_map_is_refused(tex, message):
    with pytest.raises(ValueError, match=message):
        System(tex, map=True)


@pytest.mark.parametrize("claim", ["darboux", "find_darboux"])
def test_what_is_known_of_motions_only_is_not_claimed_of_maps(claim):
    law = System(r"x_{n+1}=y_n,\ y_{n+1}=-x_n")
    given = {"darboux": ("x_n", "1"), "find_darboux": (2,)}[claim]
    with pytest.raises(ValueError, match="of maps"):
        getattr(law, claim)(*given)


@pytest.mark.parametrize("behind", ["", r",\ n=0,1,2,\dots", r",\ n=1,2,\ldots"])
@pytest.mark.parametrize(
    "factor", sampled(["", r"\sum_{i=1}^{1}", r"\sum_{i=1}^2\frac12", r"\prod_{k=1}^3"], 1)
)
def test_the_steps_of_a_map_are_counted_by_no_index_of_a_sum_or_a_product(factor, behind):
    turn = System(rf"x_{{n+1}}={factor} y_n,\ y_{{n+1}}=-x_n{behind}")
    expected = Verdict.REFUTED if "prod" in factor else Verdict.PROVED
    assert turn.integral("x_n^2+y_n^2").verdict is expected
    assert turn.integral("x_n^2-y_n^2").verdict is Verdict.REFUTED


@FEW
def test_a_recurrence_of_higher_order_moves_all_names_between_its_ends(seed):
    chance = random.Random(seed)
    letter, n, order = chance.choice("xus"), chance.choice("nkm"), chance.choice([3, 4])
    at = [f"{letter}_{{{n}+{k}}}" if k else f"{letter}_{n}" for k in range(order + 1)]
    law = System(f"{at[order]}={at[0]}+{chance.randint(2, 5)}c{at[1]}")
    assert {*law.scene.variables} == {*at[:order]} and law.scene.constants == ("c",)
    product = "".join(at[:order])
    cyclic = System(f"{at[order]}={at[0]}+{at[1]}-{at[1]}")
    assert cyclic.integral(product).verdict == "proved"
    assert cyclic.integral(f"{product}+{at[1]}").verdict == "refuted"


@FEW
def test_bars_over_and_under_letters_are_the_steps_of_a_map(seed):
    chance = random.Random(seed)
    a, b = chance.sample([-3, -2, 1, 2, 3], 2)
    x = chance.choice(["x", "u", r"\phi "])
    over = chance.choice([r"\overline {}", r"\bar{{{}}}"]).format(x.strip())
    under = chance.choice([r"\underline {}", r"\underline{{{}}}"]).format(x.strip())
    said = rf",\quad {x}={x}_n,\ {over}={x}_{{n+1}},\ {under}={x}_{{n-1}}"
    law = System(
        rf"{over}+{x}+{under}=\frac{{{a}}}{{{x}}}{b:+}" + chance.choice(["", said]), map=True
    )
    assert len(law.scene.variables) == 2
    true = rf"{x}{under}({x}+{under}{-b:+}){-a:+}({x}+{under})"
    assert law.integral(true).verdict.green, true
    assert law.integral(rf"{x}{under}({x}+{under}{b:+}){-a:+}({x}+{under})").verdict == "refuted"
    assert law.identity(rf"{over}=\frac{{{a}}}{{{x}}}{b:+}-{x}-{under}").verdict.green
    assert law.identity(rf"{over}={under}").verdict == "refuted"
    plain = System(
        rf"x_{{n+1}}+x_n+x_{{n-1}}=\frac{{{a}}}{{x_n}}{b:+}", name="plain"
    )  # the same without bars
    assert plain.integral(rf"x_nx_{{n-1}}(x_n+x_{{n-1}}{-b:+}){-a:+}(x_n+x_{{n-1}})").verdict.green


@pytest.mark.slow
@FEW
def test_a_set_is_invariant_under_a_map_where_its_images_are_in_it(seed):
    chance = random.Random(seed)
    x, y, x1, y1, told = names(chance)
    c = chance.choice([-3, -2, 2, 3])
    law = System(f"{x1}={x}+{c}{y},\\ {y1}={y}", map=told)
    assert law.invariant(f"{y}=1").verdict == "proved"
    assert law.invariant(f"{y}=0", f"{x}=5").verdict == "proved"
    assert law.invariant(f"{x}=1").verdict == "refuted"
    assert law.invariant(f"{y}=1", f"{x}=5").verdict == "refuted"
    assert law.invariant(f"{y}^2=-1").verdict == "refuted"  # of no point all is true
    assert law.invariant(f"{y}^2=4").verdict == "proved"
    assert law.invariant(f"{x} {y}=0").verdict == "refuted"


def planar(chance):
    """A map of the plane with what all its polynomial invariants up to degree 4 are made of."""
    k, m = chance.sample([-3, -2, 2, 3], 2)
    a, b, c = 1 + k * m, k, m
    yield rf"x_{{n+1}}={a}x_n{b:+}y_n,\ y_{{n+1}}={c}x_n+y_n", 1
    yield rf"x_{{n+1}}+x_{{n-1}}=\frac{{{k}ax_n{m:+}}}{{1-x_n^2}}", 1
    yield rf"x_{{n+1}}={k}x_n+{m}a,\ y_{{n+1}}={m}y_n", 0
    yield r"x_{n+1}=-y_n,\ y_{n+1}=x_n", 3
    yield rf"x_{{n+1}}=x_n,\ y_{{n+1}}=y_n+{abs(k)}bx_n", 1
    yield rf"x_{{n+1}}=x_n+a,\ y_{{n+1}}=y_n{m:+}b", 1


@pytest.mark.slow
@FEW
def test_all_polynomial_invariants_of_a_map_are_found(seed):
    chance = random.Random(seed)
    tex, number = chance.choice([*planar(chance)])
    system = System(tex)
    *found, every = system.find_integrals(4)
    assert len(found) == number and all(one.verdict.green for one in (*found, every)), (tex, found)
    assert "each polynomial invariant up to degree 4" in repr(every)
    invariants = [one.claim.printed.tex for one in found]
    assert all(system.integral(one).verdict.green for one in invariants)
    values = tuple((name, "7") for name in system.scene.constants)
    for left_out in invariants:
        fewer = tuple(one for one in invariants if one != left_out)
        says = "there are no others"
        own = {"images": system.law.images, "invariants": fewer, "degree": 4, "values": values}
        verdict = "error" if values else "refuted"  # others at these values may be none elsewhere
        assert system.states(AllInvariantsOfMap, "all", says, **own).verdict == verdict, (
            tex,
            fewer,
        )


def all_invariants(tex, degree, *known, **values):
    """What is said of the claim that a map has no other invariants, at values of its constants."""
    system = System(tex)
    own = {"images": system.law.images, "invariants": known, "degree": degree}
    return system.states(AllInvariantsOfMap, "all", "", **own, values=tuple(values.items())).outcome


@pytest.mark.parametrize(
    ("tex", "degree", "known", "values", "verdict"),
    sampled(
        [
            # what is invariant under the identity is what there is
            (r"x_{n+1}=x_n,\ y_{n+1}=y_n", 2, ("x_n", "y_n"), {}, "proved"),
            (r"x_{n+1}=x_n,\ y_{n+1}=y_n", 2, ("x_n",), {}, "refuted"),
            # nothing is said of degree 0, nor of a value at which there is no map
            (r"x_{n+1}=y_n,\ y_{n+1}=-x_n", 0, (), {}, "error"),
            (r"x_{n+1}=y_n,\ y_{n+1}=\frac{x_n}{a-2}", 2, (), {"a": "2"}, "error"),
            (r"x_{n+1}=y_n,\ y_{n+1}=\frac{x_n}{a-2}", 2, (), {"a": "5"}, "conditional"),
            # at a = 3 the map only exchanges x and y, of which nothing follows for others
            (r"x_{n+1}=y_n,\ y_{n+1}=\frac{x_n}{a-2}", 2, (), {"a": "3"}, "error"),
            (r"x_{n+1}=y_n,\ y_{n+1}=\frac{x_n}{a-2}", 2, (), {}, "error"),
            # a function that vanishes at all small numbers is not zero
            (r"x_{n+1}=x_n+x_n(x_n-1)(x_n+1)(x_n-2)(x_n+2)", 1, (), {}, "proved"),
            # what is printed has to be an invariant, and a polynomial that is not constant
            (r"x_{n+1}=y_n,\ y_{n+1}=-x_n", 2, ("x_n", "y_n"), {}, "refuted"),
            (r"x_{n+1}=y_n,\ y_{n+1}=-x_n", 2, ("7",), {}, "error"),
            (r"x_{n+1}=y_n,\ y_{n+1}=-x_n", 2, (r"\frac1{x_n^2+y_n^2}",), {}, "error"),
            # of invariants that depend on each other each is a polynomial
            (r"x_{n+1}=y_n,\ y_{n+1}=-x_n", 2, ("x_n^2+y_n^2", "3x_n^2+3y_n^2"), {}, "proved"),
            # names of coefficients are none of the map's
            (r"c_{n+1}=k_n,\ k_{n+1}=-c_n+c_1", 1, (), {"c_1": "1"}, "proved"),
        ],
        2,
    ),
)
def test_that_there_are_no_other_invariants(tex, degree, known, values, verdict):
    assert all_invariants(tex, degree, *known, **values).verdict == verdict


def parts(tree):
    """The places of numbers and names in data, each with what would stand there instead."""
    for place, part in enumerate(tree) if isinstance(tree, list) else tree.items():
        if isinstance(part, list | dict):
            yield from parts(part)
        elif isinstance(part, int) and not isinstance(part, bool):
            yield tree, place, part + 1


def test_of_a_map_the_certificate_says_what_it_is():
    """No number in what is stated can be another one."""
    outcome = all_invariants(r"x_{n+1}=3x_n-2y_n,\ y_{n+1}=2x_n-y_n", 2, "x_n-y_n")
    assert outcome.verdict == "proved"
    data = json.loads(outcome.certificate)
    lets = [step for step in data["spaces"][0]["steps"] if step[0] == "let"]
    assert [name for _, name, _ in lets] == ["x_{n+1}", "y_{n+1}"]
    accepted = []
    for tree, place, other in parts({key: data[key] for key in ("spaces", "goals")}):
        before, tree[place] = tree[place], other
        statement = {key: data[key] for key in ("spaces", "goals")}
        text = json.dumps(statement, sort_keys=True).encode()
        forged = data | {"digest": sha256(text).hexdigest()[:16]}
        with suppress(checker.Rejected):
            checker.check(json.dumps(forged))
            accepted.append((tree, place))
        tree[place] = before
    assert not accepted
