r"""Setting formulas: old TeX made plain, widths estimated, long displays broken into lines.

What comes in is a formula as an author printed it (``{\bf I}``, ``\mathop{\rm Re}\nolimits``,
rows of an ``array``) or as the program wrote it (polynomials of many terms). What goes out is
plain LaTeX that both pdflatex and pandoc read, broken where a mathematician would break it:
before a relation or a sign, in brackets only if there is no other way.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise
from typing import Final

LINES: Final = 12
"""Displays of the program's own steps longer than this are shortened by dots."""

_SCRIPT: Final = 0.72
_DEEP: Final = 60
_TOKEN: Final = re.compile(r"\\[A-Za-z]+\*?|\\.|%[^\n]*\n?|\s+|.", re.DOTALL)

_WIDE: Final = dict.fromkeys("mwMW", 0.88) | dict.fromkeys("ABDGHKNOQRUXVY", 0.77)
_NARROW: Final = dict.fromkeys("ijlIft", 0.37) | {"'": 0.24, ".": 0.28, "/": 0.5, "|": 0.28}
_GREEK: Final = dict.fromkeys((r"\Omega", r"\Psi", r"\Phi", r"\Theta", r"\Sigma"), 0.75) | {
    r"\alpha": 0.64, r"\omega": 0.64, r"\psi": 0.66, r"\varphi": 0.65, r"\phi": 0.6,
    r"\xi": 0.45, r"\tau": 0.46, r"\theta": 0.48, r"\iota": 0.36, r"\zeta": 0.45,
}  # fmt: skip
_RELATIONS: Final = {
    "=", "<", ">", r"\equiv", r"\ne", r"\neq", r"\le", r"\leq", r"\ge", r"\geq", r"\to",
    r"\mapsto", r"\in", r"\sim", r"\approx", r"\propto", r"\Rightarrow", r"\Leftrightarrow",
    r"\iff", r"\implies", r"\subset", r"\subseteq", r"\mid", r"\longrightarrow", r"\notin",
    r"\gg", r"\ll", r"\simeq", r"\cong", r"\rightarrow", r"\perp", r"\parallel",
}  # fmt: skip
_SIGNS: Final = {"+", "-", r"\pm", r"\mp"}
_BINARY: Final = _SIGNS | {
    r"\times", r"\cdot", "*", r"\cap", r"\cup", r"\wedge", r"\circ", r"\setminus", r"\otimes",
    r"\oplus", r"\land", r"\lor", r"\ast", r"\bullet",
}  # fmt: skip
_OPEN: Final = {"(", "[", r"\{", r"\langle", r"\lfloor", r"\lbrace"}
_CLOSE: Final = {")", "]", r"\}", r"\rangle", r"\rfloor", r"\rbrace"}
_DELIMITERS: Final = _OPEN | _CLOSE | {".", "|", r"\|", "/", r"\vert", r"\Vert", "<", ">"}
_PUNCTUATION: Final = {",", ";"}
_SPACES: Final = {
    r"\,": 0.17, r"\:": 0.22, r"\;": 0.28, r"\ ": 0.33, "~": 0.33, r"\!": -0.17, r"\quad": 1.0,
    r"\qquad": 2.0, r"\>": 0.22, r"\thinspace": 0.17, r"\enspace": 0.5,
}  # fmt: skip
_FONTS: Final = {
    r"\bf": r"\mathbf", r"\rm": r"\mathrm", r"\it": r"\mathit", r"\cal": r"\mathcal",
    r"\sf": r"\mathsf", r"\tt": r"\mathtt", r"\bs": r"\boldsymbol", r"\bm": r"\boldsymbol",
    r"\mbox": r"\text", r"\hbox": r"\text", r"\textrm": r"\text", r"\textnormal": r"\text",
}  # fmt: skip
_ONE: Final = {
    r"\mathbf", r"\mathrm", r"\mathit", r"\mathcal", r"\mathsf", r"\mathtt", r"\mathbb",
    r"\mathfrak", r"\boldsymbol", r"\overline", r"\underline", r"\bar", r"\dot", r"\ddot",
    r"\hat", r"\tilde", r"\vec", r"\widehat", r"\widetilde", r"\operatorname",
    r"\operatorname*", r"\phantom", r"\mathop", r"\underbrace", r"\overbrace",
}  # fmt: skip
_FRACTIONS: Final = {r"\frac", r"\dfrac", r"\tfrac", r"\cfrac"}
_DROPPED: Final = {
    r"\displaystyle", r"\textstyle", r"\nolimits", r"\limits", r"\nonumber", r"\notag", r"\hfill",
    r"\allowbreak", r"\nobreak", r"\noindent", r"\small", r"\strut", r"\mathstrut", r"\relax",
}  # fmt: skip
_SIZED: Final = re.compile(r"\\([bB]igg?)([lrm]?)$")
_FUNCTION: Final = re.compile(
    r"\\(sin|cos|tan|cot|exp|log|ln|det|dim|ker|max|min|lim|arctan|arcsin|arccos|deg|gcd)$"
)


@dataclass(frozen=True, slots=True)
class Node:
    r"""A piece of a formula: its plain TeX, its width in em, its class.

    ``kind`` is one of ord, bin, rel, open, close, punct, space, row, cell. ``inner`` holds the
    nodes of a pair ``\left…\right`` or of the numerator of a fraction (whose denominator is
    ``below``), so that either can be taken apart where it does not fit on a line.
    """

    tex: str
    width: float
    kind: str = "ord"
    inner: tuple[Node, ...] = ()
    below: str = ""
    rows: tuple[tuple[tuple[Node, ...], ...], ...] = ()
    tall: bool = False


class _TooDeepError(Exception):
    """Brackets within brackets, deeper than anybody prints."""


class _Reader:
    """Reads TeX tolerantly: what does not balance is balanced, what is unknown is kept."""

    def __init__(self, tex: str) -> None:
        self.tokens = [t for t in _TOKEN.findall(tex) if not t.startswith("%")]
        self.at = 0
        self.depth = 0

    def peek(self) -> str:
        while self.at < len(self.tokens) and self.tokens[self.at].isspace():
            self.at += 1
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def next(self) -> str:
        token = self.peek()
        self.at += 1
        return token

    def nodes(self, *stops: str) -> list[Node]:
        """The nodes up to one of the stops (which is left standing) or the end."""
        self.depth += 1
        if self.depth > _DEEP:
            raise _TooDeepError
        found: list[Node] = []
        while token := self.peek():
            if token in stops:
                break
            self.at += 1
            if token == "}":
                continue
            if token in {"^", "_", "'"}:
                base = found.pop() if found else Node("{}", 0)
                found.append(self.script(base, token))
            elif token in _DROPPED:
                if token == r"\displaystyle" and self.peek() == "{":
                    self.next()
                    found += self.group()
            elif token in _FONTS and _FONTS[token] not in {r"\boldsymbol", r"\text"}:
                rest = self.nodes(*stops)
                found.append(self.wrap(_FONTS[token], rest))
            else:
                found += self.node(token)
            if found and found[-1].kind == "close":
                self.close(found)
        self.depth -= 1
        return found

    def close(self, found: list[Node]) -> None:
        r"""Make a pair ``\left…\right`` of plain brackets around something tall."""
        opening = {")": "(", "]": "["}.get(found[-1].tex)
        for place in range(len(found) - 2, -1, -1):
            if found[place].kind == "close" or not opening:
                return
            if found[place].kind == "open":
                inside = found[place + 1 : -1]
                if found[place].tex == opening and not any(
                    n.kind in {"row", "cell"} for n in inside
                ):
                    found[place:] = [_pair(opening, inside, found[-1].tex)]
                return

    def group(self) -> list[Node]:
        """The nodes up to the closing brace, which is consumed."""
        inside = self.nodes("}")
        self.next()
        return inside

    def argument(self) -> list[Node]:
        token = self.next()
        if token == "{":
            return self.group()
        return self.node(token) if token and token not in "}^_&" else []

    def delimiter(self) -> str:
        return self.next() if self.peek() in _DELIMITERS else ""

    def raw(self) -> str:
        """The verbatim text of a braced argument."""
        if self.peek() != "{":
            return ""
        self.at += 1
        start, level = self.at, 1
        while self.at < len(self.tokens):
            level += {"{": 1, "}": -1}.get(self.tokens[self.at], 0)
            self.at += 1
            if not level:
                return "".join(self.tokens[start : self.at - 1])
        return "".join(self.tokens[start:])

    def script(self, base: Node, token: str) -> Node:
        if token == "'":
            return replace(base, tex=base.tex + "'", width=base.width + 0.24, inner=())
        inside = self.argument()
        tex = f"{base.tex}{token}{_braced(inside)}"
        wider = _SCRIPT * _width(inside)
        already = len(base.tex) > 1 and base.rows == () and base.below == "script"
        width = max(base.width, base.width - 0.4 + wider) if already else base.width + wider
        inner: tuple[Node, ...] = ()
        if base.inner and base.inner[0].kind == "open":
            last = base.inner[-1]
            inner = (*base.inner[:-1], replace(last, tex=f"{last.tex}{token}{_braced(inside)}"))
        return replace(base, tex=tex, width=width, inner=inner, below="script")

    def wrap(self, command: str, inside: Sequence[Node]) -> Node:
        width = _width(inside) * (1.1 if command in {r"\mathbf", r"\boldsymbol"} else 1.0)
        return Node(f"{command}{{{_tex(inside)}}}", width)

    def node(self, token: str) -> list[Node]:
        if token == "{":
            inside = self.group()
            if len(inside) == 1:
                return inside
            return [Node(f"{{{_tex(inside)}}}", _width(inside), inner=())]
        if token in {r"\\", r"\cr"}:
            if self.peek() == "[":
                end = next(
                    (k for k in range(self.at, len(self.tokens)) if self.tokens[k] == "]"), self.at
                )
                if re.fullmatch(
                    r"\[[\d.\s-]*(mm|pt|em|ex|cm)\]", "".join(self.tokens[self.at : end + 1])
                ):
                    self.at = end + 1
            return [Node(r"\\", 0, "row")]
        if token == "&":
            return [Node("&", 0, "cell")]
        if token in _SPACES:
            return [Node(_spaced(token.replace("~", r"\ ")), _SPACES[token], "space")]
        if token == r"\hspace":
            self.raw()
            return []
        if token == r"\label":
            self.raw()
            return []
        if token == r"\phantom":
            self.argument()
            return []
        if token in _FRACTIONS:
            return [self.fraction(token)]
        if token == r"\sqrt":
            return [self.root()]
        if token in {r"\bs", r"\bm"}:
            return [self.wrap(r"\boldsymbol", self.argument())]
        if _FONTS.get(token, token) == r"\text":
            text = self.raw()
            return [Node(rf"\text{{{text}}}", 0.5 * len(text))]
        if token in {r"\operatorname", r"\operatorname*"}:
            text = self.raw()
            return [Node(rf"\operatorname{{{text}}}", 0.5 * len(text) + 0.17)]
        if token == r"\mathop":
            inside = self.argument()
            name = re.sub(r"\\mathrm\{([A-Za-z]+)\}", r"\1", _tex(inside))
            return [Node(rf"\operatorname{{{name}}}", _width(inside) + 0.17)]
        if token in _ONE:
            return [self.wrap(token, self.argument())]
        if token == r"\left":
            return [self.pair()]
        if sized := _SIZED.match(token):
            if not (delimiter := self.delimiter()):
                return []
            kind = {"l": "open", "r": "close"}.get(sized[2]) or _kind(delimiter)
            return [Node(f"{token}{delimiter}", 0.6, kind)]
        if token == r"\begin":
            return [self.environment()]
        if token == r"\end":
            self.raw()
            return []
        if token == r"\right":
            self.delimiter()
            return []
        if _FUNCTION.match(token):
            return [Node(token + " ", 0.5 * (len(token) - 1) + 0.17)]
        return [_plain(token)]

    def fraction(self, command: str) -> Node:
        above, below = self.argument(), self.argument()
        scale = _SCRIPT if command == r"\tfrac" else 1.0
        width = scale * max(_width(above), _width(below)) + 0.24
        return Node(
            f"{command}{{{_tex(above)}}}{{{_tex(below)}}}",
            width,
            inner=tuple(above),
            below=_tex(below),
            tall=True,
        )

    def root(self) -> Node:
        index = ""
        if self.peek() == "[":
            self.next()
            index = f"[{_tex(self.nodes(']'))}]"
            self.next()
        inside = self.argument()
        return Node(rf"\sqrt{index}{{{_tex(inside)}}}", _width(inside) + 0.9)

    def pair(self) -> Node:
        opening = self.delimiter() or "."
        inside = self.nodes(r"\right")
        self.next()
        closing = self.delimiter() or "."
        return _pair(opening, inside, closing)

    def environment(self) -> Node:
        name = self.raw()
        columns = ""
        if name.startswith("array"):
            columns = "{" + self.raw() + "}"
        body = self.nodes(r"\end")
        self.next()
        self.raw()
        rows = tuple(tuple(_split(row, "cell")) for row in _split(body, "row"))
        rows = tuple(row for row in rows if any(row))
        count = max((len(row) for row in rows), default=0)
        widths = [max((_width(r[k]) for r in rows if k < len(r)), default=0) for k in range(count)]
        body_tex = r" \\ ".join(" & ".join(_tex(cell) for cell in row) for row in rows)
        tex = rf"\begin{{{name}}}{columns} {body_tex} \end{{{name}}}"
        return Node(tex, sum(widths) + count + 0.8, rows=rows, tall=True)


def _pair(opening: str, inside: Sequence[Node], closing: str) -> Node:
    tall = any(node.tall for node in inside)
    left, right = (r"\left", r"\right") if tall or "." in {opening, closing} else ("", "")
    return Node(
        f"{left}{opening} {_tex(inside)} {right}{closing}"
        if left
        else f"{opening}{_tex(inside)}{closing}",
        _width(inside) + (1.5 if tall else 0.8),
        inner=(Node(opening, 0.45, "open"), *inside, Node(closing, 0.45, "close")),
        tall=tall,
    )


def _plain(token: str) -> Node:
    kind = _kind(token)
    if kind == "rel":
        wide = {r"\Leftrightarrow": 1.0, r"\iff": 2.2, r"\implies": 2.0, r"\longrightarrow": 1.7}
        return Node(_spaced(token), wide.get(token, 0.8) + 0.56, kind)
    if kind == "bin":
        return Node(_spaced(token), (0.28 if token == r"\cdot" else 0.78) + 0.44, kind)
    if kind == "punct":
        return Node(token, 0.45, kind)
    if kind in {"open", "close"}:
        return Node(_spaced(token), 0.39, kind)
    if token.startswith("\\"):
        return Node(_spaced(token), _GREEK.get(token, 0.58))
    return Node(token, _WIDE.get(token) or _NARROW.get(token) or (0.5 if token.isdigit() else 0.58))


def _kind(token: str) -> str:
    for tokens, kind in (
        (_RELATIONS, "rel"),
        (_BINARY, "bin"),
        (_OPEN, "open"),
        (_CLOSE, "close"),
        (_PUNCTUATION, "punct"),
    ):
        if token in tokens:
            return kind
    return "ord"


def _spaced(token: str) -> str:
    return token + " " if token[0] == "\\" and token[-1].isalpha() else token


def _tex(nodes: Iterable[Node]) -> str:
    text, before = "", "open"
    for node in nodes:
        if node.kind == "bin" and before not in {"ord", "close"}:
            text += _spaced(node.tex.strip())  # a sign, not an operation
        elif node.kind in {"bin", "rel"}:
            text += f" {node.tex.strip()} "
        else:
            text += node.tex + (" " if node.kind == "punct" else "")
        before = node.kind
    return re.sub(r"(?<!\\) +", " ", text).strip(" ") if not text.endswith("\\ ") else text


def _braced(nodes: Sequence[Node]) -> str:
    tex = _tex(nodes)
    return tex if len(tex) == 1 else f"{{{tex}}}"


def _width(nodes: Iterable[Node]) -> float:
    total, before = 0.0, "open"
    for node in nodes:
        unary = node.kind == "bin" and before in {"open", "bin", "rel", "punct", "space"}
        total += node.width - (0.44 if unary else 0.0)
        before = node.kind
    return total


def _split(nodes: Iterable[Node], kind: str) -> list[tuple[Node, ...]]:
    parts: list[list[Node]] = [[]]
    for node in nodes:
        if node.kind == kind:
            parts.append([])
        else:
            parts[-1].append(node)
    return [tuple(part) for part in parts]


@lru_cache(maxsize=4096)
def _read(tex: str) -> tuple[Node, ...]:
    try:
        return _trim(_Reader(_unwrapped(tex)).nodes())
    except _TooDeepError:
        return (Node(" ".join(tex.split()), 0.4 * len(tex)),)


def _unwrapped(tex: str) -> str:
    """The formula without display delimiters and without braces around the whole."""
    tex = tex.strip()
    for opening, closing in ((r"\[", r"\]"), ("$$", "$$"), ("$", "$")):
        if tex.startswith(opening) and tex.endswith(closing) and len(tex) > len(opening + closing):
            tex = tex[len(opening) : -len(closing)].strip()
    while tex.startswith("{") and _closing_brace(tex) == len(tex) - 1:
        tex = tex[1:-1].strip()
    if tex.startswith("{") and tex.count("{") == tex.count("}") + 1:
        tex = tex[1:].strip()
    return tex


def _closing_brace(tex: str) -> int:
    level = 0
    for match in re.finditer(r"\\.|[{}]", tex):
        level += {"{": 1, "}": -1}.get(match[0], 0)
        if not level:
            return match.start()
    return -1


def _trim(nodes: Sequence[Node]) -> tuple[Node, ...]:
    start, end = 0, len(nodes)
    while start < end and nodes[start].kind in {"space", "row", "cell"}:
        start += 1
    while end > start and nodes[end - 1].kind in {"space", "row", "cell"}:
        end -= 1
    return tuple(nodes[start:end])


def plain(tex: str) -> str:
    r"""The same formula in today's LaTeX, on one line.

    >>> plain(r"{\bf e}_1 \times {\bs \alpha}")
    '\\mathbf{e}_1 \\times \\boldsymbol{\\alpha}'
    >>> plain(r"\mathop{\rm Re}\nolimits (x_2 z_1)")
    '\\operatorname{Re}(x_2z_1)'
    """
    return r"\quad ".join(_tex(statement) for statement in _statements(_read(tex)))


def width(tex: str) -> float:
    """The estimated width of a formula set on one line in display style, in em."""
    return _width(_read(tex))


# ---------------------------------------------------------------------- lines


@dataclass(frozen=True, slots=True)
class _Break:
    """A place where a line can begin: how deep in brackets, and what it costs."""

    place: int
    depth: int = 0
    cost: float = 0.0


@dataclass(frozen=True, slots=True)
class _Line:
    """One line of a display: what stands left of the alignment, and right of it."""

    left: str
    right: str
    indent: int = 0

    @property
    def tex(self) -> str:
        space = r"\quad " * (self.indent % 2) + r"\qquad " * (self.indent // 2)
        sign = re.match(r"([+-]|\\pm|\\mp) ?", self.right) if self.indent else None
        right = f"{{}} {sign[1]} {self.right[sign.end() :]}" if sign else self.right
        return f"{self.left} & {space}{right}".strip()


def display(tex: str, room: float, *, lines: int | None = None) -> str:
    r"""The inside of a display: the formula broken into lines no wider than ``room`` em.

    A display of more than ``lines`` lines is shortened: dots stand for the middle.
    """
    return _set(_statements(_read(tex)), room, lines)


def displays(formulas: Sequence[str], room: float, *, lines: int | None = None) -> str:
    """The inside of a display of several formulas, one under the other."""
    return _set([row for tex in formulas for row in _statements(_read(tex))], room, lines)


def _set(statements: Sequence[tuple[Node, ...]], room: float, lines: int | None) -> str:
    room *= 0.97  # estimates are good to a few per cent
    if len(statements) == 1 and _width(statements[0]) <= room:
        return _tex(statements[0])
    heads = [_head(statement) for statement in statements]
    aligned = all(0 < _width(s[:h]) <= 0.3 * room for s, h in zip(statements, heads, strict=True))
    column = max(_width(s[:h]) for s, h in zip(statements, heads, strict=True)) if aligned else 0.0
    set_lines: list[_Line] = []
    for statement, head in zip(statements, heads, strict=True):
        if aligned:
            body = _broken(statement[head:], room - column, first=True)
            set_lines += [
                replace(line, left=_tex(statement[:head]) if not k else "")
                for k, line in enumerate(body)
            ]
        else:
            set_lines += _broken(statement, room, first=False)
    if lines is not None and len(set_lines) > lines:
        left_out = len(set_lines) - lines + 1
        dots = _Line("", rf"+ \cdots \quad\text{{({left_out} more lines)}}", 1)
        set_lines = [*set_lines[: lines - 2], dots, set_lines[-1]]
    if len(set_lines) == 1:
        line = set_lines[0]
        return f"{line.left} {line.right}".strip()
    body_tex = " \\\\\n".join(line.tex for line in set_lines)
    return f"\\begin{{aligned}}\n{body_tex}\n\\end{{aligned}}"


def _statements(nodes: Sequence[Node]) -> list[tuple[Node, ...]]:
    """The rows of a display; a row that begins with a sign continues the one above."""
    if len(nodes) == 1 and nodes[0].rows and nodes[0].tex.startswith(r"\begin{array}"):
        rows: list[tuple[Node, ...]] = [
            _trim([node for cell in row for node in (*cell, Node(r"\quad ", 1.0, "space"))])
            for row in nodes[0].rows
        ]
    else:
        rows = [tuple(node for node in row if node.kind != "cell") for row in _split(nodes, "row")]
    joined: list[tuple[Node, ...]] = []
    for row in filter(None, map(_trim, rows)):
        if joined and row[0].kind in {"bin", "rel"}:
            repeated = joined[-1][-1].tex == row[0].tex
            joined[-1] = (*(joined[-1][:-1] if repeated else joined[-1]), *row)
        else:
            joined.append(row)
    return joined or [()]


def _head(nodes: Sequence[Node]) -> int:
    """Where the first relation outside brackets stands; 0 if there is none."""
    depth = 0
    for place, node in enumerate(nodes):
        depth += {"open": 1, "close": -1}.get(node.kind, 0)
        if node.kind == "rel" and depth <= 0:
            return place
    return 0


def _loosened(nodes: Sequence[Node], room: float, part: float) -> list[Node]:
    r"""The nodes, with pairs that take more than a part of the line, and wide fractions, apart."""
    loose: list[Node] = []
    for node in nodes:
        if node.inner and node.inner[0].kind == "open" and node.width > part * room:
            first, *inside, last = node.inner
            opening, closing = first.tex.strip(), last.tex.strip()
            if opening != "." and not closing.startswith("."):
                big = r"\Big" if node.tall else ""
                loose.append(Node(f"{big and big + 'l'}{opening}", first.width, "open"))
                loose += _loosened(inside, room, part)
                loose.append(Node(f"{big and big + 'r'}{closing}", last.width, "close"))
                continue
        if node.inner and node.inner[0].kind != "open" and node.width > 0.9 * room:
            below = _Reader(node.below).nodes()
            if _width(below) < 0.6 * room:
                one = Node(rf"\frac{{1}}{{{node.below}}}", _width(below) + 0.24, tall=True)
                loose += [one, Node(r"\Bigl(", 0.6, "open")]
                loose += _loosened(node.inner, room, part)
                loose.append(Node(r"\Bigr)", 0.6, "close"))
                continue
        loose.append(node)
    return loose


def _broken(nodes: Sequence[Node], room: float, *, first: bool) -> list[_Line]:
    """The nodes in lines. With ``first`` the line begins with the relation that is aligned."""
    if _width(nodes) <= room:
        return [_Line("", _tex(nodes))]
    found = []
    for part, price in ((1.0, 0.0), (0.7, 60.0), (0.4, 200.0)):
        loose = _loosened(nodes, room, part)
        cost, cuts = _cuts(loose, room, first)
        found.append((cost + price, -part, cuts, loose))
    _, _, cuts, loose = min(found, key=lambda one: one[:2])
    return [
        _Line("", _tex(_trim(loose[a.place : b.place])), _indent(a, first) if a.place else 0)
        for a, b in pairwise(cuts)
    ]


def _cuts(nodes: Sequence[Node], room: float, first: bool) -> tuple[float, list[_Break]]:
    """Where to break, from the beginning to the end, and what it costs.

    Few lines, few breaks within brackets, no line wider than there is room.
    """
    sums = [0.0]
    for node in nodes:
        sums.append(sums[-1] + node.width)
    places = [_Break(0), *_breaks(nodes), _Break(len(nodes))]
    best: list[tuple[float, int]] = [(0.0, -1)]
    for end in range(1, len(places)):
        choices = []
        for start in range(end - 1, -1, -1):
            used = sums[places[end].place] - sums[places[start].place]
            used += _indent(places[start], first) if start else 0
            over = max(0.0, used - room)
            empty = 0.0 if end == len(places) - 1 else max(0.0, 1 - used / room)
            cost = 100.0 + 2000.0 * over + 20.0 * empty**2 + places[end].cost
            choices.append((best[start][0] + cost, start))
            if over:
                break
        best.append(min(choices))
    cuts = [len(places) - 1]
    while cuts[-1] > 0:
        cuts.append(best[cuts[-1]][1])
    return best[-1][0], [places[cut] for cut in reversed(cuts)]


def _indent(at: _Break, first: bool) -> int:
    """How far the line that begins at a break is moved to the right, in em."""
    if at.cost < 0:  # a relation, or a new statement after a comma
        return 0 if first else 1
    return min(1 + at.depth, 4) + (0 if first else 1)


def _breaks(nodes: Sequence[Node]) -> Iterator[_Break]:
    """Where a line can be broken."""
    depth, before = 0, "open"
    for place, node in enumerate(nodes):
        if node.kind == "close":
            depth = max(0, depth - 1)
        if place:
            if node.kind == "rel" and depth == 0:
                yield _Break(place, depth, -5.0)
            elif node.tex.strip() in _SIGNS and before in {"ord", "close"}:
                yield _Break(place, depth, 60.0 * depth)
            elif before == "punct":
                yield _Break(place, depth, 60.0 * depth if depth else -1.0)
            elif depth == 0 and before in {"ord", "close"} and node.inner and node.width > 4:
                yield _Break(place, 2, 180.0)
        if node.kind == "open":
            depth += 1
        if node.kind != "space":
            before = node.kind
