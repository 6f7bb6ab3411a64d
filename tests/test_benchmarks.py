"""What became slower is told, and fails nothing."""

import json

import pytest

from benchmarks.corpus import CLAIMS, audit, paper
from benchmarks.rows import compare


@pytest.mark.parametrize(("ratio", "told"), [(1.4, False), (1.6, True)])
def test_half_as_much_again_as_the_committed_row_is_a_warning(ratio, told, tmp_path, capsys):
    file = tmp_path / "rows.json"
    row = {"seconds": 5.0, "ratio": 1.0, "MB": 40}
    file.write_text(json.dumps({"kowalevski-cas check": row}))
    compare({"kowalevski-cas check": {**row, "ratio": ratio}}, file)
    warned = "::warning::kowalevski-cas check takes 1.6 times" in capsys.readouterr().out
    assert warned == told


def test_what_has_no_row_is_only_shown(tmp_path, capsys):
    compare({"kowalevski-cas check": {"seconds": 5.0, "ratio": 1.0, "MB": 40}}, tmp_path / "none")
    assert "::warning" not in capsys.readouterr().out


@pytest.mark.slow
def test_a_paper_of_the_corpus_comes_back_with_a_verdict_and_a_certificate_for_each_claim():
    found = audit(paper(1))
    assert len(found.verdicts) >= CLAIMS and {*found.verdicts} <= {"proved", "refuted"}
    assert len(found.certificates) == len(found.verdicts) and all(found.certificates)
    assert paper(1) == paper(1) != paper(2)
