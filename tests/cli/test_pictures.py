"""The command pictures."""

import json
from pathlib import Path

import pytest

from kowalevski_cas.cli import main
from kowalevski_cas.motion.pictures import PICTURES
from kowalevski_cas.report.figures import figures_of


@pytest.fixture(scope="module")
def reports(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of reports with the picture of the motion that is usual."""
    folder = tmp_path_factory.mktemp("reports")
    assert main(["pictures", "rectangle", "--output", str(folder / "motion")]) == 0
    return folder


@pytest.mark.slow
def test_it_writes_the_picture_and_the_list_for_the_report(reports: Path) -> None:
    written = {path.name for path in (reports / "motion").iterdir()}
    assert written == {"rectangle.png", "rectangle.svg", "figures.json"}
    listed = json.loads((reports / "motion/figures.json").read_text(encoding="utf-8"))[
        "derivations"
    ]
    told = {figure["name"]: figure["caption"] for entries in listed.values() for figure in entries}
    assert "Here $a=1.2$, $b=0.7$, $m=-1.2$, $\\ell=0.3$" in told["rectangle"]
    assert "Here $a=1.2$, $b=0.7$;" in told["atlas"]
    named = [figure["name"] for entries in listed.values() for figure in entries]
    assert named == list(PICTURES)
    shown = [figure.place for derivation in listed for figure in figures_of(reports, derivation)]
    assert shown == ["motion/rectangle"]


@pytest.mark.slow
def test_a_motion_may_be_given_and_looks_different(reports: Path, tmp_path: Path) -> None:
    given = "--a 1 --b 0.4 --m 0.8 --l 0.9".split()
    assert main(["pictures", "rectangle", *given, "--output", str(tmp_path)]) == 0
    usual, other = (folder / "rectangle.png" for folder in (reports / "motion", tmp_path))
    assert usual.read_bytes() != other.read_bytes()


@pytest.mark.parametrize(
    ("given", "code", "said"),
    [
        (["portrait"], 6, "hodographs, traces"),
        (["torus", "--a", "1"], 2, "--b, --m missing"),
        ("torus --a 1 --b 0.4 --m 1 --l 0".split(), 2, "negative"),
        ("subsystems --a 1 --b 0 --m 1 --l 2".split(), 2, "those of two fields"),
        ("torus --a 1.2 --b 0.7 --s 0.4 --tau=-0.5".split(), 2, "for motions on N⁴ alone"),
        (["torus", "--point", *"123456789"], 2, "torus is drawn for motions in closed form"),
    ],
)
def test_what_cannot_be_drawn_is_said(
    given: list[str], code: int, said: str, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    assert main(["pictures", *given, "--output", str(tmp_path)]) == code
    assert said in capsys.readouterr().err
    assert not list(tmp_path.glob("*.png"))


def test_a_folder_that_cannot_be_written_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    assert main(["pictures", "rectangle", "--output", str(tmp_path / "file")]) == 2
    assert "cannot be written" in capsys.readouterr().err
