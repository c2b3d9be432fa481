# SPDX-License-Identifier: GPL-3.0-or-later
"""Edits as values: made here, applied by Button.edited, kept, compared and pickled like numbers.

    stiffer = detent.edits.scale_force(1.2)
    buttons = [button.edited(stiffer) for button in buttons]

Displacement in mm, force in N. `press`: False edits the release. `state`: of a self-locking button, from 0. What an edit would break
raises WrongUsage when it is applied, with the rule and what stands in the way; the button stays as it is.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from . import _core


@dataclass(frozen=True)
class Edit:
    """One change of a button: its name and its arguments, in the order of the function that made it."""

    name: str
    arguments: tuple[Any, ...]

    def of(self, button: _core.Button) -> _core.Button:
        """The compiled button with the edit."""
        edited: _core.Button = getattr(button, self.name)(*self.arguments)
        return edited


def rename(name: str) -> Edit:
    """Another name; any text."""
    return Edit("rename", (name,))


def scale_force(factor: float) -> Edit:
    """All forces times a factor above 0, damping with them."""
    return Edit("scale_force", (factor,))


def scale_travel(factor: float) -> Edit:
    """All displacements times a factor above 0, operating and reset points with them."""
    return Edit("scale_travel", (factor,))


def scale_snap(factor: float) -> Edit:
    """The snap ratio of every tactile point of the press times a factor above 0."""
    return Edit("scale_snap", (factor,))


def operate_at(at_mm: float | None, *, state: int = 0) -> Edit:
    """The contact closes there; None: it is not known where."""
    return Edit("operate_at", (at_mm, state))


def reset_at(at_mm: float | None, *, state: int = 0) -> Edit:
    """The contact opens there; None: it is not known where."""
    return Edit("reset_at", (at_mm, state))


def mirror_release(hysteresis_N: float, *, state: int = 0) -> Edit:
    """The release becomes the press, lowered by so much."""
    return Edit("mirror_release", (hysteresis_N, state))


def remove_release(*, state: int = 0) -> Edit:
    """The way up is not known any more."""
    return Edit("remove_release", (state,))


def move_tactile_point(index: int, to_mm: float, to_N: float, *, press: bool = True, state: int = 0) -> Edit:
    """Moves a tactile point (from 0, in the order travelled); its flanks are stretched with it."""
    return Edit("move_tactile_point", (index, to_mm, to_N, press, state))


def add_jump(at_mm: float, width_mm: float, drop_N: float, *, press: bool = True, state: int = 0) -> Edit:
    """A jump from a new tactile point, so deep and so wide."""
    return Edit("add_jump", (at_mm, width_mm, drop_N, press, state))


def remove_jump(index: int, *, press: bool = True, state: int = 0) -> Edit:
    """Takes away the jump that begins at a tactile point (from 0)."""
    return Edit("remove_jump", (index, press, state))


def make_linear(*, press: bool = True, state: int = 0) -> Edit:
    """A straight line from the start to the foot of the bottom-out."""
    return Edit("make_linear", (press, state))
