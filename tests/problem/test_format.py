import json
import random
import re
from pathlib import Path

import pytest

from kowalevski_cas.problem import checker
from kowalevski_cas.problem.checker.command import main

from .oracle import is_true
from .tampering import changed, names_in, others, places, seal

DOCUMENT = (Path(__file__).parents[2] / "docs" / "certificate.md").read_text(encoding="utf-8")
EXAMPLE = re.search(r'```json title="circles.json"\n(.*?)```', DOCUMENT, re.S).group(1)
SAID = re.search(r"```text\n(.*?)```", DOCUMENT, re.S).group(1)


def test_the_example_of_the_document_is_accepted(tmp_path, capsys):
    path = tmp_path / "circles.json"
    path.write_text(EXAMPLE, encoding="utf-8")
    assert main([str(path)]) == 0
    assert capsys.readouterr().out == SAID


@pytest.mark.slow
@pytest.mark.parametrize("share", [0.1, pytest.param(1, marks=pytest.mark.slow)])
def test_a_change_of_the_example_is_rejected_or_true(share):
    data = json.loads(EXAMPLE)
    names, through = sorted(names_in([data["spaces"], data["goals"]])), 0
    paths = [p for p in places(data) if p[0] in ("spaces", "goals", "sign", "evidence")]
    changes = [(path, value) for path in paths for value in others(data, path, names)]
    assert len(changes) > 1000
    changes = random.Random(1).sample(changes, int(share * len(changes)))
    for path, value in changes:
        other = changed(data, path, value)
        try:
            checker.check(seal(other))
        except checker.Rejected:
            continue
        through += 1
        assert is_true(other) == (True, ""), (path, value)
    assert through < len(changes) / 5


@pytest.mark.parametrize("word", ["variables", "constants", "nonzero", "steps", "field", "change",
    "conjugates", "product", "cases", "cofactors", "given", "point", "conclusions", "functions", "away", "sign",
    "minors", "squares", "eliminant", "quotients", "factors", "values", "inner", "points", *checker.KINDS])  # fmt: skip
def test_the_document_explains(word):
    assert f"`{word}`" in DOCUMENT or f"**{word}**" in DOCUMENT


@pytest.mark.parametrize("limit", ["SIZE", "DEGREE", "WORK", "BITS", "NAMES"])
def test_the_document_has_the_limits_of_the_checker(limit):
    assert re.search(rf"\b{getattr(checker, limit):,}\b", DOCUMENT)
