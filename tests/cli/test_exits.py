"""What is false, or differs, is told before what is undecided; neither hides the other's code."""

from itertools import combinations_with_replacement

import pytest

from kowalevski_cas.cli import exits
from kowalevski_cas.cli.formats import ComparedRun
from kowalevski_cas.notation import Vocabulary
from kowalevski_cas.verify.outcome import Outcome, Run, Verdict
from kowalevski_cas.verify.record import differences, unexpected_verdicts

OPEN = (Verdict.UNDECIDED, Verdict.TIMEOUT)
DECIDED = (Verdict.PROVED, Verdict.CONDITIONAL, Verdict.REFUTED)


def compared(verdicts, recorded=None):
    outcomes = tuple(Outcome(str(k), "1", "", (), "x=x", "", v) for k, v in enumerate(verdicts))
    found = Run("", "", "", "", (), outcomes, ("flint",), {}, Vocabulary())
    if recorded is None:
        return ComparedRun(None, None, None, found, unexpected_verdicts(found, {}), False)
    record = {str(k): {"verdict": str(v)} for k, v in enumerate(recorded)}
    return ComparedRun(None, None, None, found, differences(found, record))


@pytest.mark.parametrize("size", (1, 2, 3))
def test_red_before_yellow_before_green(size):
    for verdicts in combinations_with_replacement((*DECIDED, *OPEN), size):
        code = compared(verdicts).exit_code
        if Verdict.REFUTED in verdicts:
            assert code == exits.DIFFERENT
        elif {*OPEN} & {*verdicts}:
            assert code == exits.UNDECIDED
        else:
            assert code == exits.AS_RECORDED


def test_what_came_to_no_end_is_no_difference_from_the_record():
    for verdict in OPEN:
        assert compared((verdict,), (Verdict.PROVED,)).exit_code == exits.UNDECIDED


def test_of_several_runs_the_code_is_that_of_what_is_false():
    found = [compared((v,)).exit_code for v in (Verdict.UNDECIDED, Verdict.REFUTED, Verdict.PROVED)]
    assert exits.most_urgent(found) == exits.DIFFERENT
