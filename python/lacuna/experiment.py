"""An experiment file, and what can be done with it."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from typing import Any, Optional, Union

from ._arguments import Names, Paths, file_argument, listed, option, path_list, repeated
from ._commands import ExperimentCommands, decoded
from .draft import Draft
from .errors import BadInputError
from .program import PathLike, Program
from .progress import ProgressCallback
from .results import Change, CommandTable, Comparison, Diagnosis, Export, Fit, History, Prediction, Trial


class Experiment(ExperimentCommands):
    """An experiment file (TOML) with the commands of ``lacuna`` as methods.

    Nothing is read before a method is called. Commands run in the folder that was the current one when the object was
    made; relative names are relative to it. Results are kept in the database, so a fit or a diagnosis of an unchanged
    experiment is found again instead of made again.

    Parameters
    ----------
    path : path
        The experiment file.
    database : path, optional
        File for the results. Default: the experiment's name with ``.db``, in the folder.
    overrides : mapping of str to object, optional
        Values put beside those of the file, by key: ``{"engine.step": 0.0005}``. Texts, numbers, lists, dictionaries.
    plugin_path : path or sequence of paths, optional
        Folders with plugins, searched before all others.
    n_jobs : int, optional
        Threads. -1: one a processor. Results are the same whatever their number.
    random_state : int, optional
        Seed of everything random, instead of the file's.
    evaluation_limit : float, optional
        How long a single simulation of a model may take, s. Default: 120.
    folder : path, optional
        Folder in which commands run. Default: the current one.
    program : path or Program, optional
        The program. Default: the environment variable ``LACUNA``, else ``lacuna`` on the PATH.
    progress : callable, optional
        Called with a `Progress`, in the calling thread, by methods that get no `progress` of their own.

    Raises
    ------
    ProgramNotFoundError
        The program is not found.

    Notes
    -----
    All methods that call the program raise `BadInputError`, `CommandFailedError` or `StoppedError` (see
    `lacuna.errors`). An interrupt ends the program as Ctrl-C on a terminal does; what it has stored is kept.
    """

    def __init__(
        self,
        path: PathLike,
        *,
        database: Optional[PathLike] = None,
        overrides: Optional[Mapping[str, object]] = None,
        plugin_path: Paths = (),
        n_jobs: int = -1,
        random_state: Optional[int] = None,
        evaluation_limit: Optional[float] = None,
        folder: Optional[PathLike] = None,
        program: Union[PathLike, Program, None] = None,
        progress: Optional[ProgressCallback] = None,
    ) -> None:
        super().__init__(
            path,
            database=database,
            overrides=overrides,
            plugin_path=plugin_path,
            n_jobs=n_jobs,
            random_state=random_state,
            evaluation_limit=evaluation_limit,
            folder=folder,
            program=program,
            progress=progress,
        )

    def __repr__(self) -> str:
        return f"Experiment({self.path!r})"

    @classmethod
    def new(
        cls,
        path: PathLike,
        recordings: Paths,
        *,
        robot: Optional[PathLike] = None,
        time: Optional[str] = None,
        position: Names = (),
        velocity: Names = (),
        command: Names = (),
        program: Union[PathLike, Program, None] = None,
        **settings: Any,
    ) -> Draft:
        """Drafts an experiment file and, without `robot`, a robot file for recordings.

        Parameters
        ----------
        path : path
            Experiment file to write; must not be there yet. The robot file gets its name with ``-robot.toml``.
        recordings : path or sequence of paths
            Measured files; the last of several is held out.
        robot : path, optional
            Robot file that is there already (TOML, URDF, MJCF).
        time : str, optional
            Column of time (default: guessed).
        position, velocity, command : str or sequence of str, optional
            Columns that are joint positions, joint velocities, commands, instead of guesses.
        program, **settings : optional
            As of `Experiment`.

        Returns
        -------
        Draft
            The experiment, and what is left to be filled in.
        """
        experiment = cls(path, program=program, **settings)
        finished = experiment._run(
            ["new", file_argument(path)],
            [word for one in path_list(recordings) for word in ("--from", file_argument(one))],
            option("--robot", robot),
            option("--time", time),
            repeated("--position", position),
            repeated("--velocity", velocity),
            repeated("--command", command),
        )
        return Draft(experiment, finished.output.decode(errors="replace"))

    def fit(self, *, time_limit: Optional[float] = None, progress: Optional[ProgressCallback] = None) -> Fit:
        """Fits the model's free values to the fit trials.

        Parameters
        ----------
        time_limit : float, optional
            Time after which the best values so far are returned, s; `Fit.stopped` then says so.
        progress : callable, optional
            Called with a `Progress`.
        """
        finished = self._work("fit", option("--time-limit", time_limit), progress=progress, may_stop=True)
        return replace(decoded(Fit, finished), stopped=finished.failure)

    def compare(
        self,
        *,
        as_is: bool = False,
        cross_check: bool = False,
        out: Optional[PathLike] = None,
        time_limit: Optional[float] = None,
        progress: Optional[ProgressCallback] = None,
    ) -> Comparison:
        """Fits the model and compares it with every recording. Each comparison of held-out recordings is counted.

        Parameters
        ----------
        as_is : bool, optional
            Compare with the values of the file, without a fit.
        cross_check : bool, optional
            Predict with the other engine, too (`Comparison.cross_check`).
        out : path, optional
            Folder for pictures (SVG) and predictions (CSV).
        time_limit : float, optional
            Time after which `StoppedError` is raised, s; a finished fit is kept.
        progress : callable, optional
            Called with a `Progress`.
        """
        finished = self._work(
            "compare",
            option("--as-is", as_is),
            option("--cross-check", cross_check),
            option("--out", out),
            option("--time-limit", time_limit),
            progress=progress,
        )
        return decoded(Comparison, finished)

    def diagnose(
        self,
        *,
        among: Names = (),
        out: Optional[PathLike] = None,
        time_limit: Optional[float] = None,
        progress: Optional[ProgressCallback] = None,
    ) -> Diagnosis:
        """Finds the physical effect that the model is missing, if any.

        Parameters
        ----------
        among : str or sequence of str, optional
            Try these effects only; ``wrong_value``: fixed values of the robot file. Default: all.
        out : path, optional
            Folder for pictures (SVG).
        time_limit : float, optional
            Time after which a preliminary verdict is returned, s; `Diagnosis.stopped` then says so.
        progress : callable, optional
            Called with a `Progress`.
        """
        effects = listed(among)
        finished = self._work(
            "diagnose",
            ["--among", *effects] if effects else [],
            option("--out", out),
            option("--time-limit", time_limit),
            progress=progress,
            may_stop=True,
        )
        return decoded(Diagnosis, finished)

    def add(
        self,
        effect: Optional[str] = None,
        *,
        answer: bool = False,
        where: Names = (),
        id: Optional[str] = None,
        start: Optional[Mapping[str, float]] = None,
        fixed: Names = (),
        time_limit: Optional[float] = None,
        progress: Optional[ProgressCallback] = None,
    ) -> Change:
        """Adds a physical effect to the experiment file, and fits the model without and with it.

        Parameters
        ----------
        effect : str, optional
            Name in the library, such as ``coulomb_friction``; ``wrong_value``: fit a fixed value of the robot file.
        answer : bool, optional
            Add the effects that the last diagnosis of this model found, instead of a named one.
        where : str or sequence of str, optional
            Elements to place it on, such as ``joint.hinge``; of a wrong value its address. Default: the only one
            possible.
        id : str, optional
            Name of this placement. Default: the effect's.
        start : mapping of str to float, optional
            Start values of its parameters, SI.
        fixed : str or sequence of str, optional
            Parameters that are not fitted.
        time_limit : float, optional
            Time after which `StoppedError` is raised, s; the file stays as it was.
        progress : callable, optional
            Called with a `Progress`.
        """
        if effect is None and not answer:
            raise BadInputError("add: name an effect, or say answer=True for what the last diagnosis found")
        starts = [f"{name}={float(value)!r}" for name, value in (start or {}).items()]
        finished = self._work(
            "add",
            [] if effect is None else [effect],
            option("--answer", answer),
            repeated("--where", where),
            option("--id", id),
            repeated("--start", starts),
            repeated("--fixed", fixed),
            option("--time-limit", time_limit),
            progress=progress,
        )
        return decoded(Change, finished)

    def undo(self, *, progress: Optional[ProgressCallback] = None) -> Change:
        """Takes back the effect, or the freed value, that was added last."""
        return decoded(Change, self._work("undo", progress=progress))

    def history(self, *, out: Optional[PathLike] = None) -> History:
        """Stored error of each revision of the model. Fits nothing and looks at no held-out recording.

        Parameters
        ----------
        out : path, optional
            Folder for a picture (SVG).
        """
        return decoded(History, self._work("history", option("--out", out)))

    def predict(
        self,
        test: Optional[str] = None,
        *,
        duration: Optional[float] = None,
        setup: Optional[str] = None,
        progress: Optional[ProgressCallback] = None,
    ) -> Prediction:
        """Simulates the fitted model, on a test or on the fit trials.

        Parameters
        ----------
        test : str, optional
            Name of a fit trial, a line such as ``triangle motor 0.3 N*m 0.1 Hz 20 s``, or a CSV file of commands.
            Default: all fit trials.
        duration : float, optional
            Duration instead of the test's, s.
        setup : str, optional
            Setup of the recordings, or ``none``. Default: the first recording's.
        progress : callable, optional
            Called with a `Progress`.
        """
        finished = self._work(
            "predict",
            ["--fitted"],
            option("--test", test),
            option("--duration", duration),
            option("--setup", setup),
            progress=progress,
        )
        return decoded(Prediction, finished)

    def trial(
        self,
        test: str,
        *,
        duration: Optional[float] = None,
        setup: Optional[str] = None,
        holdout: bool = False,
        progress: Optional[ProgressCallback] = None,
    ) -> Trial:
        """Carries a test out on a target that takes tests; the database then has the trial.

        Parameters
        ----------
        test : str
            A line such as ``triangle motor 0.3 N*m 0.1 Hz 20 s``, or a CSV file of commands.
        duration : float, optional
            Duration instead of the test's, s.
        setup : str, optional
            Setup of the recordings, or ``none``. Default: the first recording's.
        holdout : bool, optional
            Hold the trial out: no fit reads it.
        progress : callable, optional
            Called with a `Progress`.
        """
        options = _test_options(test, duration, setup, holdout)
        return decoded(Trial, self._work("trial", options, progress=progress))

    def write_commands(
        self,
        test: str,
        csv: PathLike,
        *,
        duration: Optional[float] = None,
        setup: Optional[str] = None,
        holdout: bool = False,
    ) -> CommandTable:
        """Writes the commands of a test as a table for a rig (``lacuna trial --csv``), and carries nothing out.

        Parameters
        ----------
        test : str
            A line such as ``triangle motor 0.3 N*m 0.1 Hz 20 s``, or a CSV file of commands.
        csv : path
            File to write.
        duration, setup, holdout : optional
            As of `trial`.
        """
        options = _test_options(test, duration, setup, holdout)
        return decoded(CommandTable, self._work("trial", options, [f"--csv={os.fspath(csv)}"]))

    def export(
        self,
        *,
        toml: Optional[PathLike] = None,
        urdf: Optional[PathLike] = None,
        mjcf: Optional[PathLike] = None,
        revision: Optional[int] = None,
        progress: Optional[ProgressCallback] = None,
    ) -> Export:
        """Writes the identified robot, and beside it what its format has no place for.

        Parameters
        ----------
        toml, urdf, mjcf : path, optional
            Files to write, at least one.
        revision : int, optional
            Revision of the model. Default: the one that the file describes.
        progress : callable, optional
            Called with a `Progress`.
        """
        finished = self._work(
            "export",
            option("--toml", toml),
            option("--urdf", urdf),
            option("--mjcf", mjcf),
            option("--revision", revision),
            progress=progress,
        )
        return decoded(Export, finished)


def _test_options(test: str, duration: Optional[float], setup: Optional[str], holdout: bool) -> list[str]:
    return [
        *option("--test", test),
        *option("--duration", duration),
        *option("--setup", setup),
        *option("--holdout", holdout),
    ]
