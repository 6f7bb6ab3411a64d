"""One wrong token in the equations of motion: is the right equation blamed for what fails by it?

Fields of which integrals are published are printed with one token changed at random, on the right
side of one equation. A change by which every integral stays true is excluded, by the proofs, and
counted. Else each claim that fails has to blame the changed equation, first and alone: if another
equation is as likely, that is a failure. ``python -m study.fields --write`` commits the figures.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from random import Random
from statistics import median
from time import process_time

from kowalevski_cas import System, UserError
from kowalevski_cas.cli import run as run_command
from kowalevski_cas.cli.exits import AS_RECORDED, DIFFERENT
from kowalevski_cas.notation import NotationError, Vocabulary
from kowalevski_cas.notation.lexer import scan
from kowalevski_cas.paper.derivation import Derivation
from kowalevski_cas.processes import each
from kowalevski_cas.verify.outcome import Outcome, Verdict
from kowalevski_cas.verify.run import Session
from kowalevski_cas.verify.suspects import slip
from study.mutants.mutant import changes_at, letters_of
from study.published import PUBLISHED, Published

FIGURES = Path(__file__).with_suffix(".json")

FIELDS = 50
SEED = 1
SECONDS = 60.0
"""For each claim."""

KNOWN = [one for one in PUBLISHED if one.question == "integrals" and len(one.known) > 1]

RIGHT, TIE, OTHER, NONE, HARMLESS = "right", "tie", "another formula", "no repair", "harmless"


@dataclass(frozen=True)
class WrongField:
    """A field with one wrong token: in which row, and the words for the change."""

    published: Published
    motion: str
    row: int
    words: str

    @cached_property
    def outcomes(self) -> tuple[Outcome, ...]:
        """What is said of the published integrals."""
        system = System(self.motion)
        for integral in self.published.known:
            system.integral(integral)
        derivation = Derivation(self.published.name, "", "", "", (system.section,))
        return Session(derivation, ["flint"], timeout=SECONDS).run().outcomes


@dataclass(frozen=True)
class BlamedField:
    """What came of a wrong field, and the seconds of a processor that it took."""

    name: str
    change: str
    end: str
    seconds: float
    said: tuple[str, ...] = ()


def wrong_fields(published: Published, random: Random) -> Iterator[WrongField]:
    """Fields with one token changed, without end: on a right side, so that it is a field again."""
    tex = published.motion
    scene = System(tex).scene
    letters = letters_of(Vocabulary(frozenset({*scene.variables, *scene.constants})))
    tokens = scan(tex)
    while True:
        at = random.randrange(len(tokens))
        changes = [*changes_at(tokens, at, tex, letters)]
        row = tex[: tokens[at].start].count(r"\dot")
        begun = re.split(r",\s*\\quad", tex[: tokens[at].start])[-1]
        if not changes or "=" not in begun:
            continue
        _, start, end, new = random.choice(changes)
        motion = tex[:start] + new + tex[end:]
        try:
            _ = System(motion).scene
        except (UserError, NotationError):
            continue
        words = f"equation {row}: {new.strip() or 'nothing'} for {tex[start:end]}"
        yield WrongField(published, motion, row, words)


def blamed(field: WrongField) -> BlamedField:
    """What is blamed for what fails by a wrong token."""
    start = process_time()
    outcomes = field.outcomes
    seconds = round(process_time() - start, 2)
    failing = [one for one in outcomes if not one.verdict.green]
    ends = [end_of(one, field.row) for one in failing]
    said = tuple(one.correction.words for one in failing if one.correction is not None)
    end = next((end for end in (NONE, OTHER, TIE, RIGHT) if end in ends), HARMLESS)
    return BlamedField(field.published.name, field.words, end, seconds, said)


def end_of(outcome: Outcome, row: int) -> str:
    """Whether the right row is blamed for a claim that fails, first and alone."""
    first = outcome.correction
    if outcome.verdict is not Verdict.REFUTED or first is None:
        return NONE
    if first.edit is None or not first.blamed or first.printed is None:
        return OTHER
    if first.printed.number != row:
        return OTHER
    others = [one for one in outcome.alternatives if one.blamed and one.printed != first.printed]
    return TIE if any(one.edit and slip(one.edit) == slip(first.edit) for one in others) else RIGHT


def measure(seed: int, size: int) -> list[BlamedField]:
    """So many fields that are wrong, from all systems in turn, and those that are harmless."""
    choose = [wrong_fields(one, Random(f"{seed} {one.name}")) for one in KNOWN]
    found: list[BlamedField] = []
    seen: set[str] = set()
    turn = 0
    while (missing := size - sum(one.end != HARMLESS for one in found)) > 0:
        fields: list[WrongField] = []
        while len(fields) < missing:
            field = next(choose[turn % len(choose)])
            if field.motion not in seen:
                seen.add(field.motion)
                fields.append(field)
                turn += 1
        found += each(blamed, fields)
    return found


def figures(found: list[BlamedField]) -> dict[str, object]:
    """The counts, the median of the seconds, and the fields."""
    wrong = [one for one in found if one.end != HARMLESS]
    ends = {end: sum(one.end == end for one in found) for end in (RIGHT, TIE, OTHER, NONE)}
    return {
        "fields": len(wrong),
        "systems": len({one.name for one in wrong}),
        "harmless": len(found) - len(wrong),
        **ends,
        "median seconds": round(median(one.seconds for one in wrong), 2),
        "rows": [asdict(one) for one in found],
    }


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument("--seed", type=int, default=SEED, metavar="N", help=f"({SEED})")
    parser.add_argument("--size", type=int, default=FIELDS, metavar="N", help=f"fields ({FIELDS})")
    parser.add_argument("--write", action="store_true", help=f"write {FIGURES.name} anew")


def run(arguments: argparse.Namespace) -> int:
    """Measure, print what is not blamed rightly, and the counts."""
    found = figures(measure(arguments.seed, arguments.size))
    rows = found.pop("rows")
    assert isinstance(rows, list)
    for row in rows:
        if row["end"] not in (RIGHT, HARMLESS):
            said = "; ".join(dict.fromkeys(row["said"]))
            print(f"{row['end']:16} {row['name']}, {row['change']} ({row['seconds']} s): {said}")
    print(json.dumps(found, ensure_ascii=False))
    if arguments.write:
        text = json.dumps({**found, "rows": rows}, indent=1, ensure_ascii=False)
        FIGURES.write_text(f"{text}\n", encoding="utf-8")
    return AS_RECORDED if found[RIGHT] == found["fields"] else DIFFERENT


if __name__ == "__main__":
    sys.exit(run_command("python -m study.fields", "study.fields", sys.argv[1:]))
