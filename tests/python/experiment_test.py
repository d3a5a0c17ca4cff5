"""The commands of an experiment, by the real program on a small real rig."""

from __future__ import annotations

import dataclasses
import math
import os
import pickle
import shutil
import typing
import unittest
from pathlib import Path
from typing import Any

import lacuna
from support import EXPERIMENTS, WithRig


class CheckTest(WithRig):
    def test_says_what_was_read(self) -> None:
        check = self.rig.check()
        self.assertEqual((check.experiment, check.database, check.target), ("first-steps", "first-steps.db", "recorded"))
        self.assertEqual(check.robot.joints, ("hinge",))
        self.assertEqual([one.address for one in check.free][:1], ["body.arm.mass"])
        self.assertEqual([(one.trial, one.held_out) for one in check.trials][2], ("chirp.csv", True))
        self.assertAlmostEqual(check.trials[0].duration, 4.0)
        angle = check.channel("angle")
        assert angle is not None
        self.assertEqual((angle.kind, angle.column_unit, angle.unit), ("measured", "deg", "rad"))
        self.assertLess(angle.smallest, angle.largest)
        self.assertIsNone(check.channel("nothing"))
        self.assertFalse(Path("first-steps.db").exists())

    def test_overrides_are_put_beside_the_file(self) -> None:
        rig = lacuna.Experiment("first-steps.toml", overrides={"target.commands.motor.unit": "mN*m"}, n_jobs=1)
        check = rig.check()
        self.assertIn("N*m", check.notes[0].message)
        self.assertEqual(lacuna.Experiment("first-steps.toml", overrides={"model.free": {}}).check().free, ())

    def test_all_problems_are_named_at_once_with_their_places(self) -> None:
        self.edit("first-steps.toml", 'step = "2 ms"', 'step = "2 mm"\nstepp = 1')
        with self.assertRaises(lacuna.BadInputError) as caught:
            self.rig.check()
        error = caught.exception
        self.assertEqual(len(error.problems), 2)
        lines = Path("first-steps.toml").read_text().splitlines()
        for problem, text in zip(error.problems, ("step = ", "stepp")):
            self.assertTrue((problem.file or "").endswith("first-steps.toml"))
            self.assertTrue(lines[(problem.line or 0) - 1].startswith(text), problem)

    def test_broken_toml_and_missing_files_are_refused_with_the_place(self) -> None:
        Path("broken.toml").write_text('[experiment]\nname = "a\n')
        with self.assertRaises(lacuna.BadInputError) as caught:
            lacuna.Experiment("broken.toml").check()
        self.assertEqual((caught.exception.file, caught.exception.line), ("broken.toml", 2))
        with self.assertRaises(lacuna.BadInputError) as caught:
            lacuna.Experiment("nowhere.toml").compare()
        self.assertEqual(caught.exception.file, "nowhere.toml")
        self.assertEqual(caught.exception.exit_code, 2)
        os.remove("data/servo_pendulum/sine.csv")
        with self.assertRaises(lacuna.BadInputError) as caught:
            self.rig.check()
        self.assertIn("sine.csv", str(caught.exception))

    def test_commands_run_where_the_experiment_was_named(self) -> None:
        os.mkdir("elsewhere")
        os.chdir("elsewhere")
        self.assertEqual(self.rig.check().experiment, "first-steps")
        self.assertEqual(self.rig.folder, self.folder)


class LoopTest(WithRig):
    """One way through the loop, as each step needs the one before."""

    def test_the_missing_effect_is_found_added_and_taken_back(self) -> None:
        comparison = self.rig.compare()
        self.assertGreater(comparison.times_floor()["angle"], 10)
        self.assertEqual(comparison.held_out_look, 1)
        self.assertTrue(comparison.refitted)
        self.assertGreater(comparison.fit["body.arm.mass"].value, 0.3)
        self.assert_complete(comparison)

        diagnosis = self.rig.diagnose(among=["coulomb_friction", "cogging"])
        self.assertEqual(diagnosis.verdict, "effect_found")
        assert diagnosis.answer is not None
        self.assertEqual(str(diagnosis.answer), "coulomb_friction @ joint.hinge")
        torque = diagnosis.answer.effects[0].parameters["torque"]
        self.assertEqual(torque.unit, "N*m")
        self.assertTrue(torque.ci95[0] < torque.value < torque.ci95[1])
        self.assertEqual([row["rank"] for row in diagnosis.to_records()][:2], [1, 2])
        self.assert_complete(diagnosis)

        change = self.rig.add(answer=True)
        self.assertEqual((change.before.revision, change.after.revision), (1, 2))
        self.assertLess(change.to_records()[0]["times_floor_after"], 1.2)
        self.assertIn("coulomb_friction", Path("first-steps.toml").read_text())
        self.assert_complete(change)

        self.check_what_is_stored()
        self.check_the_export()

        back = self.rig.undo()
        self.assertEqual(back.after.revision, 1)
        self.assertIsNone(back.undo)
        self.assertNotIn("coulomb_friction", Path("first-steps.toml").read_text())

    def check_what_is_stored(self) -> None:
        history = self.rig.history()
        self.assertEqual([one.change for one in history.revisions], ["rigid", "coulomb_friction"])
        self.assertEqual([one.current for one in history.revisions], [False, True])
        self.assertIn("not compared", history.missing or "")
        self.assertTrue(math.isnan(history.revisions[1].held_out_rmse))
        self.assert_complete(history)
        fit = self.rig.fit()
        self.assertTrue(fit.converged)
        self.assertEqual(fit.to_dict()["effect.coulomb_friction.torque"], fit["effect.coulomb_friction.torque"].value)
        with self.assertRaisesRegex(KeyError, "body.arm.mass"):
            fit["nothing"]
        self.assert_complete(fit)
        prediction = self.rig.predict("triangle motor 0.3 N*m 0.5 Hz 2 s")
        self.assertEqual(len(prediction.times()), len(prediction.predicted("angle")))
        self.assertIsNone(prediction.predictions[0].channels[0].measured)
        with self.assertRaisesRegex(ValueError, "nothing was measured"):
            prediction.residual("angle")
        self.assert_complete(prediction)
        replayed = self.rig.predict()
        errors = replayed.residual("angle", "sine.csv")
        self.assertLess(math.sqrt(sum(one * one for one in errors) / len(errors)), 0.002)

    def check_the_export(self) -> None:
        exported = self.rig.export(urdf="found.urdf", toml="identified.toml")
        self.assertEqual([one.format for one in exported.files], ["urdf", "toml"])
        for one in exported.files:
            self.assertTrue(Path(one.file).exists() and Path(one.model_file).exists())
        self.assert_complete(exported)
        table = self.rig.write_commands("triangle motor 0.3 N*m 0.1 Hz 20 s", "commands.csv")
        self.assertEqual((table.file, table.setup, table.held_out), ("commands.csv", None, False))
        self.assertAlmostEqual(table.duration, 20.0)
        self.assertEqual(Path("commands.csv").read_text().splitlines()[0].split(",")[0], "t [s]")

    def assert_complete(self, result: Any) -> None:
        """Every member of the program's answer has a field; `where` of a comparison is in `raw` alone."""
        self.assertEqual(sorted(_left_out(type(result), result.raw) - {"where"}), [])
        self.assertEqual(pickle.loads(pickle.dumps(result)).raw, result.raw)

    def test_an_effect_that_is_unknown_comes_with_the_nearest_name(self) -> None:
        with self.assertRaises(lacuna.BadInputError) as caught:
            self.rig.add("coulomb_frictio")
        self.assertIn("coulomb_friction", caught.exception.remedy or "")
        with self.assertRaisesRegex(lacuna.BadInputError, "name an effect, or say answer=True"):
            self.rig.add()

    def test_starts_places_and_fixed_parameters_reach_the_file(self) -> None:
        self.rig.add("stribeck_friction", where="joint.hinge", id="s", start={"coulomb": 0.02}, fixed=["velocity"])
        text = Path("first-steps.toml").read_text()
        for part in ('"s"', "joint.hinge", "coulomb = 0.02", 'fixed = ["velocity"]'):
            self.assertIn(part, text)


class NewTest(WithRig):
    def test_drafts_an_experiment_and_says_what_is_left(self) -> None:
        files = ["data/servo_pendulum/sine.csv", "data/servo_pendulum/steps.csv"]
        draft = lacuna.Experiment.new("drafted.toml", files, position="angle_deg")
        self.assertTrue(Path("drafted.toml").exists() and Path("drafted-robot.toml").exists())
        self.assertIn("fill in", draft.text)
        self.assertEqual(draft.experiment.path, "drafted.toml")
        with self.assertRaisesRegex(lacuna.CommandFailedError, "already exists"):
            lacuna.Experiment.new("drafted.toml", files)


class TrialTest(WithRig):
    def test_carries_a_test_out_on_a_target_that_takes_tests(self) -> None:
        shutil.copytree(EXPERIMENTS / "smoke", "smoke")
        rig = lacuna.Experiment("smoke/simulated-pendulum.toml")
        trial = rig.trial("triangle motor 0.3 N*m 1 Hz 1 s", holdout=True)
        self.assertEqual((trial.trial, trial.held_out, trial.duration), ("trial-1", True, 1.0))
        self.assertGreater(trial.samples, 100)
        traces = rig.traces()
        self.assertEqual(traces.trials, ("trial-1",))
        self.assertEqual(len(traces[0].times), trial.samples)
        self.assertEqual(dict(traces[0].predicted), {})


class PluginsTest(unittest.TestCase):
    def test_lists_what_experiment_files_can_name(self) -> None:
        effects = lacuna.plugins("effect")
        self.assertIn("coulomb_friction", [one.name for one in effects.components])
        self.assertEqual({one.kind for one in effects.components}, {"effect"})
        with self.assertRaisesRegex(lacuna.BadInputError, "there is no such kind"):
            lacuna.plugins("efect")


def _left_out(kind: type, document: Any) -> set[str]:
    """Members of a document that a dataclass has no field for."""
    names = {one.metadata.get("json", one.name): one.name for one in dataclasses.fields(kind)}
    hints = typing.get_type_hints(kind)
    left = set(document) - set(names)
    for name, value in document.items():
        for inner in _classes_in(hints.get(names.get(name, ""), Any)):
            for one in _objects_in(value):
                left |= _left_out(inner, one)
    return left


def _classes_in(hint: Any) -> list[type]:
    if dataclasses.is_dataclass(hint):
        return [typing.cast(type, hint)]
    return [one for inner in typing.get_args(hint) for one in _classes_in(inner)]


def _objects_in(value: Any) -> list[Any]:
    """Of lists and of mappings from names to objects the objects, else the value itself."""
    if isinstance(value, list):
        return value
    if isinstance(value, dict):
        return list(value.values()) if value and all(isinstance(one, dict) for one in value.values()) else [value]
    return []


if __name__ == "__main__":
    unittest.main()
