import pytest
from hypothesis import given
from hypothesis import strategies as st

from kowalevski_cas.source.files import read_source
from kowalevski_cas.source.text import Region

LINES = st.lists(st.text("ab \n", max_size=6), min_size=1, max_size=4)


def at(text: str, region: Region) -> str:
    """What stands in a region of a file's text, by its lines and columns."""
    lines = text.split("\n")
    before = [
        len("\n".join(lines[: line - 1])) + (line > 1) for line in (region.line, region.end_line)
    ]
    first, last = (
        b + c - 1 for b, c in zip(before, (region.column, region.end_column), strict=True)
    )
    return text[first:last]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("paper")


@given(LINES, LINES, st.data())
def test_a_region_says_where_in_its_file_a_text_stands(folder, outer, inner, data):
    """Also behind what another file prints, on the same line."""
    (folder / "inner.tex").write_text(f"x{'x'.join(inner)}")
    (folder / "paper.tex").write_text(r"\input{inner}".join(["x", *outer]))
    source = read_source(folder / "paper.tex")
    part = data.draw(st.sampled_from([one for one in source.parts if one.end > one.start]))
    start = data.draw(st.integers(part.start, part.end - 1))
    end = data.draw(st.integers(start, part.end))
    region = source.region(start, end)
    assert region.path == part.path == source.part(start).path
    assert at(source.files[region.path], region) == source.text[start:end]
    assert (region.line, region.column) == (source.line(start), source.column(start))


def test_a_region_ends_with_its_file(tmp_path):
    (tmp_path / "inner.tex").write_text("b\n")
    (tmp_path / "paper.tex").write_text("a \\input{inner} c\n")
    source = read_source(tmp_path / "paper.tex")
    inner = source.text.index("b")
    assert source.region(inner, len(source.text))[1:] == (1, 1, 2, 1)
