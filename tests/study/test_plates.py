from __future__ import annotations

from kowalevski_cas.report.plates import plates
from study.plates import PLATES, write_plates


def test_a_report_shows_the_charts_that_are_there(tmp_path):
    folder = tmp_path / "study"
    folder.mkdir()
    write_plates(folder)
    assert plates(tmp_path, "kharlamov2002") == ()
    (folder / "growth.png").touch()
    write_plates(folder)
    (plate,) = plates(tmp_path, "kharlamov2002")
    assert plate.place == "study/growth" and plate.caption == PLATES["growth"]
