"""Names of places in a report."""

from __future__ import annotations

import re


def anchor(text: str) -> str:
    """A name that both LaTeX and Typst take for a label."""
    return re.sub(r"[^A-Za-z0-9.-]", "-", text)
