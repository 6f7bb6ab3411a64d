"""Results as JUnit XML: a test is that a claim's outcome is the recorded one."""

from __future__ import annotations

from collections.abc import Sequence
from xml.etree import ElementTree

from kowalevski_cas.cli.formats import ComparedRun
from kowalevski_cas.verify.outcome import Verdict
from kowalevski_cas.verify.record import Difference


def render(results: Sequence[ComparedRun]) -> str:
    """A suite for each derivation, a case for each claim."""
    suites = ElementTree.Element("testsuites", name="kowalevski-cas")
    for result in results:
        suites.append(_suite(result))
    ElementTree.indent(suites)
    text = ElementTree.tostring(suites, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n'


def _suite(result: ComparedRun) -> ElementTree.Element:
    changed = {d.claim: d for d in result.differences}
    suite = ElementTree.Element("testsuite", name=result.run.derivation)
    for outcome in result.run.outcomes:
        case = ElementTree.SubElement(
            suite,
            "testcase",
            classname=f"{result.run.derivation}.section{outcome.section}",
            name=outcome.claim,
            time=f"{sum(outcome.seconds.values()):.6f}",
        )
        difference = changed.pop(outcome.claim, None)
        if outcome.verdict in (Verdict.ERROR, Verdict.UNDECIDED, Verdict.TIMEOUT):
            error = ElementTree.SubElement(case, "error", message=str(outcome.verdict))
            error.text = _clean(outcome.message)
        elif difference is not None:
            _fail(case, result.standard, difference)
        output = ElementTree.SubElement(case, "system-out")
        output.text = _clean(f"{outcome.verdict}: {outcome.source or outcome.words}")
    for claim, difference in changed.items():
        gone = {"classname": result.run.derivation, "name": claim}
        _fail(ElementTree.SubElement(suite, "testcase", gone), result.standard, difference)
    suite.set("tests", str(len(suite)))
    suite.set("failures", str(len(suite.findall("*/failure"))))
    suite.set("errors", str(len(suite.findall("*/error"))))
    return suite


def _fail(case: ElementTree.Element, standard: str, difference: Difference) -> None:
    message = f"{standard}: {difference.recorded}; found: {difference.found}"
    ElementTree.SubElement(case, "failure", message=_clean(message))


def _clean(text: str) -> str:
    """The text without characters that XML cannot hold."""
    return "".join(c for c in text if c in "\n\t" or ord(c) >= 32)
