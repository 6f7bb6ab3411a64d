"""In a notebook what is asked shows itself; the example runs from its first cell to its last."""

from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

from kowalevski_cas import System, UserError
from kowalevski_cas.notebook import ask, audit, report
from kowalevski_cas.system.answers import SystemClaims

EXAMPLE = Path(__file__).parents[1] / "docs" / "notebook.ipynb"
PAPER = r"""\begin{document}
The oscillator moves by \[\dot x=v,\quad \dot v=-x.\]
The energy $H=\frac12(v^2-x^2)$ is a first integral.
\end{document}"""


def test_a_formula_is_asked_as_it_is_printed():
    names = {"circle": System(r"\dot x=y, \dot y=-x"), "x": 1}
    assert ask("circle integral x^2+y^2", names).verdict == "proved"
    assert ask(r"circle define F=\frac12 x^2", names).name == "F"
    for line in ("", "x integral x", "circle integral", "circle pool x", "circle __repr__ x"):
        with pytest.raises(UserError, match="%kc"):
            ask(line, names)


def test_a_report_and_a_paper_show_themselves(tmp_path):
    circle = System(r"\dot x=y, \dot y=-x")
    circle.integral("x^2-y^2")
    assert "refuted" in report(circle).html or "false" in report(circle).html
    (tmp_path / "paper.tex").write_text(PAPER)
    page = audit(tmp_path / "paper.tex")
    assert "false" in page.html and page._repr_html_().startswith("<iframe srcdoc=")
    assert "nothing was found" in SystemClaims()._repr_html_()


@pytest.mark.slow
@pytest.mark.filterwarnings("ignore")  # of the client's libraries
def test_the_example_runs_and_shows_what_it_says():
    notebook = nbformat.read(EXAMPLE, as_version=4)
    NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    shown = [
        output["data"]["text/html"]
        for cell in notebook.cells
        for output in cell.get("outputs", [])
        if "data" in output and "text/html" in output["data"]
    ]
    system, false, true, found, verdict, page = shown
    assert "<b>refuted</b>" in false and "<b>proved</b>" in true and verdict == "<b>proved</b>"
    assert "move" in system and "KF" in found and page.startswith("<iframe")
