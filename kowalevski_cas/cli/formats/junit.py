"""Results as JUnit XML: a test is that a claim's outcome is the recorded one."""

from __future__ import annotations

from collections.abc import Sequence
from xml.etree import ElementTree

from kowalevski_cas.cli.formats import Result
from kowalevski_cas.verify.outcome import Verdict


def render(results: Sequence[Result]) -> str:
    """A suite for each derivation, a case for each claim."""
    suites = ElementTree.Element("testsuites", name="kowalevski-cas")
    for result in results:
        suites.append(_suite(result))
    ElementTree.indent(suites)
    text = ElementTree.tostring(suites, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n'


def _suite(result: Result) -> ElementTree.Element:
    changed = {d.claim: d for d in result.differences}
    outcomes = result.run.outcomes
    suite = ElementTree.Element("testsuite", name=result.run.derivation)
    failures = errors = 0
    for outcome in outcomes:
        case = ElementTree.SubElement(
            suite,
            "testcase",
            classname=f"{result.run.derivation}.section{outcome.section}",
            name=outcome.claim,
            time=f"{sum(outcome.seconds.values()):.6f}",
        )
        if outcome.verdict in (Verdict.ERROR, Verdict.UNDECIDED, Verdict.TIMEOUT):
            errors += 1
            error = ElementTree.SubElement(case, "error", message=str(outcome.verdict))
            error.text = _clean(outcome.message)
        elif outcome.claim in changed:
            failures += 1
            difference = changed[outcome.claim]
            message = f"recorded: {difference.recorded}; found: {difference.found}"
            ElementTree.SubElement(case, "failure", message=_clean(message))
        output = ElementTree.SubElement(case, "system-out")
        output.text = _clean(f"{outcome.verdict}: {outcome.source or outcome.words}")
    for claim in changed.keys() - {outcome.claim for outcome in outcomes}:
        failures += 1
        case = ElementTree.SubElement(
            suite, "testcase", classname=result.run.derivation, name=claim
        )
        message = f"recorded: {changed[claim].recorded}; found: {changed[claim].found}"
        ElementTree.SubElement(case, "failure", message=_clean(message))
    suite.set("tests", str(len(suite)))
    suite.set("failures", str(failures))
    suite.set("errors", str(errors))
    return suite


def _clean(text: str) -> str:
    """The text without characters that XML cannot hold."""
    return "".join(c for c in text if c in "\n\t" or ord(c) >= 32)
