"""The command line: exit codes, messages, formats; never a traceback."""

import json
import os
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

from kowalevski_cas.cli import main
from kowalevski_cas.library import available
from kowalevski_cas.problem import checker
from kowalevski_cas.verify.arithmetics import Arithmetics
from kowalevski_cas.verify.outcome import Verdict
from kowalevski_cas.verify.record import load_record
from tests.sample import sampled

pytestmark = pytest.mark.usefixtures("here")

ROOT = Path(__file__).parents[2]

HEAD = r"""
from kowalevski_cas.paper.claims import *
from kowalevski_cas.paper.derivation import Derivation, Section
from kowalevski_cas.paper.scene import Scene
s = Section("1", "The oscillator")
f = s.display("f", r"\dot x = v,\quad \dot v = -x")
osc = Scene("oscillator", variables=("x", "v"), field=(f[1], f[2]))
"""
TAIL = """
derivation = Derivation("small", "A small derivation", "nobody", "nowhere", (s,))
"""
TRUE = r"""
t = s.display("t", r"x^2+v^2,\quad \dot x = v")
s.claim(FirstIntegral("energy", osc, "energy", printed=t[1]), Identity("speed", osc, "speed", printed=t[2]))
"""
WRONG = r"""
w = s.display("w", r"\dot x = -v")
s.claim(Identity("wrong", osc, "a misprint, 100%: yes", printed=w[1]))
"""


@pytest.fixture
def write(tmp_path):
    """Write a derivation and return its folder."""

    def write(body=TRUE, name="small"):
        folder = tmp_path / name
        folder.mkdir(exist_ok=True)
        (folder / "__init__.py").write_text(HEAD + body + TAIL, encoding="utf-8")
        return str(folder)

    return write


@pytest.fixture
def cli(capsys):
    """Run a command here; its exit code and what it printed."""

    def cli(*arguments):
        try:
            code = main([str(argument) for argument in arguments])
        except SystemExit as stopped:
            code = stopped.code
        out, err = capsys.readouterr()
        assert "Traceback" not in out + err
        return code, out, err

    return cli


@pytest.fixture
def decided(monkeypatch, run):
    """The first paper is decided once for all tests."""
    monkeypatch.setattr("kowalevski_cas.cli.session.run_together", lambda *_: [run])


def process(*arguments, **options):
    return subprocess.run(
        [sys.executable, "-m", "kowalevski_cas", *arguments],
        capture_output=True, text=True, cwd=ROOT, **options,
    )  # fmt: skip


# -- exit codes -------------------------------------------------------------------


def test_0_as_recorded(cli, write):
    folder = write(TRUE + WRONG)
    assert cli("record", folder)[0] == 0
    code, out, _ = cli("verify", folder)
    assert code == 0
    assert out.rstrip().endswith("as recorded")


def test_0_when_everything_is_proved_and_there_is_no_record(cli, write):
    code, out, _ = cli("verify", write())
    assert code == 0
    assert "2 claims: 2 proved" in out
    assert "there is no record to compare with (`kowalevski-cas record`)" in " ".join(out.split())


@pytest.mark.parametrize(
    ("before", "after"), sampled([(TRUE, TRUE + WRONG), (TRUE + WRONG, TRUE)], 1)
)
def test_1_claims_that_come_and_go_differ_from_the_record(cli, write, before, after):
    cli("record", write(before))
    code, out, _ = cli("verify", write(after))
    assert code == 1
    assert "DIFFERENT FROM THE RECORD" in out


def test_1_a_verdict_that_changes_in_either_direction(cli, write):
    right, wrong = WRONG.replace("-v", "v"), WRONG
    for before, after, words in (
        (right, wrong, "recorded proved, found refuted"),
        (wrong, right, "recorded refuted, found proved"),
    ):
        cli("record", write(before))
        code, out, _ = cli("verify", write(after))
        assert code == 1
        assert f"wrong: {words}" in out


def test_1_a_refuted_claim_without_a_record(cli, write):
    code, out, _ = cli("verify", write(WRONG))
    assert code == 1
    assert "\n✗   ẋ = −v\n✓   ẋ = v\n" in out


def test_2_wrong_usage(cli):
    assert cli()[0] == 2
    assert "exit codes:" in cli()[1]
    code, _, err = cli("demonstrate")
    assert code == 2 and "invalid choice: 'demonstrate'" in err
    code, _, err = cli("verify", "--arithmetic", "maple")
    assert code == 2 and "invalid choice: 'maple'" in err
    code, _, err = cli("verify", "--timeout", "-1")
    assert code == 2 and "a positive number of seconds is expected" in err
    assert cli("verify", "--timeout", "soon")[0] == 2


def test_2_no_such_derivation(cli, tmp_path):
    code, _, err = cli("verify", "euler1758")
    assert code == 2
    assert (
        err == "kowalevski-cas verify: there is no derivation “euler1758”; the library has: "
        f"{', '.join(available())}\n"
    )
    code, _, err = cli("verify", tmp_path)
    assert code == 2
    assert (
        err
        == f"kowalevski-cas verify: {tmp_path} is no derivation: a Python file is expected, or a folder with an __init__.py\n"
    )


def test_3_undecided(cli, write):
    relations = 's.claim(Dimension("d", osc, "", levels=(), equations=(e[1], e[2]), dimension=1))'
    code, out, _ = cli("verify", write(f's_ = None\ne = s.display("e", "x=v, 2x=2v")\n{relations}'))
    assert code == 3
    assert "One open statement" in out
    assert "would prove it is false, which does not refute it" in " ".join(out.split())


@pytest.mark.parametrize(("claim", "expected"), [("x=w", 2), ("x=x", 0)])
def test_a_report_of_what_cannot_be_read_is_no_success(cli, write, tmp_path, claim, expected):
    code, *_ = cli("report", write(f's.identity("e", "{claim}", on=osc, says="")'), "-o", tmp_path)
    assert code == expected
    assert [*tmp_path.glob("*.html")]


def test_3_timed_out(cli, write, monkeypatch):
    monkeypatch.undo()
    slow = "class Slow(Identity):\n    def search(self, *_):\n        import time\n        time.sleep(3)\n"
    code, out, _ = cli("verify", write(f'{slow}t = s.display("t", "x=x")\ns.claim(Slow("slow", osc, "", printed=t[1]))'), "--timeout", "0.05")  # fmt: skip
    assert code == 3
    assert "slow: Not decided within 0.05 s" in out


def test_4_the_arithmetics_disagree(cli, write, monkeypatch):
    judged = Arithmetics.judge

    def fickle(self, statement, verdicts, arithmetic):
        decided = judged(self, statement, verdicts, arithmetic)
        return decided._replace(verdict=Verdict.REFUTED) if arithmetic == "sympy" else decided

    monkeypatch.setattr(Arithmetics, "judge", fickle)
    folder = write()
    code, out, _ = cli("verify", folder, "--arithmetic", "all")
    assert code == 4
    assert "the arithmetics disagree (flint: proved, symengine: proved, sympy: refuted)" in out
    code, _, err = cli("record", folder)
    assert code == 4 and "the arithmetics disagree" in err
    assert not Path(folder, "record.json").exists()


def test_a_run_says_which_arithmetics_decided(cli, write):
    assert "2 proved; flint; " in cli("verify", write())[1]
    assert "2 proved; flint, symengine, sympy; " in cli("verify", write(), "--arithmetic", "all")[1]


def test_6_nothing_selected(cli):
    code, _, err = cli("verify", "--only", "eq10.55")
    assert code == 6
    assert err.startswith(
        f"kowalevski-cas verify: there is no claim “eq10.55” in {', '.join(available())}; "
        "did you mean eq10.5"
    )


def test_only_selects_the_derivations_that_have_the_claim(cli):
    code, out, err = cli("verify", "--only", "psi-free")
    assert (code, out) == (6, "") and "there is no claim “psi-free”" in err
    code, out, err = cli("verify", "--only", "resultant.a")
    assert (code, err) == (0, "") and out.count("claims:") + out.count("claim:") == 1


def test_6_a_derivation_without_claims(cli, write):
    assert cli("verify", write(""))[0] == 6


def test_only_some_claims_are_compared_with_the_record(cli, write):
    folder = write(TRUE + WRONG)
    cli("record", folder)
    code, out, _ = cli("verify", folder, "--only", "speed", "--only", "wrong")
    assert code == 0
    assert "2 claims: 1 proved, 1 refuted" in out and "energy" not in out


def test_help_and_version(cli):
    assert cli("--version")[:2] == (0, "kowalevski-cas 0.1.0\n")
    assert "4   the arithmetics disagree" in cli("verify", "--help")[1]


# -- formats ----------------------------------------------------------------------


@pytest.mark.slow
def test_json_has_the_documented_form(cli, derivation, decided):
    code, out, err = cli("verify", "kharlamov2002", "--format", "json")
    assert (code, err) == (0, "")
    data = json.loads(out)
    assert set(data) == {"format", "version", "claims", "summary"}
    for claim in data["claims"]:
        assert {"id", "section", "scene", "printed", "verdict", "conditions", "seconds", "counterexample", "correction"} <= set(claim)  # fmt: skip
        assert set(claim["seconds"]) == {"flint", "symengine", "sympy"}
        assert claim["verdict"] in set(Verdict)
        if claim["verdict"] == "refuted":
            assert set(claim["counterexample"]) == {"point", "left", "right", "words"}
    claims = {claim["id"]: claim for claim in data["claims"]}
    assert claims["eq12"]["conditions"] == ["x_1x_2"]
    assert claims["eq9.i"]["correction"]["printed"] == "i^2 = -1"
    assert claims["eq9.i"]["correction"]["verdict"] == "proved"
    assert claims["eq9.i"]["correction"]["accepted"] is True
    assert claims["eq14"]["correction"]["accepted"] is False
    assert claims["eq14"]["corrected"] == ["eq9.i"] and claims["eq6"]["corrected"] == []
    assert claims["eq6"]["counterexample"] is None and claims["eq6"]["correction"] is None
    assert data["summary"]["claims"] == len(claims) == len(derivation.claims)
    assert data["summary"]["differences"] == []
    assert data["summary"]["refuted"] == 10


def test_junit_is_xml_with_a_case_for_each_claim(cli, write):
    folder = write(TRUE)
    cli("record", folder)
    code, out, _ = cli("verify", write(TRUE + WRONG), "--format", "junit")
    assert code == 1
    suite = ElementTree.fromstring(out).find("testsuite")
    assert (suite.get("tests"), suite.get("failures"), suite.get("errors")) == ("3", "1", "0")
    cases = {case.get("name"): case for case in suite}
    assert cases["energy"].find("failure") is None
    assert (
        cases["wrong"].find("failure").get("message")
        == "recorded: not in the record; found: refuted"
    )


def test_junit_counts_errors(cli, write):
    code, out, _ = cli("verify", write('t = s.display("t", "x = (")\ns.claim(Identity("bad", osc, "", printed=t[1]))'), "--format", "junit")  # fmt: skip
    assert code == 2
    suite = ElementTree.fromstring(out).find("testsuite")
    assert suite.get("errors") == "1"
    assert "x = (" in suite.find("testcase/error").text


def test_junit_shows_that_a_claim_is_gone(cli, write):
    cli("record", write(TRUE + WRONG))
    code, out, _ = cli("verify", write(TRUE), "--format", "junit")
    assert code == 1
    assert ElementTree.fromstring(out).find("testsuite").get("failures") == "1"


def test_github_annotations(cli, write):
    folder = write(TRUE)
    cli("record", folder)
    code, out, _ = cli("verify", write(TRUE + WRONG), "--format", "github")
    error, notice = out.splitlines()
    assert code == 1
    assert error.startswith("::error file=") and error.endswith(
        "::recorded: not in the record; found: refuted"
    )
    assert (
        notice.startswith("::notice file=")
        and "misprint: \\dot x = -v%0Acorrect: \\dot{x} = v" in notice
    )
    place = dict(
        part.split("=", 1) for part in notice.split("::")[1].removeprefix("notice ").split(",")
    )
    assert place["title"] == "wrong"
    assert '"wrong"' in Path(place["file"]).read_text().splitlines()[int(place["line"]) - 1]


def test_the_answer_comes_first_and_each_slip_once(cli, derivation, decided, monkeypatch):
    monkeypatch.setenv("COLUMNS", "70")
    code, out, _ = cli("verify", "kharlamov2002")
    assert code == 0
    lead = " ".join(out.split("Four misprints")[0].split())
    assert "The main results stand." in lead
    assert "Nine are spoiled by four misprints, and one is false." in lead
    assert (
        lead.count(
            ": for w₃, which is not defined and may be anything, read ω₃ (1 − 3i ≠ −17 − 9i)"
        )
        == 1
    )
    assert out.count("✓   x₁′ = −x₁ω₃ + z₁w₁") == 1
    for words in ("Before (9): for 1 read −1.\n✗   i² = 1\n✓   i² = −1\n",
                  "\nThree missing hypotheses\n", f"\n{len(derivation.claims)} claims: "):  # fmt: skip
        assert words in out
    assert "\x1b" not in out and "1. Main equations" not in out
    assert max(map(len, out.splitlines()[:-1])) <= 70


@pytest.mark.slow
def test_claim_by_claim(cli, monkeypatch):
    only = ("--only", "eq9.i", "--only", "eq12")
    monkeypatch.setenv("COLUMNS", "60")
    _, narrow, _ = cli("verify", "kharlamov2002", "-v", *only)
    assert max(map(len, narrow.splitlines()[:-1])) <= 60
    monkeypatch.setenv("COLUMNS", "100")
    code, out, _ = cli("verify", "kharlamov2002", "-v", *only)
    assert code == 0
    for words in ("\n2. New solution with two invariant relations\n", "Counterexample. At α₁ = −2, ",
                  "  conditional; valid for x₁x₂ ≠ 0; with the"):  # fmt: skip
        assert words in out
    assert "the derivative" not in out  # steps are for the report


# -- bad input --------------------------------------------------------------------


def claim(tex):
    return f't = s.display("t", {tex})\ns.claim(Identity("bad", osc, "", printed=t[1]))'


@pytest.mark.parametrize(
    ("tex", "words"),
    sampled(
        [
            ('"x = ("', "x = ("),
            ('"y = x"', "y = x"),
            ('""', "statement 1 is asked for, there are 0"),
            ('"(" * 1000 + "x" + ")" * 1000 + " = x"', "t: "),
            ('"x+" * 500000 + "x = x"', "t: "),
            (r'"\x00\x01\udcff = x"', "t: "),
            ('"x = " + "1" * 5000', "digits"),
            ('"x = \\\\frac{1}{x-x}"', "vanishes identically"),
            ('"x"', "an equation is expected at t.1"),
            ('"x = \\\\sqrt{2}"', "no root of 2 is declared here"),
        ],
        2,
    ),
)
def test_a_formula_that_cannot_be_used_is_named(cli, write, tex, words):
    code, out, err = cli("verify", write(claim(tex)))
    assert code == 2
    assert words in out + err
    assert len(out) < 3000


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (b"", "states nothing: make a System(...), or define `derivation = Derivation(...)`"),
        (b"derivation = 7", "states nothing: make a System(...), or "),
        (b"x = (", "__init__.py:1: SyntaxError"),
        (b"\n\nimport nothing_of_this_name", "__init__.py:3: ModuleNotFoundError"),
        (bytes(range(128, 256)) * 9, "SyntaxError"),
        (b"\x00" * 100, "null bytes"),
    ],
)
def test_a_file_that_is_no_derivation(cli, tmp_path, text, words):
    (tmp_path / "__init__.py").write_bytes(text)
    code, out, err = cli("verify", tmp_path)
    assert (code, out) == (2, "")
    assert words in err


def test_a_record_that_cannot_be_read(cli, write):
    folder = write()
    Path(folder, "record.json").write_bytes(b"\x00\xff")
    code, _, err = cli("verify", folder)
    assert code == 2
    assert (
        f"{folder}/record.json: the record cannot be read" in err
        and "`make record` writes it anew" in err
    )


def test_a_certificate_that_cannot_be_read_is_found_again(cli, write):
    folder = write(TRUE + WRONG)
    cli("record", folder)
    for path in Path(folder, "certificates").rglob("*.json"):
        path.write_bytes(os.urandom(1000))
    assert cli("verify", folder)[0] == 0
    assert cli("check", folder)[0] == 5


@pytest.mark.parametrize("seconds", ["nan", "inf", "1e300"])
def test_seconds_are_a_finite_number(cli, write, seconds):
    assert cli("verify", write(), "--timeout", seconds)[0] == 2


@pytest.mark.parametrize(
    "body",
    [
        's.claim(Identity("bad", osc, ""))',
        "s.claim(7)",
        't = s.display("t", "x=v")\ns.claim(FirstIntegral("bad", osc, "", printed=t[1]))',
        't = s.display("t", "x")\ns.claim(Coefficient("bad", osc, "", variable="x", printed=t[1]))',
        claim('"x = 5^{100000}"'),
    ],
)
def test_a_claim_that_makes_no_sense_is_an_error(cli, write, body):
    assert cli("verify", write(body))[0] in (1, 2, 3)


# -- interrupts, pipes, imports -----------------------------------------------------


def test_an_interrupt_leaves_the_record_as_it_was(cli, write, monkeypatch):
    folder = write(TRUE)
    cli("record", folder)
    before = {path: path.read_bytes() for path in Path(folder).rglob("*.json")}
    write(TRUE + WRONG)

    def interrupted(*_, **__):
        raise KeyboardInterrupt

    for place in ("kowalevski_cas.cli.session.run_together", "os.replace", "os.chmod"):
        with monkeypatch.context() as patch:
            patch.setattr(place, interrupted)
            code, _, err = cli("record", folder)
        assert code == 130
        assert "interrupted: files written earlier are as they were" in err
        assert {path: path.read_bytes() for path in Path(folder).rglob("*.json")} == before
        assert not [path for path in Path(folder).rglob("*") if path.name.startswith("tmp")]


def test_an_interrupt_between_two_files_leaves_all(cli, write, monkeypatch):
    folder = write(TRUE)
    cli("record", folder)
    before = {path: path.read_bytes() for path in Path(folder).rglob("*.json")}
    write(TRUE + WRONG)
    replace, calls = os.replace, []

    def second(*arguments):
        calls.append(arguments)
        if len(calls) == 2:
            raise KeyboardInterrupt
        return replace(*arguments)

    monkeypatch.setattr("os.replace", second)
    assert cli("record", folder)[0] == 130
    assert {path: path.read_bytes() for path in Path(folder).rglob("*.json")} == before


def test_what_the_checker_rejects_is_not_recorded(cli, write, monkeypatch):
    check = checker.check

    def strict(text, *more):
        if json.loads(text)["claim"] == "energy":
            raise checker.Rejected("something is wrong with it")
        return check(text, *more)

    monkeypatch.setattr(checker, "check", strict)
    folder = write(TRUE + WRONG)
    code, _, err = cli("record", folder)
    assert code == 3
    assert err.startswith("energy is not recorded: error: ")
    assert err.endswith("the checker says: something is wrong with it\n")
    assert load_record(Path(folder)).keys() == {"speed", "wrong"}
    names = {path.name for path in Path(folder, "certificates").iterdir()}
    assert names == {"speed.json", "wrong.json", "corrected"}


def test_record_shows_what_changed(cli, write):
    cli("record", write(WRONG))
    code, out, _ = cli("record", write(WRONG.replace("-v", "v")))
    assert code == 0
    assert "wrong: refuted -> proved" in out
    assert "1 claim recorded" in out


@pytest.mark.slow
def test_a_reader_that_goes_away_is_no_error():
    command = f"{sys.executable} -m kowalevski_cas verify kharlamov2002 --only eq6 | head -0"
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True, cwd=ROOT)
    assert done.stderr == ""


@pytest.mark.slow
def test_proving_with_flint_imports_no_other_library():
    script = (
        "import sys; from kowalevski_cas.cli import main; code = main("
        "['verify', 'kharlamov2002', '--only', 'eq12']);"
        "found = {'sympy', 'symengine', 'numpy', 'matplotlib', 'rich', 'typst', 'difflib'}"
        " & set(sys.modules); print(code, sorted(found), file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, cwd=ROOT)
    assert done.stderr == "0 []\n"


def test_a_screening_refutes_and_proves_nothing(cli, write):
    code, out, _ = cli("verify", write(TRUE), "-v", "--arithmetic", "modular", "--seed", 7)
    assert code == 0 and "wrong with probability below" in out and "seed 7" in out
    assert " proved" not in out.replace("none is proved", "")
    code, out, _ = cli("verify", write(TRUE + WRONG), "--arithmetic", "modular")
    assert code == 1 and "1 refuted" in out and "✗   " in out


def test_a_screening_that_saw_nothing_is_no_success(cli):
    code, out, _ = cli("verify", "kharlamov2002", "--arithmetic", "modular", "--only", "equilibria")
    assert code == 3 and "cannot be seen at points" in " ".join(out.split())


def test_a_screening_writes_no_report(cli, write, tmp_path):
    code, _, err = cli("verify", write(TRUE), "--arithmetic", "ball", "--report", tmp_path)
    assert code == 2 and "ball proves nothing: choose flint" in err
    assert not [*tmp_path.glob("*.tex"), *tmp_path.glob("*.html")]


def test_a_screening_is_compared_with_the_record(cli):
    only = ("--only", "eq14", "--only", "eq12")
    code, out, _ = cli("verify", "kharlamov2002", "--arithmetic", "modular", *only)
    assert code == 0 and out.rstrip().endswith("as recorded")


def test_an_interrupt_while_modules_are_loaded_is_one(cli, monkeypatch):
    def interrupted(name):
        raise KeyboardInterrupt

    monkeypatch.setattr("kowalevski_cas.cli.import_module", interrupted)
    code, _, err = cli("verify")
    assert code == 130 and "interrupted" in err


def test_an_interrupt_that_falls_into_a_finalizer_comes_again():
    script = """
import sys, time
from kowalevski_cas import cli

class Finalized:
    def __del__(self):
        raise KeyboardInterrupt

class Command:
    __doc__ = ""
    add_arguments = staticmethod(lambda parser: None)
    def run(arguments):
        Finalized()
        time.sleep(20)

cli.import_module = lambda name: Command
sys.exit(cli.main(["verify"]))
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert done.returncode == 130 and "Traceback" not in done.stderr


@pytest.mark.slow
def test_a_full_disk_is_said():
    command = "verify kharlamov2002 --only eq6 > /dev/full"
    done = subprocess.run(
        f"{sys.executable} -m kowalevski_cas {command}",
        shell=True, capture_output=True, text=True, cwd=ROOT,
    )  # fmt: skip
    assert done.returncode == 2
    assert done.stderr.strip() == "kowalevski-cas verify: the output: No space left on device"


def test_nothing_can_be_written_below_a_file(cli, write, tmp_path):
    (tmp_path / "file").write_text("kept")
    code, _, err = cli("certificates", write(), "-o", tmp_path / "file" / "folder")
    assert code == 2 and "cannot be written" in err
    assert (tmp_path / "file").read_text() == "kept"
