#!/usr/bin/env python3
"""Writes arm.db3 and leg.mcap of this folder: make_bags.py LACUNA. The program simulates the rigs of hidden-arm.toml and
hidden-leg.toml; their readings become messages of ROS 2 as a recorder would have them. Needs nothing but Python."""
import json
import math
import pathlib
import random
import sqlite3
import struct
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
BEGIN = 1_700_000_000_000_000_000  # ns since 1970
PERIOD = 0.01  # s
JOINT_STATE = """std_msgs/Header header
string[] name
float64[] position
float64[] velocity
float64[] effort
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
"""


class Cdr:
    """A message in CDR, little-endian."""

    def __init__(self):
        self.body = b""

    def put(self, kind, value):
        size = struct.calcsize(kind)
        self.body += b"\0" * (-len(self.body) % size) + struct.pack("<" + kind, value)
        return self

    def text(self, text):
        self.put("I", len(text) + 1)
        self.body += text.encode() + b"\0"
        return self

    def doubles(self, values):
        self.put("I", len(values))
        for value in values:
            self.put("d", value)
        return self

    def bytes(self):
        return b"\0\1\0\0" + self.body


def joint_state(time, joints, columns):
    cdr = Cdr().put("i", time // 10**9).put("I", time % 10**9).text("base").put("I", len(joints))
    for joint in joints:
        cdr.text(joint)
    for values in columns:
        cdr.doubles(values)
    return cdr.bytes()


def multisine(parts, amplitude, lowest, highest):
    """Of `parts` frequencies, Hz, with phases that are drawn."""
    lines = [(amplitude * 1.4 / math.sqrt(parts), lowest * (highest / lowest) ** (k / (parts - 1)),
              random.random() * 2 * math.pi) for k in range(parts)]
    return lambda t: sum(a * math.sin(2 * math.pi * f * t + p) for a, f, p in lines)


def commands_table(folder, duration, columns):
    """A CSV file of commands: `columns` has a name with its unit and a function of time each."""
    file = folder / "commands.csv"
    rows = [[PERIOD * i] + [of(PERIOD * i) for _, of in columns] for i in range(round(duration / PERIOD))]
    head = ",".join(["t [s]"] + [name for name, _ in columns])
    file.write_text(head + "\n" + "".join(",".join(f"{value:.5f}" for value in row) + "\n" for row in rows))
    return file


def simulated(lacuna, experiment, folder, commands):
    """Series of a trial by channel."""
    database = folder / "trial.db"
    subprocess.run([lacuna, "trial", HERE / experiment, "--test", commands, "--db", database, "--quiet"], check=True)
    rows = subprocess.run([lacuna, "sql", database, "--json",
                           "SELECT channel, value FROM traces, trace_samples(traces.id) ORDER BY channel, time"],
                          check=True, stdout=subprocess.PIPE, text=True).stdout
    series = {}
    for row in json.loads(rows):
        series.setdefault(row["channel"], []).append(row["value"])
    return series


def times(count):
    return [BEGIN + round(1e9 * PERIOD * i) for i in range(count)]


def write_sqlite_bag(file, topics, messages):
    file.unlink(missing_ok=True)
    bag = sqlite3.connect(file)
    bag.execute("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
                "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL)")
    bag.execute("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL, "
                "data BLOB NOT NULL)")
    for number, (name, kind) in enumerate(topics, 1):
        bag.execute("INSERT INTO topics VALUES (?, ?, ?, 'cdr', '')", (number, name, kind))
    bag.executemany("INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)", messages)
    bag.commit()
    bag.execute("VACUUM")
    bag.close()


def record(opcode, body):
    return bytes([opcode]) + struct.pack("<Q", len(body)) + body


def text(value):
    return struct.pack("<I", len(value)) + value.encode()


def write_mcap(file, topics, messages):
    """`topics` have a name, a type and its definition each."""
    out = bytearray(b"\x89MCAP0\r\n" + record(1, text("ros2") + text("make_bags.py")))
    for number, (name, kind, definition) in enumerate(topics, 1):
        out += record(3, struct.pack("<H", number) + text(kind) + text("ros2msg") + text(definition))
        out += record(4, struct.pack("<HH", number, number) + text(name) + text("cdr") + struct.pack("<I", 0))
    for count, (topic, time, content) in enumerate(messages):
        out += record(5, struct.pack("<HIQQ", topic, count, time, time) + content)
    out += record(15, struct.pack("<I", 0)) + record(2, struct.pack("<QQI", 0, 0, 0)) + b"\x89MCAP0\r\n"
    file.write_bytes(out)


def make_arm(lacuna, folder):
    random.seed(3)
    table = commands_table(folder, 12, [("shoulder [N*m]", multisine(7, 5.0, 0.15, 1.5)),
                                        ("elbow [N*m]", multisine(7, 1.5, 0.2, 2.0))])
    run = simulated(lacuna, "hidden-arm.toml", folder, table)
    joints = ["elbow", "shoulder"]  # in the order of the alphabet, as drivers publish them
    messages = []
    for i, time in enumerate(times(len(run["shoulder"]))):
        columns = [[run[joint + what][i] for joint in joints] for what in ("_position", "_velocity", "")]
        messages.append((1, time + 300_000, joint_state(time, joints, columns)))
    write_sqlite_bag(HERE / "arm.db3", [("/joint_states", "sensor_msgs/msg/JointState")], messages)


def make_leg(lacuna, folder):
    random.seed(5)
    hip, knee = multisine(6, 0.35, 0.2, 2.0), multisine(6, 0.35, 0.25, 2.5)
    others = [leg + joint for leg in ("FR_", "RL_", "RR_") for joint in ("hip", "knee")]
    table = commands_table(folder, 6, [("FL_hip [rad]", hip), ("FL_knee [rad]", lambda t: -0.9 + knee(t))])
    run = simulated(lacuna, "hidden-leg.toml", folder, table)
    joints = ["FL_hip", "FL_knee"] + others
    messages = []
    for i, time in enumerate(times(len(run["FL_hip"]))):
        still = [0.0] * len(others)
        state = [[run["FL_hip_position"][i], run["FL_knee_position"][i]] + still, [], []]
        messages.append((1, time + 200_000, joint_state(time, joints, state)))
        goals = [[run["FL_hip"][i], run["FL_knee"][i]] + still, [], []]
        messages.append((2, time, joint_state(time, joints, goals)))
    kind = "sensor_msgs/msg/JointState"
    write_mcap(HERE / "leg.mcap", [("/joint_states", kind, JOINT_STATE), ("/joint_commands", kind, JOINT_STATE)], messages)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as scratch:
        make_arm(sys.argv[1], pathlib.Path(scratch))
    with tempfile.TemporaryDirectory() as scratch:
        make_leg(sys.argv[1], pathlib.Path(scratch))
