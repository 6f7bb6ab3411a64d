"""The displays of the first paper, as its derivation has them, and its words."""

from kowalevski_cas.library import load

DERIVATION = load("kharlamov2002")
WORDS = DERIVATION.texts().vocabulary
DISPLAYS = {display.id: display.tex for display in DERIVATION.displays()}
