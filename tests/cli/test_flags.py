"""Whatever stands behind a flag, a command ends with a message, and leaves no process behind."""

import os
import signal
import subprocess
import sys
from pathlib import Path
from time import monotonic, sleep

import pytest

from kowalevski_cas.cli import main
from tests.sample import sampled

ODD = (
    "", " ", "0", "-0", "-1", "1e-300", "1e8", "1e999", "nan", "inf", "-inf", "1/0", "0x10", "1_0",
    "٣", "true", "x.tex", "x.json", "9" * 400,
)  # fmt: skip
MOTION = ("motion", "--a", "1", "--b", "0.4", "--m", "0.8", "--l", "0.9")
CLAIM = ("verify", "kharlamov2002", "--only", "eq6", "--arithmetic")
COMMANDS = (
    (*CLAIM, "flint", "--timeout={}"), (*CLAIM, "modular", "--seed={}"), ("verify", "--only={}"),
    ("verify", "--format={}"), ("verify", "{}"), ("check", "{}"), ("audit", "{}"),
    ("audit", "--list", "{}"), ("audit", "--timeout={}", "x.tex"), ("record", "{}"),
    ("record", "--timeout={}", "x"), ("certificates", "{}"), ("report", "{}"),
    ("export", "singular", "{}", "-o", "out"), ("witness", "maxima", "{}"),
    ("find", "integrals", "--jobs={}", "kharlamov2002", "--scene", "Kowalevski case"),
    ("find", "darboux", "--cofactor={}", "--degree=1", "kharlamov2002", "--scene", "Kowalevski case"),
    ("find", "integrals", "--on={}", "kharlamov2002", "--scene", "Kowalevski case"),
    ("pictures", "{}"), ("animation", "--a={}"),
    (*MOTION, "--samples={}", "--until=1"), (*MOTION, "--until={}", "--samples=2"),
    (*MOTION, "--timeout={}", "--samples=2"), ("motion", "--point", "{}"),
    (*MOTION, "--method=ball", "--until={}", "--samples=2", "--timeout=1"),
    (*MOTION, "--method=lsoda", "--until={}", "--samples=2", "--timeout=0.5"),
    ("find", "integrals", "bobenko_reyman_semenov1989", "--degree=1", "--timeout=2", "--jobs={}"),
    ("find", "integrals", "bobenko_reyman_semenov1989", "--degree={}", "--timeout=2"),
    ("find", "closure", "bobenko_reyman_semenov1989", "{}", "--timeout=2"), ("bundle", "{}", "-o", "x"),
    ("audit", "x.tex", "--macros", "{}"), ("find", "exponents", "{}"),
    *((*MOTION, f"--{name}={{}}", "--samples=2") for name in "abml"),
)  # fmt: skip
USES = ["\0".join(words).format(odd) for words in COMMANDS for odd in ODD]


@pytest.mark.parametrize("use", sampled(USES, 15, id=lambda use: use[:60]))
def test_no_flag_gives_a_traceback(use, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    try:
        code = main(use.split("\0"))
    except SystemExit as stopped:
        code = stopped.code
    said = capsys.readouterr()
    assert code in range(7) and "Traceback" not in said.err
    assert said.out or said.err or code == 0


HANGS = r"""
from kowalevski_cas.paper.claims import Identity
from kowalevski_cas.paper.derivation import Derivation, Section
from kowalevski_cas.paper.scene import Scene
class Hangs(Identity):
    def goals(self, on):
        open("begun", "w").close()
        yield 7 ** 7 ** 11
s = Section("1", "")
f = s.display("f", r"\dot x = v,\quad \dot v = -x")
osc = Scene("oscillator", variables=("x", "v"), field=(f[1], f[2]))
s.claim(Hangs("hangs", osc, "", printed=f[1]), Identity("t", osc, "", printed=f[2]))
derivation = Derivation("hangs", "", "", "", (s,))
"""
KOWALEVSKI = (sys.executable, "-m", "kowalevski_cas")


@pytest.fixture
def hangs(tmp_path):
    """A derivation of which a claim computes in compiled code for hours."""
    folder = tmp_path / "hangs"
    folder.mkdir()
    (folder / "__init__.py").write_text(HANGS, encoding="utf-8")
    return folder


@pytest.mark.slow
def test_a_claim_that_hangs_in_compiled_code_ends_at_its_limit(hangs):
    done = subprocess.run(
        [*KOWALEVSKI, "verify", "hangs", "--timeout", "1"],
        cwd=hangs.parent, env=_environment(), capture_output=True, text=True, timeout=60,
    )  # fmt: skip
    assert done.returncode == 3 and done.stderr == ""
    assert "2 claims: 1 timeout, 1 proved" in done.stdout
    assert "Not decided within 1 s" in done.stdout


@pytest.mark.slow
def test_what_comes_to_no_end_does_not_block_the_record_of_the_others(hangs):
    done = subprocess.run(
        [*KOWALEVSKI, "record", "hangs", "--timeout", "15"],
        cwd=hangs.parent, env=_environment(), capture_output=True, text=True, timeout=120,
    )  # fmt: skip
    assert done.returncode == 3
    assert done.stderr == "hangs is not recorded: timeout: not decided within 15 s\n"
    assert [path.name for path in sorted(hangs.glob("certificates/*"))] == ["t.json"]
    assert '"t"' in (hangs / "record.json").read_text() and "1 claim recorded" in done.stdout


@pytest.mark.slow
def test_sigterm_leaves_no_process_behind(hangs):
    process = subprocess.Popen(
        [*KOWALEVSKI, "verify", "hangs"], cwd=hangs.parent, env=_environment(),
        stderr=subprocess.PIPE, text=True,
    )  # fmt: skip
    until = monotonic() + 60
    while not (hangs.parent / "begun").exists():
        assert monotonic() < until
        sleep(0.05)
    children = _children(process.pid)
    assert children
    process.send_signal(signal.SIGTERM)
    _, said = process.communicate(timeout=30)
    assert process.returncode == 130 and "interrupted" in said
    assert not _children(process.pid)
    while any(map(_runs, children)):  # who has ended runs until it is reaped
        assert monotonic() < until
        sleep(0.05)


def _environment():
    return {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}


def _children(parent):
    done = subprocess.run(["ps", "-eo", "pid=,ppid="], capture_output=True, text=True, check=True)
    rows = (line.split() for line in done.stdout.splitlines())
    return [int(pid) for pid, above in rows if int(above) == parent]


def _runs(pid):
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True
