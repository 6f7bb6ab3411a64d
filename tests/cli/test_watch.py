"""Audits that are done again, and runs with a limit: what is cut off is told, and never green."""

import json

import pytest

from kowalevski_cas.cli import audit, main
from kowalevski_cas.cli import watch as watching
from kowalevski_cas.limits import run_limit, time_limit
from kowalevski_cas.processes import each
from kowalevski_cas.reading import choice as choosing
from kowalevski_cas.verify.statement import Statement

PAPER = r"""\documentclass{article}\begin{document}
The equations are $$\dot x=y,\qquad \dot y=-x.$$
Then $x^2+y^2$ is an integral, and $x\dot x+y\dot y=0$.
\end{document}
"""


@pytest.fixture
def paper(tmp_path):
    path = tmp_path / "paper.tex"
    path.write_text(PAPER)
    return path


def test_a_change_of_the_source_is_audited_and_an_interruption_ends_it(paper, monkeypatch, capsys):
    changes = iter([PAPER.replace("y^2$", "2y^2$"), None])

    def pause(_):
        changed = next(changes)
        if changed is None:
            raise KeyboardInterrupt
        paper.write_text(changed)

    monkeypatch.setattr(watching, "sleep", pause)
    code = main(["audit", str(paper), "--alone", "--watch", "--format", "json"])
    said = capsys.readouterr().out
    first, end = json.JSONDecoder().raw_decode(said)
    second, _ = json.JSONDecoder().raw_decode(said[end:].lstrip())
    verdicts = [[f["verdict"] for f in one["formulas"]] for one in (first, second)]
    assert verdicts[0][2:] == ["proved", "proved"]
    assert verdicts[1][2:] == ["refuted", "proved"] and code == 1


def test_what_has_not_changed_keeps_its_evidence(paper, monkeypatch):
    """Evidence is handed to the next run by the names of claims."""
    kept = []

    def once(arguments, certificates, choices):
        kept.append({**certificates})
        return run_once(arguments, certificates, choices)

    def pause(_):
        if len(kept) > 1:
            raise KeyboardInterrupt
        paper.write_text(PAPER + "%")

    run_once = audit._run
    monkeypatch.setattr(audit, "_run", once)
    monkeypatch.setattr(watching, "sleep", pause)
    assert main(["audit", str(paper), "--alone", "--watch"]) == 0
    assert kept[0] == {} and len(kept[1]) == 2


def test_standard_input_is_not_watched(paper, capsys):
    assert main(["audit", str(paper), "--stdin", "--watch"]) == 2
    assert "--watch needs the file" in capsys.readouterr().err


def test_behind_the_limit_of_a_run_no_limit_is_entered():
    def enter(_):
        try:
            with time_limit(60):
                return "entered"
        except TimeoutError as error:
            return str(error)

    with run_limit(0):
        assert {*each(enter, range(3))} == {"not decided before the limit of the run"}
    assert {*each(enter, range(3))} == {"entered"}


def test_what_is_cut_off_is_timeout_and_no_success(paper, capsys):
    code = main(["audit", str(paper), "--alone", "--limit", "0.000001", "--format", "json"])
    found = json.loads(capsys.readouterr().out)
    assert [f["verdict"] for f in found["formulas"]][2:] == ["timeout", "timeout"]
    assert code == 3


@pytest.mark.slow
def test_what_has_not_changed_is_not_searched_for_again(tmp_path, monkeypatch, capsys):
    """A claim that is changed is, with its words none is, and with the law all that rest on it."""
    path, log = tmp_path / "paper.tex", tmp_path / "log"
    law = r"$$\dot x=y,\qquad \dot y=-x,\qquad \dot z=z.$$"
    claims = [r"x^2+y^2", r"(x^2+y^2)^2", r"5x^2+5y^2"]
    texts = [law, *(f"A first integral is $$F_{k}={claim}.$$" for k, claim in enumerate(claims))]
    path.write_text("\n".join(texts))

    def search(statement):
        with log.open("a") as file:
            file.write(f"{statement.claim.id}\n")
        return search_of(statement)

    def pause(_):
        searched.append(sorted(log.read_text().split()) if log.exists() else [])
        log.unlink(missing_ok=True)
        if len(searched) > len(changes):
            raise KeyboardInterrupt
        place, old, new = changes[len(searched) - 1]
        texts[place] = texts[place].replace(old, new)
        path.write_text("\n".join(texts))

    search_of, searched = Statement.search, []
    changes = [(1, "x^2+y^2", "2x^2+2y^2"), (2, "A first", "One more"), (0, "z=z", "z=2z")]
    monkeypatch.setattr(Statement, "search", search)
    monkeypatch.setattr(watching, "sleep", pause)
    assert main(["audit", str(path), "--alone", "--watch"]) == 0
    assert [len({*ids}) for ids in searched] == [3, 1, 0, 3]  # all rest on the law


def test_what_has_not_changed_is_not_chosen_again(tmp_path, monkeypatch):
    """A claim is if it changes, or a formula on which one of its readings stands."""
    path, log = tmp_path / "paper.tex", tmp_path / "log"
    texts = [
        r"$$\dot x=y,\qquad \dot y=-x.$$",
        r"Let $$H=x^2+y^2.$$",
        r"Then $$\dot H=0,$$",
        r"and $$\ddot x=-x.$$",
    ]
    path.write_text("\n".join(texts))

    def trial(rung, *others):
        with log.open("a") as file:
            file.write(f"{rung.claim.id}\n")
        return trial_of(rung, *others)

    def pause(_):
        chosen.append({*log.read_text().split()} if log.exists() else set())
        log.unlink(missing_ok=True)
        if len(chosen) > len(changes):
            raise KeyboardInterrupt
        place, old, new = changes[len(chosen) - 1]
        texts[place] = texts[place].replace(old, new)
        path.write_text("\n".join(texts))

    trial_of, chosen = choosing._trial, []
    changes = [(1, "Let", "We write"), (1, "y^2.", "y^2+1."), (0, "-x", "-x+0")]
    monkeypatch.setattr(choosing, "_trial", trial)
    monkeypatch.setattr(watching, "sleep", pause)
    assert main(["audit", str(path), "--alone", "--watch"]) == 0
    assert [len(ids) for ids in chosen] == [2, 0, 1, 2]
