"""What mkdocs does with pages: it counts recorded verdicts, and roles of Sphinx become code."""

import json
import re
from collections import Counter
from pathlib import Path

DERIVATIONS = Path(__file__).parents[1] / "derivations"
ROLE = re.compile(r":(?:class|func|meth|mod|attr|data|exc|math):<code>(~?)([^<]*)</code>")
HEAD = ["| derivation | proved | with a condition | false |", "|---|---|---|---|"]
KINDS = ("proved", "conditional", "refuted")


def on_page_markdown(markdown, **_):
    """The page with a table of what is recorded of each derivation, where it asks for one."""
    return markdown.replace("<!-- verdicts -->", "\n".join([*HEAD, *map(row, records())]))


def records():
    """The records of all derivations, those of most claims first."""
    found = {
        path.parent.name: json.loads(path.read_text()) for path in DERIVATIONS.glob("*/record.json")
    }
    return sorted(found.items(), key=lambda pair: (-len(pair[1]["claims"]), pair[0]))


def row(record):
    """How many claims of a derivation have which verdict."""
    name, data = record
    counts = Counter(claim["verdict"] for claim in data["claims"].values())
    return f"| `{name}` | {' | '.join(str(counts[kind]) for kind in KINDS)} |"


def on_page_content(html, **_):
    """The page, in which ``~a.b.C`` is shown as its last part."""
    return ROLE.sub(
        lambda role: f"<code>{role[2].rpartition('.')[2] if role[1] else role[2]}</code>", html
    )
