"""What is said when a formula cannot be read."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache

from kowalevski_cas.notation.advice import advice

_WIDTH = 70
_LETTER = re.compile(r"(?:[^_{]|\{[^{}]*\}|\{)*")

# Letters that are taken for one another in print or in haste.
_LOOKALIKES = tuple(
    frozenset(group.split())
    for group in r"""w \omega W \varpi, a \alpha A, b \beta B, c C, d \delta D,
    e \epsilon \varepsilon E, f \varphi \phi F, g \gamma G, h \eta H, i \iota I, j J,
    k \kappa \varkappa K, l \ell L, m \mu M, n \nu \eta N, p \rho \varrho P, q Q \theta, r R,
    s \sigma S, t \tau T, u \mu \upsilon U, v \nu \upsilon V, x \xi \chi X, y \psi \gamma Y,
    z \zeta Z, \psi \Psi, \phi \Phi \varphi, \theta \Theta \vartheta, \omega \Omega""".split(",")
)


class NotationError(ValueError):
    """A formula that cannot be read, and where.

    ``str()`` shows the message, or what to print instead where that is known, the line of the
    source and a caret under the place.
    """

    def __init__(self, message: str, tex: str, position: int) -> None:
        super().__init__(message)
        self.tex = tex
        self.position = max(0, min(position, len(tex)))

    @property
    def message(self) -> str:
        """What is wrong."""
        return str(self.args[0])

    def __reduce__(self) -> tuple[type[NotationError], tuple[str, str, int]]:
        """An error may cross from one process to another."""
        return NotationError, (self.message, self.tex, self.position)

    def __str__(self) -> str:
        """The message, the formula (a window of it when it is long) and the caret."""
        window, column = _window(self.tex, self.position)
        if not window.strip():
            return self.message
        instead = advice(self.tex, self.position)
        said = f"{self.message}; {instead}" if instead else self.message
        return f"{said}\n  {window}\n  {' ' * column}^"


def _window(tex: str, position: int) -> tuple[str, int]:
    """The line around the position, cut to the width, and the caret's column in it."""
    first = max(tex.rfind("\n", 0, position) + 1, position - 4 * _WIDTH)
    last = tex.find("\n", position, position + 4 * _WIDTH)
    line = tex[first : last if last >= 0 else position + 4 * _WIDTH]
    line = "".join(char if char.isprintable() else "?" for char in line.replace("\t", " "))
    column = position - first
    if len(line) > _WIDTH:
        cut = max(0, min(column - _WIDTH // 2, len(line) - _WIDTH + 6))
        piece = line[cut : cut + _WIDTH - 6]
        before = "..." if cut else ""
        after = "..." if cut + _WIDTH - 6 < len(line) else ""
        return before + piece + after, column - cut + len(before)
    return line, column


class Undeclared(NotationError):
    """A name that is not declared; its message tells the nearest that are."""

    def __init__(
        self, message: str, tex: str, position: int, name: str, declared: Iterable[str]
    ) -> None:
        super().__init__(message, tex, position)
        self.name, self.declared = name, declared

    @property
    def message(self) -> str:
        """What is wrong, and which names may have been meant: sought when somebody asks."""
        if advice(self.tex, self.position):
            return super().message
        *others, last = nearest(self.name, self.declared) or [""]
        near = f"{', '.join(others)} or {last}" if others else last
        return super().message + (f"; did you mean {near}?" if near else "")


def nearest(name: str, declared: Iterable[str], limit: int = 3) -> list[str]:
    r"""The declared names closest to the given one, the closest first.

    >>> nearest("w_3", ["x_1", "w_1", "w_2", r"\omega_3", r"\omega_1"])
    ['\\omega_3', 'w_1', 'w_2']
    """
    candidates = sorted((-closeness(name, other), other) for other in set(declared) - {name})
    found = [other for score, other in candidates if score <= -3][:limit]
    if not found:
        import difflib

        found = difflib.get_close_matches(name, sorted(set(declared)), n=limit, cutoff=0.5)
    return found


@cache
def closeness(name: str, other: str) -> float:
    """How easily one name is printed for another: 5 and more for a slip, 0 for no likeness."""
    letter, index = letter_and_index(name)
    other_letter, other_index = letter_and_index(other)
    score = 0.0
    if letter == other_letter:
        score += 3
    elif plain(letter) == plain(other_letter):
        score += 2.8
    elif any({plain(letter), plain(other_letter)} <= group for group in _LOOKALIKES):
        score += 2.5
    if index == other_index:
        score += 2
    elif index and other_index:
        score += 0.5
    return score


def letter_and_index(name: str) -> tuple[str, str]:
    r"""The parts of a name: ``\omega_1`` gives ``\omega`` and ``1``; the index may be empty.

    >>> letter_and_index("U_{12}")
    ('U', '12')
    """
    letter = _LETTER.match(name)[0]  # type: ignore[index] # it matches anything
    index = name[len(letter) + 1 :]
    return letter, index[1:-1] if index.startswith("{") else index


def rate_name(name: str) -> str:
    r"""The name of the derivative of a variable, as it is printed.

    >>> rate_name(r"\omega_1"), rate_name(r"\dot{x}")
    ('\\dot{\\omega}_1', '\\ddot{x}')
    """
    letter = name.partition("_")[0]
    dots, brace, inner = letter.partition("{")
    higher = {r"\dot": r"\ddot", r"\ddot": r"\dddot"}.get(dots if brace else "")
    marked = f"{higher}{{{inner}" if higher else rf"\dot{{{letter}}}"
    return marked + name[len(letter) :]


def name_of_rate(name: str) -> str:
    r"""The variable of which a name is the derivative; the name itself, if it is no such one.

    >>> name_of_rate(r"\dot{\omega}_1"), name_of_rate(r"\dot{\mathbf{r}}"), name_of_rate("x_1")
    ('\\omega_1', '\\mathbf{r}', 'x_1')
    """
    letter = letter_and_index(name)[0]
    if not letter.startswith(r"\dot{"):
        return name
    return letter[len(r"\dot{") : -1] + name[len(letter) :]


def plain(letter: str) -> str:
    r"""The letter without its font: ``\boldsymbol{\alpha}`` gives ``\alpha``."""
    return letter[letter.index("{") + 1 : -1] if letter.endswith("}") else letter
