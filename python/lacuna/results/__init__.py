"""What commands answer: frozen dataclasses in SI units.

A number that is not known is NaN where the field is a float, None where it is optional. `raw`, where a result has it,
is the whole answer of the program as dictionaries and lists.
"""

from .change import Change, ChannelChange, ErrorRise, RevisionErrors, RevisionValue
from .check import Channel, Check, Effect, FreeValue, ModelRobot, Note, ReadTrial
from .comparison import ChannelScore, Comparison, Condition, CrossCheck, EngineDistance, Finding, HorizonScore
from .comparison import PooledScore, TrialComparison
from .diagnosis import BaseErrors, Candidate, Diagnosis, FoundEffect, FoundParameter, HeldParameter
from .diagnosis import HorizonError, StoppedSearch, Untestable
from .export import AbsorbedEffect, Export, ExportedFile
from .fit import Fit, FitStage, FittedValue
from .forces import ForceCurve, ForceFormula, FormulaTerm, Gain, UnexplainedForce
from .history import History, Revision, RevisionHorizon
from .plugins import Component, PluginList
from .prediction import PredictedChannel, PredictedTest, Prediction
from .setup import Quantity, Setup
from .trial import CommandTable, Trial

__all__ = [
    "AbsorbedEffect",
    "BaseErrors",
    "Candidate",
    "Change",
    "Channel",
    "ChannelChange",
    "ChannelScore",
    "Check",
    "CommandTable",
    "Comparison",
    "Component",
    "Condition",
    "CrossCheck",
    "Diagnosis",
    "Effect",
    "EngineDistance",
    "ErrorRise",
    "Export",
    "ExportedFile",
    "Finding",
    "Fit",
    "FitStage",
    "FittedValue",
    "ForceCurve",
    "ForceFormula",
    "FormulaTerm",
    "FoundEffect",
    "FoundParameter",
    "FreeValue",
    "Gain",
    "HeldParameter",
    "History",
    "HorizonError",
    "HorizonScore",
    "ModelRobot",
    "Note",
    "PluginList",
    "PooledScore",
    "PredictedChannel",
    "PredictedTest",
    "Prediction",
    "Quantity",
    "ReadTrial",
    "Revision",
    "RevisionErrors",
    "RevisionHorizon",
    "RevisionValue",
    "Setup",
    "StoppedSearch",
    "Trial",
    "TrialComparison",
    "UnexplainedForce",
    "Untestable",
]
