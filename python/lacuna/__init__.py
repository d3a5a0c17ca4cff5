"""Find out which physical effect a robot model is missing, from Python.

>>> import lacuna
>>> rig = lacuna.Experiment("first-steps.toml")         # doctest: +SKIP
>>> rig.compare().to_frame()                            # doctest: +SKIP

The package calls the program ``lacuna`` (see `find_program`) and reads its JSON and its database. It needs nothing but
the standard library; with numpy, time series are arrays, with pandas, tables are data frames. All numbers are in SI
units.
"""

from . import results
from ._library import plugins
from .database import Database, Rows
from .draft import Draft
from .errors import (
    AnswerError,
    BadInputError,
    CommandFailedError,
    LacunaError,
    Problem,
    ProgramNotFoundError,
    StoppedError,
)
from .experiment import Experiment
from .program import Program, find_program
from .progress import Progress
from .traces import Trace, Traces

__all__ = [
    "AnswerError",
    "BadInputError",
    "CommandFailedError",
    "Database",
    "Draft",
    "Experiment",
    "LacunaError",
    "Problem",
    "Program",
    "ProgramNotFoundError",
    "Progress",
    "Rows",
    "StoppedError",
    "Trace",
    "Traces",
    "find_program",
    "plugins",
    "results",
]

__version__ = "0.1.0"
