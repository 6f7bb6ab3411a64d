from __future__ import annotations

import json
from pathlib import Path

import pytest

from study.store import data_file, load_rows, measure
from tests.study.toys import Interrupt


def run(step: Interrupt, folder: Path, **options: bool) -> list[dict]:
    return measure("toys", step, folder, options.pop("quick", True), lambda *_: None, **options)


def test_a_method_that_fails_is_a_row_with_its_reason(tmp_path):
    rows = run(Interrupt(fails="fair"), tmp_path)
    assert [row["verdict"] for row in rows] == ["proved", "error", "proved"]
    assert rows[1]["reason"] == "ValueError: it cannot"


def test_an_interrupted_study_keeps_what_it_measured_and_goes_on(tmp_path):
    with pytest.raises(KeyboardInterrupt):
        run(Interrupt(at="slow"), tmp_path)
    assert [row["method"] for row in load_rows("toys", tmp_path)] == ["good", "fair"]
    again = Interrupt()
    rows = run(again, tmp_path)
    assert again.ran == ["slow"]
    assert [row["method"] for row in rows] == ["good", "fair", "slow"]
    assert load_rows("toys", tmp_path) == rows


def test_a_line_torn_by_the_interruption_is_measured_again(tmp_path):
    run(Interrupt(), tmp_path)
    file = data_file(tmp_path, "toys")
    file.write_text(file.read_text()[:-10])
    again = Interrupt()
    run(again, tmp_path)
    assert again.ran == ["slow"]
    assert all(json.loads(line) for line in file.read_text().splitlines())


def test_rows_of_other_versions_are_not_continued(tmp_path):
    run(Interrupt(), tmp_path)
    file = data_file(tmp_path, "toys")
    header, *rows = file.read_text().splitlines(keepends=True)
    assert '"Python"' in header
    file.write_text(header.replace('"Python":"', '"Python":"0') + "".join(rows))
    again = Interrupt()
    run(again, tmp_path)
    assert again.ran == ["good", "fair", "slow"]


def test_quick_rows_are_no_full_ones(tmp_path):
    run(Interrupt(), tmp_path)
    again = Interrupt()
    run(again, tmp_path, quick=False)
    assert again.ran == ["good", "fair", "slow"]


def test_afresh_forgets(tmp_path):
    run(Interrupt(), tmp_path)
    again = Interrupt()
    run(again, tmp_path, afresh=True)
    assert again.ran == ["good", "fair", "slow"]


def test_the_same_task_twice_is_refused(tmp_path):
    step = Interrupt()
    step.measure = lambda quick: [*Interrupt().measure(quick), *Interrupt().measure(quick)]
    with pytest.raises(ValueError, match="same method and case"):
        run(step, tmp_path)


def test_damaged_lines_are_measured_again_and_the_others_kept(tmp_path):
    run(Interrupt(), tmp_path)
    file = data_file(tmp_path, "toys")
    header, good, *rest = file.read_bytes().splitlines(keepends=True)
    noise = b'\xff\x00\n[]\nnull\n{"method": [1], "case": {}, "verdict": 1}\n{"method": "x"}\n'
    file.write_bytes(b"".join([header, noise, good[:-9] + b"\n", *rest]))
    again = Interrupt()
    rows = run(again, tmp_path)
    assert again.ran == ["good"] and len(rows) == 3


def test_a_file_of_noise_is_no_study(tmp_path):
    file = data_file(tmp_path, "toys")
    file.parent.mkdir()
    file.write_bytes(bytes(range(128, 256)) + b"\n" + b"[" * 100_000)
    assert load_rows("toys", tmp_path) == []
    assert len(run(Interrupt(), tmp_path)) == 3
