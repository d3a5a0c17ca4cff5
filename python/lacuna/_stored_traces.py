"""Reads time series out of a database, by queries of the program."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Optional

from ._arrays import Floats, array, columns_of, from_little_endian
from .errors import BadInputError, CommandFailedError
from .traces import Trace, Traces

Query = Callable[[str], "list[dict[str, Any]]"]

# Of each trial that a revision was compared with last, what it predicted.
_PREDICTED = """
SELECT trace.id, trace.trial, revision.number AS revision
FROM trace
JOIN comparison ON comparison.id = trace.comparison AND comparison.kind = 'refitted'
JOIN revision ON revision.id = comparison.revision
JOIN experiment ON experiment.id = revision.experiment
WHERE trace.kind = 'predicted' AND experiment.name = {experiment} AND revision.number = {revision}
ORDER BY comparison.id
"""

_LATEST = """
SELECT max(revision.number) AS revision
FROM comparison JOIN revision ON revision.id = comparison.revision
JOIN experiment ON experiment.id = revision.experiment
WHERE comparison.kind = 'refitted' AND experiment.name = {experiment}
"""

_MEASURED = """
SELECT trial.id AS trial, trial.name, trial.held_out, trace.id, trace.kind
FROM trial JOIN experiment ON experiment.id = trial.experiment JOIN trace ON trace.trial = trial.id
WHERE experiment.name = {experiment} AND trace.kind IN ('measured', 'commands')
ORDER BY trial.id, trace.id
"""

_HEAD = """
SELECT channels, sample_count, precision, digest, length(times) AS times, length(samples) AS samples
FROM trace WHERE id = {id}
"""

# The program prints no bytes, but text, of a limited length.
_PART = "SELECT hex(substr({column}, {first}, {count})) AS part FROM trace WHERE id = {id}"
_LONGEST_PART = 1 << 24


@dataclass(frozen=True)
class _Series:
    times: Floats
    columns: dict[str, Floats]
    units: dict[str, str]


_NOTHING = _Series(array(()), {}, {})


def stored_experiment(query: Query, experiment: Optional[str]) -> str:
    """The experiment that is meant; without a name the only one of the database."""
    names = [row["name"] for row in query("SELECT name FROM experiment ORDER BY name")]
    known = ", ".join(names) or "none"
    if experiment is None and len(names) == 1:
        return str(names[0])
    if experiment is None:
        raise BadInputError(f"the database has the experiments {known}; name one: traces(experiment=...)")
    if experiment not in names:
        raise BadInputError(f"the database has nothing of {experiment}; its experiments are {known}")
    return experiment


def stored_traces(query: Query, experiment: str, revision: Optional[int]) -> Traces:
    """What was measured and, by a revision, predicted. Without a number, by the latest that was compared."""
    name = _literal(experiment)
    if revision is None:
        revision = query(_LATEST.format(experiment=name))[0]["revision"]
    predicted: dict[int, int] = {}
    if revision is not None:
        rows = query(_PREDICTED.format(experiment=name, revision=int(revision)))
        predicted = {row["trial"]: row["id"] for row in rows}  # the latest comparison last
        if not rows:
            raise BadInputError(f"revision {revision} of {experiment} was not compared; call compare() first")
    trials: dict[int, dict[str, Any]] = {}
    for row in query(_MEASURED.format(experiment=name)):
        trial = trials.setdefault(row["trial"], {"name": row["name"], "held_out": bool(row["held_out"])})
        trial[row["kind"]] = row["id"]
    wanted = [key for key in trials if not predicted or key in predicted]
    return Traces([_trace(query, trials[key], predicted.get(key), revision) for key in wanted])


def _trace(query: Query, trial: dict[str, Any], predicted: Optional[int], revision: Optional[int]) -> Trace:
    measured = _series(query, trial.get("measured"))
    commands = _series(query, trial.get("commands"))
    return Trace(
        trial=trial["name"],
        held_out=trial["held_out"],
        revision=revision if predicted is not None else None,
        times=measured.times,
        measured=measured.columns,
        predicted=_series(query, predicted).columns,
        command_times=commands.times,
        commands=commands.columns,
        units={**measured.units, **commands.units},
    )


def _series(query: Query, number: Optional[int]) -> _Series:
    if number is None:
        return _NOTHING
    row = query(_HEAD.format(id=int(number)))[0]
    times = _content(query, number, "times", row["times"])
    samples = _content(query, number, "samples", row["samples"])
    if _digest(row, times, samples) != row["digest"]:
        raise CommandFailedError(
            f"time series {number}: is damaged, its bytes do not match its digest; restore a backup of the database"
        )
    channels = json.loads(row["channels"])
    columns = columns_of(samples, row["precision"], max(len(channels), 1))
    return _Series(
        times=_times(times, row["sample_count"]),
        columns={channel["name"]: column for channel, column in zip(channels, columns)},
        units={channel["name"]: channel["unit"] for channel in channels},
    )


def _content(query: Query, number: int, column: str, size: int) -> bytes:
    parts = []
    for first in range(1, size + 1, _LONGEST_PART):
        row = query(_PART.format(column=column, first=first, count=_LONGEST_PART, id=int(number)))[0]
        parts.append(bytes.fromhex(row["part"]))
    return b"".join(parts)


def _times(content: bytes, count: int) -> Floats:
    """All times, or start and step of evenly spaced ones."""
    numbers = from_little_endian(content, "float64")
    if len(numbers) == count:
        return array(numbers)
    start, step = numbers
    return array([start + step * index for index in range(count)])


def _digest(row: dict[str, Any], times: bytes, samples: bytes) -> str:
    head = f"{row['channels']}\n{row['sample_count']}\n{row['precision']}\n"
    parts = "\n".join(hashlib.sha256(part).hexdigest() for part in (times, samples))
    return hashlib.sha256((head + parts).encode()).hexdigest()


def _literal(text: str) -> str:
    return "'" + text.replace("'", "''") + "'"
