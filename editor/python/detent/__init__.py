# SPDX-License-Identifier: GPL-3.0-or-later
"""Detent in Python: from a printed force graph to a button, its figures and its sound.

The programs do the work, so the numbers are theirs to the last bit. Displacement in mm, force in N.

    import detent
    button = detent.read("datasheet.pdf", page=3)
    print(button.figures()["peak_force_N"], button.report["confidence"])
    displacement_mm, force_N = button.press.T

What cannot be done raises detent.Failure. Ctrl-C ends a call within half a second. Threads may call side by side.
"""

from __future__ import annotations

import json
import os
import tempfile
import threading
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import Any, Literal, Union

import numpy as np
from numpy.typing import NDArray

from . import _programs
from ._version import version as __version__
from .failure import Failure, NoForceGraph, NotCertain, UnreadableInput, WrongUsage

__all__ = [
    "Button", "Failure", "NoForceGraph", "NotCertain", "UnreadableInput", "WrongUsage",
    "average", "between", "confusion", "find_like", "import_many", "load", "performance", "read", "render", "__version__",
]

_programs.check_version()

AnyPath = Union[str, "os.PathLike[str]"]
Quality = Literal["draft", "standard", "precise"]
Curve = NDArray[np.float64]


class Button:
    """A button: a value that does not change; made by read, load and from_json. Can be compared, pickled and shown in a notebook.

    report: what its import says of itself, the dictionary of `detent-import --json`; empty for a button from a file.
    press: (n, 2), displacement in mm and force in N of the first state, in the order travelled; not to be written to.
    release: the same of the release, from deep to rest; None where it is not known.
    """

    __slots__ = ("report", "press", "release", "_text")

    def __init__(self, text: str, curves: str, report: dict[str, Any] | None = None) -> None:
        self._text = text
        self.report: dict[str, Any] = report or {}
        press = _stroke(curves, "press")
        assert press is not None  # no button is without
        self.press: Curve = press
        self.release: Curve | None = _stroke(curves, "release")

    @property
    def name(self) -> str:
        """The button's name; may be empty."""
        return str(json.loads(self._text).get("name", ""))

    def figures(self, state: int = 0) -> dict[str, float]:
        """Key figures the button has, the unit at the name's end: peak_force_N, pre_travel_mm. IndexError: no such state."""
        with _folder_with(self) as folder:
            shown = _programs.run("detent-graph", "show", _button_in(folder), "--json")
        return dict(shown["states"][state]["figures"])

    def to_json(self) -> str:
        """The text of a button file (*.button.json)."""
        return self._text

    @staticmethod
    def from_json(text: str) -> Button:
        """The button of such a text. UnreadableInput: it is none, or of a newer version."""
        with tempfile.TemporaryDirectory(prefix="detent-") as folder:
            Path(_button_in(folder)).write_text(text, encoding="utf-8")
            return load(_button_in(folder))

    def save(self, path: AnyPath) -> None:
        """Writes a button file, whole or not at all. OSError: it cannot be written."""
        target = Path(path)
        staged = target.with_name(f".{target.name}.{os.getpid()}.{threading.get_ident()}")
        try:
            staged.write_text(self._text, encoding="utf-8")
            os.replace(staged, target)
        finally:
            staged.unlink(missing_ok=True)

    def svg(self) -> str:
        """The graph as a datasheet prints it: an SVG document."""
        with _folder_with(self) as folder:
            out = os.path.join(folder, "graph.svg")
            _programs.run("detent-graph", "convert", _button_in(folder), out, "--json")
            return Path(out).read_text(encoding="utf-8")

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        release = "with release" if self.release is not None else "press only"
        return f"<detent.Button {self.name!r}: {self.press[-1, 0]:.4g} mm, up to {self.press[:, 1].max():.4g} N, {release}>"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Button) and self._text == other._text

    def __hash__(self) -> int:
        return hash(self._text)


def _button_in(folder: str) -> str:
    return os.path.join(folder, "button.button.json")


def _folder_with(button: Button) -> tempfile.TemporaryDirectory[str]:
    folder = tempfile.TemporaryDirectory(prefix="detent-")
    Path(_button_in(folder.name)).write_text(button.to_json(), encoding="utf-8")
    return folder


def _stroke(csv: str, name: str) -> Curve | None:
    rows = [line.split(",")[1:] for line in csv.splitlines()[1:] if line.startswith(name + ",")]
    if not rows:
        return None
    points = np.array([[float(displacement), float(force)] for displacement, force in rows])
    points.flags.writeable = False
    return points


def _joined(numbers: Sequence[float], separator: str = ",") -> str:
    return separator.join(repr(float(number)) for number in numbers)


def read(
    path: AnyPath,
    *,
    page: int | None = None,
    graph: int | None = None,
    curve: str | int | None = None,
    quality: Quality = "standard",
    sure: float | None = None,
    frame: Sequence[float] | None = None,
    x_axis: tuple[float, float] | None = None,
    y_axis: tuple[float, float] | None = None,
    x_unit: str | None = None,
    y_unit: str | None = None,
    press_color: str | None = None,
    release_color: str | None = None,
    press_line: Sequence[float] | None = None,
    release_line: Sequence[float] | None = None,
    mask: Iterable[Sequence[float]] = (),
    dpi: float | None = None,
    swap_strokes: bool = False,
) -> Button:
    """Reads the force graph of a button from a picture, a PDF or SVG page, or a force meter's log.

    Everything is found; what is given by hand settles what it answers and nothing else. Arguments are the options of
    `detent-import`:

    page, graph: from 1; without them the most certain graph.
    curve: of several switches in one plot the one to read, by name or number.
    quality: draft, standard or precise.
    sure: 0..1, the confidence below which NotCertain is raised (0.5).
    frame: two opposite corners (4 numbers) or four (8), in page units: pixels of a picture, points of a document.
    x_axis, y_axis: values at the frame's edges, in the printed unit.
    x_unit, y_unit: "mm", "in", ...; "N", "gf", "cN", ...
    press_color, release_color: "#rrggbb".
    press_line, release_line: x0, y0, x1, y1, ... along the curve, page units.
    mask: boxes (x0, y0, x1, y1) to leave out, page units.
    dpi: at which documents are rendered.
    swap_strokes: press and release the other way round.

    Raises WrongUsage, UnreadableInput, NoForceGraph, NotCertain.
    """
    given: list[tuple[str, object]] = [
        ("page", page), ("graph", graph), ("curve", curve), ("quality", quality), ("sure", sure), ("dpi", dpi),
        ("frame", _joined(frame) if frame is not None else None),
        ("x-axis", _joined(x_axis, ":") if x_axis is not None else None),
        ("y-axis", _joined(y_axis, ":") if y_axis is not None else None),
        ("x-unit", x_unit), ("y-unit", y_unit), ("press-color", press_color), ("release-color", release_color),
        ("press-line", _joined(press_line) if press_line is not None else None),
        ("release-line", _joined(release_line) if release_line is not None else None),
        *(("mask", _joined(box)) for box in mask),
    ]
    options = [f"--{option}={value}" for option, value in given if value is not None]
    if swap_strokes:
        options.append("--swap-strokes")
    with tempfile.TemporaryDirectory(prefix="detent-") as folder:
        text, curves = Path(_button_in(folder)), Path(folder, "curves.csv")
        report = _programs.run("detent-import", "--json", "-o", str(text), "--csv", str(curves), *options, "--", os.fspath(path))
        report["outputs"] = []  # what was written is gone when this returns
        return Button(text.read_text(encoding="utf-8"), curves.read_text(encoding="utf-8"), report)


def load(path: AnyPath) -> Button:
    """A button from its file: *.button.json, or a CSV stroke,displacement_mm,force_N. UnreadableInput names the place that is wrong."""
    source = os.fspath(path)
    with tempfile.TemporaryDirectory(prefix="detent-") as folder:
        curves = os.path.join(folder, "curves.csv")
        _programs.run("detent-graph", "convert", source, curves, "--json")
        if not source.endswith(".json"):
            _programs.run("detent-graph", "convert", source, _button_in(folder), "--json")
            source = _button_in(folder)
        return Button(Path(source).read_text(encoding="utf-8"), Path(curves).read_text(encoding="utf-8"))


def render(button: Button, press: AnyPath | None = None, *, rate_Hz: float = 48000) -> NDArray[np.float32]:
    """A press as vibration, (n,): what `detent-play render` writes, sample for sample, as shares of full scale.

    press: a trace (CSV: time_s,force_N or time_s,displacement_mm); without one a human-like press of 0.3 s.
    rate_Hz: samples per second, 8000 to 192000.
    Failure: a setting out of its range, a trace that cannot be read.
    """
    with _folder_with(button) as folder:
        wave = os.path.join(folder, "press.wav")
        finger = ["--standard-press"] if press is None else ["--press", os.fspath(press)]
        _programs.run("detent-play", "render", _button_in(folder), *finger, "--bits", "float", "--rate", repr(float(rate_Hz)),
                      "-o", wave, "--json")
        return _samples(Path(wave).read_bytes())


def _samples(wave: bytes) -> NDArray[np.float32]:
    """The data of a WAV of 32 bit float samples."""
    at = 12
    while wave[at:at + 4] != b"data":
        at += 8 + int.from_bytes(wave[at + 4:at + 8], "little")
    size = int.from_bytes(wave[at + 4:at + 8], "little")
    return np.frombuffer(wave, dtype="<f4", count=size // 4, offset=at + 8)


def _files_in(folder: str, buttons: Sequence[Button]) -> list[str]:
    """Buttons as files of a folder, in order."""
    paths = [os.path.join(folder, f"{place}.button.json") for place in range(len(buttons))]
    for path, button in zip(paths, buttons):
        Path(path).write_text(button.to_json(), encoding="utf-8")
    return paths


def confusion(*buttons: Button) -> list[dict[str, Any]]:
    """Will people tell these buttons apart? One entry a pair, of `detent-play confusion --json`: d_prime, errors_per_90, ...

    a, b: the buttons' places among the arguments, from 0. WrongUsage: fewer than two buttons.
    """
    with tempfile.TemporaryDirectory(prefix="detent-") as folder:
        pairs: list[dict[str, Any]] = _programs.run("detent-play", "confusion", *_files_in(folder, buttons), "--json")["pairs"]
    order = [(a, b) for a in range(len(buttons)) for b in range(a + 1, len(buttons))]
    return [{**pair, "a": a, "b": b} for pair, (a, b) in zip(pairs, order)]


def performance(*buttons: Button) -> list[dict[str, Any]]:
    """How people will press these buttons: one entry a button, of `detent-play performance --json`: activation_s, misses_per_1000, ...

    Some seconds a button. WrongUsage: no button.
    """
    with tempfile.TemporaryDirectory(prefix="detent-") as folder:
        forecast = _programs.run("detent-play", "performance", *_files_in(folder, buttons), "--json")
    return list(forecast["buttons"])


def find_like(button: Button, database: AnyPath, *, limit: int = 10) -> list[dict[str, Any]]:
    """Measured switches that feel like this button, nearest first: `found` of `detent-import library find --like`.

    database: the library's file, as `detent-import library index` makes it. Each entry has name, credit, licence, source,
    distance_lab_noise (below 1 nobody can say that two differ), group and the key figures.
    UnreadableInput: no library, or one of another version.
    """
    with _folder_with(button) as folder:
        answer = _programs.run("detent-import", "library", "find", f"--db={os.fspath(database)}", f"--like={_button_in(folder)}",
                               f"--limit={limit}", "--json")
    return list(answer["found"])


def average(*units: Button) -> tuple[Button, dict[str, Any]]:
    """Several measured units as one button: the mean, and what `detent-graph average --json` says of the spread.

    `units`: by place among the arguments how far each lies from the median (distance_N), and whether it is an outlier;
    `states`: figures with mean, sd, least, most; press_band and release_band. WrongUsage: fewer than two.
    """
    with tempfile.TemporaryDirectory(prefix="detent-") as folder:
        out = os.path.join(folder, "mean.button.json")
        spread = _programs.run("detent-graph", "average", *_files_in(folder, units), "-o", out, "--json")
        mean = load(out)
    of_units = [{"distance_N": unit["distance_N"], "outlier": unit["outlier"]} for unit in spread["units"]]
    return mean, {"units": of_units, "states": spread["states"]}


def between(first: Button, second: Button, share: float | None = None) -> Button:
    """The button between two others; its report is that of `detent-play between --json`.

    share: 0 (first) to 1 (second); without it the place forecast to differ as much from either. WrongUsage: a share outside.
    """
    with tempfile.TemporaryDirectory(prefix="detent-") as folder:
        out = os.path.join(folder, "middle.button.json")
        at = [] if share is None else [f"--at={float(share)!r}"]
        report = _programs.run("detent-play", "between", *_files_in(folder, (first, second)), *at, "-o", out, "--json")
        button = load(out)
    del report["output"]
    button.report = report
    return button


def import_many(
    paths: Iterable[AnyPath], *, jobs: int | None = None, progress: bool = False, **hints: Any
) -> Iterator[tuple[AnyPath, Button | Failure]]:
    """Reads many files side by side and gives, in their order, each path with its button or the Failure it raised.

    jobs: files at once, >= 1 (default: one per core). progress: a bar, where tqdm is installed. hints: as for read, for all.
    Each file has a process of its own: a crash costs that file only.
    """
    listed = list(paths)
    bar = _bar(len(listed)) if progress else None

    def one(path: AnyPath) -> Button | Failure:
        try:
            return read(path, **hints)
        except Failure as failure:
            return failure

    pool = ThreadPoolExecutor(jobs or os.cpu_count() or 1)
    try:
        running: list[Future[Button | Failure]] = [pool.submit(one, path) for path in listed]
        for path, future in zip(listed, running):
            yield path, future.result()
            if bar is not None:
                bar.update()
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        if bar is not None:
            bar.close()


def _bar(total: int) -> Any:
    try:
        from tqdm.auto import tqdm  # type: ignore[import]
    except ImportError:
        return None
    return tqdm(total=total, unit="file")
