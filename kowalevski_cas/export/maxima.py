"""Certificates for Maxima: canonical rational expressions, derivatives by its own ``diff``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from kowalevski_cas.export.polynomials import Polynomials
from kowalevski_cas.tools import TOOLS

_BEGIN = """\
linel : 100000$
roots : []$
vanishes(p) := is(ratdisrep(p) = 0)$

red(p) := block([q : rat(p)],
  for pair in roots do q : remainder(q, first(pair)^2 - second(pair), first(pair)),
  rat(q))$

/* The coefficients of powers of v, and n to what each power lacks of the highest. */
cleared(p, v, n) := block([q : rat(0), rest : p],
  while not vanishes(rest) do (
    q : red(q * n + remainder(rest, v, v)),
    rest : quotient(rest, v, v)),
  q)$

holds(words, p, divisors) := block([q : red(p)],
  for pair in divisors do q : cleared(q, first(pair), second(pair)),
  print(sconcat(if vanishes(q) then "holds: " else "fails: ", words)))$
"""


class Program(Polynomials):
    """Roots are reduced from the last to the first, for a square may contain earlier ones."""

    tool = TOOLS["maxima"]
    suffix = ".mac"
    comment = "/* {} */"
    holds = 'holds("{}", {}, {})$'
    define = "{} : red({})$"
    relation = "roots : cons([{}, {}], roots)$"
    divisors = "{} : [{}]$"

    def arguments(self, file: Path) -> list[str]:
        return ["--very-quiet", "--run-string", f'errcatch(batchload("{file.name}"))$ quit()$']

    def objection(self, text: str, output: str) -> str:
        # Maxima repeats what it was asked to run; after an error statements are missing.
        said = [line for line in output.splitlines() if line.startswith(("holds: ", "fails: "))]
        return super().objection(text, "\n".join(said))

    def frame(self, generators: Sequence[str], body: str) -> str:
        return f"ratvars({', '.join(generators)})$\n{_BEGIN}\n{body}\n"

    def substitution(self, name: str, images: Mapping[str, str], generators: Sequence[str]) -> str:
        pairs = ", ".join(f"{old} = {new}" for old, new in images.items())
        return f"{name}(p) := rat(sublis([{pairs}], ratdisrep(p)))$"
