"""Numerals in words, English and Russian: how many there are, and which one is meant."""

from __future__ import annotations

CARDINALS = "one two three four five six seven eight nine ten".split()
"""One to ten, in their order."""

ORDINALS = (
    ("first", "перв"),
    ("second", "втор"),
    ("third", "трет"),
    ("fourth", "четверт", "четвёрт"),
    ("fifth", "пят"),
    ("sixth", "шест"),
    ("seventh", "седьм"),
    ("eighth", "восьм"),
)
"""The first to the eighth, each in both languages, without endings."""
