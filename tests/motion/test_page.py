"""The motion to touch, in a browser: the body moves as the closed form says."""

import base64
import json
import re
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from kowalevski_cas.cli import main
from kowalevski_cas.motion import Inadmissible, Motion, load
from kowalevski_cas.motion.pictures import page as module
from tests.report.browser import PROGRAM, Browser

MOTION = Motion.of("1.2", "0.7", "-1.2", ell="0.3")

in_a_browser = [
    pytest.mark.slow, pytest.mark.skipif(PROGRAM is None, reason="there is no Chromium"),
]  # fmt: skip


@pytest.fixture(scope="module")
def text():
    return module.page(MOTION)


@pytest.fixture(scope="module")
def data(text):
    return json.loads(re.search(r"const data = (\{.*\});", text)[1])


@pytest.mark.slow
def test_the_page_is_whole_in_itself_and_has_motions_of_each_type(text, data):
    assert not re.search(r"(src|href)=|https?://|/\*DATA", text)
    assert {one["type"] for one in data["motions"]} >= {"elliptic", "hyperbolic"}
    shown = data["motions"][data["start"]]
    assert (shown["m"], shown["ell"]) == (-1.2, 0.3)


def test_its_quaternions_bring_the_fields_to_rest(data):
    shown = data["motions"][data["start"]]
    quaternions = np.frombuffer(base64.b64decode(shown["q"]), "<i2").reshape(-1, 4)
    states = load("closed")(MOTION, data["step"] * np.arange(data["count"]))
    turned = Rotation.from_quat(quaternions, scalar_first=True).apply(states[:, 3:6])
    np.testing.assert_allclose(turned - [1.2, 0, 0], 0, atol=2e-4)


def test_a_single_field_has_no_page():
    with pytest.raises(Inadmissible, match="parallel"):
        module.page(Motion.of(1, 0, "0.8", ell="1.2"))


@pytest.mark.parametrize("pixels", [390, 1280])
@pytest.mark.parametrize("mark", [pytest.param(None, marks=in_a_browser)], ids=["chromium"])
def test_the_time_moves_the_body_and_a_touch_chooses_another_motion(
    text, tmp_path: Path, pixels, mark
):
    (tmp_path / "body.html").write_text(text, encoding="utf-8")
    with Browser(tmp_path / "user") as browser:
        browser.width(pixels)
        browser.show(tmp_path / "body.html")
        picture = "document.getElementById('body').toDataURL()"
        first = browser.value(picture)
        assert browser.value("document.documentElement.scrollWidth <= innerWidth")
        browser.value("$('time').value = 3; $('time').dispatchEvent(new Event('input'))")
        assert browser.value("$('clock').textContent") == "3.00"
        assert browser.value(picture) != first
        words = browser.value("$('words').textContent")
        browser.value(
            """(box => $('diagram').dispatchEvent(new MouseEvent('pointermove', {buttons: 1,
            clientX: box.left + .75 * box.width, clientY: box.top + .4 * box.height})))(
            $('diagram').getBoundingClientRect())"""
        )
        assert browser.value("$('words').textContent") != words
        wanted = Rotation.from_quat([1, 2, 3, 4], scalar_first=True).apply([5, 6, 7])
        found = browser.value("turn([1, 2, 3, 4].map(x => x / Math.sqrt(30)), [5, 6, 7])")
        np.testing.assert_allclose(found, wanted, rtol=1e-12)
        browser.value("$('play').click()")
        assert browser.value("$('play').textContent") == "Pause"


@pytest.mark.slow
def test_the_command_writes_it(tmp_path, capsys):
    assert main(["animation", "--output", str(tmp_path / "body.html")]) == 0
    assert (tmp_path / "body.html").stat().st_size < 1e6
    on_O4 = "animation --a 1.2 --b 0.7 --s 0.4 --tau=-0.5 --output".split()
    assert main([*on_O4, str(tmp_path / "other.html")]) == 2
    assert "on N⁴" in capsys.readouterr().err
