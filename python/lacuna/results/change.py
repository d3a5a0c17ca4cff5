"""What `Experiment.add` and `Experiment.undo` return."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Optional

from .._answer import Answer
from .._decode import named
from .._tables import Record, Table


@dataclass(frozen=True)
class ChannelChange:
    """The error of a channel on the fit trials.

    Attributes
    ----------
    channel, unit : str
        The channel and the SI unit of its errors.
    failed_trials : int
        Trials that cannot be simulated; `rmse` is NaN where there are some.
    rmse, floor, times_floor : float
        Root mean square error of a free run, noise floor, and their ratio.
    """

    channel: str
    unit: str
    failed_trials: int
    rmse: float
    floor: float
    times_floor: float


@dataclass(frozen=True)
class RevisionValue:
    """A fitted value of a revision.

    Attributes
    ----------
    address : str
        What was fitted.
    unit : str
        SI unit of the numbers.
    value : float
        The fitted value.
    ci95 : tuple of two float
        Its 95 % interval.
    """

    address: str
    unit: str
    value: float
    ci95: tuple[float, float]


@dataclass(frozen=True)
class RevisionErrors:
    """A revision of the model with its errors.

    Attributes
    ----------
    revision : int
        Its number, from 1.
    channels : tuple of ChannelChange
        Errors on the fit trials.
    values : tuple of RevisionValue
        Fitted values.
    """

    revision: int
    channels: tuple[ChannelChange, ...]
    values: tuple[RevisionValue, ...]


@dataclass(frozen=True)
class ErrorRise:
    """An error that is more than 1 % larger than before.

    Attributes
    ----------
    trial : str
        Trial in which it rose.
    held_out : bool
        Whether the trial is kept from every fit.
    channel, unit : str
        The channel and the SI unit of its errors.
    horizon : float or None
        Length of the predictions, s. None: a free run.
    before, after : float
        The error; `after` is NaN where the trial cannot be simulated any more.
    """

    trial: str
    held_out: bool
    channel: str
    unit: str
    horizon: Optional[float] = field(metadata=named("horizon_s"))
    before: float
    after: float


@dataclass(frozen=True, repr=False)
class Change(Answer, Table):
    """A step from one revision of the model to another. As a table: a row for each channel.

    Attributes
    ----------
    change : str
        Ids of the effects that were added, ``undo``, or the address of a value that was freed.
    before, after : RevisionErrors
        The model before and after. After an undo both are the model that is back.
    rises : tuple of ErrorRise
        Errors that rose.
    undo : str or None
        Command that takes the change back. None: it was an undo.
    """

    change: str
    before: RevisionErrors
    after: RevisionErrors
    rises: tuple[ErrorRise, ...]
    undo: Optional[str] = None

    def __repr__(self) -> str:
        errors = ", ".join(
            f"{row['channel']} {row['times_floor_before']:.3g} → {row['times_floor_after']:.3g} × floor"
            for row in self.to_records()
        )
        return f"Change({self.change}: {errors})"

    def to_records(self) -> list[Record]:
        """A row for each channel: `channel`, `unit`, `rmse_before`, `rmse_after`, `times_floor_before`,
        `times_floor_after`."""
        earlier = {one.channel: one for one in self.before.channels}
        return [
            {
                "channel": one.channel,
                "unit": one.unit,
                "rmse_before": earlier[one.channel].rmse,
                "rmse_after": one.rmse,
                "times_floor_before": earlier[one.channel].times_floor,
                "times_floor_after": one.times_floor,
            }
            for one in self.after.channels
            if one.channel in earlier
        ]
