"""The formulas of a paper to statements, in the names that it uses: which letters are vectors."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from itertools import pairwise

from kowalevski_cas.notation import (
    Formula,
    Name,
    Negative,
    NotationError,
    Power,
    Product,
    Quotient,
    Sum,
    Vocabulary,
    defined_names,
)
from kowalevski_cas.notation.layout import StatementTokens
from kowalevski_cas.notation.layout import statements as placed
from kowalevski_cas.notation.open import OpenParser, is_exponential
from kowalevski_cas.notation.primed import primed_names, primed_vectors
from kowalevski_cas.notation.symbol import BOLD
from kowalevski_cas.paper.applied import (
    functions_of,
    printed_arguments,
    with_arguments,
    without_arguments,
)
from kowalevski_cas.paper.chains import without_new_names
from kowalevski_cas.paper.initial_values import names_under_dots, without_initial_values
from kowalevski_cas.paper.names import head
from kowalevski_cas.paper.subscripts import derived_in_index, with_derivatives, with_partials
from kowalevski_cas.paper.summation import without_sums
from kowalevski_cas.problem.space import Meaningless
from kowalevski_cas.reading.antiderivatives import without_integral
from kowalevski_cas.reading.compositions import functions_in, maps_in, written_out
from kowalevski_cas.reading.crosses import matrices_on_vectors
from kowalevski_cas.reading.free_functions import other_times
from kowalevski_cas.reading.letters_of_vectors import letters_of_vectors
from kowalevski_cas.reading.measures import with_divergence, with_jacobian
from kowalevski_cas.reading.quadratures import without_quadrature
from kowalevski_cas.reading.ranks import with_ranks
from kowalevski_cas.source.displays import TypedFormula
from kowalevski_cas.source.listing import guess
from kowalevski_cas.source.tokens import tokens_of


def by_names(formulas: Sequence[TypedFormula]) -> Iterator[TypedFormula]:
    """The formulas, with names that are defined without arguments by these names alone.

    What is derived in an index has primes.
    """
    texts = [formula.tex for formula in formulas]
    by = derived_in_index(texts)
    known = printed_arguments(texts, letters_of_vectors(formulas))
    moving = set[str]().union(*map(names_under_dots, texts))
    times = moving | other_times(texts)
    fields = {} if by else functions_of(texts)
    for formula, tex in zip(formulas, without_new_names(texts), strict=True):
        with suppress(NotationError):  # who reads it says so
            tex = without_initial_values(tex, moving)
        tex = with_jacobian(with_partials(with_derivatives(tex, by), fields))
        tex = with_divergence(without_quadrature(without_integral(tex), times, moving), texts)
        with suppress(ValueError):  # at other arguments it cannot be read
            tex = without_arguments(tex, known)
        yield formula if tex == formula.tex else replace(formula, tex=tex)


def with_printed_arguments(formulas: Sequence[TypedFormula]) -> Iterator[TypedFormula]:
    """The formulas, in which functions have the arguments at which derivatives of them stand."""
    texts = [formula.tex for formula in formulas]
    for formula, tex in zip(formulas, with_arguments(texts), strict=True):
        yield formula if tex == formula.tex else replace(formula, tex=tex)


def without_maps(formulas: Sequence[TypedFormula]) -> Iterator[TypedFormula]:
    """The formulas, with what is said of maps by that to which these take a point."""
    texts = [formula.tex for formula in formulas]
    maps, functions = maps_in(texts), functions_in(texts)
    for formula, tex in zip(formulas, texts, strict=True):
        new = written_out(tex, maps, functions)
        yield formula if new == tex else replace(formula, tex=new)


def vocabulary_of(formulas: Sequence[TypedFormula]) -> Vocabulary:
    """The names of a paper; those with primes are names where rates of some are printed."""
    words = with_ranks(formulas, _letters(formulas), _is_readable)
    found: set[str] = set()
    for formula in formulas:
        with suppress(NotationError, RecursionError):
            found |= {*primed_names(formula.tex, words)}
    of_vectors = found & words.vectors
    for formula in formulas if found else ():
        with suppress(NotationError, RecursionError):
            of_vectors |= {*primed_vectors(formula.tex, words)}
    return replace(
        words,
        scalars=words.scalars | found - of_vectors,
        vectors=words.vectors | of_vectors,
        moving=words.moving | found | of_vectors,
    )


def _letters(formulas: Sequence[TypedFormula]) -> Vocabulary:
    """The letters of a paper; bold capitals are matrices or vectors, as more can be read."""
    euler = all(is_exponential(tokens_of(one.tex)) for one in formulas if "e" in one.tex)
    other = {"d", "e"} if euler else {"d"}
    listed, by_entries = letters_of_vectors(formulas), _matrices(formulas)
    by_entries |= _by_elements(formulas, by_entries) | matrices_on_vectors(f.tex for f in formulas)
    guesses = [
        replace(
            one,
            scalars=one.scalars - other - listed - by_entries,
            vectors=(one.vectors | listed) - by_entries,
            matrices=one.matrices | by_entries,
            times=one.times - listed,
            functions=one.functions.union([r"\exp"] if euler else []) - listed,
        )
        for one in guess(formulas, listed)
    ]
    if guesses[0] == guesses[1]:
        return guesses[0]
    bold = [one for one in formulas if any(mark in one.tex for mark in (*BOLD, r"\vec", r"\bf "))]

    def readable(words: Vocabulary) -> int:
        return sum(
            not trouble for one in bold for _, trouble, _ in read_formula(one, one.tex, words)
        )

    best = max(guesses, key=readable)
    for name in sorted(guesses[1].matrices):
        flipped = replace(best, matrices=best.matrices ^ {name}, vectors=best.vectors ^ {name})
        if readable(flipped) > readable(best):
            best = flipped
    return best


def _is_readable(formula: TypedFormula, words: Vocabulary) -> bool:
    """Whether all statements of a formula can be read."""
    return not any(trouble for _, trouble, _ in read_formula(formula, formula.tex, words))


def _matrices(formulas: Sequence[TypedFormula]) -> frozenset[str]:
    """The letters that are given by their entries, and by nothing else."""
    found: dict[str, bool] = {}
    for formula in formulas:
        with suppress(NotationError, IndexError):
            for heads in defined_names(formula.tex):
                between = len(heads.names) > 1 and not heads.matrix  # as L^*=L
                for name in () if between else heads.names:
                    letter = head(name)[0]
                    found[letter] = heads.matrix and found.get(letter, True)
    return frozenset(name for name, is_matrix in found.items() if is_matrix)


_PAIR = re.compile(r"(?<!\\)\[([^\[\]]*),([^\[\]]*)\]")
_ELEMENT = re.compile(r"(?<![A-Za-z\\])([A-Z])_\{?\w\w\}?\s*&?\s*=")
_TRACE = re.compile(r"\\(?:operatorname|mathrm)\s*\{(?:tr|Tr|Sp)\}|\\(?:tr|Tr|det)(?![A-Za-z])")
_CAPITAL = re.compile(r"(?<![A-Za-z\\])[A-Z](?![A-Za-z_])")


def _by_elements(formulas: Sequence[TypedFormula], known: frozenset[str]) -> frozenset[str]:
    """The letters of which the elements are given, and that have traces, or commutators."""
    given = {letter for one in formulas for letter in _ELEMENT.findall(one.tex)}
    places = ((one.tex, _TRACE.search(one.tex)) for one in formulas)
    traced = (tex[place.end() :] for tex, place in places if place is not None)
    found = {letter for tex in traced for letter in _CAPITAL.findall(tex)} & given
    for pair in (pair for one in formulas for pair in _PAIR.findall(one.tex)):
        beside = [{*_CAPITAL.findall(part)} for part in pair]
        if all(own & (given | known) for own in beside):
            found |= set[str]().union(*beside) & given
    return frozenset(found)


BY_NO_TIME = "a derivative by what is no time"
_RATIO = re.compile(
    r"(?:\\[dt]?frac\s*\{?|/)\s*\\mathrm\s*\{\s*d\s*\}"
    r"|\\[dt]?frac\s*\{?\s*d\b(?!\s*\}\s*(?:[^\sd{]|\{\s*[^\sd\\]))"
    r"|/\s*d\s*(?!\\q?quad)(?:[A-Za-z]|\\[A-Za-z])"
)
"""A differential above a line, or below a slash; where d stands there alone it is a letter."""
_DIFFERENTIALS = ("d", r"\delta", r"\Delta", "D")
"""Letters that nobody prints above a line and below it, unless they make differentials."""


def read_formula(
    formula: TypedFormula, tex: str, words: Vocabulary
) -> Iterator[tuple[Formula | None, str, tuple[int, int]]]:
    """The statements of a formula, each with why it cannot be read, and where it stands."""
    whole = (0, len(formula.tex))
    if formula.trouble:
        yield None, formula.trouble, whole
        return
    try:
        found: Sequence[StatementTokens] = placed(tex)
    except NotationError as error:
        yield None, error.message, whole
        return
    if not found:
        yield None, "there is no formula here", whole
    for tokens, start, end in found:
        try:
            tree = OpenParser(tex, tokens, words).statement()[0]
            why = BY_NO_TIME if _has_differentials(tree, tex) else ""
            yield (None if why else _expanded(tree)), why, (start, end)
        except (NotationError, RecursionError) as error:
            yield None, getattr(error, "message", str(error)), (start, end)


def tree_of(tex: str, number: int, words: Vocabulary) -> Formula:
    """The statement of a number in a display, with d as a letter where it derives by no time."""
    tokens, _, _ = [*placed(tex)][number - 1]
    return OpenParser(tex, tokens, words).statement()[0]


def _expanded(tree: Formula) -> Formula:
    """A formula with its sums written out, where that can be done."""
    try:
        return without_sums(tree)
    except Meaningless:
        return tree


def _has_differentials(tree: Formula, tex: str) -> bool:
    r"""Whether a letter was read as a factor that makes differentials.

    It is d before what stands above or below a line, or any of them that is a factor of what stands
    above a line and of what stands below.
    """
    nodes = [*tree.nodes()]
    ratios = [(node.numerator, node.denominator) for node in nodes if isinstance(node, Quotient)]
    if any(_has_factor(a, d) and _has_factor(b, d) for a, b in ratios for d in _DIFFERENTIALS):
        return True
    return "d" in tree.names() and _RATIO.search(tex) is not None


def are_differentials(members: Sequence[Formula]) -> bool:
    r"""Whether sides of an equation are proportional to differentials: :math:`dx/x=dy/y`.

    Such equations may be laws, or give another time; they claim nothing of their letters.
    """
    return sum(map(_derives_a_letter, members)) > 1


def _has_factor(formula: Formula, letter: str) -> bool:
    """Whether a letter, or a power of it, is a factor of all that is printed in a formula."""
    match formula:
        case Name(name):
            return name == letter
        case Power(inner, _) | Negative(inner) | Quotient(inner, _):
            return _has_factor(inner, letter)
        case Product(factors):
            return any(_has_factor(factor, letter) for factor in factors)
        case Sum(terms):
            return all(_has_factor(term, letter) for term in terms)
    return False


def _derives_a_letter(formula: Formula) -> bool:
    """Whether the letter d stands right before a name in a product."""
    products = (node.factors for node in formula.nodes() if isinstance(node, Product))
    pairs = (pair for factors in products for pair in pairwise(factors))
    return any(one == Name("d") and isinstance(other, Name) for one, other in pairs)
