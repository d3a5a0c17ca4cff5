"""What goes wrong, as exceptions with the place.

Every exception of the package is a `LacunaError`. Those for input that a user can correct are also a `ValueError`,
so code that knows nothing of Lacuna treats them as it should.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Optional

_DID_YOU_MEAN = re.compile(r"\((did you mean .*?\?)\)")


@dataclass(frozen=True)
class Problem:
    """One complaint about a file or an argument.

    Attributes
    ----------
    message : str
        The whole sentence: what is wrong, and what to do. Begins with `key` where there is one.
    file : str or None
        File with the problem, as the program names it. None: the problem is in no file, as a wrong argument.
    line, column : int or None
        Place in the file, counted from 1. None: not known.
    key : str or None
        Key of an experiment or robot file, such as ``model.effects[0].where``. None: the problem is with no key.
    """

    message: str
    file: Optional[str] = None
    line: Optional[int] = None
    column: Optional[int] = None
    key: Optional[str] = None

    @property
    def what(self) -> str:
        """The part of the message before its first semicolon: what is wrong."""
        return self.message.split("; ", 1)[0]

    @property
    def remedy(self) -> Optional[str]:
        """What to do: the part of the message after its first semicolon, else a suggested name, else None."""
        _, semicolon, rest = self.message.partition("; ")
        if semicolon:
            return rest
        suggestion = _DID_YOU_MEAN.search(self.message)
        return suggestion.group(1) if suggestion else None

    @property
    def where(self) -> str:
        """``file:line:column``, without the parts that are not known."""
        return ":".join(str(part) for part in (self.file, self.line, self.column) if part is not None)

    def __str__(self) -> str:
        return f"{self.where}: {self.message}" if self.where else self.message


class LacunaError(Exception):
    """Base class of all exceptions of this package.

    Attributes
    ----------
    problems : tuple of Problem
        Everything that is wrong, each with its place. Empty where no input is at fault.
    exit_code : int or None
        Exit code of the program: 1 failed, 2 bad input, 75 stopped; negative: the signal that ended it. None: the
        program did not run.
    command : tuple of str
        The command that failed, beginning with the program. Empty where none ran.
    notes : tuple of str
        Other lines that the program printed to standard error.
    """

    def __init__(
        self,
        message: str,
        *,
        problems: tuple[Problem, ...] = (),
        exit_code: Optional[int] = None,
        command: tuple[str, ...] = (),
        notes: tuple[str, ...] = (),
    ) -> None:
        super().__init__(message)
        self.problems = problems
        self.exit_code = exit_code
        self.command = command
        self.notes = notes

    def __reduce__(self) -> tuple[object, ...]:
        # Exceptions cross processes by pickle, as in joblib and concurrent.futures.
        return (_rebuild, (type(self), str(self), self.__dict__.copy()))

    @property
    def file(self) -> Optional[str]:
        """File of the first problem. None: no problem is in a file."""
        return self.problems[0].file if self.problems else None

    @property
    def line(self) -> Optional[int]:
        """Line of the first problem, from 1. None: not known."""
        return self.problems[0].line if self.problems else None

    @property
    def column(self) -> Optional[int]:
        """Column of the first problem, from 1. None: not known."""
        return self.problems[0].column if self.problems else None

    @property
    def remedy(self) -> Optional[str]:
        """What to do about the first problem. None: the program suggests nothing."""
        return self.problems[0].remedy if self.problems else None


class BadInputError(LacunaError, ValueError):
    """A command line, file, recording or SQL statement is wrong (exit code 2). `problems` has all places at once."""


class CommandFailedError(LacunaError, RuntimeError):
    """The program could not do its work: a full disk, a damaged database, a plugin that crashed (exit code 1)."""


class StoppedError(LacunaError, RuntimeError):
    """The program was stopped, by a time limit or a signal, before it had a result (exit code 75). Call it again."""


class ProgramNotFoundError(LacunaError, FileNotFoundError):
    """The program ``lacuna`` was not found, or cannot be run."""


class AnswerError(LacunaError, RuntimeError):
    """The program's answer lacks a part that this package needs: package and program are of different versions."""


def _rebuild(kind: type[LacunaError], message: str, state: dict[str, object]) -> LacunaError:
    error = kind(message)
    error.__dict__.update(state)
    return error
