import json
import shutil

import pytest

from kowalevski_cas.library import find
from kowalevski_cas.verify.committed import certificate_files

KEPT = ("eq6", "eq7", "eq21")


@pytest.fixture
def small(tmp_path):
    """The derivation with a few certificates: an identity, a combination, a misprint."""
    folder = tmp_path / "small"
    shutil.copytree(find("kharlamov2002"), folder)
    record = json.loads((folder / "record.json").read_text(encoding="utf-8"))
    record["claims"] = {claim: record["claims"][claim] for claim in KEPT}
    (folder / "record.json").write_text(json.dumps(record), encoding="utf-8")
    for path in certificate_files(folder):
        if path.stem not in KEPT:
            path.unlink()
    return folder


@pytest.fixture
def program(tmp_path, monkeypatch):
    """Put a program of this name on the path, alone: a shell script."""

    def program(name, script):
        place = tmp_path / "bin"
        place.mkdir(exist_ok=True)
        (place / name).write_text(f"#!/bin/sh\n{script}\n")
        (place / name).chmod(0o755)
        monkeypatch.setenv("PATH", str(place))

    return program
