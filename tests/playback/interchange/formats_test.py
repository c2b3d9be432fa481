#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads every exported file by a reader written from the format's description (docs/reference/export-formats.md names it) and plays it.

    formats_test.py DETENT_PLAY

Lossless formats must give the samples of `detent-play render` within 1e-3 of full scale; of the others, the energy that the reader
finds in each band must be the energy that the loss record tells, within 2 %. Needs Debian's python3-numpy: without it, SKIPPED.
"""
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import numpy
except ImportError:
    print("SKIPPED: needs python3-numpy")
    sys.exit(0)

PLAY = sys.argv.pop(1)
SAMPLES = Path(__file__).resolve().parents[3] / "samples/buttons"
RATE = 48000
BANDS = {"20_80_Hz": (20, 80), "80_230_Hz": (80, 230), "230_500_Hz": (230, 500)}


# What of Android the export names.
ANDROID = {
    "Build": "public class Build { public static class VERSION { public static final int SDK_INT = 36; } }",
    "Vibrator": """public class Vibrator {
      public static class Profile { public float getMinFrequencyHz() { return 0; } public float getMaxFrequencyHz() { return 1; } }
      public boolean areEnvelopeEffectsSupported() { return true; }
      public Profile getFrequencyProfile() { return null; }
    }""",
    "VibrationEffect": """public class VibrationEffect {
      public static VibrationEffect createWaveform(long[] timings, int[] amplitudes, int repeat) { return null; }
      public static class WaveformEnvelopeBuilder {
        public WaveformEnvelopeBuilder setInitialFrequencyHz(float hertz) { return this; }
        public WaveformEnvelopeBuilder addControlPoint(float amplitude, float hertz, long milliseconds) { return this; }
        public VibrationEffect build() { return null; }
      }
    }""",
}


def floats_of_wav(path):
    """32 bit float WAV, as `render` writes it."""
    data = Path(path).read_bytes()
    at = 12
    while at < len(data):
        name, size = data[at:at + 4], int.from_bytes(data[at + 4:at + 8], "little")
        if name == b"data":
            return numpy.frombuffer(data[at + 8:at + 8 + size], "<f4").astype(float)
        at += 8 + size + size % 2
    raise AssertionError("no data")


def sine(time, points, phase=0.0):
    """A sine whose amplitude and frequency run straight between (t, a, f): phase is the integral of the frequency."""
    out = numpy.zeros(len(time))
    for (t0, a0, f0), (t1, a1, f1) in zip(points, points[1:]):
        if t1 <= t0:
            continue
        inside = (time >= t0 - 1e-9) & (time < t1 - 1e-9)
        t = time[inside] - t0
        slope = (f1 - f0) / (t1 - t0)
        out[inside] += (a0 + (a1 - a0) * t / (t1 - t0)) * numpy.sin(2 * math.pi * (phase + f0 * t + slope * t * t / 2))
        phase += f0 * (t1 - t0) + slope * (t1 - t0) ** 2 / 2
    return out


def energies(parts, length):
    """Of parts that are played apart, each by itself; bins on a band's edge count for their share within."""
    found = dict.fromkeys(BANDS, 0.0)
    size = max(length, 1 << 17)
    frequency = numpy.fft.rfftfreq(size, 1 / RATE)
    half = frequency[1] / 2
    for samples in parts:
        spectrum = numpy.abs(numpy.fft.rfft(samples, size)) ** 2
        for name, (low, high) in BANDS.items():
            within = numpy.minimum(high, frequency + half) - numpy.maximum(low, frequency - half)
            found[name] += (spectrum * numpy.clip(within / (2 * half), 0, 1)).sum()
    return found


class Formats(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def run_play(self, *arguments):
        return subprocess.run([PLAY, *map(str, arguments)], capture_output=True, text=True, check=False)

    def export(self, button, name, ending=".out", *more):
        out = os.path.join(self.folder, f"{button}-{name}{ending}")
        done = self.run_play("export", SAMPLES / f"{button}.button.json", "--format", name, "-o", out, "--json", *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        answer = json.loads(done.stdout)
        return [Path(path).read_text(encoding="utf-8") for path in answer["outputs"]], answer["loss"]

    def rendered(self, button):
        out = os.path.join(self.folder, button + ".wav")
        done = self.run_play("render", SAMPLES / f"{button}.button.json", "--standard-press", "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        return floats_of_wav(out)

    def assert_same(self, played, original):
        self.assertEqual(len(played), len(original))
        self.assertLess(numpy.abs(played - original).max(), 1e-3)

    def assert_told(self, played, original, loss):
        length = 1 << max(1, (len(original) - 1)).bit_length()
        parts = [part[:length] for part in (played if isinstance(played, list) else [played])]
        before, after = energies([original], length), energies(parts, length)
        for band in BANDS:
            if loss["energy_kept"][band] is None:
                continue
            self.assertAlmostEqual(after[band] / before[band], loss["energy_kept"][band], delta=0.02 * max(1, loss["energy_kept"][band]),
                                   msg=band)

    def test_text_of_a_program_under_another_ending_is_warned_of(self):
        for name, ending, right in (("c", ".json", ".h"), ("da728x", ".json", ".h"), ("android", ".java", ".kt"), ("c", ".h", None), ("ahap", ".ahap", None)):
            with self.subTest(name + ending):
                done = self.run_play("export", SAMPLES / "B.button.json", "--format", name, "-o", os.path.join(self.folder, "x" + ending))
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(right is not None, "give it the ending" in done.stderr, done.stderr)
                if right:
                    self.assertIn(f"give it the ending {right}", done.stderr)

    # ---- lossless

    def test_hjif(self):
        """ISO/IEC 23090-31 as its reference software evaluates vectorial waves: linear amplitudes, phase in radians, one effect of a
        band at a time."""
        for button in ("A", "B", "F", "latch"):
            (text,), _ = self.export(button, "hjif", ".hjif")
            file, original = json.loads(text), self.rendered(button)
            played = numpy.zeros(len(original))
            scale = RATE / file["timescale"]
            for channel in file["perceptions"][0]["channels"]:
                for band in channel["bands"]:
                    self.assertEqual(band["band_type"], "VectorialWave")
                    end = -1
                    for effect in band["effects"]:
                        position = effect["position"]
                        self.assertGreater(position, end, "effects of one band overlap")
                        places = [position + k["relative_position"] for k in effect["keyframes"]]
                        end = places[-1]
                        at = numpy.arange(places[0], min(end, len(played) - 1) + 1)
                        amplitude = numpy.interp(at, places, [k["amplitude_modulation"] for k in effect["keyframes"]])
                        self.assertEqual([i for i, k in enumerate(effect["keyframes"]) if "frequency_modulation" in k], [0])
                        frequency = effect["keyframes"][0]["frequency_modulation"]
                        self.assertIsInstance(frequency, int)
                        played[at] += channel["gain"] * amplitude * numpy.sin(
                            2 * math.pi * frequency * (at - position) * scale / RATE + effect["phase"])
            self.assert_same(played, original)

    def test_pcm(self):
        for bits, full in (("16", 32767), ("8", 127)):
            (text,), _ = self.export("B", "pcm", ".h", "--bits", bits)
            numbers = re.search(r"detent_samples\[(\d+)\] = \{(.*?)\}", text, re.S)
            samples = numpy.array([int(n) for n in numbers.group(2).split(",") if n.strip()])
            self.assertEqual(len(samples), int(numbers.group(1)))
            original = self.rendered("B")
            self.assertEqual(len(samples), len(original))
            self.assertLess(numpy.abs(samples / full - original).max(), 0.51 / full)

    def test_pcm_at_another_rate_is_the_same_press(self):
        """By scipy's resampling back: the energies of the 48 kHz, and their samples but for what the rate cannot hold."""
        try:
            from scipy.signal import resample_poly
        except ImportError:
            self.skipTest("needs python3-scipy")
        for button in ("B", "D", "latch"):
            original = self.rendered(button)
            for rate in (8000, 16000, 44100, 96000):
                with self.subTest(button=button, rate=rate):
                    (text,), loss = self.export(button, "pcm", ".h", "--rate", rate)
                    self.assertIn(f"detent_sample_rate_Hz = {rate}u;", text)
                    numbers = re.search(r"detent_samples\[\d+\] = \{(.*?)\}", text, re.S)
                    samples = numpy.array([int(n) for n in numbers.group(1).split(",") if n.strip()]) / 32767
                    self.assertAlmostEqual(len(samples) / rate, len(original) / RATE, delta=1 / rate)
                    common = math.gcd(RATE, rate)
                    back = resample_poly(samples, RATE // common, rate // common)[:len(original)]
                    self.assert_told([numpy.pad(back, (0, len(original) - len(back)))], original, loss)
                    for band, kept in loss["energy_kept"].items():
                        if kept is not None:
                            self.assertAlmostEqual(kept, 1, delta=1e-3, msg=band)
                    self.assertLess(numpy.sqrt(((back - original[:len(back)]) ** 2).mean() / (original ** 2).mean()), 0.01)

    def test_package(self):
        """The example press, made anew from its bursts and the filters that the package states."""
        for button in ("A", "B", "F"):
            (text,), _ = self.export(button, "package", ".json")
            package, original = json.loads(text), self.rendered(button)
            self.assertEqual(package["example_press"]["samples"], len(original))
            chain = package["chain"]
            grains, bursts = numpy.zeros(len(original)), numpy.zeros(len(original))
            events = package["example_press"]["events"]
            slope = [e for e in events if e["kind"] == "grain"]
            started = 0.0  # where the running carrier began
            for i, event in enumerate(slope):
                wave_, first = event["wave"], event["sample"]
                length = wave_["duration_ms"] / 1000 * RATE
                last = min(first + math.ceil(length - 1e-9), len(original))
                if i + 1 < len(slope):
                    last = min(last, slope[i + 1]["sample"])
                before = slope[i - 1]["sample"] + slope[i - 1]["wave"]["duration_ms"] / 1000 * RATE if i else -1
                if not i or first >= math.ceil(before - 1e-9) or chain["grain_carrier"] != "running":
                    started = first
                t = numpy.arange(first, last)
                grains[t] = wave_["amplitude"] * (1 - (t - first) / length) * numpy.sin(
                    2 * math.pi * wave_["frequency_Hz"] * (t - started) / RATE)
            for event in events:
                if event["kind"] == "grain":
                    continue
                wave_, first = event["wave"], event["sample"]
                length = wave_["duration_ms"] / 1000 * RATE
                t = numpy.arange(first, min(first + math.ceil(length - 1e-9), len(original)))
                share = (t - first) / length
                level = share if wave_["envelope"] == "rising" else 1 - share
                bursts[t] += wave_["amplitude"] * level * numpy.sin(2 * math.pi * wave_["frequency_Hz"] * (t - first) / RATE)
            for stage in (chain["grain_low_pass"], chain["grain_high_pass"]):
                c, out, s1, s2 = stage["coefficients"], numpy.zeros(len(grains)), 0.0, 0.0
                for i, x in enumerate(grains):
                    y = c["b0"] * x + s1
                    s1, s2 = c["b1"] * x - c["a1"] * y + s2, c["b2"] * x - c["a2"] * y
                    out[i] = y
                grains = out
            quiet, level, now = chain["slope_under_jump"], numpy.ones(len(original)), 1.0
            sounding = numpy.zeros(len(original), bool)
            for event in events:
                if event["quietens_slope"]:
                    sounding[event["sample"]:event["sample"] + math.ceil(event["wave"]["duration_ms"] / 1000 * RATE)] = True
            for i in range(len(level)):
                turn = 1000 / (quiet["turn_ms"] * RATE)
                now = max(quiet["level"], now - turn) if sounding[i] else min(1.0, now + turn)
                level[i] = now
            played = chain["gain"] * (level * grains + bursts)
            course = package["example_press"]["limiter_gain"]["points"]
            self.assertEqual(bool(course), numpy.abs(played).max() > chain["limiter_ceiling"])
            if course:
                played *= numpy.interp(numpy.arange(len(played)), *zip(*course))
            self.assert_same(played, original)

    # ---- lossy

    def test_ahap(self):
        for button in ("B", "C", "latch"):
            parts, loss = self.export(button, "ahap", ".ahap")
            original = self.rendered(button)
            time = numpy.arange(len(original)) / RATE
            played = []
            bottom = [e for e in json.loads(self.export(button, "package", ".json")[0][0])["example_press"]["events"]
                      if e["kind"] == "bottom_out"]
            steps = []
            for text, zero in zip(parts, (0.0, self.turn_s(button))):
                file = json.loads(text)
                self.assertEqual(file["Version"], 1.0)
                played.append(numpy.zeros(len(original)))
                for entry in file["Pattern"]:
                    event = entry["Event"]
                    values = {p["ParameterID"]: p["ParameterValue"] for p in event["EventParameters"]}
                    amplitude = values["HapticIntensity"] ** 2
                    frequency = 80 + 150 * values["HapticSharpness"]
                    transient = event["EventType"] == "HapticTransient"
                    start = zero + event["Time"]
                    end = start + (0.022 if transient else event["EventDuration"])
                    steps.append((start, amplitude))
                    played[-1] += sine(time, [(start, amplitude, frequency), (end, 0 if transient else amplitude, frequency)])
            for event in bottom:  # its last step of 5 ms, whose middle is half a step before its end
                wave = event["wave"]
                last = event["time_s"] + (wave["duration_ms"] - 5) / 1000
                strongest = max(amplitude for start, amplitude in steps if abs(start - last) < 5e-5)
                self.assertAlmostEqual(strongest, wave["amplitude"] * (1 - 2.5 / wave["duration_ms"]), delta=1e-4)
            self.assert_told(played, original, loss)

    def turn_s(self, button):
        """Of the standard press: 20 ms of rest, 120 ms down, 80 ms of hold with a tremor of 1 % at 10 Hz, sampled at 425 Hz."""
        del button
        readings = [i / 425 for i in range(math.ceil(0.34 * 425) + 1)]
        force = [1 + 0.01 * math.sin(2 * math.pi * 10 * (t - 0.14)) if 0.14 < t < 0.22 else 0.5 for t in readings]
        return round(readings[force.index(max(force))] * RATE) / RATE

    def test_haptic(self):
        for button in ("B", "F"):
            (text,), loss = self.export(button, "haptic", ".haptic")
            file, original = json.loads(text), self.rendered(button)
            envelopes = file["signals"]["continuous"]["envelopes"]
            times = [p["time"] for p in envelopes["amplitude"]]
            self.assertEqual(times, sorted(times))
            points = [(a["time"], a["amplitude"], 80 + 150 * math.sqrt(f["frequency"]))
                      for a, f in zip(envelopes["amplitude"], envelopes["frequency"])]
            self.assert_told(sine(numpy.arange(len(original)) / RATE, points), original, loss)

    def test_a_name_that_two_files_of_a_format_would_have_is_refused(self):
        out = os.path.join(self.folder, "one.h")
        done = self.run_play("export", SAMPLES / "B.button.json", "--format", "openxr", "-o", out)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("one.h: two exported files would get this name. Give the file another ending than .h", done.stderr)
        self.assertFalse(os.path.exists(out))

    def test_openxr(self):
        for button in ("A", "B", "latch"):
            (text, header), loss = self.export(button, "openxr", ".json")
            file, original = json.loads(text), self.rendered(button)
            self.assertIn("XrHapticParametricVibrationEXT", header)
            low, high = file["minFrequencyHz"], file["maxFrequencyHz"]
            self.assertEqual(file["amplitudePointCount"], len(file["amplitudePoints"]))
            at = [p["time"] / 1e9 for p in file["frequencyPoints"]]
            hertz = [low + (high - low) * p["value"] for p in file["frequencyPoints"]]
            for frequency in hertz:
                self.assertLess(min(abs(frequency - known) for known in (150, 200, 390, 410)), 0.1)
            points = [(p["time"] / 1e9, p["value"], float(numpy.interp(p["time"] / 1e9, at, hertz))) for p in file["amplitudePoints"]]
            self.assert_told(sine(numpy.arange(len(original)) / RATE, points), original, loss)

    def test_bos1921(self):
        for button in ("A", "C", "F"):
            (text,), loss = self.export(button, "bos1921", ".h")
            slices = [tuple(map(int, m)) for m in re.findall(r"\{(\d+), (\d+), (\d+)\}", text)]
            original = self.rendered(button)
            time, played, now = numpy.arange(len(original)) / RATE, numpy.zeros(len(original)), 0.0
            starts = []
            for amplitude, frequency, cycles in slices:
                self.assertTrue(0 <= amplitude <= 4095 and 1 <= frequency <= 255 and 1 <= cycles <= 255)
                end = now + cycles / (3.9 * frequency)
                if amplitude > 0:
                    starts.append(now)
                played += sine(time, [(now, amplitude / 4095, 3.9 * frequency), (end, amplitude / 4095, 3.9 * frequency)])
                now = end
            self.assert_told(played, original, loss)
            self.assertLessEqual(abs(self.onset_error_ms(button, starts) - loss["worst_timing_error_ms"]), 3)

    def test_da728x(self):
        """The memory as the maker's decoder walks it: end pointers are indices of last bytes, a ramp starts where the last one ended."""
        for button in ("A", "B", "latch"):
            (text,), loss = self.export(button, "da728x", ".h")
            memory = [int(b, 16) for b in re.findall(r"0x([0-9A-F]{2})", text)]
            self.assertEqual(len(memory), 100)
            snippets, sequences = memory[0], memory[1]
            snippet_ends, sequence_ends = memory[2:2 + snippets], memory[2 + snippets:2 + snippets + sequences]
            self.assertLess(sequence_ends[-1], 100)
            original = self.rendered(button)
            lasts, played = [], []
            for number in range(sequences):
                at = (snippet_ends[-1] if number == 0 else sequence_ends[number - 1]) + 1
                lasts.append(0)
                while at <= sequence_ends[number]:
                    frame = memory[at]
                    self.assertEqual(frame & 0x80, 0)
                    snippet, base, gain = frame & 7, frame >> 3 & 3, frame >> 5 & 3
                    self.assertEqual(gain, 0)
                    at += 1
                    if at <= sequence_ends[number] and memory[at] & 0x80:
                        self.assertEqual(memory[at], 0x81, "once, at the motor's own frequency")
                        snippet, at = snippet + 8, at + 1
                    begin = 2 + snippets + sequences if snippet == 1 else snippet_ends[snippet - 2] + 1
                    points = memory[begin:snippet_ends[snippet - 1] + 1]
                    self.assertTrue(points)
                    self.assertEqual(points[0] & 0x80, 0, "no ramp from another snippet's level")
                    lasts[-1] += sum((p >> 4 & 7) + 1 for p in points) * 0.00136 * (1, 4, 16, 32)[base]
                    played.append(snippet)
                self.assertEqual(points[-1] & 15, 0, "ends at rest")
            self.assertEqual(played, list(range(1, snippets + 1)))
            self.assertLess(sum(lasts), len(original) / RATE + 0.2)
            self.assertLess(loss["worst_timing_error_ms"], 0.7)

    def zeros_s(self, button, room_s):
        """When each half begins: at its first burst, or at a jump or bottom-out within `room_s` of it."""
        events = json.loads(self.export(button, "package", ".json")[0][0])["example_press"]["events"]
        turn, zeros = self.turn_s(button), []
        for low, high in ((-1, turn - 1e-9), (turn - 1e-9, 1e9)):
            half = [(e["sample"] / RATE, e["kind"]) for e in events if low <= e["sample"] / RATE < high]
            strong = [t for t, kind in half if kind != "grain" and t - half[0][0] < room_s]
            zeros.append((strong or [half[0][0]])[0] if half else None)
        return zeros

    def onset_error_ms(self, button, starts):
        """Of jumps and bottom-outs to the nearest beginning of a level."""
        events = json.loads(self.export(button, "package", ".json")[0][0])["example_press"]["events"]
        return max(min(abs(e["sample"] / RATE - start) for start in starts) for e in events if e["kind"] != "grain") * 1000

    def levels(self, time, zero, steps, full):
        """(level, ms) one after another, by a motor at 205 Hz; and when each begins."""
        points, starts, now = [], [], zero
        for level, lasts_ms in steps:
            starts.append(now)
            points += [(now, level / full, 205), (now + lasts_ms / 1000, level / full, 205)]
            now += lasts_ms / 1000
        return sine(time, points), starts

    def test_drv2605(self):
        for button in ("A", "B", "F", "latch"):
            (text,), loss = self.export(button, "drv2605", ".h")
            original = self.rendered(button)
            time = numpy.arange(len(original)) / RATE
            played, starts = [], []
            for name, zero in zip(("detent_press", "detent_release"), self.zeros_s(button, 0.005)):
                numbers = re.search(name + r"\[\] = \{(.*?)\};", text, re.S).group(1)
                steps = [(int(a), int(ms)) for a, ms in re.findall(r"\{(\d+), (\d+)\}", numbers)]
                self.assertTrue(all(0 <= a <= 127 and 5 <= ms <= 255 for a, ms in steps))
                self.assertEqual(steps[-1][0], 0)
                if zero is not None:
                    wave, begins = self.levels(time, zero, steps, 127)
                    played.append(wave)
                    starts += begins
            self.assert_told(played, original, loss)
            self.assertLessEqual(self.onset_error_ms(button, starts), 1)
            self.assertLessEqual(loss["worst_timing_error_ms"], 1)

    def test_android(self):
        for button in ("A", "B", "F", "latch"):
            (text,), loss = self.export(button, "android", ".kt")
            original = self.rendered(button)
            time = numpy.arange(len(original)) / RATE
            played, starts = [], []
            halves = re.search(r"fun press(.*?)fun release(.*)", text, re.S).groups()
            rooms = zip(self.zeros_s(button, 0.02), self.zeros_s(button, 0.002))
            for half, (zero, fine_zero) in zip(halves, rooms):
                points = [(float(a), float(f), int(ms)) for a, f, ms in
                          re.findall(r"addControlPoint\(([\d.e+-]+)f, ([\d.e+-]+)f, (\d+)L\)", half)]
                timings = re.search(r"longArrayOf\((.*?)\)", half, re.S)
                if not timings:
                    continue
                durations = [int(n) for n in timings.group(1).split(",")]
                levels = [int(n) for n in re.search(r"intArrayOf\((.*?)\)", half, re.S).group(1).split(",")]
                self.assertEqual(len(durations), len(levels))
                self.assertTrue(all(ms >= 1 for ms in durations) and all(0 <= a <= 255 for a in levels))
                if not points:
                    wave, begins = self.levels(time, fine_zero, list(zip(levels, durations)), 255)
                    played.append(wave)
                    starts += begins
                    continue
                self.assertTrue(len(points) <= 16 and all(ms >= 20 and 0 <= a <= 1 for a, _, ms in points))
                self.assertEqual(points[-1][0], 0)
                self.assertIn("holds(vibrator, ", half)
                course, now = [(zero, 0, points[0][1])], zero
                for amplitude, frequency, lasts_ms in points:
                    starts.append(now)
                    now += lasts_ms / 1000
                    course.append((now, amplitude, frequency))
                played.append(sine(time, course))
            self.assert_told(played, original, loss)
            self.assertLessEqual(self.onset_error_ms(button, starts), 1)
            self.assertLessEqual(loss["worst_timing_error_ms"], 1)

    def test_a_long_android_press_compiles(self):
        if not shutil.which("kotlinc"):
            print("SKIPPED Kotlin: kotlinc is not installed")
            return
        folder = Path(self.folder, "kotlin")
        for name, text in ANDROID.items():
            (folder / "android/os").mkdir(parents=True, exist_ok=True)
            (folder / f"android/os/{name}.java").write_text("package android.os;\n" + text)
        press = folder / "press.csv"  # 28 s of presses, eight times a second
        press.write_text("time_s,force_N\n" + "".join(f"{i / 200:g},{1 - math.cos(2 * math.pi * i / 25):.5f}\n" for i in range(5600)))
        (text,), _ = self.export("EF", "android", ".kt", "--press", press)
        self.assertGreater(len(re.findall(r"longArrayOf", text)), 2)
        for arrays in re.findall(r"ArrayOf\(([^)]*)\)", text):
            self.assertLessEqual(arrays.count(","), 2000)
        (folder / "Button.kt").write_text(text)
        for command in (["javac", "-d", "classes", *folder.glob("android/os/*.java")], ["kotlinc", "-classpath", "classes", "Button.kt", "-d", "out"]):
            done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((folder / "out/DetentButton.class").exists())

    def test_header_compiles_as_c_and_cpp(self):
        compilers = [(shutil.which("gcc"), ["-std=c99", "-x", "c"]), (shutil.which("g++"), ["-std=c++11", "-x", "c++"])]
        for button in ("A", "B", "latch"):
            for name in ("c", "pcm", "bos1921", "da728x", "drv2605"):
                out = os.path.join(self.folder, "button.h")
                self.assertEqual(self.run_play("export", SAMPLES / f"{button}.button.json", "--format", name, "-o", out).returncode, 0)
                for compiler, standard in compilers:
                    if not compiler:
                        continue
                    done = subprocess.run([compiler, *standard, "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only", "-"],
                                          input=f'#include "{out}"\nint main(void) {{ return 0; }}\n', text=True, capture_output=True,
                                          check=False)
                    self.assertEqual(done.returncode, 0, done.stderr)

    # ---- refusals

    def test_refusals_write_nothing(self):
        button = SAMPLES / "B.button.json"
        out = os.path.join(self.folder, "no.json")
        for arguments, code in ((["--format", "midi"], 2), (["--format", "package", "--press", "human:1ms"], 2),
                                (["--format", "package", "--press", "missing.csv"], 3),
                                (["--format", "pcm", "--bits", "12"], 2), (["--format", "pcm", "--rate", "1"], 2)):
            done = self.run_play("export", button, *arguments, "-o", out)
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertFalse(os.path.exists(out))
            self.assertTrue(done.stderr.strip())

    def test_a_second_file_that_cannot_be_written_takes_the_first_with_it(self):
        os.mkdir(os.path.join(self.folder, "x.release.ahap"))
        done = self.run_play("export", SAMPLES / "B.button.json", "--format", "ahap", "-o", os.path.join(self.folder, "x.ahap"))
        self.assertNotEqual(done.returncode, 0)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "x.press.ahap")))


unittest.main()
