"""A server for the model context protocol: what an agent asks of papers and equations of motion.

An answer has verdicts of this program, and no others. *Undecided* is one of them: it says nothing
of a formula, and an agent is told so.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Literal

from mcp.server import MCPServer
from mcp.server.mcpserver.exceptions import ToolError

from kowalevski_cas import __version__
from kowalevski_cas.servers.commands import CommandAnswer, run_command

INSTRUCTIONS = """\
Formulas are LaTeX, as a paper on mechanics prints them. A verdict is one of: proved; conditional
(proved where its conditions do not vanish); refuted (an exact point is given where it fails);
undecided, timeout, error, open (nothing is known: say so, and do not guess). Proved and refuted
have a certificate, known by its digest, which an independent checker has accepted.
"""

KEPT = ("id", "label", "line", "tex", "role", "verdict", "conditions", "message", "digests")
"""What an agent is told of each formula of a text, besides where it fails and what mends it."""

server = MCPServer(
    "kowalevski-cas", instructions=INSTRUCTIONS, version=__version__, log_level="WARNING"
)


@dataclass(frozen=True)
class StatedClaim:
    """A claim about a system: of which kind, the formula, what is given, and a cofactor."""

    kind: Literal["identity", "implication", "integral", "invariant", "darboux", "casimir"]
    formula: str
    given: tuple[str, ...] = ()
    cofactor: str = ""


@server.tool()
async def audit(text: str) -> dict[str, Any]:
    """Read the LaTeX source of a paper, and prove or refute each formula that it claims.

    It finds the equations of motion, what is defined, supposed and claimed; `assumed` and
    `uncovered` say on what the verdicts stand, and which sentences none of them covers.
    """
    with TemporaryDirectory() as folder:
        paper = str(Path(folder, "paper.tex"))
        found = _document(
            await run_command("audit", paper, "--stdin", "--format", "json", text=text)
        )
    formulas = [
        {key: formula[key] for key in KEPT} | _evidence(formula) for formula in found["formulas"]
    ]
    return {
        "formulas": [formula for formula in formulas if formula["verdict"] != "given"],
        "statements": [
            {"id": statement["id"], "words": statement["words"], "verdict": statement["verdict"]}
            | _evidence(statement)
            for statement in found["statements"]
        ],
        "assumed": [assumption["words"] for assumption in found.get("assumed", [])],
        "uncovered": found["uncovered"],
        "wrong": found["summary"]["wrong"],
    }


@server.tool()
async def verify(
    equations: str, claims: list[StatedClaim], definitions: Sequence[str] = ()
) -> dict[str, Any]:
    r"""Prove or refute claims about equations of motion.

    Args:
        equations: a display such as `\dot x=\sigma(y-x), \dot y=\rho x-y-xz, \dot z=xy-bz`; what
            has a derivative moves, all other names are constant.
        claims: what is claimed of them: an `integral` is constant along every motion, an
            `invariant` is a relation that no motion leaves, a `darboux` polynomial has F'=KF with
            its `cofactor` K, an `implication` holds where what is `given` does.
        definitions: names that formulas use, as `F=x^2-2\sigma z`.
    """
    program = derivation(equations, claims, definitions)
    found = _document(await _with_file(program, "verify", "--format", "json"))
    keys = ("id", "words", "printed", "verdict", "conditions", "message", "digest")
    return {
        "claims": [
            {key: claim[key] for key in keys} | _evidence(claim) for claim in found["claims"]
        ],
        "derivation": program,
    }


@server.tool()
async def find(
    question: Literal["integrals", "darboux", "closure", "parameters", "exponents"],
    equations: str,
    degree: int = 2,
    formula: str = "",
    seconds: float = 60,
) -> dict[str, Any]:
    """Search what nobody has printed about equations of motion.

    Args:
        question: polynomial first `integrals` up to a degree; `darboux` polynomials; the `closure`
            of a formula under the motion; `parameters` for which a formula divides its derivative;
            the Kowalevski `exponents`.
        equations: as for `verify`.
        degree: the highest degree of integrals and Darboux polynomials.
        formula: for `closure` and `parameters`.
        seconds: how long to search; `unfinished` says if something may be left.
    """
    options = [f"--timeout={seconds}", "--format=json"]
    options += [f"--degree={degree}"] if question in ("integrals", "darboux") else []
    formulas = [formula] if question in ("closure", "parameters") else []
    program = derivation(equations, [])
    return _document(await _with_file(program, "find", question, *options, after=formulas))


@server.tool()
async def check(certificate: str) -> dict[str, Any]:
    """Check a certificate, the text of its file, with the independent checker: what it proves."""
    try:
        name = str(json.loads(certificate)["claim"])
    except (ValueError, TypeError, KeyError):
        raise ToolError("it is no certificate: a JSON object with a `claim` is expected") from None
    if "/" in name or "\0" in name:
        raise ToolError("the claim of a certificate is the name of its file")
    with TemporaryDirectory() as folder:
        file = Path(folder, f"{name[:200]}.json")
        file.write_text(certificate, encoding="utf-8")
        answer = await run_command("check", "--full", "--", str(file))
    return {"accepted": answer.code == 0, "says": answer.output.replace(f"{folder}/", "")}


def derivation(
    equations: str, claims: Sequence[StatedClaim], definitions: Sequence[str] = ()
) -> str:
    r"""A derivation in Python that states claims about equations of motion.

    >>> print(derivation(r"\dot x=y, \dot y=-x", [StatedClaim("integral", "x^2+y^2")]))
    from kowalevski_cas import System
    <BLANKLINE>
    system = System('\\dot x=y, \\dot y=-x')
    system.integral('x^2+y^2')
    <BLANKLINE>
    """
    lines = ["from kowalevski_cas import System", "", f"system = System({equations!r})"]
    lines += [f"system.define({definition!r})" for definition in definitions]
    for claim in claims:
        words = [repr(claim.formula)]
        words += [f"given={claim.given!r}"] if claim.given else []
        words += [f"cofactor={claim.cofactor!r}"] if claim.cofactor else []
        lines.append(f"system.{claim.kind}({', '.join(words)})")
    return "\n".join([*lines, ""])


async def _with_file(program: str, *words: str, after: Sequence[str] = ()) -> CommandAnswer:
    """What a command prints of a derivation in a file."""
    with TemporaryDirectory() as folder:
        file = Path(folder, "system.py")
        file.write_text(program, encoding="utf-8")
        answer = await run_command(*words, "--", str(file), *after)
    return answer._replace(errors=answer.errors.replace(f"{folder}/", ""))


def _document(answer: CommandAnswer) -> dict[str, Any]:
    if answer.document is None:
        raise ToolError(answer.errors or f"it ended with exit code {answer.code}")
    return answer.document


def _evidence(found: Mapping[str, Any]) -> dict[str, Any]:
    """Where something fails, and what would be true."""
    against, correction = found["counterexample"], found["correction"]
    told: dict[str, Any] = {}
    if against is not None:
        told |= {"point": against["point"], "fails": against["words"]}
    if correction is not None:
        told |= {"correction": correction["printed"], "correction_verdict": correction["verdict"]}
    return told


def serve() -> None:
    """Serve an agent on standard input and output, until it ends."""
    server.run()
