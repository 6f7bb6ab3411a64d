"""Settings in which the order of definitions, conjugates and granted fractions might be misread.

All names have values at a point that is chosen first, in Gaussian rational numbers. What is false
there is false, and what is granted holds there; so nobody may prove the one without a condition
that fails there, whatever is divided by.
"""

from __future__ import annotations

from fractions import Fraction
from functools import reduce
from operator import mul
from typing import NamedTuple

from .tampering import OTHERS, seal


class Gaussian(NamedTuple):
    """A Gaussian rational number."""

    re: Fraction
    im: Fraction = Fraction(0)

    def __add__(self, other):
        return Gaussian(self.re + other.re, self.im + other.im)

    def __neg__(self):
        return Gaussian(-self.re, -self.im)

    def __mul__(self, other):
        real = self.re * other.re - self.im * other.im
        return Gaussian(real, self.re * other.im + self.im * other.re)

    def conjugate(self):
        return Gaussian(self.re, -self.im)

    def inverse(self):
        size = self.re**2 + self.im**2
        return Gaussian(self.re / size, -self.im / size)

    def tree(self):
        """It as a formula."""
        parts = [_rational(self.re), ["*", _rational(self.im), "i"]]
        return parts[0] if self.im == 0 else ["+", *parts]


NAMES = ("z", "w", "c", "i", "r")
ZERO, UNIT = Gaussian(Fraction(0)), Gaussian(Fraction(0), Fraction(1))


def _rational(value):
    return value.numerator if value.denominator == 1 else ["/", value.numerator, value.denominator]


def value(tree, at):
    """The value of a formula; raises ``ZeroDivisionError`` where it has none."""
    if isinstance(tree, str):
        return at[tree]
    if isinstance(tree, int):
        return Gaussian(Fraction(tree))
    op, *parts = tree
    if op == "^":
        return reduce(mul, [value(parts[0], at)] * parts[1])
    first, *others = (value(part, at) for part in parts)
    if op in ("-", "conj"):
        return -first if op == "-" else first.conjugate()
    for other in others:
        if op == "+":
            first = first + other
        else:
            first = first * (other if op == "*" else other.inverse())
    return first


class Setting:
    """A space with a point, and the formulas that its names stand for."""

    def __init__(self, choose):
        self.choose = choose
        a, b = (Gaussian(self._number(), self._number()) for _ in "ab")
        self.at = {"z": a, "w": a.conjugate(), "c": Gaussian(b.re)}
        self.definitions, self.steps = {}, []
        names = ["i", "r", "f", "g", "h"]
        choose.shuffle(names)
        for name in names:
            self._define(name)
        self.nonzero = [*self._granted()]
        choose.shuffle(self.nonzero)

    def _number(self):
        return Fraction(self.choose.randint(1, 3), self.choose.choice((1, 1, 2)))

    def _define(self, name):
        if name == "i":
            self.at[name] = UNIT
            self.steps.append(["root", name, ["-", 1]])
        elif name == "r":  # of what is real
            real = ["+", "z", "w", "c"]
            self.at[name] = Gaussian(self._number())
            rest = self.at[name] * self.at[name] + -value(real, self.at)
            self.steps.append(["root", name, ["+", *real[1:], _rational(rest.re)]])
        else:
            while True:
                tree = self.formula(2)
                try:
                    self.at[name] = value(tree, self.at)
                except ZeroDivisionError:
                    continue
                break
            self.steps.append(["let", name, tree])
            self.definitions[name] = tree

    def formula(self, depth):
        """A formula in the names that are known."""
        if depth == 0 or self.choose.random() < 0.2:
            return self.choose.choice([*self.at, *self.at, self.choose.randint(1, 3)])
        op = self.choose.choice(["+", "*", "-", "conj", "conj", "/"])
        return [op, *(self.formula(depth - 1) for _ in range(1 if op in ("-", "conj") else 2))]

    def open(self, tree, real=(), conjugated=False):
        """A formula without conjugates and definitions, where some names are taken to be real."""
        if isinstance(tree, int):
            return tree
        if isinstance(tree, str) and tree in self.definitions:
            return self.open(self.definitions[tree], real, conjugated)
        if isinstance(tree, str):
            swapped = {"z": "w", "w": "z", "i": ["-", "i"]}
            return swapped.get(tree, tree) if conjugated and tree not in real else tree
        if tree[0] == "conj":
            return self.open(tree[1], real, not conjugated)
        return [tree[0], *(self.open(part, real, conjugated) for part in tree[1:])]

    def _granted(self):
        """Fractions that do not vanish at the point."""
        for _ in range(self.choose.randint(0, 3)):
            tree = ["/", self.formula(2), self.formula(2)]
            try:
                known = value(tree, self.at) != ZERO
            except ZeroDivisionError:
                continue
            if known and self._is_moving(tree):
                yield tree

    def _is_moving(self, tree):
        """Whether a formula has other values elsewhere: what is granted is no number."""
        elsewhere = set()
        for k in (3, 5, 7):
            a = Gaussian(Fraction(k, 11), Fraction(k * k, 13))
            at = {"z": a, "w": a.conjugate(), "c": Gaussian(Fraction(k)), "i": UNIT}
            at["r"] = Gaussian(Fraction(k + 2, 17))
            try:
                elsewhere.add(value(self.open(tree), at))
            except ZeroDivisionError:
                return False
        return len(elsewhere) == 3

    def space(self):
        return {
            "variables": ["z", "w"],
            "constants": ["c"],
            "nonzero": self.nonzero,
            "steps": self.steps,
            "conjugates": [["z", "w"]],
        }

    def with_value(self, wanted, at):
        """A sum with a name in it that has this value at a point."""
        name = self.choose.choice(["z", "w", "c"])
        return ["+", name, (wanted + -at[name]).tree()]

    def elsewhere(self):
        """Another real point, with the same value of the root."""
        move = Gaussian(Fraction(self.choose.randint(1, 3)))
        at = {name: self.at[name] for name in NAMES}
        return at | {"z": at["z"] + move, "w": at["w"] + move, "c": at["c"] + -move + -move}


def misread(tree, choose):
    """A formula with one operation left out or changed."""
    if not isinstance(tree, list):
        return choose.choice([tree, ["-", tree], ["conj", tree]])
    k = choose.randrange(len(tree))
    if k:
        return [*tree[:k], misread(tree[k], choose), *tree[k + 1 :]]
    if tree[0] in ("-", "conj"):
        return tree[1]
    return [choose.choice([op for op in OTHERS[tree[0]] if op in "+*/"]), *tree[1:]]


def true(setting):
    """A name, and what it stands for."""
    name = setting.choose.choice([*setting.definitions])
    return {"given": [], "conclusions": [[[name, setting.open(name)]]]}, [{}]


def misreading(setting):
    """A name, and what it does not stand for: their values differ at the point."""
    names = setting.choose.sample([*setting.definitions], len(setting.definitions))
    readings = [(name, setting.open(name, real)) for real in ("i", "zw") for name in names]
    readings += [(name, misread(setting.definitions[name], setting.choose)) for name in names * 3]
    for name, tree in readings:
        try:
            if value(tree, setting.at) != setting.at[name]:
                return {"given": [], "conclusions": [[[name, tree]]]}, [{}]
        except ZeroDivisionError:
            continue
    return {"given": [], "conclusions": [[["f", ["+", "f", 1]]]]}, [{}]


def divided(setting):
    """What would follow if one might divide by what vanishes at the point.

    It holds at another one. Where a root is granted to be no negative of something, it may be this.
    """
    choose, there = setting.choose, setting.elsewhere()
    with_norm = ["+", "r", setting.with_value(setting.at["r"], setting.at)]
    setting.nonzero.insert(choose.randint(0, len(setting.nonzero)), with_norm)
    granted = choose.choice(setting.nonzero)
    gone = ["+", granted, ["-", setting.with_value(value(granted, setting.at), setting.at)]]
    gone = ["+", ["-", "r"], with_norm[2]] if granted == with_norm else gone
    target = setting.with_value(ZERO, there)
    given = choose.choice([gone, ["*", gone, granted], ["*", gone, ["conj", gone]]])
    rows = [["/", 1, one] for one in (given, gone, ["*", gone, granted])]
    rows.append(["/", ["/", 1, granted], gone])
    proofs = [{"cofactors": [[row]], "point": point(there)} for row in rows]
    empty = choose.random() < 0.2
    goal = {"given": [[given if empty else ["*", given, target], 0]]}
    goal["conclusions"] = [] if empty else [[[target, 0]]]
    return goal, [*proofs, *({**proof, "away": [gone]} for proof in proofs)]


def point(at):
    """A point of a certificate."""
    return {"roots": [], "values": [[name, at[name].tree()] for name in NAMES]}


def certificates(setting, statement):
    """Certificates for a statement, each with some evidence."""
    goal, evidence = statement(setting)
    for entry in evidence:
        data = {
            "format": "kowalevski-cas certificate", "version": 2, "claim": "c", "sign": "holds",
            "spaces": [setting.space()], "goals": [{"goal": "follows", "space": 0, **goal}],
            "evidence": [{"point": point(setting.at), **entry}],
        }  # fmt: skip
        yield seal(data)
