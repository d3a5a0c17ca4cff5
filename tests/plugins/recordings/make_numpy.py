#!/usr/bin/env python3
"""Writes the recordings of this folder that NumPy makes: make_numpy.py, with NumPy 1.24."""
import pathlib

import numpy

here = pathlib.Path(__file__).parent
t = 1.7e9 + 0.001 * numpy.arange(5)
q = numpy.arange(10).reshape(5, 2) / 4
numpy.savez(here / "run.npz", t=t, q=q, tau=numpy.asfortranarray(-q), rate=1000.0, mass=numpy.ones(3),
            name=numpy.array(["a", "b", "c", "d", "e"]))
numpy.savez_compressed(here / "run_compressed.npz", t=t, q=q)
state = numpy.zeros(3, dtype=[("stamp", "<M8[ns]"), ("label", "U4"), ("joint", [("q", ">f4", (2,)), ("on", "?")]),
                              ("counts", "<u2")])
state["stamp"] = numpy.array([1700000000000000001, 1700000000500000000, 1700000001000000000], dtype="M8[ns]")
state["joint"]["q"] = [[0.5, 1], [1.5, 2], [2.5, 3]]
state["joint"]["on"] = [True, False, True]
state["counts"] = [1, 65535, 3]
numpy.save(here / "structured.npy", state)
numpy.save(here / "fortran.npy", numpy.asfortranarray(numpy.arange(12, dtype=">i4").reshape(3, 2, 2) - 6))


def pendulum():
    """The pendulum of make_bags.mjs: times, s, angles, rad, velocities and torques."""
    angle, rate, rows = 0.1, 0.0, []
    for i in range(200):
        torque = 0.5 * numpy.sin(0.03 * i) + 0.2 * numpy.sin(0.11 * i)
        rows.append((0.01 * i, angle, rate, torque))
        for _ in range(10):
            rate += 0.001 * ((torque - 9.81 * 0.2 * numpy.sin(angle) - 0.05 * rate) / 0.05)
            angle += 0.001 * rate
    return numpy.array(rows).T


if __name__ == "__main__":
    time, angle, rate, torque = pendulum()
    numpy.savez_compressed(here / "arm.npz", t=time, hinge_position=angle, hinge_velocity=rate, hinge_effort=torque)
