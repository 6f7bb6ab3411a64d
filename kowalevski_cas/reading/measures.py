r"""Measures that maps and flows preserve, as they are printed.

Those of a map, as :math:`dx'\,dy'/(x'y')=dx\,dy/(xy)`, by a Jacobian; the divergence of a field
that is named and given by nothing, as :math:`\operatorname{div}\mathcal X`, by that of the motion.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

_LETTER = r"(?:\\[A-Za-z]+|[A-Za-z])(?:_(?:\{[^{}]*\}|\w))?"
_GAP = r"(?:\\[,;:! ]|\\wedge(?![A-Za-z])|~|\s)*"
_ONE = rf"(?<![A-Za-z\\])d\s*(?:\\[,!]\s*)?{_LETTER}"
_IMAGES = re.compile(rf"{_ONE}'(?:{_GAP}{_ONE}')+")
_VOLUME = re.compile(rf"\s*{_ONE}(?:{_GAP}{_ONE})*[\s.,;]*")
_NAME = re.compile(rf"(?<![A-Za-z\\])d\s*(?:\\[,!]\s*)?({_LETTER})")


def differentials_of_images(tex: str) -> list[str]:
    r"""The names of which a formula prints the differentials of all images, side by side.

    >>> differentials_of_images(r"\frac{dx'\,dy'}{x'y'}=\frac{dx\,dy}{xy}")
    ['x', 'y']
    """
    found = _IMAGES.search(tex)
    return _NAME.findall(found[0]) if found else []


def volume_element(tex: str) -> list[str]:
    r"""The names of which a formula prints the differentials side by side, and nothing else.

    >>> volume_element(r"dx\,d\omega_1.")
    ['x', '\\omega_1']
    >>> volume_element(r"x\,dx\,dy")
    []
    """
    whole = _VOLUME.fullmatch(tex)
    return _NAME.findall(whole[0]) if whole else []


def with_jacobian(tex: str) -> str:
    r"""What says that a measure goes over into another one, by the Jacobian of the images.

    >>> with_jacobian(r"dx'\wedge dy'=dx\wedge dy")
    "\\frac{\\partial(x',y')}{\\partial(x,y)}=1"
    """
    names = differentials_of_images(tex)
    own = _GAP.join(rf"(?<![A-Za-z\\])d\s*{re.escape(name)}(?!['A-Za-z_])" for name in names)
    if not names or len(re.findall(own, tex)) != 1 or len(_IMAGES.findall(tex)) != 1:
        return tex
    images = ",".join(f"{name}'" for name in names)
    jacobian = rf"\frac{{\partial({images})}}{{\partial({','.join(names)})}}"
    tex = _IMAGES.sub(lambda _: jacobian, tex)
    before, after = re.split(own, tex)
    one = "1" if before.rstrip()[-1:] in ("", *"{=(-+") else r"\cdot1"
    return f"{before}{one}{after}"


_TYPE = r"\\(?:mathcal|mathbf|boldsymbol|bm|vec|mathfrak)"
_FIELD = rf"(?:{_TYPE}\s*(?:\{{\s*(?:\\?[A-Za-z]+)\s*\}}|[A-Za-z])|[A-Za-z])"
_DIVERGENCE = re.compile(
    rf"^\s*(?:\\(?:operatorname|mathrm|text)\s*\{{\s*[Dd]iv\s*\}}|\\(?:nabla|partial)\s*\\cdot)\s*"
    rf"(?:\\[,;! ]\s*)?(?P<open>\()?\s*(?P<field>{_FIELD})\s*(?(open)\))\s*(?=&?\s*=)"
)


def with_divergence(tex: str, texts: Sequence[str]) -> str:
    r"""What says the divergence of a field that none of the texts defines, of no field by name.

    >>> with_divergence(r"\operatorname{div}\mathcal X=-a", [r"\dot x=-ax"])
    '\\mathrm{div}=-a'
    >>> with_divergence(r"\operatorname{div}\mathbf B=0", [r"\mathbf B=(0,0,1)"])
    '\\operatorname{div}\\mathbf B=0'
    """
    found = _DIVERGENCE.match(tex)
    if found is None or any(_gives(found["field"], text) for text in texts):
        return tex
    return rf"\mathrm{{div}}{tex[found.end() :]}"


def _gives(field: str, text: str) -> bool:
    """Whether a field stands alone on the left, or has components, in a text."""
    return re.search(rf"(?:^|[,&])\s*{re.escape(field)}\s*(?:=|_)", text) is not None
