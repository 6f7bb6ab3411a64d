"""Write the page of the rows of the DLMF with their verdicts, beside what LaCASt reports of them.

``python docs/dlmf.py`` writes ``dlmf.md`` in this folder. The verdicts are those of the records;
what LaCASt has reached with Maple and Mathematica, line by line, is in ``lacast.json``:
symbolically with each, and then numerically with each.
"""

import json
import re
from collections import Counter
from pathlib import Path

DOCS = Path(__file__).parent
SECTIONS = ("22.6", "22.7", "22.8", "22.13", "4.21", "4.35")
HYPOTHESES = {
    "22.8.19": "given in 22.8.20 and 22.8.21",
    "22.8.22": "given in 22.8.23",
    "22.8.24": "given in 22.8.25",
    "22.8.26": "given in 22.8.27",
}
UNJUDGED = {
    "4.21.34": "not judged: for all integers n",
    "4.21.35": "not judged: a product over k",
    "4.35.33": "not judged: for all integers n",
}
HEAD = """\
# Rows of the DLMF

Sections 22.6, 22.7, 22.8, 22.13, 4.21 and 4.35 of the
[Digital Library of Mathematical Functions](https://dlmf.nist.gov) are identities of Jacobi's, of
trigonometric and of hyperbolic functions. In `derivations/dlmf22` and `derivations/dlmf4` each is
restated as a formula with its number, and proved with a certificate: of the functions only their
derivatives, the relations between them and their values at one point are used. A row
with ± is proved with either sign; one with a root is read as the sentence beside it says, with
either sign of the root. Rows 22.8.23, 22.8.25 and 22.8.27 rest on values at parts of the quarter
period K, which are printed beside them; the other rows with K, or with a sum of arguments, are
what is given in these. In 4.21.1_5 the phase is known by its sine and cosine. *Conditional* is what
holds where the denominators do not vanish.

Every line that LaCASt prints has been compared with the rows as they stand here: they are the same
formulas. LaCASt does not print 22.8.20, 22.8.23, 22.8.25 and 4.21.1_5. The print of 22.8.23 and
22.8.25 was not at hand, only the words beside them: that 22.8.23 rests on 22.8.22, and that the
value in 22.8.25 does not depend on the arguments. What is proved under these two numbers has
not been compared with their print.

Beside each row stands in how many of its lines it is proved by Maple and by Mathematica, and in
how many lines one of them calls it false at values that were tried, as LaCASt reports
([gipplab/LaCASt](https://github.com/gipplab/LaCASt), `misc/Mediawiki`), which translates the rows
and takes a chain of equations for several lines.
"""


def verdicts() -> dict[str, str]:
    """The verdict on each row, the weaker one of several claims."""
    found: dict[str, str] = {}
    for name in ("dlmf22", "dlmf4"):
        record = json.loads((DOCS.parent / "derivations" / name / "record.json").read_text("utf-8"))
        for claim, entry in record["claims"].items():
            chapter, section, row = re.match(r"(\d+)\.(\d+)\.(\d+(?:_\d+)?)", claim).groups()
            number = f"{chapter}.{section}.{row}"
            own = [number]
            if section == "7":  # three rows are proved together
                own = [f"22.7.{int(row) + k}" for k in range(3)]
            for one in own:
                found[one] = max(found.get(one, "proved"), entry["verdict"], key=ORDER.index)
    return found


ORDER = ("proved", "conditional", "undecided", "timeout", "refuted", "error")


def order(number: str) -> list[float]:
    """Rows stand by their numbers; 1_5 is between 1 and 2."""
    return [float(part.replace("_", ".")) for part in number.split(".")]


def page() -> str:
    """The text of the page."""
    ours, theirs = verdicts(), json.loads((DOCS / "lacast.json").read_text("utf-8"))
    parts, totals = [], []
    for section in SECTIONS:
        numbers = [n for n in {*ours, *theirs} if n.startswith(f"{section}.")]
        rows = ["| row | verdict | Maple | Mathematica | called false |", "|---|---|---|---|---|"]
        count: Counter[str] = Counter()
        for number in sorted(numbers, key=order):
            lines = theirs.get(number, [])
            chapter, part, row = number.split(".")
            link = f"[{number}](https://dlmf.nist.gov/{chapter}.{part}.E{row})"
            verdict = ours.get(number) or {**HYPOTHESES, **UNJUDGED}[number]
            proved = [sum(line[k] == "successful" for line in lines) for k in (0, 1)]
            false = sum("failed" in line for line in lines)
            shown = [f"{p} of {len(lines)}" if lines else "–" for p in proved]
            rows.append(f"| {link} | {verdict} | {shown[0]} | {shown[1]} | {false or '–'} |")
            count["rows"] += number not in HYPOTHESES
            count["ours"] += number in ours
            count["lines"] += len(lines)
            count["false"] += false
            count["maple"] += proved[0]
            count["mathematica"] += proved[1]
        cells = [f"{count['ours']} of {count['rows']}"]
        cells += [f"{count[one]} of {count['lines']}" for one in ("maple", "mathematica")]
        totals.append(f"| {section} | {' | '.join(cells)} | {count['false']} |")
        parts.append(f"## {section}\n\n" + "\n".join(rows) + "\n")
    whole = [
        "| section | rows proved here | lines proved by Maple | by Mathematica | called false |"
    ]
    whole += ["|---|---|---|---|---|", *totals, ""]
    return "\n".join([HEAD, *whole, *parts])


if __name__ == "__main__":
    (DOCS / "dlmf.md").write_text(page(), encoding="utf-8")
