# SPDX-License-Identifier: GPL-3.0-or-later
"""A handle on a motor, an encoder and a finger, for tests of detent-play as a program. Written without knowledge of playback/.

Displacement in mm grows with pressing. Forces in N are positive outwards, against pressing."""

import math
from dataclasses import dataclass


@dataclass
class Handle:
    mass_kg: float = 0.1
    friction_N: float = 0.05
    damping_Ns_per_mm: float = 0.0005
    step_mm: float = 0.01  # of the encoder
    motor_lag_s: float = 0.0003
    low_mm: float = -40.0  # end stops
    high_mm: float = 60.0


@dataclass
class Finger:
    """A spring whose far end moves to a depth. It only pushes."""

    stiffness_N_per_mm: float = 0.5
    damping_Ns_per_mm: float = 0.002
    depth_mm: float = 8.0
    comes_s: float = 0.8  # after the program's first force
    takes_s: float = 0.4
    leaves_s: float = 1e9
    tremor_mm: float = 0.02  # at 9 Hz

    def end_mm(self, since_s):
        if since_s < self.comes_s or since_s > self.leaves_s:
            return -100.0
        share = min(1.0, (since_s - self.comes_s) / self.takes_s)
        return self.depth_mm * share + self.tremor_mm * math.sin(2 * math.pi * 9 * since_s)


@dataclass
class Link:
    """Faults of the wiring, and of the line between program and board."""

    motor_sign: int = 1
    encoder_sign: int = 1
    encoder_dead: bool = False
    delay_s: float = 0.0002  # of answers
    jitter_s: float = 0.0
    mute: bool = False  # answers are lost, questions arrive
    lost: float = 0.0  # share of the answers
    # What the encoder counts besides, from the moment this link begins.
    scale: float = 1.0
    offset_mm: float = 0.0
    drift_mm_per_s: float = 0.0
    noise_mm: float = 0.0
    flicker_mm: float = 0.0  # in turns
    # Shares of the answers that come with a wrong byte, cut off, twice, or behind random bytes.
    garbled: float = 0.0
    cut: float = 0.0
    doubled: float = 0.0
    rubbish: float = 0.0

    def counted_mm(self, true_mm, began_mm, since_s, chance, turn):
        moved = began_mm + self.scale * (true_mm - began_mm) + self.offset_mm + self.drift_mm_per_s * since_s
        return moved + self.noise_mm * (2 * chance.random() - 1) + self.flicker_mm * (1 if turn % 2 else -1)

    def arrives_as(self, answer, chance):
        """The bytes that arrive for the bytes of one answer."""
        if chance.random() < self.garbled:
            at = chance.randrange(len(answer) - 1)
            answer = answer[:at] + bytes([answer[at] ^ (1 << chance.randrange(7))]) + answer[at + 1:]
        if chance.random() < self.cut:
            answer = answer[:chance.randrange(1, len(answer))]
        if chance.random() < self.doubled:
            answer += answer
        if chance.random() < self.rubbish:
            answer = chance.randbytes(200) + answer
        return answer


class Plant:
    def __init__(self, handle):
        self.handle = handle
        self.position_mm = self.speed_mm_per_s = self.motor_N = 0.0
        self.counts = self._true_counts = 0

    def step(self, step_s, command_N, link, finger_mm, finger):
        h = self.handle
        self.motor_N += (link.motor_sign * command_N - self.motor_N) * min(1.0, step_s / h.motor_lag_s)
        speed = self.speed_mm_per_s
        into_mm = finger_mm - self.position_mm
        push_N = max(0.0, finger.stiffness_N_per_mm * into_mm - finger.damping_Ns_per_mm * speed) if into_mm > 0 else 0.0
        inwards_N = push_N - self.motor_N - h.damping_Ns_per_mm * speed
        if self.position_mm < h.low_mm:
            inwards_N += 20 * (h.low_mm - self.position_mm) - 0.02 * speed
        elif self.position_mm > h.high_mm:
            inwards_N += 20 * (h.high_mm - self.position_mm) - 0.02 * speed
        # Friction holds a handle at rest and stops a moving one within a step.
        free = speed + 1000 * inwards_N / h.mass_kg * step_s
        brake = 1000 * h.friction_N / h.mass_kg * step_s
        speed = 0.0 if abs(free) <= brake else free - math.copysign(brake, free)
        self.speed_mm_per_s = speed
        self.position_mm += speed * step_s
        now = math.floor(self.position_mm / h.step_mm)
        if not link.encoder_dead:
            self.counts += link.encoder_sign * (now - self._true_counts)
        self._true_counts = now
