"""What mkdocs does with a page of the site: roles of Sphinx in docstrings become code."""

import re

ROLE = re.compile(r":(?:class|func|meth|mod|attr|data|exc|math):<code>(~?)([^<]*)</code>")


def on_page_content(html, **_):
    """The page, in which ``~a.b.C`` is shown as its last part."""
    return ROLE.sub(
        lambda role: f"<code>{role[2].rpartition('.')[2] if role[1] else role[2]}</code>", html
    )
