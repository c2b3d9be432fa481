#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C and SIGTERM, once and twice, at random moments, in every subcommand of detent-play that takes long.

    play_interrupt_test.py --detent-play BIN --source DIR [--rounds N] [--limit SECONDS] [--only NAME]

Each program runs at a terminal of its own (a pty). Asked: it ends by itself within --limit of the first signal, the terminal is as it
was, no draft of a file is left and no file is half written. The sound server is JACK's dummy driver; where it cannot run, what needs it
is left out and said. The test's limit is generous (a loaded machine is no fault of the program); the bar is --limit 0.5 on a quiet one.
"""

import argparse
import json
import os
import pathlib
import pty
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import termios
import threading
import time

BUTTON = "samples/buttons/B.button.json"


class SoundServer:
    """jackd's dummy driver under a name of its own."""

    def __init__(self):
        self.name = f"detent-interrupt-{os.getpid()}"
        self.process = None
        if shutil.which("jackd") is None:
            return
        os.environ["JACK_DEFAULT_SERVER"] = self.name
        os.environ["JACK_NO_AUDIO_RESERVATION"] = "1"
        self.process = subprocess.Popen(["jackd", "-r", "-n", self.name, "-d", "dummy", "-r", "48000", "-p", "256"],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for _ in range(100):
            time.sleep(0.05)
            if subprocess.run(["jack_lsp", "-s", self.name], capture_output=True).returncode == 0:
                return
        self.stop()

    def stop(self):
        if self.process is not None:
            self.process.terminate()
            self.process.wait()
            self.process = None


class Sensor:
    """A force sensor on a pty: 400 readings a second of a finger at rest."""

    def __init__(self):
        self.master, self.slave = pty.openpty()
        mode = termios.tcgetattr(self.slave)
        mode[0] = mode[1] = mode[3] = 0
        termios.tcsetattr(self.slave, termios.TCSANOW, mode)
        os.set_blocking(self.master, False)
        self.port = os.ttyname(self.slave)
        self.stopping = False
        self.thread = threading.Thread(target=self.run, daemon=True)
        self.thread.start()

    def run(self):
        began = time.monotonic()
        while not self.stopping:
            line = f"{int((time.monotonic() - began) * 1e6) & 0xffffffff},{100 + random.randint(-1, 1)}\n"
            try:
                os.write(self.master, line.encode())
            except BlockingIOError:
                pass
            time.sleep(1 / 400)


class Terminal:
    """A pty for one program; what it prints is thrown away, its mode is kept."""

    def __init__(self):
        self.master, self.slave = pty.openpty()
        self.mode = termios.tcgetattr(self.slave)
        self.thread = threading.Thread(target=self.drain, daemon=True)
        self.text = b""
        self.thread.start()

    def drain(self):
        try:
            while chunk := os.read(self.master, 65536):
                self.text += chunk
        except OSError:
            pass

    def type(self, text):
        os.write(self.master, text)

    def restored(self):
        return termios.tcgetattr(self.slave) == self.mode

    def close(self):
        os.close(self.slave)
        self.thread.join(1)
        os.close(self.master)


def commands(source, sensor, sound):
    """(name, arguments, what is typed at the start); run in an empty folder that holds long.csv and a study."""
    button = str(source / BUTTON)
    quiet = [
        ("render", ["render", button, "--press", "long.csv", "-o", "out.wav", "--rate", "192000"], b""),
        ("calibrate at the keyboard", ["calibrate", "--sensor", sensor.port, "-o", "out.device"], b""),
        ("calibrate while weighing", ["calibrate", "--sensor", sensor.port, "-o", "out.device"], b"0\n20\n50\n100\n200\n500\n"),
        ("force", ["force", button, "--device", "sim", "--finger", "press", "--seconds", "1000", "--log", "out.csv"], b""),
        ("study at the keyboard", ["study", "run", "study", "--participant", "K1", "--rehearse"], b"y12x"),
        ("study simulated", ["study", "run", "study", "--participant", "S1", "--simulate", "guess"], b""),
        ("confusion", ["confusion", *(str(source / f"samples/buttons/{b}.button.json") for b in "ABCDEF")], b""),
    ]
    with_sound = [
        ("live", [button, "--device", "JACK", "--osc", "0", "--udp", "0"], b"  \t +-m"),
        ("live with a sensor", [button, "--device", "JACK", "--sensor", sensor.port], b""),
        ("live with a trace", [button, "--device", "JACK", "--press", "long.csv"], b""),
        ("sweep", ["sweep", "--device", "JACK", "-o", "out.device", "--csv", "out.csv"], b""),
        ("latency", ["latency", "--device", "JACK", "--trials", "1000", "--csv", "out.csv"], b""),
        ("latency with a sensor", ["latency", "--device", "JACK", "--sensor", sensor.port, "-o", "out.device"], b""),
        ("study with sound", ["study", "run", "study", "--participant", "R1", "--device", "JACK"], b"y12x"),
    ]
    return quiet + (with_sound if sound else [])


def prepare(program, source, folder):
    rows = ["time_s,force_N"] + [f"{i * 0.25},{1.5 * (i % 2)}" for i in range(16000)]
    (folder / "long.csv").write_text("\n".join(rows) + "\n")
    buttons = [str(source / f"samples/buttons/{name}.button.json") for name in "ABCDEF"]
    subprocess.run([program, "study", "new", "study", *buttons, "--seed", "1", "--trials", "200"], check=True, cwd=folder,
                   stderr=subprocess.DEVNULL)


def whole(folder):
    """Names of files that are drafts or cannot be read to their end."""
    faults = [str(p.relative_to(folder)) for p in folder.rglob("*") if ".part" in p.name or p.suffix in (".tmp", ".draft")]
    for journal in (folder / "study/participants").glob("*.jsonl"):
        text = journal.read_bytes()
        if text and not text.endswith(b"\n"):
            faults.append(journal.name)
        for line in text.splitlines():
            json.loads(line)
    return faults


def interrupt(program, arguments, typed, number, twice, delay, folder):
    """Seconds from the first signal to the end, and what was wrong."""
    terminal = Terminal()
    process = subprocess.Popen([program, *arguments], stdin=terminal.slave, stdout=terminal.slave, stderr=terminal.slave, cwd=folder,
                               start_new_session=True)
    time.sleep(min(0.15, delay))
    terminal.type(typed)
    time.sleep(max(0.0, delay - 0.15))
    if process.poll() is not None:  # it was done before
        terminal.close()
        return None, []
    began = time.monotonic()
    process.send_signal(number)
    if twice:
        time.sleep(random.choice((0, 0.005, 0.05)))
        process.send_signal(number)
    try:
        process.wait(10)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    took = time.monotonic() - began
    faults = [] if terminal.restored() else ["terminal not restored"]
    faults += [f"left {name}" for name in whole(folder)]
    if process.returncode not in (0, 2, 130, 143, -signal.SIGINT, -signal.SIGTERM):
        faults.append(f"ended with {process.returncode}")
    terminal.close()
    return took, faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--detent-play", required=True)
    parser.add_argument("--source", required=True, type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--limit", type=float, default=3)
    parser.add_argument("--only", default="")
    given = parser.parse_args()
    given.detent_play, given.source = str(pathlib.Path(given.detent_play).resolve()), given.source.resolve()
    random.seed(20131008)
    server, sensor = SoundServer(), Sensor()
    if server.process is None:
        print("SKIPPED live, sweep, latency: no JACK server runs here")
    wrong = 0
    print(f"{'command':28} {'n':>4} {'median':>8} {'longest':>8} s")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        prepare(given.detent_play, given.source, folder)
        for label, arguments, typed in commands(given.source, sensor, server.process is not None):
            if given.only not in label:
                continue
            times = []
            for _ in range(given.rounds):
                for number in (signal.SIGINT, signal.SIGTERM):
                    for twice in (False, True):
                        delay = random.choice((random.uniform(0, 0.1), random.uniform(0.1, 1), random.uniform(0.5, 2)))
                        took, faults = interrupt(given.detent_play, arguments, typed, number, twice, delay, folder)
                        if took is None:
                            continue
                        times.append(took)
                        if took > given.limit:
                            faults.append(f"took {took:.2f} s")
                        for fault in faults:
                            wrong += 1
                            print(f"{label}, signal {number}{' twice' if twice else ''} after {delay:.2f} s: {fault}")
                for output in ("out.wav", "out.device", "out.csv"):
                    (folder / output).unlink(missing_ok=True)
            times.sort()
            if times:
                print(f"{label:28} {len(times):4} {times[len(times) // 2]:8.3f} {times[-1]:8.3f}", flush=True)
    sensor.stopping = True
    server.stop()
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
