"""What kind of characters there are, and which of them may be defined as macros are."""

from __future__ import annotations

import re

from kowalevski_cas.source.mouth import Mouth
from kowalevski_cas.source.tex import TypedToken

_CODE = re.compile(r"`(\\?.)\s*=?\s*(\\active|\"[0-9A-Fa-f]+|\d+)")
_ACTIVE = frozenset({r"\active", "13", '"8000'})
_SPECIAL = frozenset("\\{}$&#%")
_USUAL = {"^": "7", "_": "8"}


def change_code(command: str, mouth: Mouth) -> bool:
    r"""Whether what ``\catcode`` or ``\mathcode`` is to do is understood; then it is done.

    A sign may become active, or what it usually is; the sign @ may become a letter.
    """
    taken: list[TypedToken] = []
    while len(taken) < 12 and (token := mouth.character()) is not None:
        taken.append(token)
        if token.text.isspace() and len(taken) > 3:
            break
    match = _CODE.match("".join(token.text for token in taken))
    used = 0
    while match and sum(len(token.text) for token in taken[:used]) < match.end():
        used += 1
    mouth.put_back(taken[used:])
    return match is not None and _change(command, match[1][-1], match[2], mouth)


def _change(command: str, sign: str, value: str, mouth: Mouth) -> bool:
    if sign.isalnum() or sign in _SPECIAL or (command == r"\mathcode" and value not in _ACTIVE):
        return False
    if value in _ACTIVE:
        mouth.active += "" if sign in mouth.active else sign
    elif sign == "@":
        mouth.at_is_letter = value == "11"
    elif sign in _USUAL:
        mouth.active = mouth.active.replace(sign, "")
        return value == _USUAL[sign]
    else:
        return value in ("11", "12") and sign not in mouth.active
    return True
