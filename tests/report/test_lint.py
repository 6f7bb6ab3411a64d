"""The page for those who hear it, see little of it, or have it on a slow line."""

import re
from itertools import pairwise

import pytest

from kowalevski_cas.report.html import render_html
from tests.report.fixtures import document

PAGE = render_html(document())
SCHEMES = re.findall(r":root {([^}]*)}", PAGE)
"""The colours for light and for dark screens, those of the page and those of verdicts."""


def colours(*schemes: str) -> dict[str, str]:
    """The colours by name; #fff is short for #ffffff."""
    found = re.findall(r"--([a-z]+): #([0-9A-Fa-f]{3,6})\b", " ".join(schemes))
    return {name: code if len(code) == 6 else "".join(2 * c for c in code) for name, code in found}


def luminance(code: str) -> float:
    """The relative luminance of a colour, by the Web Content Accessibility Guidelines."""
    parts = [int(code[k : k + 2], 16) / 255 for k in (0, 2, 4)]
    linear = [p / 12.92 if p <= 0.03928 else ((p + 0.055) / 1.055) ** 2.4 for p in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one: str, other: str) -> float:
    """The contrast of two colours, from 1 to 21."""
    dark, light = sorted(map(luminance, (one, other)))
    return (light + 0.05) / (dark + 0.05)


@pytest.mark.parametrize("which", [0, 1], ids=["light", "dark"])
def test_every_letter_has_enough_contrast(which: int) -> None:
    found = colours(*SCHEMES[which::2])
    letters = found.keys() - {"page", "shade", "line"}
    assert {"ink", "soft", "link", "refuted", "proved"} <= letters
    for name in letters:
        for ground in ("page", "shade"):
            assert contrast(found[name], found[ground]) >= 4.5, (name, ground)


def test_headings_skip_no_level() -> None:
    levels = [int(level) for level in re.findall(r"<h([1-6])\b", PAGE)]
    assert levels[0] == 1 and levels.count(1) == 1
    assert all(after <= before + 1 for before, after in pairwise(levels))


def test_the_page_says_its_language_its_title_and_who_wrote_it_when() -> None:
    assert '<html lang="en">' in PAGE and "<title>" in PAGE
    assert re.search(r'<meta name="generator" content="kowalevski_cas [\d.]+">', PAGE)
    assert re.search(r'<meta name="date" content="\d{4}-\d\d-\d\d">', PAGE)


def test_every_picture_has_words() -> None:
    for image in re.findall(r"<figure>.*?</figure>", PAGE, re.S):
        assert "<figcaption>" in image or re.search(r'alt="[^"]+"', image)


def test_it_weighs_less_than_a_photograph() -> None:
    assert len(PAGE.encode()) < 1_000_000
