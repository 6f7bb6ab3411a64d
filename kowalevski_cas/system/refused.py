"""What is refused of equations of motion, with what to print instead."""

from __future__ import annotations

import re
from collections.abc import Collection, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from kowalevski_cas.notation import Derivative, Formula, Name, Partial, Vocabulary, read, to_latex
from kowalevski_cas.notation.cursor import Cursor
from kowalevski_cas.notation.functions import FUNCTIONS
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.notation.symbol import STAR, symbol
from kowalevski_cas.notation.tokens import Token
from kowalevski_cas.paper.claims.forms import moving
from kowalevski_cas.paper.differentials import differentials
from kowalevski_cas.paper.elaborations import Elaborations
from kowalevski_cas.paper.implied import momenta_at_rest
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Display, Printed, Texts
from kowalevski_cas.paper.vocabulary import vocabulary

_INDEX, _NEXT = re.compile("[i-n]"), re.compile(r"[a-z][-+]\d+")
_MIXED = re.compile(r"(?=.*\d)(?=.*[i-n])[\di-n]{2,}")
_SEVERAL, _SUM = re.compile("[i-n]{2,}"), "print the sums, and {}=1,2,3 behind"
_MACRO = re.compile(
    r"\\(?:[a-z]*(?:text|rm|it|sf|box|operatorname|begin|end)\s*\{[^{}]*\}|[A-Za-z]+)"
)
_WORD = re.compile(
    r"(?<![A-Za-z])(?:sin|cos|tan|cot|exp|log|ln|sinh|cosh|tanh|sqrt|where|with|and|for|const|if)"
    "(?![A-Za-z])"
)
_RANGE = re.compile(r"(?<![A-Za-z_{\\])([i-n])\s*=\s*\d\s*,")
_SUMMED = re.compile(r"\\(?:sum|prod)\s*_\s*\{?\s*([i-n])(?![A-Za-z])")
_MOMENTA = {"q": "p"}
_PERMUTATION = re.compile(r"\\(?:var)?epsilon_\{\d{3}\}")
_KRONECKER = re.compile(r"\\delta_\{[i-n]{2}\}")


def check_motion(
    display: Display,
    formulas: Mapping[Printed, Formula],
    laws: Sequence[Printed],
    moving: Collection[str],
    defined: Container[str],
) -> None:
    """Refuse equations that do not tell what moves, and names that are derived and not defined."""
    if not laws:
        raise ValueError(
            f"“{display.tex}” has no equation of motion: print one with a derivative, or H=…, L=…"
        )
    for place in formulas:
        names = place.heads.names
        if names and place not in laws and {*names} <= {*moving}:
            raise ValueError(
                f"{place.tex}: {names[0]} moves by an equation of its own: leave this one out, or "
                "print the equations of motion of what stands in it"
            )
    if len(laws) > len(moving):
        unknowns = f"{len(moving)} unknown{'' if len(moving) == 1 else 's'}"
        raise ValueError(
            f"{len(laws)} equations for {unknowns} ({', '.join(moving)}): "
            "leave one out, or claim it as an identity"
        )
    for name in (one for formula in formulas.values() for one in _derivative_names(formula)):
        if name not in defined:
            raise ValueError(f"{name} is differentiated, and nothing defines it: add {name}=…")


def check_marks(formulas: Iterable[Formula]) -> None:
    """Refuse dots or fractions beside primes, which may be no derivatives by the time."""
    nodes = (node for formula in formulas for node in formula.nodes())
    rates = (n for n in nodes if isinstance(n, Derivative) and n.argument != Name(n.mark))
    marks = {rate.mark: rate.argument for rate in rates}
    if "prime" in marks and len(marks) > 1:
        other = "dots" if "dot" in marks else "d/d" + next(one for one in marks if one != "prime")
        raise ValueError(
            f"{to_latex(marks['prime'])}' stands beside {other}, and a prime is a derivative too: "
            "print dots or primes, and names with indices"
        )


def check_no_differentials(formula: Formula) -> None:
    r"""Refuse :math:`dt=r\,d\tau` among relations of constants."""
    if differentials(formula):
        raise ValueError(f"{to_latex(formula)} is a law: print it beside the equations of motion")


def check_momenta(formulas: Iterable[Formula], moving: Collection[str]) -> None:
    """Refuse a Hamiltonian of which a momentum would be a constant, as none moves it."""
    for name in momenta_at_rest([*formulas], moving):
        raise ValueError(f"{name} stands in the Hamiltonian, and nothing moves it: print its rate")


def check_indices(names: Sequence[str], moving: Collection[str] = ()) -> None:
    """Refuse an index that may stand for numbers which other indices are."""
    symbols = {name: symbol(name) for name in names}
    running = {low for one in moving if _INDEX.fullmatch(low := symbol(one).index)}
    for name, (head, low) in ((name, (one.head, one.index)) for name, one in symbols.items()):
        if _PERMUTATION.fullmatch(name):
            raise ValueError(f"{name} is a name here: write a vector product, or the terms")
        if _KRONECKER.fullmatch(name):
            raise ValueError(f"{name} is a name here: print the sums, and {low[0]},{low[1]}=1,2,3")
        if _NEXT.fullmatch(low):
            raise ValueError(f"{name} has an index that runs: print {low[0]}=1,2,3 behind")
        if _MIXED.fullmatch(low) and any(
            one.head == head and one.index.isdigit() and len(one.index) == len(low)
            for one in symbols.values()
        ):
            raise ValueError(f"{name} stands beside names with numbers: print what runs in it")
        beside = {one.index for one in symbols.values() if one.head == head and one.index != low}
        if not _INDEX.fullmatch(low):
            if running & {*low} and _SEVERAL.fullmatch(low):
                raise ValueError(f"{name} has indices that run: {_SUM.format(low[-1])}")
        elif any(one.isdigit() for one in beside):
            raise ValueError(f"{name} stands beside names with numbers: print {low}=1,2,3 behind")
        elif running and any(map(_INDEX.fullmatch, beside)):
            other = min(one for one in beside if _INDEX.fullmatch(one))
            raise ValueError(f"{name} stands beside {head}_{other}: {_SUM.format(low)}")


def check_ends(tex: str, constants: Iterable[str], moving: Iterable[str]) -> None:
    r"""Refuse what only an index such as i+1 names, and what no row moves: the ends of a chain."""
    printed = {letter + index for letter, index in Cursor(tex, scan(tex), Vocabulary()).letters()}
    chains = {symbol(one).head for one in moving if symbol(one).index}
    for name in constants:
        if symbol(name).head in chains and name not in printed:
            link = symbol(name).head
            raise ValueError(
                rf"{name} ends a chain, and nothing moves it: print {name}=0, or \dot {name}=0 if "
                rf"it is constant, or that the chain is closed, as {link}_{{i+3}}={link}_i"
            )


def check_unit(names: Collection[str]) -> None:
    """Refuse a letter i of which nothing says whether it is the imaginary unit."""
    if "i" in names:
        said = "if it is the imaginary unit, print i^2=-1 beside the equations"
        raise ValueError(f"i is a constant here: {said}; if not, rename it")


def check_words(tex: str) -> None:
    """Refuse words and functions that are typed as letters side by side: each would be a name."""
    if typed := _WORD.search(_MACRO.sub(" ", tex)):
        word = typed[0]
        instead = (
            rf"print \{word}" if rf"\{word}" in FUNCTIONS else "print words outside of formulas"
        )
        raise ValueError(f"“{word}” is a product of letters here: {instead}")


def check_raised(tex: str) -> None:
    """Refuse letters that are derived and raised to 1, or raised to what runs: they have indices.

    Of a sum that is a polynomial, as of x^i, only a letter that has indices below elsewhere may be
    meant so, or a coordinate q beside p_i.
    """
    ranges = {one[1] for one in _RANGE.finditer(tex)}
    summed = {one[1] for one in _SUMMED.finditer(tex)}
    for letter, raised in _raised(scan(tex)):
        low = f"{letter}_{raised}"
        derived = rf"(?:dot|d)\s*\{{?\s*{re.escape(letter)}\s*\}}?\s*\^"
        if raised == "1" and re.search(derived, tex):
            raise ValueError(f"{letter}^1 is no power: print the index below, as {low}")
        others = (letter, _MOMENTA.get(letter, letter))
        beside = any(f"{one}_" in re.sub(r"[\s{}]", "", tex) for one in others)
        if raised in ranges or (raised in summed and beside):
            raise ValueError(f"{letter}^{raised} is a power or has an index: print {low}, or terms")


def _raised(tokens: Sequence[Token]) -> Iterator[tuple[str, str]]:
    """The letters that stand in no index, with one letter, or number, to which they are raised."""
    kinds = [token.kind for token in tokens]
    for k, token in enumerate(tokens):
        is_low = kinds[max(k - 1, 0) : k] == ["_"] or kinds[max(k - 2, 0) : k] == ["_", "{"]
        at = k + 1 + (kinds[k + 1 : k + 2] == ["}"])
        if token.kind != "letter" or token.text == "e" or is_low or kinds[at : at + 1] != ["^"]:
            continue
        first = at + 1 + (kinds[at + 1 : at + 2] == ["{"])
        if first == at + 1 or kinds[first + 1 : first + 2] == ["}"]:
            yield from ((token.text, one.text) for one in tokens[first : first + 1])


def check_stars(constants: Iterable[str], others: Container[str]) -> None:
    """Refuse a star by which a conjugate may be meant: it would be a constant."""
    for name in constants:
        plain = replace(symbol(name), raised="").name
        if symbol(name).raised == STAR and plain in others:
            low = replace(symbol(plain), index="*").name
            raise ValueError(
                rf"{name} is a constant here: print \overline{{{plain}}} for the conjugate of "
                f"{plain}, and {low} for a constant"
            )


def check_derivatives(
    constants: Sequence[str], defined: Container[str], moving: Container[str]
) -> None:
    """Refuse an index that says by what a function is derived: it would be a constant."""
    for name in constants:
        head, by = symbol(name).head, symbol(name).index
        if head in defined and by in moving:
            raise ValueError(
                rf"{name} is a name here: print \partial {head}/\partial {by}, or rename it"
            )


def names_of(constants: Iterable[str], time: str) -> Iterator[str]:
    """The names that are printed so, as they are read.

    Raises ``ValueError`` for what is no name, or the time, or a function.
    """
    for tex in constants:
        try:
            ((letter, index),) = Cursor(tex, scan(tex), Vocabulary()).letters()
            known = Vocabulary(frozenset({letter + index}))
            formula = None if letter in FUNCTIONS else read(tex, known, OpenParser)
        except ValueError:
            formula = None
        if not isinstance(formula, Name) or formula.name == time:
            what = "is the time" if tex == time else "is no name of a constant"
            raise ValueError(f"“{tex}” {what}: give a letter, perhaps with an index, or a word")
        yield formula.name


def check_field(scene: Scene) -> None:
    """Refuse equations of motion with something in them that has no meaning."""
    _ = Elaborations(Texts(vocabulary((scene,))))(scene).field


def check_possible(scene: Scene) -> None:
    """Refuse a scene on which what is supposed is seen to hold nowhere, by ``Contradictory``."""
    _ = Elaborations(Texts(vocabulary((scene,))))(scene).finder


def check_constant(scene: Scene, place: Printed, known: Container[str]) -> None:
    """Refuse a ``known`` constant that a relation gives by what moves: it would be none."""
    space = Elaborations(Texts(vocabulary((scene,))))(scene)
    for name in place.heads.names:
        if name in known:
            names = {*moving(space, Name(name))}
            names |= {scene.time} & space.texts.formula(place).names()
            if names:
                by = ", ".join(sorted(names))
                raise ValueError(f"{place.tex} is no relation of constants, with {by}")


def _derivative_names(formula: Formula) -> list[str]:
    """The names of which partial derivatives are printed."""
    partial = (node.argument for node in formula.nodes() if isinstance(node, Partial))
    return [argument.name for argument in partial if isinstance(argument, Name)]
