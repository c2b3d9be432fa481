# SPDX-License-Identifier: GPL-3.0-or-later
"""The presses that the product's plant and the independent one are held against each other with: 14 keys, 4 presses each, and some that fail."""
import json
from pathlib import Path

SAMPLES = Path(__file__).resolve().parents[3] / "samples/buttons"


def knots(points, wall_N=None):
    """Straight lines through (mm, N), and a wall to `wall_N` at the end."""
    slopes = [(f1 - f0) / (x1 - x0) for (x0, f0), (x1, f1) in zip(points, points[1:])]
    rows = [{"displacement_mm": x, "force_N": f, "slopeBefore_N_per_mm": before, "slopeAfter_N_per_mm": after}
            for (x, f), before, after in zip(points, slopes[:1] + slopes, slopes + slopes[-1:])]
    if wall_N is not None:
        rows.append({"displacement_mm": points[-1][0], "force_N": wall_N, "slopeBefore_N_per_mm": 0.0, "slopeAfter_N_per_mm": 0.0})
    return rows


def smooth(points):
    """Cubics that are level at every point but the ends."""
    rows = knots(points)
    for row in rows[1:-1]:
        row["slopeBefore_N_per_mm"] = row["slopeAfter_N_per_mm"] = 0.0
    return rows


def button(name, press, release):
    return {"format": "detent-button", "version": 2, "name": name, "states": [{"name": "", "press": press, "release": release}]}


def linear(name, start_N, end_N, travel_mm, gap_N, wall_N=None):
    return button(name, knots([(0, start_N), (travel_mm, end_N)], wall_N), knots([(0, start_N - gap_N), (travel_mm, end_N - gap_N)], wall_N))


def tactile(name, scale, stretch):
    press = [(0, 0.3), (1.3, 0.55), (1.9, 0.42), (4, 0.6)]
    release = [(0, 0.2), (1.1, 0.36), (1.6, 0.22), (4, 0.58)]
    return button(name, *(smooth([(x * stretch, f * scale) for x, f in points]) for points in (press, release)))


def sample(letter):
    return json.loads((SAMPLES / f"{letter}.button.json").read_text(encoding="utf-8"))


def keys():
    """(button, closes at mm, opens at mm, the force that a press has to beat)."""
    return [
        (linear("linear 4 mm", 0.3, 0.8, 4, 0.05), 2.0, 1.9, 0.55),
        (linear("linear 4 mm with a wall", 0.3, 0.8, 4, 0.05, 1.2), 2.0, 1.9, 0.55),
        (linear("light 0.05 N", 0.02, 0.06, 2, 0.01), 1.2, 1.0, 0.05),
        (linear("heavy 20 N", 6.0, 20.0, 1.0, 2.0), 0.5, 0.4, 13.0),
        (linear("0.5 mm", 0.4, 0.8, 0.5, 0.1), 0.3, 0.2, 0.65),
        (linear("10 mm", 0.2, 0.9, 10, 0.1), 5.0, 4.5, 0.55),
        (linear("no release of its own", 0.5, 0.5, 3, 0.0), 1.5, 1.4, 0.5),
        (tactile("tactile", 1.0, 1.0), 2.0, 1.7, 0.55),
        (tactile("tactile 1 mm, 4 N", 7.0, 0.25), 0.45, 0.35, 3.9),
        (sample("A"), 2.0, 1.9, 0.6),
        (sample("B"), 2.0, 1.7, 0.55),
        (sample("C"), 2.0, 1.4, 0.65),
        (sample("D"), 2.2, 2.0, 1.7),
        (sample("push"), 1.5, 1.3, 0.6),
    ]


def finger(mass_g, pulp_N_per_mm, damping, rise_ms, share):
    return {"mass_kg": mass_g / 1000, "pulp_N_per_m": pulp_N_per_mm * 1000, "pulp_damping_Ns_per_m": damping,
            "muscle_rise_s": rise_ms / 1000, "muscle_fall_s": 1.5 * rise_ms / 1000, "extensor_share": share}


# Of the population's ranges the middle and corners; amplitude over the force to beat, duration and lift in ms.
PRESSES = [
    (finger(12, 1.5, 4, 30, 1.0), 2.5, 80, 0),
    (finger(8, 3.0, 2, 20, 1.3), 4.0, 65, -20),
    (finger(16, 0.8, 6, 40, 0.7), 5.0, 100, 20),
    (finger(10, 2.0, 3, 25, 0.9), 1.4, 125, 10),
]


def cases():
    found = []
    for made, close_mm, open_mm, force_N in keys():
        for pressing, factor, duration_ms, lift_ms in PRESSES:
            found.append({"button": made, "close_m": close_mm / 1000, "open_m": open_mm / 1000, "finger": pressing,
                          "command": {"amplitude_N": min(30.0, factor * force_N + 0.3), "duration_s": duration_ms / 1000,
                                      "lift_s": lift_ms / 1000}})
    made, close_mm, open_mm, _ = keys()[0]
    for amplitude_N, duration_ms, lift_ms in ((0.02, 80, 0), (0.45, 50, 0), (2.0, 500, 0)):  # no touch, no contact, no end
        found.append({"button": made, "close_m": close_mm / 1000, "open_m": open_mm / 1000, "finger": PRESSES[0][0],
                      "command": {"amplitude_N": amplitude_N, "duration_s": duration_ms / 1000, "lift_s": lift_ms / 1000}})
    return found
