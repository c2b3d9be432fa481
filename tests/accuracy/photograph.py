#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns drawn plots into photographs of a sheet, and into small pictures, as people take and save them.

    photograph.py photo|low PICTURE RESULT SEED        one picture, for looking at it

`photographed`: the sheet lies sagging on a table, under light from one side, seen by a hand-held camera; `lowered`: the plot scaled down
to a given width, as previews and old pages show it. ImageMagick does both; the same seed gives the same picture on one machine.
"""

import math
import random
import subprocess
import sys
from pathlib import Path

SHEET_MM = 180        # width of the sheet in front of the camera
PHOTO_PX = (1600, 1200)
FARTHEST_TILT_DEG = 25
DEEPEST_SAG_MM = 2


def convert(*words):
    run = subprocess.run(["convert", *map(str, words)], text=True, capture_output=True)
    if run.returncode != 0:
        sys.exit(f"photograph.py: ImageMagick failed: {run.stderr.strip()}")


def size_of(picture):
    run = subprocess.run(["identify", "-format", "%w %h", f"{picture}[0]"], text=True, capture_output=True, check=True)
    return tuple(int(word) for word in run.stdout.split())


class Camera:
    """Where a point of the sheet (mm from its middle) stands in the photograph."""

    def __init__(self, chance, aspect):
        tilt = math.radians(chance.uniform(0.2, 1) * FARTHEST_TILT_DEG)
        about = chance.uniform(0, 2 * math.pi)
        self.axis = (math.cos(about), math.sin(about))
        self.tilt, self.turn = tilt, math.radians(chance.uniform(-4, 4))
        self.away_mm = chance.uniform(1.6, 2.4) * SHEET_MM
        self.sag_mm = chance.uniform(0, DEEPEST_SAG_MM)
        self.sag_about = chance.uniform(0, math.pi)
        fill = 0.80 * min(PHOTO_PX[0] / SHEET_MM, PHOTO_PX[1] / (SHEET_MM * aspect))
        self.focal_px = fill * self.away_mm

    def __call__(self, x, y):
        across = (x * math.cos(self.sag_about) + y * math.sin(self.sag_about)) / (0.5 * SHEET_MM)
        z = self.sag_mm * (1 - across * across)
        x, y = x * math.cos(self.turn) - y * math.sin(self.turn), x * math.sin(self.turn) + y * math.cos(self.turn)
        ax, ay = self.axis  # Rodrigues about an axis in the sheet
        c, s, along = math.cos(self.tilt), math.sin(self.tilt), ax * x + ay * y
        rx = x * c + ay * z * s + ax * along * (1 - c)
        ry = y * c - ax * z * s + ay * along * (1 - c)
        rz = z * c + (ax * y - ay * x) * s
        depth = self.away_mm - rz
        return PHOTO_PX[0] / 2 + self.focal_px * rx / depth, PHOTO_PX[1] / 2 + self.focal_px * ry / depth


def photographed(picture, result, seed):
    """A JPEG photograph of the picture printed on a sheet."""
    chance = random.Random(f"photograph {seed}")
    width, height = size_of(picture)
    camera = Camera(chance, height / width)
    raw = Path(result).with_suffix(".raw.png")
    # A polynomial of fourth degree comes near enough to perspective and sag together: it is smooth, as paper is.
    places = [(i / 6, j / 6) for i in range(7) for j in range(7)]
    mm = lambda u, v: ((u - 0.5) * SHEET_MM, (v - 0.5) * SHEET_MM * height / width)
    control = " ".join(f"{u * width:.3f},{v * height:.3f} {x:.3f},{y:.3f}" for u, v in places for x, y in [camera(*mm(u, v))])
    light, far = chance.uniform(0.55, 0.8), chance.uniform(0, 360)
    convert(picture, "-background", "white", "-flatten", "-bordercolor", "white", "-virtual-pixel", "transparent", "-alpha", "set",
            "-define", f"distort:viewport={PHOTO_PX[0]}x{PHOTO_PX[1]}+0+0", "-filter", "Lanczos",
            "-distort", "Polynomial", f"4 {control}", "+repage", raw)
    table = ["-size", "x".join(map(str, PHOTO_PX)), "-seed", str(chance.randrange(1, 10**6)), "plasma:grey40-grey20",
             "-colorspace", "gray", "-colorspace", "sRGB", "-type", "TrueColor", "+level-colors", "rgb(52,36,24),rgb(120,84,56)"]
    shade = ["-define", f"gradient:angle={far:.0f}", f"gradient:gray({int(255 * light)})-gray(255)"]
    lamp = ["-size", "x".join(map(str, PHOTO_PX)), f"xc:rgb(255,{chance.randrange(238, 253)},{chance.randrange(215, 245)})"]
    convert("(", *table, ")", raw, "-composite", "(", *lamp, "(", "-size", "x".join(map(str, PHOTO_PX)), *shade, ")", "-compose", "multiply",
            "-composite", ")", "-compose", "multiply", "-composite", "-blur", f"0x{chance.uniform(0.5, 0.9):.2f}", "-attenuate", f"{chance.uniform(0.08, 0.2):.2f}", "+noise", "Gaussian",
            "-quality", str(chance.randrange(80, 93)), result)
    raw.unlink()


def lowered(picture, result, width_px):
    """The picture scaled to that width."""
    convert(picture, "-background", "white", "-flatten", "-resize", f"{width_px}x", result)


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    if sys.argv[1] == "photo":
        photographed(sys.argv[2], sys.argv[3], sys.argv[4])
    else:
        lowered(sys.argv[2], sys.argv[3], sys.argv[4])
