r"""Formulas as they are read where nothing is proved of them: more freely than what is judged.

Any letter may derive, as :math:`\theta` in :math:`\frac{d^2u}{d\theta^2}`; lists of letters
behind a letter are arguments, and so is what always stands in brackets behind a bold one; a
:math:`\Delta` belongs to the letter behind it, unless it stands alone somewhere.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace

from kowalevski_cas.algebra.quadrature import INTEGRAL
from kowalevski_cas.notation import (
    Derivative,
    Formula,
    Name,
    NotationError,
    Number,
    Partial,
    Power,
    Product,
    Summation,
    Vocabulary,
    times,
)
from kowalevski_cas.notation.layout import statements as placed
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.open import OpenParser, independent
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.claims.measure import DIVERGENCE
from kowalevski_cas.paper.summation import expand_sum, without_sums
from kowalevski_cas.reading.components import NABLA, is_derived_vector
from kowalevski_cas.reading.definite_integrals import DIFFERENTIAL, without_integrals
from kowalevski_cas.reading.statements import SourcePaper, SourceStatement

TERMS = 2
"""How many terms a sum has of which the number is a letter."""

_LETTER = r"(?:[A-Za-z]|\\[a-z]+)"
_ARGUMENTS = re.compile(rf"(?P<of>{_LETTER}'*)\s*\(\s*{_LETTER}(?:\s*,\s*{_LETTER})+\s*\)")
"""A list of letters behind a letter: it is at these that a function is taken."""
_CAPITAL = re.compile(r"(?<![A-Za-z\\])([A-Z])(?![A-Za-z])\s*(\()?")
_AT_LETTER = re.compile(rf"(?P<of>{_LETTER}(?:_\w)?)\s*\(\s*{_LETTER}\s*\)")
_PRIMED_AT = re.compile(rf"(?P<of>{_LETTER}(?:_\w)?)'*\s*\((?P<at>\s*{_LETTER}(?:_\w)?\s*)\)")
_OF_TIME = re.compile(rf"(?P<of>{_LETTER}(?:_(?:\w|\{{\w+\}}))?)\s*\(\s*t\s*\)")
_DOTTED = re.compile(rf"\\d?dot\s*\{{?\s*({_LETTER}(?:_\w)?)")
_BOLD = r"\\(?:mathbf|boldsymbol|bm|vec)\s*\{\s*(?:[A-Za-z]|\\[A-Za-z]+)\s*\}(?:_\{?\w+\}?)?"
_LISTED = rf"(?:{_BOLD}|\\d?dot\s*\{{\s*{_BOLD}\s*\}})"
_BOLD_FUNCTION = re.compile(
    rf"(?P<of>{_BOLD})(?P<raised>\^\{{-1\}})?\s*\((?P<at>\s*{_LISTED}(?:\s*,\s*{_LISTED})*\s*)\)"
)
"""A bold letter with what is, or may be, its arguments."""
_TWICE = re.compile(r"\\sum_\{\s*([a-z])\s*,\s*([a-z])\s*=\s*(\d)\s*\}\s*\^(\w|\{\w\})")
"""A sum over two indices."""
_OF_RATE = re.compile(r"\\partial\s*(?P<of>[A-Za-z])'")
_RATE = "_{999}"
"""The index of a name that stands for that with a prime by which something is derived."""
_REST = re.compile(
    r"(?P<sign>[+-])\s*(?:\\mathcal\s*\{?\s*O\s*\}?|[Oo])\s*"
    r"(?:\\left\s*\(.*?\\right\s*\)|\([^()]*\))"
)
_SOME_CONSTANT = re.compile(
    r"\\(?:text|mathrm|mbox)\s*\{\s*const(?:ant)?\.?\s*\}(?=\s*(?:\\,\s*)?[+-])"
)
"""A constant of which nothing is said, before other terms."""
_LIMIT = re.compile(
    r"\\lim(?:\\limits)?\s*_\s*\{\s*(?:[A-Za-z]|\\[a-z]+)\s*\\(?:to|rightarrow)\s*"
    r"(?:0|\\infty)\s*\}(?P<of>[^=]*)="
)
_DELTA = r"\Delta"
_IN_BOLD = r"\\(?:mathbf|boldsymbol|bm|vec)(?:\s*\{[^{}]*\}|\s+[A-Za-z]|\s*\\[A-Za-z]+)"
_OF_NABLA = re.compile(
    rf"\\nabla\s*(?P<sign>\\times\s*(?=\\)|\\cdot\s*(?=\\)|\^\s*\{{?\s*2\s*\}}?\s*)?"
    rf"(?P<of>{_IN_BOLD}|{_LETTER}(?![A-Za-z]))(?!\s*[_^'(])"
)
"""A gradient, curl or divergence of what is named by a letter, or what Laplace's operator makes."""
_AT_VALUE = re.compile(rf"(?P<of>{_LETTER}'+)\s*\(\s*(?P<at>{_LETTER}_(?:\w|\{{\w+\}}))\s*\)")
"""The derivative of a function at a value that has an index."""
_FIRST_GRADIENT = 900
"""The index of what stands for the first one."""


def free_formulas(
    paper: SourcePaper, items: Sequence[SourceStatement]
) -> dict[SourceStatement, Formula]:
    """The formula of each statement that can be read."""
    found: dict[SourceStatement, Formula] = {}
    texts = [one.typed.tex for one in items]
    whole = paper.expanded.text
    functions = _bold_functions([whole[one.typed.start : one.typed.end] for one in items])
    words = paper.words
    by = {name for tex in texts for name in _independent(tex)}
    applied = {m["of"].rstrip("'") for tex in texts for m in _ARGUMENTS.finditer(tex)}
    single = _single(texts, words.functions)
    words = replace(
        words,
        times=words.times | by,
        functions=words.functions - applied - functions - single | {INTEGRAL},
    )
    gradients: dict[str, str] = {}
    for one in items:
        tex = _with_divergence(one.printed.display.tex, whole[one.typed.start : one.typed.end])
        tex = _without_arguments(tex, functions | single)
        tex = _without_gradients(without_integrals(_with_ellipses(tex)), gradients)
        if one.formula is not None:
            found[one] = one.formula
            if tex == one.printed.display.tex and "d" not in one.names:
                continue
        for own, printed in (
            (words, tex),
            (_with_one_component(words), tex),
            (_with_functions(words, single_functions(paper)), tex),
            (words, _OF_TIME.sub(lambda m: m["of"], tex)),
        ):
            with suppress(NotationError, RecursionError, IndexError):
                vectors = {one for one in gradients if symbol(one).is_bold}
                own = replace(own, vectors=own.vectors | vectors)
                found[one] = _named(_read(printed, one.printed.number, own), gradients)
                break
    for sign, of in ((Name(_DELTA), _difference), (Name(DIFFERENTIAL), _differential)):
        if not any(sign in _alone(tree, sign) for tree in found.values()):
            found = {one: _with_signs(tree, sign, of) for one, tree in found.items()}
    return found


def single_functions(paper: SourcePaper) -> dict[str, str]:
    """The unknown functions of one argument, by their names, with what they are functions of."""
    every = {name: {one.by for one in own} for name, own in paper.functions_by_name.items()}
    return {name: by[0] for name, own in every.items() for by in own if len(own) == len(by) == 1}


def arguments(paper: SourcePaper, items: Sequence[SourceStatement]) -> dict[str, str]:
    """The functions that stand at one letter wherever they are applied, each with it.

    None is a function of the time, nor printed with a dot: then it moves.
    """
    at: dict[str, set[str]] = {name: {by} for name, by in single_functions(paper).items()}
    texts = [one.typed.tex for one in items]
    for match in (match for tex in texts for match in _PRIMED_AT.finditer(tex)):
        at.setdefault(match["of"], set()).add(match["at"].strip())
    dotted = {found[1] for tex in texts for found in _DOTTED.finditer(tex)}
    found = {name: min(by) for name, by in at.items() if len(by) == 1 and "'" not in name}
    return {name: by for name, by in found.items() if by != "t" and name not in dotted}


def _with_functions(words: Vocabulary, functions: Collection[str]) -> Vocabulary:
    """The names, with functions that stand at other arguments as well, as F(1/u)."""
    names = frozenset(functions)
    return replace(words, functions=words.functions | names, scalars=words.scalars - names)


def _with_one_component(words: Vocabulary) -> Vocabulary:
    """The names, with numbers for vectors and matrices: then a vector and a matrix are added."""
    scalars = words.scalars | words.vectors | words.matrices
    return replace(words, scalars=scalars, vectors=frozenset(), matrices=frozenset())


def with_gradients(words: Vocabulary, formulas: Iterable[Formula]) -> Vocabulary:
    """The names, with those of gradients among the vectors."""
    names = {name for one in formulas for name in one.names() if is_derived_vector(name)}
    return replace(words, vectors=words.vectors | names)


def _with_divergence(tex: str, printed: str) -> str:
    """A display with the divergence that is printed, where it is read as that of the motion."""
    found = re.search(rf"\\nabla\s*\\cdot\s*{_IN_BOLD}", printed)
    return tex if found is None else tex.replace(DIVERGENCE, found[0])


def _without_gradients(tex: str, names: dict[str, str]) -> str:
    """A display with letters for what is named by one: gradients and the like, which are entered.

    So are derivatives at values.
    """

    def letter(name: str) -> str:
        known = next((one for one, named in names.items() if named == name), "")
        bold = r"\mathbf{N}" if is_derived_vector(name) else "N"
        known = known or f"{bold}_{{{_FIRST_GRADIENT + len(names)}}}"
        names[known] = name
        return f" {known}"

    def of_nabla(found: re.Match[str]) -> str:
        (of,) = (token.text for token in scan(found["of"]))
        sign = re.sub(r"[\s{}]", "", found["sign"] or "")
        return letter(f"{NABLA.strip()}{sign} {of}")

    with suppress(NotationError, ValueError):
        tex = _AT_VALUE.sub(lambda m: letter(f"{m['of']}({m['at']})"), tex)
        return _OF_NABLA.sub(of_nabla, tex)
    return tex


def _named(formula: Formula, names: Mapping[str, str]) -> Formula:
    """A formula with other names."""
    if isinstance(formula, Name):
        return Name(names[formula.name]) if formula.name in names else formula
    return formula.map_children(lambda child: _named(child, names))


def _read(tex: str, number: int, words: Vocabulary) -> Formula:
    """The statement of a number in a display, in which primes may stand behind a ∂."""
    marked = _OF_RATE.sub(lambda m: rf"\partial {m['of']}{_RATE}", tex)
    tokens, _, _ = [*placed(marked)][number - 1]
    rates = {f"{m['of']}{_RATE}" for m in _OF_RATE.finditer(tex)}
    words = replace(words, scalars=words.scalars | rates)
    return _primed(OpenParser(marked, tokens, words).statement()[0])


def _primed(formula: Formula) -> Formula:
    formula = formula.map_children(_primed)
    if isinstance(formula, Partial) and formula.by.endswith(_RATE):
        return replace(formula, by=formula.by.removesuffix(_RATE) + "'")
    return formula


def _independent(tex: str) -> list[str]:
    with suppress(NotationError):
        return independent(tex)
    return []


def _without_arguments(tex: str, bold: set[str]) -> str:
    """A display without the arguments of its functions."""
    tex = _ARGUMENTS.sub(lambda m: m["of"], _with_single_sums(tex))
    tex = _ARGUMENTS.sub(lambda m: m["of"], tex)  # of what was an argument itself
    tex = _AT_LETTER.sub(lambda m: m["of"] if m["of"] in bold else m[0], tex)
    return _BOLD_FUNCTION.sub(
        lambda m: m["of"] + (m["raised"] or "") if m["of"] in bold else m[0], tex
    )


def _single(texts: list[str], functions: frozenset[str]) -> set[str]:
    """The functions of one letter that are printed without it as well."""
    found = {m["of"] for tex in texts for m in _AT_LETTER.finditer(tex)} & functions
    bare = (rf"(?<![A-Za-z\\]){re.escape(name)}(?!\s*[\w('])" for name in found)
    pairs = zip(found, bare, strict=True)
    return {name for name, one in pairs if any(re.search(one, tex) for tex in texts)}


def _always_applied(texts: list[str]) -> set[str]:
    """The capital letters that have a bracket behind them wherever they stand."""
    bare = {m[1] for tex in texts for m in _CAPITAL.finditer(tex) if not m[2]}
    return {m[1] for tex in texts for m in _CAPITAL.finditer(tex) if m[2]} - bare


def _with_ellipses(tex: str) -> str:
    """A display with dots for terms of an order, and for some constant; and ≈ for a limit."""
    tex = _SOME_CONSTANT.sub(r"\\dots ", _REST.sub(lambda m: rf"{m['sign']}\dots ", tex))
    return _LIMIT.sub(lambda m: rf"\;{m['of']}\approx", tex)


def _with_single_sums(tex: str) -> str:
    """A display in which each sum is over one index, and commas stand between two of them."""
    for first, second, *_ in _TWICE.findall(tex):
        tex = re.sub(rf"_\{{\s*{first}\s*{second}\s*\}}", f"_{{{first},{second}}}", tex)
    return _TWICE.sub(r"\\sum_{\1=\3}^\4\\sum_{\2=\3}^\4", tex)


def _bold_functions(texts: list[str]) -> set[str]:
    """The bold letters that have one list of arguments behind them wherever they stand."""
    at: dict[str, set[str]] = {}
    count: dict[str, int] = {}
    for tex in texts:
        for match in _BOLD_FUNCTION.finditer(tex):
            at.setdefault(match["of"], set()).add(match["at"])
            count[match["of"]] = count.get(match["of"], 0) + 1
    whole = {name: sum(tex.count(name) for tex in texts) for name in at}
    return {name for name in at if len(at[name]) == 1 and count[name] == whole[name] > 1}


# -- differences and differentials ---------------------------------------------------------


def _alone(formula: Formula, sign: Name) -> Iterator[Formula]:
    r"""The names in a formula, but for each Δ, or d, that stands before a letter in a product."""
    waiting = [formula]
    while waiting:
        node = waiting.pop()
        children = node.children()
        if isinstance(node, Product):
            behind = (*children[1:], Number(1))
            children = tuple(
                one
                for one, other in zip(children, behind, strict=True)
                if one != sign or _letter(other) is None
            )
        yield node
        waiting += children


def _letter(node: Formula) -> Name | None:
    base = node.base if isinstance(node, Power) else node
    return base if isinstance(base, Name) else None


def _with_signs(formula: Formula, sign: Name, of: Callable[[Name], Formula]) -> Formula:
    """A formula in which each sign and the letter behind it are one."""
    formula = formula.map_children(lambda child: _with_signs(child, sign, of))
    if not isinstance(formula, Product) or sign not in formula.factors:
        return formula
    found: list[Formula] = []
    for factor in formula.factors:
        letter = _letter(factor)
        if found[-1:] == [sign] and letter is not None:
            whole = of(letter)
            found[-1] = Power(whole, factor.exponent) if isinstance(factor, Power) else whole
        else:
            found.append(factor)
    return times(*found)


def _difference(letter: Name) -> Formula:
    return Name(f"{_DELTA} {letter.name}")


def _differential(letter: Name) -> Formula:
    """A differential is a derivative, by what nobody prints."""
    return Derivative(letter, DIFFERENTIAL)


# -- sums ----------------------------------------------------------------------------------


def instances(formula: Formula) -> Iterator[Formula]:
    """A formula with its sums written out; for each value of an index that is free in it."""
    bound = {node.index for node in formula.nodes() if isinstance(node, Summation)}
    written = without_sums(_bounded(formula))
    free = {symbol(name).index for name in written.names()} & {"i", "j", "k"}
    if len(free - bound) != 1:
        yield written
        return
    (index,) = free - bound
    for value in range(1, TERMS + 1):
        yield expand_sum(Summation(index, Number(value), Number(value), written))


def _bounded(formula: Formula) -> Formula:
    """A formula with a number for the letter up to which a sum goes."""
    if isinstance(formula, Summation) and isinstance(formula.last, Name):
        formula = replace(formula, last=Number(TERMS))
    return formula.map_children(_bounded)
