"""What the installed package says of the project, which is set in one place: pyproject.toml."""

from __future__ import annotations

from importlib.metadata import PackageNotFoundError, metadata


def url(name: str) -> str:
    """The address of the project by its name there, without a slash at its end; empty if none."""
    try:
        found: list[str] = metadata("kowalevski-cas").get_all("Project-URL") or []
    except PackageNotFoundError:  # it is not installed, but run where it lies
        return ""
    pairs: dict[str, str] = dict(line.split(", ", 1) for line in found)
    return pairs.get(name, "").rstrip("/")
