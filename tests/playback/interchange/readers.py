# SPDX-License-Identifier: GPL-3.0-or-later
"""Players of the exported files, one per format, written from what each format's makers publish and from the words in the files,
without a look at the writers (formats_test.py is theirs). Each gives samples at 48000 Hz, halves of a press as a list, and the times at
which something begins to sound, so that another hand can recount what the files say they lost.

Sources: DA7280 data sheet revision 3.0, pages 42 to 46 (waveform memory); ISO/IEC 23090-31 as its reference software evaluates it;
Android's reference of VibrationEffect; OpenXR 1.1 with XR_EXT_haptic_parametric; the .haptic and AHAP conventions in
docs/reference/export-formats.md, since no maker publishes what an actuator makes of them.
"""
import json
import math
import re
import shutil
import struct
import subprocess

import numpy

RATE = 48000
MOTOR_HZ = 205.0  # the files' words: "the motor plays at its own resonance, for the loss taken as 205 Hz"
BANDS = (("20_80_Hz", 20, 80), ("80_230_Hz", 80, 230), ("230_500_Hz", 230, 500))


class Half:
    """Samples from the half's time 0 on, the times (s) at which something gets stronger, and those at which the file says anything."""

    def __init__(self, samples, onsets, points=()):
        self.samples = numpy.asarray(samples, float)
        self.onsets = sorted(onsets)
        self.points = sorted(set(points) | set(onsets))


def band_energies(samples):
    """Energy per band of a signal that is silent before and after; a bin on an edge counts for its share within."""
    size = 1 << max(17, (len(samples) - 1).bit_length())
    power = numpy.abs(numpy.fft.rfft(samples, size)) ** 2 * 2 / size
    frequency = numpy.fft.rfftfreq(size, 1 / RATE)
    half = frequency[1] / 2
    return {name: (power * numpy.clip((numpy.minimum(high, frequency + half) - numpy.maximum(low, frequency - half)) / (2 * half),
                                      0, 1)).sum() for name, low, high in BANDS}


def oscillator(times, levels, frequency_times, frequencies, end=None):
    """A sine of straight levels and frequencies between points; a level or frequency that jumps has two points at one time."""
    count = int(round((times[-1] if end is None else end) * RATE)) + 1
    t = numpy.arange(count) / RATE
    level = numpy.interp(t, times, levels, left=0, right=0)
    at, hertz = numpy.array(frequency_times, float), numpy.array(frequencies, float)
    turned = numpy.concatenate(([0], numpy.cumsum((hertz[1:] + hertz[:-1]) / 2 * numpy.diff(at))))  # cycles at each point
    here = numpy.clip(numpy.searchsorted(at, t, side="right") - 1, 0, len(at) - 1)
    after = numpy.minimum(here + 1, len(at) - 1)
    long = at[after] - at[here]
    slope = numpy.where(long > 0, (hertz[after] - hertz[here]) / numpy.where(long > 0, long, 1), 0)
    since = t - at[here]
    return level * numpy.sin(2 * math.pi * (turned[here] + hertz[here] * since + slope * since * since / 2))


def rises(times, levels, least=1.05):
    """Where a level begins to grow, or is higher from one moment to the next."""
    found = []
    for i in range(1, len(times)):
        falling_before = i < 2 or levels[i - 1] <= levels[i - 2]
        if levels[i] > least * levels[i - 1] + 1e-4 and falling_before:
            found.append(times[i - 1])
    return found


# ---- exact formats


def read_pcm(path):
    text = open(path).read()
    rate = float(re.search(r"sample_rate_Hz = (\d+)u", text).group(1))
    bits, body = re.search(r"int(\d+)_t \w+samples\[\d+\] = \{(.*?)\};", text, re.S).groups()
    values = numpy.array([int(v) for v in re.findall(r"-?\d+", body)], float)
    if len(values) != int(re.search(r"samples\[(\d+)\]", text).group(1)):
        raise ValueError("the array is not as long as it says")
    return rate, values / (2 ** (int(bits) - 1) - 1)


def read_hjif(path):
    """As Effect::EvaluateVectorial, Band::EvaluationBand and Channel::EvaluateChannel do it, limits after every band among them."""
    data = json.load(open(path))
    scale = data["timescale"]
    end = 0
    for perception in data["perceptions"]:
        for channel in perception["channels"]:
            for band in channel["bands"]:
                for effect in band["effects"]:
                    end = max(end, effect["position"] + effect["keyframes"][-1]["relative_position"])
    whole = numpy.zeros(int(math.ceil(RATE * end / scale)) + 1)
    onsets = []
    for perception in data["perceptions"]:
        for channel in perception["channels"]:
            sound = numpy.zeros_like(whole)
            for band in channel["bands"]:
                if band["band_type"] != "VectorialWave":
                    raise ValueError("a band that is not evaluated here: " + band["band_type"])
                for effect in band["effects"]:
                    keys = effect["keyframes"]
                    hertz = {k["frequency_modulation"] for k in keys if "frequency_modulation" in k}
                    if len(hertz) != 1 or effect["base_signal"] != "Sine":
                        raise ValueError("one frequency per effect is expected")
                    f = hertz.pop()
                    if not band["lower_frequency_limit"] <= f <= band["upper_frequency_limit"]:
                        raise ValueError("a frequency outside its band")
                    places = [k["relative_position"] for k in keys]
                    first = math.ceil(effect["position"] * RATE / scale)
                    last = math.floor((effect["position"] + places[-1]) * RATE / scale)
                    ticks = numpy.arange(first, last + 1) * scale / RATE - effect["position"]
                    level = numpy.interp(ticks, places, [k["amplitude_modulation"] for k in keys])
                    sound[first:last + 1] += level * numpy.sin(2 * math.pi * f * ticks / scale + effect.get("phase", 0))
                    onsets.append(effect["position"] / scale)
                sound = numpy.clip(sound, -1, 1)
            whole += channel["gain"] * sound * 10 ** perception.get("perception_unit_exponent", 0)
    return [Half(whole, onsets)]


def burst(wave, seconds_at):
    """One wave of a package: a sine whose level rises over rise_ms and falls over fall_ms."""
    t = seconds_at
    long, rise, fall = wave["duration_ms"] / 1e3, wave["rise_ms"] / 1e3, wave["fall_ms"] / 1e3
    level = numpy.full_like(t, wave["amplitude"])
    if rise > 0:
        level *= numpy.clip(t / rise, 0, 1)
    if fall > 0:
        level *= numpy.clip((long - t) / fall, 0, 1)
    level[(t < 0) | (t >= long)] = 0
    return level * numpy.sin(2 * math.pi * wave["frequency_Hz"] * t)


def filtered(samples, c):
    out, x1, x2, y1, y2 = numpy.zeros_like(samples), 0.0, 0.0, 0.0, 0.0
    for i, x in enumerate(samples):
        y = c["b0"] * x + c["b1"] * x1 + c["b2"] * x2 - c["a1"] * y1 - c["a2"] * y2
        x2, x1, y2, y1 = x1, x, y1, y
        out[i] = y
    return out


def quiet_slope(chain, events, count):
    """Level of the slope: towards slope_under_jump while a burst sounds that quietens it, by a whole level in turn_ms, and back."""
    under, step = chain["slope_under_jump"]["level"], 1e3 / (chain["slope_under_jump"]["turn_ms"] * chain["sample_rate_Hz"])
    sounding = numpy.zeros(count, bool)
    for event in events:
        if event["quietens_slope"]:
            sounding[event["sample"]:event["sample"] + int(math.ceil(event["wave"]["duration_ms"] / 1e3 * chain["sample_rate_Hz"]))] = True
    level, now = numpy.ones(count), 1.0
    for i in range(count):
        now = max(under, now - step) if sounding[i] else min(1.0, now + step)
        level[i] = now
    return level


def read_package(path):
    """Grains (a new one takes the place of the last, the carrier runs on), their filters, then everything else."""
    data = json.load(open(path))
    chain, press = data["chain"], data["example_press"]
    count = press["samples"]
    slope, rest, onsets = numpy.zeros(count), numpy.zeros(count), []
    grains = [e for e in press["events"] if e["kind"] == "grain"]
    phase, until = 0.0, None
    for i, event in enumerate(grains):
        first, wave = event["sample"], event["wave"]
        long = int(math.ceil(wave["duration_ms"] / 1e3 * chain["sample_rate_Hz"] - 1e-6))
        last = min(first + long, count, grains[i + 1]["sample"] if i + 1 < len(grains) else count)
        if until is None or first > until or chain["grain_carrier"] != "running":
            phase = 0.0
        t = numpy.arange(last - first) / chain["sample_rate_Hz"]
        level = wave["amplitude"] * (1 - t / (wave["duration_ms"] / 1e3))
        slope[first:last] = level * numpy.sin(phase + 2 * math.pi * wave["frequency_Hz"] * t)
        phase += 2 * math.pi * wave["frequency_Hz"] * (last - first) / chain["sample_rate_Hz"]
        until = last
    for name in ("grain_low_pass", "grain_high_pass"):
        part = chain.get(name)
        if part and part.get("acts_on", "grains") == "grains" and "coefficients" in part:
            slope = filtered(slope, part["coefficients"])
    seconds = numpy.arange(count) / chain["sample_rate_Hz"]
    slope *= quiet_slope(chain, press["events"], count)
    for event in press["events"]:
        if event["kind"] == "grain" or "wave" not in event:
            continue
        first = event["sample"]
        last = min(count, first + int(math.ceil(event["wave"]["duration_ms"] / 1e3 * RATE)) + 1)
        rest[first:last] += burst(event["wave"], seconds[first:last] - first / chain["sample_rate_Hz"])
        onsets.append(event["time_s"])
    sound = slope + rest
    if chain["grain_low_pass"]["acts_on"] == "all":
        sound = filtered(sound, chain["grain_low_pass"]["coefficients"])
    for band in chain["equalizer"]:
        sound = filtered(sound, band["coefficients"])
    sound = chain["gain"] * sound
    course = press["limiter_gain"]["points"]
    if course:
        sound = sound * numpy.interp(numpy.arange(count), [p[0] for p in course], [p[1] for p in course])
    return [Half(sound, onsets)]


# ---- time lines


def read_ahap(path):
    """Level is intensity squared, frequency 80 Hz + 150 Hz x sharpness, a transient falls over 22 ms."""
    data = json.load(open(path))
    if data["Version"] != 1.0:
        raise ValueError("version")
    events = []
    for entry in data["Pattern"]:
        event = entry["Event"]
        value = {p["ParameterID"]: p["ParameterValue"] for p in event["EventParameters"]}
        transient = event["EventType"] == "HapticTransient"
        events.append((event["Time"], 0.022 if transient else event["EventDuration"], transient,
                       value.get("HapticIntensity", 1.0) ** 2, 80 + 150 * value.get("HapticSharpness", 0.5)))
    count = int(math.ceil(RATE * max(e[0] + e[1] for e in events))) + 1
    sound = numpy.zeros(count)
    t = numpy.arange(count) / RATE
    # Each event begins a sine of its own; Core Haptics says nothing of phase.
    ended, onsets, level_before = None, [], 0.0
    for begin, long, transient, level, hertz in sorted(events):
        inside = (t >= begin) & (t < begin + long)
        if transient:
            sound[inside] += level * (1 - (t[inside] - begin) / long) * numpy.sin(2 * math.pi * hertz * (t[inside] - begin))
            onsets.append(begin)
            continue
        sound[inside] += level * numpy.sin(2 * math.pi * hertz * (t[inside] - begin))
        if ended is None or abs(begin - ended) > 1e-4 or level > 1.05 * level_before:
            onsets.append(begin)
        ended, level_before = begin + long, level
    return Half(sound, onsets, [e[0] for e in events])


def read_haptic(path):
    data = json.load(open(path))
    if data["version"]["major"] != 1:
        raise ValueError("version")
    envelopes = data["signals"]["continuous"]["envelopes"]
    times = [p["time"] for p in envelopes["amplitude"]]
    levels = [p["amplitude"] for p in envelopes["amplitude"]]
    pitch = envelopes.get("frequency") or [{"time": 0, "frequency": 0.0}]
    sound = oscillator(times, levels, [p["time"] for p in pitch], [80 + 150 * math.sqrt(p["frequency"]) for p in pitch])
    emphasis = [p["time"] for p in envelopes["amplitude"] if "emphasis" in p]
    return [Half(sound, rises(times, levels) + emphasis, times)]


def read_openxr(path):
    data = json.load(open(path))
    low, high = data["minFrequencyHz"], data["maxFrequencyHz"]
    times = [p["time"] / 1e9 for p in data["amplitudePoints"]]
    levels = [p["value"] for p in data["amplitudePoints"]]
    frequency_times = [p["time"] / 1e9 for p in data["frequencyPoints"]]
    hertz = [low + (high - low) * p["value"] for p in data["frequencyPoints"]]
    return [Half(oscillator(times, levels, frequency_times, hertz), rises(times, levels), times)]


def held(levels_and_seconds, hertz=MOTOR_HZ):
    """A motor that holds each level for its time."""
    edges = numpy.concatenate(([0], numpy.cumsum([s for _, s in levels_and_seconds])))
    count = int(round(edges[-1] * RATE))
    t = numpy.arange(count) / RATE
    level = numpy.array([l for l, _ in levels_and_seconds])[
        numpy.clip(numpy.searchsorted(edges, t + 1e-9, side="right") - 1, 0, len(levels_and_seconds) - 1)]
    onsets, before = [], 0.0
    for (now, _), at in zip(levels_and_seconds, edges):
        if now != before:  # each step is written anew
            onsets.append(at)
        before = now
    return Half(level * numpy.sin(2 * math.pi * hertz * t), onsets, edges[:-1])


def read_android(path):
    """press() and release() as a phone plays them: an envelope where there is one, else held amplitudes of a motor's own frequency."""
    text = re.sub(r"//[^\n]*|/\*.*?\*/", "", open(path).read(), flags=re.S)
    halves = []
    for name in ("press", "release"):
        found = re.search(r"fun %s\(.*?(?=\n    fun |\n\}\s*$)" % name, text, re.S)
        if not found:
            raise ValueError("no " + name)
        body = found.group(0)
        points = [(float(a.rstrip("f")), float(f.rstrip("f")), int(ms)) for a, f, ms in
                  re.findall(r"addControlPoint\(([-\d.e]+f?), ([-\d.e]+f?), (\d+)L?\)", body)]
        waveform = re.search(r"createWaveform\(\s*longArrayOf\(([^)]*)\),\s*intArrayOf\(([^)]*)\), -1\)", body)
        steps = None
        if waveform:
            ms = [int(v) for v in waveform.group(1).split(",")]
            level = [int(v) for v in waveform.group(2).split(",")]
            if len(ms) != len(level):
                raise ValueError("as many times as amplitudes are needed")
            steps = held([(l / 255, m / 1000) for l, m in zip(level, ms)])
        envelope = None
        if points:
            first_Hz = float(re.search(r"setInitialFrequencyHz\(([-\d.]+)f?\)", body).group(1))
            times = [0] + list(numpy.cumsum([p[2] for p in points]) / 1000)
            levels = [0] + [p[0] for p in points]
            envelope = Half(oscillator(times, levels, times, [first_Hz] + [p[1] for p in points]), rises(times, levels), times)
        halves.append({"envelope": envelope, "steps": steps, "points": points})
    return halves


# ---- chips


def numbers_of(text, name):
    body = re.search(r"%s\[\d*\] = \{(.*?)\n\};|%s\[\d*\] = \{(.*?)\};" % (name, name), text, re.S)
    return body.group(1) or body.group(2) or ""


def read_bos1921(path):
    """Slices {amplitude of 4095, frequency in 3.9 Hz, whole cycles}, one after the other; each begins and ends at 0."""
    text = open(path).read()
    slices = [tuple(int(v) for v in s.split(",")) for s in re.findall(r"\{(\d+, ?\d+, ?\d+)\}", numbers_of(text, r"detent_slices"))]
    sound, onsets, at, before = [], [], 0.0, 0.0
    spans = []
    for amplitude, frequency, cycles in slices:
        long = cycles / (3.9 * frequency)
        spans.append((at, at + long, amplitude / 4095, 3.9 * frequency))
        if amplitude / 4095 > 1.05 * before + 1e-3:
            onsets.append(at)
        before = amplitude / 4095
        at += long
    t = numpy.arange(int(math.ceil(at * RATE))) / RATE
    sound = numpy.zeros_like(t)
    for begin, end, level, hertz in spans:
        inside = (t >= begin) & (t < end)
        sound[inside] = level * numpy.sin(2 * math.pi * hertz * (t[inside] - begin))
    return [Half(sound, onsets, [begin for begin, _, level, _ in spans if level > 0])]


def read_da728x(path):
    """The waveform memory of the data sheet, played with ACCELERATION_EN = 1 and FREQ_WAVEFORM_TIMEBASE = 1."""
    text = open(path).read()
    memory = [int(v, 16) for v in re.findall(r"0x([0-9A-Fa-f]{2})", numbers_of(text, r"detent_da728x_memory"))]
    if len(memory) != 100:
        raise ValueError("the memory has 100 bytes")
    snippets, sequences = memory[0], memory[1]
    ends = memory[2:2 + snippets + sequences]
    if snippets > 15 or sequences > 16 or any(b <= a for a, b in zip(ends, ends[1:])) or ends[-1] > 99:
        raise ValueError("the end pointers are wrong")
    begins = [2 + snippets + sequences] + [e + 1 for e in ends[:-1]]
    parts = [memory[b:e + 1] for b, e in zip(begins, ends)]
    timebase_s = (0.00136, 0.00544, 0.02176, 0.04352)
    halves = []
    for frames in parts[snippets:]:
        points, last, at, index = [(0.0, 0.0)], 0.0, 0.0, 0
        while index < len(frames):
            if frames[index] & 0x80:
                raise ValueError("a frame begins with its first byte")
            gain = 10 ** (-6 * (frames[index] >> 5 & 3) / 20)
            base = timebase_s[frames[index] >> 3 & 3]
            snippet, loops = frames[index] & 7, 1
            index += 1
            if index < len(frames) and frames[index] & 0x80:
                loops = (frames[index] >> 3 & 15) + 1
                if frames[index] & 4:
                    raise ValueError("a frequency is not for a motor that is tracked")
                snippet |= (frames[index] & 1) << 3
                index += 1
            body = parts[snippet - 1] if snippet else [0x10]
            for _ in range(loops):
                for byte in body:
                    long, level = ((byte >> 4 & 7) + 1) * base, gain * (byte & 15) / 15
                    if not byte & 0x80:
                        points.append((at, level))
                    at += long
                    points.append((at, level))
                    last = level
        times, levels = [p[0] for p in points], [p[1] for p in points]
        sound = oscillator(times, levels, [0], [MOTOR_HZ])
        onsets = [a for (a, l), (b, m) in zip(points, points[1:]) if m > 1.05 * l]
        halves.append(Half(sound, onsets, times))
    return halves


def read_drv2605(path):
    text = open(path).read()
    halves = []
    for name in ("detent_press", "detent_release"):
        steps = [tuple(int(v) for v in s.split(",")) for s in re.findall(r"\{(\d+, ?\d+)\}", numbers_of(text, name))]
        if len(steps) != int(re.search(name + r"_count = (\d+)u", text).group(1)):
            raise ValueError("the count is not the list's")
        halves.append(held([(a / 127, ms / 1000) for a, ms in steps]))
    return halves


C_DUMP = r"""
#include <stdio.h>
#include HEADER
static void wave(detent_wave w) {
  printf("[%.9g,%.9g,%.9g,%.9g,%.9g]", w.frequency_Hz, w.duration_ms, w.amplitude, w.rise_ms, w.fall_ms);
}
static void slopes(const char* name, const detent_slope* s, unsigned count) {
  printf("\"%s\":[", name);
  for (unsigned i = 0; i < count; ++i) printf("%s[%.9g,%.9g,%.9g]", i ? "," : "", s[i].from_mm, s[i].to_mm, s[i].level);
  printf("],");
}
static void curve(const char* name, const float* mm, const float* N, unsigned count) {
  printf("\"%s\":[", name);
  for (unsigned i = 0; i < count; ++i) printf("%s[%.9g,%.9g]", i ? "," : "", mm[i], N[i]);
  printf("],");
}
int main(void) {
  printf("{\"grains_per_mm\":%.9g,\"loudest_per_s\":%.9g,\"under_jump\":%.9g,\"power\":%.9g,\"grain\":",
         detent_grains_per_mm, detent_loudest_grains_per_s, detent_slope_under_jump, detent_grain_level_power);
  wave(detent_grain);
  printf(",\"states\":[");
  for (unsigned i = 0; i < detent_state_count; ++i) {
    const detent_state* s = &detent_states[i];
    printf("%s{\"thresholds\":[%.9g,%.9g,%.9g,%.9g],", i ? "," : "", s->press_threshold_N, s->release_threshold_N, s->operating_N,
           s->reset_N);
    slopes("press_slopes", s->press_slopes, s->press_slope_count);
    slopes("release_slopes", s->release_slopes, s->release_slope_count);
    curve("press", s->press_mm, s->press_N, s->press_points);
    curve("release", s->release_mm, s->release_N, s->release_points);
    printf("\"triggers\":[");
    for (unsigned t = 0; t < s->trigger_count; ++t) {
      const detent_trigger* g = &s->triggers[t];
      printf("%s{\"release\":%d,\"kind\":%d,\"at_N\":%.9g,\"at_mm\":%.9g,\"wave\":", t ? "," : "", g->release, g->kind, g->force_N,
             g->displacement_mm);
      wave(g->wave);
      printf("}");
    }
    printf("]}");
  }
  printf("]}\n");
  return 0;
}
"""


def read_c_header(path):
    """The header as a compiler takes it, number by number. None without a compiler."""
    compiler = shutil.which("gcc") or shutil.which("cc")
    if not compiler:
        return None
    program = str(path) + ".dump"
    subprocess.run([compiler, "-std=c99", "-Wall", "-Werror", "-Wno-unused-variable", f'-DHEADER="{path}"', "-x", "c", "-", "-o", program],
                   input=C_DUMP, text=True, check=True)
    return json.loads(subprocess.run([program], capture_output=True, text=True, check=True).stdout)


def play_c_header(data, events, count):
    """What a board makes of a header (momentary buttons) when its finger meets `events`: the sample, kind and place of each. As the
    header's words have it: a new grain takes the place of the last, its carrier goes on while they touch."""
    state, (hertz, long_ms, loud, _, _) = data["states"][0], data["grain"]
    slope, rest, quiet_until, last, before_mm = numpy.zeros(count), numpy.zeros(count), 0, None, 0.0
    long, until, phase = long_ms * RATE / 1e3, 0, 0.0
    for i, (at, kind, place_mm) in enumerate(events):
        after_mm = events[i + 1][2] if i + 1 < len(events) else place_mm
        releasing = after_mm < place_mm if after_mm != place_mm else place_mm < before_mm
        before_mm = place_mm
        if kind == "grain":
            pieces = state["release_slopes" if releasing else "press_slopes"]
            level = [l for low, high, l in pieces if low - 1e-5 <= place_mm <= high + 1e-5]
            if not level:
                raise ValueError(f"no slope has grains at {place_mm} mm")
            amplitude = loud * level[0] * (data["under_jump"] if at < quiet_until else 1)
            if data["loudest_per_s"] > 0:
                often = 0 if last is None else RATE / max(at - last, 0.5)
                often = min(max(often, 1000 / long_ms), data["loudest_per_s"])
                amplitude *= (often / data["loudest_per_s"]) ** data["power"]
            phase = phase + 2 * math.pi * hertz * (at - last) / RATE if last is not None and at <= until else 0.0
            last, until = at, at + int(math.ceil(long))
            t = numpy.arange(min(int(math.ceil(long)), count - at))
            slope[at:] = 0
            slope[at:at + len(t)] = amplitude * (1 - t / long) * numpy.sin(phase + 2 * math.pi * hertz * t / RATE)
            continue
        here = [g for g in state["triggers"] if abs(g["at_mm"] - place_mm) < 1e-4 and
                (g["kind"], g["release"]) == ((1, 0) if kind == "bottom_out" else (0, int(kind == "release_jump")))]
        if len(here) != 1:
            raise ValueError(f"{len(here)} triggers are a {kind} at {place_mm} mm")
        w = dict(zip(("frequency_Hz", "duration_ms", "amplitude", "rise_ms", "fall_ms"), here[0]["wave"]))
        if kind != "bottom_out":
            quiet_until = at + round(w["duration_ms"] * RATE / 1e3)
        rest[at:] += burst(w, numpy.arange(count - at) / RATE)
    return slope + rest


def read_touchpad(path):
    """Threshold in g within what pads offer, release ratio and intensities; nothing that could be played."""
    with open(path, encoding="utf-8") as file:
        data = json.load(file)
    if not 110 <= data["press_threshold_g"] <= 190 or not 0 < data["release_ratio"] <= 1:
        raise ValueError("a threshold that no pad has")
    if any(data["intensity"][k] not in range(5) for k in ("press", "release")):
        raise ValueError("an intensity that no pad has")
    if abs(data["press_threshold_N"] - data["press_threshold_g"] * 9.80665e-3) > 1e-9:
        raise ValueError("g and N differ")
    return data


def read_wave(path):
    """A WAV of 32 bit floats, one channel."""
    raw = open(path, "rb").read()
    at, rate = 12, 0
    while at + 8 <= len(raw):
        name, size = raw[at:at + 4], struct.unpack("<I", raw[at + 4:at + 8])[0]
        if name == b"fmt ":
            kind, channels, rate, _, _, bits = struct.unpack("<HHIIHH", raw[at + 8:at + 24])
            if channels != 1 or bits != 32:
                raise ValueError("one channel of 32 bit floats is expected")
        if name == b"data":
            return rate, numpy.frombuffer(raw[at + 8:at + 8 + size], "<f4").astype(float)
        at += 8 + size + (size & 1)
    raise ValueError("no samples")


def read_any_wave(path):
    """A WAV of whole numbers (16 bit) or floats, its first channel."""
    raw = open(path, "rb").read()
    at, kind, bits, channels = 12, 0, 0, 1
    while at + 8 <= len(raw):
        name, size = raw[at:at + 4], struct.unpack("<I", raw[at + 4:at + 8])[0]
        if name == b"fmt ":
            kind, channels, _, _, _, bits = struct.unpack("<HHIIHH", raw[at + 8:at + 24])
        if name == b"data":
            form, full = ("<f4", 1) if kind == 3 else ("<i2", 32767)
            if kind not in (1, 3) or bits not in (16, 32):
                raise ValueError("another kind of WAV")
            return numpy.frombuffer(raw[at + 8:at + 8 + size], form).astype(float)[::channels] / full
        at += 8 + size + (size & 1)
    raise ValueError("no samples")
