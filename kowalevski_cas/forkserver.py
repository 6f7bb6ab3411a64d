"""Work for a process that has threads, in one that has none: copies can be made of that.

A fork copies the locks of a process and not the threads that would open them: the copy of a process
with threads may wait forever. So a fork server is begun beside it, once, as a fresh Python; each
work is sent there, and done in a copy of the server.
"""

from __future__ import annotations

import atexit
import os
import pickle
import signal
import socket
import subprocess
import sys
from collections.abc import Callable, Generator, Iterable
from contextlib import suppress
from functools import cache
from importlib import import_module
from io import BufferedRWPair
from typing import Any, TypeVar

from kowalevski_cas.limits import ProcessDied

Answer = TypeVar("Answer")

Take = Callable[[int], Any]
Heard = Callable[..., None]
Work = Callable[[Take, Heard], Iterable[Answer]]
"""What yields answers, and meanwhile takes items and tells words."""


def has_threads() -> bool:
    """Whether this process has more than one thread that runs Python.

    Threads of compiled libraries do not count: those of BLAS end before a copy is made.
    """
    return len(sys._current_frames()) > 1


def answers(work: Work[Answer], take: Take, heard: Heard) -> Generator[Answer, None, None]:
    """What ``work(take, heard)`` yields, elsewhere: ``take`` and ``heard`` are called here.

    If this ends early, so does the work. Raises :class:`ProcessDied` if it ends without a word.
    """
    here, there = socket.socketpair()
    with here, here.makefile("rwb") as stream:
        with there:
            _send(there)
        pid = pickle.load(stream)
        try:
            stream.write(_pickle_whole(work))
            stream.flush()
            while (message := _receive(stream))[0] != "end":
                match message:
                    case "take", number:
                        pickle.dump(take(number), stream)
                        stream.flush()
                    case "heard", words:
                        heard(*words)
                    case "answer", answer:
                        yield answer
                    case "error", error:
                        raise error
        finally:
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGTERM)
            with suppress(OSError):
                while here.recv(1 << 16):  # until it has ended, with those that it has begun
                    pass


def _receive(stream: BufferedRWPair) -> tuple[Any, ...]:
    try:
        message: tuple[Any, ...] = pickle.load(stream)
    except (EOFError, ConnectionError):
        raise ProcessDied("the process that shared out the work has died") from None
    return message


def _pickle_whole(work: object) -> bytes:
    """The work as bytes; what no other process could import is sent whole."""
    import cloudpickle

    for name, module in [*sys.modules.items()]:
        if "." not in name and name != "__main__" and getattr(module, "__spec__", 0) is None:
            cloudpickle.register_pickle_by_value(module)
    surroundings = os.getcwd(), dict(os.environ), sys.path
    return pickle.dumps(surroundings) + bytes(cloudpickle.dumps(work))


# -- the server --------------------------------------------------------------------------


def _send(connection: socket.socket) -> None:
    """Give the server a connection, and where to print; another server is begun if it has died."""
    for _ in range(2):
        try:
            socket.send_fds(_server(), [b"."], [connection.fileno(), 1, 2])
            return
        except OSError:
            _server.cache_clear()
    raise ProcessDied("no process can be begun that shares out the work")


@cache
def _server() -> socket.socket:
    """The socket of a fork server; it ends with this process."""
    here, there = socket.socketpair()
    known = sorted(name for name in sys.modules if name.startswith(f"{__package__}."))
    code = (
        f"import sys; sys.path[:] = {sys.path!r}; "
        f"from {__name__} import _serve; _serve({there.fileno()}, {known!r})"
    )
    with there:
        server = subprocess.Popen(
            [sys.executable, "-c", code],
            stdin=subprocess.DEVNULL,
            pass_fds=[there.fileno()],
            start_new_session=True,
        )

    @atexit.register
    def end() -> None:
        here.close()
        server.kill()
        server.wait()

    return here


def _serve(number: int, known: Iterable[str]) -> None:
    """Make a copy of this process for each connection, until nobody can ask any more."""
    for name in known:
        with suppress(ImportError):
            import_module(name)
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # nobody asks how a copy has ended
    control = socket.socket(fileno=number)
    while True:
        data, numbers, _, _ = socket.recv_fds(control, 1, 3)
        if not data:
            return
        with socket.socket(fileno=numbers[0]) as connection:
            if os.fork() == 0:
                control.close()
                for standard, number in enumerate(numbers[1:], 1):  # what is printed is seen there
                    os.dup2(number, standard)
                signal.signal(signal.SIGCHLD, signal.SIG_DFL)
                _work(connection)
                os._exit(0)
        for number in numbers[1:]:
            os.close(number)


def _work(connection: socket.socket) -> None:
    """Do the work that comes by a connection."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    with suppress(KeyboardInterrupt, ConnectionError), connection.makefile("rwb") as stream:

        def send(*message: object) -> None:
            stream.write(pickle.dumps(message))
            stream.flush()

        def take(number: int) -> object:
            send("take", number)
            return pickle.load(stream)

        pickle.dump(os.getpid(), stream)
        stream.flush()
        try:
            folder, environment, path = pickle.load(stream)
            os.chdir(folder)
            os.environ.clear()
            os.environ.update(environment)
            sys.path[:] = path
            for answer in pickle.load(stream)(take, lambda *words: send("heard", words)):
                send("answer", answer)
            send("end")
        except (EOFError, ConnectionError):
            raise ConnectionError from None  # nobody asks any more
        except Exception as error:
            send("error", error)
