#!/usr/bin/env python3
"""Writes long recordings of an arm of six joints, to measure how fast formats are read: make_big.py SECONDS FOLDER makes
big.mcap, big.db3, big.jsonl and big.npy there, of 100 samples a second (docs/explanation/formats.md)."""
import json
import math
import pathlib
import struct
import sys

import make_bags

JOINTS = ["shoulder_yaw", "shoulder_pitch", "elbow_pitch", "elbow_roll", "wrist_pitch", "wrist_roll"]


def sample(i):
    """Positions, velocities and torques of the joints."""
    t = make_bags.PERIOD * i
    phases = [0.3 * t + k for k in range(6)]
    return [[0.5 * math.sin(p) for p in phases], [0.15 * math.cos(p) for p in phases], [3.0 * math.cos(p) for p in phases]]


def time_of(i):
    return make_bags.BEGIN + i * 10_000_000


def messages(count):
    return [(1, time_of(i), make_bags.joint_state(time_of(i), JOINTS, sample(i))) for i in range(count)]


def write_lines(file, count):
    with open(file, "w") as out:
        for i in range(count):
            position, velocity, effort = sample(i)
            out.write(json.dumps({"t": make_bags.PERIOD * i, "joints": {"name": JOINTS, "position": position,
                                                                        "velocity": velocity, "effort": effort}}) + "\n")


def write_array(file, count):
    """An array of NumPy: a row a sample."""
    head = "{'descr': '<f8', 'fortran_order': False, 'shape': (%d, 19), }" % count
    head += " " * (-(len(head) + 11) % 64) + "\n"
    with open(file, "wb") as out:
        out.write(b"\x93NUMPY\1\0" + struct.pack("<H", len(head)) + head.encode())
        for i in range(count):
            out.write(struct.pack("<19d", make_bags.PERIOD * i, *(value for part in sample(i) for value in part)))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    count, folder = round(float(sys.argv[1]) / make_bags.PERIOD), pathlib.Path(sys.argv[2])
    bag = messages(count)
    kind = "sensor_msgs/msg/JointState"
    make_bags.write_mcap(folder / "big.mcap", [("/joint_states", kind, make_bags.JOINT_STATE)], bag)
    make_bags.write_sqlite_bag(folder / "big.db3", [("/joint_states", kind)], bag)
    write_lines(folder / "big.jsonl", count)
    write_array(folder / "big.npy", count)
