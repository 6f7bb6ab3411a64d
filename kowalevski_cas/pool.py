"""Independent tasks: done here, in processes, or on a cluster; the results come in their order.

Tasks go out in batches that are worth the way. A worker that dies costs its batch, which is done
again. Results are kept in a file, if one is given, so that interrupted work goes on from there.
"""

from __future__ import annotations

import pickle
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from functools import cached_property, partial
from hashlib import sha256
from importlib import import_module
from io import BytesIO
from itertools import chain, islice
from math import inf
from pathlib import Path
from time import perf_counter
from typing import Any, TypeVar

from kowalevski_cas import __version__
from kowalevski_cas.limits import ProcessDied
from kowalevski_cas.processes import each

Item = TypeVar("Item")
Result = TypeVar("Result")

BATCH = 0.1
"""Seconds that a batch of tasks should take at least."""

SHARES = 4
"""Of what is left, a process takes this part of its share at most."""

PATIENCE = 5
"""Seconds in which a scheduler has to answer, and to have a worker."""

Key = bytes | int
Found = dict[Key, tuple[Any, Exception | None]]
"""Results of tasks, or the errors with which they ended."""


class Pool:
    """Where tasks are done.

    Args:
        jobs: how many processes work at once; one is this process itself.
        scheduler: the address of a Dask cluster that works instead, if there is one.
        file: where results are kept, until the work is done and :meth:`forget` is called.
    """

    def __init__(self, jobs: int = 1, scheduler: str = "", file: Path | None = None) -> None:
        self.jobs, self.scheduler, self.file = jobs, scheduler, file
        self._size = 1
        self._number = 0
        self._unsaved: Found = {}
        self._seconds = 0.0

    @cached_property
    def _content(self) -> Found:
        """What the file had at first."""
        return {} if self.file is None else _read(self.file)

    def map(self, work: Callable[[Item], Result], items: Iterable[Item]) -> Iterator[Result]:
        """The results of the work on every item, in their order; so is the first error raised.

        What is sent elsewhere has to be plain data, and the work a function of a module, or an
        object of plain data. Items are taken when they are needed.

        Raises:
            ProcessDied: two workers have died on a batch, or no cluster answers.
        """
        source, found = iter(items), dict(self._content)
        for item in source:  # what is known comes before anything is begun
            if (key := self._key(work, item)) not in found:
                source = chain([item], source)
                break
            yield found[key][0]
        waiting, late = deque[Key](), list[Exception]()
        left = len(items) if isinstance(items, Sequence) else inf
        batches = self._batches(source, partial(self._key, work), found, waiting, late, left)
        for seconds, results in self._run_batches(partial(_run_batch, work), batches):
            found.update(results)
            self._keep(seconds, results)
            yield from _in_order(waiting, found)
        yield from _in_order(waiting, found)
        for error in late:
            raise error

    def _batches(
        self,
        items: Iterator[Item],
        key: Callable[[Item], Key],
        found: Found,
        waiting: deque[Key],
        late: list[Exception],
        left: float,
    ) -> Iterator[dict[Key, Item]]:
        """What is not found so far, and all that is waited for; an error of the items is late.

        ``left`` is how many there are: no batch is so large that all others wait for it.
        """
        batch: dict[Key, Item] = {}
        try:
            for item in items:
                waiting.append(own := key(item))
                left -= 1
                if own not in found:
                    batch[own] = item
                if len(batch) >= min(self._size, 1 + left / (SHARES * self.jobs)):
                    yield batch
                    batch = {}
        except Exception as error:
            late.append(error)
        if batch:
            yield batch

    def forget(self) -> None:
        """Take away what was kept: the work is done."""
        if self.file is not None:
            self.file.unlink(missing_ok=True)

    def _run_batches(
        self,
        work: Callable[[dict[Key, Item]], tuple[float, Found]],
        batches: Iterator[dict[Key, Item]],
    ) -> Iterator[tuple[float, Found]]:
        """What comes of batches, as it comes, and how long each took."""
        if self.scheduler:
            yield from _on_cluster(self.scheduler, work, batches)
        elif self.jobs > 1:
            yield from each(work, batches, self.jobs, ordered=False)
        else:
            yield from map(work, batches)

    def _key(self, work: object, item: object) -> Key:
        """What a task is known by: what it consists of, if its result is kept."""
        if self.file is None:
            self._number += 1
            return self._number
        stream = BytesIO()
        pickler = pickle.Pickler(stream)
        pickler.fast = True  # equal data are equal bytes, whether or not parts are the same object
        pickler.dump((work, item))
        return sha256(stream.getvalue()).digest()

    def _keep(self, seconds: float, results: Found) -> None:
        """Write results to the file, as soon as they were worth a batch."""
        if seconds < BATCH and (self.scheduler or self.jobs > 1):
            self._size *= 2
        self._seconds += seconds
        self._unsaved.update((k, both) for k, both in results.items() if both[1] is None)
        if self.file is not None and self._seconds >= BATCH:
            with suppress(OSError):  # without a place to keep it, it is not kept
                self.file.parent.mkdir(parents=True, exist_ok=True)
                with self.file.open("ab") as file:
                    file.write(pickle.dumps(self._unsaved))
            self._unsaved, self._seconds = {}, 0.0


HERE = Pool()
"""The pool that is this process."""


def _run_batch(
    work: Callable[[Item], Result], batch: dict[Key, Item]
) -> tuple[float, dict[Key, tuple[Result | None, Exception | None]]]:
    """The results of a batch up to the first error, and how long it took."""
    found: Found = {}
    start = perf_counter()
    for key, item in batch.items():
        try:
            found[key] = work(item), None
        except Exception as error:
            found[key] = None, error
            break
    return perf_counter() - start, found


def _in_order(waiting: deque[Key], found: Found) -> Iterator[Any]:
    """What is there of the results that come next."""
    while waiting and waiting[0] in found:
        result, error = found[waiting.popleft()]
        if error is not None:
            raise error
        yield result


def _read(file: Path) -> Found:
    """What was kept; a last part that was torn by the interruption is taken away."""
    found: Found = {}
    with suppress(OSError), file.open("r+b") as stream:
        whole = 0
        try:
            while True:
                found.update(pickle.load(stream))
                whole = stream.tell()
        except Exception:  # the end, or anything that damaged data can be taken for
            stream.truncate(whole)
    return found


def _on_cluster(
    address: str,
    work: Callable[[dict[Key, Item]], tuple[float, Found]],
    batches: Iterator[dict[Key, Item]],
) -> Iterator[tuple[float, Found]]:
    """What comes of batches, by the workers of a Dask cluster, of which each has one more ahead."""
    distributed = import_module("distributed")
    try:
        client = distributed.Client(address, timeout=PATIENCE)
    except (OSError, ValueError) as error:
        raise ProcessDied(f"no Dask scheduler answers at {address}: {error}") from None
    with client:
        _check_workers(client, address)

        def submit(number: int) -> list[Any]:
            chosen = (pickle.dumps((work, batch)) for batch in islice(batches, number))
            return [client.submit(_run_pickled, batch, pure=False) for batch in chosen]

        running = distributed.as_completed(submit(2 * max(1, sum(client.nthreads().values()))))
        for future in running:
            try:
                yield pickle.loads(future.result())
            except distributed.KilledWorker as error:
                raise ProcessDied(f"workers of the cluster have died: {error}") from None
            running.update(submit(1))


def _check_workers(client: Any, address: str) -> None:
    """Raise :class:`ProcessDied` if a cluster has no workers, or some that lack this package."""

    def version() -> (
        str
    ):  # nothing of the package can be named there before it is known to be there
        try:
            from kowalevski_cas import __version__
        except ImportError:
            return "no version"
        return __version__

    try:
        client.wait_for_workers(1, timeout=PATIENCE)
    except TimeoutError:
        said = f"the scheduler at {address} has no workers: begin some with `dask worker {address}`"
        raise ProcessDied(said) from None
    for worker, found in client.run(version).items():
        if found != __version__:
            raise ProcessDied(
                f"the worker at {worker} has {found} of kowalevski-cas, not {__version__}: "
                f"pip install 'kowalevski-cas[cluster]=={__version__}' there"
            )


def _run_pickled(data: bytes) -> bytes:
    """A batch, done where it was sent."""
    work, batch = pickle.loads(data)
    return pickle.dumps(work(batch))
