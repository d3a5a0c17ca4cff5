"""What `Experiment.history` returns."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
from typing import Optional

from .._answer import Answer
from .._decode import named
from .._tables import Record, Table
from .setup import Setup


@dataclass(frozen=True)
class RevisionHorizon:
    """Errors of predictions over one length.

    Attributes
    ----------
    horizon : float
        Length of the predictions, s.
    fit_rmse, held_out_rmse : float
        RMS error on the fit trials and on the held-out ones. NaN: not known.
    """

    horizon: float = field(metadata=named("horizon_s"))
    fit_rmse: float
    held_out_rmse: float


@dataclass(frozen=True)
class Revision:
    """A revision of the model, of one channel.

    Attributes
    ----------
    revision : int
        Its number, from 1.
    parent : int or None
        The revision before. None: it is the first.
    change : str
        What it has that its parent had not, such as ``coulomb_friction``.
    current : bool
        Whether the experiment file describes it now.
    fitted : bool
        Whether there is a fit of it.
    channel, unit : str
        The channel and the SI unit of its errors.
    fit_rmse, held_out_rmse : float
        RMS error of free runs. NaN: not compared yet.
    floor : float
        Noise floor.
    times_floor : float
        `held_out_rmse` / `floor`, of `fit_rmse` where held-out trials were not looked at.
    failed_trials : int
        Trials that cannot be simulated.
    horizons : tuple of RevisionHorizon
        Errors of shorter predictions, the shortest first.
    """

    revision: int
    parent: Optional[int]
    change: str
    current: bool
    fitted: bool
    channel: str
    unit: str
    fit_rmse: float
    held_out_rmse: float
    floor: float
    times_floor: float
    failed_trials: int
    horizons: tuple[RevisionHorizon, ...]


@dataclass(frozen=True)
class History(Answer, Table):
    """Error by revision of the model. As a table: a row for each revision and channel.

    Attributes
    ----------
    held_out_looks : int
        How often held-out trials were compared.
    missing : str or None
        What is not stored of the current model yet, a sentence. None: nothing.
    next : str or None
        Command that stores it.
    setups : tuple of Setup
        Setups, where recordings have some.
    revisions : tuple of Revision
        The first revision first.
    """

    held_out_looks: int
    missing: Optional[str]
    next: Optional[str]
    setups: tuple[Setup, ...]
    revisions: tuple[Revision, ...]

    def to_records(self) -> list[Record]:
        """A row for each revision and channel, with the fields of `Revision` but `horizons`."""
        rows = []
        for revision in self.revisions:
            row = asdict(revision)
            del row["horizons"]
            rows.append(row)
        return rows
