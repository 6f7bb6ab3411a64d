"""Certificates as programs over polynomials: definitions, derivatives, and sums that vanish.

Denominators are cleared by generators v with v n = 1 for each expression n that is
assumed non-zero; a root is a generator with a square. Nothing is taken from here
on trust: the program differentiates by itself, and it checks each inverse, each
relation and each change of variables as it does the statements.
"""

from __future__ import annotations

from abc import ABC

from kowalevski_cas.export.format import Format, Inexpressible, Json
from kowalevski_cas.export.polynomials.language import Language
from kowalevski_cas.export.polynomials.program import program
from kowalevski_cas.proof.checker import Rejected


class Polynomials(Language, Format, ABC):
    """A format that is made of the words of a language."""

    def translate(self, certificate: Json) -> str:
        try:
            return program(self, certificate)
        except Rejected as error:
            raise Inexpressible(f"the checker says: {error.args[0]}") from None

    def objection(self, text: str, output: str) -> str:
        wanted = [line.split('"')[1] for line in text.splitlines() if line.startswith('holds("')]
        found = [line.strip() for line in output.splitlines() if line.strip()]
        for line, words in zip(found, wanted, strict=False):
            if line != f"holds: {words}":
                return line
        if not wanted or len(found) != len(wanted):
            return f"{len(found)} of {len(wanted)} statements are confirmed"
        return ""
