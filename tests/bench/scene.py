#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Only what the scene requires: what programs call, load and compute for what is in front of them.

    scene.py [--bin FOLDER] [--check | --write]

--check: every claim below, by the functions that ran (callgrind): in the first scene none of them, in the second at least one, so that a
function that was renamed or inlined cannot pass for one that was spared; and a picture's import loads not more than 60 shared libraries.
--write: docs/measurements/scene.md. Without either the tables are printed. What runs inside one program is proved there: tests/playback/poisoned.h makes
every number a signalling NaN that belongs to nothing the button has; silent_player_test counts the threads of a player without a sensor.
A program that is not there (built without devices or editor) is said to be skipped. Needs valgrind (install-dependencies.sh test).
"""
import argparse
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import cost

sys.path.insert(0, str(cost.ROOT / "tests/editor/e2e"))
from desktop import geometry_report  # noqa: E402

PAGE = cost.ROOT / "docs/measurements/scene.md"
PLOTS, BUTTONS = cost.SAMPLES / "plots", cost.SAMPLES / "buttons"
MOST_LIBRARIES, MOST_START_MS = 60, 40
PATIENCE_S = 600
IMPORT = ["-o", "out.button.json"]

SCENES = {
    "import: picture": ["detent-import", PLOTS / "black-red-curves.png", *IMPORT],
    "import: PDF with text": ["detent-import", PLOTS / "white-vector.pdf", *IMPORT],
    "import: SVG": ["detent-import", PLOTS / "black-inch-ounce.svg", *IMPORT],
    "import: force meter's log": ["detent-import", PLOTS / "force-meter-log.csv", *IMPORT],
    "import: nothing to read": ["detent-import", "missing.png"],
    "graph: check": ["detent-graph", "check", BUTTONS / "B.button.json"],
    "play: sound of a press": ["detent-play", "render", BUTTONS / "B.button.json", "--standard-press", "-o", "out.wav"],
    "play: sound, linear button": ["detent-play", "render", BUTTONS / "A.button.json", "--standard-press", "-o", "out.wav"],
    "play: force": ["detent-play", "force", BUTTONS / "B.button.json", "--device", "sim", "--seconds", "1", "--fast"],
    "play: force, damped": ["detent-play", "force", BUTTONS / "push.button.json", "--device", "sim", "--seconds", "1", "--fast"],
    "play: forecast of a pair": ["detent-play", "confusion", BUTTONS / "A.button.json", BUTTONS / "B.button.json"],
    "play: nothing to read": ["detent-play", "render", "missing.button.json", "--standard-press", "-o", "out.wav"],
    "edit: start": ["detent-edit"],
    "edit: a button": ["detent-edit", BUTTONS / "B.button.json"],
}
# What is there when an editor can be used; it then ends.
SHOWN = {"edit: start": "welcomePage", "edit: a button": "graphCanvas"}
EXPECTED_EXIT = {"import: nothing to read": 3, "play: nothing to read": 3}


@dataclass(frozen=True)
class Claim:
    what: str
    without: str  # scene
    with_it: str  # scene in which the functions do run
    functions: str


TEXT_ENGINE, PDF_LIBRARY = r"tesseract::TessBaseAPI::", r"(fz|pdf)_\w+"
CLAIMS = [
    Claim("a page with text loads no text engine", "import: PDF with text", "import: picture", TEXT_ENGINE),
    Claim("a picture loads no PDF library", "import: picture", "import: PDF with text", PDF_LIBRARY),
    Claim("a log loads no text engine", "import: force meter's log", "import: picture", TEXT_ENGINE),
    Claim("a log loads no PDF library", "import: force meter's log", "import: PDF with text", PDF_LIBRARY),
    Claim("a log finds no plot", "import: force meter's log", "import: picture", r"detent::importer::findPlotFrames\("),
    Claim("a linear button evaluates no jump", "play: sound, linear button", "play: sound of a press", r"detent::jumpArea_mJ\("),
    Claim("a button without damping evaluates none", "play: force", "play: force, damped", r"detent::dampingAt\("),
    Claim("the editor's start loads no text engine", "edit: start", "import: picture", TEXT_ENGINE),
    Claim("the editor's start loads no PDF library", "edit: start", "import: PDF with text", PDF_LIBRARY),
    Claim("the editor's start computes no waveform", "edit: start", "play: sound of a press", r"detent::playback::HapticEngine::render\("),
]


def environment(folder):
    """A home of its own: neither sessions nor settings of whoever runs this."""
    home = {name: str(folder) for name in ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME")}
    return {**os.environ, **home, "QT_QPA_PLATFORM": "offscreen", "LC_ALL": "C.UTF-8", "OMP_THREAD_LIMIT": "1"}


class Running:
    """One scene's program, until it ends by itself or what it should show is there."""

    def __init__(self, scene, binaries, folder, prefix=(), **extra):
        self.scene, self.folder = scene, Path(folder)
        program, *arguments = SCENES[scene]
        self.process = subprocess.Popen([*prefix, str(binaries / program), *map(str, arguments)], cwd=folder, env={**environment(self.folder), **geometry_report(binaries / program, self.folder / "places.json"), **extra},
                                        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def shown(self):
        places = self.folder / "places.json"
        return places.is_file() and SHOWN[self.scene] in places.read_text(errors="replace")

    def wait(self):
        """Gives what the system counted for it. An editor is ended once it shows what it should."""
        end = time.monotonic() + PATIENCE_S
        while self.scene in SHOWN and not self.shown():
            if self.process.poll() is not None or time.monotonic() > end:
                self.process.kill()
                raise RuntimeError(f"{self.scene}: {SHOWN[self.scene]} was not shown within {PATIENCE_S} s")
            time.sleep(0.05)
        if self.scene in SHOWN:
            self.process.send_signal(signal.SIGTERM)
        _, status, used = os.wait4(self.process.pid, 0)
        self.process.returncode = os.waitstatus_to_exitcode(status)
        if self.scene not in SHOWN and self.process.returncode != EXPECTED_EXIT.get(self.scene, 0):
            raise RuntimeError(f"{self.scene} ended with {self.process.returncode}")
        return used


def counted(scene, binaries, folder, *options):
    """Instructions, and the names of all functions that ran."""
    out = Path(folder) / "callgrind.out"
    Running(scene, binaries, folder, ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", *options]).wait()
    text = out.read_text(errors="replace")
    functions = set(re.findall(r"^c?fn=\(\d+\) (.+)$", text, re.M))
    return int(re.search(r"^totals: (\d+)", text, re.M)[1]), functions


def memory_MB(scene, binaries, folder):
    """Largest resident memory. What the system counts for a child begins with that of its parent, so something small starts it."""
    if scene in SHOWN:
        return Running(scene, binaries, folder).wait().ru_maxrss / 1024
    Running(scene, binaries, folder, ["/usr/bin/time", "-o", str(folder / "peak"), "-f", "%M"]).wait()
    return int((folder / "peak").read_text().split()[-1]) / 1024


def libraries(scene, binaries, folder):
    """Shared libraries that were loaded, also later ones."""
    log = Path(folder) / "loader"
    Running(scene, binaries, folder, LD_DEBUG="files", LD_DEBUG_OUTPUT=str(log)).wait()
    return len({name for file in Path(folder).glob("loader.*") for name in re.findall(r"calling init: (\S+)", file.read_text(errors="replace"))})


def in_folder(measure, *arguments):
    with tempfile.TemporaryDirectory() as folder:
        return measure(*arguments, Path(folder))


def there(scene, binaries):
    return (binaries / SCENES[scene][0]).is_file()


def check(binaries):
    ran = {}

    def functions_of(scene):
        if scene not in ran:
            ran[scene] = in_folder(lambda folder: counted(scene, binaries, folder))[1]
        return ran[scene]

    wrong = []
    for claim in CLAIMS:
        if not (there(claim.without, binaries) and there(claim.with_it, binaries)):
            print(f"SKIPPED {claim.what}: its programs are not in {binaries}")
            continue
        pattern = re.compile(claim.functions)
        met = sorted(name for name in functions_of(claim.without) if pattern.match(name))
        if met:
            wrong.append(f"{claim.what}: not so in '{claim.without}', where {len(met)} ran, such as {met[0]}")
        if not any(pattern.match(name) for name in functions_of(claim.with_it)):
            wrong.append(f"{claim.what}: nothing that matches {claim.functions} ran in '{claim.with_it}' either; what is it called now?")
        print(f"{'WRONG' if met else 'so   '} {claim.what}", flush=True)
    loaded = in_folder(lambda folder: libraries("import: picture", binaries, folder))
    print(f"{loaded} shared libraries for a picture")
    if loaded > MOST_LIBRARIES:
        wrong.append(f"a picture's import loads {loaded} shared libraries; not more than {MOST_LIBRARIES}")
    return wrong


# ---- tables

ENGINES = {"sound": (["render", None, "--standard-press", "-o", "out.wav"], "detent::playback::HapticEngine::render(float*, unsigned long)"),
           "force": (["force", None, "--device", "sim", "--seconds", "2", "--fast"],
                     "detent::playback::ForceEngine::step(detent::playback::ForceReading const&)")}


def engine_cost(binaries, kind, button, folder):
    """Instructions inside the engine alone for each sample of sound, or step of force."""
    arguments, function = ENGINES[kind]
    command = [str(binaries / "detent-play"), *(str(BUTTONS / f"{button}.button.json") if a is None else a for a in arguments)]
    out = folder / "callgrind.out"
    subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", f"--toggle-collect={function}", *command], cwd=folder, check=True,
                   capture_output=True)
    inside = int(re.search(r"^totals: (\d+)", out.read_text(), re.M)[1])
    if kind == "force":
        return inside / 2000  # 2 s of 1 kHz
    return inside / ((folder / "out.wav").stat().st_size / 4)  # 32 bit floats; the header is 20 samples of tens of thousands


def engines(binaries):
    buttons, sounds, forces = ("A", "B", "C", "D", "E", "F", "EF", "push", "latch"), [], []
    for button in buttons:
        sound, force = (in_folder(lambda folder, kind=kind: engine_cost(binaries, kind, button, folder)) for kind in ENGINES)
        sounds.append(f"{sound:.1f}")
        forces.append(f"{force:.0f}")
        print(button, sounds[-1], forces[-1], flush=True)
    return ["| buttons | sound, instructions a sample | force, instructions a step |", "|---|---|---|",
            f"| {', '.join(buttons)} | {', '.join(sounds)} | {', '.join(forces)} |"]


def loaded(binaries):
    lines = ["| program: input | libraries | memory, MB | million instructions | processor, ms |", "|---|---|---|---|---|"]
    for scene in SCENES:
        if not there(scene, binaries):
            print(f"SKIPPED {scene}")
            continue
        used = [in_folder(lambda folder: Running(scene, binaries, folder).wait()) for _ in range(5)]
        milliseconds = min(1000 * (u.ru_utime + u.ru_stime) for u in used)
        instructions, _ = in_folder(lambda folder: counted(scene, binaries, folder))
        count, memory = (in_folder(lambda folder, of=of: of(scene, binaries, folder)) for of in (libraries, memory_MB))
        lines.append(f"| {scene} | {count} | {memory:.0f} | {instructions / 1e6:.0f} | {milliseconds:.0f} |")
        print(lines[-1], flush=True)
    return lines


HEAD = """# Only what the scene requires

Made by `tests/bench/scene.py --write`; `--check` proves the claims again (test `scene`, part of the suite).

## What is not called

By the functions that ran. Each claim has a second scene in which they do run.

"""
BETWEEN = """
Inside the engines, signalling NaNs stand in every number that the button does not have (`tests/playback/poisoned.h`,
[0008](../develop/decisions/0008-nothing-unneeded-runs.md)). A player without a sensor has no thread but its caller's
(`silent_player_test`).

## Instructions inside the engines

A standard press at 48 kHz; two seconds on the simulated 1 µm device at 1 kHz. Counted: the function that
renders or steps, and all it calls.

"""
LOADED = """
## What is loaded

Shared libraries (also those loaded later), largest resident memory, instructions of the whole process, least processor time of five runs. *Nothing to read*: the
requested file does not exist. Bars: a picture 60 libraries, a start 40 ms.

"""


def page(binaries):
    claims = ["| claim | scene | functions | where they run |", "|---|---|---|---|"]
    claims += ["| {} | {} | `{}` | {} |".format(c.what, c.without, c.functions.replace("|", "\\|"), c.with_it) for c in CLAIMS]
    return HEAD + "\n".join(claims) + "\n" + BETWEEN + "\n".join(engines(binaries)) + "\n" + LOADED + "\n".join(loaded(binaries)) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", default=cost.ROOT / "build/release/bin", type=Path)
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--check", action="store_true")
    what.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    binaries = arguments.bin.absolute()
    if arguments.check:
        wrong = check(binaries)
        for line in wrong:
            print(line)
        return 1 if wrong else 0
    text = page(binaries)
    if arguments.write:
        PAGE.write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
