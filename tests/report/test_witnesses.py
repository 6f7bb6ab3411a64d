import json

import pytest

from kowalevski_cas.report import pdf, render_latex, write_report
from kowalevski_cas.report.witnesses import Witness, arithmetics, programs
from kowalevski_cas.verify.outcome import Verdict

from .fixtures import claim, run

P, R = Verdict.PROVED, Verdict.REFUTED
DIGESTS = {"eq6": "6" * 64, "eq7": "7" * 64}


def says(folder, name, **content):
    place = folder / "witnesses" / "kharlamov2002"
    place.mkdir(parents=True, exist_ok=True)
    said = {"program": name, "version": f"{name} 1.0", "confirmed": DIGESTS, "failed": {}}
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
    from dataclasses import replace

    one = replace(claim("a", "1", "x=x", "", P), verdicts={"flint": P, "sympy": R})
    assert [(w.name, w.claims) for w in arithmetics([one])] == [
        ("FLINT", frozenset({"a"})), ("SymPy", frozenset()),
    ]  # fmt: skip


class TestPage:
    def section(self, text):
        return text.partition("what has to be trusted}")[2].partition(r"\section{")[0]

    def test_without_certificates_nobody_claims_that_there_are(self):
        text = self.section(render_latex(run()))
        assert "What is not proved." in text
        assert "checker has" not in text and "Digest" not in text

    def test_with_certificates_and_programs(self, tmp_path):
        known = run().outcomes
        digests = {outcome.claim: f"{k:064d}"[::-1] for k, outcome in enumerate(known, 1)}
        rocq = Witness("Rocq", "8.16", frozenset([known[0].claim]))
        text = render_latex(run(), (), digests, (rocq,))
        page = self.section(text)
        assert f"All {len(known)} claims have a certificate" in page
        assert "Rocq has read the same certificates" in page
        rows = [row for row in page.splitlines() if r"\texttt{" in row and r"\\" in row]
        assert len(rows) == len(known)
        marks = page.count(r"$\bullet$")
        assert marks >= len(known) + 1
        assert "8.16" in text
        assert text == render_latex(run(), (), digests, (rocq,))

    @pytest.mark.parametrize("engine", ["latex", "typst"])
    def test_it_is_typeset(self, engine, tmp_path):
        if engine == "latex" and not pdf.latex_command():
            pytest.skip("there is no LaTeX")
        known = run().outcomes
        digests = {outcome.claim: "a" * 64 for outcome in known}
        says(tmp_path, "rocq", confirmed=digests)
        written = write_report(run(), tmp_path, digests, engine=engine)
        assert written.pdf.read_bytes().startswith(b"%PDF")
        assert "& Rocq" in written.tex.read_text(encoding="utf-8")
