"""Write the manual page, kowalevski-cas.1, from the help of the commands."""

from __future__ import annotations

import re
import sys
from pathlib import Path

from argparse_manpage.manpage import Manpage

from kowalevski_cas import __version__
from kowalevski_cas.cli import whole_parser

PAGE = Path(__file__).with_name("kowalevski-cas.1")


def page() -> str:
    """The manual page, the same in every version of Python that formats help alike."""
    parser = whole_parser()
    parser.man_short_description = "check the formulas of papers in mechanics"  # type: ignore[attr-defined] # where argparse-manpage looks for it
    data = {
        "project_name": "kowalevski-cas",
        "version": __version__,
        "manual_title": "kowalevski-cas",
        "manual_section": 1,
        "format": "single-commands-section",
    }
    text = f"{Manpage(parser, _data=data, format=data['format'])}"
    text = re.sub(r"processes at once \(\d+\)", "processes at once (one a processor)", text)
    text = re.sub(r'(?m)^(\.TH .*? "1") "[^"]*"', r'\1 ""', text)  # no dates
    return re.sub(r"(?m)^usage: (?:.+\n)+", r".nf\n\g<0>.fi\n", text)


if __name__ == "__main__":
    (Path(sys.argv[1]) if sys.argv[1:] else PAGE).write_text(page(), encoding="utf-8")
