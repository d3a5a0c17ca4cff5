"""A rig for tests: it reads half of what its motor is told, and has a fault of its own where its argument names one."""

import atexit
import glob
import json
import os
import signal
import subprocess
import sys
import time

FAULT = sys.argv[1] if len(sys.argv) > 1 else "none"
WAVERS = ("wavers", "wavers, then hangs")
EXCHANGES = ("only exchange", "begins early", *WAVERS)

HELLO = {
    "type": "hello",
    "protocol": "lacuna-process/2",
    "name": "test rig",
    "modes": ["series"] * (FAULT not in EXCHANGES) + ["exchange"] * (FAULT != "only series"),
    "sensors": [{"name": "heat", "unit": "1"}, {"name": "angle", "unit": "deg", "noise": 0.1}],
    "actuators": [{"name": "motor", "unit": "mN*m", "lower": -600, "upper": 600}],
}
KNOWN_START = {"hinge": {"position": 0.25, "velocity": 0.0}}


def say(message):
    print(message if isinstance(message, str) else json.dumps(message), flush=True)


def listen():
    begin = ""
    if FAULT == "writes while it is sent":
        begin = sys.stdin.read(1)
        sys.stdout.write("\n" * (1 << 20))
    line = begin + sys.stdin.readline()
    if not line:
        leave()
    return json.loads(line)


def leave():
    if FAULT == "stays":
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        time.sleep(1000)
    sys.exit(0)


def crash(words):
    sys.stderr.write(words + "\n")
    sys.exit(3)


def once(name):
    """Whether it is the first time, over all processes in this folder."""
    if os.path.exists(name):
        return False
    open(name, "w").close()
    return True


def greet():
    if FAULT == "crashes in hello":
        sys.stderr.write("first line\n" * 9)
        crash("Traceback: no rig at /dev/ttyUSB0")
    if FAULT == "hangs in hello":
        time.sleep(1000)
    if FAULT == "prints":
        say("Rig driver 1.2 ready")
    if FAULT == "huge line":
        while True:
            sys.stdout.write("x" * (1 << 20))
    if FAULT == "closes its output":
        os.close(1)
        time.sleep(1000)
    if FAULT == "is sick":
        say({"type": "error", "message": "the motor's power is off"})
        return
    hello = json.loads(json.dumps(HELLO))
    if FAULT == "wrong hello":
        hello.update(protocol="lacuna-process/9", modes=["often"])
        hello["sensors"] = [{"name": "angle", "unit": "furlong"}, {"name": "angle"}]
        hello["actuators"][0].update(lower=2, upper=1)
    if FAULT == "is of before":
        hello.update(protocol="lacuna-process/1")
    if FAULT == "wrong units":
        hello["sensors"][1]["unit"] = "m"
    if FAULT == "wrong names":
        hello["sensors"][1]["name"] = "angel"
        hello["actuators"].append({"name": "brake", "unit": "N*m", "lower": 0, "upper": 1})
    if FAULT in ("beyond its range", "cold"):
        for sensor in hello["sensors"]:
            sensor.update(lower=-180, upper=180)
    if FAULT == "narrow":
        hello["actuators"][0].update(lower=-100, upper=100)
    say(hello)
    if FAULT == "reads no more":
        time.sleep(1000)
    if FAULT == "closes its input":
        os.close(0)
        time.sleep(1000)
    while FAULT == "talks without end":
        sys.stdout.write("I am well\n" * (1 << 16))


def fault_in_trial(test):
    if FAULT == "dies" or (FAULT == "dies once" and once("died")) or (
        FAULT == "waits for repair" and not os.path.exists("repaired")
    ):
        crash("motor driver: over-current")
    if FAULT == "leaves a helper":
        subprocess.Popen(["sleep", "1000"])  # which has this program's input and output
        crash("motor driver: over-current")
    if FAULT == "is killed":
        os.kill(os.getpid(), signal.SIGSEGV)
    if FAULT == "echoes":
        crash(json.dumps({key: test[key] for key in ("trial", "seed", "duration", "period", "periods")}))
    if FAULT == "waits for more":
        once("waits")
        listen()
    if FAULT == "meets another":
        once(f"here-{os.getpid()}")
        while len(glob.glob("here-*")) < 2:
            time.sleep(0.01)
    if FAULT == "hangs" or (FAULT == "hangs once" and once("hangs")) or (
        FAULT == "wavers, then hangs" and test["trial"] == 1 and once("hangs")
    ):
        time.sleep(1000)
    if FAULT == "half a line":
        sys.stdout.write('{"type": "sam')
        sys.stdout.flush()
        time.sleep(1000)
    if FAULT == "refuses":
        say({"type": "error", "message": "the arm is not at rest"})
        return True
    if FAULT == "refuses, and answers late":
        if test["id"] == 1:
            say({"type": "error", "id": 1, "message": "took too long"})
            return True
        time.sleep(0.3)
        say(dict(samples_of(test), id=1))
    if FAULT == "refuses late" and test["id"] == 2:
        say({"type": "error", "id": 1, "message": "took too long"})
        return True
    if FAULT == "refuses in colour":
        say({"type": "error", "message": "\x1b[31mzu heiß\x1b[0m" + "!" * 1000})
        return True
    if FAULT == "half an answer":
        sys.stdout.write('{"type": "samples", "times": [0, ')
        sys.stdout.flush()
        sys.exit(0)
    if FAULT == "other type":
        say({"type": "banana"})
        return True
    return False


def samples_of(test):
    commands = test["commands"]
    times = [k * test["period"] for k in range(test["periods"] + 1)]
    first = commands["samples"][0][0]
    return {"type": "samples", "id": test["id"], "times": times, "samples": [[20.0, 0.5 * first] for _ in times]}


def run_series(test):
    answer = samples_of(test)
    if FAULT == "nan":
        answer["samples"][1][1] = float("nan")
    if FAULT == "huge":
        print(json.dumps(answer).replace("20.0", "1e400"), flush=True)
        return
    if FAULT == "absurd":
        answer["samples"][1][1] = 1e308
    if FAULT in ("beyond its range", "cold"):
        answer["samples"][1][1 if FAULT != "cold" else 0] = -181
    if FAULT == "a gap":
        answer["samples"][1][1] = None
    if FAULT == "no heat":
        answer["samples"] = [[None, row[1]] for row in answer["samples"]]
    if FAULT == "nothing measured":
        answer["samples"] = [[20.0, None] for _ in answer["times"]]
    if FAULT == "too few":
        answer["times"], answer["samples"] = answer["times"][:3], answer["samples"][:3]
    if FAULT == "short rows":
        answer["samples"] = [row[:1] for row in answer["samples"]]
    if FAULT == "times stand still":
        answer["times"][2] = answer["times"][1]
    if FAULT == "other joint":
        answer["start"] = {"knee": {"position": 0, "velocity": 0}}
    if FAULT == "knows its start":
        answer["start"] = KNOWN_START
    if FAULT == "measures late":
        answer.update(times=answer["times"][1:], samples=answer["samples"][1:], start=KNOWN_START)
    if FAULT == "repeats no id":
        del answer["id"]
    if FAULT == "answers twice" and test["id"] == 2:
        time.sleep(0.3)  # after the test was sent: the second answer to the first one comes late
        say(dict(samples_of(test), id=1))
    say(answer)
    if FAULT == "talks on":
        say({"type": "by the way"})
    if FAULT == "dies afterwards":
        sys.exit(0)


def run_exchange(test):
    angle = 0.0
    for k in range(test["periods"] + 1):
        late = {"out of step": 0.8 * (k == 2), "begins early": -0.4}.get(FAULT, 0.4 * (-1) ** k * (FAULT in WAVERS))
        readings = {"type": "readings", "id": test["id"], "sensors": [20.0, angle]}
        readings["time"] = (k + late) * test["period"]
        if FAULT == "no heat":
            readings["sensors"][0] = None
        if FAULT == "absurd" and k == 1:
            readings["sensors"][1] = 1e308
        if FAULT == "a gap" and k == 1:
            readings["sensors"][1] = None
        if FAULT in ("begins early", *WAVERS) and k == 0:
            readings["start"] = KNOWN_START
        say(readings)
        if k < test["periods"]:
            angle = 0.5 * listen()["commands"][0]


def main():
    with open("pid", "w") as file:
        file.write(str(os.getpid()))
    if FAULT == "works alone":
        try:
            os.close(os.open("lock", os.O_CREAT | os.O_EXCL))
        except FileExistsError:
            crash("another one has the rig")
        atexit.register(os.remove, "lock")
        time.sleep(0.5)  # in which another one would come
    if FAULT == "reads nothing":
        time.sleep(1000)
    if FAULT == "floods standard error":
        sys.stderr.write("noise " * (1 << 22))
    while True:
        message = listen()
        if message["type"] == "hello":
            greet()
        elif not fault_in_trial(message):
            (run_series if message["mode"] == "series" else run_exchange)(message)


main()
