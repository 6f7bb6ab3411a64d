"""Reading formulas: an author's TeX as nodes of plain LaTeX."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Final

from kowalevski_cas.report.mathematics.nodes import (
    Node,
    bracketed,
    joined,
    measured,
    spaced,
    split,
    trimmed,
)
from kowalevski_cas.report.mathematics.symbols import DELIMITERS, SPACES, kind, symbol

_SCRIPT: Final = 0.72
_DEEP: Final = 60
_TOKEN: Final = re.compile(r"\\[A-Za-z]+\*?|\\.|%[^\n]*\n?|\s+|.", re.DOTALL)

_SWITCHES: Final = {
    r"\bf": r"\mathbf", r"\rm": r"\mathrm", r"\it": r"\mathit", r"\cal": r"\mathcal",
    r"\sf": r"\mathsf", r"\tt": r"\mathtt",
}  # fmt: skip
_WRAPPERS: Final = {
    command: command
    for command in (
        r"\mathbf", r"\mathrm", r"\mathit", r"\mathcal", r"\mathsf", r"\mathtt", r"\mathbb",
        r"\mathfrak", r"\boldsymbol", r"\overline", r"\underline", r"\bar", r"\dot", r"\ddot",
        r"\hat", r"\tilde", r"\vec", r"\widehat", r"\widetilde", r"\underbrace", r"\overbrace",
    )
} | {r"\bs": r"\boldsymbol", r"\bm": r"\boldsymbol"}  # fmt: skip
_DROPPED: Final = {
    r"\displaystyle", r"\textstyle", r"\nolimits", r"\limits", r"\nonumber", r"\notag", r"\hfill",
    r"\allowbreak", r"\nobreak", r"\noindent", r"\small", r"\strut", r"\mathstrut", r"\relax",
}  # fmt: skip
_SIZED: Final = re.compile(r"\\[bB]igg?([lrm]?)$")
_FUNCTION: Final = re.compile(
    r"\\(sin|cos|tan|cot|exp|log|ln|det|dim|ker|max|min|lim|arctan|arcsin|arccos|deg|gcd)$"
)


class _TooDeepError(Exception):
    """Brackets within brackets, deeper than anybody prints."""


@lru_cache(maxsize=4096)
def read(tex: str) -> tuple[Node, ...]:
    """The nodes of a formula; one that is too deep to be read is a single node."""
    try:
        return trimmed(_Reader(_unwrapped(tex)).nodes())
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

    def deeper(self) -> None:
        self.depth += 1
        if self.depth > _DEEP:
            raise _TooDeepError

    def delimiter(self) -> str:
        return self.next() if self.peek() in DELIMITERS else ""

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

    def skip_length(self) -> None:
        r"""Pass over a length in brackets, as after ``\\``."""
        if self.peek() == "[" and "]" in self.tokens[self.at :]:
            end = self.tokens.index("]", self.at) + 1
            if re.fullmatch(r"\[[\d.\s-]*(mm|pt|em|ex|cm)\]", "".join(self.tokens[self.at : end])):
                self.at = end

    def nodes(self, *stops: str) -> list[Node]:
        """The nodes up to one of the stops (which is left standing) or the end."""
        self.deeper()
        found: list[Node] = []
        while (token := self.peek()) and token not in stops:
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
            elif token in _SWITCHES:
                found.append(_wrapped(_SWITCHES[token], self.nodes(*stops)))
            else:
                found += self.node(token)
            if found and found[-1].kind == "close":
                _close(found)
        self.depth -= 1
        return found

    def group(self) -> list[Node]:
        """The nodes up to the closing brace, which is consumed."""
        inside = self.nodes("}")
        self.next()
        return inside

    def argument(self) -> list[Node]:
        """The nodes of an argument: a group, or whatever comes next."""
        token = self.next()
        if token == "{":
            return self.group()
        self.deeper()
        found = self.node(token) if token and token not in "}^_&" else []
        self.depth -= 1
        return found

    def node(self, token: str) -> list[Node]:
        """The node that begins with a token; none where nothing is set."""
        match token:
            case "{":
                inside = self.group()
                if len(inside) == 1:
                    return inside
                return [Node(f"{{{joined(inside)}}}", measured(inside))]
            case "&":
                return [Node("&", 0, "cell")]
            case r"\\" | r"\cr":
                self.skip_length()
                return [Node(r"\\", 0, "row")]
            case r"\hspace" | r"\label" | r"\end":
                self.raw()
                return []
            case r"\phantom":
                self.argument()
                return []
            case r"\right":
                self.delimiter()
                return []
            case r"\left":
                return [self.pair()]
            case r"\frac" | r"\dfrac" | r"\tfrac" | r"\cfrac":
                return [self.fraction(token)]
            case r"\sqrt":
                return [self.root()]
            case r"\begin":
                return [self.environment()]
            case r"\text" | r"\mbox" | r"\hbox" | r"\textrm" | r"\textnormal":
                text = self.raw()
                return [Node(rf"\text{{{text}}}", 0.5 * len(text))]
            case r"\operatorname" | r"\operatorname*":
                text = self.raw()
                return [Node(rf"\operatorname{{{text}}}", 0.5 * len(text) + 0.17)]
            case r"\mathop":
                inside = self.argument()
                name = re.sub(r"\\mathrm\{([A-Za-z]+)\}", r"\1", joined(inside))
                return [Node(rf"\operatorname{{{name}}}", measured(inside) + 0.17)]
        if token in SPACES:
            return [Node(spaced(token.replace("~", r"\ ")), SPACES[token], "space")]
        if token in _WRAPPERS:
            return [_wrapped(_WRAPPERS[token], self.argument())]
        if sized := _SIZED.match(token):
            if not (delimiter := self.delimiter()):
                return []
            side = {"l": "open", "r": "close"}.get(sized[1]) or kind(delimiter)
            return [Node(f"{token}{spaced(delimiter)}", 0.6, side)]
        if _FUNCTION.match(token):
            return [Node(token + " ", 0.5 * (len(token) - 1) + 0.17)]
        return [symbol(token)]

    def script(self, base: Node, token: str) -> Node:
        if token == "'":
            return replace(base, tex=base.tex + "'", width=base.width + 0.24, inner=())
        inside = self.argument()
        raised = joined(inside)
        raised = f"{token}{raised}" if len(raised) == 1 else f"{token}{{{raised}}}"
        wider = _SCRIPT * measured(inside)
        width = base.width + wider
        if base.scripted and not base.rows:  # one above the other
            width = max(base.width, base.width - 0.4 + wider)
        inner: tuple[Node, ...] = ()
        if base.pair:
            last = base.inner[-1]
            inner = (*base.inner[:-1], replace(last, tex=last.tex + raised))
        return replace(base, tex=base.tex + raised, width=width, inner=inner, scripted=True)

    def fraction(self, command: str) -> Node:
        above, below = self.argument(), self.argument()
        scale = _SCRIPT if command == r"\tfrac" else 1.0
        return Node(
            f"{command}{{{joined(above)}}}{{{joined(below)}}}",
            scale * max(measured(above), measured(below)) + 0.24,
            inner=tuple(above),
            below=tuple(below),
            tall=True,
            fraction=True,
        )

    def root(self) -> Node:
        index = ""
        if self.peek() == "[":
            self.next()
            index = f"[{joined(self.nodes(']'))}]"
            self.next()
        inside = self.argument()
        return Node(rf"\sqrt{index}{{{joined(inside)}}}", measured(inside) + 0.9)

    def pair(self) -> Node:
        opening = self.delimiter() or "."
        inside = self.nodes(r"\right")
        self.next()
        closing = self.delimiter() or "."
        return bracketed(opening, inside, closing)

    def environment(self) -> Node:
        name = self.raw()
        columns = "{" + self.raw() + "}" if name.startswith("array") else ""
        body = self.nodes(r"\end")
        self.next()
        self.raw()
        rows = tuple(tuple(split(row, "cell")) for row in split(body, "row"))
        rows = tuple(row for row in rows if any(row))
        count = max((len(row) for row in rows), default=0)
        widths = [
            max((measured(row[k]) for row in rows if k < len(row)), default=0) for k in range(count)
        ]
        body_tex = r" \\ ".join(" & ".join(map(joined, row)) for row in rows)
        tex = rf"\begin{{{name}}}{columns} {body_tex} \end{{{name}}}"
        return Node(tex, sum(widths) + count + 0.8, rows=rows, tall=True)


def _wrapped(command: str, inside: Sequence[Node]) -> Node:
    width = measured(inside) * (1.1 if command in {r"\mathbf", r"\boldsymbol"} else 1.0)
    return Node(f"{command}{{{joined(inside)}}}", width)


def _close(found: list[Node]) -> None:
    """Make one node of the plain brackets that have just been closed, and what is in them."""
    opening = {")": "(", "]": "["}.get(found[-1].tex)
    if not opening:
        return
    for place in range(len(found) - 2, -1, -1):
        if found[place].kind == "close":
            return
        if found[place].kind == "open":
            inside = found[place + 1 : -1]
            if found[place].tex == opening and not any(n.kind in {"row", "cell"} for n in inside):
                found[place:] = [bracketed(opening, inside, found[-1].tex)]
            return
