"""Words among formulas: the function that they name, what is declared, or an error; no constant."""

import random
from itertools import product

import pytest

from kowalevski_cas import System
from kowalevski_cas.notation import NotationError
from kowalevski_cas.notation.formula import Application
from kowalevski_cas.notation.functions import FUNCTIONS, SPELLING
from tests.sample import sampled

FONTS = (
    r"\operatorname{%s}", r"\mathrm{%s}", r"{\rm %s}", r"\mathop{\rm %s}", r"\mathit{%s}",
    r"\mathsf{%s}", r"\operatorname*{%s}",
)  # fmt: skip
OVER = (
    "%s", r"\hat{%s}", r"\tilde %s", r"\widehat{\mathrm{%s}}", r"\mathcal{%s}", r"\check{\mathsf{%s}}",
)  # fmt: skip
ARGUMENTS = ("x", r"\,x", "(x)", r"\left(x\right)", "{x}", "^2x", "^2(x+y)", "2x", r"\frac{x}{2}")
UNKNOWN = ("erf", "Ai", "sinc", "Ra", "abc", "lg", "grad", "sl")
KNOWN = sorted(
    {word[8:-1] for word in (*FUNCTIONS, *SPELLING) if word.startswith(r"\mathrm{")}
    | {word[1:] for word in FUNCTIONS if not word.startswith(r"\mathrm")}
)

FEW, MANY = 12, 400
MARKS = [FEW, pytest.param(MANY, marks=pytest.mark.slow)]


def chosen(words, many):
    every = [*product(words, FONTS, ARGUMENTS)]
    return random.Random(2002).sample(every, min(many, len(every)))


@pytest.mark.parametrize("many", MARKS)
def test_a_word_that_nobody_declares_is_an_error(many):
    for word, font, argument in chosen(UNKNOWN, many):
        for tex in (
            rf"\dot x=y,\ \dot y={font % word}{argument}",
            rf"\dot x={font % word}{argument}y",
        ):
            with pytest.raises(NotationError):
                System(tex)


@pytest.mark.parametrize("many", MARKS)
def test_a_word_that_names_a_function_is_never_a_name(many):
    for word, font, argument in chosen(KNOWN, many):
        tex = rf"\dot x=y,\ \dot y={font % word}{argument}"
        try:
            system = System(tex)
        except (NotationError, ValueError):
            continue  # as where the argument is no scalar
        assert not system.scene.constants, tex
        nodes = [n for one in system._formulas(system.section.displays[0]) for n in one.nodes()]
        assert any(isinstance(node, Application) for node in nodes), tex


@pytest.mark.parametrize("over", OVER)
def test_a_macro_is_no_constant_whatever_stands_over_it(over):
    for macro in (
        r"\foo",
        r"\sin",
        r"\partial",
        r"\nabla",
        r"\infty",
        r"\int",
        r"\ln",
        r"\mathrm{tg}",
    ):
        for argument in ("x", "(x)", "^2x"):
            try:
                system = System(rf"\dot x=y,\ \dot y={over % macro}{argument}")
            except (NotationError, ValueError):
                continue  # as it is refused, or where the function that it is has no such argument
            assert not system.scene.constants, (over, macro)


@pytest.mark.parametrize("font", FONTS)
def test_what_is_declared_is_a_name(font):
    word = font % "Ra"
    plain = System(r"\dot x=ay,\ \dot y=-ax").having(word)
    assert plain.scene.constants == ("a", r"\mathrm{Ra}")
    assert plain.integral(f"{word}(x^2+y^2)").verdict == "proved"
    defined = System(rf"\dot x=a{word}y,\ \dot y=-a{word}x,\ {word}=3a+1")
    assert defined.integral("x^2+y^2").verdict == "proved"
    moving = System(rf"\frac{{d{word}}}{{dt}}=y,\ \dot y=-{word}")
    assert moving.scene.variables == (r"\mathrm{Ra}", "y")


@pytest.mark.parametrize("index", [r"_{\rm max}", r"_{\mathrm{ab}}", r"_{\text{ext}}"])
def test_an_index_is_a_word_of_a_name(index):
    system = System(rf"\dot x=a{index}y,\ \dot y=-{{\rm c}}x")
    assert len(system.scene.constants) == 2


@pytest.mark.parametrize("name", ["t", "", " ", r"\sin", r"\ln", "x", "2", "ab", "a+b", "a=1", r"\frac", r"\mathrm{sin}", r"\operatorname{tg}", "x^2", "d x"])  # fmt: skip
def test_what_is_no_name_of_a_constant_is_declared_by_nobody(name):
    with pytest.raises(ValueError):
        System(r"\dot x=ay,\ \dot y=-ax").having(name)


@pytest.mark.parametrize(
    "relation", ["a=x", "a=x^2", "a=t", "a=b+y", r"a=\sin x", "a=x-x+y", "a=E"]
)
def test_a_constant_is_given_by_constants_only(relation):
    system = System(r"\dot x=aby,\ \dot y=-abx")
    system.define("E=x^2+y^2")
    with pytest.raises(ValueError):
        system.where(relation)


def test_a_root_of_what_moves_is_no_constant_in_the_heading():
    special = System(r"\dot x=ry,\ \dot y=-rx").where("r^2=x^2+y^2")
    assert "constant" not in repr(special)
    assert special.integral("r").verdict.green


# -- words behind formulas -------------------------------------------------------------------------


@pytest.mark.parametrize(
    "beside",
    sampled([
        r"a\text{ constant}", r"a,b\text{ constants}", r"a,\ b\text{ are arbitrary constants}",
        r"a\text{ the mass}", r"a\text{ is the mass},\ b\text{ denotes the stiffness of the spring}",
        r"a\text{ and }b\text{ being the masses}", r"b\mbox{ a number}",
    ], 1),
)  # fmt: skip
def test_words_that_describe_constants_say_no_more(beside):
    system = System(rf"a\ddot x=-bx,\quad {beside}")
    assert {*system.scene.constants} == {"a", "b"}
    assert system.integral(r"a\dot x^2+bx^2").verdict.green
    assert system.integral(r"a\dot x^2-bx^2").verdict == "refuted"


@pytest.mark.parametrize(
    "words",
    [
        "a positive constant", "the real number", "not constant", "if positive", "a unit vector",
        "the only integral", "small", "an integer", "constant on the set", "the smaller or the larger",
    ],
)  # fmt: skip
def test_words_that_suppose_something_are_refused_with_what_to_print(words):
    with pytest.raises(ValueError, match="print what they suppose as a formula"):
        System(rf"a\ddot x=-bx,\quad a\text{{ {words}}}")


@pytest.mark.slow
def test_what_is_said_to_be_constant_is_that():
    system = System(
        r"\dot{\mathbf x}=\mathbf k\times\mathbf x,\quad"
        r"\mathbf k=(k_1,k_2,k_3)^{\mathsf T}\text{ constant},\quad c=k_1^2"
    )
    assert {*system.scene.constants} == {"k_1", "k_2", "k_3"}
    assert system.integral(r"\mathbf k\cdot\mathbf x").verdict.green
    assert system.integral(r"\mathbf k\cdot\mathbf k+cx_1").verdict == "refuted"


@pytest.mark.parametrize("reals", [r"\mathbf R", r"\mathbb{R}", "{\\bf R}"])
@pytest.mark.parametrize("names", sampled(["a,b", "a", r"b,\ a", "a_1"], 1))
def test_what_is_said_to_be_real_is_that_anyway(names, reals):
    system = System(rf"a\ddot x=-bx,\quad {names}\in{reals}")
    assert {*system.scene.constants} == {"a", "b"}
    assert system.integral(r"a\dot x^2+bx^2").verdict.green
    assert system.integral(r"a\dot x^2-bx^2").verdict == "refuted"


@pytest.mark.parametrize("set_", [r"\mathbf R^2", r"\mathbf R_+", r"\mathbf C", r"\mathbf N"])
def test_other_sets_suppose_something_and_are_refused(set_):
    with pytest.raises(ValueError, match=r"print|components|\\in"):
        System(rf"a\ddot x=-bx,\quad a\in{set_}")


@pytest.mark.parametrize("tex", [r"x'=iy,\ y'=x", r"z'=e^{i(\alpha+\beta|z|^2)}z"])
def test_an_i_in_a_map_may_be_the_imaginary_unit(tex):
    with pytest.raises(ValueError, match=r"print i\^2=-1"):
        System(tex, map=True)
