"""A paper's source read as a derivation: what each formula is, and on what it stands."""

from kowalevski_cas.reading.read import Formula, Reading, read
