"""The picture of which claim rests on which."""

from collections.abc import Iterable
from xml.etree import ElementTree

from kowalevski_cas.report.graph import WIDTH, Drawing, picture
from kowalevski_cas.report.graph.svg import svg
from kowalevski_cas.verify.outcome import Outcome, Verdict
from tests.report.fixtures import P, R, claim, outcomes


def drawn_of(claims: Iterable[Outcome], **labels: str) -> Drawing:
    """A picture in which each claim has its name for a label."""
    found = tuple(claims)
    return picture(found, {one.claim: labels.get(one.claim, one.claim) for one in found})


def chain(*pairs: tuple[str, tuple[str, ...]]) -> list[Outcome]:
    return [claim(name, "1", "x=x", "", P, rests_on=below) for name, below in pairs]


def test_every_claim_is_in_a_box_or_named_as_alone() -> None:
    rows = {one.claim: "(10)" for one in outcomes() if one.claim.startswith("eq10.")}
    drawn = drawn_of(outcomes(), **rows)
    assert [box.name for box in drawn.boxes if box.label == "(10)"] == ["eq10.1"]
    assert "eq16.invariance" in {box.label for box in drawn.boxes}
    assert set(drawn.alone) == {
        "last-multiplier", "probable-one", "enclosed-one", "timeout-one", "error-one"
    }  # fmt: skip


def test_foundations_stand_above_what_rests_on_them() -> None:
    drawn = drawn_of(chain(("a", ()), ("b", ("a",)), ("c", ("b", "a")), ("d", ("a",))))
    height = {box.name: box.y for box in drawn.boxes}
    assert height["a"] < height["b"] < height["c"] and height["a"] < height["d"]
    assert sum(line.tip for line in drawn.lines) == 3  # a to c follows from the others


def test_what_the_paper_cites_leads_on_by_another_line() -> None:
    claims = [*chain(("a", ()), ("b", ("a",)), ("c", ()), ("d", ()))]
    claims = [c._replace(cites=("a", "b", "c")) if c.claim == "d" else c for c in claims]
    drawn = drawn_of(claims)
    lines = {(line.names[0], end): line.cited for line in drawn.lines for end in line.names[1:]}
    assert lines == {("a", "b"): False, ("b", "d"): True, ("c", "d"): True}
    (other,) = (c for c in claims if c.claim == "d")
    both = [*claims[:-1], other._replace(rests_on=("b",))]
    assert {line.names for line in drawn_of(both).lines if line.cited} == {("c", "d")}


def test_every_piece_of_a_line_knows_what_it_joins() -> None:
    drawn = drawn_of(chain(("a", ()), ("b", ("a",)), ("c", ("b",)), ("d", ("c",)), ("e", ("d",))))
    far = drawn_of(
        [*chain(("a", ()), ("b", ("a",)), ("c", ("b",))), *chain(("z", ()), ("y", ("z", "c")))]
    )
    for one in (drawn, far):
        boxes = {box.name for box in one.boxes}
        assert all(boxes.issuperset(line.names) and len(line.names) > 1 for line in one.lines)


def test_rows_share_a_box_with_the_least_verdict() -> None:
    rows = [claim("eq1.1", "1", "", "", P), claim("eq1.2", "1", "", "", R)]
    both = dict.fromkeys(("eq1.1", "eq1.2"), "(1)")
    (box, _) = drawn_of([*rows, claim("z", "1", "", "", P, rests_on=("eq1.1",))], **both).boxes
    assert (box.label, box.verdict) == ("(1)", Verdict.REFUTED)


def test_rows_stay_apart_where_one_rests_on_another_by_way_of_a_third() -> None:
    both = dict.fromkeys(("eq1.1", "eq1.2"), "(1)")
    drawn = drawn_of(chain(("eq1.1", ()), ("m", ("eq1.1",)), ("eq1.2", ("m",))), **both)
    assert [box.label for box in drawn.boxes] == ["(1)", "m", "(1)"]


def test_circles_and_unknown_names_do_no_harm() -> None:
    drawn = drawn_of(chain(("a", ("b", "nowhere")), ("b", ("a",)), ("c", ("c",))))
    assert {box.name for box in drawn.boxes} == {"a", "b"}
    assert drawn.alone == ("c",)


def test_no_claims_no_picture() -> None:
    assert picture([], {}).boxes == ()
    assert picture([], {}).scale == 1.0


def test_boxes_do_not_overlap_and_layers_are_no_wider_than_the_page() -> None:
    many = chain(("root", ()), *[(f"claim-number-{k}", ("root",)) for k in range(40)])
    drawn = drawn_of(many)
    assert len(drawn.boxes) == 41 and drawn.width <= WIDTH + 1
    for box in drawn.boxes:
        for other in drawn.boxes:
            if box is not other and box.y == other.y:
                assert abs(box.x - other.x) >= (box.width + other.width) / 2


def test_svg_is_well_formed_and_self_contained() -> None:
    root = ElementTree.fromstring(svg(drawn_of(outcomes())))
    assert root.tag.endswith("svg")
    boxes = drawn_of(outcomes()).boxes
    links = [link.get("href") for link in root.findall("{*}a")]
    assert links == [f"#claim.{box.name}" for box in boxes] != []
    assert len(root.findall("{*}a/{*}rect")) == len(boxes)
    titles = [title.text or "" for title in root.findall("{*}a/{*}title")]
    assert titles[links.index("#claim.eq9.i")] == "i² = 1" and all(titles)
