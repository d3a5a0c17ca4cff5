"""What several tests share: a folder with the rig of experiments/first-steps.toml, and the built program."""

from __future__ import annotations

import os
import shutil
import tempfile
import unittest
from pathlib import Path

import lacuna

SOURCE = Path(__file__).resolve().parents[2]
EXPERIMENTS = SOURCE / "experiments"


def copy_first_steps(folder: Path) -> None:
    """Three recordings of a pendulum on a motor, half of each, and a rigid model of it."""
    shutil.copy(EXPERIMENTS / "first-steps.toml", folder)
    for name in ("robots", "data"):
        (folder / name).mkdir()
    shutil.copy(EXPERIMENTS / "robots" / "servo-pendulum.toml", folder / "robots")
    shutil.copytree(EXPERIMENTS / "data" / "servo_pendulum", folder / "data" / "servo_pendulum")


class InFolder(unittest.TestCase):
    """Each test in a folder of its own, which is the current one."""

    def setUp(self) -> None:
        if not os.environ.get("LACUNA"):
            self.fail("the environment variable LACUNA must name the built program")
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        folder = tempfile.TemporaryDirectory(prefix="lacuna-python-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name).resolve()
        os.chdir(self.folder)


class WithRig(InFolder):
    """With the rig of first steps in that folder."""

    def setUp(self) -> None:
        super().setUp()
        copy_first_steps(self.folder)
        self.rig = lacuna.Experiment("first-steps.toml")

    def edit(self, file: str, old: str, new: str) -> None:
        """Replaces a text that must be there."""
        text = Path(file).read_text()
        self.assertIn(old, text)
        Path(file).write_text(text.replace(old, new))
