"""Words of a report: lists, numbers, capitals, and that something does not vanish."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Final, TypeVar

from kowalevski_cas.notation import Formula, Name, Negative, Number, Relation, Root, Sum
from kowalevski_cas.report.document import Link, Text
from kowalevski_cas.verify.outcome import Condition

T = TypeVar("T")

ZERO: Final = Number(0)


def list_in_words(items: Sequence[Text], last: str = " and ") -> Text:
    """A list in words.

    >>> list_in_words([("one",), ("two",), ("three",)])
    ('one', ', ', 'two', ' and ', 'three')
    """
    text: Text = ()
    for k, item in enumerate(items):
        text += ((last if k == len(items) - 1 else ", ",) if k else ()) + item
    return text


def group_alike(
    things: Iterable[tuple[str, T]], aspect: Callable[[T], object] = lambda thing: thing
) -> Iterator[tuple[tuple[str, ...], tuple[T, ...]]]:
    """Claims and what they have, those together that are the same in the given aspect.

    >>> list(group_alike([("a", 1), ("b", 2), ("c", 1)]))
    [(('a', 'c'), (1, 1)), (('b',), (2,))]
    """
    found: dict[str, list[tuple[str, T]]] = {}
    for claim, thing in things:
        found.setdefault(repr(aspect(thing)), []).append((claim, thing))
    for having in found.values():
        yield tuple(claim for claim, _ in having), tuple(thing for _, thing in having)


def in_words(many: int) -> str:
    """A number in words, as far as they are shorter."""
    names = "no one two three four five six seven eight nine ten eleven twelve".split()
    return names[many] if many < len(names) else str(many)


def count_in_words(many: int, one: str, more: str = "") -> str:
    """How many there are.

    >>> count_in_words(1, "misprint"), count_in_words(13, "misprint")
    ('one misprint', '13 misprints')
    """
    return f"{in_words(many)} {one if many == 1 else more or one + 's'}"


def runs(numbers: Iterable[int]) -> str:
    """Numbers in words, those that follow one another together.

    >>> runs([1, 2, 3, 4, 7, 8])
    '1–4, 7 and 8'
    """
    found: list[list[int]] = []
    for number in sorted(numbers):
        if found and found[-1][-1] == number - 1:
            found[-1].append(number)
        else:
            found.append([number])
    parts = [
        part
        for run in found
        for part in ([f"{run[0]}–{run[-1]}"] if len(run) > 2 else map(str, run))
    ]
    return "".join(map(str, list_in_words([(part,) for part in parts])))


def capital(text: str) -> str:
    """The text with a capital at its beginning, unless it begins with an address.

    >>> capital("a line"), capital("https://dlmf.nist.gov/22.2")
    ('A line', 'https://dlmf.nist.gov/22.2')
    """
    return text if text.startswith(("http://", "https://")) else text[:1].upper() + text[1:]


def capitalise(text: Text) -> Text:
    """The text with a capital, where it begins with a word."""
    match text:
        case (str(word), *rest):
            return (capital(word), *rest)
        case (Link() as link, *rest):
            return (link._replace(text=capitalise(link.text)), *rest)
    return text


def nonzero(formula: Formula) -> Formula:
    """That a formula is not zero."""
    return Relation((formula, ZERO), (r"\ne",))


def violates_no(condition: Condition) -> Text:
    """That a condition holds: of a sum of squares, that one of them is not zero, if this is short.

    A sum of squares of letters says it best itself.
    """
    zeros = [zero for zero in condition.zeros if isinstance(zero, Relation)]
    if all(isinstance(zero.members[0], Name) and zero.members[1] == ZERO for zero in zeros):
        return (nonzero(condition.expression),)
    return list_in_words([(Relation(zero.members, (r"\ne",)),) for zero in zeros], " or ")


def supposed(formulas: Iterable[Formula]) -> Text:
    r"""That formulas do not vanish; of a root, which is not negative, that it is taken of more.

    >>> from kowalevski_cas.notation import Vocabulary, read, to_plain
    >>> names = Vocabulary(scalars=frozenset({"x", "y", "z"}))
    >>> said = supposed(read(tex, names) for tex in (r"\sqrt{x-y}", r"\sqrt{-z}", "z", "x"))
    >>> "".join(part if isinstance(part, str) else to_plain(part) for part in said)
    'x > y, z < 0 and x ≠ 0'
    """
    several = list(dict.fromkeys(formulas))
    below = [formula.argument for formula in several if isinstance(formula, Root)]
    signed = {f.argument if isinstance(f, Negative) else f for f in below}
    said = [_positive(f.argument) if isinstance(f, Root) else nonzero(f) for f in several]
    kept = [words for formula, words in zip(several, said, strict=True) if formula not in signed]
    return list_in_words([(words,) for words in kept])


def _positive(formula: Formula) -> Formula:
    """That a formula is positive, as it is said of a difference or of what has a minus."""
    match formula:
        case Negative(argument):
            return Relation((argument, ZERO), ("<",))
        case Sum((first, Negative(second))):
            return Relation((first, second), (">",))
    return Relation((formula, ZERO), (">",))
