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
from threading import Lock
from typing import Any, TypeVar

from kowalevski_cas.limits import LENGTH, ProcessDied, end_with

Answer = TypeVar("Answer")

Take = Callable[[int], Any]
Heard = Callable[..., None]
Work = Callable[[Take, Heard], Iterable[Answer]]
"""What yields answers, and meanwhile takes items and tells words."""


def answers(work: Work[Answer], take: Take, heard: Heard) -> Generator[Answer, None, None]:
    """What ``work(take, heard)`` yields, elsewhere: ``take`` and ``heard`` are called here.

    If this ends early, so does the work. Raises :class:`ProcessDied` if it ends without a word.
    """
    here, there = socket.socketpair()
    with here, here.makefile("rwb") as stream:
        with there:
            _send(there)
        pid, runs = _receive(stream)[0], True
        try:
            stream.write(_pickle_whole(work))
            stream.flush()
            while runs:
                match _receive(stream):
                    case "take", number:
                        pickle.dump(take(number), stream)
                        stream.flush()
                    case "heard", words:
                        heard(*words)
                    case "answer", answer:
                        yield answer
                    case "end", error:
                        runs = False
                        if error is not None:
                            raise error
        finally:
            if runs:
                _end(pid, here)


def _end(pid: int, connection: socket.socket) -> None:
    """End the work, with the processes that it has begun."""
    with suppress(ProcessLookupError):
        os.kill(pid, signal.SIGTERM)
    with suppress(OSError):
        while connection.recv(1 << 16):  # until nobody writes any more
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


class _Server:
    """A fork server; it ends with this process."""

    def __init__(self) -> None:
        self.control, there = socket.socketpair()
        code = (
            f"import sys; sys.path[:] = {sys.path!r}; "
            f"from {__name__} import _serve; _serve({there.fileno()})"
        )
        with there:
            self.process = subprocess.Popen(
                [sys.executable, "-c", code],
                stdin=subprocess.DEVNULL,
                pass_fds=[there.fileno()],
                start_new_session=True,
            )
        self.known = set[str]()
        """The modules that it was told to import, once and not in each copy."""
        atexit.register(self.end)

    def send(self, connection: socket.socket) -> None:
        """Give it a connection, where to print, and what this process has imported since."""
        names = [name for name in [*sys.modules] if name.startswith(f"{__package__}.")]
        new = {"cloudpickle", *names} - self.known
        data = pickle.dumps(sorted(new))
        length = len(data).to_bytes(LENGTH)
        socket.send_fds(self.control, [length], [connection.fileno(), 1, 2])
        self.control.sendall(data)
        self.known |= new

    def end(self) -> None:
        self.control.close()
        self.process.kill()
        self.process.wait()


_server = cache(_Server)
_sending = Lock()


def _send(connection: socket.socket) -> None:
    """Give the server a connection; another server is begun if it has died."""
    for _ in range(2):
        try:
            with _sending:
                return _server().send(connection)
        except OSError:
            _server.cache_clear()
    raise ProcessDied("no process can be begun that shares out the work")


def _serve(number: int) -> None:
    """Make a copy of this process for each connection, until nobody can ask any more."""
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # nobody asks how a copy has ended
    control, here = socket.socket(fileno=number), os.getpid()
    while True:
        length, numbers, _, _ = socket.recv_fds(control, LENGTH, 3)
        data = control.recv(int.from_bytes(length), socket.MSG_WAITALL) if length else b""
        if not data:
            return
        for name in pickle.loads(data):
            with suppress(ImportError):
                import_module(name)
        with socket.socket(fileno=numbers[0]) as connection:
            if os.fork() == 0:
                try:
                    end_with(here)
                    control.close()
                    for standard, number in enumerate(numbers[1:], 1):  # it is printed there
                        os.dup2(number, standard)
                    signal.signal(signal.SIGCHLD, signal.SIG_DFL)
                    _work(connection)
                finally:
                    os._exit(0)  # also if it is ended as it ends
        for number in numbers[1:]:
            os.close(number)


def _work(connection: socket.socket) -> None:
    """Do the work that comes by a connection."""
    with suppress(KeyboardInterrupt, ConnectionError), connection.makefile("rwb") as stream:
        signal.signal(signal.SIGTERM, signal.default_int_handler)

        def send(*message: object) -> None:
            stream.write(pickle.dumps(message))
            stream.flush()

        def take(number: int) -> object:
            send("take", number)
            return pickle.load(stream)

        send(os.getpid())
        try:
            folder, environment, path = pickle.load(stream)
            os.chdir(folder)
            os.environ.clear()
            os.environ.update(environment)
            sys.path[:] = path
            for answer in pickle.load(stream)(take, lambda *words: send("heard", words)):
                send("answer", answer)
            send("end", None)
        except (EOFError, ConnectionError):
            raise ConnectionError from None  # nobody asks any more
        except Exception as error:
            send("end", error)
