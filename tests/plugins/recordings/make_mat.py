#!/usr/bin/env python3
"""Writes the recordings of this folder in MATLAB's format: make_mat.py, with SciPy 1.10."""
import pathlib

import make_numpy
import numpy
import scipy.io

here = pathlib.Path(__file__).parent
t = 1.7e9 + 0.001 * numpy.arange(5)
q = numpy.arange(10).reshape(5, 2) / 4
log = {"time": t, "q": q, "wide": -q.T, "counts": numpy.arange(5, dtype=numpy.uint16), "label": "run 1",
       "inner": {"on": numpy.array([True, False, True, False, True])}}
scipy.io.savemat(here / "run.mat", {"log": log, "gains": numpy.ones((2, 3)), "rate": 1000.0}, do_compression=False)
scipy.io.savemat(here / "run_compressed.mat", {"time": t.astype(numpy.float32) * 0 + numpy.arange(5), "q": q,
                                               "cells": numpy.array([1, "a"], dtype=object), "z": q + 1j,
                                               "list": numpy.array([(1,), (2,)], dtype=[("x", "O")])},
                 do_compression=True)

time, angle, rate, torque = make_numpy.pendulum()
scipy.io.savemat(here / "arm.mat", {"log": {"t": time, "hinge_position": angle, "hinge_velocity": rate,
                                            "hinge_effort": torque}}, do_compression=True)
