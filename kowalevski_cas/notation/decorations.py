"""What stands over a letter or is raised on it and makes another name of it: one line each.

The reader, the names by their parts and all printers take it from here.
"""

from __future__ import annotations

from typing import NamedTuple


class Accent(NamedTuple):
    """A mark over a letter, or below it."""

    plain: str
    """The combining sign of Unicode."""
    mathml: str
    """The sign that is set over the letter; one that is set below has none."""
    typst: str
    spelled: str = ""
    """Other macros for it, without backslashes."""


class RaisedSign(NamedTuple):
    """A sign that is raised on a letter."""

    shown: str
    """As it is raised where things can be."""
    plain: str
    """In a line."""
    spelled: str = ""


ACCENTS = {
    r"\hat": Accent("\u0302", "^", "hat({})", "widehat"),
    r"\tilde": Accent("\u0303", "~", "tilde({})", "widetilde"),
    r"\check": Accent("\u030c", "ˇ", "caron({})"),
    r"\vec": Accent("\u20d7", "→", "arrow({})", "overrightarrow"),
    r"\underline": Accent("\u0332", "", "underline({})"),
}
"""By their macros."""

RATES = {
    r"\dot": Accent("\u0307", "˙", "dot({})"),
    r"\ddot": Accent("\u0308", "¨", "dot.double({})"),
    r"\dddot": Accent("\u20db", "⃛", "dot.triple({})"),
    r"\ddddot": Accent("\u20dc", "⃜", "dot.quad({})"),
}
"""Those that make the name of a rate of it, by the number of dots."""

RAISED = {"*": RaisedSign("*", "*", "ast"), "+": RaisedSign("+", "⁺"), "-": RaisedSign("−", "⁻")}
"""By the sign, or its macro."""


def raised_sign(shown: str) -> RaisedSign:
    """What is raised on a letter, by how it is shown: a sign, or the name of a frame."""
    return RAISED.get(shown) or RaisedSign(shown, f"^{shown}")
