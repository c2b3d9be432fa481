#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Timing studies from outside: people made by numpy run through the very study and come back; presses under a sensor are
timed as well as the journal says.

    timing_study_test.py --detent-play BIN --participant BIN --samples DIR [--laboratories N] [--table]

1. Ten people a laboratory, each with a place and a spread of their own, drift and lapses, press in `study run --simulate presses=FILE`, trial
   by trial with the times of the study's own lists. `study presses FOLDER` then has to hold the laboratory's two figures in its 95 % intervals.
   --laboratories 100 --table prints docs/measurements/coverage.md's rows.
2. A serial sensor's presses come at known times, with jackd's dummy driver where it can run: what the journal says lies between is compared
   with what did; it tells of the tones' delay what jackd says. A dead sensor completes nothing.
3. A simulated force device presses, as its own log says; its force is stopped and comes back.
4. `study presses FOLDER --task` of another task than the study's is refused."""

import argparse
import csv
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

import numpy

from presses_test import PLACE, PLACE_SD, SPREAD, SPREAD_SD, wilson
from study_sensor_test import Participant, Sensor, sound_server

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


# ---- 2. devices under a participant (study_participant.cpp)


def events(study, participant="P1"):
    journal = study / "participants" / f"{participant}.jsonl"
    return [json.loads(line) for line in journal.read_text().splitlines()] if journal.exists() else []


def answers(study):
    return [e for e in events(study) if e.get("event") == "answer"]


def begin(station, study, *arguments):
    participant = Participant(station, study, "P1", *arguments)
    if not participant.says("trial 1\n", 20):
        raise RuntimeError("no beginning: " + participant.said[-300:])
    return participant


def compared(told, truth):
    """Errors of the times between presses, seconds."""
    return numpy.abs(numpy.diff(told) - numpy.diff(truth)) if len(told) == len(truth) else None


class TimedSensor(Sensor):
    """As the other test's, and tells when each press began on the clock that its stamps are of."""

    def tap(self):
        self.press()
        return self.pressed


def sensor_is_timed(program, station, samples, folder):
    study = folder / "sensor"
    run(program, "new", study, samples / "B.button.json", "--kind", "timing", "--task", "tapping", "--trials", "1", "--run-seconds", "6", "--seed", "1")
    sensor = TimedSensor("healthy", 0, 1, folder / "port")
    sensor.start()
    participant = begin(station, study, "--device", "JACK", "--sensor", sensor.port)
    time.sleep(0.7)
    truth = []
    while not truth or time.monotonic() - truth[0] < 5.2:
        truth.append(sensor.tap())
        participant.look(0)
    participant.says("end\n", 5)
    participant.end()
    sensor.ending.set()
    sensor.join()
    kept = answers(study)
    if len(kept) != 1:
        return [f"sensor: {len(kept)} runs kept: {participant.said[-300:]}"]
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


def tones_are_late_as_jack_says(program, station, samples, folder):
    """Half a buffer, and the latency of the device's own port, which jack_lsp reads."""
    study = folder / "tones"
    run(program, "new", study, samples / "B.button.json", "--kind", "timing", "--intervals", "0.3", "--trials", "1", "--seed", "1")
    begin(station, study, "--device", "JACK").end()
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


def force_device_presses(program, station, samples, folder):
    """The simulated device's finger presses by itself; what the force loop's own log says of it is what the journal has to say."""
    study, log = folder / "force", folder / "force.csv"
    run(program, "new", study, samples / "B.button.json", "--kind", "timing", "--task", "tapping", "--trials", "1", "--run-seconds", "4", "--seed", "1")
    participant = begin(station, study, "--force", "sim")
    participant.look(1.5)
    participant.type("e")
    if not participant.says("lost: force stopped", 3):
        return ["force: it was not stopped: " + participant.said[-300:]]
    participant.look(0.5)
    participant.type("r")
    if not participant.says("end\n", 20):
        return ["force: no end: " + participant.said[-300:]]
    participant.end()
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


def dead_sensor(program, station, samples, folder):
    study = folder / "dead"
    run(program, "new", study, samples / "B.button.json", "--kind", "timing", "--intervals", "0.3", "--trials", "2", "--seed", "1")
    sensor = TimedSensor("dead", 0.0, 2, folder / "deadport")
    sensor.begun = -1e9
    sensor.start()
    participant = Participant(station, study, "P1", "--device", "JACK", "--sensor", sensor.port)
    if participant.says("trial 1\n", 20):
        for _ in range(40):  # the space bar is no press where a sensor is
            participant.type(" ")
            participant.look(0.2)
    participant.end()
    sensor.ending.set()
    sensor.join()
    return ["a dead sensor: answers were kept"] if answers(study) else []


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--detent-play", required=True)
    parser.add_argument("--participant", required=True, help="study_participant.cpp")
    parser.add_argument("--samples", required=True, type=pathlib.Path)
    parser.add_argument("--laboratories", type=int, default=6)
    parser.add_argument("--table", action="store_true")
    options = parser.parse_args()
    station, program, samples = options.participant, str(pathlib.Path(options.detent_play).resolve()), options.samples.resolve()
    memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None  # a disk's sync takes most of the time
    with tempfile.TemporaryDirectory(prefix="detent-timing-", dir=memory) as name:
        folder = pathlib.Path(name)
        wrong = coverage(program, samples, options.laboratories, options.table, folder)
        if not options.table:
            wrong += another_task_is_refused(program, samples, folder) + force_device_presses(program, station, samples, folder)
            server = sound_server()
            if server is None:
                print("SKIPPED presses under a sensor: jackd with its dummy driver does not start here")
            else:
                wrong += sensor_is_timed(program, station, samples, folder) + dead_sensor(program, station, samples, folder)
                wrong += tones_are_late_as_jack_says(program, station, samples, folder)
                server.terminate()
                server.wait()
    print("\n".join(wrong) or "all within their bars")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
