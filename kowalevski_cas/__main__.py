"""``python -m kowalevski_cas``: the same as the command ``kowalevski-cas``."""

import sys

from kowalevski_cas.cli import main

sys.exit(main())
