"""How papers are read and judged, compared with what is known of each of their formulas.

Beside PAPER.tex lies PAPER.json, the truth, as tests/data/papers/README.md says. The paper is
audited by the command, as a stranger would do it, without a derivation.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from kowalevski_cas.audit.followed import FROM_BEFORE
from kowalevski_cas.cli import run as run_command
from kowalevski_cas.cli import session
from kowalevski_cas.cli.exits import AS_RECORDED, DIFFERENT, NOTHING, CommandError
from kowalevski_cas.reading.dimensions import AS_THE_REST
from kowalevski_cas.source.files import read_source
from kowalevski_cas.verify.outcome import FALSE_AS_READ, Verdict

EXIT_CODES = {
    AS_RECORDED: "nothing false is proved, and nothing true refuted",
    DIFFERENT: "something is, or an audit ends without an answer",
}

LIMIT = 240
"""The seconds for a paper, if no others are asked for: what is cut off then is ``timeout``."""

GRACE = 60
"""The seconds after which a paper that has passed its limit is given up."""

STANDS_FOR = {
    "level": ("notation", "definition", "claim"),
    "other": ("notation",),
    "notation": ("other",),
}
"""Roles of the truth that are right as well, where the audit has another word."""

_WITH = re.compile(r"(?:it holds|is true) with \$(.*?)\$")
_DOLLARS = re.compile(r"\$(.*?)\$")

_GREEN = ("proved", "conditional")
_GAP = r"(?:\s|\\label\{[^}]*\})*"

Entry = dict[str, Any]
"""A formula of the truth, or of an audit."""


@dataclass
class Score:
    """The roles and verdicts of the formulas of a paper, against the truth."""

    roles: Counter[bool] = field(default_factory=Counter)
    verdicts: Counter[bool] = field(default_factory=Counter)
    errors: Counter[bool] = field(default_factory=Counter)
    """Of the planted errors, whether they are noticed: the formula is red, suspected, a cause,
    corrected, or yellow because it is false as it was read."""
    doubted: Counter[bool] = field(default_factory=Counter)
    """Of the claims that are true, whether they are yellow because they are false as read."""
    timeouts: int = 0
    """How many claims were cut off by a limit of time."""
    repairs: int = 0
    """For how many of the planted errors there is a repair, of the formula itself."""
    false_greens: list[str] = field(default_factory=list)
    false_reds: list[str] = field(default_factory=list)
    misread: list[str] = field(default_factory=list)
    missed: list[str] = field(default_factory=list)
    unnoticed: list[str] = field(default_factory=list)

    def add(self, other: Score) -> None:
        """Count another paper in."""
        self.roles += other.roles
        self.verdicts += other.verdicts
        self.errors += other.errors
        self.doubted += other.doubted
        self.repairs += other.repairs
        self.timeouts += other.timeouts
        self.false_greens += other.false_greens
        self.false_reds += other.false_reds

    @property
    def line(self) -> str:
        """The counts in a line."""
        return ", ".join(
            [
                *(
                    f"{name} {counts[True]}/{counts.total()}"
                    for name, counts in (
                        ("roles", self.roles),
                        ("verdicts", self.verdicts),
                        ("errors noticed", self.errors),
                    )
                ),
                f"repaired {self.repairs}",
                f"true and doubted {self.doubted[True]}/{self.doubted.total()}",
                f"false greens {len(self.false_greens)}",
                f"false reds {len(self.false_reds)}",
                f"timeouts {self.timeouts}",
            ]
        )


def repairs_told(message: str) -> list[str]:
    """The repairs of which a message speaks."""
    said, _, rest = message.partition(FROM_BEFORE)
    said, _, more = said.partition(AS_THE_REST)
    return [*_WITH.findall(said), *_DOLLARS.findall(more), *_DOLLARS.findall(rest)]


def audit_entries(path: Path, timeout: float, limit: float = LIMIT) -> list[Entry]:
    """The formulas of an audit without a derivation, and what it judges of claims in words.

    ``timeout`` is the limit of a claim, and ``limit`` that of the paper.

    Raises:
        CommandError: the audit ends without an answer.
    """
    command = [sys.executable, "-m", "kowalevski_cas", "audit", str(path), "--alone"]
    options = ["--format", "json", "--timeout", str(timeout), "--limit", str(limit)]
    most = limit + GRACE
    try:
        done = subprocess.run([*command, *options], capture_output=True, timeout=most, text=True)
        found = json.loads(done.stdout)
    except subprocess.TimeoutExpired:
        raise CommandError(f"no answer in {most:.0f} s", NOTHING) from None
    except ValueError:
        last = (done.stderr.strip().splitlines() or ["nothing was said"])[-1]
        raise CommandError(f"exit code {done.returncode}, {last}", NOTHING) from None
    in_words = (
        {**one, "role": "claim", "reason": ""} for one in found["statements"] if one["line"]
    )
    return [*found["formulas"], *in_words]


def places(text: str, truth: list[Entry]) -> Iterator[tuple[int, int]]:
    """The interval of the source that each formula of the truth is in, one after another."""
    starts = [0, *(match.end() for match in re.finditer("\n", text))]
    end = 0
    for row in truth:
        pattern = _GAP.join(re.escape(word) for word in row["tex"].split())
        match = re.compile(pattern).search(text, max(end, starts[row["line"] - 1]))
        if match is None:
            match = re.compile(pattern).search(text, starts[row["line"] - 1])
        if match is None:
            raise CommandError(f"line {row['line']}: the source has no {row['tex']}", NOTHING)
        end = match.end()
        yield match.span()


def compare(path: Path, formulas: list[Entry]) -> Score:
    """The score of an audit of a paper."""
    text = read_source(path).text
    truth = json.loads(path.with_suffix(".json").read_text(encoding="utf-8"))
    starts = [0, *(match.end() for match in re.finditer("\n", text))]
    offsets = [(starts[f["line"] - 1] + f["column"] - 1, f) for f in formulas]
    causes = {cause for f in formulas for cause in f["causes"]}
    failing = {f["id"] for f in formulas if f["verdict"] == "refuted"}
    score = Score(timeouts=sum(f["verdict"] == Verdict.TIMEOUT for f in formulas))
    for row, (start, end) in zip(truth, places(text, truth), strict=True):
        here = [f for offset, f in offsets if start <= offset < end]
        where = f"{path.stem}:{row['line']}"
        if not row.get("sentence"):
            _role(score, row, here, where)
        _verdict(score, row, here, where, failing)
        if "error" in row:
            noticed = any(
                f["verdict"] in ("refuted", "suspect")
                or f["correction"]
                or f["id"] in causes
                or _is_doubted(f)
                for f in here
            )
            score.errors[noticed] += 1
            if not noticed:
                said = "; ".join(f"{f['role']}, {f['verdict']}" for f in here) or "not listed"
                score.unnoticed.append(f"{where} {row['tex'][:60]}: {said}")
            score.repairs += any(f["correction"] or repairs_told(str(f["message"])) for f in here)
    return score


def _role(score: Score, row: Entry, here: list[Entry], where: str) -> None:
    role = row["role"]
    right = bool(here) and all(
        role == f["role"] or role in STANDS_FOR.get(f["role"], ()) for f in here
    )
    score.roles[right] += 1
    if not right:
        said = "; ".join(f"{f['role']} ({f['reason']})" for f in here) or "not listed"
        score.misread.append(f"{where} {role}: {said}")


def _verdict(score: Score, row: Entry, here: list[Entry], where: str, failing: set[str]) -> None:
    """Count the verdict of a claim, and what is red or green and should not be."""
    said = [f["verdict"] for f in here if f["role"] == "claim"]
    red = "refuted" in said
    green = bool(said) and all(verdict in _GREEN for verdict in said)
    true = row["true"] is True and row.get("as_printed", True) is True
    if red and (true or (row["true"] is None and "error" not in row)):
        score.false_reds.append(f"{where} {row['tex']}")
    if row["role"] != "claim":
        return
    if green and not true and ("proved" in said or row["true"] is False):
        score.false_greens.append(f"{where} {row['tex']}")
    if true:
        right = green
        score.doubted[any(map(_is_doubted, here))] += 1
    elif row["true"] is False:
        right = red
    else:
        doubted = {"refuted", "undecided"} | ({row["true"]} & {"conditional"})
        right = bool(doubted & set(said)) and "proved" not in said
        # true where what is cited holds, which is misprinted, and said to be false
        cited = {name.rpartition(".")[0] for f in here for name in f.get("on") or ()}
        right = right or (row["true"] is True and said == ["conditional"] and bool(cited & failing))
    score.verdicts[right] += 1
    if not right:
        words = ", ".join(said) or "no claim"
        score.missed.append(f"{where} {row['kind']}, {row['true']}: {words}")


def _is_doubted(found: Entry) -> bool:
    """Whether a claim is yellow because it is false as it was read."""
    told = str(found["message"]).startswith(FALSE_AS_READ)
    return found["verdict"] == Verdict.UNDECIDED and told


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    parser.add_argument("papers", nargs="+", type=Path, metavar="PAPER.tex", help="with its truth")
    session.add_timeout(parser, 5)
    session.add_limit(parser)
    parser.set_defaults(limit=LIMIT)
    parser.add_argument("-v", "--verbose", action="store_true", help="list what is misread, missed")


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    total, failed = Score(), False
    for path in arguments.papers:
        try:
            score = compare(path, audit_entries(path, arguments.timeout, arguments.limit))
        except CommandError as error:
            print(f"{path.stem}: {error}", flush=True)
            failed = True
            continue
        print(f"{path.stem}: {score.line}", flush=True)
        if arguments.verbose:
            for name in ("misread", "missed", "unnoticed"):
                print("".join(f"  {name} {words}\n" for words in getattr(score, name)), end="")
        total.add(score)
    print(f"all: {total.line}")
    for name in ("false_greens", "false_reds"):
        print(
            "".join(f"  {name.replace('_', ' ')[:-1]} {w}\n" for w in getattr(total, name)), end=""
        )
    return DIFFERENT if failed or total.false_greens or total.false_reds else AS_RECORDED


if __name__ == "__main__":
    sys.exit(run_command("python -m study.readings", "study.readings", sys.argv[1:]))
