"""A table and a picture of what was measured."""

import math
import os
import subprocess

from growth_study.exponents import memory_power, time_power, upper_half

BLUE, ORANGE = "#0072B2", "#D55E00"
COLUMNS, WIDTH, HEIGHT, MARGIN = 3, 330, 270, 62  # of panels; px of one; px beside it
UNITS = {"trials": "recordings", "samples": "samples", "joints": "joints", "population": "models a generation",
         "effects": "effects", "scores": "scores of models"}

BEGINNING = """set terminal svg size {width},{height} font "sans-serif,12" background "white"
set multiplot
set grid lc rgb "#E4E4E4" lt 1
set border 11 lc rgb "#7A7A7A"
set tics textcolor rgb "#333333" nomirror
set logscale xyy2
set format y "%g"
set format y2 "%g"
set ytics nomirror
set y2tics
set key off
set ylabel "processor time, s" textcolor rgb "{blue}" offset 1.2,0
set y2label "peak memory, MB" textcolor rgb "{orange}" offset -1.2,0
"""


def table(curves):
    lines = ["| command | sizes | time | memory | time ∝ size to the | memory ∝ size to the |",
             "| --- | --- | --- | --- | --- | --- |"]
    for kind, curve in curves.items():
        first, last = curve[0], curve[-1]
        lines.append(f"| {kind} | {spaced(first.size)} … {spaced(last.size)} | "
                     f"{first.seconds:.3g} → {last.seconds:.3g} s | {first.megabytes:.0f} → {last.megabytes:.0f} MB | "
                     f"{exponent(time_power(curve))} | {exponent(memory_power(curve))} |")
    return "\n".join(lines)


def spaced(number):
    return f"{number:,}".replace(",", " ")


def exponent(power):
    return f"{round(power.exponent, 2) + 0.0:.2f}" if power else "-"


def draw(curves, file):
    drawn = {kind: curve for kind, curve in curves.items() if time_power(curve)}
    rows = -(-len(drawn) // COLUMNS)
    script = BEGINNING.format(width=COLUMNS * WIDTH, height=rows * HEIGHT, blue=BLUE, orange=ORANGE)
    for place, (kind, curve) in enumerate(drawn.items()):
        script += data(curve, place) + frame(place, rows) + axes(kind, curve) + plot(curve, place)
    picture = subprocess.run(["gnuplot", "--default-settings", "-"], input=script, capture_output=True, text=True,
                             env={**os.environ, "LC_ALL": "C.UTF-8"})
    if picture.returncode != 0 or not picture.stdout:
        raise SystemExit(f"gnuplot drew nothing: {picture.stderr}")
    file.write_text(picture.stdout)


def data(curve, place):
    """What was measured, and the ends of the lines that were fitted."""
    half, time, memory = upper_half(curve), time_power(curve), memory_power(curve)
    points = "".join(f"{p.size} {p.seconds} {p.megabytes}\n" for p in curve if p.size > 0)
    line = "".join(f"{p.size} {time.at(p.size)} {memory.at(p.size)}\n" for p in (half[0], half[-1]))
    return f"$points{place} << END\n{points}END\n$line{place} << END\n{line}END\n"


def frame(place, rows):
    left, top = place % COLUMNS / COLUMNS, 1.0 - place // COLUMNS / rows
    margin, above, below = MARGIN / (COLUMNS * WIDTH), 30 / (rows * HEIGHT), 52 / (rows * HEIGHT)
    return (f"set lmargin at screen {left + margin}\nset rmargin at screen {left + 1 / COLUMNS - margin}\n"
            f"set tmargin at screen {top - above}\nset bmargin at screen {top - 1 / rows + below}\n")


def axes(kind, curve):
    command, _, size = kind.partition(" by ")
    title = "slowest view, lacuna sql" if command.startswith("slowest") else f"lacuna {command}"
    shown = [point for point in curve if point.size > 0]
    return (f"set title '{title}' offset 0,-0.6\nset xlabel '{UNITS[size]}, n' offset 0,0.4\n"
            f"{ticks([point.size for point in shown])}"
            f"set xrange [{shown[0].size / 1.3}:{shown[-1].size * 1.3}]\n"
            f"set yrange [{decades(point.seconds for point in shown)}]\n"
            f"set y2range [{decades(point.megabytes for point in shown)}]\n")


def ticks(sizes):
    """Powers of ten, or, of smaller sizes, every other one that was measured."""
    if sizes[-1] > 3000:
        return "set xtics autofreq\nset format x '10^{%T}'\n"
    return "set xtics (" + ", ".join(f"'{size}' {size}" for size in sizes[::-1][::2]) + ")\n"


def decades(values):
    """A range of whole powers of ten around values, with room above for the exponents."""
    values = [max(value, 1e-3) for value in values]
    low = math.floor(math.log10(min(values)))
    return f"1e{low}:1e{max(low + 1, math.ceil(math.log10(max(values)) + 0.45))}"


def plot(curve, place):
    return (f"set label 1 'time ∝ n^{{{exponent(time_power(curve))}}}' at graph 0.04,0.93 tc rgb '{BLUE}'\n"
            f"set label 2 'memory ∝ n^{{{exponent(memory_power(curve))}}}' at graph 0.04,0.82 tc rgb '{ORANGE}'\n"
            f"plot $line{place} using 1:2 with lines lw 2 lc rgb '{BLUE}', "
            f"$line{place} using 1:3 axes x1y2 with lines lw 2 lc rgb '{ORANGE}', "
            f"$points{place} using 1:2 with points pt 7 ps 0.6 lc rgb '{BLUE}', "
            f"$points{place} using 1:3 axes x1y2 with points pt 5 ps 0.5 lc rgb '{ORANGE}'\n")
