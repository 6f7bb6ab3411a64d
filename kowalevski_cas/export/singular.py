"""Certificates for Singular: polynomials in one ring, derivatives by its own ``diff``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from pathlib import Path

from kowalevski_cas.export.polynomials import Polynomials
from kowalevski_cas.tools import TOOLS

_BEGIN = """\
ideal relations;

proc red(poly p)
{
  attrib(relations, "isSB", 1);
  return(reduce(p, relations));
}

proc cleared(poly p, poly v, poly n)
{
  matrix c = coeffs(p, v);
  int d = nrows(c) - 1;
  poly q = 0;
  int k;
  for (k = 0; k <= d; k = k + 1) { q = red(q * n + c[k + 1, 1]); }
  return(q);
}

proc holds(string words, poly p, list divisors)
{
  poly q = red(p);
  int k;
  for (k = 1; k < size(divisors); k = k + 2) { q = cleared(q, divisors[k], divisors[k + 1]); }
  if (q == 0) { "holds: " + words; } else { "fails: " + words; }
}
"""


class Program(Polynomials):
    """Roots lead in a lexicographic order, so that their relations reduce as they stand."""

    tool = TOOLS["singular"]
    suffix = ".sing"
    comment = "// {}"
    define = "poly {} = red({});"
    relation = "relations = relations + ideal({}^2 - {});"
    divisors, pair = "list {} = list({});", "{}, {}"

    def arguments(self, file: Path) -> list[str]:
        return ["--quiet", "--no-rc", "--no-warn", file.name]

    def frame(self, generators: Sequence[str], body: str) -> str:
        names = ", ".join(reversed(generators))
        return f"ring R = 0, ({names}), lp;\n{_BEGIN}\n{body}\nquit;\n"

    def number(self, value: Fraction) -> str:
        if value.denominator == 1:
            return f"number({value.numerator})"
        return f"(number({value.numerator})/number({value.denominator}))"

    def substitution(self, name: str, images: Mapping[str, str], generators: Sequence[str]) -> str:
        values = ", ".join(images.get(name, name) for name in reversed(generators))
        return f"map {name} = R, {values};"
