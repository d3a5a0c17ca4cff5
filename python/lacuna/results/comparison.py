"""What `Experiment.compare` returns."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
from typing import Optional

from .._answer import Answer, called
from .._decode import named
from .._tables import Record, Table
from .fit import Fit
from .setup import Setup


@dataclass(frozen=True)
class ChannelScore:
    """The error of a channel in a trial, of a free run over the whole trial.

    Attributes
    ----------
    channel : str
        Sensor channel.
    unit : str
        SI unit of the errors.
    samples : int
        Readings that count.
    rmse : float
        Root mean square of measured − predicted. NaN: the trial cannot be simulated.
    floor : float
        Error that a right model would leave: noise of the readings and of the commands.
    times_floor : float
        `rmse` / `floor`.
    normalised_rmse : float
        `rmse` / standard deviation of what was measured.
    bias : float
        Mean of measured − predicted.
    theil_u : float
        Theil's inequality coefficient, 0 to 1.
    bias_share, magnitude_share, form_share : float
        Parts of the mean square error: constant, of size, of form. Together 1.
    sprague_geers_magnitude, sprague_geers_phase : float
        Sprague and Geers' errors of magnitude and phase.
    max_error : float
        Largest absolute error.
    max_error_time : float
        When that was, s.
    from_start : float
        RMS error that the uncertain initial state explains.
    rmse_as_written : float
        `rmse` with the values of the file, unfitted.
    numerical : float or None
        RMS error of the integration itself. None: not computed.
    """

    channel: str
    unit: str
    samples: int
    rmse: float
    floor: float
    times_floor: float
    normalised_rmse: float
    bias: float
    theil_u: float
    bias_share: float
    magnitude_share: float
    form_share: float
    sprague_geers_magnitude: float
    sprague_geers_phase: float
    max_error: float
    max_error_time: float = field(metadata=named("max_error_time_s"))
    from_start: float
    rmse_as_written: float
    numerical: Optional[float]


@dataclass(frozen=True)
class HorizonScore:
    """Errors of predictions over one length.

    Attributes
    ----------
    horizon : float
        Length of the predictions, s.
    automatic : bool
        Whether the program chose the length.
    rmse : tuple of float
        Root mean square error for each channel of the trial, in the channel's unit.
    """

    horizon: float = field(metadata=named("horizon_s"))
    automatic: bool
    rmse: tuple[float, ...]


@dataclass(frozen=True)
class TrialComparison:
    """A trial, compared.

    Attributes
    ----------
    trial : str
        Its name.
    held_out : bool
        Whether it is kept from every fit.
    valid : bool
        Whether it can be simulated.
    reason : str
        Why not; empty where it can.
    channels : tuple of ChannelScore
        Errors of a free run.
    horizons : tuple of HorizonScore
        Errors of shorter predictions, each from a measured start.
    """

    trial: str
    held_out: bool
    valid: bool
    reason: str
    channels: tuple[ChannelScore, ...]
    horizons: tuple[HorizonScore, ...]


@dataclass(frozen=True)
class PooledScore:
    """The error of a channel over all fit trials, or over all held-out ones.

    Attributes
    ----------
    channel, unit : str
        The channel and the SI unit of its errors.
    held_out : bool
        Whether these are the held-out trials.
    failed_trials : int
        Trials that cannot be simulated; `rmse` is NaN where there are some.
    rmse, floor, times_floor, from_start, rmse_as_written : float
        As in `ChannelScore`, weighed by samples.
    numerical : float or None
        As in `ChannelScore`.
    floor_origin : str
        Where the noise floor is from, a sentence.
    """

    channel: str
    unit: str
    held_out: bool
    failed_trials: int
    rmse: float
    floor: float
    times_floor: float
    from_start: float
    rmse_as_written: float
    numerical: Optional[float]
    floor_origin: str


@dataclass(frozen=True)
class Condition:
    """A range of a feature of the state.

    Attributes
    ----------
    name : str
        The feature, such as ``velocity`` or ``direction of motion``.
    of : str
        Joint or actuator that it is of; empty where there is one only.
    unit : str
        SI unit of the bounds.
    lower, upper : float or None
        The feature is at least `lower` and below `upper`. None: unbounded.
    """

    name: str
    of: str
    unit: str
    lower: Optional[float] = field(metadata=named("from"))
    upper: Optional[float] = field(metadata=named("below"))


@dataclass(frozen=True)
class Finding:
    """Where the model fails, found on the fit trials.

    Attributes
    ----------
    kind : str
        ``regime``, ``dependence``, ``offset``, ``magnitude`` or ``trial``. Fields that do not belong to a kind are empty.
    share : float
        Share of squares that it is about, 0 to 1.
    sentence : str
        What was found.
    view : str
        ``free_run``: the residual itself; ``acceleration``: what accelerates the channel and is not in the model.
    channel : str or None
        Channel that it is about. None: all.
    depends_on, not_on : tuple of str
        ``dependence``: features of the state on which the residual depends, and those that add nothing to them.
    p : float or None
        ``dependence`` and ``offset``: probability that chance alone does it.
    conditions : tuple of Condition
        ``regime``: where the error is large.
    share_of_samples : float or None
        ``regime`` and ``trial``: share of samples that it is about, 0 to 1.
    offset : float or None
        ``offset``: constant part of the residual, in `unit`.
    unit : str or None
        SI unit of the offset.
    relative : float or None
        ``magnitude``: how much too wide the prediction swings, 0.06: 6 %.
    trial : str or None
        ``trial``: its name.
    """

    kind: str
    share: float
    sentence: str
    view: str
    channel: Optional[str] = None
    depends_on: tuple[str, ...] = ()
    not_on: tuple[str, ...] = ()
    p: Optional[float] = None
    conditions: tuple[Condition, ...] = ()
    share_of_samples: Optional[float] = None
    offset: Optional[float] = None
    unit: Optional[str] = None
    relative: Optional[float] = None
    trial: Optional[str] = None


@dataclass(frozen=True)
class EngineDistance:
    """How far the predictions of two engines are apart.

    Attributes
    ----------
    channel, unit : str
        The channel and its SI unit.
    apart : float
        RMS distance of the two.
    error : float
        RMS error of the model.
    """

    channel: str
    unit: str
    apart: float
    error: float


@dataclass(frozen=True)
class CrossCheck:
    """The trials once more with the other engine.

    Attributes
    ----------
    engine : str
        Its name.
    substeps : int
        Steps that it made in one of the experiment's.
    channels : tuple of EngineDistance
        The distance for each channel.
    left_out : tuple of str
        What was not simulated, a sentence each.
    """

    engine: str
    substeps: int
    channels: tuple[EngineDistance, ...]
    left_out: tuple[str, ...]


@dataclass(frozen=True, repr=False)
class Comparison(Answer, Table):
    """The model beside every recording. As a table: a row for each trial and channel. `raw` has every test of where the
    model fails, under ``where``.

    Attributes
    ----------
    experiment : str
        Its name.
    held_out_look : int
        How often held-out trials were compared, this time included. Each comparison weakens them as evidence. 0:
        there are none.
    refitted : bool
        Whether the values were fitted; else they are those of the file.
    fit : Fit
        The fit.
    pooled : tuple of PooledScore
        Errors over all fit trials and over all held-out ones, for each channel.
    trials : tuple of TrialComparison
        Errors for each trial.
    setups : tuple of Setup
        Setups, where recordings have some.
    findings : tuple of Finding
        Where the model fails, the largest part first.
    notes : tuple of str
        What a user should know of this comparison.
    advice : str or None
        What follows from the errors: a sentence, and the command to call next. None: the program states none.
    cross_check : CrossCheck or None
        With ``compare(cross_check=True)``.
    """

    experiment: str
    held_out_look: int
    refitted: bool
    fit: Fit
    pooled: tuple[PooledScore, ...]
    trials: tuple[TrialComparison, ...]
    setups: tuple[Setup, ...]
    findings: tuple[Finding, ...]
    notes: tuple[str, ...]
    advice: Optional[str] = None
    cross_check: Optional[CrossCheck] = None

    def __repr__(self) -> str:
        errors = ", ".join(
            f"{one.channel} {one.times_floor:.3g} × floor on the {'held-out' if one.held_out else 'fit'} trials"
            for one in self.pooled
        )
        return f"Comparison({self.experiment}: {errors})"

    def __getitem__(self, trial: str) -> TrialComparison:
        """The trial of this name. Raises `KeyError` with the known ones where there is none."""
        return called(trial, self.trials, "trial", "the trials are")

    def times_floor(self, *, held_out: bool = False) -> dict[str, float]:
        """Error over all fit trials, or all held-out ones, in multiples of the noise floor, by channel.

        About 1: noise alone explains it. Above 1.2: something is missing, or a trial's start is uncertain.
        """
        return {one.channel: one.times_floor for one in self.pooled if one.held_out == held_out}

    def to_records(self) -> list[Record]:
        """A row for each trial and channel: `trial`, `held_out`, and the fields of `ChannelScore`."""
        return [
            {"trial": trial.trial, "held_out": trial.held_out, **asdict(channel)}
            for trial in self.trials
            for channel in trial.channels
        ]
