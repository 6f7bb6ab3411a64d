"""What the judge accepts the checker accepts too, in the run, or there is no verdict."""

from math import inf
from time import sleep

import pytest

from kowalevski_cas import processes
from kowalevski_cas.notation import Name, Sum
from kowalevski_cas.paper.claims import FirstIntegral, Identity
from kowalevski_cas.problem import checker
from kowalevski_cas.problem.checker.elimination import rank
from kowalevski_cas.processes import each
from kowalevski_cas.verify.confirm import Watch, is_received, receive, received
from kowalevski_cas.verify.outcome import Verdict
from kowalevski_cas.verify.run import Session
from tests.paper.small import Oscillator, derivation

pytestmark = pytest.mark.forged

ENERGY, FALSE, DIVIDED = "x^2+v^2", "x=v", r"\frac{x}{v}=\frac{x}{v}"


def session(kind=Identity, tex=DIVIDED, **options):
    small = Oscillator()
    small.section.claim(kind("t", small.scene, "", printed=small(tex)))
    return Session(derivation(small.section), ["flint"], **options)


def outcome(*claim, **options):
    (found,) = session(*claim, **options).run().outcomes
    return found


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [((FirstIntegral, ENERGY), "proved"), ((Identity, FALSE), "refuted"), ((), "conditional")],
)
def test_each_verdict_was_checked_in_the_run(claim, verdict, monkeypatch):
    texts, check = [], checker.check
    monkeypatch.setattr(checker, "check", lambda text, *more: texts.append(text) or check(text))
    found = outcome(*claim)
    assert found.verdict == verdict
    assert [*found.certificates.values()] == texts != []


def test_what_the_checker_rejects_is_an_error_that_names_both(monkeypatch):
    def strict(text, budget):
        raise checker.Rejected("no")

    monkeypatch.setattr(checker, "check", strict)
    found = outcome()
    assert found.verdict == "error" and not found.certificates and not found.conditions
    assert "flint" in found.message and "the checker says: no" in found.message


def test_a_checker_that_comes_to_no_end_is_a_timeout(monkeypatch):
    monkeypatch.setattr("kowalevski_cas.problem.checker.reading.WORK", 10)
    monkeypatch.setattr(checker.Budget.__init__, "__defaults__", (10,))
    assert outcome().verdict == "timeout"


def test_a_rank_by_several_processes_is_the_same_and_takes_as_many_steps(monkeypatch):
    monkeypatch.setattr("kowalevski_cas.verify.confirm.LONG", 0)
    vectors = [{n: 1, n + 1: k + 2} for n in range(0, 60, 3) for k in range(3)]
    alone, together = Watch(inf), Watch(inf, jobs=2)
    assert rank(vectors, alone) == rank(vectors, together) == 40
    assert alone.left + alone.rest == together.left + together.rest < checker.WORK
    together.left, together.rest = 125, 0
    with pytest.raises(checker.Exhausted):
        rank(vectors, together)


@pytest.mark.slow
def test_the_time_of_the_checker_is_that_of_the_claim(monkeypatch):
    """Also if nothing that it computes can be interrupted; and the claim had half a second more."""
    for slow in (lambda text, budget: sleep(1), lambda text, budget: wait(budget)):
        monkeypatch.setattr(checker, "check", slow)
        found = outcome(timeout=0.3)
        assert found.verdict == "timeout" and not found.certificates


def wait(budget):
    while True:
        budget.spend(100)
        sleep(0.001)


@pytest.mark.slow
def test_in_a_run_of_several_processes_each_certificate_is_checked_once(monkeypatch):
    """By the process that prints; others find a certificate, and leave it at that."""
    checked, check = [], checker.check
    monkeypatch.setattr(checker, "check", lambda text, *more: checked.append(text) or check(text))
    for claim in (FirstIntegral, ENERGY), (Identity, FALSE), ():
        found = outcome(*claim, timeout=60)
        texts = [*found.certificates.values(), *(one.certificate for one in found.alternatives)]
        assert sorted(checked) == sorted(texts) != []
        checked.clear()
    monkeypatch.setattr(checker, "check", lambda *_: 1 / 0)
    found = outcome(timeout=60)
    assert found.verdict == "error" and "ZeroDivisionError" in found.message


def test_conditions_that_differ_from_those_of_the_judge_are_received_by_nobody():
    true = outcome()
    assert true.divided and receive(true).verdict == "conditional"
    ((one,),) = true.divided
    for forged in ((), ((),), ((one, Sum((one, Name("x")))),), ((Name("x"),),)):
        assert receive(true._replace(divided=forged)).verdict == "error"


def test_conditions_that_differ_are_an_error(monkeypatch):
    """More divisors, or fewer, than those by which the judge divides."""
    supposed = checker.Space.supposed
    for change in (lambda found: [], lambda found: [*found, found[0] + found[0].ring.number(1)]):
        monkeypatch.setattr(checker.Space, "supposed", lambda self, c=change: c(supposed(self)))
        found = outcome()
        assert found.verdict == "error" and "conditions" in found.message


@pytest.mark.parametrize("claim", [(FirstIntegral, ENERGY), (Identity, FALSE), ()])
def test_what_another_process_says_is_checked_where_it_is_received(claim):
    true = outcome(*claim)
    assert true.certificates and receive(true)._replace(seconds=true.seconds) == true
    other = outcome(FirstIntegral, "(x^2+v^2)^2")
    wrong = {Verdict.REFUTED: Verdict.PROVED}.get(true.verdict, Verdict.REFUTED)
    for forged in (
        true._replace(certificate=""),
        true._replace(certificate=true.certificate.replace("x", "v")),
        true._replace(certificate=other.certificate),
        true._replace(digest=other.digest),
        true._replace(verdict=wrong),
    ):
        assert receive(forged).verdict == "error"


@pytest.mark.parametrize("threads", [False, True])
def test_what_is_received_is_not_checked_where_it_is_said(threads, monkeypatch):
    monkeypatch.setattr(processes, "has_threads", lambda: threads)
    assert [*each(received(lambda _: is_received()), [None])] == [True]
    assert [*each(lambda _: is_received(), [None])] == [False]


def test_a_correction_is_checked_where_it_is_received():
    true = outcome(Identity, r"\dot x=-v")
    assert true.correction is not None and receive(true).correction == true.correction
    forged = true.correction._replace(certificate=true.certificate)
    found = receive(true._replace(correction=forged))
    assert found.verdict == "error" and found.correction is None


def test_what_is_not_decided_has_no_certificate():
    found = outcome(Identity, r"\frac{1}{x-x}=1")
    assert found.verdict == "error" and not found.certificates
    small = Oscillator()
    small.section.claim(Identity("t", small.scene, "", printed=small("x=x")))
    (found,) = Session(derivation(small.section), ["modular"]).run().outcomes
    assert found.verdict == "probable" and not found.certificates
