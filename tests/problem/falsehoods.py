"""Statements that are false by construction, and what somebody may give as evidence for them.

Each is built around a point that is chosen first, and at which it fails: exact rational arithmetic
on the trees says so, by itself. `FALSE` has statements that do not hold and `TRUE` such that do;
the sign of a certificate that `attempts` gives is always the wrong one.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import product

from .tampering import seal

NAMES = ("x", "y", "z")


# -- formulas, and their values ----------------------------------------------------


def plus(*trees):
    return ["+", *trees]


def times(*trees):
    return ["*", *trees]


def minus(a, b):
    return ["+", a, ["-", b]]


def rational(value):
    """A rational number as a formula."""
    value = Fraction(value)
    return value.numerator if value.denominator == 1 else ["/", value.numerator, value.denominator]


def value(tree, at):
    """The value of a formula at a point, with its derivative where names have rates."""
    if isinstance(tree, str):
        return at[tree]
    if isinstance(tree, int):
        return Fraction(tree), Fraction(0)
    op, *parts = tree
    if op == "^":
        found = Fraction(1), Fraction(0)
        for _ in range(parts[1]):
            found = multiplied(found, value(parts[0], at))
        return found
    first, *others = (value(part, at) for part in parts)
    if op == "D":
        return first[1], None
    if op == "-":
        return -first[0], -first[1]
    for other in others:
        if op == "+":
            first = first[0] + other[0], first[1] + other[1]
        elif op == "*":
            first = multiplied(first, other)
        else:
            inverse = 1 / other[0]
            first = multiplied(first, (inverse, -other[1] * inverse**2))
    return first


def multiplied(a, b):
    return a[0] * b[0], a[0] * b[1] + a[1] * b[0]


class Draw:
    """Formulas, points and settings, drawn at random."""

    def __init__(self, choose):
        self.choose = choose
        self.hints = []  # evidence that somebody would like best
        self.right = {}  # evidence for the right sign, beside the point
        self.point = {
            name: Fraction(choose.randint(-3, 3), choose.choice((1, 1, 2))) for name in NAMES
        }
        self.rates = {name: self.formula(1) for name in NAMES}
        still = {name: (number, Fraction(0)) for name, number in self.point.items()}
        speeds = {name: value(tree, still)[0] for name, tree in self.rates.items()}
        self.at = {name: (number, speeds[name]) for name, number in self.point.items()}

    def formula(self, depth=2):
        """A polynomial in the names."""
        if depth == 0 or self.choose.random() < 0.2:
            return self.choose.choice([*NAMES, self.choose.randint(-3, 3), *NAMES])
        op = self.choose.choice("++**-^")
        if op == "-":
            return ["-", self.formula(depth - 1)]
        if op == "^":
            return ["^", self.formula(depth - 1), self.choose.randint(0, 3)]
        return [op, *(self.formula(depth - 1) for _ in range(self.choose.randint(2, 3)))]

    def number(self, tree):
        """The value of a formula at the point."""
        return value(tree, self.at)[0]

    def with_value(self, wanted, depth=2):
        """A formula that is no number, and has this value at the point."""
        tree = plus(self.choose.choice(NAMES), self.formula(depth))
        return plus(tree, rational(wanted - self.number(tree)))

    def vanishing(self, many):
        """Equations that hold at the point."""
        return [[self.with_value(0), 0] for _ in range(many)]

    def off(self):
        """A number other than zero."""
        return self.choose.choice([-1, 1]) * Fraction(
            self.choose.randint(1, 4), self.choose.choice((1, 2))
        )

    def space(self, **more):
        field = [[[*NAMES], ["vector", 1, 1, 1], ["vector", *(self.rates[n] for n in NAMES)]]]
        return {"variables": [*NAMES], "field": field, **more}


def at(values):
    """The point of a certificate."""
    return {"roots": [], "values": [[name, rational(number)] for name, number in values.items()]}


def follows(conclusions, given=(), kind="follows"):
    return {"goal": kind, "space": 0, "given": [*given], "conclusions": conclusions}


# -- false statements --------------------------------------------------------------


def identity(draw):
    """An identity that fails at the point."""
    tree = draw.formula()
    return draw.space(), follows([[[tree, minus(tree, draw.with_value(draw.off()))]]])


def implication(draw):
    """What does not follow: the given equations hold at the point, the conclusion fails."""
    return draw.space(), follows(
        [[[draw.with_value(draw.off()), 0]]], draw.vanishing(draw.choose.randint(1, 2))
    )


def alternatives(draw):
    """Each of the conclusions fails at the point."""
    conclusions = [[[draw.with_value(draw.off()), 0]] for _ in range(2)]
    return draw.space(), follows(conclusions, draw.vanishing(1))


def emptiness(draw):
    """Equations that are said to have no common point have this one."""
    return draw.space(), follows([], draw.vanishing(draw.choose.randint(1, 2)))


def motion(draw):
    """A derivative that is another one at the point."""
    tree = draw.with_value(0)
    rate = value(tree, draw.at)[1]
    return draw.space(), follows(
        [[[["D", tree], draw.with_value(rate + draw.off())]]], draw.vanishing(1)
    )


def defined(draw):
    """The same behind a name."""
    tree = draw.formula()
    space = draw.space(steps=[["let", "f", tree]])
    return space, follows(
        [[["f", draw.with_value(draw.number(tree) + draw.off())]]], draw.vanishing(1)
    )


def rooted(draw):
    """A root that is a number at the point, and is said to be another one on the given set."""
    side = draw.off()
    space = draw.space(steps=[["root", "r", draw.with_value(side * side)]])
    draw.at["r"] = side, None
    draw.point["r"] = side
    return space, follows(
        [[[minus(["^", "r", 3], draw.with_value(side**3 + draw.off())), 0]]], draw.vanishing(1)
    )


def exists(draw):
    """No factor is a quotient by what vanishes at the point, as an expression or as a number."""
    bound = draw.choose.choice(["numbers", "expressions"])
    draw.right = {"inner": 0, "points": [[1, at(draw.point)]]}
    goal = follows([[[draw.with_value(draw.off()), times("M", draw.with_value(0))]]])
    return draw.space(), {
        "goal": "exists",
        "numbers": [],
        "expressions": [],
        bound: ["M"],
        "goals": [goal],
    }


def dependent(draw):
    """Functions of one function have dependent differentials."""
    tree = draw.with_value(draw.off())
    functions = [tree, plus(["^", tree, 2], tree, draw.choose.randint(0, 3))]
    draw.right = {"minors": [[], [], []]}
    return draw.space(), {
        "goal": "rank",
        "space": 0,
        "functions": functions,
        "given": [],
        "rank": 2,
    }


def counted(draw):
    """A number of square roots that is not two."""
    goal = {"goal": "count", "space": 0, "names": ["x"], "number": draw.choose.choice([0, 1, 3, 4])}
    draw.point = {"x": Fraction(abs(draw.off())), "a": Fraction(0)}
    draw.point["a"] = draw.point["x"]
    draw.at = {name: (number, Fraction(0)) for name, number in draw.point.items()}
    draw.right = count(at(draw.point))
    space = {"variables": ["x"], "constants": ["a"], "nonzero": ["a"]}
    return space, {**goal, "equations": [[["^", "x", 2], ["^", "a", 2]]]}


def excluded(draw):
    """It would follow, but the given equations leave nothing that the conditions admit."""
    gone = draw.with_value(0)
    return draw.space(nonzero=[gone]), follows([[[draw.with_value(0), 0]]], [[gone, 0]])


def contradictory(draw):
    """It would follow, but the given equations contradict each other."""
    gone = draw.with_value(0)
    return draw.space(), follows(
        [[[draw.with_value(0), 0]]], [[gone, 0], [gone, rational(draw.off())]]
    )


def unreal(draw):
    """It would follow, but no point of the setting is real."""
    square = ["-", plus(1, ["^", draw.formula(1), 2])]
    steps = [["root", "r", square]]
    draw.point["r"] = 1 + abs(draw.off())
    return draw.space(steps=steps), follows([[[draw.with_value(0), 0]]], [[["^", "r", 2], square]])


def refuted(draw):
    """What is said to fail somewhere is a combination of what is given."""
    given = draw.vanishing(2)
    row = [draw.formula(1) for _ in given]
    sides = [times(factor, equation[0]) for factor, equation in zip(row, given, strict=True)]
    draw.right = {"cofactors": [row]}
    return draw.space(), follows([[[plus(*sides), 0]]], given, kind="fails")


VACUOUS = excluded, contradictory, unreal
"""Nothing satisfies what they suppose: they neither hold nor fail."""

FALSE = (
    identity, implication, alternatives, emptiness, motion, defined, rooted, exists, dependent, counted,
    refuted, *VACUOUS,
)  # fmt: skip


# -- true statements ---------------------------------------------------------------


def combination(draw):
    """A combination of given equations vanishes with them."""
    space, goal = refuted(draw)
    return space, {**goal, "goal": "follows"}


def expanded(draw):
    """A product is what it is multiplied out."""
    a, b = draw.formula(), draw.formula()
    whole = plus(["^", a, 2], times(2, a, b), ["^", b, 2])
    return draw.space(), follows([[[["^", plus(a, b), 2], whole]]])


def away(draw):
    """It fails at the point, and does not where a condition of somebody's own holds."""
    zero, other = (
        minus("x", rational(draw.point["x"])),
        minus("y", rational(draw.point["y"] + draw.off())),
    )
    there = draw.point | {"x": draw.point["x"] + 1, "y": draw.point["y"] - draw.number(other)}
    draw.hints.append({"away": [zero], "cofactors": [[["/", 1, zero]]], "point": at(there)})
    return draw.space(), follows([[[other, 0]]], [[times(zero, other), 0]], kind="fails")


def sum_of_squares(draw):
    """One more than a square vanishes nowhere."""
    base = draw.formula()
    draw.right = {"product": [[1, base]], "cofactors": [[1]], "cases": [{"cofactors": [[0, 1, 0]]}]}
    return draw.space(), follows([], [[plus(1, ["^", base, 2]), 0]])


def independent(draw):
    """Coordinates are independent."""
    return draw.space(), {
        "goal": "rank",
        "space": 0,
        "functions": ["x", plus("y", ["^", "x", 2])],
        "given": [],
        "rank": 2,
    }


TRUE = (combination, expanded, away, sum_of_squares, independent)


# -- evidence ----------------------------------------------------------------------


def conditions(draw, goal):
    """What somebody would like not to vanish."""
    given = [minus(*sides) for sides in goal.get("given", [])]
    stated = [minus(*sides) for one in goal.get("conclusions", []) for sides in one]
    return [
        [],
        given[:1],
        stated[:1],
        [draw.formula()],
        [times(*given, *stated)] if given and stated else ["x"],
    ]


def points(draw):
    """The point, others nearby, and what is no real point."""
    values = dict(draw.point)
    other = dict.fromkeys(values, Fraction(0))
    moved = {name: number + draw.choose.randint(-1, 1) for name, number in values.items()}
    unreal = at(values)
    unreal["values"][0][1] = "i"
    return [
        at(values),
        at(other),
        at(moved),
        unreal,
        {"roots": [], "values": at(values)["values"][:-1]},
    ]


def cofactors(draw, goal):
    """Rows that would prove something if one could divide as one likes."""
    given = [minus(*sides) for sides in goal.get("given", [])]
    stated = [minus(*one[0]) for one in goal.get("conclusions", [])]
    target = times(*stated, 1) if stated else 1
    rows = [[], [[]]]
    for k, one in enumerate(given):
        rows.append([[0] * k + [["/", target, one]] + [0] * (len(given) - k - 1)])
    rows.append([[draw.formula(1) for _ in given]])
    return rows


def proofs(draw, goal):
    """Proofs that are none: combinations, cases, powers."""
    given = [minus(*sides) for sides in goal.get("given", [])]
    for rows in cofactors(draw, goal):
        yield {"cofactors": rows} if rows else {}
        yield {"cofactors": rows or [[]], "power": 2}
    for group in ([1], [0], given[:1] or ["x"], ["x", "y"]):
        first = [1] + [0] * (len(given) - 1) if given else []
        yield {
            "product": [group],
            "cofactors": [first],
            "cases": [{"cofactors": [[0] * len(given) + [1] * len(group)]}],
        }
        yield {"product": [group], "cofactors": [[]], "cases": [{}]}


def entries(draw, goal, sign):
    """Entries of evidence for a goal, or against it."""
    places = points(draw)
    if goal["goal"] == "exists":
        one = goal["goals"][0]
        for tree in (
            0,
            ["/", one["conclusions"][0][0][0], one["conclusions"][0][0][1][2]],
            draw.formula(1),
        ):
            for entry in entries(draw, one, "holds"):
                yield {"values": [["M", tree]], "evidence": [entry]}
        return
    if goal["goal"] in ("rank", "count"):
        yield from ({"point": place} for place in places)
        yield {"minors": [[]] * 3}
        yield {"points": places[:2]}
        yield from (count(place) for place in places if "equations" in goal)
        return
    for divisors, place in product(conditions(draw, goal), places):
        own = {"away": divisors} if divisors else {}
        if (goal["goal"] == "fails") == (sign == "holds"):
            yield {"point": place, **own}
        else:
            given = {"point": place} if goal["conclusions"] else {}
            yield from ({**given, **own, **proof} for proof in proofs(draw, goal))
            yield from ({**own, **proof} for proof in proofs(draw, goal) if not given)


def count(place):
    """Evidence that is right for two solutions."""
    return {
        "point": place, "root": "s", "form": "x", "eliminant": [["-", ["^", "a", 2]], 0],
        "solved": [["x", "s", 1]], "cofactors": [[1], [0]], "quotients": [1, 0],
        "factors": [{"factor": ["^", "a", 2], "squares": [[1, "a"]]}], "minors": [[2, [0]], [4, [1]]],
    }  # fmt: skip


def attempts(draw, statement, many):
    """Certificates of the wrong sign."""
    space, goal = statement(draw)
    sign = "holds" if statement in FALSE else "denied"
    found = [*entries(draw, goal, sign)]
    for entry in [*draw.hints, *draw.choose.sample(found, min(many, len(found)))]:
        yield certificate(space, goal, sign, entry)


def rightly(draw, statement):
    """A certificate of the right sign, with the evidence that shows it."""
    space, goal = statement(draw)
    sign = "denied" if statement in FALSE else "holds"
    point = {} if {"points", "minors"} & draw.right.keys() else {"point": at(draw.point)}
    return certificate(space, goal, sign, {**point, **draw.right})


def certificate(space, goal, sign, entry):
    data = {
        "format": "kowalevski-cas certificate",
        "version": 2,
        "claim": "c",
        "spaces": [space],
        "goals": [goal],
    }
    evidence = entry if sign == "holds" else {"goal": 0, **entry}
    return seal({**data, "sign": sign, "evidence": [evidence]})
