"""The program ``lacuna``: where it is, and a command of it."""

from __future__ import annotations

import logging
import os
import queue
import shutil
import signal
import subprocess
import threading
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Optional, Union

from ._messages import read_line
from .errors import BadInputError, CommandFailedError, LacunaError, Problem, ProgramNotFoundError, StoppedError
from .progress import Progress, ProgressCallback

PathLike = Union[str, "os.PathLike[str]"]

#: Name of the environment variable that says where the program is.
VARIABLE = "LACUNA"

_log = logging.getLogger("lacuna")
_BAD_INPUT = 2
_STOPPED = 75


def find_program(program: Optional[PathLike] = None) -> str:
    """Where the program is: `program`, else the environment variable ``LACUNA``, else ``lacuna`` on the PATH.

    Parameters
    ----------
    program : path, optional
        The program itself, such as ``build/release/bin/lacuna``, or its name on the PATH.

    Returns
    -------
    str
        Absolute path of the program.

    Raises
    ------
    ProgramNotFoundError
        It is not there, or is a file that cannot be run. The message says where it was looked for, and what to do.
    """
    if program is not None:
        return _named(os.fspath(program), "the argument program")
    named = os.environ.get(VARIABLE)
    if named:
        return _named(named, f"the environment variable {VARIABLE}")
    found = shutil.which("lacuna")
    if found:
        return os.path.abspath(found)
    raise ProgramNotFoundError(
        f"the program lacuna is not on the PATH; set the environment variable {VARIABLE} to it, as in "
        f"{VARIABLE}=build/release/bin/lacuna, pass program=..., or build it with ./bootstrap build"
    )


def _named(name: str, source: str) -> str:
    path = Path(name).expanduser()
    if path.is_dir():
        raise ProgramNotFoundError(f"{name}: is a folder; let {source} name the program in it, {path / 'lacuna'}")
    found = shutil.which(str(path))
    if found:
        return os.path.abspath(found)
    what = "cannot be run; check its permissions" if path.exists() else "there is no such program"
    raise ProgramNotFoundError(f"{name}: {what}; {source} must name the program lacuna, such as build/release/bin/lacuna")


@dataclass(frozen=True)
class Finished:
    """What a command printed.

    Attributes
    ----------
    output : bytes
        Standard output, exactly.
    exit_code : int
        0, or one of those that the caller said it takes.
    notes : tuple of str
        Lines on standard error that are neither progress nor errors.
    failure : str or None
        What the program said of an exit code other than 0. None: nothing.
    """

    output: bytes
    exit_code: int = 0
    notes: tuple[str, ...] = ()
    failure: Optional[str] = None


@dataclass
class _Said:
    """What has come on standard error so far."""

    problems: list[Problem] = field(default_factory=list)
    failures: list[str] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    def take(self, line: str) -> Optional[Progress]:
        kind, content = read_line(line)
        if isinstance(content, Progress):
            return content
        if isinstance(content, Problem):
            self.problems.append(content)
        elif kind == "failure":
            self.failures.append(content)
        elif content.strip():
            self.notes.append(content)
            _log.info("%s", content)
        return None


class Program:
    """The program ``lacuna``, at a place.

    Parameters
    ----------
    program : path, optional
        Where it is; else it is looked for (`find_program`).

    Attributes
    ----------
    path : str
        Absolute path of the program.
    """

    def __init__(self, program: Optional[PathLike] = None) -> None:
        self.path = find_program(program)

    def __repr__(self) -> str:
        return f"Program({self.path!r})"

    def version(self) -> str:
        """The program's version, such as ``0.1.0``."""
        return self.run(["--version"]).output.decode().strip()

    def run(
        self,
        arguments: Sequence[str],
        *,
        folder: Optional[PathLike] = None,
        progress: Optional[ProgressCallback] = None,
        also_accept: Sequence[int] = (),
    ) -> Finished:
        """Runs a command and waits for its end.

        An interrupt (Ctrl-C, the stop button of a notebook) reaches the program as Ctrl-C does on a terminal: it ends
        where everything is in order, what it has stored is kept, and `KeyboardInterrupt` goes on. A second interrupt
        ends it at once. So does an exception of `progress`.

        Parameters
        ----------
        arguments : sequence of str
            The command and its options, such as ``["fit", "rig.toml", "--json"]``.
        folder : path, optional
            Folder in which it runs. Default: the current one.
        progress : callable, optional
            Called with a `Progress`, in the calling thread.
        also_accept : sequence of int, optional
            Exit codes besides 0 that are no error where there is output.

        Raises
        ------
        BadInputError, CommandFailedError, StoppedError
            The program ended with exit code 2, 1 (or by a signal), or 75.
        ProgramNotFoundError
            The program cannot be run any more.
        """
        command = (self.path, *arguments)
        said = _Said()
        process = self._start(command, folder)
        try:
            output = _Collected(process.stdout)
            for line in _lines_of(process.stderr):
                report = said.take(line)
                if report is not None and progress is not None:
                    progress(report)
            content = output.all()
            exit_code = process.wait()
        except BaseException:
            _stop(process)
            raise
        if exit_code != 0 and not (content and exit_code in also_accept):
            raise _error_of(exit_code, command, said)
        failure = "\n".join(said.failures) or None
        return Finished(content, exit_code, tuple(said.notes), failure)

    def _start(self, command: tuple[str, ...], folder: Optional[PathLike]) -> subprocess.Popen[bytes]:
        environment = {**os.environ, "LACUNA_MESSAGES": "json"}
        try:
            # A process group of its own: Ctrl-C on the terminal comes to Python alone, which passes it on once.
            return subprocess.Popen(
                command,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                cwd=folder,
                env=environment,
                start_new_session=True,
            )
        except FileNotFoundError as error:
            if folder is not None and not os.path.isdir(folder):
                raise BadInputError(f"{os.fspath(folder)}: there is no such folder") from error
            raise ProgramNotFoundError(f"{self.path}: is not there any more; build it again") from error
        except OSError as error:
            raise ProgramNotFoundError(f"{self.path}: cannot be run: {error.strerror}") from error


class _Collected:
    """All bytes of a stream, read by a thread, so that neither stream of a program fills up."""

    def __init__(self, stream: Optional[IO[bytes]]) -> None:
        assert stream is not None
        self._parts: list[bytes] = []
        self._stream = stream
        self._thread = threading.Thread(target=self._read, daemon=True)
        self._thread.start()

    def _read(self) -> None:
        with self._stream:
            self._parts.append(self._stream.read())

    def all(self) -> bytes:
        self._thread.join()
        return b"".join(self._parts)


def _lines_of(stream: Optional[IO[bytes]]) -> Iterator[str]:
    """Lines as they come. A thread reads them: the program never waits for whoever takes them."""
    assert stream is not None
    source = stream
    lines: queue.SimpleQueue[Optional[bytes]] = queue.SimpleQueue()

    def read() -> None:
        with source:
            for line in source:
                lines.put(line)
        lines.put(None)

    threading.Thread(target=read, daemon=True).start()
    while True:
        line = lines.get()
        if line is None:
            return
        yield line.decode(errors="replace").rstrip("\n")


def _stop(process: subprocess.Popen[bytes]) -> None:
    """As Ctrl-C does; where it is asked for once more, at once."""
    for number in (signal.SIGINT, signal.SIGINT, signal.SIGKILL):
        process.send_signal(number)
        try:
            process.wait()
            return
        except KeyboardInterrupt:
            continue
    process.wait()


def _error_of(exit_code: int, command: tuple[str, ...], said: _Said) -> LacunaError:
    problems = tuple(said.problems)
    message = "\n".join([str(problem) for problem in problems] + said.failures) or "\n".join(said.notes)
    if not message and exit_code < 0:
        message = f"the program was ended by {_signal_name(-exit_code)}; what it had stored is kept"
    kinds: dict[int, type[LacunaError]] = {_BAD_INPUT: BadInputError, _STOPPED: StoppedError}
    kind = kinds.get(exit_code, CommandFailedError)
    return kind(
        message or f"the program ended with exit code {exit_code} and said nothing",
        problems=problems,
        exit_code=exit_code,
        command=command,
        notes=tuple(said.notes),
    )


def _signal_name(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"
