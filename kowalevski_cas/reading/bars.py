r"""Letters with bars that are new names, as the images :math:`\bar x=y,\ \bar y=-x`.

Elsewhere a bar is a complex conjugate.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from kowalevski_cas.source.displays import TypedFormula

_UNDER = (
    r"\s*(?:\{\s*(?P<letter>[A-Za-z]|\\[A-Za-z]+)\s*\}"
    r"|(?P<bare>[A-Za-z](?![A-Za-z])|\\[A-Za-z]+))"
)
_SIGN = re.compile(rf"\\(?:bar|overline)(?={_UNDER})")
_GIVEN = re.compile(rf"[\s&]*\\(?:bar|overline){_UNDER}[\s&]*=(?P<value>.*)", re.DOTALL)
_PARTS = re.compile(r"\\\\|\\q?quad|[,;]")
"""What stands between equations of a display."""
_INDEX = r"_(?:\w|\{[^{}]*\})"
_LETTER = re.compile(rf"[\s{{}}&.,]*(?:\\(?!frac|sqrt)[A-Za-z]+|[A-Za-z])(?:{_INDEX})?[\s{{}}&.,]*")
_WORDS = re.compile(r"\\(?:label|tag|(?:eq)?ref|begin|end|text|mbox|operatorname)\s*\{[^{}]*\}")
_NO_UNIT = re.compile(
    rf"{_INDEX}|{_WORDS.pattern}"
    r"|\\(?!im\b|I\b|ii\b|mathrm\s*\{\s*i)[A-Za-z]+|\bi\s*="
)
"""Words, indices, other macros and ranges, in which the letter i is no imaginary unit."""
_UNIT = re.compile(r"\\(?:im|I|ii)\b|i")
_COMPLEX = re.compile(
    r"\b(?:complex|conjugate\s+(?:of|to|function|number|quantit)\w*|holomorphic|комплексн\w*"
    r"|сопряж[её]нн\w+\s+(?:к|функци|числ|величин)\w*)",
    re.IGNORECASE,
)
_ACCENTS = (r"\tilde", r"\hat", r"\check", r"\breve")
"""What a bar may be read as where it makes names."""


def with_bars(formulas: Sequence[TypedFormula], text: str) -> Iterator[TypedFormula]:
    """The formulas, with another accent in the place of bars that make new names.

    They do where a letter with a bar is first printed as what an equation gives, and nothing is
    complex: a value that is no letter alone tells, too, that it is no conjugate.
    """
    barred = next((one.tex for one in formulas if "=" in one.tex and _SIGN.search(one.tex)), "")
    given = [
        found for part in _PARTS.split(_WORDS.sub("", barred)) if (found := _GIVEN.fullmatch(part))
    ]
    values = [found["value"] for found in given if not _SIGN.search(found["value"])]
    is_complex = any(_UNIT.search(_NO_UNIT.sub(" ", one.tex)) for one in formulas)
    is_name = any(not _LETTER.fullmatch(value) for value in values)
    real = any(found["value"].strip(" .") in (found["letter"], found["bare"]) for found in given)
    is_name = is_name or bool(values and not real and not _COMPLEX.search(text))
    accent = next((one for one in _ACCENTS if all(one not in f.tex for f in formulas)), "")
    for formula in formulas:
        if is_name and accent and not is_complex:
            yield replace(formula, tex=_SIGN.sub(lambda _: accent, formula.tex))
        else:
            yield formula
