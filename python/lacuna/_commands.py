"""An experiment file, the options that commands on it share, and what is stored of it."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Optional, TypeVar, Union

from . import _decode
from ._arguments import Paths, file_argument, option, path_list, repeated, toml_value
from .database import Database, Rows
from .program import Finished, PathLike, Program
from .progress import ProgressCallback
from .results import Check
from .traces import Traces

T = TypeVar("T")

#: Of the program: stopped before its end.
STOPPED = 75


class ExperimentCommands:
    """The program, a folder, an experiment file in it, and options. `Experiment` describes the parameters.

    Attributes
    ----------
    path : str
        The experiment file, as it was named.
    folder : pathlib.Path
        Folder in which commands run, absolute.
    program : Program
        The program.
    """

    def __init__(
        self,
        path: PathLike,
        *,
        database: Optional[PathLike],
        overrides: Optional[Mapping[str, object]],
        plugin_path: Paths,
        n_jobs: int,
        random_state: Optional[int],
        evaluation_limit: Optional[float],
        folder: Optional[PathLike],
        program: Union[PathLike, Program, None],
        progress: Optional[ProgressCallback],
    ) -> None:
        self.path = os.fspath(path)
        self.folder = Path(os.path.abspath(folder if folder is not None else "."))
        self.program = program if isinstance(program, Program) else Program(program)
        self._database = None if database is None else os.fspath(database)
        self._progress = progress
        self._known: Optional[tuple[tuple[int, int], Check]] = None
        settings = [f"{key}={toml_value(value)}" for key, value in (overrides or {}).items()]
        self._of_model = [
            *repeated("--set", settings),
            *repeated("--plugin-path", path_list(plugin_path)),
            *option("--evaluation-limit", evaluation_limit),
        ]
        self._of_work = [
            *option("--threads", None if n_jobs == -1 else n_jobs),
            *option("--seed", random_state),
        ]

    def check(self) -> Check:
        """Reads the experiment file and everything it names, and simulates nothing.

        Raises
        ------
        BadInputError
            Something is wrong. `problems` has all places at once.
        """
        return decoded(Check, self._run(["check", file_argument(self.path), "--json"], self._of_model))

    @property
    def database(self) -> Database:
        """The database with the results of this experiment."""
        name = self._database if self._database is not None else self._read().database
        return Database(self.folder / name, program=self.program)

    def traces(self, *, revision: Optional[int] = None) -> Traces:
        """What was measured, commanded and predicted, by trial. Call `compare` first.

        Parameters
        ----------
        revision : int, optional
            Revision of the model that predicts. Default: the newest one that was compared.
        """
        return self.database.traces(experiment=self._read().experiment, revision=revision)

    def sql(self, statement: str) -> Rows:
        """The rows that a SQL statement gives of the experiment's database (`Database.sql`)."""
        return self.database.sql(statement)

    def report(self, path: Optional[PathLike] = None, *, robots: bool = True) -> Path:
        """Writes the database as a page for any browser, and returns its path (`Database.report`)."""
        return self.database.report(None if path is None else self.folder / path, robots=robots)

    def _read(self) -> Check:
        """What `check` says, asked again where the file has changed."""
        try:
            status = os.stat(self.folder / self.path)
        except OSError:
            return self.check()  # says why it cannot be read
        state = (status.st_mtime_ns, status.st_size)
        if self._known is None or self._known[0] != state:
            self._known = (state, self.check())
        return self._known[1]

    def _work(
        self, command: str, *parts: list[str], progress: Optional[ProgressCallback] = None, may_stop: bool = False
    ) -> Finished:
        """A command that uses the database. `may_stop`: it has a result, too, when a time limit stops it."""
        database = option("--db", self._database)
        words = [command, file_argument(self.path), "--json"]
        return self._run(
            words,
            *parts,
            self._of_model,
            self._of_work,
            database,
            progress=progress,
            accept=(STOPPED,) if may_stop else (),
        )

    def _run(
        self, *parts: list[str], progress: Optional[ProgressCallback] = None, accept: tuple[int, ...] = ()
    ) -> Finished:
        return self.program.run(
            [word for part in parts for word in part],
            folder=self.folder,
            progress=progress or self._progress,
            also_accept=accept,
        )


def decoded(kind: type[T], finished: Finished) -> T:
    return _decode.decode(kind, _decode.parse(finished.output))
