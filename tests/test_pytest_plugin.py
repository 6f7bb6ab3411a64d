"""Derivations as tests of pytest: one a claim, and a broken one hides no other."""

import gc
from contextlib import redirect_stdout
from io import StringIO
from multiprocessing import get_context

import pytest

CIRCLE = r"""
from kowalevski_cas import System
circle = System(r"\dot x=y, \dot y=-x")
circle.integral("x^2+y^2")
circle.integral("x^2-y^2"{})
"""


def said_by_pytest(options):
    """The exit code of pytest here, and what it prints."""
    gc.freeze()  # pytest looks at its end for what is left over, and not among what was here
    with redirect_stdout(StringIO()) as said:
        code = pytest.main(["-p", "kowalevski_cas.pytest_plugin", "-v", *options])
    return code, said.getvalue()


@pytest.fixture
def run(tmp_path, monkeypatch):
    """Let pytest test files in a folder of their own; the exit code, and what it prints."""

    def run(files, *options):
        for name, text in files.items():
            (tmp_path / name).parent.mkdir(exist_ok=True)
            (tmp_path / name).write_text(text, encoding="utf-8")
        monkeypatch.chdir(tmp_path)
        monkeypatch.syspath_prepend(tmp_path)
        with get_context("fork").Pool(1) as copy:  # of this process, which need not import anew
            return copy.apply(said_by_pytest, (options,))

    return run


@pytest.mark.slow
def test_a_claim_is_a_test_and_its_failure_reads_like_the_terminal(run):
    code, out = run({"derivation_circle.py": CIRCLE.format("")})
    assert code == 1
    assert "derivation_circle.py::integral-x-2-y-2 PASSED" in out
    assert "derivation_circle.py::integral-x-2-y-2::2 FAILED" in out
    assert "the derivative of x² − y² along the motion is 4, not 0" in out
    assert "expected that it is true, found refuted" in out
    assert "Traceback" not in out


def test_what_is_expected_passes(run):
    assert run({"derivation_circle.py": CIRCLE.format(', expect="refuted"')})[0] == 0


@pytest.mark.slow
def test_a_claim_that_comes_to_no_end_fails_in_its_time(run):
    hangs = """
from kowalevski_cas import System
from kowalevski_cas.paper.claims import Identity
class Hangs(Identity):
    def goals(self, on):
        yield 7 ** 7 ** 11
circle = System(r"\\dot x=y, \\dot y=-x")
circle.states(Hangs, "hangs", "it hangs", printed="x=x")
circle.integral("x^2+y^2")
"""
    code, out = run({"derivation_circle.py": hangs}, "--claim-timeout=0.5")
    assert code == 1 and "1 failed, 1 passed" in out
    assert "Not decided within 0.5 s" in out


@pytest.mark.slow
def test_a_broken_file_hides_no_other(run):
    good = CIRCLE.format(', expect="refuted"')
    files = {"derivation_a.py": "1 +", "derivation_b.py": good, "derivation_c.py": "x = 1"}
    files["derivation_d.py"] = "import os\nos._exit(0)"
    code, out = run(files)
    assert code == 1 and "3 failed, 2 passed" in out
    assert "derivation_a.py:1: SyntaxError" in out and "derivation_c.py states nothing" in out
    assert "derivation_d.py:2: os._exit would end the program" in out


@pytest.mark.slow
def test_installed_packages_name_their_derivations(run):
    files = {
        "circles.py": CIRCLE.format(""),
        "circles-1.dist-info/METADATA": "Metadata-Version: 2.1\nName: circles\nVersion: 1\n",
        "circles-1.dist-info/entry_points.txt": "[kowalevski_cas.derivations]\na = circles\nb = none\n",
    }
    assert run(files)[0] == 5
    code, out = run(files, "--derivations")
    assert code == 1 and "2 failed, 1 passed" in out
    assert "there is no derivation “none”" in out
