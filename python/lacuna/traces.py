"""Stored time series: what was measured, commanded and predicted."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Optional, Union, overload

from ._answer import called
from ._arrays import Floats, subtracted
from ._tables import Record, Table


@dataclass(frozen=True, eq=False)
class Trace(Table):
    """The time series of one trial. As a table: a row for each time.

    Arrays are `numpy.ndarray` of float64 where numpy is installed, lists of float elsewhere; NaN is a reading that is
    missing or not compared. Channels are by name.

    Attributes
    ----------
    trial : str
        Name of the trial.
    held_out : bool
        Whether it is kept from every fit.
    revision : int or None
        Revision of the model that predicted. None: the trial was not compared.
    times : array
        Times of the readings, s.
    measured : mapping of str to array
        Readings of each sensor channel.
    predicted : mapping of str to array
        Predictions of the same channels at the same times, of a free run. Stored in single precision. Empty: the
        trial was not compared, or cannot be simulated.
    command_times : array
        Times of the commands, s.
    commands : mapping of str to array
        Commands of each actuator.
    units : mapping of str to str
        SI unit of each channel and actuator.
    """

    trial: str
    held_out: bool
    revision: Optional[int]
    times: Floats = field(repr=False)
    measured: Mapping[str, Floats] = field(repr=False)
    predicted: Mapping[str, Floats] = field(repr=False)
    command_times: Floats = field(repr=False)
    commands: Mapping[str, Floats] = field(repr=False)
    units: Mapping[str, str]

    @property
    def channels(self) -> tuple[str, ...]:
        """Names of the sensor channels."""
        return tuple(self.measured)

    @property
    def residual(self) -> dict[str, Floats]:
        """Measured − predicted of each channel that is predicted, SI."""
        return {
            name: subtracted(self.measured[name], values)
            for name, values in self.predicted.items()
            if name in self.measured
        }

    def to_records(self) -> list[Record]:
        """A row for each time: `time`, and for each channel ``NAME measured`` and, where there are predictions,
        ``NAME predicted``."""
        columns = {"time": self.times}
        for name, values in self.measured.items():
            columns[f"{name} measured"] = values
            if name in self.predicted:
                columns[f"{name} predicted"] = self.predicted[name]
        return [dict(zip(columns, (float(one) for one in row))) for row in zip(*columns.values())]


class Traces(Sequence[Trace]):
    """Time series by trial: a sequence, and by a trial's name ``traces["chirp.csv"]``."""

    def __init__(self, traces: Sequence[Trace]) -> None:
        self._traces = tuple(traces)

    @property
    def trials(self) -> tuple[str, ...]:
        """Names of the trials."""
        return tuple(one.trial for one in self._traces)

    @overload
    def __getitem__(self, key: Union[int, str]) -> Trace: ...

    @overload
    def __getitem__(self, key: slice) -> Traces: ...

    def __getitem__(self, key: Union[int, str, slice]) -> Union[Trace, Traces]:
        if isinstance(key, slice):
            return Traces(self._traces[key])
        if isinstance(key, int):
            return self._traces[key]
        return called(key, self._traces, "trial", "the trials are")

    def __len__(self) -> int:
        return len(self._traces)

    def __iter__(self) -> Iterator[Trace]:
        return iter(self._traces)

    def __repr__(self) -> str:
        return f"Traces({', '.join(self.trials)})"
