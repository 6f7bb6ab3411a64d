from __future__ import annotations

import pytest

from kowalevski_cas.pictures import save, style
from study.speed_accuracy import draw, summaries


def row(method, case, verdict, truth=True, seconds=0.01, proves=False, **more):
    measured = {"seconds": seconds, "verdict": verdict, "truth": truth, "proves": proves}
    return {"method": method, "case": str(case), **measured, **more}


ROWS = [
    *(row("flint", k, "accepted", seconds=0.002 + k / 1e3, proves=True) for k in range(5)),
    *(row("modular", k, "accepted", seconds=0.005, bound=3e-18) for k in range(5)),
    *(row("quick", k, "accepted", truth=k > 0, seconds=0.001) for k in range(5)),
    *(row("slow", k, "timeout", seconds=10.0, reason="10 s") for k in range(4)),
    row("slow", 4, "rejected", seconds=5.0),
    *(row("lucky", k, "accepted", seconds=0.02) for k in range(50)),
    *(row("happy", k, "accepted", seconds=0.03) for k in range(50)),
    row("shy", 1, "accepted", proves=True),
    row("shy", 2, "none", truth=False, proves=True, reason="it cannot tell"),
    row("broken", 1, "error", seconds=None, reason="ValueError: it cannot"),
]


@pytest.fixture(autouse=True)
def styled():
    with style():
        yield


@pytest.fixture
def found():
    return {summary.method: summary for summary in summaries(ROWS)}


def test_errors_and_silence_are_counted_among_true_and_among_false_statements(found):
    assert found["quick"].words == "wrong: 1 of 1 false"
    assert found["slow"].words == "wrong: 1 of 5 true; no answer: 4 of 5 true"
    assert found["shy"].words == "no answer: 1 of 1 false"
    assert found["flint"].words == ""


def test_the_surest_come_first_and_a_method_without_a_time_not_at_all(found):
    assert list(found) == ["flint", "shy", "modular", "lucky", "happy", "quick", "slow"]


def test_proof_is_more_than_no_error(found):
    kinds = {method: summary.grade[2] for method, summary in found.items()}
    assert kinds["flint"] == "proof" and kinds["modular"] == r"chance of error ≤ $3\cdot10^{-18}$"
    assert kinds["lucky"] == kinds["happy"] == "0 of 50 wrong: ≤ 3/50"
    assert kinds["quick"] == kinds["slow"] == "wrong answers seen"


def test_a_proof_that_is_wrong_is_no_proof():
    wrong = [*ROWS, row("flint", 9, "accepted", truth=False, proves=True)]
    assert {s.method: s for s in summaries(wrong)}["flint"].grade[2] == "wrong answers seen"


def test_a_proof_that_does_not_always_answer_is_hollow_and_says_so():
    (axes,) = draw(ROWS).axes
    marks = {int(line.get_ydata()[0]): line for line in axes.lines if line.get_marker() == "o"}
    fills = {place: line.get_markerfacecolor() for place, line in marks.items()}
    assert fills[0] != "white" and fills[1] == "white"
    assert any(text.get_text() == "no answer: 1 of 1 false" for text in axes.texts)


def test_a_start_is_a_tick_and_no_statement():
    starts = [row("shy", f"start {k}", "started", seconds=0.004 + k / 1e3) for k in range(3)]
    found = {summary.method: summary for summary in summaries([*ROWS, *starts])}
    assert len(found["shy"].rows) == 2 and found["shy"].start == 0.005
    assert found["flint"].start is None
    ticks = [line for line in draw([*ROWS, *starts]).axes[0].lines if line.get_marker() == "|"]
    assert [list(line.get_xdata()) for line in ticks] == [[0.005]]


def test_the_title_says_what_the_fastest_is_and_how_sure():
    (axes,) = draw(ROWS).axes
    assert axes.get_title(loc="left") == "the fastest answer: wrong answers seen, by quick in 1 ms"
    (axes,) = draw([one for one in ROWS if one["method"] != "quick"]).axes
    assert axes.get_title(loc="left") == "the fastest answer: proof, by FLINT in 4 ms"


@pytest.mark.slow
def test_every_method_has_a_line_and_no_words_cover_others():
    figure = draw(ROWS)
    figure.draw_without_rendering()
    (axes,) = figure.axes
    labels = [label.get_text().partition(", $n=") for label in axes.get_yticklabels()]
    assert [name for name, _, _ in labels][:3] == ["FLINT", "shy", "residues"]
    counts = [len(one.rows) for one in summaries(ROWS)]
    assert [many for _, _, many in labels] == [
        "" if count == max(counts) else f"{count}$" for count in counts
    ]
    boxes = [text.get_window_extent() for text in axes.texts]
    for k, one in enumerate(boxes):
        assert not any(one.overlaps(other) for other in boxes[k + 1 :])
        assert figure.bbox.x0 <= one.x0 and one.x1 <= figure.bbox.x1


def test_no_line_crosses_words():
    (axes,) = draw(ROWS).axes
    beside = [text for text in axes.texts if text.get_text().startswith(("no answer:", "wrong:"))]
    fastest = axes.lines[-1]
    assert fastest.get_linestyle() == "--" and len(beside) > 1
    for text in beside:  # what is behind the letters is cleared, lines too
        assert text.get_path_effects() and text.get_zorder() > fastest.get_zorder()


@pytest.mark.slow
def test_the_same_rows_give_the_same_files(tmp_path):
    one, other = (save(draw(ROWS), tmp_path, name).read_bytes() for name in "ab")
    assert one == other
