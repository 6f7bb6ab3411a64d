r"""What comments of authors may say, made from the attributes of the kinds of claims.

    law | map | define NAMES | level NAMES | given NAMES | skip | on PLACES
    suppose TEX | accept TEX
    claim [KIND [$TEX$ ...] [NUMBER] [FIELD VALUES] ...] [on PLACES] [in PLACES]
          [locus EQUATIONS off TEX] ...

A kind is named by words of its name, as ``integral`` for a first integral; each of its attributes
is a field, by its own name, and a number stands by itself. ``of`` is the field of the places that
the claim is about, ``with`` that of the integrals of which the values are fixed. A place is a
label, with a number behind a stop where it has several statements, or TeX in quotes; TeX between
dollars is a statement that the paper does not print, and behind a kind one that is claimed.
Where one statement is named, a display of several is named row by row: each of those that are
claimed has that of its own number. ``in`` names the display that gives the variables in which the
claim is made, ``locus`` where it may fail, and what does not vanish elsewhere. A scene of a claim
is named by what is supposed on it, and a measure by names, a power, and the rest of their unit.
Before all of it, a number says which statement of a display is meant; ``as`` says a kind of role.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import MISSING, dataclass, fields, replace
from difflib import get_close_matches
from functools import cache
from typing import Any

from kowalevski_cas.paper import claims
from kowalevski_cas.paper.claims import Claim
from kowalevski_cas.paper.scene import Locus
from kowalevski_cas.reading.statements import SourceStatement
from kowalevski_cas.source.comments import Comment
from kowalevski_cas.source.text import SourceError

NAMING = ("define", "level", "given", "map")
"""What may be followed by the names that get a meaning or a value."""
OF_TEX = ("suppose", "accept")
"""What is followed by a formula: one that is supposed, or the one that should stand there."""
BESIDE = ("on", *OF_TEX)
"""What may be said of a formula beside its role."""
VERBS = ("law", *NAMING, "claim", "skip", *BESIDE)
RULED = (
    "identity", "constant", "integral", "invariant", "rest", "inequality", "solution",
    "approximate", "somewhere", "another-law", "condition", "form", "divergence", "measure",
    "energy",
)  # fmt: skip
"""Kinds of claims of which the rules of reading know on what they stand."""

AS = {
    "set": "set",
    "set-in-force": "set in force",
    "value": "value",
    "inequality": "inequality",
    "of-the-sentence": "of the sentence",
    "set-of-the-sentence": "set of the sentence",
    "square": "square",
    "clock": "clock",
    "unit": "unit",
    "vector": "vector",
    "constraint": "constraint",
}
"""The kinds of roles that may stand behind ``as``."""
_BEHIND = ("on", "names")
_WORDS = re.compile(r'"[^"]*"|\$[^$]*\$|[^\s"]+')
_BASE = {attribute.name for attribute in fields(Claim)}
INVARIANT_SET = "InvariantRelations"
"""The type of an attribute that is the claim of an invariant set: its equations are named."""
ROW = ("Printed", "Printed | None")
"""The types of attributes that name one statement; of a display, each row names that beside it."""
_PLACES = (*ROW, "tuple[Printed, ...]", INVARIANT_SET)
SCENE, PAIRS, MEASURES = "Scene", "tuple[tuple[str, str], ...]", "tuple[Measure, ...]"
"""The types of attributes that a scene gives: one beside it, its conjugates, its units."""
_NAMES = ("str", "str | None", "tuple[str, ...]")
_NUMBERS = ("int", "tuple[int, ...]", "bool")
_FIELDS = (*_PLACES, *_NAMES, *_NUMBERS, "tuple[tuple[str, ...], ...]", SCENE, PAIRS, MEASURES)


@dataclass(frozen=True, eq=False)
class Directive:
    """What a comment says: a verb, which statement of its display is meant, and the rest."""

    comment: Comment
    verb: str
    number: int = 0
    names: tuple[str, ...] = ()
    ruled: str = ""
    """The kind of a role, or of a claim by rules."""
    kind: type[Claim] | None = None
    values: Mapping[str, object] | None = None
    """The attributes of a claim of this kind."""
    items: tuple[SourceStatement, ...] = ()
    """The statements that are named."""
    stated: SourceStatement | None = None
    """The statement that is claimed, if the paper does not print it."""
    on: tuple[SourceStatement, ...] | None = None
    """The statements on which the claim rests, if they are said."""
    change: tuple[SourceStatement, ...] = ()
    """What gives the variables in which the claim is made, if these are others."""
    loci: tuple[Locus, ...] = ()
    """Where the claim may fail."""
    tex: str = ""
    """The formula that is supposed or accepted."""

    @property
    def place(self) -> str:
        """Where the comment is written."""
        return f"{self.comment.path}:{self.comment.line}"

    @property
    def is_of_formula(self) -> bool:
        """Whether it says something of the formula by which it stands."""
        return self.stated is None and (self.kind is None or of_formula(self.kind))


def wrong(comment: Comment, words: str, near: str = "", among: Iterable[str] = ()) -> SourceError:
    """What is to be raised for a comment that cannot be obeyed."""
    close = get_close_matches(near, list(among), 1, 0.5)
    hint = f"; did you mean {close[0]}?" if close else ""
    return SourceError(f"{comment.path}:{comment.line}: “%kc: {comment.words}”: {words}{hint}")


@cache
def kinds() -> dict[str, type[Claim]]:
    """The kinds of claims that a comment can state, by the words of their names."""
    found = {}
    for name in claims.MODULES:
        kind = getattr(claims, name)
        if inspect.isclass(kind) and issubclass(kind, Claim) and not inspect.isabstract(kind):
            if all(one.type in _FIELDS for one in own_fields(kind)):
                found[" ".join(re.findall("[A-Z][a-z]+", name)).lower()] = kind
    return found


def own_fields(kind: type[Claim]) -> list[Any]:
    """The attributes that a kind has beside those of all kinds."""
    return [one for one in fields(kind) if one.name not in _BASE]


def of_formula(kind: type[Claim]) -> bool:
    """Whether a kind is about the one formula at its place."""
    own = (one for base in kind.__mro__ if base is not Claim for one in vars(base).values())
    codes = (one.__code__ for one in own if inspect.isfunction(one))
    return any("own" in code.co_names for code in codes)


def parse(comment: Comment, find: Callable[[str], Sequence[SourceStatement]]) -> list[Directive]:
    """What a comment says, for each statement that it gives and claims one.

    ``find`` gives the statements of a label, or of TeX.

    Raises:
        SourceError: a word is not known, or stands for nothing.
    """
    parser = _Parser(comment, find)
    made = parser.directive()
    stated = [replace(made, stated=o, items=(o, *made.items)) for o in parser.stated]
    return stated or [made]


class _Parser:
    def __init__(self, comment: Comment, find: Callable[[str], Sequence[SourceStatement]]) -> None:
        self.comment, self.find = comment, find
        said, *self.loci = re.split(r"(?:^|\s)locus(?:\s|$)", comment.words)
        self.words = [word.strip(",;") or word for word in _WORDS.findall(said)]
        self.items: list[SourceStatement] = []
        self.stated: list[SourceStatement] = []
        self.on: tuple[SourceStatement, ...] | None = None
        self.change: tuple[SourceStatement, ...] = ()

    def directive(self) -> Directive:
        number = int(self.words.pop(0)) if self.words and self.words[0].isdigit() else 0
        if not self.words:
            raise wrong(self.comment, "it says nothing")
        verb = self.words.pop(0)
        if verb not in VERBS:
            raise wrong(self.comment, f"the word {verb} is not known here", verb, VERBS)
        made = Directive(self.comment, verb, number)
        if verb == "claim":
            return self.claim(made)
        if verb in OF_TEX:
            tex = self.comment.words.partition(verb)[2].strip()
            if not tex:
                raise wrong(self.comment, f"a formula is missing behind {verb}")
            return replace(made, tex=tex)
        if verb == "on":
            on = self.places(self.taken(()))
            return replace(made, items=tuple(self.items), on=on)
        ruled = self.ruled()
        names = tuple(self.taken(())) if verb in NAMING else ()
        if verb == "skip" and self.words == ["sentence"]:
            names = ("sentence",)
        if verb == "law" and self.words:
            raise wrong(self.comment, f"{self.words[0]} follows law, and nothing should")
        return replace(made, names=names, ruled=ruled)

    def ruled(self) -> str:
        """The kind of a role, behind ``as``."""
        if self.words[:1] != ["as"]:
            return ""
        self.words.pop(0)
        word = str(self.words.pop(0)) if self.words else ""
        if word not in AS:
            raise wrong(self.comment, f"the word {word} is not known behind as", word, AS)
        return AS[word]

    def claim(self, made: Directive) -> Directive:
        """A claim: by the rules, or of a kind with the values of its attributes."""
        by_rules = [*self.words[:1]] if self.words[:1] and self.words[0] in RULED else []
        rest = self.words[len(by_rules) :]
        if not rest or rest[0] in _BEHIND:
            self.words = rest
            names: tuple[str, ...] = ()
            on: tuple[SourceStatement, ...] | None = None
            while self.words:
                if self.words.pop(0) == "on":
                    on = self.places(self.taken(_BEHIND))
                else:
                    names = tuple(self.taken(_BEHIND))
            ruled = by_rules[0] if by_rules else "identity"
            return replace(made, names=names, ruled=ruled, on=on)
        kind = self.kind()
        while of_formula(kind) and self.words and self.words[0].startswith("$"):
            self.stated += self.places([self.words.pop(0)])
        self.items.clear()
        values, loci = self.values(kind), tuple(map(self.locus, self.loci))
        return replace(
            made, kind=kind, values=values, items=tuple(self.items), on=self.on,
            change=self.change, loci=loci,
        )  # fmt: skip

    def locus(self, words: str) -> Locus:
        """A locus: its equations, and behind ``off`` what does not vanish elsewhere."""
        equations, _, off = map(str.strip, words.partition(" off "))
        if not (equations and off):
            raise wrong(self.comment, "a formula is missing behind locus")
        return Locus(equations, tuple(map(str.strip, equations.split(","))), off)

    def kind(self) -> type[Claim]:
        """The kind that the next words name: all of its name, or words that no other one has."""
        said: list[str] = []
        candidates = dict(kinds())
        while self.words and self.words[0].isalpha():
            more = {n: k for n, k in candidates.items() if self.words[0].lower() in n.split()}
            if not more:
                break
            candidates = more
            said.append(self.words.pop(0).lower())
        if not said:
            unknown = self.words[0] if self.words else ""
            among = {word for name in kinds() for word in name.split()} | {*RULED}
            raise wrong(self.comment, f"no kind of claim is called {unknown}", unknown, among)
        if " ".join(said) in candidates:
            return candidates[" ".join(said)]
        if len(candidates) > 1:
            raise wrong(self.comment, f"which one is meant: {', '.join(candidates)}?")
        return next(iter(candidates.values()))

    def values(self, kind: type[Claim]) -> dict[str, object]:
        """The attributes of a kind; on what the claim rests, and in what, is noted."""
        own = {one.name: one for one in own_fields(kind)}
        places = [name for name, one in own.items() if one.type in _PLACES]
        called = {name: name for name in own}
        about = [name for name in places if name not in ("levels", "given", "together")]
        called |= {"of": about[0]} if about else {}
        called |= {"with": "levels"} if "levels" in own else {}
        called |= {} if "given" not in own else {"on": "given"}
        values: dict[str, object] = {}
        numbers = [name for name, one in own.items() if one.type == "int"]
        stops = (*called, "of", "on", "in")
        while self.words:
            word = self.words.pop(0)
            if word.isdigit() and numbers:
                values[numbers.pop(0)] = int(word)
            elif word in called:
                taken = self.taken(stops)
                values[called[word]] = self.value(own[called[word]].type, taken)
            elif word == "on":
                self.on = self.places(self.taken(stops))
            elif word == "in":
                self.change = self.places(self.taken(stops))
            elif word == "of":  # a kind without places: about what it is said
                self.places(self.taken(stops))
            else:
                raise wrong(self.comment, f"the word {word} is not known here", word, stops)
        missing = {name: one for name, one in own.items() if name not in values}
        return values | {n: () for n in missing if self.is_empty(missing[n])}

    def is_empty(self, one: Any) -> bool:
        """Whether a field that is not given is empty; else its kind or a change gives it."""
        if one.name == "levels" and one.type.startswith("tuple"):
            return True
        by_change = self.change and one.type in (SCENE, PAIRS)
        if not by_change and one.default is MISSING and one.default_factory is MISSING:
            raise wrong(self.comment, f"{one.name} is missing")
        return False

    def taken(self, stops: Sequence[str]) -> list[str]:
        """The words up to one of these."""
        found = []
        while self.words and self.words[0] not in stops:
            found.append(self.words.pop(0))
        return found

    def value(self, type: str, words: list[str]) -> object:
        """The value of an attribute of some type."""
        if type in _PLACES:
            found = tuple(item.printed for item in self.places(words))
            rows = len(found) > 1 and len({one.display.id for one in found}) == 1
            if rows or type.startswith("tuple") or type == INVARIANT_SET:
                return found
            return self.one(found, words)
        if type == SCENE:
            return self.places(words)
        if type == MEASURES:
            return tuple(self.measures(words))
        if type == "bool":
            return True
        if type in ("str", "str | None"):
            return " ".join(words).strip('"')
        if type == "int":
            return int(self.one(words, words))
        if type == "tuple[int, ...]":
            return tuple(map(int, words))
        names = tuple(word.strip('"') for word in words)
        if type == PAIRS:
            return tuple(zip(names[::2], names[1::2], strict=False))
        return names if type == "tuple[str, ...]" else tuple((name,) for name in names)

    def measures(self, words: list[str]) -> Iterator[tuple[tuple[str, ...], int, str]]:
        """Names, the power of the unit of time in their unit, and the rest of it, in turn."""
        names: list[str] = []
        left = iter(words)
        for word in left:
            if re.fullmatch(r"-?\d+", word) and names:
                yield tuple(names), int(word), next(left, "1")
                names = []
            else:
                names.append(word.strip('"'))
        if names:
            raise wrong(self.comment, f"a power of the unit of time is missing behind {names[-1]}")

    def one(self, found: Sequence[Any], words: Sequence[str]) -> Any:
        if len(found) != 1:
            raise wrong(self.comment, f"one is expected, and not {' '.join(words) or 'none'}")
        return found[0]

    def places(self, words: Iterable[str]) -> tuple[SourceStatement, ...]:
        """The statements that some words name."""
        found: list[SourceStatement] = []
        for word in words:
            try:
                found += self.find(word)
            except LookupError as error:
                raise wrong(self.comment, f"{word} {error}") from None
        self.items += found
        return tuple(dict.fromkeys(found))
