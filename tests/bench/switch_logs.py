# SPDX-License-Identifier: GPL-3.0-or-later
"""Switches of known curves, and their records as laboratories publish them.

Written from the files of the laboratories themselves, not from the reader: the SHIMPO meter's CSV of ThereminGoat/force-curves, once with a row a sample and a
header ("Raw Data CSV"), once at 2 kHz with a preamble and no header ("HighResolutionRaw"); jsejcksn/force-curves-tidy; the Open-Switch curve meter's sheets in both
layouts; the dome runs of BuddyOG/topre-force-curves; the force tester of geekboards. Nothing of these files is in here."""

import json
import random
import zipfile
from pathlib import Path
from xml.sax.saxutils import escape

import numpy as np

GF_N = 0.00980665  # newtons per gram-force


class Switch:
    """A rise from contact, a spring, a bump that falls steeper than it rises, a wall. Forces in gf, travel in mm."""

    def __init__(self, draw):
        self.contact_mm = draw.uniform(0.1, 0.3)
        self.start_gf = draw.uniform(20, 50)
        self.rise_gf_per_mm = draw.uniform(250, 500)
        self.spring_gf_per_mm = draw.uniform(3, 12)
        self.bump_gf = draw.choice([0, draw.uniform(15, 45)])
        self.bump_mm = draw.uniform(0.9, 1.6)
        self.before_mm, self.after_mm = draw.uniform(0.25, 0.5), draw.uniform(0.15, 0.35)
        self.bottom_mm = draw.uniform(3.2, 3.8)
        self.wall_gf_per_mm = draw.uniform(400, 900)
        self.end_mm = self.bottom_mm + draw.uniform(0.1, 0.15)
        self.loss_gf = draw.uniform(4, 12)
        self.operating_mm = draw.uniform(1.7, 2.2)
        self.reset_mm = self.operating_mm - draw.uniform(0.2, 0.5)

    def press_gf(self, x):
        """Of an array of places."""
        at = np.maximum(0, x - self.contact_mm)
        width = np.where(x < self.bump_mm, self.before_mm, self.after_mm)
        spring = self.start_gf + self.spring_gf_per_mm * at + self.bump_gf * np.exp(-((x - self.bump_mm) / width) ** 2)
        return np.minimum(self.rise_gf_per_mm * at, spring) + self.wall_gf_per_mm * np.maximum(0, x - self.bottom_mm)

    def release_gf(self, x):
        """Below the press by the loss, which fades in from contact and out at the end."""
        share = np.minimum(1, np.minimum(np.maximum(0, x - self.contact_mm) / 0.3, np.maximum(0, self.end_mm - x) / 0.08))
        return self.press_gf(x) - self.loss_gf * share


class Meter:
    """Samples there and back: white noise of the force, a resolution of each, the place known to a share of a step."""

    def __init__(self, draw, step_mm=0.005, noise_gf=0.15, force_step_gf=0.1, travel_step_mm=0.005, scale=1.0):
        self.draw, self.step_mm, self.noise_gf, self.scale = draw, step_mm, noise_gf, scale
        self.force_step_gf, self.travel_step_mm = force_step_gf, travel_step_mm

    def _read(self, x, force_gf):
        force_gf = self.scale * force_gf + self.draw.gauss(0, self.noise_gf)
        return (round(x / self.travel_step_mm) * self.travel_step_mm, round(force_gf / self.force_step_gf) * self.force_step_gf)

    def stroke(self, force_gf, from_mm, to_mm):
        count = max(2, round(abs(to_mm - from_mm) / self.step_mm))
        places = from_mm + (to_mm - from_mm) * np.arange(count + 1) / count
        return [self._read(x, f) for x, f in zip(places.tolist(), force_gf(places).tolist())]

    def press(self, switch):
        return self.stroke(switch.press_gf, 0, switch.end_mm)

    def release(self, switch):
        return self.stroke(switch.release_gf, switch.end_mm, 0)


def write_tidy(path, switch, meter, name):
    """force-curves-tidy: force, displacement, judge, name; way down, then up."""
    rows = "".join(f"{f:.1f},{x:.3f},0,{name}\n" for x, f in meter.press(switch) + meter.release(switch))
    Path(path).write_text("force,displacement,judge,name\n" + rows, encoding="utf-8")


def write_raw(path, switch, meter):
    """"Raw Data CSV": five lines about the run, a header, then No., force, unit, displacement, unit, judge, position, time, date."""
    samples = [meter._read(0, 0) for _ in range(40)] + meter.press(switch) + meter.release(switch) + [meter._read(0, 0) for _ in range(20)]
    most = max(range(len(samples)), key=lambda i: samples[i][1])
    head = (f"Maximum,{samples[most][1]:.1f},@,No.{most + 1},,,,,,\nMinimum,-0.3,@,No.3,,,,,,\nAverage,51.91,,,,,,,,\nData Quantity,{len(samples)},,,,,,,,\n"
            "Number of NG,0,,,,,,,,\nNo.,Force,Unit,Displacement,Unit,Judge,Position,Time,Date,\n")
    rows = "".join(f"{i + 1},{f:.1f},gf,{x:.3f},mm,OK,--,10:37:{i // 10 % 60:02} PM,9/20/2025,\n" for i, (x, f) in enumerate(samples))
    Path(path).write_text(head + rows, encoding="utf-8")


def write_high_resolution(path, switch, meter):
    """"HighResolutionRaw": a preamble of 13 lines, then force and displacement at 2 kHz without a header."""
    fine = Meter(meter.draw, step_mm=switch.end_mm / 45000, noise_gf=meter.noise_gf, scale=meter.scale)
    samples = [fine._read(0, 0) for _ in range(4000)] + fine.press(switch) + fine.release(switch)
    most, least = max(samples, key=lambda s: s[1]), min(samples, key=lambda s: s[1])
    head = (f"MAX FORCE = {most[1]:.1f},{most[0]:.3f}\nMIN FORCE = {least[1]:.1f},{least[0]:.3f}\nAVERAGE FORCE = 59.62,\nUNIT = gf,mm\n"
            f"DATA COUNT = {len(samples)},\nRECORDING RATE = 0.0005,\nFILE DATE = 6/21/2022 11:55:45 PM,\nCOMMENT = ,\nMARK POINT ON = ---,---\n"
            "MARK POINT OFF = ---,---\nTHRESHOLD = ---,\n1ST PEAK FORCE = ---,---\n2ND PEAK FORCE = ---,---\n")
    Path(path).write_text(head + "".join(f"{f:.1f},{x:.3f}\n" for x, f in samples), encoding="utf-8")


def write_dome_run(path, switch, meter):
    """DataLog_N.csv: Millis, Steps, Travel (mm), Scale raw, Scale (grams), every 5 um."""
    rows = [(x, f) for x, f in meter.press(switch) + meter.release(switch)]
    text = "".join(f"{948801 + 33 * i},{round(x / 0.000625)},{x:.4f},{15980 + 3000 * f:.2f},{f:.4f}\n" for i, (x, f) in enumerate(rows))
    Path(path).write_text("Millis,Steps,Travel (mm),Scale raw,Scale (grams)\n" + text, encoding="utf-8")


def write_geekboards(path, switch, meter):
    """down_x, down_y, up_x, up_y every 25 um; forces of the way up from the deepest place on, beside the travel of the way down."""
    coarse = Meter(meter.draw, step_mm=0.025, noise_gf=meter.noise_gf, force_step_gf=0.01, travel_step_mm=0.025, scale=meter.scale)
    xs = [0.025 * i for i in range(2, int(switch.end_mm / 0.025) + 1)]
    down = [coarse._read(x, float(switch.press_gf(x)))[1] for x in xs]
    up = [coarse._read(x, float(switch.release_gf(x)))[1] for x in reversed(xs)]
    rounded = [round(x, 3) for x in xs]
    close = next(x for x in rounded if x >= switch.operating_mm)
    opens = next(x for x in reversed(rounded) if x <= switch.reset_mm)
    Path(path).write_text(json.dumps({
        "down_x": rounded, "down_y": [round(f, 2) for f in down], "up_x": rounded, "up_y": [round(f, 2) for f in up],
        "pressPoint": [close, round(float(switch.press_gf(close)), 2)], "releasePoint": [opens, round(float(switch.release_gf(opens)), 2)]}), encoding="utf-8")


def _cell(value):
    if value is None:
        return "<table:table-cell/>"
    if isinstance(value, str):
        return f'<table:table-cell office:value-type="string"><text:p>{escape(value)}</text:p></table:table-cell>'
    return f'<table:table-cell office:value-type="float" office:value="{value:g}"><text:p>{value:g}</text:p></table:table-cell>'


def write_open_switch(path, switch, meter, headings_in_one_line):
    """The Open-Switch curve meter's sheet: what it wrote, and the corrected strokes with the contact's state beside them."""
    down, up = meter.press(switch), meter.release(switch)
    if headings_in_one_line:
        head = [[None, "Raw X (microns)", "Raw Force (gf)", "Actuated?", "Force - Tared (gf)", "Corrected downstroke X (mm)", "Corrected downstroke force (gf)",
                 "Corrected downstroke actuated?", "Corrected upstroke X (mm)", "Corrected upstroke force (gf)", "Corrected upstroke actuated?", "Actuation points"]]
    else:
        head = [["Raw data", None, None, None, None, "Corrected Downstroke", None, "Corrected Upstroke"],
                ["X (microns)", "Force (gf)", "Actuated? ", "Tared", None, "X (mm)", "Force (gf)", "X (mm)", "Force (gf)"]]
    closed = [1 if x >= switch.operating_mm else 0 for x, _ in down] + [1 if x > switch.reset_mm else 0 for x, _ in up]
    rows = []
    for i, (x, f) in enumerate(down + up):
        raw = [1000 * x, f, float(closed[i])]
        strokes = [[s[j][0], s[j][1], float(closed[j + at])] if j < len(s) else [None, None, None] for s, at, j in ((down, 0, i), (up, len(down), i))]
        if headings_in_one_line:
            rows.append([float(i), *raw, f, *strokes[0], *strokes[1]])
        else:
            rows.append([*raw, f, None, *strokes[0][:2], *strokes[1][:2]])
    body = "".join("<table:table-row>" + "".join(map(_cell, row)) + "</table:table-row>" for row in head + rows)
    xml = ('<?xml version="1.0" encoding="UTF-8"?>\n<office:document-content xmlns:office="urn:oasis:names:tc:opendocument:xmlns:office:1.0" '
           'xmlns:table="urn:oasis:names:tc:opendocument:xmlns:table:1.0" xmlns:text="urn:oasis:names:tc:opendocument:xmlns:text:1.0"><office:body>'
           f'<office:spreadsheet><table:table table:name="Sheet1">{body}</table:table></office:spreadsheet></office:body></office:document-content>')
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("mimetype", "application/vnd.oasis.opendocument.spreadsheet", zipfile.ZIP_STORED)
        archive.writestr("content.xml", xml)


def drawn(seed):
    """A switch and the random numbers of its meter."""
    draw = random.Random(seed)
    return Switch(draw), draw
