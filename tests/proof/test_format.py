import json
import re
from pathlib import Path

import pytest

from kowalevski_cas.proof import checker

from .oracle import is_true
from .tampering import ODD, changed, names_in, others, places, seal

DOCUMENT = (Path(__file__).parents[2] / "docs" / "certificate.md").read_text(encoding="utf-8")
EXAMPLE = re.search(r"```json\n(.*?)```", DOCUMENT, re.S).group(1)
SAID = re.search(r"```text\n(.*?)```", DOCUMENT, re.S).group(1)


def test_the_example_of_the_document_is_accepted(tmp_path, capsys):
    path = tmp_path / "circles.json"
    path.write_text(EXAMPLE, encoding="utf-8")
    assert checker.main([str(path)]) == 0
    assert capsys.readouterr().out == SAID


def test_every_change_of_the_example_is_rejected_or_true():
    data = json.loads(EXAMPLE)
    names, through, tampered = sorted(names_in([data["spaces"], data["parts"]])), 0, 0
    for path in [p for p in places(data) if p[0] in ("spaces", "parts")]:
        for value in others(data, path, names):
            other, tampered = changed(data, path, value), tampered + 1
            try:
                checker.check(seal(other))
            except (checker.Rejected, *ODD):
                continue
            through += 1
            assert is_true(other) == (True, ""), (path, value)
    assert tampered > 1000 and through < tampered / 5


@pytest.mark.parametrize("word", ["variables", "constants", "nonzero", "steps", "field", "change",
    "conjugates", "product", "cases", "cofactors", "given", "point", "root", "levels", "notes"])  # fmt: skip
def test_the_document_explains(word):
    assert f"`{word}`" in DOCUMENT or f"**{word}**" in DOCUMENT


def test_the_document_has_the_limits_of_the_checker():
    for number in (checker.SIZE, checker.DEGREE, checker.WORK):
        assert f"{number:,}" in DOCUMENT.replace("1000,", "1,000,")
