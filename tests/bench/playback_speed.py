#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is left to feel when the finger moves faster: energy in 40-400 Hz against speed, 1 to 300 mm/s.

playback_speed.py PROGRAM [--write DOCS_DIR]

Renders strokes at constant speed with detent-play: the slope of button A (whole travel, grains only), the jump of button B
and the bottom-out of button A (clicks only). Level: root of the mean square in 40-400 Hz over the time the finger moves and
one grain longer (slope), or over the burst's own length (jump, bottom-out). Constant: mean over the same time. `--write` puts
docs/measurements/bench-playback-speed.md and its picture. Plain Python, no timing: the same figures on every machine.
"""
import argparse, cmath, math, pathlib, struct, subprocess, sys, tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
SPEEDS = [1, 2, 5, 10, 20, 50, 100, 200, 300]
RATE = 8000
LEAD_S = 0.1
GRAIN_S, JUMP_S, BOTTOM_S = 0.020, 0.034, 0.030
LOW_HZ, HIGH_HZ = 40, 400


def fft(x):
    """In place, iterative, power of two."""
    n = len(x)
    j = 0
    for i in range(1, n):
        bit = n >> 1
        while j & bit:
            j ^= bit
            bit >>= 1
        j |= bit
        if i < j:
            x[i], x[j] = x[j], x[i]
    size = 2
    while size <= n:
        step = cmath.exp(-2j * math.pi / size)
        twiddle = [1]
        for _ in range(size // 2 - 1):
            twiddle.append(twiddle[-1] * step)
        for start in range(0, n, size):
            for k in range(size // 2):
                a, b = x[start + k], x[start + k + size // 2] * twiddle[k]
                x[start + k], x[start + k + size // 2] = a + b, a - b
        size *= 2
    return x


def samples_of(file):
    data = file.read_bytes()
    at = 12
    while data[at:at + 4] != b"data":
        at += 8 + struct.unpack_from("<I", data, at + 4)[0]
    length = struct.unpack_from("<I", data, at + 4)[0]
    return struct.unpack_from(f"<{length // 4}f", data, at + 8)


def band_energy(samples):
    """Sum of squares of what lies in LOW_HZ..HIGH_HZ (Parseval)."""
    n = 1
    while n < len(samples):
        n *= 2
    spectrum = fft([complex(s) for s in samples] + [0j] * (n - len(samples)))
    return sum((2 if 0 < k < n // 2 else 1) * abs(spectrum[k])**2
               for k in range(n // 2) if LOW_HZ <= k * RATE / n <= HIGH_HZ) / n


def stroke(speed, travel):
    """A press at constant speed, ten times as fast a reading as 425 Hz where it needs them, then stillness."""
    rows = ["time_s,displacement_mm", "0,0", f"{LEAD_S},0"]
    end = LEAD_S + travel / speed
    rows += [f"{LEAD_S + i / 425},{i / 425 * speed}" for i in range(1, int(travel / speed * 425) + 1)
             if i / 425 * speed < travel]
    return "\n".join(rows + [f"{end},{travel}", f"{end + 0.3},{travel}"]) + "\n"


def measure(program, folder, button, travel, speed, options, span_s):
    trace, sound = folder / "trace.csv", folder / "out.wav"
    trace.write_text(stroke(speed, travel))
    subprocess.run([program, "render", SOURCE / f"samples/buttons/{button}.button.json", "--press", trace, "-o", sound,
                    "--rate", str(RATE), "--feel", "paper", *options], check=True, capture_output=True)
    samples = samples_of(sound)
    sounding = [i for i, s in enumerate(samples) if s != 0]
    if not sounding:
        return 0.0, 0.0
    span = span_s(speed, travel) * RATE
    first = sounding[0]
    cut = samples[first:first + int(span)]
    return math.sqrt(band_energy(samples) / span), abs(sum(cut) / span)


def picture(curves):
    """Level in dB of full scale against speed, both axes labelled."""
    width, height, left, top, right, bottom = 640, 380, 70, 20, 180, 50
    x = lambda v: left + math.log10(v) / math.log10(300) * (width - left - right)
    y = lambda db: top + -db / 60 * (height - top - bottom)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" font-family="sans-serif" font-size="12">',
           '<rect width="100%" height="100%" fill="white"/>']
    for db in range(0, -61, -10):
        out.append(f'<path d="M{left} {y(db)}H{width - right}" stroke="#ddd"/>'
                   f'<text x="{left - 8}" y="{y(db) + 4}" text-anchor="end">{db}</text>')
    for v in SPEEDS:
        out.append(f'<path d="M{x(v):.1f} {top}V{height - bottom}" stroke="#eee"/>'
                   f'<text x="{x(v):.1f}" y="{height - bottom + 16}" text-anchor="middle">{v}</text>')
    out.append(f'<text x="{(left + width - right) / 2}" y="{height - 12}" text-anchor="middle">speed of the finger in mm/s</text>')
    out.append(f'<text transform="translate(16 {(top + height - bottom) / 2}) rotate(-90)" text-anchor="middle">'
               'level in 40-400 Hz, dB of full scale</text>')
    for i, (name, values) in enumerate(curves):
        colour = ["#0072b2", "#999999", "#d55e00", "#009e73"][i]
        points = " ".join(f"{x(v):.1f},{y(max(-60, 20 * math.log10(max(level, 1e-6)))):.1f}" for v, level in values)
        out.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2"/>')
        out.append(f'<path d="M{width - right + 12} {top + 20 + 22 * i}h20" stroke="{colour}" stroke-width="2"/>'
                   f'<text x="{width - right + 38}" y="{top + 24 + 22 * i}">{name}</text>')
    return "\n".join(out + ["</svg>"]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--write")
    options = parser.parse_args()
    moving = lambda speed, travel: travel / speed + GRAIN_S
    kinds = [("slope, running carrier", "A", 4, ["--mode", "slope-only"], moving),
             ("slope, retriggered", "A", 4, ["--mode", "slope-only", "--grain-carrier", "retriggered", "--high-pass-hz", "0"], moving),
             ("jump", "B", 3, ["--mode", "click-only"], lambda *_: JUMP_S),
             ("bottom-out", "A", 4, ["--mode", "click-only"], lambda *_: BOTTOM_S)]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        table = {kind: [(v, *measure(options.program, folder, button, travel, v, flags, span)) for v in SPEEDS]
                 for kind, button, travel, flags, span in kinds}
    text = ["# Feedback against the speed of the finger", "",
            "Written by `tests/bench/playback_speed.py`, which says how. Level: rms in 40-400 Hz of full scale while the finger moves "
            "(slope) or while the burst lasts; in brackets the constant part.", "", "![level against speed](bench-playback-speed.svg)", "",
            "| mm/s | " + " | ".join(table) + " |", "|---" * (len(table) + 1) + "|"]
    for i, v in enumerate(SPEEDS):
        text.append(f"| {v} | " + " | ".join(f"{rows[i][1]:.3f} ({rows[i][2]:.4f})" for rows in table.values()) + " |")
    at = {v: level for v, level, _ in table["slope, running carrier"]}
    text += ["", "Slope at 50, 100 and 200 mm/s against 5 mm/s: " +
             ", ".join(f"{20 * math.log10(at[v] / at[5]):+.1f} dB" for v in (50, 100, 200)) + " (asked: within 6 dB).", ""]
    print("\n".join(text))
    if options.write:
        docs = pathlib.Path(options.write)
        (docs / "bench-playback-speed.md").write_text("\n".join(text))
        (docs / "bench-playback-speed.svg").write_text(
            picture([(kind, [(v, level) for v, level, _ in rows]) for kind, rows in table.items()]))
    worst = max(constant for _, _, constant in table["slope, running carrier"])
    return 0 if all(abs(20 * math.log10(at[v] / at[5])) <= 6 for v in (50, 100, 200)) and worst <= 0.01 else 1


if __name__ == "__main__":
    sys.exit(main())
