"""What is printed: no control characters of a paper, and streams that are closed."""

import io
import re
import subprocess
import sys
from contextlib import redirect_stdout

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.cli.terminal import Output, output, width, with_style
from tests.sample import sampled

STYLE = re.compile(r"\x1b\[\d+m")

CIRCLE = r"""
from kowalevski_cas import System
circle = System(r"\dot x=y, \dot y=-x", name="circle")
circle.integral("x^2+y^2")
"""


class Terminal(io.StringIO):
    def isatty(self):
        return True


@given(st.lists(st.tuples(st.text(), st.sampled_from([None, 1, 31, 36]))))
def test_only_styles_of_our_own_control_a_terminal(parts):
    screen = Terminal()
    with redirect_stdout(Output(screen)):
        for words, style in parts:
            print(words if style is None else with_style(words, style))
    seen = STYLE.sub("", screen.getvalue())
    assert not re.search(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]", seen)
    assert sum(map(len, STYLE.findall(screen.getvalue()))) <= len(screen.getvalue()) - len(seen)


def test_styles_have_no_width_and_are_shown_on_terminals_only():
    assert with_style("proved", 32) == "proved"
    with redirect_stdout(Output(Terminal())):
        assert width(with_style("proved", 32)) == len("proved") < len(with_style("proved", 32))


@pytest.mark.parametrize(
    "words", ["a\x1b[31mred", "a\x1b]0;title\x07", "a\rb", "a\x9b2J", "a\u202eb"]
)
def test_messages_of_any_source_are_printable(words, capsys):
    with output():
        print(words)
    assert "?" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("closed", "code", "said"),
    sampled(
        [(">&-", 2, "the output is closed"), ("2>&-", 0, "1 proved"), ("<&-", 0, "1 proved")], 1
    ),
)
def test_a_stream_may_be_closed(closed, code, said, tmp_path):
    (tmp_path / "circle.py").write_text(CIRCLE)
    words = f'exec "{sys.executable}" -m kowalevski_cas verify "{tmp_path}/circle.py" {closed}'
    found = subprocess.run(["sh", "-c", words], capture_output=True, text=True, check=False)
    assert found.returncode == code
    assert said in found.stdout + found.stderr and "Traceback" not in found.stderr
