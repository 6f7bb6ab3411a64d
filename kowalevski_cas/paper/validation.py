"""What a scene has to be, so that its statements mean what they say.

Whatever is taken for granted, conjugated or measured by another time is examined once, before
anything is decided there. An error says on which scene and at which place, and what to do.
"""

from __future__ import annotations

from collections import Counter

from kowalevski_cas.algebra.squares import sum_of_squares
from kowalevski_cas.algebra.tower import Element
from kowalevski_cas.notation import Formula, Name, Negative, Number, Product, Sum
from kowalevski_cas.paper.meaning import Meaning
from kowalevski_cas.paper.scene import Change as ChangeOfScene
from kowalevski_cas.paper.texts import Printed
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.space import Adjoined, Contradictory, Meaningless, Space

POSITIVE_AT = (1, -2)
"""The first coordinates of points at which it is looked whether something is positive."""


def validate(setting: Meaning) -> None:
    """Raise :class:`Meaningless` for a setting in which anything or nothing could be shown."""
    for examine in (_pairs, _clock, _roots, _values, _assumptions, _time, _chains):
        examine(setting)


def _refuse(setting: Meaning, what: str, advice: str, name: str | None = None) -> Meaningless:
    return Meaningless(f"on the scene “{setting.scene.name}” {what}: {advice}", name)


def _pairs(setting: Meaning) -> None:
    """A conjugation is an involution of the variables, of the constants, and of the roots."""
    pairs = setting.conjugates
    twice = [name for name, count in Counter(n for p in pairs for n in p).items() if count > 1]
    if twice:
        what = f"{twice[0]} stands in two pairs of conjugates"
        raise _refuse(setting, what, "name each variable in one pair, and no real one", twice[0])
    kinds = [{*setting.variables}, {*setting.constants}, {*setting.roots}]
    for pair in pairs:
        for name in pair:
            setting.step(name)
        if not any({*pair} <= kind for kind in kinds):
            what = f"{pair[0]} and {pair[1]} are said to be conjugates"
            advice = "pair two variables, two constants, or two roots that the scene declares"
            raise _refuse(setting, what, advice, pair[0])
        squares = [step.square for n in pair if isinstance(step := setting.step(n), Adjoined)]
        if squares and not _same(setting, setting.finder.scalar(squares[0], True), squares[1]):
            what = f"{pair[0]} and {pair[1]} are said to be conjugates, and their squares are not"
            raise _refuse(setting, what, "mend the pair or the squares", pair[0])


def _same(setting: Meaning, value: Element, formula: Formula) -> bool:
    return (value - setting.finder.scalar(formula)).is_zero


def _clock(setting: Meaning) -> None:
    """The other time of a scene is one; where differentials give it, its rate may vary."""
    clock = setting.scene.clock
    if clock is not None and not setting.texts.time_change(clock).varies:
        check_time(setting, clock)


def check_time(setting: Meaning, printed: Printed) -> None:
    """Another time is a multiple of the time by a constant that is not zero."""
    scale = setting.finder.scalar(setting.plain(setting.texts.time_change(printed).rate))
    moving = [n for n in setting.variables if not setting.finder.partial(scale, n).is_zero]
    if scale.is_zero or moving:
        what = f"{printed.place} gives a time that {'stands still' if scale.is_zero else 'varies'}"
        raise _refuse(setting, what, "print it as a constant other than zero, times t")


def _time(setting: Meaning) -> None:
    """The time t is real: conjugates have conjugate rates, and what is real has real ones."""
    scene = setting.scene
    if scene.time != "t" or not scene.field or not (scene.unit or scene.conjugates):
        return
    if setting.finder.time_sign < 0:
        what = "the rates of what is real are imaginary"
        raise _refuse(setting, what, "print the motion of real and imaginary parts")


def _chains(setting: Meaning) -> None:
    """What stands in the middle of an equation of motion is the rate that its end is."""
    for printed in () if isinstance(setting.scene.field, ChangeOfScene) else setting.scene.field:
        *between, last = setting.texts.relation(printed).members[1:]
        rate = setting.finder.scalar(setting.plain(last)) if between else None
        if rate is not None and any(not _same(setting, rate, setting.plain(m)) for m in between):
            what = f"{printed.place} gives one rate twice, and not as the same"
            raise _refuse(setting, what, "leave one of both out, or mend it")


def _roots(setting: Meaning) -> None:
    """A real root has a radicand that is not negative everywhere."""
    ring, paired = setting.finder.ring, {name for pair in setting.conjugates for name in pair}
    for name, radicand in zip(ring.roots, ring.radicands, strict=True):
        # a real root of what is negative leaves no real point, and of none everything is true
        if name == "i" or name in paired:
            continue
        square = _in_real_names(setting, radicand)
        if _is_nowhere_positive(square):
            what = f"{name} is real, and its square is nowhere positive"
            raise _refuse(setting, what, "print it with $i$, or mend the radicand", name)


def _is_nowhere_positive(square: Element) -> bool:
    """Whether what a root is taken of is a sum of squares with another sign.

    It is none if it is positive somewhere, which a few points tell sooner.
    """
    if square.parts.keys() != {0}:
        return False
    polynomials = square.ring.polynomials
    for first in POSITIVE_AT:
        numbers = [polynomials.constant(first + k) for k, _ in enumerate(polynomials.generators)]
        value = polynomials.substitution(numbers, polynomials)(square.parts[0])
        if any(number > 0 for number in polynomials.terms(value).values()):
            return False
    return sum_of_squares((-square).terms()[0]) is not None


def _values(setting: Meaning) -> None:
    """Values of functions that are printed obey the relations of these functions."""
    for left, right in setting.transcendental.equations:
        if not _same(setting, setting.finder.scalar(setting.plain(left)), setting.plain(right)):
            what = "values of functions are printed that contradict each other"
            raise _refuse(setting, what, "mend the values")


def _in_real_names(setting: Meaning, element: Element) -> Element:
    """An element in real and imaginary parts, which have the names of two conjugates."""
    if not setting.conjugates:
        return element
    finder = setting.finder
    names = (*finder.ring.polynomials.generators, *(n for n in finder.ring.roots if n != "i"))
    space = Space(names, steps=(Adjoined("i", Negative(Number(1))),))
    real = Evaluation(space, finder.polynomials).adjoin_roots()
    values = {
        name: Sum((Name(a), Product((Number(sign), Name("i"), Name(b)))))
        for a, b in setting.conjugates
        for name, sign in ((a, 1), (b, -1))
    }
    return real.image(element, lambda name: real.scalar(values.get(name, Name(name))))


def _assumptions(setting: Meaning) -> None:
    """What is taken for granted not to vanish does not vanish by the relations."""
    product = setting.finder.ring.one
    for tex, formula in zip(setting.scene.nonzero, setting.nonzero, strict=False):
        # all together: with √(x²) neither x+√(x²) nor x−√(x²) is zero, and their product is
        product = product * setting.finder.scalar(formula)
        if product.is_zero:
            what = f"{tex} is taken for granted not to vanish, and the relations make it vanish"
            refused = _refuse(setting, what, "leave it out, or mend the relations")
            raise Contradictory(str(refused))
