"""Each sentence of docs/verdicts.md names a test, which is there; each verdict has its sentences."""

import ast
import re
from functools import cache
from pathlib import Path

import pytest

from kowalevski_cas.verify.outcome import Verdict

ROOT = Path(__file__).parents[1]
TEXT = (ROOT / "docs" / "verdicts.md").read_text(encoding="utf-8")
SENTENCES = re.findall(r"^\* (.*?)(?=^\*|^#|\Z)", TEXT, re.MULTILINE | re.DOTALL)


@cache
def functions_of(path: Path) -> set[str]:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return {node.name for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)}


@pytest.mark.parametrize("sentence", SENTENCES)
def test_the_test_that_a_sentence_names_is_there(sentence):
    found = re.search(r"\(`(tests/[\w/]+\.py)::(test_\w+)`\)\s*\Z", sentence)
    assert found, "a test is expected at the end"
    assert found[2] in functions_of(ROOT / found[1])


@pytest.mark.parametrize("verdict", list(Verdict))
def test_each_verdict_is_explained(verdict):
    headings = re.findall(r"^## (.*)$", TEXT, re.MULTILINE)
    assert any(str(verdict) in heading.lower() for heading in headings)
