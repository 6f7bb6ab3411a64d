"""A bundle proves its verdicts without the program that wrote it."""

import json
import shutil
import subprocess
import sys
from hashlib import sha256

import pytest

from kowalevski_cas.cli import main
from kowalevski_cas.library import find


@pytest.fixture(scope="module")
def bundle(tmp_path_factory):
    """The bundle of a derivation with a few claims."""
    folder = tmp_path_factory.mktemp("bundle")
    assert main(["bundle", "bobenko_reyman_semenov1989", "-o", str(folder)]) == 0
    return folder / "bobenko_reyman_semenov1989"


def contents(folder):
    """The files below a folder by name."""
    files = (path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}


def checked(folder):
    """The command of its README, in an isolated Python."""
    certificates = sorted(str(path) for path in (folder / "certificates").rglob("*.json"))
    return subprocess.run(
        [sys.executable, "-I", "-S", "-B", "checker", *certificates],
        cwd=folder, capture_output=True, text=True, check=False,
    )  # fmt: skip


@pytest.mark.slow
def test_its_checker_accepts_it_alone(bundle):
    done = checked(bundle)
    assert done.returncode == 0 and done.stdout.endswith("CERTIFIED 4 of 4\n")
    assert "The last line has to be `CERTIFIED 4 of 4`" in (bundle / "README.md").read_text()


def test_evidence_that_was_changed_is_rejected(bundle, tmp_path):
    folder = tmp_path / "copy"
    shutil.copytree(bundle, folder)
    path = next((folder / "certificates").glob("*.json"))
    path.write_text(path.read_text().replace("1", "2", 1))
    assert checked(folder).returncode == 5


def test_every_file_has_its_digest(bundle):
    files = contents(bundle)
    sums = files.pop("SHA256SUMS").decode()
    assert sums == "".join(f"{sha256(files[n]).hexdigest()}  {n}\n" for n in sorted(files))


def test_a_verdict_is_cited_by_the_digest_of_its_statement(bundle):
    facts = json.loads((bundle / "bobenko_reyman_semenov1989.json").read_text())
    citation = next(x for x in (bundle / "README.md").read_text().splitlines() if x[:1] == ">")
    claim = citation.split()[2]
    assert facts["claims"][claim]["statement"] in citation
    assert json.loads((bundle / f"certificates/{claim}.json").read_text())["digest"] in citation


@pytest.mark.slow
def test_the_bytes_are_the_same_again_and_nothing_is_mixed(bundle, tmp_path, capsys):
    arguments = ["bundle", str(find("bobenko_reyman_semenov1989")), "-o", str(tmp_path)]
    assert main(arguments) == 0
    assert contents(tmp_path / bundle.name) == contents(bundle)
    assert main(arguments) == 2
    assert "is not empty" in capsys.readouterr().err


def test_without_certificates_there_is_none(tmp_path, capsys):
    file = tmp_path / "circle.py"
    file.write_text(
        'from kowalevski_cas import System\nSystem("x\'=y, y\'=-x").integral("x^2+y^2")\n'
    )
    assert main(["bundle", str(file), "-o", str(tmp_path / "deposit")]) == 6
    assert "circle has no certificates" in capsys.readouterr().err
    assert not (tmp_path / "deposit").exists()
