r"""Maps: :math:`x_{n+1}=y_n,\; y_{n+1}=-x_n`, or :math:`x'=y,\; y'=-x` where that is said.

A name with the index :math:`n+1` is the image of the one with n, and so on from the first step that
is printed, as :math:`n-1`, to the last, as :math:`n+4`. Equations that do not give the images are
solved for them.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from itertools import chain

from kowalevski_cas.notation import Derivative, Formula, Name, Relation, Vocabulary
from kowalevski_cas.notation.cursor import Cursor
from kowalevski_cas.notation.layout import split_display
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.notation.macros import SPELLING
from kowalevski_cas.notation.symbol import symbol
from kowalevski_cas.notation.tokens import Token
from kowalevski_cas.paper.amplitudes import conjugate_images, with_conjugates
from kowalevski_cas.paper.images import images_by_index, solutions
from kowalevski_cas.paper.implied import canonical_brackets, conjugate_pairs
from kowalevski_cas.paper.names import BRACKET, head
from kowalevski_cas.paper.scene import Scene
from kowalevski_cas.paper.texts import Display, Printed
from kowalevski_cas.system.refused import check_unit
from kowalevski_cas.system.roots import with_roots
from kowalevski_cas.system.rows import Names, read_rows, vocabulary_of
from kowalevski_cas.system.scenes import with_row
from kowalevski_cas.system.vectors import Vectors

STEP = "+1"
_LETTER = r"(?:[A-Za-z]|\\[A-Za-z]+)"
_ACCENT = r"\\(?P<accent>overline|bar|(?:wide)?tilde|(?:wide)?hat)"
_BAR = re.compile(
    rf"{_ACCENT}(?![A-Za-z])\s*(?:\{{\s*(?P<braced>{_LETTER})\s*\}}|(?P<letter>{_LETTER}))"
    r"(?P<index>\s*_\s*(?:\w|\{\s*\w+\s*\}))?"
)
_OVER = rf"(?:(?:{_ACCENT}|\\underline)(?![A-Za-z])\s*)?"
_COUNTED = r"\s*_\s*(?:\w|\{\s*\w\s*(?:[-+]\s*\d\s*)?\})"
_STEP = (
    re.compile(rf"{_OVER}\{{?\s*(?P<letter>{_LETTER})\s*\}}?\s*=\s*(?P=letter){_COUNTED}"),
    re.compile(rf"(?P<letter>{_LETTER}){_COUNTED}\s*=\s*{_OVER}\{{?\s*(?P=letter)\s*\}}?"),
)


def index_of_map(tex: str) -> str:
    r"""The index that counts the steps of a map, if a display is one; nothing for equations.

    >>> index_of_map(r"x_{n+1}=y_n, y_{n+1}=-x_n"), index_of_map(r"\dot u_i=u_{i+1}")
    ('n', '')

    The index of a sum counts something else.

    >>> index_of_map(r"H=\sum_{i=1}^2q_iq_{i+1}"), index_of_map(r"x_{n+1}=2x_n, n=0,1,2")
    ('', 'n')
    """
    # Brackets say nothing of steps, as those of a closed chain.
    for start, end in reversed(split_display(tex) if r"\{" in tex else ()):
        tex = tex[:start] + tex[end:] if tex[start:end].lstrip().startswith(r"\{") else tex
    tokens = scan(tex)
    letters = [letter + index for letter, index in Cursor(tex, tokens, Vocabulary()).letters()]
    if any(token.kind == "prime" or token.text == "d" or _is_dot(token) for token in tokens):
        return ""
    steps = {symbol(name).index[:-2] for name in letters if symbol(name).index.endswith(STEP)}
    here = {symbol(name).index for name in letters}
    bound = set(re.findall(r"\\(?:sum|prod)\s*_\s*\{?\s*([A-Za-z])", tex))
    found = [one for one in steps - bound if len(one) == 1 and one.isalpha() and one in here]
    return found[0] if len(found) == 1 else ""


def _is_dot(token: Token) -> bool:
    return token.kind == "accent" and "dot" in token.text


def images_by_primes(formulas: Collection[Formula]) -> dict[str, str]:
    """The variables of a map that is printed with primes, with their images."""
    nodes = chain.from_iterable(formula.nodes() for formula in formulas)
    primed = (n.argument for n in nodes if isinstance(n, Derivative) and n.mark == "prime")
    images = {one.name: f"{one.name}'" for one in primed if isinstance(one, Name)}
    names = dict.fromkeys(name for formula in formulas for name in sorted(formula.names()))
    before = {name: name_under(name) for name in names if name_under(name) != name}
    return images | before


def name_under(name: str) -> str:
    r"""The name above a line, as x for :math:`\underline x`; itself, if there is no line."""
    parts = symbol(name)
    kept = parts.accents[1:] if parts.accents[:1] == (r"\underline",) else parts.accents
    return replace(parts, accents=kept).name


def has_bars(tex: str) -> bool:
    r"""Whether bars, tildes or hats stand over letters of a map, and no primes behind them.

    They stand over images then, if they are of one kind.

    >>> has_bars(r"\overline x=ax+\underline x"), has_bars(r"z'=z|z|^2\bar z")
    (True, False)
    >>> has_bars(r"\widetilde x=\tilde y"), has_bars(r"\tilde x=\hat ax")
    (True, False)
    """
    accents = {
        SPELLING.get(f"\\{bar['accent']}", f"\\{bar['accent']}") for bar in _BAR.finditer(tex)
    }
    return not re.search(r"'|\\prime", tex) and len(accents) == 1


def with_primes(tex: str) -> str:
    r"""A map with primes for the bars over images, as in :math:`\overline x+x+\underline x=0`.

    >>> with_primes(r"\overline x+x+\underline x=\frac a{\bar{q}_1}")
    "x'+x+\\underline x=\\frac a{q_1'}"
    """

    def image(bar: re.Match[str]) -> str:
        joined = tex[: bar.start()][-1:].isalpha()  # to a macro before it
        return f"{' ' * joined}{bar['braced'] or bar['letter']}{bar['index'] or ''}'"

    return _BAR.sub(image, tex)


def without_steps(tex: str) -> str:
    r"""A map without what only says how its steps are printed, as :math:`\overline x=x_{n+1}`.

    >>> without_steps(r"\overline x+\underline x=ax, x=x _n, x_{ n+1 }=\overline {x}")
    '\\overline x+\\underline x=ax, , '
    """
    for start, end in reversed(split_display(tex)):
        if any(one.fullmatch(tex[start:end].strip()) for one in _STEP):
            tex = tex[:start] + tex[end:]
    return tex


class Map:
    """The equations of a map: rows that give an image, equations for images, and all others.

    Raises ``ValueError`` if there is no image, or not one equation for each.
    """

    def __init__(self, display: Display, vectors: Vectors, declared: Names, index: str) -> None:
        self.display, words = display, vocabulary_of(display, vectors, declared)
        printed = read_rows(display, words).values()
        nodes = (node for formula in printed for node in formula.nodes())
        names = dict.fromkeys(node.name for node in nodes if isinstance(node, Name))
        self.images = images_by_index(names, index) if index else images_by_primes([*printed])
        """The variables with the names of their images."""
        if not self.images:
            tex = display.tex
            raise ValueError(f"“{tex}” is no map: print x_{{n+1}}=…, or x'=…, for each variable")
        self.new = [one for one in self.images.values() if one not in self.images]
        self.words = replace(words, scalars=words.scalars.union(self.images.values()))
        self.formulas = read_rows(display, self.words)
        rows = self.formulas.items()
        given = {one: place for one in self.new for place, f in rows if _gives(f, one)}
        self.rows = {one: p for one, p in given.items() if one not in self._needed(one, given)}
        self.others = [place for place, f in rows if f.names().isdisjoint(self.new)]
        known = {*self.others, *self.rows.values()}
        self.implicit = [place for place in self.formulas if place not in known]
        self.left = [one for one in self.new if one not in self.rows]

    def _needed(self, name: str, given: Mapping[str, Printed]) -> set[str]:
        """The images by which an image is given, and those by which these are."""
        found, waiting = set[str](), [name]
        while waiting:
            place = given.get(waiting.pop())
            right = self.formulas[place].children()[1:] if place else ()
            new = {one for side in right for one in side.names()} & {*self.new} - found
            found |= new
            waiting += new
        return found

    def scene(self, name: str, vectors: Vectors) -> Scene:
        """The variables, and what the rows and the other statements say."""
        defined = {head(n)[0] for place in self.others for n in place.heads.names}
        nodes = (node for formula in self.formulas.values() for node in formula.nodes())
        known = {*self.images, *self.new, *defined, *self.words.matrices}
        fixed = dict.fromkeys(n.name for n in nodes if isinstance(n, Name))
        constants = tuple(name for name in fixed if name not in known)
        scene = Scene(name or "the map", vectors, (*self.images,), constants)
        for place in self.others:
            scene = with_row(scene, place, self.formulas[place])
        for one, place in self.rows.items():
            scene = scene.naming(one, place)
        check_unit(scene.constants)
        if scene.unit is not None:
            scene = with_conjugates(scene, self.formulas.values())
        return scene

    def solutions(self, vectors: Vectors) -> Iterator[str]:
        """The images that are not given, by the equations in which they are linear."""
        if not self.left:
            return
        if len(self.implicit) != len(self.left):
            said = ", ".join(self.left)
            raise ValueError(f"{len(self.implicit)} equations for {said}: print one for each")
        scene = self.scene("", vectors)
        rooted = with_roots(scene.having(variables=tuple(self.left)), self.display)
        yield from solutions(replace(scene, roots=rooted.roots), self.left, self.implicit)


def with_images(tex: str, vectors: Vectors, declared: Names, index: str) -> str:
    """The equations of a map with its images, and the canonical bracket if none is printed."""
    found = Map(Display("map", tex, ""), vectors, declared, index)
    more = [*found.solutions(vectors)]
    whole = Map(Display("map", r",\quad ".join((tex, *more)), ""), vectors, declared, index)
    rows = {one: whole.formulas[place] for one, place in whole.rows.items()}
    more += conjugate_images([*whole.formulas.values()], rows, whole.images)
    if not any(name.startswith(BRACKET) for place in found.others for name in place.heads.names):
        names = [*found.images]
        try:
            pairs = conjugate_pairs(names)
        except ValueError:
            pairs = [(names[0], names[1])] if len(names) == 2 else []
        more += canonical_brackets(pairs)
    return r",\quad ".join((tex, *more))


def _gives(formula: Formula, name: str) -> bool:
    """Whether an equation has an image alone on its left side."""
    match formula:
        case Relation((Name(own), _), ("=",)) if own == name:
            return True
    return False
