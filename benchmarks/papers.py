"""How long a person waits for the audit of a paper: for the first finding, and for the end.

The papers are synthetic: sections with equations of motion of their own and combinations of their
integrals, one in twenty with a token too many. With ``--write`` the rows are committed anew.
"""

from __future__ import annotations

import json
import os
import sys
from collections import Counter
from pathlib import Path
from random import Random
from time import perf_counter

from benchmarks.corpus import MISPRINTS, SYSTEMS, variables
from kowalevski_cas.audit.reading import ReadingSession, audit_reading
from kowalevski_cas.audit.referee import FirstReferee
from kowalevski_cas.reading import read
from kowalevski_cas.source.text import Source

ROWS = Path(__file__).with_suffix(".json")

SIZES = (40, 2000)
"""The formulas of the papers."""

SECTION = 20
"""The formulas of a section."""

TIMEOUT = 5.0


def paper(size: int, seed: int = 1) -> str:
    """A paper with so many displays."""
    random, lines = Random(seed), [r"\documentclass{article}\begin{document}"]
    for number in range(size):
        section, place = divmod(number, SECTION)
        if not place:
            system = random.choice(SYSTEMS)
            lines += [rf"\section{{System {section}}}", "Now consider another system."]
            lines += [rf"Its equations are \begin{{equation}}{system.motion}.\end{{equation}}"]
            continue
        terms = [rf"{random.randint(2, 99)}({one})" for one in system.known]
        wrong = f"+{random.choice(variables(system.motion))}^3" * (random.random() < MISPRINTS)
        tex = rf"F_{{{section},{place}}}={'+'.join(terms)}{wrong}"
        lines += ["A first integral is", rf"\begin{{equation}}{tex}.\end{{equation}}"]
    return "\n".join([*lines, r"\end{document}"])


def measure(size: int) -> dict[str, object]:
    """What the audit of a paper takes."""
    source, told = Source("paper.tex", paper(size)), list[float]()
    start, before = perf_counter(), os.times()
    referee = FirstReferee(lambda _: told.append(perf_counter() - start), timeout=TIMEOUT)
    found = audit_reading(ReadingSession(read(source, referee=referee), timeout=TIMEOUT))
    seconds, after = perf_counter() - start, os.times()
    return {
        "displays": size,
        "statements": len(found.formulas),
        "verdicts": dict(Counter(str(one.verdict) for one in found.outcomes.values())),
        "seconds to the first finding": round(told[0], 1) if told else None,
        "seconds": round(seconds, 1),
        "CPU seconds": round(sum(after[:4]) - sum(before[:4]), 1),
        "processors": os.cpu_count(),
    }


def main() -> None:
    """Measure, and print what was found."""
    found = json.dumps([measure(size) for size in SIZES], indent=1)
    print(found)
    if "--write" in sys.argv[1:]:
        ROWS.write_text(f"{found}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
