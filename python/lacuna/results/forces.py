"""Forces that a diagnosis finds, as curves and as formulas."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional


@dataclass(frozen=True)
class Gain:
    """How much better a model predicts what it was not fitted to.

    Attributes
    ----------
    value : float
        How much lower the mean logarithm of the error is, nats: 0.69 is half the error.
    standard_error : float
        Of the value, nats.
    ci95 : tuple of two float
        Its 95 % interval, nats.
    """

    value: float
    standard_error: float
    ci95: tuple[float, float]


@dataclass(frozen=True)
class ForceCurve:
    """A force that the model lacks, over one quantity.

    Attributes
    ----------
    joint : str
        Joint on which it acts.
    of : str
        ``position``, ``velocity``, ``command`` or ``time``.
    unit, force_unit : str
        SI units of `at` and of `force`.
    at : tuple of float
        Values of the quantity.
    force : tuple of float
        The force there.
    standard_error : tuple of float
        Of the force.
    position : float or None
        Position of the joint that the curve is about. None: all.
    by_answer : tuple of float
        What the answer makes of it; empty where there is no answer.
    """

    joint: str
    of: str
    unit: str
    force_unit: str
    at: tuple[float, ...]
    force: tuple[float, ...]
    standard_error: tuple[float, ...]
    position: Optional[float] = None
    by_answer: tuple[float, ...] = ()


@dataclass(frozen=True)
class FormulaTerm:
    """A term of a formula.

    Attributes
    ----------
    text : str
        Such as ``v*abs(v)``.
    coefficient, standard_error : float
        In `unit`.
    unit : str
        SI unit.
    """

    text: str
    coefficient: float
    standard_error: float
    unit: str


@dataclass(frozen=True)
class ForceFormula:
    """A law for a force that no effect of the library has.

    Attributes
    ----------
    joint : str
        Joint on which it acts.
    text : str
        The law, as ``lacuna plugins new effect --formula`` takes it.
    unit : str
        Unit of the force.
    terms : tuple of FormulaTerm
        Its terms.
    gain : Gain
        Over the null model.
    """

    joint: str
    text: str
    unit: str
    terms: tuple[FormulaTerm, ...]
    gain: Gain


@dataclass(frozen=True)
class UnexplainedForce:
    """A force that no effect of the library has.

    Attributes
    ----------
    joint : str
        Joint on which it acts.
    depends_on : str
        What it depends on.
    share : float
        Share of the whole gain, 0 to 1.
    gain : Gain
        Over the answer.
    """

    joint: str
    depends_on: str
    share: float
    gain: Gain
