"""Names in a report: of claims, and of the displays they are rows of."""

from __future__ import annotations

import re


def display_of(claim: str) -> str:
    """The display to which a claim belongs: ``eq10`` for ``eq10.3``; else the claim itself."""
    match = re.fullmatch(r"(.+)\.\d+", claim)
    return match[1] if match else claim


def anchor(text: str) -> str:
    """A name that both LaTeX and Typst take for a label."""
    return re.sub(r"[^A-Za-z0-9.-]", "-", text)
