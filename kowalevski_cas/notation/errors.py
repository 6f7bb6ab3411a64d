"""What is said when a formula cannot be read."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from kowalevski_cas.notation.advice import advice
from kowalevski_cas.notation.symbol import symbol

_WIDTH = 70

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
    ours, theirs = symbol(name), symbol(other)
    score = 0.0
    if ours.head == theirs.head:
        score += 3
    elif ours.letter == theirs.letter:
        score += 2.8
    elif any({ours.letter, theirs.letter} <= group for group in _LOOKALIKES):
        score += 2.5
    if ours.index == theirs.index:
        score += 2
    elif ours.index and theirs.index:
        score += 0.5
    return score
