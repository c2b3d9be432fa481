# SPDX-License-Identifier: GPL-3.0-or-later
"""Detent in Python: from a printed force graph to a button, its figures and its sound.

What the programs do, by the same library, so the numbers are theirs to the last bit. Displacement in mm, force in N, time in s.

    import detent
    button = detent.read("datasheet.pdf", page=3)
    print(button.figures()["peak_force_N"], button.report["confidence"])
    displacement_mm, force_N = button.press.T

What cannot be done raises detent.Failure. Ctrl-C ends a call within half a second. Threads may call side by side: nothing that takes
long holds Python's lock.
"""

from __future__ import annotations

import importlib
import inspect
import json
import os
import threading
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any, Literal, Union

import numpy as np
from numpy.typing import NDArray

from . import _core, edits
from ._version import version as __version__
from .edits import Edit
from .failure import Failure, NoForceGraph, NotCertain, UnreadableInput, WrongUsage

__all__ = [
    "Button", "Edit", "Failure", "Graph", "NoForceGraph", "NotCertain", "UnreadableInput", "WrongUsage",
    "average", "between", "compare", "confusion", "edits", "find_like", "import_many", "load", "performance", "read", "render",
    "__version__",
]

if _core.version != __version__:
    raise ImportError(f"detent: the module is of version {__version__}, its library ({_core.__file__}) of {_core.version}. "
                      "Install both from the same release.")

AnyPath = Union[str, "os.PathLike[str]"]
Quality = Literal["draft", "standard", "precise"]
Feel = Literal["clear", "paper"]
Curve = NDArray[np.float64]
Column = NDArray[np.float64]


class Graph:
    """The force graph of one state of a button: a value that does not change. Arrays are views on the library's memory, not to be written to.

    name: "" for the only state, else "unlocked" or "locked".
    press: (n, 2), displacement in mm and force in N, in the order travelled.
    release: the same of the release, from deep to rest; None where it is not known.
    """

    __slots__ = ("_core", "_state", "press", "release")

    def __init__(self, core: _core.Button, state: int) -> None:
        self._core = core
        self._state = state
        press = core.points(state, True)
        assert press is not None  # no state is without
        self.press: Curve = press
        self.release: Curve | None = core.points(state, False)

    @property
    def name(self) -> str:
        """Of the state; "" for the only one."""
        return self._core.state_name(self._state)

    @property
    def press_displacement_mm(self) -> Column:
        """(n,): where the press was sampled, a view on `press`."""
        column: Column = self.press[:, 0]
        return column

    @property
    def press_force_N(self) -> Column:
        """(n,): its force there."""
        column: Column = self.press[:, 1]
        return column

    @property
    def release_displacement_mm(self) -> Column | None:
        """(n,): where the release was sampled; None where it is not known."""
        return None if self.release is None else self.release[:, 0]

    @property
    def release_force_N(self) -> Column | None:
        """(n,): its force there."""
        return None if self.release is None else self.release[:, 1]

    @property
    def operating_point_mm(self) -> float | None:
        """Where the contact closes on the press; None where it is not known."""
        return self._core.operating_point_mm(self._state)

    @property
    def reset_point_mm(self) -> float | None:
        """Where it opens on the release; None where it is not known."""
        return self._core.reset_point_mm(self._state)

    @property
    def damping(self) -> Curve:
        """(n, 2): displacement in mm and damping in N s/mm; no rows where none is modelled."""
        return self._core.damping(self._state)

    def figures(self) -> dict[str, float]:
        """Key figures it has, the unit at the name's end: peak_force_N, pre_travel_mm; a share (snap_ratio) has none."""
        return self._core.figures(self._state)

    def __repr__(self) -> str:
        release = "with release" if self.release is not None else "press only"
        return f"<detent.Graph {self.name!r}: {self.press[-1, 0]:.4g} mm, up to {self.press[:, 1].max():.4g} N, {release}>"


class Button:
    """A button: a value that does not change; made by read, load, from_json and edited. Can be compared, pickled and shown in a notebook.

    report: what its import says of itself, the dictionary of `detent-import --json`; empty for a button from a file.
    """

    __slots__ = ("report", "_core", "_graphs")

    def __init__(self, core: _core.Button, report: dict[str, Any] | None = None) -> None:
        self._core = core
        self._graphs: tuple[Graph, ...] | None = None
        self.report: dict[str, Any] = report or {}

    @property
    def name(self) -> str:
        """The button's name; may be empty."""
        return self._core.name

    @property
    def graphs(self) -> tuple[Graph, ...]:
        """Its states: one, or two of a self-locking button."""
        if self._graphs is None:
            self._graphs = tuple(Graph(self._core, state) for state in range(len(self._core)))
        return self._graphs

    @property
    def press(self) -> Curve:
        """(n, 2): displacement in mm and force in N of the first state, in the order travelled; not to be written to."""
        return self.graphs[0].press

    @property
    def release(self) -> Curve | None:
        """The same of the release, from deep to rest; None where it is not known."""
        return self.graphs[0].release

    def figures(self, state: int = 0) -> dict[str, float]:
        """Key figures the button has, the unit at the name's end: peak_force_N, pre_travel_mm. IndexError: no such state."""
        return self._core.figures(state)

    def edited(self, *changes: Edit) -> Button:
        """The button after these edits, one after the other; without a report. WrongUsage: one cannot be made."""
        core = self._core
        for change in changes:
            core = change.of(core)
        return Button(core)

    def to_json(self) -> str:
        """The text of a button file (*.button.json)."""
        return self._core.to_json()

    @staticmethod
    def from_json(text: str) -> Button:
        """The button of such a text. UnreadableInput: it is none, or of a newer version."""
        return Button(_core.Button.from_json(text, "button.json"))

    def save(self, path: AnyPath) -> None:
        """Writes a button file, whole or not at all. OSError: it cannot be written."""
        target = Path(path)
        staged = target.with_name(f".{target.name}.{os.getpid()}.{threading.get_ident()}")
        try:
            staged.write_text(self.to_json(), encoding="utf-8")
            os.replace(staged, target)
        finally:
            staged.unlink(missing_ok=True)

    def svg(self) -> str:
        """The graph as a datasheet prints it: an SVG document."""
        return self._core.svg()

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        release = "with release" if self.release is not None else "press only"
        return f"<detent.Button {self.name!r}: {self.press[-1, 0]:.4g} mm, up to {self.press[:, 1].max():.4g} N, {release}>"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Button) and self._core == other._core

    def __hash__(self) -> int:
        return hash(self.to_json())

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self.to_json(), self.report)


def _restored(text: str, report: dict[str, Any]) -> Button:
    return Button(Button.from_json(text)._core, report)


def _joined(numbers: Sequence[float], separator: str = ",") -> str:
    return separator.join(repr(float(number)) for number in numbers)


def _cores(buttons: Sequence[Button]) -> list[_core.Button]:
    return [_core_of(button) for button in buttons]


def _core_of(button: Button) -> _core.Button:
    if not isinstance(button, Button):
        raise TypeError(f"a detent.Button is wanted, not {type(button).__name__}; detent.load makes one of a file")
    return button._core


def _options(hints: dict[str, Any]) -> list[bytes]:
    """The options of detent-import that the hints of `read` stand for."""
    inspect.signature(read).bind("", **hints)  # TypeError: no hint has such a name
    given: list[tuple[str, object]] = []
    for name, value in hints.items():
        if value is None or value is False:
            continue
        option = name.replace("_", "-")
        if name == "mask":
            given += [(option, _joined(box)) for box in value]
        elif name in ("x_axis", "y_axis"):
            given.append((option, _joined(value, ":")))
        elif name in ("frame", "press_line", "release_line"):
            given.append((option, _joined(value)))
        else:
            given.append((option, value))
    return [os.fsencode(f"--{option}" if value is True else f"--{option}={value}") for option, value in given]


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
    no_release: bool = False,
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
    no_release: the plot shows no release of this button.

    Raises WrongUsage, UnreadableInput, NoForceGraph, NotCertain.
    """
    hints = {name: value for name, value in locals().items() if name != "path"}
    return _told(*_core.read(os.fsencode(path), _options(hints)))


def _told(core: _core.Button, report: str) -> Button:
    return Button(core, json.loads(report))


def load(path: AnyPath) -> Button:
    """A button from its file: *.button.json, or a CSV stroke,displacement_mm,force_N. UnreadableInput names the place that is wrong."""
    return Button(_core.Button.load(os.fsencode(path)))


def render(button: Button, press: AnyPath | None = None, *, rate_Hz: float = 48000, feel: Feel = "clear") -> NDArray[np.float32]:
    """A press as vibration, (n,): what `detent-play render` writes, sample for sample, as shares of full scale.

    press: a trace (CSV: time_s,force_N or time_s,displacement_mm); without one a human-like press of 0.3 s.
    rate_Hz: samples per second, 8000 to 192000.
    feel: "clear", or "paper" as K&L have it.
    WrongUsage: a setting out of its range. UnreadableInput: a trace that cannot be read.
    """
    return _core.render(_core_of(button), b"" if press is None else os.fsencode(press), rate_Hz, feel)


def confusion(*buttons: Button) -> list[dict[str, Any]]:
    """Will people tell these buttons apart? One entry a pair, of `detent-play confusion --json`: d_prime, errors_per_90, ...

    a, b: the buttons' places among the arguments, from 0. WrongUsage: fewer than two buttons.
    """
    pairs = json.loads(_core.confusion(_cores(buttons)))
    return [{**pair, "a": int(pair["a"]), "b": int(pair["b"])} for pair in pairs]


def performance(*buttons: Button, operate_at_mm: float | None = None) -> list[dict[str, Any]]:
    """How people will press these buttons: one entry a button, of `detent-play performance --json`: activation_s, misses_per_1000, ...

    operate_at_mm: what if the contact closed there. Some seconds a button. WrongUsage: no button.
    """
    return list(json.loads(_core.performance(_cores(buttons), operate_at_mm)))


def find_like(button: Button, database: AnyPath, *, limit: int = 10) -> list[dict[str, Any]]:
    """Measured switches that feel like this button, nearest first: `found` of `detent-import library find --like`.

    database: the library's file, as `detent-import library index` makes it. Each entry has name, credit, licence, source,
    distance_lab_noise (below 1 nobody can say that two differ), group and the key figures.
    UnreadableInput: no library, or one of another version.
    """
    return list(json.loads(_core.find_like(_core_of(button), os.fsencode(database), limit))["found"])


def compare(first: Button, second: Button, *, state: int = 0, other_state: int = 0) -> dict[str, Any]:
    """How far two graphs lie apart, in mm, N and shares of the first one's span: `detent-graph compare --json`.

    WrongUsage: they have no stroke in common. IndexError: no such state.
    """
    distance: dict[str, Any] = json.loads(_core.compare(_core_of(first), _core_of(second), state, other_state))
    return {key: value for key, value in distance.items() if key not in ("status", "command", "file", "other")}


def average(*units: Button) -> tuple[Button, dict[str, Any]]:
    """Several measured units as one button: the mean, and what `detent-graph average --json` says of the spread.

    `units`: by place among the arguments how far each lies from the median (distance_N), and whether it is an outlier;
    `states`: figures with mean, sd, least, most; press_band and release_band. WrongUsage: fewer than two.
    """
    core, text = _core.average(_cores(units))
    spread = json.loads(text)
    of_units = [{"distance_N": unit["distance_N"], "outlier": unit["outlier"]} for unit in spread["units"]]
    return Button(core), {"units": of_units, "states": spread["states"]}


def between(first: Button, second: Button, share: float | None = None) -> Button:
    """The button between two others; its report is that of `detent-play between --json`.

    share: 0 (first) to 1 (second); without it the place forecast to differ as much from either. WrongUsage: a share outside.
    """
    return _told(*_core.between(_core_of(first), _core_of(second), share))


def import_many(
    paths: Iterable[AnyPath], *, jobs: int | None = None, progress: bool = False, **hints: Any
) -> Iterator[tuple[AnyPath, Button | Failure]]:
    """Reads many files side by side and gives, in their order, each path with its button or the Failure it raised.

    jobs: files at once, >= 1 (default: one per core). progress: a bar, where tqdm is installed. hints: as for read, for all.
    The library's own threads read; Python goes on meanwhile. Of files from strangers, `detent-import --batch` gives each a process.
    WrongUsage, before anything is read: a hint or `jobs` that cannot be.
    """
    listed = list(paths)
    if jobs is not None and jobs < 1:
        raise WrongUsage(2, f"jobs: {jobs} is not 1 or more.")
    many = _core.ReadMany([os.fsencode(path) for path in listed], _options(hints), jobs or os.cpu_count() or 1)
    return _results(listed, many, _bar(len(listed)) if progress else None)


def _results(listed: list[AnyPath], many: _core.ReadMany, bar: Any) -> Iterator[tuple[AnyPath, Button | Failure]]:
    try:
        for path in listed:
            result: Button | Failure
            try:
                result = _told(*many.next())
            except Failure as failure:
                result = failure
            yield path, result
            if bar is not None:
                bar.update()
    finally:
        many.stop()
        if bar is not None:
            bar.close()


def _bar(total: int) -> Any:
    try:
        bars = importlib.import_module("tqdm.auto")
    except ImportError:
        return None
    return bars.tqdm(total=total, unit="file")
