import json

import pytest

from kowalevski_cas.report.pdf import facts, write_report
from kowalevski_cas.report.witnesses import Witness, arithmetics, programs
from kowalevski_cas.verify.outcome import Verdict

from .fixtures import claim, in_order, run

P, R = Verdict.PROVED, Verdict.REFUTED
DIGESTS = {"eq6": "6" * 64, "eq7": "7" * 64}


def says(folder, name, **content):
    place = folder / "witnesses" / "kharlamov2002"
    place.mkdir(parents=True, exist_ok=True)
    said = {"program": name, "program_version": f"{name} 1.0", "confirmed": DIGESTS, "failed": {}}
    (place / f"{name}.json").write_text(json.dumps(said | content))


class TestPrograms:
    def test_one_that_confirms_the_certificates(self, tmp_path):
        says(tmp_path, "rocq")
        (rocq,) = programs(tmp_path, "kharlamov2002", DIGESTS)
        assert rocq == Witness("Rocq", "rocq 1.0", frozenset(DIGESTS))

    def test_another_certificate_is_not_confirmed(self, tmp_path):
        says(tmp_path, "rocq", confirmed={"eq6": "6" * 64, "eq7": "0" * 64, "eq8": "8" * 64})
        (rocq,) = programs(tmp_path, "kharlamov2002", DIGESTS)
        assert rocq.claims == {"eq6"}

    def test_none(self, tmp_path):
        assert programs(tmp_path, "kharlamov2002", DIGESTS) == ()
        says(tmp_path, "pari", confirmed={})
        says(tmp_path, "rocq")
        assert programs(tmp_path, "kharlamov2002", {}) == ()
        assert programs(tmp_path, "another", DIGESTS) == ()

    @pytest.mark.parametrize(
        "content", ["", "[]", "{", '{"confirmed": 3}', "\0", '{"confirmed": {}}']
    )
    def test_what_cannot_be_read(self, content, tmp_path):
        says(tmp_path, "rocq")
        (tmp_path / "witnesses" / "kharlamov2002" / "pari.json").write_text(content)
        assert [w.name for w in programs(tmp_path, "kharlamov2002", DIGESTS)] == ["Rocq"]

    def test_they_stand_in_one_order(self, tmp_path):
        for name in ("another", "pari", "singular", "rocq"):
            says(tmp_path, name)
        found = programs(tmp_path, "kharlamov2002", DIGESTS)
        assert [w.name for w in found] == ["Rocq", "Singular", "PARI/GP", "another"]


def test_an_arithmetic_confirms_only_its_own_verdict():

    one = claim("a", "1", "x=x", "", P)._replace(verdicts={"flint": P, "sympy": R})
    assert [(w.name, w.claims) for w in arithmetics([one])] == [
        ("FLINT", frozenset({"a"})), ("SymPy", frozenset()),
    ]  # fmt: skip


class TestFacts:
    def test_who_confirms_what(self):
        known = run()
        digests = {outcome.claim: "0" * 64 for outcome in known.outcomes if outcome.claim != "eq7"}
        rocq = Witness("Rocq", "8.16", frozenset({"eq6"}))
        content = json.loads(facts(known, digests, (rocq,)))
        assert content["versions"]["Rocq"] == "8.16"
        assert list(content["claims"]) == [outcome.claim for outcome in known.outcomes]
        assert content["claims"]["eq6"]["confirmed by"] == ["Rocq"]
        assert content["claims"]["eq7"]["confirmed by"] == []
        assert content["claims"]["eq7"]["certificate"] is None
        assert content["claims"]["eq9"]["rests on"] == ["eq9.i"]

    def test_nothing_is_said_of_programs_that_nobody_asked(self):
        claims = json.loads(facts(run(), {}, ()))["claims"].values()
        assert not any("confirmed by" in claim for claim in claims)

    @pytest.mark.slow
    def test_a_report_comes_with_them(self, tmp_path):
        known = run()
        digests = {outcome.claim: "a" * 64 for outcome in known.outcomes}
        says(tmp_path, "rocq", confirmed=digests)
        written = write_report(known, in_order(known), tmp_path, digests)
        (rocq,) = programs(tmp_path, "kharlamov2002", digests)
        text = (tmp_path / "kharlamov2002.json").read_text(encoding="utf-8")
        assert text == facts(known, digests, (rocq,))
        assert f"Rocq confirms {len(digests)}" in written.html.read_text(encoding="utf-8")
