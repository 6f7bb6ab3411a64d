"""The operations of the growing work as programs for Singular and PARI/GP."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from kowalevski_cas.algebra.polynomials import Terms
from study.direct import FORGET, Operation, Recording, Trace


@dataclass(frozen=True)
class Words:
    """How a program says it: templates for the parts of a file."""

    options: tuple[str, ...]
    suffix: str
    begin: str
    define: str
    forget: str
    derivative: str
    zero: str
    told: str
    end: str


WORDS = {
    "singular": Words(
        options=("--quiet", "--no-rc", "--no-warn"),
        suffix=".sing",
        begin='ring R = 0, ({names}), dp;\nsystem("--ticks-per-sec", 1000);\nint clock;',
        define="poly {name} = {text};",
        forget="kill {name};",
        derivative="diff({name}, {generator})",
        zero='if ({name} != 0) {{ "fails"; }}',
        told='"step {k} " + string(rtimer - clock) + "e-3";',
        end="quit;",
    ),
    "pari": Words(
        options=("--quiet", "--fast", "--default", "parisize=2G"),
        suffix=".gp",
        begin="[{names}];\nclock = 0;",
        define="{name} = {text};",
        forget="kill({name});",
        derivative="deriv({name}, {generator})",
        zero='if({name} != 0, print("fails"));',
        told='print("step {k} ", getwalltime() - clock, "e-3");',
        end="quit;",
    ),
}  # fmt: skip
START = {"singular": "clock = rtimer;", "pari": "clock = getwalltime();"}


def growth_program(program: str, steps: Sequence[tuple[Recording, Trace]]) -> str:
    """The text of a program that goes through these steps and tells its time at each."""
    words = WORDS[program]
    recording = steps[0][0]
    names = [f"g{k}" for k in range(len(recording.generators))]
    used = {number for _, trace in steps for o in trace.operations for number in o.arguments}
    lines = [words.begin.format(names=", ".join(names))]
    known: set[int] = set()

    def define(number: int, text: str) -> None:
        lines.append(words.define.format(name=f"p{number}", text=text))
        known.add(number)

    for _, trace in steps:
        for number, value in trace.given.items():
            if number in used:
                define(number, polynomial(recording.plain.terms(value), names))
    lines.append(START[program])
    for k, (_, trace) in enumerate(steps, 1):
        zeros = set(trace.zeros)
        for o in trace.operations:
            name = f"p{o.result}"
            if o.name == FORGET:
                if o.result in known:
                    if o.result in zeros:
                        lines.append(words.zero.format(name=name))
                    lines.append(words.forget.format(name=name))
                continue
            define(o.result, _computed(o, words, names))
        lines.append(words.told.format(k=k))
    return "\n".join([*lines, words.end, ""])


def _computed(operation: Operation, words: Words, names: Sequence[str]) -> str:
    """What an operation computes, in a program's words; ``names`` are those of the generators."""
    first, *more = (f"p{number}" for number in operation.arguments)
    if operation.generator is not None:
        return words.derivative.format(name=first, generator=names[operation.generator])
    return f"{first} {operation.name} {more[0]}" if more else f"-{first}"


def polynomial(terms: Terms, names: Sequence[str]) -> str:
    """A polynomial as both programs read it."""
    summands = []
    for exponents, value in terms.items():
        factors = [f"{n}^{e}" for n, e in zip(names, exponents, strict=True) if e]
        summands.append("*".join([f"({value.numerator})", *factors, f"1/{value.denominator}"]))
    return " + ".join(summands) or "0"
