"""Let another program read an export: it confirms a claim, in so many words, or the claim fails."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory

from kowalevski_cas.export.format import Export, Format
from kowalevski_cas.processes import each
from kowalevski_cas.schema import head
from kowalevski_cas.tools import MissingTool, Tool

JOBS = 2
SECONDS = 300
"""A program that has not answered after so long does not confirm."""

Progress = Callable[[str, int, int], None]


@dataclass(frozen=True)
class Testimony:
    """What a program confirms.

    ``confirmed`` has the digests of the certificates by claim, ``failed`` the reasons
    why other claims are not confirmed.
    """

    program: str
    program_version: str
    confirmed: dict[str, str]
    failed: dict[str, str]

    def text(self) -> str:
        """The testimony as JSON."""
        value = {**head("testimony"), **asdict(self)}
        return json.dumps(value, indent=1, ensure_ascii=False) + "\n"


def version(tool: Tool) -> str:
    """What a system calls itself, with its version.

    Raises:
        MissingTool: it is not installed, or does not tell.
    """
    call = tool.call()
    code, output = answer([*call, *tool.version], Path.cwd())
    if code or not output.strip():
        raise MissingTool(f"{' '.join(call)} does not tell its version: {_last(output)}")
    return output.strip().splitlines()[0]


def testify(
    name: str,
    format: Format,
    export: Export,
    digests: Mapping[str, str],
    progress: Progress = lambda claim, done, total: None,
) -> Testimony:
    """Let the program of a format read an export, two files at a time.

    ``digests`` has the digest of each claim's certificate.

    Raises:
        MissingTool: the program is not installed, or does not run.
    """
    call = format.tool.call()
    testimony = Testimony(name, version(format.tool), {}, {})
    with TemporaryDirectory() as place:
        folder = Path(place)
        for file, text in export.files.items():
            (folder / file).write_text(text, encoding="utf-8")

        def read(claim: str) -> str:
            """Why the program does not confirm what it reads about a claim; empty if it does."""
            file, text = export.names[claim], export.texts[claim]
            code, output = answer([*call, *format.arguments(folder / file)], folder)
            return f"exit code {code}: {_last(output)}" if code else format.objection(text, output)

        for file in export.shared:
            code, output = answer([*call, *format.arguments(folder / file)], folder)
            if code:
                reason = f"{file}: {_last(output)}"
                return replace(testimony, failed=dict.fromkeys(export.texts, reason))
        answers = each(read, list(export.texts), JOBS)
        for done, (claim, reason) in enumerate(zip(export.texts, answers, strict=True)):
            progress(claim, done, len(export.texts))
            if reason:
                testimony.failed[claim] = reason
            else:
                testimony.confirmed[claim] = digests[claim]
    return testimony


def answer(arguments: Sequence[str], folder: Path) -> tuple[int, str]:
    """The exit code of a program, and all that it said.

    Nobody has to have a home: a warning that there is none is no answer.
    """
    try:
        done = subprocess.run(
            arguments,
            cwd=folder,
            env={"HOME": str(folder)} | {k: v for k, v in os.environ.items() if k != "HOME" or v},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            timeout=SECONDS,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return 124, f"no answer within {SECONDS} seconds"
    except OSError as error:
        return 126, str(error)
    return done.returncode, done.stdout.decode("utf-8", "replace")


def _last(output: str) -> str:
    """The last thing that a program said, in one line."""
    words = " ".join(output.split())
    return f"… {words[-200:]}" if len(words) > 200 else words
