"""How macros take their arguments: by the forms that LaTeX, TeX and xparse have for it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from kowalevski_cas.source.mouth import Malformed, Mouth
from kowalevski_cas.source.tex import TypedToken

NO_VALUE = r"\-NoValue-"
TRUE, FALSE = r"\BooleanTrue", r"\BooleanFalse"


@dataclass(frozen=True)
class Parameter:
    r"""How an argument is taken: by its kind, as in the specifications of xparse.

    ``m`` is a group or a token, ``o`` stands between brackets or is left out, ``s`` is a token or
    left out, ``u`` ends before some tokens, and ``=`` is no argument, but tokens that have to be
    there.
    """

    kind: str
    tokens: tuple[str, ...] = ()
    default: tuple[str, ...] = (NO_VALUE,)

    def take(self, mouth: Mouth) -> list[TypedToken]:
        """The argument."""
        if self.kind == "m":
            return mouth.argument()
        if self.kind == "u":
            return mouth.until(self.tokens)
        if self.kind == "o":
            found = mouth.optional_argument(*self.tokens)
            return [TypedToken(text) for text in self.default] if found is None else found
        if self.kind == "s":
            return [TypedToken(TRUE if mouth.skips(self.tokens[0]) else FALSE)]
        for text in self.tokens:
            token = mouth.character()
            if token is None or (token.text != text and not (token.text.isspace() and text == " ")):
                mouth.put_back([token] if token else [])
                raise Malformed(f"{text} is expected here")
        return []


def delimited_parameters(printed: Sequence[str]) -> tuple[Parameter, ...]:
    r"""The parameters that stand, with what is around them, between a name and its body.

    >>> delimited_parameters(["(", "#1", ",", "#2", ")"])[1].tokens
    (',',)
    """
    if printed and printed[-1].startswith("#") and not printed[-1][1:].isdigit():
        raise Malformed("a macro that ends with a brace")
    found: list[Parameter] = []
    tokens: list[str] = []
    numbered = False
    for text in [*printed, "#"]:
        if text[0] != "#":
            tokens.append(text)
            continue
        if numbered:
            found.append(Parameter("u", tuple(tokens)) if tokens else Parameter("m"))
        elif tokens:
            found.append(Parameter("=", tuple(tokens)))
        numbered, tokens = True, []
    return tuple(found)


def specified_parameters(tokens: Sequence[TypedToken]) -> tuple[Parameter, ...]:
    """The parameters that a specification of xparse names."""
    rest = [token.text for token in tokens if token.text != " "]
    found: list[Parameter] = []
    while rest:
        kind = rest.pop(0)
        if kind in "+!":
            continue
        if kind not in _KINDS:
            raise Malformed(f"the argument {kind} of a specification is not known")
        try:
            found.append(_KINDS[kind](rest))
        except IndexError:
            raise Malformed("the specification of arguments ends early") from None
    return tuple(found)


def _default(rest: list[str]) -> tuple[str, ...]:
    """The default value in braces that comes next in a specification."""
    if rest.pop(0) != "{":
        raise Malformed("a default is missing")
    inside: list[str] = []
    depth = 1
    while depth:
        inside.append(rest.pop(0))
        depth += {"{": 1, "}": -1}.get(inside[-1], 0)
    return tuple(inside[:-1])


def _pair(rest: list[str]) -> tuple[str, str]:
    return rest.pop(0), rest.pop(0)


_KINDS: dict[str, Callable[[list[str]], Parameter]] = {
    "m": lambda rest: Parameter("m"),
    "o": lambda rest: Parameter("o", ("[", "]")),
    "O": lambda rest: Parameter("o", ("[", "]"), _default(rest)),
    "s": lambda rest: Parameter("s", ("*",)),
    "t": lambda rest: Parameter("s", (rest.pop(0),)),
    "g": lambda rest: Parameter("o", ("{", "}")),
    "G": lambda rest: Parameter("o", ("{", "}"), _default(rest)),
    "d": lambda rest: Parameter("o", _pair(rest)),
    "D": lambda rest: Parameter("o", _pair(rest), _default(rest)),
    "r": lambda rest: Parameter("o", _pair(rest)),
    "R": lambda rest: Parameter("o", _pair(rest), _default(rest)),
}
