"""How long searches take, and how much memory, against the rows of ``searches.json``.

With ``--write`` the rows are committed anew.
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from random import Random

from benchmarks.rows import compare, measure_rows


def cycle(size: int) -> str:
    """The lattice of Volterra."""
    names = [f"x_{{{k}}}" for k in range(1, size + 1)]
    return r",\ ".join(
        rf"\dot {x}={x}({names[(k + 1) % size]}-{names[k - 1]})" for k, x in enumerate(names)
    )


def chain(size: int) -> str:
    """The open lattice of Toda, in the variables of Flaschka."""
    rates = [rf"\dot a_{k}=a_{k}(b_{k + 1}-b_{k})" for k in range(1, size)]
    for k in range(1, size + 1):
        terms = [f"+2a_{k}^2" if k < size else "", f"-2a_{k - 1}^2" if k > 1 else ""]
        rates.append(rf"\dot b_{k}=" + "".join(terms).removeprefix("+"))
    return r",\ ".join(rates)


def dense(size: int) -> str:
    """A field with all quadratic terms, and coefficients from −5 to 5 that are not zero."""
    random, names = Random(1), [f"x_{k}" for k in range(1, size + 1)]
    pairs = [names[i] + names[j] for i in range(size) for j in range(i, size)]
    numbers = [n for n in range(-5, 6) if n]
    return r",\ ".join(
        rf"\dot {x}=" + "".join(f"{random.choice(numbers):+d}{pair}" for pair in pairs)
        for x in names
    ).replace("=+", "=")


KOWALEVSKI = r"2\dot p=qr,\ 2\dot q=-pr-z,\ \dot r=y,\ \dot x=ry-qz,\ \dot y=pz-rx,\ \dot z=qx-py"
TWO_FIELDS = (
    r"2\dot p=qr+f_3,\ 2\dot q=-pr-e_3,\ \dot r=e_2-f_1,\ \dot e_1=re_2-qe_3,\ "
    r"\dot e_2=pe_3-re_1,\ \dot e_3=qe_1-pe_2,\ \dot f_1=rf_2-qf_3,\ "
    r"\dot f_2=pf_3-rf_1,\ \dot f_3=qf_1-pf_2"
)
LORENZ = r"\dot x=s(y-x),\ \dot y=rx-y-xz,\ \dot z=xy-bz"

SYSTEMS = {
    "two_fields": TWO_FIELDS, "kowalevski": KOWALEVSKI, "lorenz": LORENZ, "toda": chain(5),
    "dense": dense(5), "volterra20": cycle(20), "volterra30": cycle(30),
}  # fmt: skip

SEARCHES = (
    "integrals two_fields.py --weighted --degree 8",
    "integrals two_fields.py --degree 7",
    "integrals two_fields.py --degree 8",
    "integrals toda.py --degree 7",
    "integrals toda.py --degree 8",
    "integrals kowalevski.py --degree 10",
    "integrals dense.py --degree 8",
    "integrals dense.py --degree 9",
    "integrals volterra30.py --degree 3",
    "integrals volterra20.py --degree 4",
    "darboux lorenz.py --degree 6",
    "darboux lorenz.py --degree 7",
    "darboux lorenz.py --degree 6 --special",
    "darboux kowalevski.py --degree 5",
)


def main() -> None:
    """Measure, and compare."""
    with tempfile.TemporaryDirectory() as folder:
        for name, motion in SYSTEMS.items():
            text = f'from kowalevski_cas import System\n\nsystem = System(r"{motion}")\n'
            (Path(folder) / f"{name}.py").write_text(text, encoding="utf-8")
        commands = [f"kowalevski-cas find {one} --jobs 1 --timeout 600" for one in SEARCHES]
        compare(measure_rows(commands, folder), Path(__file__).with_suffix(".json"))


if __name__ == "__main__":
    main()
