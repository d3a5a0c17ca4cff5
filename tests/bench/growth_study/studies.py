"""What is measured: of each study the points, each with a way to make its inputs and a command."""

import functools
import pathlib
import subprocess
from typing import Callable, NamedTuple

from growth_study import rigs

SAMPLES_A_TRIAL = 1000
SAMPLES_WITH_EFFECTS = 2000
VIEW = "view "  # begins the kinds of the views


class Tools(NamedTuple):
    lacuna: str
    generator: str  # of databases
    folder: pathlib.Path


class Point(NamedTuple):
    kind: str
    size: int
    prepare: Callable[[], None]
    command: list
    warm: bool = False


def trials(tools, sizes):
    folder, prepared = tools.folder, functools.cache(lambda: cut_recordings(tools, sizes[-1]))
    for size in sizes:
        def prepare(size=size):
            prepared()
            rigs.write_fit(folder, [f"trial{i}.csv" for i in range(size)], 1)
        yield Point("fit by trials", size, prepare, fitting(tools, "fit"))


def cut_recordings(tools, count):
    series = rigs.simulate(tools.lacuna, tools.folder, 1, count * SAMPLES_A_TRIAL)
    for i in range(count):
        begin = i * SAMPLES_A_TRIAL
        rigs.write_recording(tools.folder / f"trial{i}.csv", *series, begin, begin + SAMPLES_A_TRIAL)


def samples(tools, sizes):
    folder, prepared = tools.folder, functools.cache(lambda: long_recordings(tools, sizes))
    for size in sizes:
        for command in ("fit", "compare"):
            def prepare(size=size):
                prepared()
                rigs.write_fit(folder, [f"samples{size}.csv"], 1)
            yield Point(f"{command} by samples", size, prepare, fitting(tools, command))


def long_recordings(tools, sizes):
    series = rigs.simulate(tools.lacuna, tools.folder, 1, sizes[-1])
    for size in sizes:
        rigs.write_recording(tools.folder / f"samples{size}.csv", *series, 0, size)


def joints(tools, sizes):
    for size in sizes:
        prepare = functools.partial(rigs.write_run, tools.folder, size, 50, as_usual=False)
        yield Point("run by joints", size, prepare, running(tools))


def population(tools, sizes):
    for size in sizes:
        prepare = functools.partial(rigs.write_run, tools.folder, 2, size)
        yield Point("run by population", size, prepare, running(tools))


def effects(tools, sizes):
    for size in sizes:
        prepare = functools.partial(rigs.write_run, tools.folder, rigs.JOINTS_OF_EFFECTS, 50, size, as_usual=False)
        yield Point("run by effects", size, prepare, running(tools))
        prepare = functools.partial(recording_with_effects, tools, size)
        yield Point("compare by effects", size, prepare, fitting(tools, "compare"))


def recording_with_effects(tools, count):
    """The target has the effects that the model has, with other values."""
    joint_count, hidden = rigs.JOINTS_OF_EFFECTS, rigs.effects("target", count, True)
    series = rigs.simulate(tools.lacuna, tools.folder, joint_count, SAMPLES_WITH_EFFECTS, hidden)
    rigs.write_recording(tools.folder / "effects.csv", *series, 0, SAMPLES_WITH_EFFECTS)
    rigs.write_fit(tools.folder, ["effects.csv"], joint_count, count)


def database(tools, sizes):
    for size in sizes:
        file = tools.folder / f"scores{size}.db"
        prepare = functools.partial(grown_database, tools, file, size)
        yield Point("runs by scores", size, prepare, [tools.lacuna, "runs", file.name], warm=True)
        for view, question in views(tools):
            yield Point(VIEW + view, size, prepare, [tools.lacuna, "sql", file.name, question], warm=True)
        for kind, command in (("verify", ["verify", file.name, "--quiet"]),
                              ("report", ["report", file.name, "--out", "scratch/page.html", "--quiet"]),
                              ("merge", ["merge", "scratch/all.db", file.name, "--quiet"])):
            yield Point(f"{kind} by scores", size, prepare, [tools.lacuna, *command])
        file.unlink(missing_ok=True)


def grown_database(tools, file, scores):
    if not file.exists():
        subprocess.run([tools.generator, file, str(scores)], check=True, stdout=subprocess.DEVNULL)


def views(tools):
    """Each documented view with its example, from triples of lines: name, meaning, example."""
    asked = subprocess.run([tools.lacuna, "sql", "--views"], check=True, stdout=subprocess.PIPE, text=True)
    said = asked.stdout.splitlines()
    return [(said[i], said[i + 2].strip()) for i in range(0, len(said), 3)]


def fitting(tools, command):
    return [tools.lacuna, command, "fit.toml", "--db", "scratch/fit.db", "--threads", "1"]


def running(tools):
    return [tools.lacuna, "run", "run.toml", "--db", "scratch/run.db", "--threads", "1", "--quiet"]


# name: the points, their sizes, those of --quick
STUDIES = {
    "trials": (trials, [1, 2, 4, 8, 16, 32, 64], [1, 2, 4]),
    "samples": (samples, [1000, 3162, 10_000, 31_623, 100_000, 316_228], [1000, 4000]),
    "joints": (joints, [1, 2, 3, 4, 6, 8, 10, 12], [1, 2]),
    "population": (population, [25, 50, 100, 200, 400, 800, 1600], [10, 40]),
    "effects": (effects, [0, 1, 2, 4, 8, 16, 32], [1, 2]),
    "database": (database, [10_000, 100_000, 1_000_000, 3_162_278, 10_000_000], [1000, 4000]),
}
