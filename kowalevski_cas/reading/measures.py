r"""Measures that a map preserves, printed as :math:`dx'\,dy'/(x'y')=dx\,dy/(xy)`: by a Jacobian."""

from __future__ import annotations

import re

_LETTER = r"(?:\\[A-Za-z]+|[A-Za-z])(?:_(?:\{[^{}]*\}|\w))?"
_GAP = r"(?:\\[,;:! ]|\\wedge(?![A-Za-z])|~|\s)*"
_ONE = rf"(?<![A-Za-z\\])d\s*(?:\\[,!]\s*)?{_LETTER}"
_IMAGES = re.compile(rf"{_ONE}'(?:{_GAP}{_ONE}')+")
_NAME = re.compile(rf"(?<![A-Za-z\\])d\s*(?:\\[,!]\s*)?({_LETTER})")


def differentials_of_images(tex: str) -> list[str]:
    r"""The names of which a formula prints the differentials of all images, side by side.

    >>> differentials_of_images(r"\frac{dx'\,dy'}{x'y'}=\frac{dx\,dy}{xy}")
    ['x', 'y']
    """
    found = _IMAGES.search(tex)
    return _NAME.findall(found[0]) if found else []


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
