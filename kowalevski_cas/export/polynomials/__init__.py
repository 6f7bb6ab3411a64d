"""Certificates as programs over polynomials: definitions, derivatives, and sums that vanish.

Denominators are cleared by generators v with v n = 1 for each expression n that is
assumed non-zero; a root is a generator with a square. Nothing is taken from here
on trust: the program differentiates by itself, and it checks each inverse, each
relation and each change of variables as it does the statements.
"""

from kowalevski_cas.export.polynomials.language import Language

__all__ = ["Language"]
