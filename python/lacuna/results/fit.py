"""What `Experiment.fit` returns."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Optional

from .._answer import Answer, called
from .._tables import Record, Table


@dataclass(frozen=True)
class FittedValue:
    """A fitted value.

    Attributes
    ----------
    address : str
        What was fitted, such as ``joint.hinge.damping`` or ``effect.coulomb_friction.torque``.
    unit : str
        SI unit of the numbers.
    start : float
        Where the fit began: the value of the file.
    value : float
        The fitted value.
    standard_error : float
        Of the value. NaN: the data cannot tell it.
    ci95 : tuple of two float
        Its 95 % interval.
    at_bound : bool
        Whether the fit ended at a bound.
    identified : bool
        Whether the data tell this value apart from others.
    """

    address: str
    unit: str
    start: float
    value: float
    standard_error: float
    ci95: tuple[float, float]
    at_bound: bool
    identified: bool


@dataclass(frozen=True)
class FitStage:
    """A stage of a fit: segments of one length.

    Attributes
    ----------
    name : str
        Such as ``segments of 0.5 s`` or ``free run``.
    converged : bool
        Whether it came to its end.
    residual_over_noise : float
        Root mean square of the residual, in multiples of the noise floor.
    values : tuple of float
        The values then, in the order of `Fit.values`.
    """

    name: str
    converged: bool
    residual_over_noise: float
    values: tuple[float, ...]


@dataclass(frozen=True)
class Fit(Answer, Table):
    """The model's free values, fitted to the fit trials. As a table: a row for each value.

    Attributes
    ----------
    values : tuple of FittedValue
        In the order of the experiment file.
    stages : tuple of FitStage
        In the order in which they were made.
    cannot_tell : tuple of str
        What the data cannot tell apart, a sentence each.
    notes : tuple of str
        What a user should know of this fit, a sentence each.
    experiment : str or None
        Name of the experiment. None: the fit is part of a comparison.
    stopped : str or None
        Why it ended before it converged, as by a time limit. None: it did not.
    """

    values: tuple[FittedValue, ...]
    stages: tuple[FitStage, ...]
    cannot_tell: tuple[str, ...]
    notes: tuple[str, ...]
    experiment: Optional[str] = None
    stopped: Optional[str] = None

    def __getitem__(self, address: str) -> FittedValue:
        """The value at an address. Raises `KeyError` with the known ones where there is none."""
        return called(address, self.values, "address", "fitted are")

    @property
    def converged(self) -> bool:
        """Whether every stage came to its end."""
        return self.stopped is None and all(stage.converged for stage in self.stages)

    def to_dict(self) -> dict[str, float]:
        """Fitted values by address, in SI units."""
        return {one.address: one.value for one in self.values}

    def to_records(self) -> list[Record]:
        """A row for each value, with the fields of `FittedValue`; the interval is in `lower` and `upper`."""
        rows = []
        for one in self.values:
            row = asdict(one)
            lower, upper = row.pop("ci95")
            row.update(lower=lower, upper=upper)
            rows.append(row)
        return rows
