"""Certificates for PARI/GP: recursive polynomials, derivatives by its own ``deriv``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from kowalevski_cas.export.polynomials import Polynomials
from kowalevski_cas.tools import TOOLS

_BEGIN = """\
roots = [];

reduced(p, s, r) =
{
  my(d = poldegree(p, s));
  if(d < 2, return(p));
  sum(k = 0, d, polcoef(p, k, s) * s^(k % 2) * r^(k \\ 2));
}
red(p) =
{
  forstep(k = #roots, 1, -1, p = reduced(p, roots[k][1], roots[k][2]));
  p;
}
cleared(p, v, n) =
{
  my(d = poldegree(p, v));
  if(d < 1, return(p));
  red(sum(k = 0, d, polcoef(p, k, v) * n^(d - k)));
}
holds(words, p, divisors) =
{
  p = red(p);
  for(k = 1, #divisors, p = cleared(p, divisors[k][1], divisors[k][2]));
  print(if(p == 0, "holds: ", "fails: "), words);
}
"""


class Program(Polynomials):
    """Roots are reduced from the last to the first, for a square may contain earlier ones."""

    tool = TOOLS["pari"]
    suffix = ".gp"
    comment = r"\\ {}"
    define = "{} = red({});"
    relation = "roots = concat(roots, [[{}, {}]]);"
    divisors = "{} = [{}];"
    derivative = "deriv({}, {})"

    def arguments(self, file: Path) -> list[str]:
        return ["--quiet", "--fast", "--default", "parisize=1G", file.name]

    def frame(self, generators: Sequence[str], body: str) -> str:
        return f"[{', '.join(reversed(generators))}];\n{_BEGIN}\n{body}\nquit;\n"

    def substitution(self, name: str, images: Mapping[str, str], generators: Sequence[str]) -> str:
        return f"{name}(p) = substvec(p, [{', '.join(images)}], [{', '.join(images.values())}]);"
