# SPDX-License-Identifier: GPL-3.0-or-later
"""The devices behind the port: one that speaks docs/reference/force-protocol.md, and ODrives with the ASCII protocol of firmware
0.5 and 0.6. Written from the documents and the public firmware, without knowledge of playback/."""

import math

MICRO = 1e-6


def with_checksum(body):
    total = 0
    for byte in body.encode():
        total ^= byte
    return f"{body}*{total:02X}\n"


def clamp(value, low, high):
    return min(max(value, low), high)


class Board:
    began = False  # True from the first line that sets a force or keeps a table running

    def __init__(self):
        self.unknown = []

    def kept(self):
        """The configuration that the board would save."""
        return {}


class SerialBoard(Board):
    def __init__(self, greeting="", confuses=False, doubles_limit=False, largest_N=8.0):
        super().__init__()
        self.greeting, self.confuses, self.doubles_limit, self.largest_N = greeting, confuses, doubles_limit, largest_N
        self.limit_N = self.command_N = self.given_N = self.share = self.heard_s = self.law_s = 0.0
        self.silence_s = 0.05
        self.running = self.stopped = self.clock_stands = False
        self.clock_s = 0.0
        self.table = []

    def reset(self):
        self.limit_N = self.command_N = self.given_N = self.share = 0.0
        self.running = self.stopped = False
        self.table = []

    def press_switch(self):
        self.stopped = True

    def confuse(self):
        self.confuses = True

    def stop_clock(self):
        self.clock_stands = True

    def position(self, sequence, view):
        state = 1 if self.stopped else 2 if self.limit_N == 0 else 0
        self.clock_s = self.clock_s if self.clock_stands else view.now_s
        return with_checksum(f"P,{sequence},{round(self.clock_s / MICRO) % 2**32},{round(view.position_mm / MICRO)},{state}")

    def take(self, line, view):
        star = line.rfind("*")
        if star < 0 or len(line) > 95 or with_checksum(line[:star]) != line + "\n":
            return ""
        self.heard_s = view.now_s
        words = line[:star].split(",")
        letter, words = words[0], words[1:]
        try:
            v = [int(word) for word in words]
        except ValueError:
            return ""
        if letter == "?":
            return self.greeting or with_checksum(f"I,world,10000,{round(self.largest_N / MICRO)},4000,256,2")
        if letter == "L":
            return self.take_limits(words, v)
        if letter == "F" and len(v) == 2:
            self.began, self.running, self.command_N = True, False, v[1] * MICRO
            return self.position(v[0] + 7 if self.confuses else words[0], view)
        if letter == "H" and len(v) == 1:
            self.began = self.began or self.running
            return self.position(v[0] + 7 if self.confuses else words[0], view)
        if letter == "T":
            self.running, self.command_N = False, 0.0
            if len(v) != 6 or v[5] * MICRO > self.limit_N + 1e-9:
                return with_checksum("N,limit")
            self.table = [(0.0, 0.0, 0.0)] * v[0]
            self.first_mm, self.spacing_mm, self.radius_mm, self.end_N_per_mm, self.table_limit_N = (x * MICRO for x in v[1:])
            return with_checksum("A")
        if letter == "R":
            if len(v) != 4 or not 0 <= v[0] < len(self.table):
                return with_checksum("N,row")
            self.table[v[0]] = tuple(x * MICRO for x in v[1:])
            return with_checksum("A")
        if letter == "G":
            if len(self.table) < 2 or self.limit_N == 0:
                return with_checksum("N,no table")
            self.running, self.share, self.given_N, self.law_s = True, 0.0, 0.0, view.now_s
            self.centre_mm = view.position_mm + self.radius_mm
            return with_checksum("A")
        if letter == "S":
            self.stopped = True
        elif letter == "U":
            self.stopped, self.share = False, 0.0
        elif letter == "X":
            self.running, self.command_N = False, 0.0
        return ""

    def take_limits(self, words, v):
        if len(v) != 5 or min(v) <= 0:
            return with_checksum("N,limit")
        self.limit_N = min(v[0] * MICRO, self.largest_N)
        self.slew_N_per_s, self.fast_mm_per_s, self.rise_s = v[1] * 1e-3, v[2] * 1e-3, v[3] * 1e-3
        self.silence_s = min(v[4], 50) * 1e-3
        self.command_N, self.running = 0.0, False
        told_N = self.limit_N * (2 if self.doubles_limit else 1)
        return with_checksum(f"L,{round(told_N / MICRO)},{words[1]},{words[2]},{words[3]},{min(v[4], 50)}")

    def force_N(self, view):
        if view.now_s - self.heard_s > self.silence_s:
            self.running, self.command_N = False, 0.0
        if self.stopped or self.limit_N == 0:
            self.given_N = self.share = 0.0
        elif not self.running:
            self.given_N = clamp(self.command_N, -self.limit_N, self.limit_N)
        else:
            step_s = view.now_s - self.law_s
            self.law_s = view.now_s
            fast = abs(view.speed_mm_per_s) > self.fast_mm_per_s
            self.share = clamp(self.share + (-step_s / 0.01 if fast else step_s / self.rise_s), 0.0, 1.0)
            limit_N = self.table_limit_N
            wanted_N = clamp(self.law_N(view), -limit_N, limit_N) * self.share
            change_N = self.slew_N_per_s * step_s
            wanted_N = clamp(wanted_N, self.given_N - change_N, self.given_N + change_N)
            self.given_N = clamp(wanted_N, -limit_N * self.share, limit_N * self.share)
        return self.given_N

    def law_N(self, view):
        x = view.position_mm
        self.centre_mm = clamp(self.centre_mm, x - self.radius_mm, x + self.radius_mm)
        along, last = (x - self.first_mm) / self.spacing_mm, len(self.table) - 1
        at = clamp(along, 0.0, float(last))
        below = min(int(at), last - 1)
        a, b, share = self.table[below], self.table[below + 1], at - below
        press_N, release_N = a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])
        pressing = (x - self.centre_mm + self.radius_mm) / (2 * self.radius_mm)
        beyond_mm = max(0.0, along - last) * self.spacing_mm
        return release_N + pressing * (press_N - release_N) + a[2] * view.speed_mm_per_s + self.end_N_per_mm * beyond_mm


IDLE, CLOSED_LOOP, TORQUE_CONTROL = 1, 8, 1
PASSTHROUGH, TORQUE_RAMP, MIRROR, TUNING = 1, 6, 7, 8
NO_TORQUE = (2, 3)  # velocity ramp, position filter: an acceleration times an inertia of 0
UNCHANGED = (0, 5)  # inactive, trapezoidal trajectory

CONTROLLER = "axis0.controller.config."


def factory(firmware):
    """What a calibrated board has saved, by the names of the public interface; values as it answers them."""
    values = {CONTROLLER + name: value for name, value in {
        "control_mode": "3", "input_mode": "1", "vel_limit": "2.000000", "vel_limit_tolerance": "1.200000", "vel_gain": "0.166667",
        "vel_integrator_gain": "0.333333", "pos_gain": "20.000000", "inertia": "0.000000", "torque_ramp_rate": "0.010000",
        "vel_ramp_rate": "1.000000", "input_filter_bandwidth": "2.000000", "enable_vel_limit": "1", "enable_torque_mode_vel_limit": "1",
        "enable_overspeed_error": "1", "enable_gain_scheduling": "0", "axis_to_mirror": "255", "mirror_ratio": "1.000000",
        "torque_mirror_ratio": "0.000000"}.items()}
    values |= {"axis0.config.enable_watchdog": "0", "axis0.config.watchdog_timeout": "0.000000"}
    if firmware == 5:
        values |= {CONTROLLER + "anticogging.anticogging_enabled": "1", CONTROLLER + "anticogging.pre_calibrated": "0",
                   CONTROLLER + "anticogging.calib_anticogging": "0", "axis0.motor.config.torque_lim": "inf",
                   "axis0.motor.config.torque_constant": "0.040000", "axis0.motor.config.current_lim": "10.000000",
                   "axis0.encoder.config.cpr": "8192", "axis0.encoder.config.bandwidth": "1000.0000"}
    else:
        values |= {"axis0.config.anticogging.enabled": "0", "axis0.config.torque_soft_min": "-inf", "axis0.config.torque_soft_max": "inf",
                   "axis0.config.motor.torque_constant": "0.040000", "axis0.config.motor.current_soft_max": "10.000000"}
    return values


class ODrive(Board):
    def __init__(self, firmware=5, saved=None, error_at_s=1e9, error_bits=0, mm_per_turn=60.0):
        super().__init__()
        self.firmware, self.mm_per_turn, self.error_at_s, self.error_bits = firmware, mm_per_turn, error_at_s, error_bits
        self.values = factory(firmware) | (saved or {})
        self.state, self.errors = IDLE, 0
        self.input_Nm = self.setpoint_Nm = self.fed_s = self.began_s = self.last_s = 0.0
        self.failed = self.confused = False
        self.settle()

    def reset(self):
        self.values = factory(self.firmware)
        self.state, self.errors, self.input_Nm, self.setpoint_Nm = IDLE, 0, 0.0, 0.0
        self.settle()

    def press_switch(self):
        """The axis leaves closed-loop control."""
        self.state = IDLE

    def confuse(self):
        """From now on it answers another question."""
        self.confused = True

    def stop_clock(self):
        """Has none: its controller reports a failure instead."""
        self.fail(0x200)

    def kept(self):
        return dict(self.values)

    def settle(self):
        """Reads what the controller needs out of the values by name."""
        def number(name):
            return float(self.values[name])
        self.input_mode, self.control_mode = int(number(CONTROLLER + "input_mode")), int(number(CONTROLLER + "control_mode"))
        self.vel_limit, self.vel_gain = number(CONTROLLER + "vel_limit"), number(CONTROLLER + "vel_gain")
        self.ramp = number(CONTROLLER + "torque_ramp_rate")
        self.limits_velocity = number(CONTROLLER + "enable_torque_mode_vel_limit") != 0
        if self.firmware == 5:
            self.anticogging = (number(CONTROLLER + "anticogging.anticogging_enabled") != 0
                                and number(CONTROLLER + "anticogging.pre_calibrated") != 0)
            self.most_Nm = number("axis0.motor.config.torque_lim")
        else:
            self.anticogging = number("axis0.config.anticogging.enabled") != 0
            self.most_Nm = number("axis0.config.torque_soft_max")
        self.watchdog, self.watchdog_s = number("axis0.config.enable_watchdog") != 0, number("axis0.config.watchdog_timeout")

    def turns(self, view):
        return 0.31 + view.position_mm / self.mm_per_turn

    def torque_Nm(self, force_N):
        return force_N * self.mm_per_turn / 1000 / (2 * math.pi)

    def take(self, line, view):
        text, star, checksum = line.split(";")[0].strip().partition("*")
        if star:
            total = 0
            for byte in text.encode():
                total ^= byte
            if checksum != str(total):
                return ""
        words = text.split()
        answers = self.answers(words, view) if words else []
        sent = ""
        for answer in answers:
            total = 0
            for byte in answer.encode():
                total ^= byte
            sent += answer + (f"*{total}" if star else "") + "\r\n"
        return sent

    def answers(self, words, view):
        letter = words[0]
        if letter == "f" and self.confused:
            return ["24.087200"]
        if letter == "f":
            return [f"{self.turns(view):.6f} {view.speed_mm_per_s / self.mm_per_turn:.6f}"]
        if letter == "c":
            if len(words) < 3:
                return ["invalid command format"]
            if not self.began:
                self.began, self.began_s = True, view.now_s
            self.input_Nm, self.fed_s = float(words[2]), view.now_s
            return []
        if letter == "u":
            self.fed_s = view.now_s
            return []
        if letter == "sc":
            self.errors = 0
            return []
        if letter == "i":
            return ["Hardware version: 3.6-56V", f"Firmware version: 0.{self.firmware}.6", "Serial number: 206A3398304B"]
        if letter == "r":
            answer = self.read(words[1], view)
            if answer is None:
                self.unknown.append(" ".join(words))
                return ["invalid property"]
            return [answer[:9] if self.firmware == 5 else answer]  # 0.5 has ten bytes for it, one of which ends the text
        if letter == "w":
            if self.write(words[1], words[2] if len(words) > 2 else "", view):
                return []
            self.unknown.append(" ".join(words))
            return ["invalid property"]
        return ["unknown command"]

    def read(self, name, view):
        old = self.firmware == 5
        plain = {"axis0.current_state": self.state, "axis0.requested_state": 0, "vbus_voltage": "24.087200", "serial_number": 35601883739976,
                 "fw_version_major": 0, "fw_version_minor": self.firmware, "fw_version_revision": 6, "hw_version_major": 3 if old else 4,
                 "hw_version_minor": 6 if old else 4, CONTROLLER[:-7] + "input_torque": f"{self.input_Nm:.6f}"}
        if old:
            plain |= {"axis0.error": self.errors, "axis0.motor.error": 0, "axis0.encoder.error": 0,
                      "axis0.controller.error": 2 if self.errors & 0x200 else 0, "axis0.encoder.pos_estimate": f"{self.turns(view):.6f}"}
        else:
            plain |= {"axis0.active_errors": self.errors, "axis0.disarm_reason": self.errors, "axis0.procedure_result": 0,
                      "axis0.pos_estimate": f"{self.turns(view):.6f}"}
        plain |= self.values
        return str(plain[name]) if name in plain else None

    def write(self, name, value, view):
        if name in self.values:
            self.values[name] = {"true": "1", "True": "1", "false": "0", "False": "0"}.get(value, value)
            if name == "axis0.config.enable_watchdog":
                self.fed_s = view.now_s
            self.settle()
            return True
        if name == "axis0.requested_state":
            if int(value) == CLOSED_LOOP and self.errors == 0:
                self.state = CLOSED_LOOP
            elif int(value) == IDLE:
                self.state = IDLE
            return True
        if name == "axis0.controller.input_torque":
            self.input_Nm = float(value)
            return True
        if self.firmware == 5 and name.endswith(".error"):
            self.errors = 0
            return True
        return False

    def fail(self, bits):
        self.errors |= bits
        self.state, self.setpoint_Nm = IDLE, 0.0

    def force_N(self, view):
        if self.began and not self.failed and view.now_s - self.began_s > self.error_at_s:
            self.failed = True
            self.fail(self.error_bits)
        if self.watchdog and self.state == CLOSED_LOOP and view.now_s - self.fed_s > self.watchdog_s:
            self.fail(0x800 if self.firmware == 5 else 0x1000000)
        step_s, self.last_s = view.now_s - self.last_s, view.now_s
        if self.state != CLOSED_LOOP:
            self.setpoint_Nm = 0.0
            return 0.0
        if self.input_mode == PASSTHROUGH:
            self.setpoint_Nm = self.input_Nm
        elif self.input_mode == TORQUE_RAMP:
            self.setpoint_Nm += clamp(self.input_Nm - self.setpoint_Nm, -self.ramp * step_s, self.ramp * step_s)
        elif self.input_mode == MIRROR:  # the other axis moves
            self.setpoint_Nm = self.torque_Nm(1.5 * math.sin(math.pi * view.now_s))
        elif self.input_mode == TUNING:
            self.setpoint_Nm = self.torque_Nm(2 * math.sin(6 * math.pi * view.now_s))
        elif self.input_mode in NO_TORQUE:
            self.setpoint_Nm = 0.0
        elif self.input_mode not in UNCHANGED:
            self.fail(0x200)
            return 0.0
        torque_Nm, speed = self.setpoint_Nm, view.speed_mm_per_s / self.mm_per_turn
        if self.anticogging:
            torque_Nm += self.torque_Nm(0.4 * math.cos(14 * math.pi * self.turns(view)))
        if self.control_mode > TORQUE_CONTROL:  # holds a speed
            torque_Nm -= self.vel_gain * speed
        elif self.limits_velocity:
            torque_Nm = clamp(torque_Nm, (-self.vel_limit - speed) * self.vel_gain, (self.vel_limit - speed) * self.vel_gain)
        return -clamp(torque_Nm, -self.most_Nm, self.most_Nm) * 2 * math.pi / (self.mm_per_turn / 1000)
