"""The audit command: formats, exit codes, and input that means no good."""

import json
import random

import pytest

from kowalevski_cas.cli import main
from tests.audit.material import base, patched, source
from tests.sample import sampled

NAMED = ("--derivation", "kharlamov2002")


@pytest.fixture(autouse=True)
def decided(monkeypatch):
    """The derivation is decided once for all tests."""
    base().outcomes  # noqa: B018
    monkeypatch.setattr("kowalevski_cas.cli.audit.audit_run", lambda *_: base())


@pytest.fixture
def paper(tmp_path):
    path = tmp_path / "paper.tex"
    path.write_text(source().text, encoding="utf-8")
    return path


@pytest.fixture
def write(tmp_path):
    def write(text: str | bytes):
        path = tmp_path / "other.tex"
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return str(path)

    return write


@pytest.mark.slow
def test_pretty(paper, capsys):
    assert main(["audit", str(paper)]) == 1
    out = " ".join(capsys.readouterr().out.split())
    assert "(14): refuted; move √(x₁x₂) from the denominator to the numerator." in out
    assert (
        "formulas 1–4, 7 and 8 of (10): refuted; for w₃, which is not defined and may be "
        "anything, read ω₃."
    ) in out
    assert "after (22): refuted: " in out and "Three missing hypotheses" in out
    assert "9 refuted" in out and "Statements in words" not in out
    assert "68 claims: 27 conditional, 31 proved, 10 refuted" in out


@pytest.mark.slow
def test_formula_by_formula(paper, capsys):
    assert main(["audit", "-v", str(paper), *NAMED]) == 1
    out = capsys.readouterr().out
    assert "Statements in words" in out and "\n·     " in out
    assert " definition: 𝐈 = diag(A₁, A₂, A₃)\n" in out


@pytest.mark.slow
def test_json(paper, capsys):
    assert main(["audit", str(paper), "--format", "json", *NAMED]) == 1
    value = json.loads(capsys.readouterr().out)
    keys = {"id", "label", "line", "role", "tex", "verdict", "counterexample", "correction"}
    assert all(keys <= formula.keys() for formula in value["formulas"])
    eq14 = next(f for f in value["formulas"] if f["id"] == "eq14")
    assert eq14["label"] == "eq14"
    assert eq14["correction"]["verdict"] == "conditional"
    assert value["summary"]["derivation"] == "kharlamov2002"
    assert value["summary"]["wrong"] == 10
    assert value["summary"]["claims"] == {"proved": 31, "conditional": 27, "refuted": 10}


@pytest.mark.slow
def test_sarif(paper, capsys):
    main(["audit", str(paper), "--format", "sarif", *NAMED])
    value = json.loads(capsys.readouterr().out)
    results = value["runs"][0]["results"]
    assert value["version"] == "2.1.0"
    assert sum(result["ruleId"] == "refuted" for result in results) == 10
    rules = {rule["id"] for rule in value["runs"][0]["tool"]["driver"]["rules"]}
    assert {result["ruleId"] for result in results} <= rules


@pytest.mark.slow
def test_github(paper, capsys):
    main(["audit", str(paper), "--format", "github", *NAMED])
    lines = capsys.readouterr().out.splitlines()
    assert sum(line.startswith("::error file=") for line in lines) == 10


@pytest.mark.slow
def test_patch(paper, capfdbinary):
    assert main(["audit", str(paper), "--patch", *NAMED]) == 1
    out = capfdbinary.readouterr().out.decode()
    assert out.startswith("--- a/")
    assert "+variables, introduce" in out or "i^2=-1" in out


@pytest.mark.slow
def test_nothing_but_words_is_wrong_after_the_patch(tmp_path, capsys):
    path = tmp_path / "mended.tex"
    path.write_text(patched(), encoding="utf-8")
    main(["audit", str(path), "--format", "json", *NAMED])
    value = json.loads(capsys.readouterr().out)
    assert value["summary"]["wrong"] == 1  # the sentence of the critical set
    assert not any(formula["verdict"] == "refuted" for formula in value["formulas"])


def test_any_article_can_be_listed(write, capsys):
    path = write(
        "\\newcommand{\\R}{\\mathbf R}\n"
        "Let $f(x)=x^2$ on $\\R$.\n"
        "\\begin{align}a&=b,\\label{one}\\\\ \\int_0^1 x\\,dx&=\\frac12\\label{two}\\end{align}\n"
    )
    assert main(["audit", "--list", path]) == 0
    out = capsys.readouterr().out
    assert "4 formulas" in out
    assert "one" in out
    assert "\\int" in out
    assert main(["audit", "--list", path, "--format", "json"]) == 0
    value = json.loads(capsys.readouterr().out)
    assert [f["label"] for f in value["formulas"]] == ["", "", "one", "two"]


def test_an_article_that_no_derivation_fits(write, capsys):
    assert main(["audit", write("$$ E = mc^2 $$")]) == 6
    assert "no equations of motion are found" in capsys.readouterr().out


def test_an_unknown_derivation(paper, capsys):
    assert main(["audit", str(paper), "--derivation", "nobody1900"]) == 2
    assert "the library has: bobenko_reyman_semenov1989, " in capsys.readouterr().err


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "is empty"),
        (random.Random(1).randbytes(100_000), "not a text file"),
        ("\x00\x01\x02" * 100, "not a text file"),
    ],
)
def test_noise(write, capsys, content, words):
    assert main(["audit", write(content)]) == 2
    assert words in capsys.readouterr().err


def test_a_large_file(tmp_path, capsys):
    path = tmp_path / "large.tex"
    with path.open("wb") as file:
        file.truncate(100_000_000)
    assert main(["audit", str(path)]) == 2
    assert "is not read" in capsys.readouterr().err


def test_other_files_are_not_read(tmp_path, capsys):
    secret = tmp_path / "secret.tex"
    secret.write_text("$$ secret = 1 $$", encoding="utf-8")
    path = tmp_path / "paper.tex"
    path.write_text(
        f"\\input{{{secret}}} \\include{{/etc/passwd}} \\input /etc/passwd $x=1$", encoding="utf-8"
    )
    assert main(["audit", "--list", str(path)]) == 0
    out = capsys.readouterr().out
    assert "secret = 1" not in out
    assert "root:" not in out
    assert "1 formulas" in out
    assert "/etc/passwd is not read: it does not lead into the paper's folder" in out


@pytest.mark.parametrize(
    "text",
    sampled(
        [
            "{" * 10_000 + "$x$",
            "$" + "{" * 10_000 + "$",
            "$$" + "(" * 10_000 + ")" * 10_000 + "$$",
            "\\newcommand{\\a}{\\a\\a} $$ \\a = 1 $$",
            "\\def\\a#1{\\a{#1#1}} $$ \\a{x} = 1 $$",
            "$$ " + "x^{" * 200 + "2" + "}" * 200 + " $$",
            "\\begin{equation} x = 1",
            "$$ x_{1 $$ $y$",
            "\\begin{align}" + "\\begin{array}{c}" * 1000 + "\\end{align}",
            "$" * 9999,
            "\\[" * 5000,
            "\\" * 9999,
            "%" * 9999,
        ],
        1,
    ),
)
def test_unbalanced_input(write, capsys, text):
    assert main(["audit", "--list", write(text)]) in (0, 2, 6)
    assert main(["audit", write(text), *NAMED]) in (1, 2, 6)
    assert "Traceback" not in capsys.readouterr().err


HOSTILE = (
    r"((\omega_1+1)^{50})^{50}", "9" * 901, "(" * 200 + "1" + ")" * 200, r"\frac{1}{0}", "J_2^{J_2}",
    r"{\bs\alpha}", r"\dot{\dot{\dot{J_1}}}",
)  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("value", sampled(HOSTILE, 1))
def test_a_hostile_change_of_the_paper(write, capsys, value):
    path = write(source().text.replace(r"J_1  = \omega _1^2", f"J_1  = {value}", 1))
    assert main(["audit", path, *NAMED]) in (1, 2)
    assert "Traceback" not in capsys.readouterr().err


@pytest.mark.slow
def test_too_many_formulas(write, capsys):
    assert main(["audit", "--list", write("$x$ " * 20_001)]) == 2
    assert "more than 20,000 formulas" in capsys.readouterr().err
