"""What a corpus of papers costs on a cluster, from its pieces, and whether a run has that slope.

The pieces are the work for a paper, the bytes that go to a worker and come back, and what the
scheduler of Dask takes for a task that does nothing. From these the time for a corpus on so many
cores follows, and from how many cores on the scheduler is what has to be waited for. Synthetic
papers, whole ones with equations of motion, integrals and now and then a misprint, are then audited
on a local cluster, fewer and more of them, by one worker and by two.
"""

from __future__ import annotations

import argparse
import json
import os
import pickle
from collections.abc import Callable, Sequence
from functools import partial
from importlib import import_module
from random import Random
from statistics import linear_regression, median
from time import perf_counter, process_time
from typing import NamedTuple

from kowalevski_cas.audit.reading import ReadingSession, audit_reading
from kowalevski_cas.pool import BATCH, Pool
from kowalevski_cas.reading import read
from kowalevski_cas.source.text import Source
from kowalevski_cas.verify.outcome import Verdict
from study.published import PUBLISHED

CORPUS = 100_000
"""The papers for which the cost is said."""

CLAIMS = 12
"""Of a synthetic paper."""

MISPRINTS = 0.05
"""The share of them with a token too many."""

SIZES = (50, 100, 200)
"""The numbers of papers of the runs."""

TASKS = 2_000
"""Tasks that do nothing."""

TIMEOUT = 10.0

SYSTEMS = [one for one in PUBLISHED if one.question == "integrals" and one.known]


class Audited(NamedTuple):
    """What comes back of a paper: the work for it, and its verdicts with their certificates."""

    seconds: float
    verdicts: tuple[str, ...]
    certificates: tuple[str, ...]


def paper(seed: int) -> str:
    """A paper: equations of motion, and combinations of their integrals."""
    random = Random(seed)
    system = random.choice(SYSTEMS)
    lines = [r"\documentclass{article}\begin{document}", "The equations of motion are"]
    lines += [rf"\begin{{equation}}{system.motion}.\end{{equation}}"]
    for number in range(1, CLAIMS + 1):
        terms = [rf"{random.randint(2, 99)}({one})" for one in system.known]
        wrong = f"+{random.choice(variables(system.motion))}^3" * (random.random() < MISPRINTS)
        tex = rf"F_{{{number}}}={'+'.join(terms)}{wrong}"
        lines += ["A first integral is", rf"\begin{{equation}}{tex}.\end{{equation}}"]
    return "\n".join([*lines, r"\end{document}"])


def variables(motion: str) -> list[str]:
    """What moves."""
    return [row.split("=")[0].split(r"\dot ")[1] for row in motion.split(r",\quad ")]


def audit(text: str) -> Audited:
    """What is said of a paper, and how long a processor worked for it."""
    start, before = process_time(), os.times()
    source = Source("paper.tex", text)
    found = audit_reading(ReadingSession(read(source), ["flint"], timeout=TIMEOUT))
    outcomes = [one for one in found.session.outcomes.values()]
    after = os.times()
    below = sum(after[2:4]) - sum(before[2:4])
    return Audited(
        process_time() - start + below,
        tuple(outcome.verdict for outcome in outcomes),
        tuple(outcome.certificate for outcome in outcomes),
    )


def stay(core: int) -> None:
    """Have all threads of this process, and what they begin, stay on one core."""
    for thread in os.listdir("/proc/self/task"):
        os.sched_setaffinity(int(thread), {core})


def nothing(number: int) -> int:
    """A task that does nothing."""
    return number


def on_cluster(work: Callable[[Pool], object], workers: int) -> float:
    """The seconds of work on a local cluster of warm workers, each on a core of its own."""
    distributed = import_module("distributed")
    with (
        distributed.LocalCluster(
            n_workers=workers, threads_per_worker=1, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        for core, address in enumerate(client.scheduler_info()["workers"]):
            client.run(stay, core, workers=[address])
        pool = Pool(scheduler=cluster.scheduler_address)
        [*pool.map(audit, [paper(0)] * workers)]
        start = perf_counter()
        work(pool)
        return perf_counter() - start


def seconds_of_a_task() -> float:
    """What the scheduler takes for a task of its own, sent as :class:`Pool` sends batches."""
    distributed = import_module("distributed")
    with (
        distributed.LocalCluster(
            n_workers=1, threads_per_worker=1, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        client.gather(client.map(nothing, range(100), pure=False))
        start = perf_counter()
        client.gather(client.map(nothing, range(TASKS), pure=False))
        return (perf_counter() - start) / TASKS


def measure(sizes: Sequence[int]) -> dict[str, object]:
    """The pieces, and the runs."""
    papers = [paper(seed) for seed in range(max(sizes))]
    alone = [*Pool().map(audit, papers[: min(sizes)])]
    sent = median(len(pickle.dumps(text)) for text in papers)
    task = seconds_of_a_task()
    seconds = sum(one.seconds for one in alone) / len(alone)
    runs = []
    for workers in range(1, (os.cpu_count() or 1) + 1):
        times = []
        for size in sizes:
            work = partial(lambda pool, size: [*pool.map(audit, papers[:size])], size=size)
            times.append(on_cluster(work, workers))
        runs.append(
            {
                "workers": workers,
                "papers": [*sizes],
                "seconds": [round(one, 1) for one in times],
                "slope": round(linear_regression(sizes, times).slope, 4),
                "expected": round(seconds / workers + task * seconds / max(seconds, BATCH), 4),
            }
        )
    verdicts = [verdict for one in alone for verdict in one.verdicts]
    return {
        "papers": len(alone),
        "claims": len(verdicts),
        "proved": verdicts.count(Verdict.PROVED),
        "refuted": verdicts.count(Verdict.REFUTED),
        "CPU seconds of a paper": round(seconds, 4),
        "claims per second and core": round(len(verdicts) / len(alone) / seconds, 1),
        "bytes to a worker": round(sent),
        "bytes back": round(median(len(pickle.dumps(one)) for one in alone)),
        "seconds of the scheduler for a task": round(task, 5),
        "core hours of the corpus": round(CORPUS * seconds / 3600, 1),
        "cores at which the scheduler is the bound": round(max(seconds, BATCH) / task),
        "runs": runs,
    }


def main() -> None:
    """Measure, and print what was found."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--papers", type=int, nargs="+", default=[*SIZES], metavar="N")
    print(json.dumps(measure(sorted(parser.parse_args().papers)), indent=1))


if __name__ == "__main__":
    main()
