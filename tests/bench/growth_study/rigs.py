"""Robots, recordings and experiments of any size, the same each time: chains of hinges, simulated by the program."""

import array
import contextlib
import math
import random
import sqlite3
import subprocess

INTERVAL = 5e-3  # s, of commands and readings; one integration step each

LINK = """
[body.link{i}]
mass = 0.4
at = [0.0, 0.0, {at}]
com = [0.0, 0.0, -0.1]
inertia = [0.002, 0.002, 0.001]

[joint.joint{i}]
kind = "hinge"
{parent}child = "link{i}"
anchor = [0.0, 0.0, {at}]
axis = "y"
damping = 0.05

[actuator.motor{i}]
joint = "joint{i}"
kind = "force"
force_limit = 1.0

[sensor.angle{i}]
kind = "joint_position"
joint = "joint{i}"
noise = "0.3 mrad"
"""

SIMULATED = """
[target]
kind = "simulated"
file = "chain{joints}.toml"
noise = {{ "sensor.angle*" = "0.3 mrad" }}
hidden = {{ "body.link0.mass" = {{ uniform = [0.3, 0.5] }} }}
hidden_seed = 4
"""

MODEL = """
[model]
file = "chain{joints}.toml"
free = {{ "body.link0.mass" = [0.1, 1.0], "joint.joint0.damping" = [0.0, 0.2] }}

[engine]
step = "5 ms"
substeps = 1
"""

RUN = """
[test]
encoding = "command_series"
duration = "5 s"

[estimation]
parameters = {{ population = {population}, keep = {keep}, generations = 10 }}
abandon = {as_usual}
reuse = {as_usual}

[exploration]
fitness = "random"
parameters = {{ population = 2, keep = 1, generations = 1 }}
"""

FIT = """
[fit]
method = "free_run"
starts = 1
"""

# effect, place, its free value in the target, what of it is fixed
EFFECTS = [
    ("quadratic_drag", "body.link", "area = 1.0", '"density"'),
    ("joint_spring", "joint.joint", "stiffness = 0.1", '"rest"'),
    ("joint_offset_torque", "joint.joint", "torque = 0.01", ""),
    ("armature", "joint.joint", "inertia = 0.002", ""),
    ("cubic_stiffness", "joint.joint", "stiffness = 0.05", '"rest"'),
    ("torque_gain", "actuator.motor", "gain = 0.95", ""),
    ("sensor_scale", "sensor.angle", "scale = 1.02", ""),
    ("sensor_offset", "sensor.angle", "offset = 0.01", ""),
]
JOINTS_OF_EFFECTS = 4


def chain(joints):
    text = '[robot]\nname = "chain"\n'
    for i in range(joints):
        text += LINK.format(i=i, at=round(-0.2 * i, 3), parent=f'parent = "link{i - 1}"\n' if i else "")
    return text


def effects(section, count, in_target):
    """The first `count` of 32: kinds in turns, the joint changes after each."""
    text = ""
    for i in range(count):
        effect, place, value, fixed = EFFECTS[i // JOINTS_OF_EFFECTS]
        if in_target:
            fixed = ", ".join(filter(None, [fixed, f'"{value.split()[0]}"']))
        start = f"start = {{ {value} }}\n" if in_target else ""
        text += (f'\n[[{section}.effects]]\nid = "effect{i}"\neffect = "{effect}"\n'
                 f'where = "{place}{i % JOINTS_OF_EFFECTS}"\n{start}fixed = [{fixed}]\n')
    return text


def experiment(name, target, joints, model_effects="", more=""):
    heading = f'[experiment]\nname = "{name}"\nseed = 1\npasses = 1\n'
    return heading + target + MODEL.format(joints=joints) + model_effects + more


def write_run(folder, joints, population, effect_count=0, as_usual=True):
    """An experiment for `lacuna run`; not as usual: every model is simulated to the end of each trial."""
    (folder / f"chain{joints}.toml").write_text(chain(joints))
    target = SIMULATED.format(joints=joints) + effects("target", effect_count, True)
    run = RUN.format(population=population, keep=population // 2, as_usual=str(as_usual).lower())
    (folder / "run.toml").write_text(experiment("run", target, joints, effects("model", effect_count, True), run))


def write_commands(file, joints, samples):
    """Five sines for each motor, of 0.2 to 3 Hz, with random phases."""
    chance = random.Random(7)
    waves = [[(chance.uniform(0.2, 3.0), chance.uniform(0.0, 2.0 * math.pi)) for _ in range(5)] for _ in range(joints)]
    with open(file, "w") as out:
        print("t," + ",".join(f"motor{i}" for i in range(joints)), file=out)
        for n in range(samples):
            t = INTERVAL * n
            values = [0.08 * sum(math.sin(2.0 * math.pi * f * t + phase) for f, phase in wave) for wave in waves]
            print(f"{t:.3f}," + ",".join(f"{value:.6f}" for value in values), file=out)


def simulate(lacuna, folder, joints, samples, target_effects=""):
    """Commands and noisy readings of a chain: lists of channels."""
    (folder / f"chain{joints}.toml").write_text(chain(joints))
    target = SIMULATED.format(joints=joints) + target_effects
    test = '\n[test]\nencoding = "command_series"\n'
    (folder / "recorded.toml").write_text(experiment("recorded", target, joints, more=test))
    write_commands(folder / "commands.csv", joints, samples)
    database = folder / "recorded.db"
    database.unlink(missing_ok=True)
    subprocess.run([lacuna, "trial", "recorded.toml", "--test", "commands.csv", "--quiet"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    return [trace(database, kind) for kind in ("commands", "measured")]


def trace(database, kind):
    with contextlib.closing(sqlite3.connect(database)) as connection:
        count, blob = connection.execute("SELECT sample_count, samples FROM trace WHERE kind = ?", (kind,)).fetchone()
    values = array.array("d", blob)
    channels = len(values) // count  # a row has a value of each
    return [values[i::channels] for i in range(channels)]


def write_recording(file, commands, readings, begin, end):
    with open(file, "w") as out:
        names = [f"motor{i}" for i in range(len(commands))] + [f"angle{i}" for i in range(len(readings))]
        print("t," + ",".join(names), file=out)
        for n in range(begin, min(end, len(readings[0]))):
            values = [channel[n] for channel in commands + readings]
            print(f"{INTERVAL * (n - begin):.3f}," + ",".join(f"{value:.7g}" for value in values), file=out)


def write_fit(folder, files, joints, effect_count=0):
    """An experiment for `lacuna fit` and `lacuna compare`."""
    target = "\n[target]\nfiles = [" + ", ".join(f'"{file}"' for file in files) + "]\n"
    for i in range(joints):
        target += f'\n[target.sensors.angle{i}]\ncolumn = "angle{i}"\nunit = "rad"\n'
        target += f'\n[target.commands.motor{i}]\ncolumn = "motor{i}"\nunit = "N*m"\n'
    (folder / f"chain{joints}.toml").write_text(chain(joints))
    (folder / "fit.toml").write_text(experiment("fit", target, joints, effects("model", effect_count, False), FIT))
