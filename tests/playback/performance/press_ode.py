# SPDX-License-Identifier: GPL-3.0-or-later
"""One press of one finger as an ordinary differential equation, from docs/reference/press-forecast.md ("Plant") and without the plant's source.
The rules of walls and of crossing strokes are those of the product's key_tables.cpp, which was read: there it bears no witness.

Every piece between two events (touch, turn of the pulp, turn of the play, stops, contact, end) is smooth and solved by DOP853;
lengths in m, downwards, forces in N, times in s from the start of the command.
"""
import bisect
import math

from scipy.integrate import solve_ivp

START_M = 0.003  # the finger above the cap
POSTURE_N_PER_M, JOINT_NS_PER_M = 20.0, 0.5
CAP_KG, STOP_N_PER_M, CAP_NS_PER_M = 0.002, 20000.0, 0.2
PLAY_M = 0.02e-3  # of a whole turn, from one branch to the other
CELLS, WALL_N_PER_M = 1024, 200000.0  # a wall of the graph rises within the last of so many parts of the travel, no steeper
EXTENSOR, EXTENSOR_S = 0.6, 0.020
LONGEST_S = 0.5
TOLERANCE = 1e-7
NOT, COMPRESSED, RELAXING = range(3)  # the pulp


class Stroke:
    """Force over depth from a file's knots (docs/reference/file-format.md): cubics in Hermite form, the nearest end's force outside."""

    def __init__(self, knots):
        self.starts, self.pieces = [], []
        points = [(k["displacement_mm"] / 1000, k["force_N"], k["slopeBefore_N_per_mm"] * 1000, k["slopeAfter_N_per_mm"] * 1000)
                  for k in knots]
        self.first_N, self.last_N = points[0][1], points[-1][1]
        self.start, self.end = points[0][0], points[-1][0]
        self.wall_N_per_m, self.wall_from = 0.0, math.inf
        for (x0, f0, _, s0), (x1, f1, s1, _) in zip(points, points[1:]):
            if x1 == x0:
                assert x1 == self.end and f1 > f0, "only a wall at the end of the travel is followed here"
                self.wall_from = self.end - self.end / CELLS
                self.wall_N_per_m = min((f1 - f0) * CELLS / self.end, WALL_N_PER_M)
                self.last_N = f0 + self.wall_N_per_m * self.end / CELLS
                continue
            width = x1 - x0
            rise = f1 - f0
            self.starts.append(x0)
            self.pieces.append((x0, width, f0, width * s0, 3 * rise - width * (2 * s0 + s1), width * (s0 + s1) - 2 * rise))

    def __call__(self, x):
        if x <= self.start:
            return self.first_N
        if x >= self.end:
            return self.last_N
        x0, width, a, b, c, d = self.pieces[bisect.bisect_right(self.starts, x) - 1]
        u = (x - x0) / width
        force = a + u * (b + u * (c + u * d))
        return force + max(0.0, x - self.wall_from) * self.wall_N_per_m


class Key:
    def __init__(self, button):
        state = button["states"][0]
        self.press = Stroke(state["press"])
        self.release = Stroke(state.get("release", state["press"]))
        self.end = self.press.end
        self.dampers = [(p["displacement_mm"] / 1000, p["damping_Ns_per_mm"] * 1000) for p in state.get("damping", [])]

    def force(self, x, play):
        inside = min(max(x, 0.0), self.end)
        down = self.press(inside)
        up = min(down, self.release(inside))
        stop = STOP_N_PER_M * (x - inside)
        return 0.5 * (down + up) + 0.5 * (down - up) * play + stop

    def damping(self, x):
        if not self.dampers:
            return CAP_NS_PER_M
        at = bisect.bisect_left([p[0] for p in self.dampers], x)
        if at == 0:
            return CAP_NS_PER_M + self.dampers[0][1]
        if at == len(self.dampers):
            return CAP_NS_PER_M + self.dampers[-1][1]
        (x0, b0), (x1, b1) = self.dampers[at - 1:at + 1]
        return CAP_NS_PER_M + b0 + (x - x0) / (x1 - x0) * (b1 - b0)


class Press:
    """Solves one press; `outcome` afterwards holds what docs/reference/press-forecast.md speaks of."""

    def __init__(self, case):
        self.key = Key(case["button"])
        self.finger, self.command = case["finger"], case["command"]
        self.close, self.open = case["close_m"], case["open_m"]
        self.play, self.play_x = -1.0, None  # x where a turn of the play began; None: saturated
        self.pulp, self.closed = NOT, False
        rest = -self.key.force(0.0, self.play) / STOP_N_PER_M  # on the stop, as the last press left it
        self.start = -START_M
        # finger, its speed, cap, its speed, muscle, impulse
        self.y = [self.start, 0.0, rest, 0.0, 0.0, 0.0]
        self.region = -1 if rest < 0 else 0
        self.t = 0.0
        self.grazing = False  # the pulp stands still: its damper, continuous there, is not cut at its turns for 10 µs
        self.pieces = 0
        self.outcome = {"touch_s": None, "activation_s": None, "peak_N": 0.0, "peak_s": 0.0, "impulse_Ns": 0.0, "deepest_m": 0.0,
                        "end_s": LONGEST_S, "ended": False, "closings": 0}
        self.run()

    # -- the equations

    def commanded(self, t):
        a, duration = self.command["amplitude_N"], self.command["duration_s"]
        flexor = a * math.sin(math.pi * t / duration) if t < duration else 0.0
        late = t - duration - self.command["lift_s"]
        extensor = EXTENSOR * a * self.finger["extensor_share"] * math.exp(-late / EXTENSOR_S) if self.extending else 0.0
        return flexor - extensor

    def muscle_slope(self, wanted, got):
        rises = abs(wanted) > abs(got)
        return (wanted - got) / (self.finger["muscle_rise_s"] if rises else self.finger["muscle_fall_s"])

    def play_at(self, x):
        return self.play if self.play_x is None else self.play + 2 * (x - self.play_x) / PLAY_M

    def contact_N(self, y):
        if self.pulp == NOT:
            return 0.0
        return self.finger["pulp_N_per_m"] * (y[0] - y[2]) + self.finger["pulp_damping_Ns_per_m"] * max(0.0, y[1] - y[3])

    def slope(self, t, y):
        contact = self.contact_N(y)
        force = y[4] - POSTURE_N_PER_M * (y[0] - self.start) - JOINT_NS_PER_M * y[1] - contact
        if self.outcome["touch_s"] is None:
            cap = 0.0
        else:
            cap = (contact - self.key.force(y[2], self.play_at(y[2])) - self.key.damping(y[2]) * y[3]) / CAP_KG
        return [y[1], force / self.finger["mass_kg"], y[3], cap, self.muscle_slope(self.commanded(t), y[4]), contact]

    # -- the events

    def events(self):
        """(what, function of (t, y), direction) in the present mode."""
        found = []
        if self.pulp == NOT:
            found.append(("touch", lambda t, y: y[0] - y[2], 1))
        else:
            found.append(("part", lambda t, y: y[0] - y[2], -1))
            if not self.grazing:
                found.append(("relax", lambda t, y: y[1] - y[3], -1) if self.pulp == COMPRESSED else
                             ("squeeze", lambda t, y: y[1] - y[3], 1))
        if self.outcome["touch_s"] is None:
            return found
        if self.play_x is not None:
            found += [("play full", lambda t, y: self.play_at(y[2]) - 1, 1), ("play empty", lambda t, y: self.play_at(y[2]) + 1, -1)]
        else:
            found.append(("play turns", lambda t, y: y[3], -1 if self.play > 0 else 1))
        if self.region >= 0:
            found.append(("up to the stop", lambda t, y: y[2], -1))
        if self.region < 0:
            found.append(("off the stop", lambda t, y: y[2], 1))
        if self.region == 0:
            found.append(("bottom", lambda t, y: y[2] - self.key.end, 1))
        if self.region > 0:
            found.append(("off the bottom", lambda t, y: y[2] - self.key.end, -1))
        if self.closed:
            found.append(("open", lambda t, y: y[2] - self.open, -1))
        else:
            found.append(("close", lambda t, y: y[2] - self.close, 1))
            if self.pulp == NOT:
                found.append(("up", lambda t, y: y[1], -1))
        return found

    def happened(self, what):
        y, out = self.y, self.outcome
        if what == "touch":
            if out["touch_s"] is None:
                out["touch_s"], out["touch_m_per_s"] = self.t, y[1]
            self.pulp, y[0] = COMPRESSED, y[2]
        elif what == "relax":
            self.pulp, y[1] = RELAXING, y[3]
        elif what == "squeeze":
            self.pulp, y[1] = COMPRESSED, y[3]
        elif what == "part":
            self.pulp, y[0] = NOT, y[2]
        elif what == "play turns":
            y[3], self.play_x = 0.0, y[2]
        elif what == "play full":
            self.play, self.play_x = 1.0, None
        elif what == "play empty":
            self.play, self.play_x = -1.0, None
        elif what in ("up to the stop", "off the stop"):
            self.region, y[2] = -1 if what == "up to the stop" else 0, 0.0
        elif what in ("bottom", "off the bottom"):
            self.region, y[2] = 1 if what == "bottom" else 0, self.key.end
        elif what == "close":
            self.closed = True
            out["closings"] += 1
            if out["activation_s"] is None:
                out["activation_s"], out["activation_m_per_s"] = self.t, y[3]
        elif what == "open":
            self.closed = False
        elif what == "up":
            y[1] = 0.0

    def over(self):
        return self.outcome["touch_s"] is not None and self.pulp == NOT and not self.closed and self.y[1] <= 0

    # -- the run

    def look(self, solution):
        out = self.outcome
        out["deepest_m"] = max(out["deepest_m"], max(solution.y[2]))
        if self.pulp == NOT:
            return
        forces = [self.contact_N(y) for y in solution.y.T]
        for t0, t1, f0, f1 in zip(solution.t, solution.t[1:], forces, forces[1:]):
            if max(f0, f1) > 0.9 * out["peak_N"]:
                self.look_between(solution, t0, t1)

    def look_between(self, solution, t0, t1):
        times = [t0 + (t1 - t0) * i / 4 for i in range(5)]
        for _ in range(3):  # the parabola through the highest point and its neighbours
            forces = [self.contact_N(solution.sol(t)) for t in times]
            best = max(range(len(times)), key=lambda i: forces[i])
            if forces[best] > self.outcome["peak_N"]:
                self.outcome["peak_N"], self.outcome["peak_s"] = forces[best], times[best]
            elif forces[best] < 0.98 * self.outcome["peak_N"]:
                return
            low, high = times[max(best - 1, 0)], times[min(best + 1, len(times) - 1)]
            times = [low + (high - low) * i / 4 for i in range(5)]

    def run(self):
        duration = self.command["duration_s"]
        cuts = sorted({duration, duration + self.command["lift_s"], LONGEST_S})
        self.extending = False
        while cuts and not self.over():
            until = cuts[0]
            if until <= self.t:
                cuts.pop(0)
                self.extending = self.extending or self.t >= duration + self.command["lift_s"]
                continue
            events = self.events()
            for _, g, direction in events:
                g.terminal, g.direction = True, direction
            began = self.t
            if self.grazing:
                until = min(until, began + 1e-5)
            solution = solve_ivp(self.slope, (began, until), self.y, method="DOP853", rtol=TOLERANCE, atol=1e-11, max_step=1e-3,
                                 events=[g for _, g, _ in events], dense_output=True)
            assert solution.success, solution.message
            self.look(solution)
            self.pieces += 1
            assert self.pieces < 20000, f"no progress at {self.t} s"
            self.t, self.y = float(solution.t[-1]), [float(v) for v in solution.y[:, -1]]
            if solution.status == 1:
                for (what, _, _), times in zip(events, solution.t_events):
                    if len(times):
                        self.happened(what)
            if self.grazing and self.pulp != NOT:
                self.pulp = COMPRESSED if self.y[1] > self.y[3] else RELAXING
            self.grazing = self.t - began < 1e-9
        if self.over():
            self.outcome["ended"], self.outcome["end_s"] = True, self.t
        self.outcome["impulse_Ns"] = self.y[5]


def press(case):
    return Press(case).outcome
