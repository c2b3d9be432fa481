# SPDX-License-Identifier: GPL-3.0-or-later
"""The key figures of a curve that is known everywhere, and curves of other kinds than switch_logs.Switch.

Figures by the definitions in docs/reference/glossary.md on a grid of 0.1 um, by numpy alone: no formula of a curve, no code of the program that is judged. Curves: smooth ones (a force that
comes up exponentially at contact, a collapse between two logistic steps), and ones through random places by scipy's monotone cubics, whose bend jumps at every place. A
meter whose noise is partly carried on from sample to sample."""

import math

import numpy as np
from scipy.interpolate import PchipInterpolator

from switch_logs import GF_N, Meter

GRID_mm = 1e-4


def figures_of(switch):
    """Start: 0 mm. Peak and valley: the two places between which the press falls deepest before its wall. Foot: the sharpest corner upwards in the last half."""
    xs = np.linspace(0, switch.end_mm, round(switch.end_mm / GRID_mm) + 1)
    press, release = switch.press_gf(xs) * GF_N, switch.release_gf(xs) * GF_N
    half = len(xs) // 2
    foot = half + 1 + int(np.argmax(np.diff(press[half:], 2)))
    known = {"initial_force_N": press[0], "total_travel_mm": xs[-1], "end_force_N": press[-1], "press_work_mJ": np.trapz(press, xs),
             "hysteresis_mJ": np.trapz(press - release, xs), "bottom_out_force_N": press[foot], "bottom_out_travel_mm": xs[foot]}
    fallen = np.maximum.accumulate(press[:foot + 1]) - press[:foot + 1]
    valley = int(np.argmax(fallen))
    if fallen[valley] <= 1e-9:
        known["slope_to_peak_N_per_mm"] = (press[foot] - press[0]) / xs[foot]
        return known
    peak = int(np.argmax(press[:valley + 1]))
    known.update({
        "peak_force_N": press[peak], "peak_travel_mm": xs[peak], "valley_force_N": press[valley], "valley_travel_mm": xs[valley],
        "drop_N": press[peak] - press[valley], "snap_ratio": (press[peak] - press[valley]) / press[peak],
        "slope_to_peak_N_per_mm": (press[peak] - press[0]) / xs[peak], "slope_of_drop_N_per_mm": (press[valley] - press[peak]) / (xs[valley] - xs[peak]),
        "slope_to_bottom_out_N_per_mm": (press[foot] - press[valley]) / (xs[foot] - xs[valley]),
    })
    return known


def contact_figures_of(switch):
    """What a meter that watches the contact adds."""
    return {
        "pre_travel_mm": switch.operating_mm, "operating_force_N": float(switch.press_gf(switch.operating_mm)) * GF_N,
        "over_travel_mm": switch.end_mm - switch.operating_mm, "reset_travel_mm": switch.reset_mm,
        "reset_force_N": float(switch.release_gf(switch.reset_mm)) * GF_N, "differential_travel_mm": switch.operating_mm - switch.reset_mm,
    }


class Lossy:
    """A release below a press by a loss that is largest at a place of its own and vanishes at contact and at the end."""

    def __init__(self, draw):
        self.loss_gf, self.loss_at_mm = draw.uniform(4, 12), draw.uniform(1.0, 2.5)
        self.operating_mm = draw.uniform(1.7, 2.2)
        self.reset_mm = self.operating_mm - draw.uniform(0.15, 0.5)

    def release_gf(self, x):
        press_gf = self.press_gf(x)
        fade = (1 - np.exp(-np.maximum(0, x - self.contact_mm) / 0.1)) * (1 - np.exp(-np.maximum(0, self.end_mm - x) / 0.05))
        return press_gf - np.minimum(self.loss_gf * (0.7 + 0.3 * np.exp(-((x - self.loss_at_mm) / 0.6) ** 2)) * fade, 0.9 * press_gf)


class SmoothSwitch(Lossy):
    def __init__(self, draw):
        self.contact_mm = draw.uniform(0.05, 0.25)
        self.start_gf, self.toe_mm = draw.uniform(15, 45), draw.uniform(0.03, 0.08)
        self.spring_gf_per_mm, self.stiffening_gf_per_mm2 = draw.uniform(3, 10), draw.uniform(0, 1.5)
        self.collapse_gf = draw.choice([0, draw.uniform(15, 40)])
        self.rise_mm, self.fall_mm = draw.uniform(0.5, 0.8), draw.uniform(1.2, 1.7)
        self.rise_width_mm, self.fall_width_mm = draw.uniform(0.06, 0.15), draw.uniform(0.05, 0.12)
        self.bottom_mm = draw.uniform(3.0, 3.9)
        self.wall_gf_per_mm = draw.uniform(350, 900)
        self.end_mm = self.bottom_mm + draw.uniform(0.1, 0.2)
        super().__init__(draw)

    def press_gf(self, x):
        at = np.maximum(0, x - self.contact_mm)
        toe = 1 - np.exp(-at / self.toe_mm)
        collapse = 1 / (1 + np.exp(-(x - self.rise_mm) / self.rise_width_mm)) - 1 / (1 + np.exp(-(x - self.fall_mm) / self.fall_width_mm))
        spring = self.start_gf + self.spring_gf_per_mm * at + self.stiffening_gf_per_mm2 * at * at
        return toe * (spring + self.collapse_gf * collapse) + self.wall_gf_per_mm * np.maximum(0, x - self.bottom_mm)


class ThreadedSwitch(Lossy):
    """Through random places by monotone cubics: nine of ten have a peak."""

    def __init__(self, draw):
        self.contact_mm = draw.uniform(0.06, 0.2)
        start_gf = draw.uniform(20, 45)
        peak_mm, valley_mm = draw.uniform(0.7, 1.4), draw.uniform(1.7, 2.3)
        self.bottom_mm = draw.uniform(3.0, 3.9)
        self.end_mm = self.bottom_mm + draw.uniform(0.1, 0.2)
        self.wall_gf_per_mm = draw.uniform(350, 900)
        bump_gf = draw.choice([0] + 9 * [draw.uniform(10, 40)])
        peak_gf = start_gf + max(bump_gf, 4)
        valley_gf = peak_gf - 0.9 * bump_gf if bump_gf else peak_gf + 4
        end_gf = max(valley_gf, start_gf) + draw.uniform(6, 25)
        between = draw.uniform(0.3, 0.7)
        places = [(0, 0), (self.contact_mm, 0), (self.contact_mm + draw.uniform(0.08, 0.15), start_gf), (peak_mm, peak_gf),
                  (peak_mm + between * (valley_mm - peak_mm), peak_gf + draw.uniform(0.35, 0.65) * (valley_gf - peak_gf)), (valley_mm, valley_gf),
                  (self.end_mm + 0.01, end_gf)]
        self.course = PchipInterpolator(*zip(*places))
        super().__init__(draw)

    def press_gf(self, x):
        return self.course(x) + self.wall_gf_per_mm * np.maximum(0, x - self.bottom_mm)


class CarryingMeter(Meter):
    """White noise, and half as much that each sample carries on to the next by nine tenths; samples that do not keep step with the resolution."""

    def __init__(self, draw, step_mm=0.0041, **options):
        super().__init__(draw, step_mm, **options)
        self.carried_gf = 0.0

    def _read(self, x, force_gf):
        self.carried_gf = 0.9 * self.carried_gf + math.sqrt(1 - 0.81) * self.draw.gauss(0, 0.5 * self.noise_gf)
        return super()._read(x, force_gf + self.carried_gf)
