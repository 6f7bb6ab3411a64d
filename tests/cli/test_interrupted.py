"""An audit that is interrupted prints what is known by then, and says that it was interrupted."""

import json
import os
import signal
import subprocess
import sys
import time
from random import Random
from threading import Thread

import pytest

from kowalevski_cas.audit.reading import ReadingSession
from kowalevski_cas.audit.referee import FirstReferee
from kowalevski_cas.cli import main
from kowalevski_cas.cli.session import Progress
from kowalevski_cas.reading import read
from kowalevski_cas.source.text import Source
from kowalevski_cas.verify.outcome import Verdict
from tests.sample import sampled

CLAIMS = [rf"{k}(x^2+y^2){'+y^3' * (k == 4)}" for k in range(2, 9)]

PAPER = "\n".join(
    [
        r"\documentclass{article}\begin{document}",
        r"The equations of motion are $$\dot x=y,\qquad \dot y=-x.$$",
        *(f"A first integral is $$F_{k}={claim}.$$" for k, claim in enumerate(CLAIMS, 1)),
        r"\end{document}",
    ]
)


@pytest.fixture
def paper(tmp_path):
    path = tmp_path / "paper.tex"
    path.write_text(PAPER)
    return path


def verdicts(paper, capsys):
    code = main(["audit", str(paper), "--alone", "--format", "json"])
    out = capsys.readouterr()
    return code, [f["verdict"] for f in json.loads(out.out)["formulas"]][2:], out.err


def interrupting(monkeypatch, at):
    """Interrupt this process when it hears of work for the nth time, counted from 1."""
    heard = []

    def hear(*words):
        heard.append(words)
        if len(heard) in at:
            os.kill(os.getpid(), signal.SIGINT)

    monkeypatch.setattr(Progress, "__call__", hear)


@pytest.mark.parametrize("at", sampled(range(1, len(CLAIMS) + 1), 1))
def test_what_is_decided_before_an_interruption_is_what_it_is_without_one(
    paper, monkeypatch, capsys, at
):
    code, whole, _ = verdicts(paper, capsys)
    assert code == 1 and whole.count("refuted") == 1
    with monkeypatch.context() as patch:
        interrupting(patch, {at})
        code, known, said = verdicts(paper, capsys)
    assert code == 130 and "interrupted" in said
    assert "timeout" in known or at > 1
    for one, other in zip(known, whole, strict=True):
        assert one in (other, "timeout") or (one, other) == ("undecided", "refuted")


def test_in_another_thread_nothing_is_interrupted(paper, capsys):
    codes = []
    thread = Thread(target=lambda: codes.append(main(["audit", str(paper), "--alone"])))
    thread.start()
    thread.join()
    assert codes == [1] and "interrupted" not in capsys.readouterr().err


def test_the_second_interruption_ends_it_at_once(paper, monkeypatch, capsys):
    interrupting(monkeypatch, {1, 2})
    assert main(["audit", str(paper), "--alone"]) == 130
    out = capsys.readouterr()
    assert not out.out and "interrupted" in out.err


@pytest.mark.slow
def test_behind_an_interrupted_audit_nothing_is_cut_off(paper, monkeypatch, capsys):
    with monkeypatch.context() as patch:
        interrupting(patch, {1})
        verdicts(paper, capsys)
    assert "timeout" not in verdicts(paper, capsys)[1]


@pytest.mark.slow
def test_what_fails_is_told_when_it_is_read_and_is_decided_once():
    told = []
    source = Source("paper.tex", PAPER)
    found = read(source, referee=FirstReferee(told.append, timeout=5))
    assert [source.line(place) for place in told] == [5]
    assert {*found.outcomes} == {claim.id for claim in found.derivation.claims}
    without = ReadingSession(read(source), timeout=5).outcomes
    decided = ReadingSession(found, timeout=5)
    assert {id: one.verdict for id, one in decided.outcomes.items()} == {
        id: one.verdict for id, one in without.items()
    }
    assert [one.verdict for one in without.values()].count(Verdict.REFUTED) == 1


def evidence(paper):
    """The files of the evidence of a paper, by their names."""
    folder = paper.with_suffix(".evidence")
    return {str(f.relative_to(folder)): f.read_bytes() for f in folder.rglob("*") if f.is_file()}


@pytest.mark.slow
def test_an_interruption_at_any_moment_leaves_the_evidence_whole(paper, tmp_path):
    recording = [sys.executable, "-m", "kowalevski_cas", "record"]
    start = time.monotonic()
    subprocess.run([*recording, paper], capture_output=True)
    took, whole = time.monotonic() - start, evidence(paper)
    assert "record.json" in whole
    random, ends = Random(1), set()
    for number in range(12):
        other = tmp_path / str(number) / paper.name
        other.parent.mkdir()
        other.write_text(PAPER)
        process = subprocess.Popen(
            [*recording, other], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        time.sleep(random.uniform(0, took))
        process.send_signal(signal.SIGINT)
        ends.add(process.wait())
        known = evidence(other)
        assert known.items() <= whole.items() and ("record.json" not in known or known == whole)
        subprocess.run([*recording, other], capture_output=True)
        assert evidence(other) == whole
    assert ends & {130, -signal.SIGINT}
