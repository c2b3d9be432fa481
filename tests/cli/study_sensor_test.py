#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies whose force sensor dies while an impatient participant goes on answering: none may end complete as real.

    study_sensor_test.py --detent-play BIN --participant BIN --samples DIR [--studies N] [--jobs N]

The sensor is a pty that speaks docs/reference/serial-protocol.md. It works until a moment in the first trials, then fails in one of the ways below for
good. The participant presses, answers, and answers again, whatever is said. Asked of each study:

- its journal holds no answer to a trial whose three stimuli the finger did not press past the bottom-out while the sensor worked;
- it is not complete; a sensor that works throughout brings it to its end (one study in nine, so that the harness itself is seen to work).

JACK's dummy driver is the sound device; where it cannot run, that is said. The whole of it is 200 studies."""

import argparse
import collections
import concurrent.futures
import json
import math
import os
import pathlib
import pty
import random
import select
import shutil
import subprocess
import sys
import tempfile
import termios
import threading
import time
import tty

TRIALS = 4
FAULT_WITHIN_S = 6.0  # a trial takes this participant about 2 s
WORK_S = 16.0  # more than the 10 s after which a reading that stands still is called stuck
PRESS_S, REST_S, PEAK_N = 0.3, 0.25, 6.0
THROUGH_N = 0.8  # where the bottom-out of A and B begins, about
READING_S = 0.0025


def checked(body):
    """A line of the protocol with its checksum."""
    total = 0
    for byte in body.encode():
        total ^= byte
    return f"{body}*{total:02X}\n"


# What a broken sensor makes of the force: newtons, or None for nothing at all. `at_N` is what it read when it broke.
FAULTS = {
    "healthy": lambda force_N, at_N, chance: force_N,
    "dead": lambda force_N, at_N, chance: 0.0,
    "noise": lambda force_N, at_N, chance: chance.gauss(0, 0.01),
    "silent": lambda force_N, at_N, chance: None,
    "stuck": lambda force_N, at_N, chance: at_N,
    "saturated": lambda force_N, at_N, chance: 29.0,
    "weak": lambda force_N, at_N, chance: 0.05 * force_N,
    "garbage": lambda force_N, at_N, chance: None,
    "lost": lambda force_N, at_N, chance: None,
}


class Sensor(threading.Thread):
    """Sends a reading every 2.5 ms; `fault` begins `fault_s` after `begun`."""

    def __init__(self, fault, fault_s, seed, port):
        super().__init__(daemon=True)
        self.fault, self.fault_s, self.chance = fault, fault_s, random.Random(seed)
        self.master, self.slave = pty.openpty()
        tty.setraw(self.slave, termios.TCSANOW)
        os.set_blocking(self.master, False)
        self.port = port  # a name of its own: the system gives a pty's number away again once it is closed
        self.port.symlink_to(os.ttyname(self.slave))
        self.begun = math.inf if fault_s > 0 else 0.0
        self.pressed, self.told_N = -1e9, 0.0
        self.ending = threading.Event()

    def force_N(self, now):
        share = (now - self.pressed) / PRESS_S
        return PEAK_N * math.sin(math.pi * share) ** 2 if 0 < share < 1 else 0.0

    def press(self):
        """One press, from rest to rest; whether the sensor told of it before it broke."""
        self.told_N = 0.0
        self.pressed = time.monotonic()
        time.sleep(PRESS_S + REST_S)
        return self.told_N > THROUGH_N

    def working(self, now):
        return self.fault == "healthy" or now - self.begun < self.fault_s

    def run(self):
        at_N = 0.0
        while not self.ending.wait(READING_S):
            now = time.monotonic()
            force_N = self.force_N(now)
            if self.working(now):
                at_N = force_N
                self.told_N = max(self.told_N, force_N)
                self.send(force_N, now)
                continue
            if self.fault == "lost":
                self.port.unlink()
                break
            if self.fault == "garbage":
                self.write(bytes(self.chance.randrange(256) for _ in range(12)))
            shown_N = FAULTS[self.fault](force_N, at_N, self.chance)
            if shown_N is not None:
                self.send(shown_N, now)
        os.close(self.master)
        os.close(self.slave)

    def send(self, force_N, now):
        self.write(checked(f"{int(now * 1e6) % 2**32},{force_N:.4f}N").encode())

    def write(self, data):
        try:
            os.write(self.master, data)
        except BlockingIOError:
            pass  # nobody reads


class Participant:
    """study_participant.cpp at a study of its own."""

    def __init__(self, program, *arguments):
        self.said = ""
        self.process = subprocess.Popen([program, *map(str, arguments)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def type(self, keys):
        try:
            os.write(self.process.stdin.fileno(), keys.encode())
        except OSError:
            pass
        self.look(0)

    def look(self, seconds):
        """Reads what is said; False once the program has ended."""
        end = time.monotonic() + seconds
        while select.select([self.process.stdout], [], [], max(0, end - time.monotonic()))[0]:
            data = os.read(self.process.stdout.fileno(), 4096)
            if not data:
                return False
            self.said += data.decode(errors="replace")
        return True

    def says(self, words, seconds, start=0):
        end = time.monotonic() + seconds
        while words not in self.said[start:] and time.monotonic() < end and self.look(0.01):
            pass
        return words in self.said[start:]

    def end(self):
        self.type("q")
        try:
            return self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            return -9
        finally:
            self.process.stdin.close()
            self.process.stdout.close()


def answers(journal):
    events = [json.loads(line) for line in journal.read_text().splitlines()] if journal.exists() else []
    return [e for e in events if e.get("event") == "answer"], [e for e in events if e.get("event") == "interruption"]


def work(participant, sensor):
    """Presses and answers until the time is over; how many trials had all three stimuli pressed through by a working sensor."""
    felt = 0
    end = time.monotonic() + WORK_S
    while time.monotonic() < end and "end" not in participant.said:
        whole = True
        for key in "12x":
            participant.type(key)
            time.sleep(0.03)
            whole = sensor.press() and whole
        felt += whole
        for key in "aba":
            participant.type(key)
            time.sleep(0.02)
        if not participant.look(0.08):
            break
    return felt


def run(program, station, samples, folder, number, seed):
    chance = random.Random(seed * 1000003 + number)
    fault = list(FAULTS)[number % len(FAULTS)]
    study = folder / f"s{number}"
    subprocess.run([program, "study", "new", str(study), str(samples / "A.button.json"), str(samples / "B.button.json"),
                    "--trials", str(TRIALS), "--seed", str(number)], check=True, stderr=subprocess.DEVNULL)
    from_start = fault != "healthy" and chance.random() < 0.2
    sensor = Sensor(fault, 0 if from_start else chance.uniform(0.1, FAULT_WITHIN_S), number,
                    folder / f"sensor{number}")
    sensor.start()
    participant = Participant(station, study, "P1", "--device", "JACK", "--sensor", sensor.port)
    started = participant.says("trial 1\n", 10)
    if not from_start:
        sensor.begun = time.monotonic()
    felt = work(participant, sensor) if started else 0
    code = participant.end()
    sensor.ending.set()
    sensor.join()
    told, interruptions = answers(study / "participants" / "P1.jsonl")
    status = json.loads(subprocess.run([program, "study", "status", str(study), "--json"], capture_output=True, text=True,
                                       check=True).stdout)["participants"]
    complete = bool(status) and status[0]["complete"]
    real = bool(status) and status[0]["kind"] == "real"
    trouble = []
    if not started and (not from_start or code != 6):
        trouble.append("did not start: " + participant.said[-200:])
    if fault == "healthy" and not (complete and real):
        trouble.append(f"a working sensor brought {len(told)} of {TRIALS} answers")
    if fault != "healthy" and complete:
        trouble.append("is complete")
    if len(told) > felt:
        trouble.append(f"{len(told)} answers, {felt} trials were felt")
    for answer in told:
        peaks = [f["peak_N"] for f in answer["felt"] + [answer["felt_x"]]]
        most_N = 30 if fault == "saturated" else 1.1 * PEAK_N  # what is under the finger goes on being measured
        if not all(THROUGH_N < peak < most_N for peak in peaks):
            trouble.append(f"trial {answer['trial']} says peaks of {peaks} N")
    if code < 0:
        trouble.append(f"ended by signal {-code}")
    return fault, len(told), len(interruptions), complete, trouble


def sound_server():
    """jackd's dummy driver under a name of its own; None where it cannot run."""
    if shutil.which("jackd") is None:
        return None
    name = f"detent-sensor-{os.getpid()}"
    os.environ.update(JACK_DEFAULT_SERVER=name, JACK_NO_AUDIO_RESERVATION="1", JACK_NO_START_SERVER="1")
    server = subprocess.Popen(["jackd", "-r", "-n", name, "-d", "dummy", "-r", "48000", "-p", "1024"],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    for _ in range(100):
        time.sleep(0.05)
        if subprocess.run(["jack_lsp", "-s", name], capture_output=True, check=False).returncode == 0:
            return server
    server.terminate()
    server.wait()
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--detent-play", required=True)
    parser.add_argument("--participant", required=True, help="study_participant.cpp")
    parser.add_argument("--samples", required=True, type=pathlib.Path)
    parser.add_argument("--studies", type=int, default=len(FAULTS))
    parser.add_argument("--jobs", type=int, default=len(FAULTS))
    parser.add_argument("--seed", type=int, default=26)
    options = parser.parse_args()
    server = sound_server()
    if server is None:
        print("SKIPPED studies with a broken sensor: jackd with its dummy driver does not start here")
        return 0
    program = str(pathlib.Path(options.detent_play).resolve())
    counted, failed = collections.defaultdict(lambda: [0, 0, 0, 0]), 0
    with tempfile.TemporaryDirectory(prefix="detent-sensor-") as folder, \
            concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        results = pool.map(lambda n: run(program, options.participant, options.samples.resolve(), pathlib.Path(folder), n, options.seed),
                           range(options.studies))
        for number, (fault, told, interrupted, complete, trouble) in enumerate(results):
            counted[fault] = [a + b for a, b in zip(counted[fault], [1, told, interrupted, complete])]
            failed += bool(trouble)
            for words in trouble:
                print(f"study {number} ({fault}): {words}")
    server.terminate()
    server.wait()
    print("| sensor | studies | answers kept | interruptions | complete as real |\n|---|---|---|---|---|")
    for fault, figures in counted.items():
        print(f"| {fault} | " + " | ".join(str(figure) for figure in figures) + " |")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
