#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The product's plant of a press against an ODE written from docs/reference/press-forecast.md, and its timed presses against chance.

    press_ode_test.py PRESS_PROBE [--table]     --table: the largest difference of each figure, for docs/reference/press-forecast.md

Needs Debian's python3-scipy: without it, SKIPPED.
"""
import json
import multiprocessing
import subprocess
import sys
import unittest

try:
    import numpy
    from scipy.stats import norm
except ImportError:
    print("SKIPPED: needs python3-scipy")
    sys.exit(0)

import press_cases
import press_ode

PROBE = sys.argv.pop(1)
STEP_S = 50e-6
# What a step of 50 µs may do. Times are told at the end of a step, and the plant sees the touch up to one step late.
TOUCH_S = 2 * STEP_S
PEAK_TIME_S = END_S = 3 * STEP_S
PEAK = 0.01
IMPACT = 0.06  # where the blow of the touch is the peak: it fades with cap / pulp damper, 0.3 ms
IMPULSE = 0.002
DEEPEST_M = 5e-6


def probed(cases):
    lines = "".join(json.dumps(case) + "\n" for case in cases)
    done = subprocess.run([PROBE], input=lines, text=True, capture_output=True, check=False)
    if done.returncode:
        raise AssertionError(done.stderr)
    return [json.loads(line) for line in done.stdout.splitlines()]


def differences(product, ode):
    """(figure, difference, tolerance): all that are told of both."""
    found = []
    for figure in ("touch_s", "activation_s"):
        if (product[figure] is None) != (ode[figure] is None):
            return [(figure, float("inf"), 0.0)]
    if ode["touch_s"] is not None:
        found.append(("touch_s", abs(product["touch_s"] - ode["touch_s"]), TOUCH_S))
    if ode["activation_s"] is not None:
        # A touch seen late is a depth; a cap that creeps over its operating point makes more time of it.
        slower = max(1.0, ode["touch_m_per_s"] / ode["activation_m_per_s"])
        found.append(("activation_s", abs(product["activation_s"] - ode["activation_s"]), TOUCH_S * slower))
    if ode["touch_s"] is None:
        return [("impulse_Ns", product["impulse_Ns"] + product["peak_N"], 0), ("end_s", abs(product["end_s"] - ode["end_s"]), END_S)]
    impact = ode["peak_s"] == ode["touch_s"]
    found.append(("impact_N" if impact else "peak_N", abs(product["peak_N"] / ode["peak_N"] - 1), IMPACT if impact else PEAK))
    if not impact:  # else another peak may be the higher one by less than the blow is known
        found.append(("peak_s", abs(product["peak_s"] - ode["peak_s"]), PEAK_TIME_S))
    found.append(("impulse_Ns", abs(product["impulse_Ns"] / ode["impulse_Ns"] - 1), IMPULSE))
    found.append(("deepest_m", abs(product["deepest_m"] - ode["deepest_m"]), DEEPEST_M))
    found.append(("end_s", abs(product["end_s"] - ode["end_s"]), END_S))
    found.append(("closings", abs(product["closings"] - ode["closings"]) + (product["ended"] != ode["ended"]), 0))
    return found


def all_differences():
    """[(case, its differences)]."""
    cases = press_cases.cases()
    products = probed(cases)
    with multiprocessing.Pool(2) as pool:
        odes = pool.map(press_ode.press, cases, chunksize=2)
    return [(case, differences(product, ode)) for case, product, ode in zip(cases, products, odes, strict=True)]


class Plant(unittest.TestCase):
    def test_presses(self):
        compared = all_differences()
        self.assertGreaterEqual(len(compared), 40)
        wrong = [f"{case['button']['name']}, {case['command']}: {figure} differs by {difference:.3g}, allowed {allowed:.3g}"
                 for case, found in compared for figure, difference, allowed in found if not difference <= allowed]
        self.assertEqual([], wrong, "\n".join(wrong))

    def test_every_way_a_press_can_go_is_among_the_cases(self):
        outcomes = probed(press_cases.cases())
        self.assertIn(0, [outcome["closings"] for outcome in outcomes])
        self.assertIn(2, [outcome["closings"] for outcome in outcomes])
        self.assertIn(None, [outcome["touch_s"] for outcome in outcomes])
        self.assertIn(False, [outcome["ended"] for outcome in outcomes])


class TimedPress(unittest.TestCase):
    PRESSES = 400000
    ASKED = [{"window_s": window, "interval_s": interval, "activation_sd_s": button, "aim": aim, "spread": spread}
             for window in (0.03, 0.1, 0.25) for interval in (0.4, 1.0) for button in (0.0, 0.004, 0.03)
             for aim, spread in ((0.185, 0.09), (0.5, 0.04))]

    def test_share_outside_the_window_is_that_of_chance(self):
        """All together at the level of 3 standard errors, 0.27 %: for one of 36 that is 4.1. One in ten runs has one beyond 3."""
        allowed = norm.isf(0.5 * 0.0027 / len(self.ASKED))
        chance = numpy.random.Generator(numpy.random.PCG64(30))
        for case, answer in zip(self.ASKED, probed(self.ASKED), strict=True):
            press_s = (case["aim"] * case["window_s"] + case["spread"] * case["interval_s"] * chance.standard_normal(self.PRESSES)
                       + case["activation_sd_s"] * chance.standard_normal(self.PRESSES))
            counted = float(numpy.mean((press_s < 0) | (press_s > case["window_s"])))
            self.assertTrue(0 <= answer["error"] <= 1, f"{case}: {answer['error']}")
            error = (answer["error"] * (1 - answer["error"]) / self.PRESSES) ** 0.5
            self.assertLessEqual(abs(counted - answer["error"]), allowed * error + 1e-12, case)

    def test_share_outside_the_window_is_that_of_two_tails(self):
        for case, answer in zip(self.ASKED, probed(self.ASKED), strict=True):
            spread_s = numpy.hypot(case["spread"] * case["interval_s"], case["activation_sd_s"])
            late, early = (1 - case["aim"]) * case["window_s"], case["aim"] * case["window_s"]
            self.assertAlmostEqual(answer["error"], norm.sf(late / spread_s) + norm.sf(early / spread_s), delta=1e-12)


def table():
    largest = {}
    for _, found in all_differences():
        for figure, difference, allowed in found:
            seen = largest.setdefault(figure, [0, 0.0, 0.0])
            seen[0] += 1
            seen[1] = max(seen[1], difference)
            seen[2] = max(seen[2], difference / allowed if allowed else difference)
    for figure, (count, difference, share) in largest.items():
        print(f"{figure:13s} {count:3d} presses, largest difference {difference:.3g}, {share:.0%} of what is allowed")


if __name__ == "__main__":
    if "--table" in sys.argv:
        table()
    else:
        unittest.main()
