"""The papers with planted errors: what their truth says of them stands in them."""

import json
import re
from pathlib import Path

import pytest

PAPERS = sorted((Path(__file__).parent / "data" / "papers").glob("*.tex"))
KINDS = {
    "identity", "integral", "invariant", "limit", "equivalence", "independence", "count", "lax",
    "involution", "inequality", "other",
}  # fmt: skip


def spaced(tex):
    """A formula without its labels, spaces as one."""
    return " ".join(re.sub(r"\\label\{[^}]*\}", "", tex).split())


def source(path):
    data = path.read_bytes()
    return data.decode("cp1251" if b"[cp1251]{inputenc}" in data else "utf-8")


@pytest.mark.parametrize("path", PAPERS, ids=[path.stem for path in PAPERS])
def test_each_formula_stands_where_the_truth_says(path):
    lines = source(path).split("\n")
    truth = json.loads(path.with_suffix(".json").read_text(encoding="utf-8"))
    assert [row["line"] for row in truth] == sorted(row["line"] for row in truth)
    for row in truth:
        assert row["tex"] in spaced(
            " ".join(lines[row["line"] - 1 : row.get("until", row["line"])])
        )


@pytest.mark.parametrize("path", PAPERS, ids=[path.stem for path in PAPERS])
def test_what_is_not_true_has_its_error(path):
    for row in json.loads(path.with_suffix(".json").read_text(encoding="utf-8")):
        assert (row["role"] == "claim") == ("kind" in row)
        assert row.get("kind", "other") in KINDS
        assert (row["true"] in (False, "conditional")) == ("error" in row)
        if row["true"] == "conditional":
            assert row["error"]["class"] == "hypothesis"
