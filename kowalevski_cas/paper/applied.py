r"""Names at the arguments on which they depend: :math:`L(\lambda)`, :math:`V(q_1,q_2)` beside V=….

The name stands for a formula, and the arguments say again what is in it. At other arguments it
would be something else, which is refused.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress

from kowalevski_cas.notation import NotationError, defined_names
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.paper.initial_values import names_under_dots
from kowalevski_cas.paper.names import head

SPECTRAL = (r"\lambda", r"\zeta", r"\mu", r"\xi")
"""The letters of a parameter on which matrices depend, and which does not move."""

_NAME = r"(?:\\[A-Za-z]+|[A-Za-z])(?:_(?:\w|\{[^{}]*\}))?"
_LISTED = re.compile(
    rf"\s*(?:\\left\s*)?\(\s*(?P<by>{_NAME}(?:\s*,\s*{_NAME})*)\s*(?:\\right\s*)?\)"
)
_OPENED = re.compile(r"\s*(?:\\left\s*)?\(")
_PRIMED = re.compile(r"\s*'+\s*\(")


def printed_arguments(texts: Iterable[str], vectors: Collection[str] = ()) -> dict[str, str]:
    r"""The names that displays define, with the arguments at which these have them.

    Of vectors it would be a scalar product.

    >>> printed_arguments([r"L(\lambda)=\begin{pmatrix}\lambda&x\\y&0\end{pmatrix}"])
    {'L': '\\lambda'}
    >>> printed_arguments([r"H=\frac12(p_1^2+p_2^2)+V(q_1,q_2), V=q_1^2q_2"])
    {'V': 'q_1,q_2'}

    What depends on a parameter may stand alone, if it is printed at nothing else.

    >>> printed_arguments([r"L(\lambda)=M+\lambda A, \dot L=LN-NL"])
    {'L': '\\lambda'}
    >>> printed_arguments([r"L(\lambda)=M+\lambda A, \dot L=0, L(0)=M"])
    {}

    What stands in brackets may be a factor, where it is not in the definition.

    >>> printed_arguments(["a=b+c, y=a(x)"]), printed_arguments(["V=x^2+y, y=2V(x)"])
    ({}, {'V': 'x'})
    """
    texts = [*texts]
    found = collective_arguments(texts) | arguments_said_once(texts)
    for tex in texts:
        with suppress(NotationError, IndexError):
            for place in defined_names(tex):
                for name, by in map(head, place.names):
                    spectral = len(by) == 1 and symbol(by[0]).letter in SPECTRAL
                    if spectral and (place.matrix or _stands_alone(name, by[0], texts)):
                        found[name] = by[0]
                    elif not by and (listed := _arguments(name, texts, vectors)):
                        found[name] = listed
    return found


def collective_arguments(texts: Iterable[str]) -> dict[str, str]:
    r"""The names that displays define at letters which stand for all names with an index.

    >>> collective_arguments(["H(q,p)=p_1^2+q_1q_2", "F(x)=x^2+x_1"])
    {'H': 'q,p'}
    """
    texts, found = [*texts], dict[str, str]()
    for tex in texts:
        with suppress(NotationError, IndexError):
            for place in defined_names(tex):
                for name, by in map(head, place.names):
                    if by and _stand_for_all(name, by, texts):
                        found[name] = ",".join(by)
    return found


_DOTTED = rf"(?:\\d?dot\s*(?:\{{\s*{_NAME}\s*\}}|{_NAME})|{_NAME})"
_DEFINED = re.compile(
    rf"(?<![A-Za-z\\}}^_])(?P<name>{_NAME})\s*\(\s*(?P<by>{_DOTTED}(?:\s*,\s*{_DOTTED})*)\s*\)"
    r"\s*&?\s*=(?P<body>[^=]*)"
)

_ACCENTED = re.compile(
    rf"\\(?:d{{1,3}}ot|(?:wide)?(?:tilde|hat)|bar|overline)\s*(?:\{{\s*{_NAME}\s*\}}|{_NAME})"
)
"""A name with an accent: a rate, or another name."""
_UPRIGHT = re.compile(
    r"\\(?:operatorname\*?|mathrm|text|label|ref|begin|end)\s*\{[^{}]*\}|\\(?!left|prime)[A-Za-z]+"
)
"""What prints no letter that stands for anything."""


def arguments_said_once(texts: Iterable[str]) -> dict[str, str]:
    r"""The names that one display defines at arguments, and that stand alone everywhere else.

    >>> arguments_said_once([r"J(q,\dot q)=q^2+\dot q^2", r"\frac{\partial J}{\partial q}=2q"])
    {'J': 'q,\\dot q'}

    Where another display has it at something, or gives it by its name alone, it is another thing;
    but at several arguments that all move, or the time, it is what is taken along the motion.

    >>> arguments_said_once(["f(x)=x^2", "f=f(a)"]), arguments_said_once(["E(k)=k^2", "E=2, 3E=6"])
    ({}, {})
    >>> arguments_said_once(["H(q,p)=qp", r"\dot q=q, \dot p=-p", r"\dot H=0", r"H(q,p)=H(a,b)"])
    {'H': 'q,p'}
    """
    texts, found = [*texts], dict[str, str]()
    letters = [_UPRIGHT.sub(" ", tex) for tex in texts]
    plain = [_ACCENTED.sub(" ", tex) for tex in texts]
    moving = set[str]().union(*map(names_under_dots, texts))
    for place in (match for tex in texts for match in _DEFINED.finditer(tex)):
        name, by = place["name"], re.sub(r"\s*,\s*", ",", place["by"])
        printed = letters if name.isalpha() and len(name) == 1 else texts
        letter = rf"(?<!\\){re.escape(name)}(?![A-Za-z_])" if printed is texts else f"{name}(?!_)"

        def count(behind: str, letter: str = letter, texts: list[str] = printed) -> int:
            return sum(len(re.findall(letter + behind, tex)) for tex in texts)

        calls, primed = count(r"\s*(?:\\left\s*)?\("), count(r"\s*(?:'|\^\{?\\prime)")
        given = any(re.search(rf"{letter}\s*&?\s*=", tex) for tex in plain)
        alone = count("") > 1 and not (primed or given)
        listed = re.escape(by).replace(",", r"\s*,\s*")
        derived = re.compile(rf"\}}\s*\(\s*{listed}\s*\)")  # as \frac{\partial H}{\partial p}(q,p)
        along = "," in by and {*by.split(",")} - {"t"} <= moving
        once = (calls == 1 or along) and alone and not any(map(derived.search, texts))
        if once and re.search(re.escape(by.split(",")[0]), place["body"]):
            found[name] = by
    return found


def functions_of(texts: Iterable[str]) -> dict[str, str]:
    r"""The functions of several letters that displays define, with no component that is one too.

    >>> functions_of(["u(x,t)=x-ct", "u_t+u u_x=0"]), functions_of(["v(x,t)=x+t, 2v=v_x, v_x=2"])
    ({'u': 'x,t'}, {})
    """
    texts = [*texts]

    def has_component(name: str) -> bool:
        own = re.compile(rf"(?:^|[,&])\s*{re.escape(name)}_\{{?\w\}}?\s*&?\s*=")
        return any(map(own.search, texts))

    found = arguments_said_once(texts)
    return {name: by for name, by in found.items() if "," in by and not has_component(name)}


def _stand_for_all(name: str, by: Collection[str], texts: Iterable[str]) -> bool:
    """Whether arguments say which names with an index stand in a definition, as q in H(q)=q_1^2."""
    listed = r"\s*,\s*".join(map(re.escape, by))
    head_of = (
        rf"(?<![A-Za-z\\_]){re.escape(name)}\s*(?:\\left\s*)?\(\s*{listed}\s*(?:\\right\s*)?\)"
    )
    bodies = [m[1] for tex in texts for m in re.finditer(head_of + r"\s*&?\s*=([^=]*)", tex)]
    return bool(bodies) and all(
        re.search(rf"(?<![A-Za-z\\_]){re.escape(one)}\s*_", body)
        and not re.search(rf"(?<![A-Za-z\\_]){re.escape(one)}(?!\s*_)(?![A-Za-z])", body)
        for one in by
        for body in bodies
    )


def _arguments(name: str, texts: Iterable[str], vectors: Collection[str]) -> str:
    """The one list of arguments of a name elsewhere; empty if they are not all in what it is."""
    texts = [tex for tex in texts if name in tex]  # most displays of a long paper have no such name
    letter = rf"(?<![A-Za-z\\_]){re.escape(name)}"
    places = [(tex, found.end()) for tex in texts for found in re.finditer(letter, tex)]
    if any(_PRIMED.match(tex, end) for tex, end in places):
        return ""  # it is derived, and taken at arguments: it is a function
    every = (_LISTED.match(tex, end) for tex, end in places)
    lists = {re.sub(r"\s+", "", match["by"]) for match in every if match}
    if len(lists) != 1:
        return ""
    (listed,) = lists
    definition = rf"{letter}\s*=(?P<by>[^=]*)"
    defining = " ".join(match["by"] for tex in texts for match in re.finditer(definition, tex))
    inside = all(
        re.search(rf"(?<![A-Za-z\\_]){re.escape(argument)}(?![A-Za-z])", defining)
        for argument in listed.split(",")
    )
    return listed if inside and {*listed.split(",")}.isdisjoint(vectors) else ""


def _stands_alone(name: str, by: str, texts: Iterable[str]) -> bool:
    """Whether a name is printed alone somewhere, at this argument elsewhere, and never derived."""
    letter = rf"(?<![A-Za-z\\_]){re.escape(name)}(?![A-Za-z_])"
    behind = [tex[found.end() :] for tex in texts for found in re.finditer(letter, tex)]
    called = [_LISTED.match(rest) for rest in behind if _OPENED.match(rest)]
    if any(_PRIMED.match(rest) for rest in behind) or len(called) == len(behind):
        return False
    return all(one is not None and one["by"].strip() == by for one in called)


_LETTER = r"(?:[A-Za-z]|\\[A-Za-z]+)"
_PRIMED = re.compile(
    rf"(?<![A-Za-z\\])(?P<name>{_LETTER})'+\s*(?:\\left\s*)?\(\s*(?P<by>{_LETTER})\s*(?:\\right\s*)?\)"
)


def with_arguments(texts: Sequence[str]) -> Iterator[str]:
    r"""Formulas, in which what gives a function has its argument, if that stands at a derivative.

    So :math:`U=\cos\theta` gives :math:`U(\theta)`, beside :math:`U'(\theta)`. A function that is
    printed at arguments itself has them.

    >>> [*with_arguments([r"U=\theta^2", r"U'(\theta)=2\theta"])]
    ['U(\\theta)=\\theta^2', "U'(\\theta)=2\\theta"]
    """
    found: dict[str, set[str]] = {}
    for tex in texts:
        for one in _PRIMED.finditer(tex):
            found.setdefault(one["name"], set()).add(one["by"])
    for name, by in [*found.items()]:
        applied = re.compile(rf"(?<![A-Za-z\\]){re.escape(name)}\s*(?:\\left\s*)?\(")
        if len(by) > 1 or any(map(applied.search, texts)):
            del found[name]
    for tex in texts:
        for name, (argument,) in found.items():
            if re.search(rf"{re.escape(argument)}(?![A-Za-z])", tex):
                first = rf"((?:^|[,&]|\\q?quad|\\\\)\s*{re.escape(name)})(?=\s*&?\s*=)"
                at = argument.replace("\\", r"\\")
                tex = re.sub(first, rf"\1({at})", tex)
        yield tex


def without_arguments(tex: str, known: Mapping[str, str]) -> str:
    r"""A display with these names alone, as L for :math:`L(\lambda)`, as long as it was.

    Raises ``ValueError`` for one at anything else.
    """
    for name, by in known.items():
        letter = rf"(?<![A-Za-z\\_])(?P<name>{re.escape(name)})\s*(?:\\left\s*)?\("
        listed = r"\s*,\s*".join(map(re.escape, by.split(",")))
        call = rf"{letter}\s*{listed}\s*(?:\\right\s*)?\)"
        # filled up to the same length: errors point at places of the text as it was printed
        tex = re.sub(call, lambda found: f"{{{found['name']}}}".ljust(len(found[0])), tex)
        if other := re.search(letter, tex):
            what = tex[other.start() : other.start() + 12]
            raise ValueError(
                f"{name} is printed at {by}; at another argument, {what}…, is not known"
            )
    return tex
