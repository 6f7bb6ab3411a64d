"""The command animation."""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from kowalevski_cas.cli import main
from kowalevski_cas.motion.pictures import animation, page


@pytest.fixture(autouse=True)
def few_frames(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(animation, "FRAMES", 4)


def test_it_writes_a_gif_in_which_the_body_moves(tmp_path: Path) -> None:
    assert main(["animation", "--output", str(tmp_path / "new" / "body.gif")]) == 0
    with Image.open(tmp_path / "new" / "body.gif") as found:
        assert found.n_frames == 4
        frames = []
        for number in range(4):
            found.seek(number)
            frames.append(np.array(found.convert("L")))
    assert all(np.any(a != b) for a, b in pairwise(frames))
    assert [path.name for path in (tmp_path / "new").iterdir()] == ["body.gif"]


def test_constants_without_a_motion_are_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    given = "animation --a 1 --b 0.4 --m 1 --l 0 --output".split()
    assert main([*given, str(tmp_path / "body.gif")]) == 2
    assert "negative" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_a_file_that_cannot_be_written_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    assert main(["animation", "--output", str(tmp_path / "file" / "body.gif")]) == 2
    assert "cannot be written" in capsys.readouterr().err


def test_an_animation_is_a_gif_or_a_page(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for wrong in (tmp_path, tmp_path / "body.mp4"):
        assert main(["animation", "--output", str(wrong)]) == 2
        assert f"--output {wrong} does not end with .gif or .html" in capsys.readouterr().err


@pytest.mark.slow
def test_any_motion_is_shown_but_for_parallel_fields(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    point = "animation --point 0.1 0.2 0.3 1 0 0 0.2 0.4 0.1 --output".split()
    assert main([*point, str(tmp_path / "body.gif")]) == 0
    with Image.open(tmp_path / "body.gif") as found:
        assert found.n_frames == 4
    parallel = "animation --point 0.1 0.2 0.3 1 0 0 2 0 0 --output".split()
    assert main([*parallel, str(tmp_path / "none.gif")]) == 2
    assert "parallel" in capsys.readouterr().err
    assert main([*point, str(tmp_path / "body.html")]) == 2


def test_in_a_far_unit_of_time_the_page_is_that_of_a_near_one(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(page, "ACROSS", 2)
    given = "animation --a 1e60 --b 4e59 --m 8e-61 --l 0.9 --output".split()
    assert main([*given, str(tmp_path / "body.html")]) == 0
    assert (
        "drawn in a unit of time 2^-99 times as long, in which a = 2.489" in capsys.readouterr().err
    )
    assert '"a": 2.489' in (tmp_path / "body.html").read_text(encoding="utf-8")
    single = "animation --a 1 --b 0 --m 1 --l 2 --output".split()
    assert main([*single, str(tmp_path / "none.html")]) == 2
    assert "parallel" in capsys.readouterr().err
