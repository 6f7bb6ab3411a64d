"""One run of the growing work: the processor time from the start to each step.

It is the program ``python -m study.growth ARITHMETIC CLAIM STEPS``.
"""

import sys

from kowalevski_cas.algebra import POINTS, load
from study.growth.work import growth, steps

if __name__ == "__main__":
    arithmetic, claim, most = sys.argv[1:]
    work = growth(claim, None if arithmetic in POINTS else load(arithmetic))
    for k, seconds in enumerate(steps(work, int(most)), 1):
        print(f"step {k} {seconds:.6f}", flush=True)
