"""Scenes derive from one another by verbs, and a name is defined once."""

import pytest

from kowalevski_cas.paper.claims import Equivalence, FirstIntegral, Identity
from kowalevski_cas.paper.derivation import Derivation, Locus, Scene, Section

section = Section("1", "")
motion = section.display("motion", r"\dot x = v, \quad \dot v = -x")
energy = section.display("energy", r"E = x^2+v^2 \equiv e")
other = section.display("other", r"E = v^2")
unit = section.inline("unit", "i^2=-1")
tau = section.inline("tau", r"\tau=it")
change = section.display("change", "z_1=x+iv, \\quad z_2=x-iv")
root = section.display("root", r"r^2 = x^2+1, \quad \sqrt{x} = 1")
at_rest = section.inline("at-rest", r"{\bs v} = 0")
top = Scene("oscillator", variables=("x", "v")).moving(motion)


def test_each_verb_gives_a_new_scene_and_leaves_the_old_one():
    derived = top.called("E").defining(energy).with_unit(unit[1], tau[1])
    assert derived.definitions == {"E": energy[1], "e": energy[1]}
    assert (derived.name, derived.unit, derived.clock) == ("E", unit[1], tau[1])
    assert derived.field == (motion[1], motion[2])
    assert (top.definitions, top.unit, top.name) == ({}, None, "oscillator")


def test_a_name_is_defined_once():
    with pytest.raises(ValueError, match="E has a meaning already on the scene “oscillator”"):
        top.defining(energy, other)
    assert top.defining(energy).redefining(other).definitions["E"] == other[1]
    for again in (
        lambda: top.defining(energy).naming("E", other[1]),
        lambda: top.naming("x", other[1]),
        lambda: top.having(constants=("x",)),
        lambda: top.having(variables=("y",), constants=("m",)).having(constants=("y",)),
        lambda: top.adjoining(r"\sqrt{x}", r"\sqrt{x}"),
        lambda: top.naming("r", other[1]).adjoining(root[1]),
    ):
        with pytest.raises(ValueError, match="has a meaning already"):
            again()


def test_variables_and_constants_are_not_defined():
    assert top.having(constants=("e",)).defining(energy).definitions == {"E": energy[1]}
    for printed in (change[1], motion[1]):
        with pytest.raises(ValueError, match="defines no new name"):
            top.having(variables=("z_1",)).defining(printed)


def test_roots_are_printed_or_given_by_their_squares():
    scene = top.adjoining(r"\sqrt{x}", root[1]).solving("s", energy[1])
    assert scene.roots == {r"\sqrt{x}": None, "r": root[1], "s": energy[1]}
    with pytest.raises(ValueError, match=r"root\.2 does not give the square of one name"):
        top.adjoining(root[2])


def test_a_restriction_takes_the_variables_away():
    scene = top.having(vectors={r"\boldsymbol{v}": ("v", "w")}).restricted(at_rest)
    assert (scene.variables, scene.zero) == (("x",), (at_rest[1],))


def test_a_change_has_the_variables_that_it_prints():
    scene = top.defining(change).with_unit(unit[1], tau[1]).changed(change, tau[1], keeping=("v",))
    assert scene.variables == ("z_1", "z_2", "v")
    assert (scene.time, scene.definitions, scene.unit) == (r"\tau", {}, None)
    assert scene.field.formulas == (change[1], change[2])


def test_more_of_everything():
    locus = Locus("x=0", ("x=0",), "x")
    scene = top.having(
        constants=("m",),
        powers=(("x", "m"),),
        conjugates=(("x", "v"),),
        nonzero=("x",),
        loci=(locus,),
    ).having(nonzero=("v",), undefined=("w",))
    assert (scene.nonzero, scene.undefined, scene.loci) == (("x", "v"), ("w",), (locus,))


# -- sections ------------------------------------------------------------------------


def test_a_display_is_placed_and_claimed_at_once():
    one = Section("2", "", copied=False)
    shown = one.identity("eq7", r"x-x = 0, \quad v-v = 0", on=top, says=("first", "second"))
    assert [(c.id, c.printed, c.words) for c in one.claims] == [
        ("eq7.1", shown[1], "first"),
        ("eq7.2", shown[2], "second"),
    ]
    assert all(isinstance(claim, Identity) for claim in one.claims)
    assert (shown.label, shown.section) == ("(7)", "2")


def test_ids_are_those_of_the_display_or_given():
    one = Section("2", "")
    one.states(FirstIntegral, one.display("E", "x^2+v^2"), on=top, says="constant")
    one.states(
        FirstIntegral, one.display("two", "x^2 = c, \\quad v"), on=top, says="", ids=("c", "v")
    )
    assert [claim.id for claim in one.claims] == ["E", "c", "v"]


def test_two_displays_say_the_same_statement_by_statement():
    one = Section("2", "")
    old, new = one.display("old", r"x=0, \quad v=0"), one.display("new", r"2x=0, \quad 3v=0")
    one.states(Equivalence, new, on=top, says="", to=old)
    assert [(c.id, c.printed, c.to) for c in one.claims] == [
        ("new.1", new[1], old[1]),
        ("new.2", new[2], old[2]),
    ]


@pytest.mark.parametrize("given", [{"says": ("one",)}, {"says": "", "ids": ("a", "b", "c")}])
def test_words_and_ids_are_as_many_as_statements(given):
    one = Section("2", "")
    with pytest.raises(ValueError, match="eq7: 2 statements"):
        one.identity("eq7", r"x = x, \quad v = v", on=top, **given)


# -- derivations that rest on others ---------------------------------------------------


def test_accepted_corrections_hold_in_what_rests_on_it():
    first, second = Section("1", ""), Section("1", "")
    rows = first.display("rows", r"x+0 = x, \quad x+0 = w, \quad v = v.")
    first.accept(rows[2], rows[2].tex.replace("w", "x"))
    below = Derivation("below", "", "", "", (first,))
    second.states(Identity, rows, on=top, says="")
    above = Derivation("above", "", "", "", (second,), rests_on=(below,))
    assert below.texts().source(rows) == rows.tex
    assert above.texts(None, top).source(rows) == r"x+0 = x, \quad x+0 = x, \quad v = v."
    assert above.corrected() == below.corrected()
    assert above.texts({"rows": "x=x"}).source(rows) == "x=x"


def test_an_id_is_given_once_in_all_that_is_used():
    first, second = Section("1", ""), Section("1", "")
    first.display("eq1", "x=x")
    second.display("eq1", "v=v")
    below = Derivation("below", "", "", "", (first,))
    with pytest.raises(ValueError, match="two displays are called eq1"):
        Derivation("above", "", "", "", (second,), rests_on=(below,))


@pytest.mark.parametrize("wrong", ["E=v^2", 3, None, ("E=v^2",)])
@pytest.mark.parametrize(
    "verb",
    ["moving", "defining", "redefining", "assuming", "taking", "restricted", "solved", "solving", "naming", "changed"],
)  # fmt: skip
def test_a_verb_takes_what_is_printed_and_no_text(verb, wrong):
    arguments = {"naming": ("E", wrong), "solving": ("r", wrong), "changed": (wrong, tau[1])}
    if (verb, wrong) == ("solving", None):
        return  # a root that is printed as such
    with pytest.raises(TypeError, match=r"is expected|is to hold a statement"):
        getattr(top, verb)(*arguments.get(verb, (wrong,)))


@pytest.mark.parametrize("more", [{"nonzero": "x"}, {"constants": "m"}, {"variables": ["y"]}])
def test_further_names_are_a_tuple(more):
    with pytest.raises(TypeError, match="add a comma"):
        top.having(**more)
