"""The run: verdicts, disagreements, limits of time, errors that are outcomes."""

import sys
import time
from collections import Counter

import pytest

from kowalevski_cas.algebra import EXACT
from kowalevski_cas.library import available, find, load
from kowalevski_cas.paper.claims import FirstIntegral, Identity
from kowalevski_cas.paper.derivation import Derivation, Section
from kowalevski_cas.problem.evaluate import Evaluation
from kowalevski_cas.problem.examine import Accepted
from kowalevski_cas.problem.fold import Fold
from kowalevski_cas.verify.arithmetics import Arithmetics, Decided
from kowalevski_cas.verify.certificate import load_certificates
from kowalevski_cas.verify.decider import FRAMES
from kowalevski_cas.verify.outcome import Verdict
from kowalevski_cas.verify.record import differences, load_record
from kowalevski_cas.verify.run import Session, run_together
from kowalevski_cas.verify.statement import Statement
from tests.paper.small import Oscillator, decide, derivation, verdicts
from tests.sample import sampled

SAID = dict(zip(EXACT, ("proved", "refuted", "proved"), strict=True))
judge = Arithmetics.judge


def fickle(self, statement, verdicts, arithmetic):
    """What comes out depends on the arithmetic."""
    return Decided(statement, None, Accepted(), Verdict(SAID[arithmetic]))


def slow(self, statement, verdicts, arithmetic):
    """The time of one arithmetic is over."""
    if arithmetic == "sympy":
        raise TimeoutError
    return judge(self, statement, verdicts, arithmetic)


class LongSearch(Identity):
    def search(self, goals):
        time.sleep(5)
        return {}


@pytest.fixture
def small():
    return Oscillator()


def one(small, claim, **options):
    small.section.claim(claim)
    (outcome,) = Session(derivation(small.section), EXACT, **options).run().outcomes
    return outcome


@pytest.mark.forged
def test_arithmetics_that_disagree_are_an_error(small, monkeypatch):
    monkeypatch.setattr(Arithmetics, "judge", fickle)
    outcome = one(small, Identity("t", small.scene, "", printed=small("x=x")))
    assert outcome.verdict == "error"
    said = "flint: proved, symengine: refuted, sympy: proved"
    assert outcome.message == f"the arithmetics disagree ({said})"


def test_a_claim_whose_evidence_is_not_found_in_time_is_a_timeout(small):
    claim = LongSearch("t", small.scene, "", printed=small("x=x"))
    (outcome,) = decide(small.section, claim, timeout=0.05)
    assert outcome.verdict == "timeout"
    assert outcome.message == "not decided within 0.05 s"


class Crashes(Identity):
    """Whatever happens when a claim says what it states."""

    how: str

    def goals(self, on):
        yield from eval(self.how)


CRASHES = [
    "1 / 0", "next(iter(()))", "{}['x']", "(lambda f: f(f))(lambda f: f(f))", "[7]", "(yield)",
    "(_ for _ in ()).throw(AssertionError('it is so'))", "(_ for _ in ()).throw(MemoryError)",
    "__import__('sys').exit(0)",
]  # fmt: skip
DEATHS = ["__import__('os')._exit(0)", "__import__('os').kill(__import__('os').getpid(), 9)"]


@pytest.mark.parametrize("how", CRASHES)
@pytest.mark.parametrize("timeout", sampled([None, 60.0], 1))
def test_whatever_a_claim_does_is_an_error_of_its_own(how, timeout, small):
    claims = [
        Crashes("bad", small.scene, "", how, printed=small("x=x")),
        Identity("good", small.scene, "", printed=small("x=x")),
    ]
    bad, good = decide(small.section, *claims, timeout=timeout)
    assert (bad.verdict, good.verdict) == ("error", "proved")
    assert bad.message.startswith("it cannot be computed (") and "Traceback" in bad.stack
    assert bad.stack.count("File") <= 2 * FRAMES and not good.stack


@pytest.mark.parametrize("how", DEATHS)
def test_a_process_that_dies_takes_its_claim_along_and_no_other(how, small):
    claims = [
        Identity("first", small.scene, "", printed=small("x=x")),
        Crashes("bad", small.scene, "", how, printed=small("x=x")),
        Identity("good", small.scene, "", printed=small("x=x")),
    ]
    first, bad, good = decide(small.section, *claims, timeout=60.0)
    assert (first.verdict, bad.verdict, good.verdict) == ("proved", "error", "proved")
    assert "has died" in bad.message


def test_a_timeout_in_one_arithmetic_is_a_timeout(small, copies, monkeypatch):
    monkeypatch.setattr(Arithmetics, "judge", slow)
    outcome = one(small, Identity("t", small.scene, "", printed=small("x=x")), timeout=600)
    assert outcome.verdict == "timeout"
    assert outcome.message == "not decided within 600 s"


def test_a_formula_that_cannot_be_read_is_an_error_of_its_claim_only(small):
    bad = Identity("bad", small.scene, "", printed=small("x = ("))
    good = Identity("good", small.scene, "", printed=small(r"\dot x = v"))
    bad, good = decide(small.section, bad, good)
    assert (bad.verdict, good.verdict) == ("error", "proved")
    assert "x = (" in bad.message and bad.digest == "" and bad.rests_on == ()


def test_a_statement_that_is_not_there_is_an_error(small):
    (outcome,) = decide(small.section, Identity("t", small.scene, "", printed=small("x=x", 3)))
    assert outcome.verdict == "error"
    assert "statement 3 is asked for, there are 1" in outcome.message


def test_a_name_without_meaning_on_the_scene_is_an_error(small):
    (outcome,) = decide(
        small.section,
        Identity("t", small.old, "", printed=small("x=k")),
        Identity("u", small.scene, "", printed=small("k=k")),
    )[:1]
    assert outcome.verdict == "error"
    assert "k has no meaning on the scene “oscillator with the unit”" in outcome.message


def test_an_undeclared_name_is_an_error_with_a_caret(small):
    lines = small.outcome(Identity, "y = x").message.splitlines()
    assert lines[-2].strip() == "y = x" and lines[-1].strip() == "^"


def test_sources_are_read_instead_of_what_is_printed(small):
    tex = small("x=v")
    assert verdicts(
        small.section, Identity("t", small.scene, "", printed=tex), sources={tex.display.id: "x=x"}
    ) == ["proved"]


def test_every_arithmetic_decides_and_tells_what_it_costs(run):
    assert all(set(outcome.seconds) == set(EXACT) for outcome in run.outcomes)


def test_an_id_is_given_once(small):
    claims = [
        Identity("t", small.scene, "", printed=small("x=x")),
        Identity("t", small.scene, "", printed=small("x=v")),
    ]
    with pytest.raises(ValueError):
        decide(small.section, *claims)


@pytest.mark.slow
@pytest.mark.parametrize("name", sampled(available(), 1, seed=8))
def test_what_has_a_certificate_is_searched_for_no_more(name, monkeypatch):
    """That goes for the corrections of other derivations as well on which one rests."""
    monkeypatch.setitem(sys.modules, "kowalevski_cas.search.find", None)
    kept, record = load_certificates(find(name)), load_record(find(name))
    run = Session(load(name), ["flint"], certificates=kept, record=record).run()
    assert run.outcomes and not differences(run, record, True)


class Unsure(Session):
    """A run that decides nothing."""

    def decide(self, claim):
        return self.decider.writer.without_evidence(claim, self.on(claim), Verdict.UNDECIDED, "")


@pytest.mark.parametrize("own", [True, False])
def test_what_rests_on_another_derivation_asks_the_run_of_that_one_and_no_namesake(own, small):
    """Above a misprint that is corrected below, where a run of the one below says nothing."""
    printed = small("K=(x-v)(x+v)=x^2+v^2")
    on = small.scene.defining(printed)
    small.section.claim(Identity("t", on, "", printed=printed))
    small.section.accept(printed, "K=(x-v)(x+v)=x^2-v^2")
    below, namesake = (Derivation("below", "", "", "", (small.section,)) for _ in range(2))
    section = Section("2", "")
    section.identity("eq2", "K=x^2-v^2", on=on, says="")
    above = Derivation("above", "", "", "", (section,), rests_on=(below,))
    known = Unsure(below if own else namesake, ["flint"])
    (outcome,) = run_together([known, Session(above, ["flint"])], ["eq2"])[1].outcomes
    assert outcome.corrected == ("below/t",)
    assert outcome.verdict == ("undecided" if own else "proved")


def test_points_need_no_search_for_a_proof_but_for_what_exists(small, monkeypatch):
    asked = []
    search = Statement.search
    monkeypatch.setattr(Statement, "search", lambda one: asked.append(one.name) or search(one))
    small.section.claim(
        Identity("t", small.scene, "", printed=small("x=x+v-v")),
        Identity("f", small.scene, "", printed=small("x=v")),
    )
    outcomes = Session(derivation(small.section), ["modular"]).run().outcomes
    assert [str(outcome.verdict) for outcome in outcomes] == ["probable", "refuted"] and not asked


@pytest.mark.forged  # nothing is: the law of verdicts would evaluate it anew
@pytest.mark.parametrize("tex", ["x^2+v^2", "kE"])
def test_a_new_statement_is_evaluated_once(small, monkeypatch, tex):
    """By search, judge and words together, in the evaluation that they share."""
    evaluated = Counter()
    pairs = Fold.pairs

    def count(fold, equations):
        evaluated.update(equations if type(fold) is Evaluation else ())
        return pairs(fold, equations)

    monkeypatch.setattr(Fold, "pairs", count)
    small.section.claim(FirstIntegral("t", small.scene, "", printed=small(tex)))
    (outcome,) = Session(derivation(small.section), ["flint"]).run().outcomes
    assert str(outcome.verdict) == "proved" and evaluated and max(evaluated.values()) == 1
