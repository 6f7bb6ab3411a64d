r"""What an integral by the time, without limits, is said to be: its rate is what is integrated."""

from __future__ import annotations

import re

_WHOLE = re.compile(
    r"(?P<lead>\s*(?:\\label\{[^{}]*\}\s*)?)"
    r"\\int(?![A-Za-z]|\s*(?:\\(?:no)?limits\s*)?[_^])(?P<inner>(?:(?!\\int|&|\\\\|=).)+?)"
    r"(?:\\[,;:!]\s*)*(?:\\mathrm\s*\{\s*d\s*\}|(?<![A-Za-z\\])d)\s*t"
    r"\s*=(?P<value>(?:(?!\\o?i*int|&|\\\\|=|const).)*?)(?P<end>[\s.,;]*)",
    re.DOTALL,
)
r"""A whole formula :math:`\int f\,dt=F`."""
_MACRO = re.compile(r"\\[A-Za-z]+")


def without_integral(tex: str) -> str:
    r"""That the rate of a function is what is integrated, in place of the integral by the time.

    >>> without_integral(r"\int \cos(kt)\,\mathrm{d}t=\frac1k\sin(kt).")
    '\\frac{d}{dt}(\\frac1k\\sin(kt))=\\cos(kt).'

    Between limits, or by what need not be the only thing that varies, it is something else; and
    what does not depend on the time is no such function.

    >>> [without_integral(tex) for tex in (r"\int_0^1 t\,dt=1", r"\int y\,dx=xy", r"\int p\,dt=J")]
    ['\\int_0^1 t\\,dt=1', '\\int y\\,dx=xy', '\\int p\\,dt=J']
    """
    found = _WHOLE.fullmatch(tex)
    if found is None or "t" not in _MACRO.sub(" ", found["value"]):
        return tex
    rate = rf"\frac{{d}}{{dt}}({found['value'].strip()})={found['inner'].strip()}"
    return f"{found['lead']}{rate}{found['end']}"
