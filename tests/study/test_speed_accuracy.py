from __future__ import annotations

import pytest

from kowalevski_cas.pictures import save, style
from study.charts import seconds
from study.speed_accuracy import draw
from study.speed_accuracy_chart import chart
from study.summary import pareto, summaries


def row(method, case, verdict, truth=True, seconds=0.01, reason="", **more):
    measured = {"seconds": seconds, "verdict": verdict, "reason": reason, "truth": truth}
    return {"method": method, "case": str(case), **measured, **more}


ROWS = [
    *(row("flint", k, "accepted", seconds=0.01 + k / 1e3, proves=True) for k in range(5)),
    *(row("modular", k, "accepted", seconds=0.005, bound=1e-18) for k in range(5)),
    *(row("quick", k, "accepted", truth=k > 0, seconds=0.001) for k in range(5)),
    *(row("slow", k, "timeout", seconds=10.0, reason="10 s") for k in range(4)),
    row("slow", 4, "rejected", seconds=5.0),
    *(row("lucky", k, "accepted", seconds=0.02) for k in range(5)),
    row("broken", 1, "error", seconds=None, reason="ValueError: it cannot"),
    {"method": "flint", "case": "cold 1", "seconds": 0.2, "verdict": "cold", "reason": ""},
]


@pytest.fixture(autouse=True)
def styled():
    with style():
        yield


@pytest.fixture
def found():
    return {summary.method: summary for summary in summaries(ROWS)}


def test_errors_are_counted_by_kind(found):
    assert found["quick"].false_accepts == 1 and found["quick"].rate == 0.2
    assert (
        found["slow"].false_rejects == 1 and found["slow"].words == "1 true rejected, 4 over 10 s"
    )
    assert found["broken"].words == "1 failed"


def test_proof_is_more_than_no_error(found):
    assert found["flint"].is_proof and not found["lucky"].is_proof
    assert found["lucky"].is_estimate and found["lucky"].rate == pytest.approx(3 / 5)
    assert found["modular"].rate == 1e-18 and not found["modular"].is_estimate


def test_a_proof_that_is_wrong_is_no_proof():
    wrong = [*ROWS, row("flint", 9, "accepted", truth=False, proves=True)]
    assert not summaries(wrong)[0].is_proof


def test_the_front_has_the_methods_than_which_none_is_faster_and_surer(found):
    assert [s.method for s in pareto(list(found.values()))] == ["quick", "modular", "flint"]


def test_every_method_is_in_the_chart(found):
    figure = chart(list(found.values()))
    texts = {t.get_text() for axes in figure.axes for t in axes.texts}
    texts |= {t.get_text() for t in figure.texts}
    names = {"FLINT", "residues", "quick", "slow", "lucky", "broken"}
    assert all(any(text.startswith(name) for text in texts) for name in names)
    assert any("4 over 10 s" in text for text in texts)


def test_labels_do_not_cover_each_other(found):
    figure = chart(list(found.values()))
    figure.canvas.draw()
    for axes in figure.axes:
        boxes = [text.get_window_extent() for text in axes.texts if text.get_text()]
        for k, one in enumerate(boxes):
            assert not any(one.overlaps(other) for other in boxes[k + 1 :])


def test_the_same_rows_give_the_same_files(tmp_path):
    one, other = (save(draw(ROWS)["speed-accuracy"], tmp_path, name).read_bytes() for name in "ab")
    assert one == other


def test_times_are_said_in_words():
    assert [seconds(t) for t in (1e-9, 3e-6, 0.25, 12)] == ["1 ns", "3 µs", "250 ms", "12 s"]
