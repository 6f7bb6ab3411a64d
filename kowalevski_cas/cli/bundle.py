"""Put all that proves the verdicts on a derivation into one folder, to deposit with a paper.

It has the problems with their evidence, the checker, which needs Python alone, the report as a
page, the digest of every file, and a README that says how to check them and to cite a verdict.
"""

from __future__ import annotations

import argparse
import sys
from hashlib import sha256
from importlib.resources import files
from pathlib import Path
from typing import Final

from kowalevski_cas import __version__
from kowalevski_cas.cli import plain, session
from kowalevski_cas.cli.check import tell
from kowalevski_cas.cli.exits import NOTHING, CommandError
from kowalevski_cas.cli.formats import ComparedRun
from kowalevski_cas.cli.report import check_certificates, runs_with_steps
from kowalevski_cas.files import read, write_all
from kowalevski_cas.problem import checker
from kowalevski_cas.report.pdf import page
from kowalevski_cas.verify.certificate import FOLDER
from kowalevski_cas.verify.committed import Checked, certificate_files
from kowalevski_cas.verify.outcome import Outcome, Run, Verdict

SUMS: Final = "SHA256SUMS"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The arguments of the command."""
    session.add_derivations(parser)
    session.add_output(
        parser, "write there, each derivation into an empty folder of its name", required=True
    )
    session.add_timeout(parser, 60)


def run(arguments: argparse.Namespace) -> int:
    """Run the command and return its exit code."""
    chosen = session.derivations(arguments.derivations)
    for folder, derivation in chosen:
        if not certificate_files(folder):
            name = derivation.name
            raise CommandError(f"{name} has no certificates: `kowalevski-cas record`", NOTHING)
        target = arguments.output / derivation.name
        if target.exists() and any(target.iterdir()):
            raise CommandError(f"{target} is not empty: remove it, or write elsewhere")

    done = session.map_in_processes(
        lambda found: _write(found, arguments.output), runs_with_steps(chosen, arguments.timeout)
    )
    for _, said in done:
        print(said, file=sys.stderr)
    return max(tell([checked]) for checked, _ in done)


def _write(found: ComparedRun, output: Path) -> tuple[Checked, str]:
    """Write the bundle of a run; what the checker says of its certificates, and where it is."""
    run, folder = found.run, found.folder
    checked, digests = check_certificates(found)
    _, written = page(run, found.paper, digests, evidence=FOLDER)
    contents: dict[str, bytes] = {name: text.encode() for name, text in written.items()}
    for path in certificate_files(folder):
        contents[f"{FOLDER}/{path.relative_to(folder / FOLDER).as_posix()}"] = read(path).encode()
    for path in sorted(Path(checker.__file__).parent.glob("*.py")):
        contents[f"checker/{path.name}"] = path.read_bytes()
    contents["README.md"] = _readme(run, checked).encode()
    sums = (f"{sha256(data).hexdigest()}  {name}\n" for name, data in sorted(contents.items()))
    contents[SUMS] = "".join(sums).encode()
    target = output / run.derivation
    write_all({target / name: data for name, data in contents.items()})
    size = sum(map(len, contents.values())) / 1e6
    return checked, f"{target} has {len(contents)} files, {size:.1f} MB"


def _readme(run: Run, checked: Checked) -> str:
    """What is in a bundle, how it is checked, and how a verdict is cited."""
    title = plain.words(run.title, run.vocabulary)
    origin = ", ".join(filter(None, (run.author, plain.words(run.source, run.vocabulary))))
    sure = [o for o in run.outcomes if o.claim in checked.accepted]
    sure.sort(key=lambda o: o.verdict is not Verdict.REFUTED)
    folders = dict.fromkeys(f"{FOLDER}/{name}".rpartition("/")[0] for name in checked.accepted)
    template = (files("kowalevski_cas.report") / "pages" / "bundle.md").read_text(encoding="utf-8")
    return template.format(
        title=title, origin=origin, name=run.derivation, version=__version__, folder=FOLDER,
        sums=SUMS, number=checked.total, files=" ".join(f"{name}/*.json" for name in folders),
        citation="".join(_citation(outcome, f"“{title}” ({origin})") for outcome in sure[:1]),
        example="".join(f"{FOLDER}/{outcome.claim}.json" for outcome in sure[:1]),
    )  # fmt: skip


def _citation(outcome: Outcome, paper: str) -> str:
    said = "is false as printed" if outcome.verdict is Verdict.REFUTED else "holds"
    return (
        f"Claim {outcome.claim} of {paper} {said}: statement {outcome.digest}, "
        f"certificate {FOLDER}/{outcome.claim}.json, kowalevski_cas {__version__}."
    )
