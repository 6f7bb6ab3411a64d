"""When a report was written, and by what."""

from __future__ import annotations

import os
from datetime import UTC, date, datetime
from importlib.metadata import PackageNotFoundError, metadata

from kowalevski_cas import __version__
from kowalevski_cas.report.document import Code, Link, Text


def written_by(command: str) -> Text:
    """The date, the program with its version and its address, and the command to do it again."""
    name: Text = (f"kowalevski_cas {__version__}",)
    if address := project_address():
        name = (Link(address, name, outside=True),)
    day = today()
    return (f"Written on {day.day} {day:%B %Y} by ", *name, ": ", Code(command))


def today() -> date:
    """The date of the report: ``SOURCE_DATE_EPOCH``, by which builds are repeated, or today's."""
    moment = os.environ.get("SOURCE_DATE_EPOCH", "")
    if moment.isdecimal():
        return datetime.fromtimestamp(int(moment), UTC).date()
    return datetime.now(UTC).date()


def project_address() -> str:
    """Where the project lives, by the package's metadata; nothing if that does not say."""
    try:
        said = metadata("kowalevski-cas").get_all("Project-URL") or []
    except PackageNotFoundError:
        return ""
    addresses: dict[str, str] = dict(line.split(", ", 1) for line in said)
    return addresses.get("Repository", "")
