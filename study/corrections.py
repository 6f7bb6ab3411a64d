"""What an audit makes of formulas that their authors corrected later, each in its context.

A folder has ``index.json``, a list of entries, and for each a folder with ``PAPER.tex``, a page in
which one formula is printed as it first was. An entry has its ``id``, the ``label`` of the formula,
the ``kind`` of the slip, and what was printed, ``wrong``, and what its author made of it,
``right``. The pages are audited by the command, as a stranger would do it.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections import Counter
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path
from tempfile import TemporaryDirectory

from kowalevski_cas.algebra.present import fraction_formula
from kowalevski_cas.audit.audited import OPEN
from kowalevski_cas.cli import run as run_command
from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, DIFFERENT, NOTHING, CommandError
from kowalevski_cas.notation import (
    Formula,
    Negative,
    NotationError,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Vocabulary,
    read,
    times,
    to_latex,
)
from kowalevski_cas.notation.open import OpenParser
from kowalevski_cas.reading.definite_integrals import with_integrals
from kowalevski_cas.reading.dimensions import AS_THE_REST
from kowalevski_cas.reading.free_formulas import free_formulas
from kowalevski_cas.reading.statements import read_statements
from kowalevski_cas.source.files import read_source
from kowalevski_cas.source.text import Source
from kowalevski_cas.verify.outcome import FALSE_AS_READ
from study.readings import Entry, audit_entries, repairs_told

EXIT_CODES = {
    AS_RECORDED: "every wrong formula is noticed",
    DIFFERENT: "one is not noticed, or is proved",
    NOTHING: "there is nothing to look at",
}

GREEN, NOTICED, LEFT = "green", "noticed", "not noticed"

MOST = 3
"""How many repairs are looked at."""


@dataclass(frozen=True)
class CorrectedFormula:
    """A formula that its author corrected: what an audit says of it, and whether it mends it so."""

    id: str
    kind: str
    end: str
    repaired: bool
    said: str
    alarm: bool = False
    """Whether what its author printed later is doubted as well: then it was not understood."""


def corrected_formula(folder: Path, entry: Entry, timeout: float) -> CorrectedFormula:
    """What an audit says of the wrong formula of an entry.

    It is noticed if it is red, corrected, named as the cause of what fails, or false as it was
    read; it is repaired if what its author printed later is among the first repairs, whatever the
    order of terms and factors.
    """
    path = folder / entry["id"] / "PAPER.tex"
    formulas = audit_entries(path, timeout)
    own = [one for one in formulas if one["label"] == entry["label"]]
    noticed = is_noticed(formulas, own)
    claims = [one["verdict"] for one in own if one["role"] == "claim"]
    green = bool(claims) and {*claims} <= {"proved", "conditional"}
    end = NOTICED if noticed else GREEN if green else LEFT
    said = "; ".join(f"{one['role']}, {one['verdict']}: {one['message'] or ''}" for one in own)
    mended = mended_source(path, entry)
    words = read_statements(mended).words
    meant = {ordered(tex, words) for tex in meant_formulas(path, entry)}
    with TemporaryDirectory() as there:
        page = Path(there) / path.name
        page.write_text(mended.text, encoding="utf-8")
        later = audit_entries(page, timeout)
    alarm = is_noticed(later, [one for one in later if one["label"] == entry["label"]])
    repaired = bool(meant & {ordered(tex, words) for tex in repairs(formulas, own)})
    return CorrectedFormula(entry["id"], entry["kind"], end, repaired, said, alarm)


def is_noticed(formulas: list[Entry], own: list[Entry]) -> bool:
    """Whether something is said against the formulas of a display."""
    failing = [one for one in formulas if one not in own and one["verdict"] != OPEN]
    causes = {cause for one in failing for cause in one["causes"]}
    return any(
        one["verdict"] in ("refuted", "suspect")
        or one["correction"]
        or one["id"] in causes
        or FALSE_AS_READ in str(one["message"])
        or AS_THE_REST in str(one["message"])
        for one in own
    )


def repairs(formulas: list[Entry], own: list[Entry]) -> list[str]:
    """The repairs that an audit proposes for a display, by what they print."""
    ids = {one["id"] for one in own}
    found: list[str] = []
    for one in formulas:
        proposed = [one["correction"], *one["alternatives"]] if one in own else []
        found += [repair["printed"] for repair in filter(None, proposed)][:MOST]
        if one in own or ids & {*one["causes"]}:
            found += repairs_told(str(one["message"]))
    return found


def ordered(tex: str, words: Vocabulary) -> str:
    """A formula with factors and terms in one order, one line for a fraction, one sign squared."""
    with suppress(NotationError):
        return to_latex(_ordered(read(tex, words, OpenParser)))
    return tex


def _ordered(formula: Formula) -> Formula:
    if isinstance(formula, Sum):
        return Sum((*sorted(map(_ordered, formula.terms), key=to_latex),))
    if isinstance(formula, Power) and isinstance(formula.base, Sum) and _is_even(formula.exponent):
        signs = (formula.base, Sum((*map(Negative, formula.base.terms),)))
        return Power(min(map(_ordered, signs), key=to_latex), formula.exponent)
    if not isinstance(formula, Product | Quotient | Negative):
        return formula.map_children(_ordered)
    number, above, below = Fraction(1), list[Formula](), list[Formula]()
    waiting: list[tuple[Formula, bool]] = [(formula, False)]
    while waiting:
        match waiting.pop():
            case Product(factors), under:
                waiting += [(factor, under) for factor in factors]
            case Quotient(over, divisor), under:
                waiting += [(over, under), (divisor, not under)]
            case Negative(argument), under:
                number, waiting = -number, [*waiting, (argument, under)]
            case Number(value), under if value:
                number = number / value if under else number * value
            case factor, under:
                (below if under else above).append(_ordered(factor))
    size = fraction_formula(abs(number))
    numerator, denominator = (times(*sorted(part, key=to_latex)) for part in (above, below))
    whole = times(size, Quotient(numerator, denominator) if below else numerator)
    return Negative(whole) if number < 0 else whole


def _is_even(exponent: Formula) -> bool:
    return isinstance(exponent, Number) and exponent.value % 2 == 0


def meant_formulas(path: Path, entry: Entry) -> set[str]:
    """What the author printed later, as the program prints it; nothing that stood there before."""
    return {*_statements(mended_source(path, entry))} - {*_statements(read_source(path))}


def mended_source(path: Path, entry: Entry) -> Source:
    """The page with what its author printed later."""
    source = read_source(path)
    mended = replace(source, text=source.text.replace(entry["wrong"], entry["right"], 1))
    if mended.text == source.text:
        raise CommandError(f"{path} has no {entry['wrong']}", NOTHING)
    return mended


def _statements(source: Source) -> Iterator[str]:
    """The statements of a source, as the program prints them."""
    paper = read_statements(source)
    for item in paper.items:
        if item.formula is not None:
            yield to_latex(item.formula)
    for formula in free_formulas(paper, paper.items).values():
        yield to_latex(with_integrals(formula))


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument("folder", type=Path, metavar="FOLDER", help="with index.json and the pages")
    words = "only the entries with these ids"
    parser.add_argument("--only", nargs="+", default=[], metavar="ID", help=words)
    session.add_timeout(parser, 5)


def run(arguments: argparse.Namespace) -> int:
    """Print what is said of each formula, and how many are noticed, and mended as by the author."""
    index = arguments.folder / "index.json"
    try:
        entries = json.loads(index.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise CommandError(f"{index}: {error}", NOTHING) from None
    found = []
    for entry in entries:
        if arguments.only and entry["id"] not in arguments.only:
            continue
        try:
            one = corrected_formula(arguments.folder, entry, arguments.timeout)
        except CommandError as error:
            one = CorrectedFormula(entry["id"], entry["kind"], LEFT, False, str(error))
        found.append(one)
        mended = ", mended" if one.repaired else ""
        mended += ", doubted when right, too" if one.alarm else ""
        print(f"{one.id} ({one.kind}): {one.end}{mended}: {one.said}", flush=True)
    if not found:
        raise CommandError("there is nothing to look at", NOTHING)
    ends = Counter(one.end for one in found)
    counts = ", ".join(f"{end} {ends[end]}" for end in (NOTICED, GREEN, LEFT))
    repaired, alarms = sum(one.repaired for one in found), sum(one.alarm for one in found)
    print(f"{len(found)} corrections: {counts}; as the author mended {repaired}", end="")
    print(f"; doubted when right, too {alarms}")
    return AS_RECORDED if ends[NOTICED] == len(found) else DIFFERENT


if __name__ == "__main__":
    sys.exit(run_command("python -m study.corrections", "study.corrections", sys.argv[1:]))
