"""Measured points by kind, and the powers of the size that they follow."""

import math
from typing import NamedTuple

from growth_study.studies import VIEW

SLOWEST_VIEW = "slowest view by scores"


class Measured(NamedTuple):
    size: int
    seconds: float
    megabytes: float
    wall: float


class Power(NamedTuple):
    factor: float
    exponent: float

    def at(self, size):
        return self.factor * size**self.exponent


def curves_of(points):
    """By kind, in the order of sizes; of the views, the one that takes longest on the wall at each size."""
    curves = {}
    for (kind, size), cost in points.items():
        curve = curves.setdefault(SLOWEST_VIEW if kind.startswith(VIEW) else kind, {})
        if size not in curve or curve[size].wall < cost.wall:
            curve[size] = Measured(size, *cost)
    return {kind: [curve[size] for size in sorted(curve)] for kind, curve in curves.items()}


def slowest_view(points):
    """Name, size and wall time of the slowest view on the largest database; nothing where none was asked."""
    asked = [(size, cost[2], kind[len(VIEW):]) for (kind, size), cost in points.items() if kind.startswith(VIEW)]
    if not asked:
        return None
    size, wall, view = max(asked)
    return view, size, wall


def upper_half(curve):
    """The points in the upper half of the sizes on a logarithmic scale, at least two."""
    positive = [point for point in curve if point.size > 0]
    middle = math.sqrt(positive[0].size * positive[-1].size) if positive else 0
    half = [point for point in positive if point.size >= 0.999 * middle]
    return half if len(half) > 1 else positive[-2:]


def power_of(curve, value):
    """Least squares on logarithms."""
    logs = [(math.log(point.size), math.log(max(value(point), 1e-3))) for point in upper_half(curve)]
    if len(logs) < 2:
        return None
    mean_x, mean_y = (sum(values) / len(logs) for values in zip(*logs))
    exponent = sum((x - mean_x) * (y - mean_y) for x, y in logs) / sum((x - mean_x)**2 for x, _ in logs)
    return Power(math.exp(mean_y - exponent * mean_x), exponent)


def time_power(curve):
    return power_of(curve, lambda point: point.seconds)


def memory_power(curve):
    return power_of(curve, lambda point: point.megabytes)
