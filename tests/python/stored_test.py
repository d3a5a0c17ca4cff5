"""Time series and tables out of a database that the program wrote."""

from __future__ import annotations

import array
import csv
import hashlib
import json
import math
import os
import subprocess
import sys
import unittest
from pathlib import Path
from typing import Any

import lacuna
from lacuna._stored_traces import stored_traces
from support import WithRig


def rms(values: Any) -> float:
    known = [float(one) for one in values if not math.isnan(one)]
    return math.sqrt(sum(one * one for one in known) / len(known))


class TracesTest(WithRig):
    def test_measured_and_predicted_are_those_of_the_recording_and_the_comparison(self) -> None:
        comparison = self.rig.compare()
        traces = self.rig.traces()
        self.assertEqual(traces.trials, ("sine.csv", "steps.csv", "chirp.csv"))
        chirp = traces["chirp.csv"]
        self.assertEqual((chirp.held_out, chirp.revision, chirp.channels), (True, 1, ("angle",)))
        self.assertEqual(chirp.units, {"angle": "rad", "motor": "N*m"})
        with open("data/servo_pendulum/chirp.csv", newline="") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))[: len(chirp.times)]
        for index in (0, 700, 2000):
            self.assertAlmostEqual(chirp.times[index], float(rows[index]["t_s"]))
            self.assertAlmostEqual(chirp.measured["angle"][index], math.radians(float(rows[index]["angle_deg"])))
            self.assertAlmostEqual(chirp.commands["motor"][index], float(rows[index]["torque_Nm"]))
        # A comparison leaves out the first readings, which tell the start.
        self.assertAlmostEqual(rms(chirp.residual["angle"]) / comparison["chirp.csv"].channels[0].rmse, 1.0, delta=0.02)
        self.assertEqual(len(chirp.to_records()), len(chirp.times))
        self.assertEqual(list(chirp.to_records()[0]), ["time", "angle measured", "angle predicted"])
        self.assertEqual(len(traces[:2]), 2)
        with self.assertRaisesRegex(KeyError, "the trials are sine.csv, steps.csv, chirp.csv"):
            traces["nothing"]

    def test_each_revision_has_its_own_predictions(self) -> None:
        self.rig.compare()
        self.rig.add("coulomb_friction")
        self.assertEqual(self.rig.traces().trials, ("sine.csv", "steps.csv"))  # a change looks at no held-out trial
        self.rig.compare()
        self.assertEqual(self.rig.traces().trials, ("sine.csv", "steps.csv", "chirp.csv"))
        with self.assertRaisesRegex(lacuna.BadInputError, "revision 3 of first-steps was not compared"):
            self.rig.traces(revision=3)
        before, after = self.rig.traces(revision=1)[0], self.rig.traces()[0]
        self.assertEqual((before.revision, after.revision), (1, 2))
        self.assertLess(rms(after.residual["angle"]), rms(before.residual["angle"]) / 5)
        found = self.rig.sql("SELECT revision, change FROM error_by_revision ORDER BY revision")
        self.assertEqual([row["change"] for row in found], ["rigid", "coulomb_friction"])
        self.assertEqual(self.rig.report("page.html", robots=False), self.folder / "page.html")
        self.assertIn("<html", Path("page.html").read_text()[:2000].lower())

    def test_a_database_is_read_without_its_experiment(self) -> None:
        self.rig.fit()
        database = lacuna.Database("first-steps.db")
        self.assertIn("latest_comparison", database.views())
        with self.assertRaises(lacuna.BadInputError) as caught:
            database.sql("SELECT *\nFROM nothing")
        self.assertEqual((caught.exception.file, caught.exception.line), ("SQL", 2))
        self.assertEqual(database.sql("-- a comment\nSELECT 1 AS one, NULL AS none")[0], {"one": 1, "none": None})
        with self.assertRaisesRegex(lacuna.BadInputError, "has nothing of other; its experiments are first-steps"):
            database.traces(experiment="other")
        with self.assertRaises(lacuna.BadInputError):
            lacuna.Database("first-steps.toml").sql("SELECT 1")

    def test_lists_and_dictionaries_do_without_numpy_and_pandas(self) -> None:
        self.rig.compare()
        script = """
import sys
sys.modules["numpy"] = sys.modules["pandas"] = None
import lacuna
rig = lacuna.Experiment("first-steps.toml")
trace = rig.traces()["sine.csv"]
assert type(trace.times) is list and type(trace.measured["angle"]) is list, type(trace.times)
assert type(trace.residual["angle"][0]) is float
print(len(trace.times), trace.measured["angle"][700], rig.history().to_records()[0]["change"])
try:
    rig.history().to_frame()
except ImportError as error:
    print(error)
"""
        done = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True, text=True)
        head, message = done.stdout.splitlines()
        count, value, change = head.split()
        trace = self.rig.traces()["sine.csv"]
        self.assertEqual((int(count), float(value), change), (2001, trace.measured["angle"][700], "rigid"))
        self.assertIn("to_frame needs pandas, which is not installed", message)


class DecodingTest(unittest.TestCase):
    """Bytes of time series, from rows that a database could have."""

    def traces(self, **changes: Any) -> lacuna.Traces:
        times, samples = array.array("d", [0.0, 0.5]), array.array("f", [1.0, -1.0, 2.0, -2.0, 3.0, -3.0])
        head: dict[str, Any] = {
            "channels": json.dumps([{"name": "a", "unit": "rad"}, {"name": "it's", "unit": "1"}]),
            "sample_count": 3,
            "precision": "float32",
        }
        digests = "\n".join(hashlib.sha256(part.tobytes()).hexdigest() for part in (times, samples))
        whole = f"{head['channels']}\n{head['sample_count']}\n{head['precision']}\n{digests}"
        content = {"times": times.tobytes(), "samples": samples.tobytes()}
        head.update(digest=hashlib.sha256(whole.encode()).hexdigest(), times=16, samples=24)
        head.update(changes)

        def query(statement: str) -> list[dict[str, Any]]:
            if "max(revision.number)" in statement:
                return [{"revision": None}]
            if "AS part" in statement:
                column = "times" if "substr(times" in statement else "samples"
                return [{"part": content[column].hex().upper()}]
            if "AS trial, trial.name" in statement:
                return [{"trial": 1, "name": "one", "held_out": 0, "id": 9, "kind": "measured"}]
            return [head]

        return stored_traces(query, "it's", None)

    def test_rows_become_columns_and_a_step_becomes_times(self) -> None:
        one = self.traces()["one"]
        self.assertEqual(list(one.times), [0.0, 0.5, 1.0])
        self.assertEqual([list(one.measured[name]) for name in ("a", "it's")], [[1, 2, 3], [-1, -2, -3]])
        self.assertEqual((one.revision, dict(one.predicted), dict(one.commands)), (None, {}, {}))

    def test_damaged_bytes_are_noticed(self) -> None:
        with self.assertRaisesRegex(lacuna.CommandFailedError, "time series 9: is damaged"):
            self.traces(sample_count=2)


class FramesTest(WithRig):
    def test_tables_become_data_frames(self) -> None:
        try:
            import pandas
        except ImportError:
            self.skipTest("pandas is not installed (Debian: python3-pandas)")
        frame = self.rig.fit().to_frame()
        self.assertIsInstance(frame, pandas.DataFrame)
        self.assertEqual(list(frame.columns)[:4], ["address", "unit", "start", "value"])
        self.assertGreater(frame.set_index("address").loc["body.arm.mass", "value"], 0.3)
        traces = self.rig.predict().to_frame()
        self.assertEqual(set(traces["channel"]), {"angle"})

    def test_arrays_are_numpys(self) -> None:
        try:
            import numpy
        except ImportError:
            self.skipTest("numpy is not installed (Debian: python3-numpy)")
        self.rig.compare()
        trace = self.rig.traces()[0]
        for values in (trace.times, trace.measured["angle"], trace.predicted["angle"], trace.residual["angle"]):
            self.assertIsInstance(values, numpy.ndarray)
            self.assertEqual(values.dtype, numpy.float64)

    def test_notebooks_show_a_table_with_nothing_of_a_name_carried_out(self) -> None:
        html = lacuna.Rows([{"a<b>": 1.23456, "c": None, "d": "<script>"}])._repr_html_()
        self.assertIn("<th>a&lt;b&gt;</th>", html)
        self.assertIn("<td>1.235</td><td></td><td>&lt;script&gt;</td>", html)


if __name__ == "__main__":
    unittest.main()
