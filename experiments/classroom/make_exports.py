#!/usr/bin/env python3
"""Writes session.csv and video.txt of this folder: make_exports.py LACUNA. The program simulates the pendulum of
hidden-pendulum.toml; its swings become files as a sensor program and a video analysis export them where numbers have
decimal commas. Needs nothing but Python."""
import math
import pathlib
import random
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "bags"))
import make_bags  # noqa: E402

COUNTS_PER_TURN = 4000  # of the rotary sensor
PUSH = 0.3  # s
LATER = 100  # samples from the push to the begin of a recording
PIVOT, RADIUS = (0.127, 0.946), 0.375  # m, in the video


def swing(lacuna, torque, seconds):
    """Angles in rad of a free swing after a push by a hand, 100 a second."""
    with tempfile.TemporaryDirectory() as scratch:
        push = [("hand [N*m]", lambda t: torque if t < PUSH else 0.0)]
        table = make_bags.commands_table(pathlib.Path(scratch), seconds + 2, push)
        angles = make_bags.simulated(lacuna, HERE / "hidden-pendulum.toml", pathlib.Path(scratch), table)["angle"]
    return angles[LATER:LATER + round(seconds / make_bags.PERIOD)]


def comma(number, digits):
    return f"{number:.{digits}f}".replace(".", ",")


def counted(angle):
    step = 2 * math.pi / COUNTS_PER_TURN
    return step * round(angle / step)


def write_session(file, runs):
    """Runs of 50 samples a second side by side, each with a clock of its own; quotes, semicolons and a byte order mark."""
    names = [f'"{name} Run #{run}"' for run in range(1, len(runs) + 1) for name in ("Time (s)", "Angle (rad)")]
    lines = [";".join(names)]
    for i in range(max(map(len, runs))):
        cells = [[comma(0.02 * i, 2), comma(counted(run[i]), 4)] if i < len(run) else ["", ""] for run in runs]
        lines.append(";".join(cell for pair in cells for cell in pair))
    file.write_bytes("\r\n".join(["\ufeff" + lines[0]] + lines[1:] + [""]).encode())


def write_video(file, angles):
    """A tracked weight, 50 pictures a second: its name above the header, tabs."""
    lines = ["mass_A\t\t", "t\tx\ty"]
    for i, angle in enumerate(angles):
        x = PIVOT[0] + RADIUS * math.sin(angle) + random.gauss(0, 0.0007)
        y = PIVOT[1] - RADIUS * math.cos(angle) + random.gauss(0, 0.0007)
        lines.append("\t".join([comma(0.02 * i, 6), comma(x, 6), comma(y, 6)]))
    file.write_text("\n".join(lines + [""]))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    random.seed(2)
    write_session(HERE / "session.csv", [swing(sys.argv[1], torque, seconds)[::2]
                                         for torque, seconds in ((0.36, 14), (0.2, 10), (0.42, 12))])
    write_video(HERE / "video.txt", swing(sys.argv[1], 0.3, 10)[::2])
