"""Two readers that share no code read the same numbers from every formula."""

import re
from random import Random

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kowalevski_cas.library import available, load
from kowalevski_cas.notation import Relation, edits, read_display, to_latex
from kowalevski_cas.notation import formula as f
from tests.notation import numbers as n
from tests.notation import paper, textbooks
from tests.notation.second_reader import Words, derived, key, read
from tests.notation.strategies import WORDS, formulas
from tests.sample import sampled


def folded(values, join):
    """Several values joined from left to right."""
    first, *rest = values
    for other in rest:
        first = join(first, other)
    return first


# What a node is at a point, by its attributes; ``of`` gives the values of those that are formulas.
NODES = {
    f.Number: lambda of, at, node: n.number(node.value),
    f.Sum: lambda of, at, node: folded(map(of, node.terms), n.plus),
    f.Negative: lambda of, at, node: n.each(n.Value.__neg__, of(node.argument)),
    f.Product: lambda of, at, node: folded(map(of, node.factors), n.times),
    f.Quotient: lambda of, at, node: n.over(of(node.numerator), of(node.denominator)),
    f.Power: lambda of, at, node: n.to(of(node.base), of(node.exponent)),
    f.Root: lambda of, at, node: of(node.argument).root(),
    f.Derivative: lambda of, at, node: derived(of(node.argument), [key(node.mark)]),
    f.Partial: lambda of, at, node: derived(of(node.argument), ["∂" + key(node.by)]),
    f.Conjugate: lambda of, at, node: n.each(n.Value.conjugate, of(node.argument)),
    f.RealPart: lambda of, at, node: n.part(of(node.argument), True),
    f.ImaginaryPart: lambda of, at, node: n.part(of(node.argument), False),
    f.Application: lambda of, at, node: at.applied(key(node.function), [*map(of, node.arguments)]),
    f.Vector: lambda of, at, node: n.padded([*map(of, node.components)]),
    f.Diagonal: lambda of, at, node: n.diagonal(n.padded([*map(of, node.entries)])),
    f.ScalarProduct: lambda of, at, node: n.dot(of(node.left), of(node.right)),
    f.CrossProduct: lambda of, at, node: n.cross(of(node.left), of(node.right)),
    f.PoissonBracket: lambda of, at, node: n.bracket(of(node.left), of(node.right)),
    f.Commutator: lambda of, at, node: n.commutator(of(node.left), of(node.right)),
    f.Modulus: lambda of, at, node: n.length(of(node.argument)),
    f.Summation: lambda of, at, node: folded(
        (of(indexed(node.body, node.index, k)) for k in span(of(node.first), of(node.last))), n.plus
    ),
    f.Unwritten: lambda of, at, node: at.scalar("..."),
    f.Constant: lambda of, at, node: "const",
}


def span(first, last):
    """The numbers between limits."""
    return range(*(round(one[()].real) + k for k, one in enumerate((first, last))))


def indexed(formula, index, k):
    """The body of a sum for a value of the index."""
    if isinstance(formula, f.Name):
        letter, _, indices = formula.name.partition("_")
        if formula.name == index:
            return f.Number(k)
        return f.Name(f"{letter}_{indices.replace(index, str(k))}") if indices else formula
    return formula.map_children(lambda child: indexed(child, index, k))


def value(formula, words, point):
    """What a tree is at a point."""
    if isinstance(formula, f.Name):
        called = key(formula.name)
        return (point.scalar, point.vector, point.matrix)[words.ranks[called]](called)
    return NODES[type(formula)](lambda inner: value(inner, words, point), point, formula)


def agree(formula, second, words, point):
    """Whether a tree has the values and signs that the second reader found."""
    related = isinstance(formula, Relation)
    members = formula.members if related else (formula,)
    signs = formula.signs if related else ()
    values, found = second
    pairs = zip(members, values, strict=True)
    return tuple(found) == signs and all(
        one == other if "const" in (one, other) else n.same(one, other)
        for one, other in ((value(m, words, point), v) for m, v in pairs)
    )


def at(seed, tex):
    """A random point, with a time for each name by which the source differentiates in part."""
    names = re.findall(
        r"\\partial *\{?(\\?(?:[A-Za-z]+\{)?\\?[A-Za-z]+\}?(?:_(?:\w|\{[^}]*\}))?)", tex
    )
    partials = {"∂" + key(name) for name in names} if "partial" in tex else set()
    return n.Point(seed, {"dot", "prime", "t", "tau", *partials})


def check(tex, vocabulary, seeds=(1, 2)):
    words, found = Words.of(vocabulary), read_display(tex, vocabulary)
    for seed in seeds:
        point = at(seed, tex)
        second = read(tex, words, point)
        assert len(found) == len(second)
        for statement, other in zip(found, second, strict=True):
            assert agree(statement.formula, other, words, point), statement.source


@pytest.mark.parametrize("tex", textbooks.FORMULAS)
def test_on_textbooks(tex):
    check(tex, textbooks.WORDS)


# The second reader has no elliptic integrals, and nothing that is said for all indices.
BY_BOTH = [name for name in available() if name != "leroy2020"]


@pytest.mark.parametrize("name", sampled(BY_BOTH, 1, seed=9))
def test_on_every_display_of_the_derivations(name):
    derivation = load(name)
    vocabulary = derivation.texts().vocabulary
    read = {place.display for claim in derivation.claims for place in claim.places()}
    read |= {place.display for scene in derivation.scenes() for place in scene.places}
    for display in (one for one in derivation.displays() if one in read):
        check(display.tex, vocabulary, seeds=(1,))


@given(formulas, st.integers(0, 10**6))
def test_on_any_formula(formula, seed):
    tex = to_latex(formula)
    words, point = Words.of(WORDS), at(seed, tex)
    try:
        second = read(tex, words, point)
        assert len(second) == 1
        assert agree(formula, second[0], words, point)
    except (ArithmeticError, ValueError):  # a pole, or a logarithm of zero
        assume(False)


@pytest.mark.parametrize("name", sampled(["eq5", "eq10", "eq12", "eq14", "eq16", "eq21"], 1))
def test_a_misprint_changes_the_numbers_of_both(name):
    tex, words = paper.DISPLAYS[name], Words.of(paper.WORDS)
    chance, point = Random(name), at(3, tex)
    for row, statement in enumerate(read_display(tex, paper.WORDS)):
        for edit in chance.sample([*edits(statement, paper.WORDS)], 8):
            second = read(edit.tex, words, point)[row]
            assert agree(edit.formula, second, words, point)
            assert not agree(statement.formula, second, words, point)
