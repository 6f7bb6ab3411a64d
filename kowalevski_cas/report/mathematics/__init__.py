r"""Setting formulas: old TeX made plain, widths estimated, long displays broken into lines.

What comes in is a formula as an author printed it (``{\bf I}``, ``\mathop{\rm Re}\nolimits``,
rows of an ``array``) or as the program wrote it (polynomials of many terms). What goes out is
plain LaTeX that both pdflatex and pandoc read, broken where a mathematician would break it:
before a relation or a sign, in brackets only if there is no other way.
"""

from kowalevski_cas.report.mathematics.setting import display, displays, plain, width

__all__ = ["display", "displays", "plain", "width"]
