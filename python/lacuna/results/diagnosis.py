"""What `Experiment.diagnose` returns."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Optional

from .._answer import Answer
from .._decode import named
from .._tables import Record, Table
from .forces import ForceCurve, ForceFormula, Gain, UnexplainedForce
from .setup import Setup


@dataclass(frozen=True)
class FoundParameter:
    """A parameter of an effect, or a value of the model, as the diagnosis fitted it.

    Attributes
    ----------
    value : float
        The fitted value.
    ci95 : tuple of two float
        Its 95 % interval; NaN: the data cannot tell it.
    unit : str
        SI unit of the numbers.
    stated : float or None
        Of a wrong value of the robot file: what the file states.
    at_bound : bool
        Whether the fit ended at a bound of the range.
    """

    value: float
    ci95: tuple[float, float]
    unit: str
    stated: Optional[float] = None
    at_bound: bool = False


@dataclass(frozen=True)
class HeldParameter:
    """A parameter that acts only together with another one, which stays where it is.

    Attributes
    ----------
    value : float
        Where it stays.
    unit : str
        Its SI unit.
    """

    value: float
    unit: str


@dataclass(frozen=True)
class FoundEffect:
    """An effect at a place.

    Attributes
    ----------
    effect : str
        Name in the library, such as ``coulomb_friction``; ``wrong_value``: a fixed value of the robot file.
    where : str
        Element such as ``joint.hinge``, ``world``, or the address of the wrong value.
    parameters : mapping of str to FoundParameter
        Its parameters by name.
    held : mapping of str to HeldParameter
        Parameters that were not fitted.
    """

    effect: str
    where: str
    parameters: Mapping[str, FoundParameter]
    held: Mapping[str, HeldParameter] = field(default_factory=dict)

    def __str__(self) -> str:
        return f"{self.effect} @ {self.where}"


@dataclass(frozen=True)
class Candidate:
    """A set of effects that was tried.

    Attributes
    ----------
    effects : tuple of FoundEffect
        What it adds to the model.
    look_alikes : tuple of str
        Effects that these data do not tell apart from it.
    gain : float
        Over the null model, nats (see `Gain`).
    gain_ci95 : tuple of two float
        Its 95 % interval.
    gain_standard_error : float
        Of the gain.
    noise_floor, fit_rmse, held_out_rmse : mapping of str to float
        By channel, of predictions over `segment` s, in the unit that `Diagnosis.units` names.
    fitted_ratio_to_floor : float
        RMS error on what was fitted, over all lengths, in multiples of the noise floor.
    segment : float
        Length of these predictions, s.
    """

    effects: tuple[FoundEffect, ...]
    look_alikes: tuple[str, ...] = field(metadata=named("class"))
    gain: float
    gain_ci95: tuple[float, float]
    gain_standard_error: float
    noise_floor: Mapping[str, float]
    fit_rmse: Mapping[str, float]
    held_out_rmse: Mapping[str, float]
    fitted_ratio_to_floor: float
    segment: float = field(metadata=named("segment_s"))

    def __str__(self) -> str:
        return " + ".join(str(effect) for effect in self.effects)


@dataclass(frozen=True)
class BaseErrors:
    """Errors of the null model, of the longest predictions.

    Attributes
    ----------
    fit_rmse, held_out_rmse : mapping of str to float
        By channel, in the unit that `Diagnosis.units` names.
    fitted_ratio_to_floor : float
        RMS error on what was fitted, over all lengths, in multiples of the noise floor.
    segment : float
        Length of these predictions, s.
    """

    fit_rmse: Mapping[str, float]
    held_out_rmse: Mapping[str, float]
    fitted_ratio_to_floor: float
    segment: float = field(metadata=named("segment_s"))


@dataclass(frozen=True)
class HorizonError:
    """Errors of predictions over one length, of one channel.

    Attributes
    ----------
    horizon : float
        Length of the predictions, s.
    channel, unit : str
        The channel and the SI unit of the errors.
    floor : float
        Noise of a reading.
    base, answer : float
        RMS error of the null model and with the answer, on the fit trials.
    base_held_out, answer_held_out : float
        The same on the held-out trials.
    """

    horizon: float = field(metadata=named("horizon_s"))
    channel: str
    unit: str
    floor: float
    base: float
    answer: float
    base_held_out: float
    answer_held_out: float


@dataclass(frozen=True)
class Untestable:
    """An effect that could not be tried.

    Attributes
    ----------
    effect, where : str
        The effect and the place; `where` is empty where it has none.
    reason : str
        Why not.
    failed : bool
        Whether its plugin failed.
    """

    effect: str
    where: str
    reason: str
    failed: bool


@dataclass(frozen=True)
class StoppedSearch:
    """Where a time limit stopped the search.

    Attributes
    ----------
    during : str
        What was under way.
    not_examined : tuple of str
        Candidates that were not looked at.
    next : str
        What to do.
    """

    during: str
    not_examined: tuple[str, ...]
    next: str


@dataclass(frozen=True, repr=False)
class Diagnosis(Answer, Table):
    """What the model is missing. As a table: the ranking, a row for each candidate.

    Attributes
    ----------
    verdict : str
        ``nothing_missing``, ``effect_found``, ``not_in_library`` or ``cannot_tell``.
    probability : float or None
        That the verdict is right. None: none is stated.
    calibrated : bool
        Whether the probability was calibrated on simulated experiments.
    evidence : mapping of str to float
        Figures that say how sure the verdict is.
    noise_floor : mapping of str to float
        By channel, in the unit that `units` names.
    units : mapping of str to str
        SI unit by channel.
    ranking : tuple of Candidate
        Candidates, the first is the best.
    values : mapping of str to FoundParameter
        The model's own free values beside the answer, by address.
    hypotheses : int
        How many effects at places were tried.
    findings : tuple of str
        Sentences: data checks, and what had absorbed the effect.
    next_test : str
        A test that would tell the candidates apart, as `Experiment.trial` takes it; empty: none.
    next_test_setup : Setup or None
        Setup to make it in. None: no recording has a setup.
    next_test_worth : str
        What that test is expected to tell; empty: there is none.
    not_testable : tuple of Untestable
        Effects that could not be tried.
    seconds : float
        How long it took, s.
    method : str or None
        What decided. None: nothing was searched.
    base : BaseErrors or None
        Errors of the null model.
    horizons : tuple of HorizonError
        Errors by length of the prediction.
    p_by_chance : float or None
        How often noise alone gains as much as the best set. None: not asked.
    answer_gain : Gain or None
        Gain of the answer over the null model.
    missing_force : tuple of ForceCurve
        Force that the null model lacks on the joints of the answer.
    unexplained : UnexplainedForce or None
        A force that no effect has.
    formulas : tuple of ForceFormula
        Laws for it.
    residual_force : tuple of ForceCurve
        Its curves.
    stopped : StoppedSearch or None
        Where a time limit stopped the search: the verdict is preliminary. None: it is finished.
    effect_filter : tuple of str
        The only effects that were tried. Empty: all.
    """

    verdict: str
    probability: Optional[float]
    calibrated: bool
    evidence: Mapping[str, float]
    noise_floor: Mapping[str, float]
    units: Mapping[str, str]
    ranking: tuple[Candidate, ...]
    values: Mapping[str, FoundParameter]
    hypotheses: int
    findings: tuple[str, ...]
    next_test: str
    next_test_setup: Optional[Setup]
    next_test_worth: str
    not_testable: tuple[Untestable, ...]
    seconds: float
    method: Optional[str] = None
    base: Optional[BaseErrors] = None
    horizons: tuple[HorizonError, ...] = ()
    p_by_chance: Optional[float] = None
    answer_gain: Optional[Gain] = None
    missing_force: tuple[ForceCurve, ...] = ()
    unexplained: Optional[UnexplainedForce] = None
    formulas: tuple[ForceFormula, ...] = ()
    residual_force: tuple[ForceCurve, ...] = ()
    stopped: Optional[StoppedSearch] = None
    effect_filter: tuple[str, ...] = ()

    def __repr__(self) -> str:
        return f"Diagnosis({self.verdict}{f': {self.answer}' if self.answer else ''})"

    @property
    def answer(self) -> Optional[Candidate]:
        """What to add to the model (``Experiment.add(answer=True)``). None unless the verdict is ``effect_found``."""
        return self.ranking[0] if self.verdict == "effect_found" and self.ranking else None

    def to_records(self) -> list[Record]:
        """A row for each candidate: `rank`, `effects`, `gain` with `gain_lower` and `gain_upper` (nats),
        `times_floor` (error on what was fitted) and `look_alikes`."""
        return [
            {
                "rank": rank,
                "effects": str(one),
                "gain": one.gain,
                "gain_lower": one.gain_ci95[0],
                "gain_upper": one.gain_ci95[1],
                "times_floor": one.fitted_ratio_to_floor,
                "look_alikes": ", ".join(one.look_alikes),
            }
            for rank, one in enumerate(self.ranking, start=1)
        ]
