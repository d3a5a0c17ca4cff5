#!/usr/bin/env python3
"""A pendulum on a motor as a target of Lacuna: lacuna-process/2 on standard input and output.

It has its own equations and none of Lacuna's. What its model in experiments/robots/servo-pendulum.toml knows nothing of
is dry friction in the hinge.
"""

import json
import math
import random
import sys

# The truth. Inertia is about the hinge, with the motor's rotor; q = 0 is hanging.
INERTIA = 0.005 + 0.50 * 0.20**2 + 0.005  # kg*m^2
GRAVITY_TORQUE = 0.50 * 9.81 * 0.20  # N*m, of the arm when it is horizontal
VISCOUS = 0.021  # N*m*s/rad
COULOMB = 0.030  # N*m; what the model lacks
NOISE = 0.3e-3  # rad, standard deviation of a reading before it is rounded
COUNT = 2.0 * math.pi / 2048  # rad, step of the encoder
LIMIT = 0.6  # N*m, of the motor
STEP = 0.25e-3  # s, of the integration

HELLO = {
    "type": "hello",
    "protocol": "lacuna-process/2",
    "name": "pendulum",
    "modes": ["series", "exchange"],
    "sensors": [{"name": "angle", "unit": "rad"}],
    "actuators": [{"name": "motor", "unit": "N*m", "lower": -LIMIT, "upper": LIMIT}],
}
AT_REST = {"hinge": {"position": 0.0, "velocity": 0.0}}


class Pendulum:
    """Hangs at rest until the motor turns it."""

    def __init__(self, seed):
        self.q = 0.0  # rad
        self.v = 0.0  # rad/s
        self.noise = random.Random(seed)

    def advance(self, torque, seconds):
        steps = max(1, round(seconds / STEP))
        for _ in range(steps):
            self.step(torque, seconds / steps)

    def step(self, torque, h):
        """Semi-implicit Euler. Friction first takes what it can of the momentum: all of it, and the arm sticks."""
        drive = torque - GRAVITY_TORQUE * math.sin(self.q)
        v = (self.v + h * drive / INERTIA) / (1.0 + h * VISCOUS / INERTIA)
        brake = h * COULOMB / INERTIA
        self.v = 0.0 if abs(v) <= brake else v - math.copysign(brake, v)
        self.q += h * self.v

    def angle(self):
        return COUNT * round((self.q + self.noise.gauss(0.0, NOISE)) / COUNT)


def say(message):
    print(json.dumps(message), flush=True)


def listen():
    line = sys.stdin.readline()
    if not line:
        sys.exit(0)  # Lacuna has ended
    return json.loads(line)


def run_series(test):
    pendulum = Pendulum(test["seed"])
    period = test["period"]
    times, samples = [0.0], [[pendulum.angle()]]
    commands = test["commands"]
    place = 0
    for k in range(test["periods"]):
        while place + 1 < len(commands["times"]) and commands["times"][place + 1] <= k * period + 1e-9:
            place += 1
        pendulum.advance(commands["samples"][place][0], period)
        times.append((k + 1) * period)
        samples.append([pendulum.angle()])
    say({"type": "samples", "id": test["id"], "times": times, "samples": samples, "start": AT_REST})


def run_exchange(test):
    pendulum = Pendulum(test["seed"])
    say({"type": "readings", "id": test["id"], "time": 0.0, "sensors": [pendulum.angle()], "start": AT_REST})
    for k in range(test["periods"]):
        torque = listen()["commands"][0]
        pendulum.advance(torque, test["period"])
        time = (k + 1) * test["period"]
        say({"type": "readings", "id": test["id"], "time": time, "sensors": [pendulum.angle()]})


def main():
    while True:
        message = listen()
        if message["type"] == "hello":
            say(HELLO)
        elif message["type"] == "test" and message["mode"] == "series":
            run_series(message)
        elif message["type"] == "test":
            run_exchange(message)
        else:
            say({"type": "error", "message": "there is no message of type " + message["type"]})


main()
