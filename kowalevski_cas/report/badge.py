"""A badge for the page of a repository: how its claims stand."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape

LETTER = 6.6
"""Width of a letter, in pixels; the text is fitted into what it is given."""

COLOURS = {"false": "#c62828", "open": "#8d6e00", "proved": "#2e7d32", "none": "#616161"}


def badge(counts: Mapping[str, int]) -> str:
    """An SVG that says how many claims are proved, false and open, by the numbers of verdicts."""
    proved = counts.get("proved", 0) + counts.get("conditional", 0)
    false = counts.get("refuted", 0)
    numbers = {"proved": proved, "false": false, "open": sum(counts.values()) - proved - false}
    words = ", ".join(f"{number} {word}" for word, number in numbers.items() if number)
    worst = next((word for word in COLOURS if numbers.get(word)), "none")
    return _svg("formulas", words or "no claims", COLOURS[worst])


def _svg(left: str, right: str, colour: str) -> str:
    """Two words side by side, the second one on a colour."""
    first, second = (round(LETTER * len(words)) + 12 for words in (left, right))
    title = escape(f"{left}: {right}")

    def words(text: str, start: int, width: int) -> str:
        return (
            f'<text x="{start + width / 2:g}" y="14" textLength="{width - 12}" '
            f'lengthAdjust="spacingAndGlyphs">{escape(text)}</text>'
        )

    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{first + second}" height="20" '
        f'role="img" aria-label="{title}"><title>{title}</title>'
        f'<rect width="{first + second}" height="20" rx="3" fill="#424242"/>'
        f'<path d="M{first} 0h{second - 3}a3 3 0 0 1 3 3v14a3 3 0 0 1-3 3h-{second - 3}z" '
        f'fill="{colour}"/>'
        f'<g fill="#fff" text-anchor="middle" font-family="Verdana,sans-serif" font-size="11">'
        f"{words(left, 0, first)}{words(right, first, second)}</g></svg>\n"
    )
