"""The lines that the program prints to standard error with ``LACUNA_MESSAGES=json``."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any, Optional, Union

from .errors import Problem
from .progress import Progress


def read_line(line: str) -> tuple[str, Union[Progress, Problem, str]]:
    """The kind of a line, ``progress``, ``problem``, ``failure`` or ``note``, with what it says."""
    if line.startswith("{"):
        try:
            document = json.loads(line)
        except ValueError:
            return "note", line
        for kind, reader in _READERS.items():
            if isinstance(document, dict) and kind in document:
                return kind, reader(document[kind])
    return "note", line


def _progress(members: Any) -> Progress:
    return Progress(members["phase"], members["fraction"], members["seconds_left"])


def _problem(members: Any) -> Problem:
    return Problem(
        message=members["message"],
        file=_known(members["file"]),
        line=_known(members["line"]),
        column=_known(members["column"]),
        key=_known(members["key"]),
    )


def _known(value: Any) -> Optional[Any]:
    return value or None


_READERS: dict[str, Callable[[Any], Union[Progress, Problem, str]]] = {
    "progress": _progress,
    "problem": _problem,
    "failure": str,
}
