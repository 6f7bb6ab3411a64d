"""Single symbols: what each is in a formula, and how wide."""

from __future__ import annotations

from typing import Final

from kowalevski_cas.report.mathematics.nodes import Node, spaced

_RELATIONS: Final = (
    "=", "<", ">", r"\equiv", r"\ne", r"\neq", r"\le", r"\leq", r"\ge", r"\geq", r"\to",
    r"\mapsto", r"\in", r"\sim", r"\approx", r"\propto", r"\Rightarrow", r"\Leftrightarrow",
    r"\iff", r"\implies", r"\subset", r"\subseteq", r"\mid", r"\longrightarrow", r"\notin",
    r"\gg", r"\ll", r"\simeq", r"\cong", r"\rightarrow", r"\perp", r"\parallel",
)  # fmt: skip
_BINARY: Final = (
    "+", "-", r"\pm", r"\mp", r"\times", r"\cdot", "*", r"\cap", r"\cup", r"\wedge", r"\circ",
    r"\setminus", r"\otimes", r"\oplus", r"\land", r"\lor", r"\ast", r"\bullet",
)  # fmt: skip
_OPEN: Final = ("(", "[", r"\{", r"\langle", r"\lfloor", r"\lbrace")
_CLOSE: Final = (")", "]", r"\}", r"\rangle", r"\rfloor", r"\rbrace")
_KINDS: Final = (
    dict.fromkeys(_RELATIONS, "rel")
    | dict.fromkeys(_BINARY, "bin")
    | dict.fromkeys(_OPEN, "open")
    | dict.fromkeys(_CLOSE, "close")
    | dict.fromkeys((",", ";"), "punct")
)

DELIMITERS: Final = {*_OPEN, *_CLOSE, ".", "|", r"\|", "/", r"\vert", r"\Vert", "<", ">"}
"""What can stand after ``\\left``, ``\\right`` and ``\\big``."""

SPACES: Final = {
    r"\,": 0.17, r"\:": 0.22, r"\;": 0.28, r"\ ": 0.33, "~": 0.33, r"\!": -0.17, r"\quad": 1.0,
    r"\qquad": 2.0, r"\>": 0.22, r"\thinspace": 0.17, r"\enspace": 0.5,
}  # fmt: skip
"""Spaces, and how wide they are."""

_LETTERS: Final = (
    dict.fromkeys("mwMW", 0.88)
    | dict.fromkeys("ABDGHKNOQRUXVY", 0.77)
    | dict.fromkeys("ijlIft", 0.37)
    | {"'": 0.24, ".": 0.28, "/": 0.5, "|": 0.28}
    | dict.fromkeys((r"\Omega", r"\Psi", r"\Phi", r"\Theta", r"\Sigma"), 0.75)
    | {
        r"\alpha": 0.64, r"\omega": 0.64, r"\psi": 0.66, r"\varphi": 0.65, r"\phi": 0.6,
        r"\xi": 0.45, r"\tau": 0.46, r"\theta": 0.48, r"\iota": 0.36, r"\zeta": 0.45,
    }
)  # fmt: skip
_OPERATORS: Final = {
    r"\cdot": 0.28, r"\Leftrightarrow": 1.0, r"\iff": 2.2, r"\implies": 2.0,
    r"\longrightarrow": 1.7,
}  # fmt: skip


def kind(token: str) -> str:
    """The class of a symbol, as TeX has it."""
    return _KINDS.get(token, "ord")


def symbol(token: str) -> Node:
    """A symbol by itself."""
    match kind(token):
        case "rel":
            return Node(spaced(token), _OPERATORS.get(token, 0.8) + 0.56, "rel")
        case "bin":
            return Node(spaced(token), _OPERATORS.get(token, 0.78) + 0.44, "bin")
        case "punct":
            return Node(token, 0.45, "punct")
        case "open" | "close" as bracket:
            return Node(spaced(token), 0.39, bracket)
        case _:
            usual = 0.5 if token.isdigit() else 0.58
            return Node(spaced(token), _LETTERS.get(token, usual))
