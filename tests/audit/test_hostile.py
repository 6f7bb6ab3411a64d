"""A source that is made to harm reaches neither the terminal nor a page with what it carries."""

import random
import re
import unicodedata

import pytest

from kowalevski_cas.cli import main
from kowalevski_cas.cli.formats import OF_AUDITS
from tests.sample import sampled

PAPER = r"""\documentclass{article}\begin{document}
A The point moves by \begin{equation}\label{law} \dot x=y,\quad \dot y=-x. \end{equation}
B Then $x^2+y^2$ is an integral.\footnote{C} There is no other integral D.
\section{E} \[ \dot x+\dot y=y-x F\] G
\end{document}
"""

HARM = [
    r"\href{javascript:alert(1)}{x}",
    r"\url{javascript:alert(1)}",
    r"\href{data:text/html,<script>alert(1)</script>}{y}",
    "<script>alert(1)</script>",
    "<img src=x onerror=alert(1)>",
    "\x1b[31mred\x1b[0m",
    "\x1b]8;;http://evil.example\x07link\x1b]8;;\x07",
    "\x9b31m",
    "\u202egnp.exe",
    "\u2066hidden\u2069",
    "\x00\x07\x08",
    r"\label{<b>}",
    r"\def\x#1{\x{#1#1}}\x{y}",
    r"\def\a{\a\a}\a",
    r"\input{/etc/passwd}",
    r"\input{|id}",
    r"\immediate\write18{id}",
    r"\catcode`\%=12 % \special{ps:}",
    r"\csname input\endcsname{../paper}",
    r"\begin{verbatim}$x$",
    r"\iffalse",
    "{" * 300,
    "$" * 301,
    r"\end{document}",
    r"^^5c^^1b",
    "%kc:",
    "&<>\"'",
    r"\(\[\]\)",
]


def hostile(seed: int) -> str:
    """The paper with some harm in some of its places."""
    chance = random.Random(seed)
    text = PAPER
    for mark in "ABCDEFG":
        harm = " ".join(chance.sample(HARM, chance.choice([0, 1, 2])))
        text = re.sub(rf"(?<![A-Za-z\\]){mark}(?![A-Za-z])", lambda _, h=harm: h, text, count=1)
    return text


def harmless(text: str) -> None:
    signs = {
        s for s in text if unicodedata.category(s) in ("Cc", "Cf") and s not in "\n\t\u2061\u2062"
    }
    assert not signs, signs


@pytest.mark.parametrize("seed", sampled(range(60), 2))
def test_what_a_hostile_source_carries_reaches_nobody(seed, tmp_path, capfd):
    path = tmp_path / "paper.tex"
    path.write_text(hostile(seed), encoding="utf-8")
    formats = [["--alone", "--format", name] for name in OF_AUDITS]
    commands = [["--list"], *formats, ["--alone", "--draft"]]
    commands += [["--alone", "--report", str(tmp_path / "page")]]
    for options in commands:
        try:
            assert main(["audit", *options, "--timeout", "2", str(path)]) in range(7)
        except SystemExit as ended:
            assert ended.code in range(7)
        out, err = capfd.readouterr()
        harmless(out + err)
        assert "Traceback" not in err
        assert "root:" not in out
    for page in (tmp_path / "page").glob("*.html"):
        text = page.read_text(encoding="utf-8")
        harmless(text)
        assert "javascript:" not in text.replace("&#", "")
        assert not re.search(r"<script>alert|<img src=x|<[^>]*onerror=", text)


@pytest.mark.parametrize("harm", HARM)
def test_a_formula_beside_harm_is_read_or_says_why_not(harm, tmp_path, capfd):
    path = tmp_path / "paper.tex"
    path.write_text(f"{harm}\n$$x=1$$\n", encoding="utf-8")
    main(["audit", "--list", str(path)])
    out, err = capfd.readouterr()
    harmless(out + err)
