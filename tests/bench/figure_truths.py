# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooth switches and their key figures, solved by scipy from the definitions in docs/glossary.md; written from these, not from the program that is judged.

Other curves than switch_logs.Switch: a force that comes up exponentially at contact, a collapse between two logistic steps, a release of its own shape, a wall with or
without play, and a meter whose noise is partly carried on from sample to sample. The interface is that of switch_logs.Switch and Meter."""

import math

from scipy.integrate import quad
from scipy.optimize import brentq, minimize_scalar

from switch_logs import GF_N, Meter


def _logistic(x):
    return 1 / (1 + math.exp(-max(-60.0, min(60.0, x))))


class SmoothSwitch:
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
        self.loss_gf, self.loss_at_mm = draw.uniform(4, 12), draw.uniform(1.0, 2.5)
        self.operating_mm = draw.uniform(1.7, 2.2)
        self.reset_mm = self.operating_mm - draw.uniform(0.15, 0.5)

    def press_gf(self, x):
        at = x - self.contact_mm
        if at <= 0:
            return 0.0
        toe = 1 - math.exp(-at / self.toe_mm)
        collapse = _logistic((x - self.rise_mm) / self.rise_width_mm) - _logistic((x - self.fall_mm) / self.fall_width_mm)
        spring = self.start_gf + self.spring_gf_per_mm * at + self.stiffening_gf_per_mm2 * at * at
        return toe * (spring + self.collapse_gf * collapse) + self.wall_gf_per_mm * max(0.0, x - self.bottom_mm)

    def release_gf(self, x):
        """The press less a loss that is largest at a place of its own and vanishes at contact and at the end."""
        if x <= self.contact_mm:
            return 0.0
        fade = (1 - math.exp(-(x - self.contact_mm) / 0.1)) * (1 - math.exp(-max(0.0, self.end_mm - x) / 0.05))
        loss = self.loss_gf * (0.7 + 0.3 * math.exp(-((x - self.loss_at_mm) / 0.6) ** 2))
        return self.press_gf(x) - min(loss * fade, 0.9 * self.press_gf(x))

    def _work(self, force_gf):
        breaks = [self.contact_mm, self.contact_mm + 3 * self.toe_mm, self.rise_mm, self.fall_mm, self.bottom_mm]
        return quad(force_gf, 0, self.end_mm, points=breaks, limit=400, epsabs=1e-9)[0] * GF_N

    def _slope(self, x):
        step = 1e-5
        return (self.press_gf(x + step) - self.press_gf(x - step)) / (2 * step)

    def figures(self):
        """Start: 0 mm. Peak: the tactile point of the press with the largest drop after it. Valley: the lowest force between it and the end."""
        bottom_N = self.press_gf(self.bottom_mm) * GF_N
        work = self._work(self.press_gf)
        known = {"initial_force_N": 0.0, "total_travel_mm": self.end_mm, "end_force_N": self.press_gf(self.end_mm) * GF_N, "press_work_mJ": work,
                 "hysteresis_mJ": work - self._work(self.release_gf), "bottom_out_force_N": bottom_N, "bottom_out_travel_mm": self.bottom_mm}
        if self.collapse_gf == 0:
            known["slope_to_peak_N_per_mm"] = bottom_N / self.bottom_mm
            return known
        inside = self.bottom_mm - 1e-4
        top_mm = minimize_scalar(lambda x: -self.press_gf(x), bounds=(self.rise_mm, self.fall_mm), method="bounded").x
        peak_mm = brentq(self._slope, top_mm - 0.1, top_mm + 0.1, xtol=1e-12)
        low_mm = minimize_scalar(self.press_gf, bounds=(self.fall_mm, min(self.fall_mm + 10 * self.fall_width_mm, inside)), method="bounded").x
        valley_mm = brentq(self._slope, low_mm - 0.1, low_mm + 0.1, xtol=1e-12)
        peak_N, valley_N = self.press_gf(peak_mm) * GF_N, self.press_gf(valley_mm) * GF_N
        known.update({
            "peak_force_N": peak_N, "peak_travel_mm": peak_mm, "valley_force_N": valley_N, "valley_travel_mm": valley_mm, "drop_N": peak_N - valley_N,
            "snap_ratio": (peak_N - valley_N) / peak_N, "slope_to_peak_N_per_mm": peak_N / peak_mm,
            "slope_of_drop_N_per_mm": (valley_N - peak_N) / (valley_mm - peak_mm),
            "slope_to_bottom_out_N_per_mm": (bottom_N - valley_N) / (self.bottom_mm - valley_mm),
        })
        return known

    def contact_figures(self):
        return {
            "pre_travel_mm": self.operating_mm, "operating_force_N": self.press_gf(self.operating_mm) * GF_N,
            "over_travel_mm": self.end_mm - self.operating_mm, "reset_travel_mm": self.reset_mm,
            "reset_force_N": self.release_gf(self.reset_mm) * GF_N, "differential_travel_mm": self.operating_mm - self.reset_mm,
        }


class CarryingMeter(Meter):
    """White noise, and half as much that each sample carries on to the next by nine tenths; samples that do not keep step with the resolution."""

    def __init__(self, draw, step_mm=0.0041, **options):
        super().__init__(draw, step_mm, **options)
        self.carried_gf = 0.0

    def _read(self, x, force_gf):
        self.carried_gf = 0.9 * self.carried_gf + math.sqrt(1 - 0.81) * self.draw.gauss(0, 0.5 * self.noise_gf)
        return super()._read(x, force_gf + self.carried_gf)
