"""An agent asks: verdicts come with their points and digests, and what is not known is said."""

import asyncio
import json
import sys

import pytest
from mcp import ClientSession, StdioServerParameters
from mcp.client.stdio import stdio_client

from kowalevski_cas.library import find
from kowalevski_cas.servers.agents import StatedClaim, derivation

OSCILLATOR = r"\dot x=y, \dot y=-x"
PAPER = r"""\begin{document}
The oscillator moves by
\[\dot x=v,\quad \dot v=-x.\]
Its energy $H=\frac12(v^2-x^2)$ is a first integral.
\end{document}"""


def asked(session):
    """What a session with the server comes to."""

    async def run():
        server = StdioServerParameters(command=sys.executable, args=["-m", "kowalevski_cas", "mcp"])
        async with stdio_client(server) as streams, ClientSession(*streams) as client:
            await client.initialize()

            async def call(tool, **arguments):
                answer = await client.call_tool(tool, arguments)
                text = "".join(one.text for one in answer.content)
                return text if answer.is_error else json.loads(text)

            return await session(client, call)

    return asyncio.run(asyncio.wait_for(run(), 120))


@pytest.mark.slow
def test_a_text_is_audited_and_a_system_verified():
    async def session(client, call):
        tools = {one.name for one in (await client.list_tools()).tools}
        assert tools == {"audit", "verify", "find", "check"}
        paper = await call("audit", text=PAPER)
        (wrong,) = [one for one in paper["formulas"] if one["verdict"] == "refuted"]
        assert wrong["correction"] == r"H = \frac{1}{2}(v^2 + x^2)" and wrong["point"]
        claims = [{"kind": "integral", "formula": one} for one in ("x^2+y^2", "x^2-y^2")]
        true, false = (await call("verify", equations=OSCILLATOR, claims=claims))["claims"]
        assert true["verdict"] == "proved" and len(true["digest"]) == 16
        assert false["verdict"] == "refuted" and {*false["point"]} == {"x", "y"}

    asked(session)


@pytest.mark.slow
def test_integrals_are_found_and_certificates_checked():
    certificate = (find("kharlamov2002") / "certificates" / "eq14.json").read_text()

    async def session(client, call):
        found = await call("find", question="integrals", equations=OSCILLATOR, degree=2)
        assert found["findings"] and found["unfinished"] is None
        closed = await call("find", question="closure", equations=OSCILLATOR, formula="-x")
        assert closed["findings"]
        assert (await call("check", certificate=certificate))["accepted"]
        forged = certificate.replace('"refuted"', '"proved"').replace("2", "3")
        assert not (await call("check", certificate=forged))["accepted"]

    asked(session)


@pytest.mark.slow
def test_what_is_not_known_is_said():
    async def session(client, call):
        unknown = {"kind": "integral", "formula": r"x^2+\gamma q^2"}
        (one,) = (await call("verify", equations=OSCILLATOR, claims=[unknown]))["claims"]
        assert one["verdict"] == "error" and "q" in one["message"]
        assert "derivative" in await call("verify", equations="a=b", claims=[])
        assert "no certificate" in await call("check", certificate="[]")
        assert "file" in await call("check", certificate='{"claim": "../../x"}')
        assert (await call("audit", text="{" * 3000))["formulas"] == []
        assert "empty" in await call("audit", text="")

    asked(session)


def test_formulas_cannot_leave_their_quotes(tmp_path):
    evil = "x'); import os; os.abort(); ('"
    names = {}
    exec(
        derivation(evil, [StatedClaim("integral", evil, (evil,))], [evil]).replace(
            "from kowalevski_cas import System", ""
        ),
        {"System": lambda text: names.setdefault(text, Recorder(names))},
    )
    assert {*names} == {evil}


class Recorder:
    """A system that only keeps the formulas that it is given."""

    def __init__(self, names):
        self.names = names

    def define(self, text):
        self.names[text] = self

    def integral(self, text, given):
        self.names |= dict.fromkeys([text, *given])
