r"""A second reader: from TeX straight to numbers, by no code of the first one.

Braces are resolved first, as TeX does it: macros take their arguments, fonts their letters. What
is left is a row of signs and boxes, of which the value is computed while it is read; there is no
tree. What a name is (number, vector, matrix, function, time) it is told.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from tests.notation import numbers as n

TOKEN = re.compile(
    r"%[^\n]*|\.\.\.|\\(?:\\(?:\s*\[[^\]]*\])?|[A-Za-z]+\*?|.)|[0-9]+\.[0-9]+|[0-9]|\S", re.DOTALL
)
NOTHING = set(
    r"""\displaystyle \left \right \mathop \nolimits \, \! \; \: \> ~ $ \nonumber \noindent
    \big \Big \bigl \bigr \Bigl \Bigr \limits .""".split()
) | {"\\ "}
LOST = (r"\phantom", r"\label", r"\tag", r"\hspace")
SWITCHES = {r"\bf": "B", r"\rm": "R"}
FONTS = dict.fromkeys((r"\bs", r"\mathbf", r"\boldsymbol", r"\bm", r"\vec"), "B") | {
    r"\mathrm": "R", r"\operatorname": "R", r"\text": "R", r"\tilde": "T", r"\hat": "H",
}  # fmt: skip
BOXES = {r"\frac": 2, r"\tfrac": 2, r"\dfrac": 2, r"\sqrt": 1, "^": 1, "_": 1} | dict.fromkeys(
    (r"\dot", r"\ddot", r"\dddot", r"\overline", r"\bar"), 1
)
RELATIONS = {"=": "=", r"\equiv": r"\equiv", r"\ne": r"\ne", r"\neq": r"\ne"} | {
    "<": "<", ">": ">", r"\le": r"\le", r"\leq": r"\le", r"\leqslant": r"\le",
    r"\ge": r"\ge", r"\geq": r"\ge", r"\geqslant": r"\ge",
    r"\approx": r"\approx", r"\to": r"\to",
}  # fmt: skip
BREAKS = {"&": "cell", r"\quad": "gap", r"\qquad": "gap", r"\cr": "row", ",": "comma"}
PAIRS = {"(": ")", "[": "]", r"\{": r"\}", r"\langle": r"\rangle", r"\lvert": r"\rvert"}
WORDS = {*RELATIONS, r"\cdot", r"\times", r"\ldots", r"\Re", r"\Im", r"\partial", r"\prime"}
WORDS |= {*PAIRS, *PAIRS.values(), r"\sum", r"\pm", r"\mp", r"\over", r"\vert"}
BARS = ("|", r"\|", r"\vert")
MATRICES = ("pmatrix", "matrix", "bmatrix", "vmatrix")
NAMED = ("sin", "cos", "tan", "cot", "sec", "exp", "ln", "sinh", "cosh", "tanh", "arctan", "det")
SAME = {"tg": "tan", "ctg": "cot", "sh": "sinh", "ch": "cosh", "th": "tanh", "arctg": "arctan"}
UNICODE = {"−": "-", "ω": r"\omega ", "≤": r"\le ", "∂": r"\partial ", "·": r"\cdot "}
BINARY = {*RELATIONS, "+", "-", r"\pm", r"\mp", r"\cdot", r"\times", "/"}


class Letter(str):
    """A letter with its font before it."""


@dataclass
class Box:
    """A macro with its arguments, each a row."""

    macro: str
    arguments: list


@dataclass
class Words:
    """What the names are, by their keys."""

    ranks: dict
    functions: set
    times: set
    moving: set

    @classmethod
    def of(cls, vocabulary):
        """The words of a vocabulary, which is asked for nothing but its names."""
        ranks = {key(name): rank for name, rank in vocabulary.ranks.items()}
        names = (vocabulary.functions, vocabulary.times, vocabulary.moving)
        return cls(ranks, *({*map(key, some)} for some in names))


def key(name):
    r"""How a name is called here: ``\boldsymbol{\alpha}_1`` is ``Balpha_1``."""
    for macro, font in FONTS.items():
        name = name.replace(macro + "{", font)
    return re.sub(r"[\\{}\s]", "", name)


# -- braces --------------------------------------------------------------------------------------


def boxes(tex):
    """The row of signs and boxes in a source."""
    for sign, macro in UNICODE.items():
        tex = tex.replace(sign, macro)
    return group([t for t in TOKEN.findall(tex) if t[0] != "%"][::-1], "", None)


def group(tokens, font, closing):
    """What stands up to the closing token."""
    row, above = [], None
    while tokens:
        token = tokens.pop()
        if token == closing:
            return row if above is None else [Box(r"\frac", [above, row])]
        if token == r"\over":
            above, row = row, []
            continue
        if token in SWITCHES:
            font = SWITCHES[token]
        else:
            row += one(token, tokens, font)
    assert closing is None, f"{closing} is missing"
    return row


def argument(tokens, font):
    """The argument that comes next."""
    return one(tokens.pop(), tokens, font)


def one(token, tokens, font):
    """What a token begins."""
    if token == "{":
        return group(tokens, font, "}")
    if token in NOTHING:
        return []
    if token in LOST:
        argument(tokens, "")
        return []
    if token in FONTS:  # an accent stands over the letter, whatever its type
        over = "".join(sign for sign in font if sign in "HT")
        accent = FONTS[token] in "HT"
        return argument(tokens, FONTS[token] + font if accent else over + FONTS[token])
    if token in BOXES:
        return [Box(token, [argument(tokens, font) for _ in range(BOXES[token])])]
    if token == r"\begin":
        return environment(tokens, font)
    if token[:2] == "\\\\":
        return ["row"]
    if token in BREAKS:
        return [BREAKS[token]]
    if not re.fullmatch(r"\\?[A-Za-z]+", token) or token in WORDS:
        return [token]
    return [letter(token, tokens, font)]


def letter(token, tokens, font):
    """A letter, or a whole word in upright letters; a single upright letter is as any other."""
    if font != "R" or token[0] == "\\":
        token = token.removeprefix("\\")
        return Letter(font.replace("R", "") + SAME.get(token, token))
    while tokens and re.fullmatch("[A-Za-z]", tokens[-1]):
        token += tokens.pop()
    if token in ("Re", "Im", "diag", "const"):
        return "\\" + token
    token = SAME.get(token, token)
    return Letter(token if len(token) == 1 or token in NAMED else "R" + token)


def environment(tokens, font):
    """A matrix, or rows of formulas."""
    name = "".join(argument(tokens, ""))
    if name == "array":
        argument(tokens, "")
    row = []
    while tokens[-1] != r"\end":
        row += one(tokens.pop(), tokens, font)
    tokens.pop()
    argument(tokens, "")
    if name not in MATRICES:
        return ["row", *row, "row"]
    box = Box("matrix", [row])
    return [r"\lvert", box, r"\rvert"] if name == "vmatrix" else [box]


# -- statements ----------------------------------------------------------------------------------


def split(row):
    """The statements in a row: between commas, and between rows that no sign joins."""
    found, depth, strongest, empty_cell = [[]], 0, "comma", False
    for k, item in enumerate(row):
        depth += (item in PAIRS) - (item in PAIRS.values()) if isinstance(item, str) else 0
        if depth or isinstance(item, Box | Letter) or item not in ("row", "cell", "gap", "comma"):
            if strongest and found[-1] and not joins(found[-1], row[k:], strongest, empty_cell):
                found.append([])
            elif strongest == "row" and found[-1][-1:] == [item] and item in BINARY:
                found[-1].pop()  # a sign that is repeated in the next row
            found[-1].append(item)
            strongest, empty_cell = "", False
        elif "comma" in (item, strongest):
            strongest = "comma"
        else:
            empty_cell |= item == "cell" and strongest == "row"
            strongest = "row" if "row" in (item, strongest) else item
    return [one for statement in found if statement for one in signs(statement)]


def signs(row):
    """A row with the upper signs, and one with the lower; itself if there are none."""
    upper = {r"\pm": "+", r"\mp": "-"}
    lower = {r"\pm": "-", r"\mp": "+"}
    found = [put(row, of) for of in (upper, lower)]
    return found if found[0] != row else [row]


def put(row, of):
    """A row, with what stands in its boxes, with other signs."""
    return [
        Box(i.macro, [put(one, of) for one in i.arguments])
        if isinstance(i, Box)
        else i
        if isinstance(i, Letter | list)
        else of.get(i, i)
        for i in row
    ]


def joins(before, rest, strongest, empty_cell):
    """Whether a statement runs on behind a break."""
    item = rest[0]
    if strongest == "comma":
        return False
    if isinstance(before[-1], str) and before[-1] in BINARY:
        return True
    if not isinstance(item, str) or item not in BINARY:
        return False
    stop = next((k for k, x in enumerate(rest) if x in ("row", "comma", "gap")), len(rest))
    complete = any(x in RELATIONS for x in rest[:stop] if isinstance(x, str))
    return item != "-" or empty_cell or not complete


# -- values --------------------------------------------------------------------------------------


class Reader:
    """Reads a row from left to right, and computes."""

    def __init__(self, row, words, point, indices=()):
        self.row, self.words, self.point, self.at = row, words, point, 0
        self.indices = dict(indices)  # of sums, with their values
        self.bars = 0

    @property
    def here(self):
        return self.row[self.at] if self.at < len(self.row) else ""

    def take(self):
        self.at += 1
        return self.row[self.at - 1]

    def within(self, row):
        """The value of a whole row."""
        inner = Reader(row, self.words, self.point, self.indices)
        value = inner.sum()
        assert inner.at == len(row), f"{row[inner.at :]} is left"
        return value

    def chain(self):
        """The values of the members, and the signs between them."""
        values, signs = [self.sum()], []
        while self.here in RELATIONS:
            signs.append(RELATIONS[self.take()])
            values.append(self.sum())
        assert self.at == len(self.row), f"{self.row[self.at :]} is left"
        return values, signs

    def sum(self):
        total = None
        while total is None or self.here in ("+", "-"):
            sign = 1
            while self.here in ("+", "-"):
                sign = -sign if self.take() == "-" else sign
            term = self.term()
            if sign < 0:
                term = n.each(n.Value.__neg__, term)
            total = term if total is None else n.plus(total, term)
        return total

    def term(self):
        value = self.factors()
        while self.here in (r"\cdot", r"\times"):
            product = n.dot if self.take() == r"\cdot" else n.cross
            other = self.factors()
            vectors = n.rank(value) == n.rank(other) == 1
            value = product(value, other) if vectors else n.times(value, other)
        return value

    def factors(self):
        value = self.factor()
        while self.here:
            if self.here == "/":
                self.take()
                value = n.over(value, self.factor())
            elif self.starts(self.here):
                value = n.times(value, self.factor())
            else:
                break
        return value

    def starts(self, item):
        return (
            isinstance(item, Box | Letter)
            or item in PAIRS
            or item[0].isdigit()
            or (item in BARS and not self.bars)
            or item in (r"\Re", r"\Im", r"\diag", r"\ldots", "...", r"\sum", r"\partial")
        )

    def factor(self):
        item = self.take()
        if item in ("d", r"\partial") and item not in self.words.ranks:
            return self.rate(item)
        if isinstance(item, Letter):
            return self.name(item, [])
        if isinstance(item, Box):
            return self.box(item)
        if item[0].isdigit():
            while isinstance(self.here, str) and self.here.isdigit():
                item += self.take()
            return self.scripts(n.number(float(item)))
        return self.marked(item)

    def marked(self, item):
        """What a sign begins."""
        if item in BARS:
            self.bars += 1
            value = self.sum()
            self.bars -= 1
            assert self.take() == item
            return self.scripts(self.modulus(value))
        if item == r"\sum":
            return self.summed()
        if item in PAIRS:
            self.at -= 1
            return self.scripts(self.bracket())
        if item in (r"\ldots", "..."):
            return self.point.scalar("...")
        if item == r"\const":
            return "const"
        if item == r"\diag":
            return n.diagonal(n.padded(self.listed()))
        assert item in (r"\Re", r"\Im"), f"{item} is no factor"
        return n.part(self.operand(), item == r"\Re")

    def modulus(self, value):
        """What bars around a value mean, by its rank."""
        if n.rank(value) == 2:
            return self.point.applied("det", [value])
        return n.length(value)

    def rate(self, d):
        """A derivative with a slash."""
        order = int("".join(self.take().arguments[0])) if isinstance(self.here, Box) else 1
        value = self.factor()
        assert (self.take(), self.take()) == ("/", d)
        by, end = [], self.at
        while end < len(self.row) and isinstance(self.row[end], Letter | Box):
            if by and isinstance(self.row[end], Letter):
                break
            by.append(self.row[end])
            end += 1
        self.at = end
        times = self.differential(d, by)
        assert len(times) == order
        return derived(value, times)

    def summed(self):
        """A sum over an index: the same signs are read for each of its values."""
        limits = {}
        while isinstance(self.here, Box) and self.here.macro in "_^":
            box = self.take()
            limits[box.macro] = box.arguments[0]
        index, equal, *first = limits["_"]
        assert equal == "="
        total, at = None, self.at
        for k in range(int("".join(first)), int("".join(limits["^"])) + 1):
            self.at, self.indices[index] = at, k
            term = self.term()
            total = term if total is None else n.plus(total, term)
        del self.indices[index]
        return total

    def operand(self):
        return (
            self.bracket() if isinstance(self.here, str) and self.here in PAIRS else self.factor()
        )

    def bracket(self):
        opening = self.here
        values = self.listed()
        if opening == r"\lvert":
            return self.modulus(values[0])
        if len(values) == 1:
            return values[0]
        if opening == "[":
            return n.commutator(*values)
        if opening == r"\{":
            return n.bracket(*values)
        if len(values) == 2 and [n.rank(value) for value in values] == [1, 1]:
            return n.dot(*values)
        return n.padded(values)

    def listed(self):
        closing = PAIRS[self.take()]
        values = [self.sum()]
        while self.here == "comma":
            self.take()
            values.append(self.sum())
        assert self.take() == closing, f"{closing} is missing"
        return values

    def name(self, item, accents):
        """A letter with all that stands on it; or a function and its argument."""
        called, primes, power = str(item), 0, None
        while True:
            if isinstance(self.here, Box) and self.here.macro == "_":
                index = self.take().arguments[0]
                called += "_" + "".join(str(self.indices.get(item, item)) for item in index)
            elif self.at_time(called):
                self.at += 3
            elif count := self.primes():
                primes += count
            elif starred := self.starred(called):
                called = starred
            elif isinstance(self.here, Box) and self.here.macro == "^" and power is None:
                power = self.within(self.take().arguments[0])
            else:
                break
        called, primes = self.primed(called, primes)
        function = called in self.words.functions
        listed = isinstance(self.here, str) and self.here in PAIRS
        if function and (listed or called not in self.words.ranks):
            arguments = self.listed() if listed else [self.single()]
            value = self.point.applied(called, arguments)
            return self.scripts(value if power is None else n.to(value, power))
        if called == "e" and called not in self.words.ranks:
            return self.point.applied("exp", [power])
        if called in self.indices:
            value = n.number(self.indices[called])
            return value if power is None else n.to(value, power)
        value = derived(self.value(called, accents), ["prime"] * primes)
        return value if power is None else n.to(value, power)

    def primed(self, called, primes):
        """A name with its primes, as k', or beside the primes that derive it."""
        whole = called + "'" * primes
        return (whole, 0) if whole in self.words.ranks else (called, primes)

    def value(self, called, accents):
        """The value of a name under accents."""
        of = (self.point.scalar, self.point.vector, self.point.matrix)[self.words.ranks[called]]
        value = of(called)
        for accent in accents:
            value = accented(value, accent)
        return value

    def single(self):
        """The argument of a function without brackets, as in sin 2x and cos ωt."""
        start, found = self.at, []
        while isinstance(self.here, Letter | Box) or str(self.here).isdigit():
            if str(self.here) in {*NAMED, *self.words.functions}:
                break
            found.append(self.here)
            self.take()
        self.at = start
        if len(found) > 1 and str(found[-1]) in self.words.times:
            value = self.factor()
            for _ in found[1:]:
                value = n.times(value, self.factor())
            return value
        number = isinstance(self.here, str) and self.here.isdigit()
        value = self.factor()
        more = number and isinstance(self.here, Letter) and str(self.here) not in NAMED
        return n.times(value, self.factor()) if more else value

    def at_time(self, called):
        """Whether the time stands here in brackets, behind a name that moves."""
        three = self.row[self.at : self.at + 3]
        return (
            called in self.words.moving
            and len(three) == 3
            and three[::2] == ["(", ")"]
            and three[1] in self.words.times
        )

    def starred(self, called):
        """The name with the star that stands here, before its index; nothing, if none does."""
        if not isinstance(self.here, Box) or self.here != Box("^", [["*"]]):
            return ""
        self.take()
        letter, low, index = called.partition("_")
        return f"{letter}^*{low}{index}"

    def primes(self):
        """How many primes stand here, if that is what stands here."""
        if self.here == "'":
            self.take()
            return 1
        if isinstance(self.here, Box) and self.here.macro == "^":
            raised = self.here.arguments[0]
            if raised and all(item in ("'", r"\prime") for item in raised):
                self.take()
                return len(raised)
        return 0

    def scripts(self, value):
        while (isinstance(self.here, Box) and self.here.macro == "^") or self.here == "'":
            if count := self.primes():
                value = derived(value, ["prime"] * count)
            else:
                value = n.to(value, self.within(self.take().arguments[0]))
        return value

    def box(self, box):
        if box.macro == "matrix":
            return self.scripts(self.matrix(box.arguments[0]))
        if box.macro == r"\sqrt":
            return self.scripts(self.within(box.arguments[0]).root())
        if box.macro in (r"\frac", r"\tfrac", r"\dfrac"):
            return self.fraction(*box.arguments)
        accents, inner = [box.macro], box.arguments[0]
        while len(inner) == 1 and isinstance(inner[0], Box) and inner[0].macro in ACCENTS:
            accents, inner = [inner[0].macro, *accents], inner[0].arguments[0]
        if len(inner) == 1 and isinstance(inner[0], Letter):
            return self.name(inner[0], accents)
        return self.scripts(accented(self.within(box.arguments[0]), box.macro))

    def fraction(self, above, below):
        d = below[0]
        if above[0] == d and d in ("d", r"\partial") and (times := self.differential(d, below[1:])):
            rest = above[1:]
            if rest and isinstance(rest[0], Box) and rest[0].macro == "^":
                rest = rest[1:]
            if rest:
                return self.scripts(derived(self.within(rest), times))
            return derived(self.scripts(self.operand()), times)
        return self.scripts(n.over(self.within(above), self.within(below)))

    def differential(self, d, row):
        """The times of a derivative, by the variables below; none if these are no such."""
        if d in row:
            first, second = row[: row.index(d)], row[row.index(d) + 1 :]
            return self.differential(d, first) + self.differential(d, second)
        called, order = "", 1
        for item in row:
            if isinstance(item, Letter) and not called:
                called = str(item)
            elif isinstance(item, Box) and item.macro == r"\dot" and not called:
                (letter,) = item.arguments[0]
                called = f"dot{letter}"
            elif isinstance(item, Box) and item.macro == "_" and called:
                called += "_" + "".join(map(str, item.arguments[0]))
            elif isinstance(item, Box) and item.macro == "^" and called:
                order = int("".join(item.arguments[0]))
            else:
                return []
        known = self.words.times if d == "d" else self.words.ranks
        if called.removeprefix("dot") not in known:
            return []
        return [called if d == "d" else "∂" + called] * order

    def matrix(self, row):
        rows = [[[]]]
        for item in row:
            if item == "row":
                rows.append([[]])
            elif item == "cell":
                rows[-1].append([])
            else:
                rows[-1][-1].append(item)
        values = [[self.within(cell) for cell in cells] for cells in rows if cells != [[]]]
        if len(values) == 1 or len(values[0]) == 1:
            return n.padded([value for line in values for value in line])
        return n.padded([n.padded(line) for line in values])


ACCENTS = {r"\dot": 1, r"\ddot": 2, r"\dddot": 3, r"\overline": 0, r"\bar": 0}


def accented(value, accent):
    if ACCENTS[accent]:
        return derived(value, ["dot"] * ACCENTS[accent])
    return n.each(n.Value.conjugate, value)


def derived(value, times):
    for time in times:
        value = n.each(lambda part, time=time: part.derivative(time), value)
    return value


def read(tex, words, point):
    """The values and signs of every statement of a source."""
    return [Reader(row, words, point).chain() for row in split(boxes(tex))]
