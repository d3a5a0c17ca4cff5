"""A database of results."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, Optional, Union, overload

from . import _decode
from ._stored_traces import stored_experiment, stored_traces
from ._tables import Record, Table
from .program import PathLike, Program
from .traces import Traces


class Rows(Table, Sequence[Record]):
    """Rows that a query gave: a sequence of dictionaries, and a table."""

    def __init__(self, rows: Sequence[Record]) -> None:
        self._rows = list(rows)

    @overload
    def __getitem__(self, index: int) -> Record: ...

    @overload
    def __getitem__(self, index: slice) -> Rows: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[Record, Rows]:
        return Rows(self._rows[index]) if isinstance(index, slice) else self._rows[index]

    def __len__(self) -> int:
        return len(self._rows)

    def __iter__(self) -> Iterator[Record]:
        return iter(self._rows)

    def __repr__(self) -> str:
        return f"Rows({self._rows!r})"

    def to_records(self) -> list[Record]:
        """The rows."""
        return list(self._rows)


class Database:
    """A database that Lacuna wrote. It is only read.

    Parameters
    ----------
    path : path
        The file, such as ``first-steps.db``.
    program : path or Program, optional
        The program ``lacuna``, through which the file is read (`find_program`).

    Attributes
    ----------
    path : pathlib.Path
        The file, absolute.
    """

    def __init__(self, path: PathLike, *, program: Union[PathLike, Program, None] = None) -> None:
        self.path = Path(os.path.abspath(path))
        self._program = program if isinstance(program, Program) else Program(program)

    def __repr__(self) -> str:
        return f"Database({str(self.path)!r})"

    def sql(self, statement: str) -> Rows:
        """The rows that a SQL statement gives; of bytes only their number.

        Parameters
        ----------
        statement : str
            One SELECT, such as ``SELECT * FROM error_by_revision``. ``schema/database.md`` has tables and views.

        Raises
        ------
        BadInputError
            The statement is wrong, or the file is no database of Lacuna.
        """
        output = self._program.run(["sql", "--json", "--", str(self.path), statement]).output
        return Rows(_decode.parse(output))

    def views(self) -> dict[str, str]:
        """Views of a database, each with a query as an example."""
        lines = self._program.run(["sql", "--views"]).output.decode().splitlines()
        return {name: example.strip() for name, example in zip(lines[::3], lines[2::3])}

    def traces(self, *, experiment: Optional[str] = None, revision: Optional[int] = None) -> Traces:
        """What was measured, commanded and predicted, by trial.

        Parameters
        ----------
        experiment : str, optional
            Name of the experiment. Default: the only one of the database.
        revision : int, optional
            Revision of the model that predicts. Default: the newest one that was compared.

        Raises
        ------
        BadInputError
            There is no such experiment, or the revision was not compared.
        """
        return stored_traces(self._query, stored_experiment(self._query, experiment), revision)

    def report(
        self, path: Optional[PathLike] = None, *, most_megabytes: Optional[float] = None, robots: bool = True
    ) -> Path:
        """Writes the database as a page for any browser, and returns its path.

        Parameters
        ----------
        path : path, optional
            The page. Default: beside the database, with ``.html``.
        most_megabytes : float, optional
            Size from which a selection of the database is taken, MB. Default: 50.
        robots : bool, optional
            Whether robots of stored runs are simulated again for it.
        """
        page = Path(os.path.abspath(path if path is not None else self.path.with_suffix(".html")))
        arguments = ["report", str(self.path), "--out", str(page), "--quiet"]
        if most_megabytes is not None:
            arguments += ["--most-megabytes", repr(float(most_megabytes))]
        if not robots:
            arguments.append("--no-robots")
        self._program.run(arguments)
        return page

    def _query(self, statement: str) -> list[dict[str, Any]]:
        return self.sql(statement).to_records()
