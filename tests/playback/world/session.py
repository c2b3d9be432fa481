# SPDX-License-Identifier: GPL-3.0-or-later
"""detent-play as a program, at a plant behind a pseudo terminal, with a fault at a stated moment."""

import gc
import math
import os
import random
import select
import signal
import subprocess
import tempfile
import time
import tty
from collections import deque
from dataclasses import dataclass, field

from plant import Finger, Handle, Link, Plant

PLANT_STEP_S = 0.0002


class Lateness:
    """Counts the periods of the program (1 ms) in which this computer kept the board from answering in time.

    A question comes in each period and waits at most as long as the board's loop takes; and the kernel passes it on when it finds
    time, which a byte through a port of the board's own shows. The program takes an answer as missing after 0.85 of a period
    (answerWaitOfPeriod in playback/device/round_trips.h), so a loop or a passage longer than that can cost an answer in each period
    that it touches. Two rules bound what is harmless, both with 3: the safeguard bridges 3 missing answers in a row
    (heldReadings in playback/realtime/force_program.h), and the delay of the link is that of the 37th fastest of the first 40
    answers (RoundTrips::usual_s). With more, drop-outs or a slow link may be the board's own.
    """

    PERIOD_S, LATE_S, HARMLESS = 0.001, 0.00085, 3
    ROW_S = 2 * (HARMLESS + 1) * PERIOD_S  # a punctual answer between late ones does not make the force rise at once
    MEASURED_S, MEASURED_UNTIL_S = 40 * PERIOD_S, 0.25  # the delay is measured for up to 0.2 s after the greeting

    def __init__(self):
        self.heard_s = self.began_s = None  # first line of the program, and first that sets a force
        self.longest_s, self.periods = 0.0, 0
        self.recent = deque()  # (end, periods) of late loops, as many as the longest window holds
        self.explains_from_s = None  # when the board had first been so late that the program had to notice
        self.port = None  # here, there; a byte is on its way since sent_s
        self.before_s = self.sent_s = None

    def open(self):
        self.port = os.openpty()
        for end in self.port:
            tty.setraw(end)
        os.set_blocking(self.port[0], False)

    def close(self):
        for end in self.port:
            os.close(end)

    def loop(self, now_s):
        """Call once in each loop of the board."""
        took_s = now_s - self.before_s if self.before_s is not None else 0.0
        try:
            if self.sent_s is not None and os.read(self.port[0], 1):
                took_s, self.sent_s = max(took_s, now_s - self.sent_s), None
        except BlockingIOError:
            pass
        if self.sent_s is None:
            os.write(self.port[1], b".")
            self.sent_s = now_s
        self.add(now_s, took_s)
        self.before_s = now_s

    def add(self, end_s, took_s):
        if self.heard_s is None:
            return
        self.longest_s = max(self.longest_s, took_s)
        if took_s <= self.LATE_S:
            return
        self.recent.append((end_s, math.ceil(took_s / self.PERIOD_S)))
        self.periods += self.recent[-1][1]
        while end_s - self.recent[0][0] >= self.MEASURED_S:
            self.recent.popleft()
        window_s = self.MEASURED_S if end_s - self.heard_s < self.MEASURED_UNTIL_S else self.ROW_S
        if self.explains_from_s is None and sum(n for at_s, n in self.recent if end_s - at_s < window_s) > self.HARMLESS:
            self.explains_from_s = end_s

    def explains(self, until_s):
        """Whether the board was so late, until this time after its first force, that the program had to notice."""
        began_s = math.inf if self.began_s is None else self.began_s
        return self.explains_from_s is not None and self.explains_from_s <= began_s + until_s


@dataclass
class View:
    """State of the plant that the board can read."""

    now_s: float = 0.0
    position_mm: float = 0.0
    speed_mm_per_s: float = 0.0


@dataclass
class Scene:
    arguments: list = field(default_factory=lambda: ["force", "--stiffness=1.0", "--travel", "10", "--max-N", "5", "--json"])
    port_option: str = "serial:"
    seconds: float | None = 2.7  # given as --seconds
    handle: Handle = field(default_factory=Handle)
    finger: Finger = field(default_factory=Finger)
    before: Link = field(default_factory=Link)
    after: Link = field(default_factory=Link)  # the fault
    fault_s: float = 1.6  # after the first force, like the next two
    healed_s: float = 1e9
    stall_s: float = 0.0  # at the fault the program stands still for this time
    second: bool = False  # at the fault the same command runs a second time
    signal: int = 0  # at the fault the program gets this signal
    board_event: str = ""  # at the fault: a method of the board
    away_s: float = 0.0  # at the fault the port is gone for this time
    wait_s: float = 9.0
    seed: int = 1


class Outcome:
    def __init__(self):
        self.exit_code, self.said, self.json = -1, "", ""
        self.second_exit_code, self.second_said = -1, ""
        self.moments = []  # (s after the first force, N at the motor, mm)
        self.lateness = Lateness()
        self.unknown, self.kept_before, self.kept_after = [], {}, {}

    def largest_N(self, from_s=0.0, to_s=1e9):
        return max((abs(n) for t, n, _ in self.moments if from_s <= t <= to_s), default=0.0)

    def until_none_s(self, from_s):
        """From `from_s` until the motor's force stays below 0.1 N; infinite if it does not until the end."""
        if not self.moments:
            return 0.0
        end_s = self.moments[-1][0]
        last_s = max((t for t, n, _ in self.moments if t >= from_s and abs(n) >= 0.1), default=from_s)
        return math.inf if last_s > end_s - 0.1 else last_s - from_s

    def outside_mm(self, travel_mm, from_s):
        """Largest distance outside 0..travel with more than 0.1 N on the motor."""
        return max((max(-x, x - travel_mm) for t, n, x in self.moments if t >= from_s and abs(n) > 0.1), default=0.0)

    def off_law_N(self, from_s, to_s):
        """Mean distance of the force from 1 N/mm times the position."""
        window = [abs(n - x) for t, n, x in self.moments if from_s <= t <= to_s]
        return sum(window) / len(window) if window else math.inf


class Program:
    def __init__(self, arguments):
        self.out, self.err = tempfile.TemporaryFile(), tempfile.TemporaryFile()
        self.process = subprocess.Popen(arguments, stdin=subprocess.DEVNULL, stdout=self.out, stderr=self.err)

    def ended(self):
        return self.process.poll() is not None

    def finish(self):
        if not self.ended():
            self.process.send_signal(signal.SIGCONT)
            self.process.terminate()
            try:
                self.process.wait(1)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
        texts = []
        for file in (self.out, self.err):
            file.seek(0)
            texts.append(file.read().decode(errors="replace"))
            file.close()
        return self.process.returncode, *texts


def play(program, scene, board):
    """Runs `program` until it ends, in real time, and returns the Outcome."""
    try:  # as punctual as a board, where the system allows it
        os.sched_setscheduler(0, os.SCHED_FIFO | os.SCHED_RESET_ON_FORK, os.sched_param(40))
    except PermissionError:
        pass
    gc.disable()
    chance = random.Random(scene.seed)
    master, slave = os.openpty()
    tty.setraw(slave)
    os.set_blocking(master, False)
    folder = tempfile.TemporaryDirectory()
    port = os.path.join(folder.name, "port")  # a name that stays when the board is plugged in again
    os.symlink(os.ttyname(slave), port)
    arguments = [program, *scene.arguments, "--device", scene.port_option + port]
    if scene.seconds is not None:
        arguments += ["--seconds", str(scene.seconds)]
    outcome, plant, view = Outcome(), Plant(scene.handle), View()
    outcome.kept_before = board.kept()
    answers, received, moments = deque(), b"", outcome.moments
    began_s, plant_s, wakes_s, ended_s = None, 0.0, math.inf, math.inf
    fault_done, second, back_s = False, None, math.inf
    outcome.lateness.open()
    fault_mm, turn = 0.0, 0
    start_s = time.monotonic()
    first = Program(arguments)
    while True:
        now_s = time.monotonic() - start_s
        outcome.lateness.loop(now_s)
        if now_s > scene.wait_s or now_s > ended_s + 0.1:
            break
        since_s = -1.0 if began_s is None else now_s - began_s
        faulty = scene.fault_s <= since_s < scene.healed_s
        link = scene.after if faulty else scene.before
        while plant_s < now_s:
            plant_s += PLANT_STEP_S
            counted_mm = plant.counts * scene.handle.step_mm
            if not faulty:
                fault_mm = counted_mm
            else:
                turn += 1
                counted_mm = link.counted_mm(counted_mm, fault_mm, since_s - scene.fault_s, chance, turn // 5)
                counted_mm = round(counted_mm / scene.handle.step_mm) * scene.handle.step_mm
            view.now_s, view.position_mm = plant_s, counted_mm
            view.speed_mm_per_s = 0.0 if link.encoder_dead else link.encoder_sign * plant.speed_mm_per_s
            plant_since_s = -1.0 if began_s is None else plant_s - began_s
            plant.step(PLANT_STEP_S, board.force_N(view), link, scene.finger.end_mm(plant_since_s), scene.finger)
            if began_s is not None:
                moments.append((plant_since_s, plant.motor_N, plant.position_mm))
        if faulty and not fault_done:
            fault_done = True
            if scene.stall_s > 0:
                first.process.send_signal(signal.SIGSTOP)
                wakes_s = now_s + scene.stall_s
            if scene.second:
                second = Program(arguments)
            if scene.signal:
                first.process.send_signal(scene.signal)
            if scene.board_event:
                getattr(board, scene.board_event)()
            if scene.away_s > 0:
                os.close(master)
                os.close(slave)
                os.unlink(port)
                answers.clear()
                master, slave, received, back_s = -1, -1, b"", now_s + scene.away_s
        if now_s >= back_s:
            back_s = math.inf
            master, slave = os.openpty()
            tty.setraw(slave)
            os.set_blocking(master, False)
            os.symlink(os.ttyname(slave), port)
        if now_s >= wakes_s:
            first.process.send_signal(signal.SIGCONT)
            wakes_s = math.inf
        try:
            received += os.read(master, 4096) if master >= 0 else b""
        except BlockingIOError:
            pass
        while b"\n" in received:
            line, received = received.split(b"\n", 1)
            outcome.lateness.heard_s = outcome.lateness.heard_s or now_s
            answer = board.take(line.decode(errors="replace"), view)
            if board.began and began_s is None:
                began_s = outcome.lateness.began_s = plant_s
            if not answer or link.mute or chance.random() < link.lost:
                continue
            due_s = now_s + link.delay_s + link.jitter_s * chance.random()
            answers.append((max(due_s, answers[-1][0]) if answers else due_s, link.arrives_as(answer.encode(), chance)))
        while answers and answers[0][0] <= now_s:
            os.write(master, answers.popleft()[1])
        if ended_s == math.inf and first.ended() and (second is None or second.ended()):
            ended_s = now_s
        until_s = min(now_s + 0.0004, answers[0][0] if answers else math.inf)
        select.select([master] if master >= 0 else [], [], [], max(0.0, until_s - (time.monotonic() - start_s)))
    outcome.exit_code, outcome.json, outcome.said = first.finish()
    if second is not None:
        outcome.second_exit_code, _, outcome.second_said = second.finish()
    if master >= 0:
        os.close(master)
        os.close(slave)
    outcome.lateness.close()
    folder.cleanup()
    outcome.kept_after, outcome.unknown = board.kept(), board.unknown
    return outcome
