r"""Matrices that are given by their inverses: :math:`\mathbf J^{-1}=\operatorname{diag}(a,b,c)`."""

from __future__ import annotations

import re

from kowalevski_cas.notation import split_display

_INVERSE = re.compile(
    r"""(?P<name>(?:\\(?:mathbf|boldsymbol|bm)\s*)?\{?[A-Z]\}?)\s*\^\s*\{\s*-\s*1\s*\}\s*=\s*
    (?P<matrix>\\(?:operatorname|mathrm|text)\s*\{diag\}.*|\\begin\{[pb]matrix\}.*)""",
    re.DOTALL | re.VERBOSE,
)


def without_inverses(tex: str) -> str:
    r"""A display in which they are the inverses of what is printed.

    >>> without_inverses(r"\dot x=y, \mathbf J^{-1}=\operatorname{diag}(a,b)")
    '\\dot x=y, \\mathbf J=\\operatorname{diag}(a,b)^{-1}'
    """
    for start, end in reversed(split_display(tex)):
        if inverse := _INVERSE.fullmatch(tex[start:end].strip()):
            tex = f"{tex[:start]}{inverse['name']}={inverse['matrix']}^{{-1}}{tex[end:]}"
    return tex
