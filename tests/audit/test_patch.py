"""Patches mend the author's own lines, and nothing else."""

import shutil
import subprocess

import pytest

from kowalevski_cas.audit.audit import audit
from kowalevski_cas.audit.patch import patch, repair_source
from kowalevski_cas.source.text import Source
from tests.audit.material import audited, audited_again, base, changed, patched, source, watched


def wrong(text: str) -> list[str]:
    found = audit(Source("paper.tex", text), base())
    return [formula.id for formula in found.formulas if formula.wrong]


@pytest.mark.slow
def test_nothing_is_wrong_after_the_patch():
    assert [formula.id for formula in audited_again().formulas if formula.wrong] == []


def test_a_patch_changes_as_little_as_it_can():
    before = source().text.split("\n")
    after = patched().split("\n")
    assert len(before) == len(after)
    lines = [(a, b) for a, b in zip(before, after, strict=True) if a != b]
    assert len(lines) <= 8
    assert any(r"- x_1 \omega_3  + z_1 w_1" in b for _, b in lines)
    assert any("i^2=-1" in b for _, b in lines)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("old", "new"),
    [
        (r"J_2  = 2\omega _1", r"J_3  = 2\omega _1"),
        (r"2\omega'_3 = y_2  - y_1", r"2\omega'_3 = y_2  + y_1"),
        (r"2w'_2  = w_2 w_3  + z_2", r"2w'_2  = w_2 w_3  + z_1"),
        (r"J_1  = 0,", r"J_1  = 1,"),
    ],
)
@watched
def test_what_was_changed_is_mended(old, new):
    assert wrong(repair_source(changed(old, new)).text) == []


@pytest.mark.slow
def test_the_diff_applies(tmp_path):
    program = shutil.which("patch")
    if program is None:
        pytest.skip("there is no program called patch")
    path = tmp_path / "paper.tex"
    path.write_bytes(source().text.encode(source().encoding))
    diff = patch(audited()).encode(source().encoding)
    subprocess.run([program, str(path)], input=diff, check=True, capture_output=True)
    assert path.read_bytes().decode(source().encoding) == patched()


def test_no_misprint_no_patch():
    assert patch(audited_again()) == ""


@pytest.mark.slow
def test_line_ends_of_another_system_stay():
    text = source().text.replace("\n", "\r\n")
    found = repair_source(audit(Source("paper.tex", text), base())).text
    assert found.count("\n") == found.count("\r\n")
    assert found.replace("\r\n", "\n") == patched()
