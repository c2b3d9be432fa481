#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Timing studies from outside: people made by numpy run through the very study and come back; presses at a terminal and under a sensor are
timed as well as the journal says.

    timing_study_test.py --detent-play BIN --samples DIR [--laboratories N] [--table]

1. Ten people a laboratory, each with a place and a spread of their own, drift and lapses, press in `study run --simulate presses=FILE`, trial
   by trial with the times of the study's own lists. `study presses FOLDER` then has to hold the laboratory's two figures in its 95 % intervals.
   --laboratories 100 --table prints docs/measurements/coverage.md's rows.
2. At a pty the space bar is hit at known times, in a rehearsal: what the journal says lies between is compared with what did.
3. Likewise a serial sensor's presses, with jackd's dummy driver where it can run; there the journal tells of the tones' delay what jackd says.
4. Cue, window and German words at the terminal; a key that repeats and a trial without a press begin anew; a dead sensor completes nothing.
5. A simulated force device presses, as its own log says; Esc takes its force away.
6. `study presses FOLDER --task` of another task than the study's is refused."""

import argparse
import csv
import json
import math
import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

import numpy

from presses_test import PLACE, PLACE_SD, SPREAD, SPREAD_SD, wilson
from study_sensor_test import Sensor, sound_server

PEOPLE, RUN_S = 10, 10
BUFFER_FRAMES = 1024  # of sound_server
NEW = {"cue": ["--trials", "60"], "window": ["--trials", "60"], "tapping": ["--trials", "2", "--run-seconds", str(RUN_S)]}


def run(program, *arguments, check=True):
    return subprocess.run([program, "study", *map(str, arguments)], capture_output=True, text=True, check=check)


# ---- 1. people made by numpy


def presses_of(task, rows, chance):
    """What one person does in each trial of a list: (trial, press behind the cue or the run's first press)."""
    place = PLACE[task] + chance.normal(0, PLACE_SD[task]) if task != "tapping" else PLACE[task] * math.exp(chance.normal(0, PLACE_SD[task]))
    spread = SPREAD[task] * math.exp(chance.normal(0, SPREAD_SD))
    drift = chance.normal(0, 1.0) * spread
    out = []
    for number, row in enumerate(rows):
        behind = drift * (number / max(len(rows) - 1, 1) - 0.5)
        if task == "tapping":
            at = 0.0
            while at <= RUN_S:
                out.append((row["trial"], at))
                at += chance.uniform(0.06, 0.6) if chance.random() < 0.02 else place * math.exp(chance.normal(0, 1) * spread + behind)
            continue
        interval, window = float(row["interval_s"]), float(row["window_s"])
        while True:  # a press that does not count: the trial begins anew, and the person presses again
            press = place * (window if task == "window" else interval) + (chance.normal(0, 1) * spread + behind) * interval
            if chance.random() < 0.02:
                press = chance.uniform(-0.9, 0.9) * interval
            if -interval / 2 < press < interval:
                break
        out.append((row["trial"], press))
    return out


def laboratory(program, empty, task, seed, folder):
    study = folder / f"{task}{seed}"
    shutil.copytree(empty, study)
    chance = numpy.random.default_rng(seed)
    for place in range(PEOPLE):
        name = f"P{place + 1:02d}"
        with open(empty.parent / f"{task}-lists" / f"{name}.csv", encoding="utf-8") as text:
            rows = list(csv.DictReader(text))
        file = folder / f"{task}{seed}.csv"
        file.write_text("trial,press_s\n" + "".join(f"{trial},{press:.9f}\n" for trial, press in presses_of(task, rows, chance)))
        run(program, "run", study, "--participant", name, "--simulate", f"presses={file}")
    row = json.loads(run(program, "presses", study, "--json").stdout)["tables"][0]["rows"][0]
    shutil.rmtree(study)
    key, unit = ("place_ms", 1000) if task == "tapping" else ("place_percent", 100)
    low, high = row[key.replace("_", "_low_", 1)], row[key.replace("_", "_high_", 1)]
    assert row["people"] == PEOPLE, row
    return low <= unit * PLACE[task] <= high, row["spread_low_percent"] <= 100 * SPREAD[task] <= row["spread_high_percent"], \
        row["spread_percent"] / (100 * SPREAD[task])


def coverage(program, samples, laboratories, table, folder):
    wrong = []
    if table:
        print("| task | N | place within 95 % | spread within 95 % | spread fitted : true |\n|---|---|---|---|---|")
    for task in PLACE:
        empty = folder / f"{task}-empty"
        run(program, "new", empty, samples / "B.button.json", "--kind", "timing", "--task", task, "--seed", 7, *NEW[task])
        run(program, "plan", empty, "--people", PEOPLE, "--lists", folder / f"{task}-lists")
        with ThreadPoolExecutor(2) as pool:
            found = numpy.array(list(pool.map(lambda seed, t=task, e=empty: laboratory(program, e, t, seed, folder), range(laboratories))), dtype=float)
        place, spread, ratio = found.mean(axis=0)
        if table:
            words = [f"{100 * s:.1f} ({100 * wilson(s, laboratories)[0]:.1f}–{100 * wilson(s, laboratories)[1]:.1f})" for s in (place, spread)]
            print(f"| {task} | {laboratories} | {words[0]} | {words[1]} | {ratio:.3f} |", flush=True)
        for what, share in (("place", place), ("spread", spread)):
            if wilson(share, laboratories)[1] < 0.90 or not 0.9 < ratio < 1.1:
                wrong.append(f"{task}: {what} within in {share:.3f} of {laboratories}, spread {ratio:.3f} of the true one")
    return wrong


# ---- 2 to 4. at a terminal


def now():
    return time.clock_gettime(time.CLOCK_MONOTONIC_RAW)


class Terminal:
    def __init__(self, program, folder, *arguments):
        self.screen = ""
        self.pid, self.master = pty.fork()
        if self.pid == 0:
            os.chdir(folder)
            os.execv(program, [program, "study", "run", *map(str, arguments)])

    def look(self, seconds):
        end = time.monotonic() + seconds
        while select.select([self.master], [], [], max(0.0, end - time.monotonic()))[0]:
            try:
                data = os.read(self.master, 4096)
            except OSError:
                return False
            if not data:
                return False
            self.screen += data.decode(errors="replace")
        return True

    def type(self, keys):
        os.write(self.master, keys.encode())
        return now()

    def shows(self, words, seconds, start=0):
        return self.matches(re.escape(words), seconds, start)

    def matches(self, pattern, seconds, start=0):
        end = time.monotonic() + seconds
        while not re.search(pattern, self.screen[start:]) and time.monotonic() < end and self.look(0.01):
            pass
        return bool(re.search(pattern, self.screen[start:]))

    def end(self):
        self.type("\x03")
        while self.look(0.1):
            pass
        _, status = os.waitpid(self.pid, 0)
        os.close(self.master)
        return os.waitstatus_to_exitcode(status)


def events(study, participant="P1"):
    journal = study / "participants" / f"{participant}.jsonl"
    return [json.loads(line) for line in journal.read_text().splitlines()] if journal.exists() else []


def answers(study):
    return [e for e in events(study) if e.get("event") == "answer"]


def begin(program, folder, study, *arguments):
    terminal = Terminal(program, folder, study, "--participant", "P1", *arguments)
    if not terminal.shows("I agree", 20):
        raise RuntimeError("no consent: " + terminal.screen[-300:])
    terminal.type("y")
    if not terminal.shows("Any key begins", 20):
        raise RuntimeError("no beginning: " + terminal.screen[-300:])
    return terminal


def compared(told, truth):
    """Errors of the times between presses, seconds."""
    return numpy.abs(numpy.diff(told) - numpy.diff(truth)) if len(told) == len(truth) else None


def keys_are_timed(program, samples, folder):
    """Tapping in a rehearsal, at times of all kinds between 60 and 260 ms."""
    study = folder / "keys"
    run(program, "new", study, samples / "B.button.json", "--kind", "timing", "--task", "tapping", "--trials", "2", "--run-seconds", "6", "--seed", "1")
    terminal, chance, truth = begin(program, folder, study, "--rehearse"), numpy.random.default_rng(1), []
    terminal.type("x")
    for trial in range(2):
        terminal.shows(f"Trial {trial + 1} of 2", 5)
        terminal.look(0.7)
        typed = [terminal.type(" ")]
        while True:
            time.sleep(chance.uniform(0.06, 0.26))
            terminal.look(0)
            if now() - typed[0] > 5.9:
                break
            typed.append(terminal.type(" "))
        truth.append(typed)
        terminal.shows("Stop.", 5, terminal.screen.rfind("Trial"))
    code = terminal.end() if not terminal.shows("That was the last one", 5) else 0
    told = [a["presses_s"] for a in answers(study)]
    if code < 0 or len(told) != 2:
        return [f"keys: exit {code}, {len(told)} runs kept: {terminal.screen[-200:]}"]
    errors = [compared(t, w) for t, w in zip(told, truth)]
    if any(e is None for e in errors):
        return [f"keys: {[len(t) for t in told]} presses kept of {[len(w) for w in truth]}"]
    errors = numpy.concatenate(errors)
    within = max(a["press_within_s"] for a in answers(study))
    print(f"keys: {len(errors)} times between presses, error median {1000 * numpy.median(errors):.2f} ms, "
          f"95 % {1000 * numpy.quantile(errors, 0.95):.2f} ms, worst {1000 * errors.max():.2f} ms; the journal says within {1000 * within:.2f} ms")
    return ["keys: timed worse than 5 ms in the median"] if numpy.median(errors) > 0.005 else []


class TimedSensor(Sensor):
    """As the other test's, and tells when each press began on the clock that its stamps are of."""

    def tap(self):
        self.press()
        return self.pressed


def sensor_is_timed(program, samples, folder):
    study = folder / "sensor"
    run(program, "new", study, samples / "B.button.json", "--kind", "timing", "--task", "tapping", "--trials", "1", "--run-seconds", "6", "--seed", "1")
    sensor = TimedSensor("healthy", 0, 1, folder / "port")
    sensor.start()
    terminal = begin(program, folder, study, "--device", "JACK", "--sensor", sensor.port)
    terminal.type("x")
    terminal.shows("Trial 1 of 1", 5)
    time.sleep(0.7)
    truth = []
    while not truth or time.monotonic() - truth[0] < 5.2:
        truth.append(sensor.tap())
        terminal.look(0)
    terminal.shows("That was the last one", 5)
    terminal.end()
    sensor.ending.set()
    sensor.join()
    kept = answers(study)
    if len(kept) != 1:
        return [f"sensor: {len(kept)} runs kept: {terminal.screen[-300:]}"]
    errors = compared(kept[0]["presses_s"], truth)
    if errors is None:
        return [f"sensor: {len(kept[0]['presses_s'])} presses kept of {len(truth)}"]
    print(f"sensor: {len(errors)} times between presses, error median {1000 * numpy.median(errors):.2f} ms, worst {1000 * errors.max():.2f} ms; "
          f"the journal says within {1000 * kept[0]['press_within_s']:.2f} ms")
    route = events(study)[0]["route"]
    wrong = [] if route["timing"]["press"].startswith("sensor") else ["sensor: not in the route"]
    if errors.max() > 2 * kept[0]["press_within_s"] + 0.001:
        wrong.append("sensor: timed worse than the journal says")
    return wrong


def tones_are_late_as_jack_says(program, samples, folder):
    """Half a buffer, and the latency of the device's own port, which jack_lsp reads."""
    study = folder / "tones"
    run(program, "new", study, samples / "B.button.json", "--kind", "timing", "--intervals", "0.3", "--trials", "1", "--seed", "1")
    begin(program, folder, study, "--device", "JACK").end()
    told = events(study)[0]["route"]["timing"]["cue_latency_s"]
    listed = subprocess.run(["jack_lsp", "-s", os.environ["JACK_DEFAULT_SERVER"], "-l", "system:playback_1"], capture_output=True, text=True, check=True)
    frames = int(re.search(r"port playback latency = \[ (\d+) ", listed.stdout)[1])
    wanted = (frames + BUFFER_FRAMES / 2) / 48000
    print(f"tones: {told} s late as the journal says, {wanted} s by jack_lsp")
    return [] if told is not None and frames > 0 and abs(told - wanted) < 1e-9 else [f"tones: {told} s, not {wanted}"]


def another_task_is_refused(program, samples, folder):
    study = folder / "task"
    run(program, "new", study, samples / "B.button.json", "--kind", "timing", "--task", "tapping", "--trials", "2", "--seed", "1")
    run(program, "run", study, "--participant", "P1", "--simulate", "timing=0.2,0.1")
    wrong, ran = [], run(program, "presses", study, "--task", "cue", check=False)
    if ran.returncode != 2 or ran.stdout or "--task" not in ran.stderr or "tapping" not in ran.stderr:
        wrong.append(f"another task: exit {ran.returncode}, {ran.stderr!r}")
    if run(program, "presses", study, "--task", "tapping").stdout != run(program, "presses", study).stdout:
        wrong.append("its own task: another table")
    return wrong


def force_device_presses(program, samples, folder):
    """The simulated device's finger presses by itself; what the force loop's own log says of it is what the journal has to say."""
    study, log = folder / "force", folder / "force.csv"
    run(program, "new", study, samples / "B.button.json", "--kind", "timing", "--task", "tapping", "--trials", "1", "--run-seconds", "4", "--seed", "1")
    terminal = begin(program, folder, study, "--force-device", "sim")
    if "Esc takes the force away" not in terminal.screen:
        return ["force: nobody is told how to stop it"]
    terminal.type("x")
    terminal.look(1.5)
    terminal.type("\x1b")
    if not terminal.shows("force stopped", 3) or not terminal.shows("a brings it back", 3):
        return ["force: Esc did not stop it: " + terminal.screen[-300:]]
    terminal.look(0.5)
    terminal.type("a")
    if not terminal.shows("That was the last one", 20):
        return ["force: no end: " + terminal.screen[-300:]]
    terminal.end()
    [answer] = answers(study)
    told = numpy.diff(answer["presses_s"])
    subprocess.run([program, "force", samples / "B.button.json", "--device", "sim", "--fast", "--seconds", "12", "--log", log], check=True, capture_output=True)
    rows = list(csv.DictReader(open(log, encoding="utf-8")))
    time_s, place = (numpy.array([float(r[k]) for r in rows]) for k in ("time_s", "position_mm"))
    state = json.loads((samples / "B.button.json").read_text())["states"][0]
    travel = max(k["displacement_mm"] for k in state["press"])
    acts, resets = state.get("operatingPoint_mm", travel / 2), state.get("resetPoint_mm", travel / 2)
    closings, closed = [], True
    for k in range(1, len(place)):
        if not closed and place[k] >= acts:
            share = (acts - place[k - 1]) / (place[k] - place[k - 1])
            closings.append(time_s[k - 1] + share * (time_s[k] - time_s[k - 1]))
        closed = place[k] >= acts if not closed else place[k] > resets
    true = float(numpy.median(numpy.diff(closings)))
    header, reasons = events(study)[0], [e["reason"] for e in events(study) if e.get("event") == "interruption"]
    print(f"force device: {len(told)} times between presses, {1000 * numpy.median(told):.2f} ms in the median, {1000 * true:.2f} ms by the loop's own log; "
          f"the journal says within {1000 * answer['press_within_s']:.2f} ms")
    wrong = [] if abs(numpy.median(told) - true) < 0.002 and len(told) > 1 else [f"force: {told} s between presses, not {true}"]
    if reasons != ["force stopped"] or not header["route"]["timing"]["press"].startswith("force device") or "Hz" not in header["route"]["force"]:
        wrong.append(f"force: {reasons}, {header['route']}")
    kinds = {e["kind"] for e in events(study) if e.get("event") == "session"}
    return wrong + ([] if kinds == {"rehearsal"} else [f"force: simulated, and {kinds}"])


def dead_sensor(program, samples, folder):
    study = folder / "dead"
    run(program, "new", study, samples / "B.button.json", "--kind", "timing", "--intervals", "0.3", "--trials", "2", "--seed", "1")
    sensor = TimedSensor("dead", 0.0, 2, folder / "deadport")
    sensor.begun = -1e9
    sensor.start()
    terminal = Terminal(program, folder, study, "--participant", "P1", "--device", "JACK", "--sensor", sensor.port)
    if terminal.shows("I agree", 20):
        terminal.type("y")
        if terminal.shows("Any key begins", 20):
            for _ in range(40):  # the space bar is no press where a sensor is
                terminal.type(" ")
                terminal.look(0.2)
    terminal.end()
    sensor.ending.set()
    sensor.join()
    return ["a dead sensor: answers were kept"] if answers(study) else []


def tasks_at_a_terminal(program, samples, folder):
    wrong = []
    study = folder / "cue"
    run(program, "new", study, samples / "B.button.json", "--kind", "timing", "--intervals", "0.4", "--trials", "2", "--seed", "1")
    terminal = Terminal(program, folder, study, "--participant", "P1", "--rehearse", "--language", "de")
    if not terminal.shows("Ich bin einverstanden", 20):
        wrong.append("no German consent key")
    terminal.type("j")
    if not terminal.shows("Jede Taste beginnt", 10) or "Leertaste" not in terminal.screen:
        wrong.append("no German task: " + terminal.screen[-200:])
    terminal.type("x")
    for trial in (1, 2):
        if trial == 1:  # nobody presses: it begins anew
            if not terminal.shows("Noch einmal", 6):
                wrong.append("a trial without a press was taken")
        start = len(terminal.screen)
        terminal.shows("  O", 6, start)
        time.sleep(0.05)
        terminal.type(" ")
        terminal.look(0.2)
    if not terminal.shows("Das war die letzte", 5):
        wrong.append("cue: no end: " + terminal.screen[-200:])
        terminal.end()
    kept = answers(study)
    counted = [[p for p in a["presses_s"] if -0.2 < p < 0.4][0] for a in kept]
    print(f"cue: pressed some 55 ms behind it, told {[round(1000 * p) for p in counted]} ms")
    if len(kept) != 2 or not all(0.03 < p < 0.25 for p in counted):
        wrong.append(f"cue: {counted}")
    if not any(e.get("event") == "interruption" and e["reason"] == "no press" for e in events(study)):
        wrong.append("no press is not in the journal")

    study = folder / "window"
    run(program, "new", study, samples / "B.button.json", "--kind", "timing", "--task", "window", "--intervals", "0.6", "--windows", "0.3", "--trials", "2",
        "--seed", "1")
    terminal = begin(program, folder, study, "--rehearse")
    start = len(terminal.screen)
    terminal.type("x")
    terminal.matches(r"\[ *o", 6, start)
    terminal.type(" ")
    if not terminal.shows("hit", 3, start):
        wrong.append("window: no hit: " + terminal.screen[-200:])
    start = len(terminal.screen)
    terminal.matches(r"\] *o", 6, start)
    terminal.type(" ")
    if not terminal.shows("missed", 3, start):
        wrong.append("window: no miss: " + terminal.screen[-200:])
    terminal.end()
    if len(answers(study)) != 2:
        wrong.append(f"window: {len(answers(study))} answers")

    study = folder / "held"
    run(program, "new", study, samples / "B.button.json", "--kind", "timing", "--task", "tapping", "--run-seconds", "3", "--trials", "1", "--seed", "1")
    terminal = begin(program, folder, study, "--rehearse")
    terminal.type("x")
    terminal.look(0.3)
    for _ in range(110):
        terminal.type(" ")
        terminal.look(0.03)
    if not terminal.shows("too close", 5):
        wrong.append("a key that repeats was taken for tapping")
    terminal.end()
    return wrong + (["a key that repeats was kept"] if answers(study) else [])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--detent-play", required=True)
    parser.add_argument("--samples", required=True, type=pathlib.Path)
    parser.add_argument("--laboratories", type=int, default=6)
    parser.add_argument("--table", action="store_true")
    options = parser.parse_args()
    program, samples = str(pathlib.Path(options.detent_play).resolve()), options.samples.resolve()
    memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None  # a disk's sync takes most of the time
    with tempfile.TemporaryDirectory(prefix="detent-timing-", dir=memory) as name:
        folder = pathlib.Path(name)
        wrong = coverage(program, samples, options.laboratories, options.table, folder)
        if not options.table:
            wrong += keys_are_timed(program, samples, folder) + tasks_at_a_terminal(program, samples, folder)
            wrong += another_task_is_refused(program, samples, folder) + force_device_presses(program, samples, folder)
            server = sound_server()
            if server is None:
                print("SKIPPED presses under a sensor: jackd with its dummy driver does not start here")
            else:
                wrong += sensor_is_timed(program, samples, folder) + dead_sensor(program, samples, folder)
                wrong += tones_are_late_as_jack_says(program, samples, folder)
                server.terminate()
                server.wait()
    print("\n".join(wrong) or "all within their bars")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
