"""The long description of a release: the README, whose pictures are found from elsewhere."""

import re
from pathlib import Path
from typing import Any

from hatchling.metadata.plugin.interface import MetadataHookInterface

_RELATIVE = re.compile(
    r"""(?P<mark>!?)\[(?P<words>[^][]*)\]\((?P<link>(?![a-z]+:|\#)[^()\s]+)\)"""
    r"""|(?P<src>src=")(?P<picture>(?![a-z]+:)[^"]+)"""
)


class LongDescription(MetadataHookInterface):
    """Gives the README to a release, with links into the repository if it is known."""

    def update(self, metadata: dict[str, Any]) -> None:
        """Set the long description; without a repository it is the README as it stands."""
        text = Path(self.root, "README.md").read_text(encoding="utf-8")
        repository = metadata.get("urls", {}).get("Repository", "").rstrip("/")
        if repository:
            text = absolute(text, repository)
        metadata["readme"] = {"content-type": "text/markdown", "text": text}


def absolute(text: str, repository: str) -> str:
    """The text with links to the files of a repository; pictures are linked to as they are."""

    def linked(match: re.Match[str]) -> str:
        if match["src"]:
            return f"{match['src']}{repository}/raw/HEAD/{match['picture']}"
        kind = "raw" if match["mark"] else "blob"
        return f"{match['mark']}[{match['words']}]({repository}/{kind}/HEAD/{match['link']})"

    return _RELATIVE.sub(linked, text)
