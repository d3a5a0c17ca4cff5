"""Processor time, memory and wall time of a command."""

import os
import pathlib
import shutil
import subprocess
import sys
from typing import NamedTuple

SHORT = 3.0  # s of processor time, up to which a command is measured more than once
ENVIRONMENT = {name: value for name, value in os.environ.items() if name != "LACUNA_PLUGIN_PATH"}
LAUNCH = [sys.executable, "-I", "-S", str(pathlib.Path(__file__).with_name("launch.py"))]


class Cost(NamedTuple):
    seconds: float    # processor time, user and system, of the process and those that it started
    megabytes: float  # peak resident memory of the largest of them
    wall: float       # s


def once(command, folder):
    """Runs in `folder` with an empty folder `scratch`, so that no database has the answer already."""
    scratch = folder / "scratch"
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir()
    with open(folder / "said.txt", "w+", errors="replace") as said:
        launched = subprocess.run([*LAUNCH, *command], cwd=folder, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=said,
                                  text=True)
        code, seconds, kilobytes, wall = launched.stdout.split() or ["unknown", 0, 0, 0]
        if code != "0":
            said.seek(0)
            sys.exit(f"{' '.join(command)} ended with exit code {code}: {said.read(2000)}")
    return Cost(float(seconds), float(kilobytes) * 1024 / 1e6, float(wall))


def cost_of(command, folder, repeats, warm=False):
    """The least of up to `repeats` runs, since other work only adds; `warm`: after one that is not counted."""
    if warm:
        once(command, folder)
    costs = [once(command, folder)]
    while len(costs) < repeats and costs[0].seconds < SHORT:
        costs.append(once(command, folder))
    return Cost(*map(min, zip(*costs)))
