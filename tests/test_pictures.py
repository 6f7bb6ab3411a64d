from __future__ import annotations

import re
import sys
from itertools import combinations
from xml.etree import ElementTree

import pytest
from PIL import Image

from kowalevski_cas import pictures


def figure():
    with pictures.style():
        figure = pictures.new_figure(3, 2)
        axes = figure.subplots()
        for index in range(3):
            one = pictures.mark(index)
            axes.plot([0, 1], [index, 1], **one.line, label="x")
        axes.legend()
    return figure


@pytest.mark.slow
def test_the_same_figure_gives_the_same_bytes(tmp_path):
    first = pictures.save(figure(), tmp_path / "a", "x")
    second = pictures.save(figure(), tmp_path / "b", "x")
    assert first.name == "x.png"
    assert first.read_bytes() == second.read_bytes()


def test_a_page_can_carry_a_file(tmp_path):
    with Image.open(pictures.save(figure(), tmp_path, "x")) as image:
        assert image.mode == "P" and len(image.getcolors()) <= pictures.COLOURS


def test_files_carry_no_date_and_no_version(tmp_path):
    data = pictures.save(figure(), tmp_path, "x").read_bytes()
    assert not re.search(rb"tEXt|tIME|Matplotlib", data)


@pytest.mark.slow
def test_a_drawing_takes_the_ink_of_the_page_and_is_alone_in_it(tmp_path):
    first, second = (pictures.save_drawing(figure(), tmp_path, name) for name in ("x", "y"))
    drawn = first.read_text()
    root = ElementTree.fromstring(drawn)
    assert root.tag.endswith("svg") and root.get("fill") == "currentColor"
    assert pictures.INK not in drawn and "#ffffff" not in drawn and "Matplotlib" not in drawn
    assert "prefers-color-scheme: dark" in drawn and "svg:root" in drawn  # no page has this root
    own, others = (set(re.findall(r'\bid="([^"]*)"', p.read_text())) for p in (first, second))
    assert own and not own & others
    assert {*re.findall(r'(?:href="|url\()#([^")]*)', drawn)} <= own
    data = first.read_bytes()
    assert data == pictures.save_drawing(figure(), tmp_path, "x").read_bytes()


def test_a_drawing_that_is_heavy_is_none(tmp_path, monkeypatch):
    assert pictures.save_drawing(figure(), tmp_path, "x").is_file()
    monkeypatch.setattr(pictures, "LIGHT", 100)
    assert pictures.save_drawing(figure(), tmp_path, "x") is None
    assert not (tmp_path / "x.svg").exists()


def test_what_has_greys_is_no_drawing_for_the_dark(tmp_path):
    with pictures.style():
        shaded = pictures.new_figure(2, 1)
        shaded.subplots().axhspan(0, 1, color="#d9d9d9")
    assert pictures.save_drawing(shaded, tmp_path, "x") is None


def test_marks_differ_in_grey_and_without_colour():
    def grey(colour: str) -> float:
        red, green, blue = (int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5))
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue

    for one, other in combinations(pictures.MARKS, 2):
        assert one.marker != other.marker and one.dashes != other.dashes
        assert one.colour != other.colour
    assert all(grey(one.colour) < 0.75 for one in pictures.MARKS)  # dark enough for paper


@pytest.mark.slow
def test_the_users_own_settings_do_not_show_through(tmp_path):
    import matplotlib

    plain = pictures.save(figure(), tmp_path / "a", "x")
    with matplotlib.rc_context({"font.size": 30, "axes.facecolor": "red"}):
        other = pictures.save(figure(), tmp_path / "b", "x")
    assert plain.read_bytes() == other.read_bytes()


def test_the_style_loads_no_library_of_pictures_before_it_is_used():
    import subprocess

    code = "import sys, kowalevski_cas.pictures; sys.exit('matplotlib' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code]).returncode == 0
