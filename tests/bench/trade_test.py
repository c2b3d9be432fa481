#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What docs/measurements/trade.md recommends is what the programs do by themselves, the import dialogue and the help quote its figures, and every section stands there.

    trade_test.py --bin FOLDER
"""
import argparse
import importlib.machinery
import importlib.util
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COMMANDS = {"--quality": ["detent-import"], "--placement": ["detent-play", "render"], "--feel": ["detent-play", "render"], "--rate 48000": ["detent-play", "render"],
            "--rate 1000": None, "--velocity": ["detent-play", "force"]}  # None: 0 stands for the device's own, 1000 Hz of every preset


def trade():
    loader = importlib.machinery.SourceFileLoader("trade", str(ROOT / "tests/bench/trade"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("trade", loader))
    sys.modules["trade"] = module
    loader.exec_module(module)
    return module


def command_of(option, value):
    return COMMANDS.get(f"{option} {value}", COMMANDS.get(option))


def quality_box(module):
    """What the import dialogue says of the levels, against the page."""
    source = ROOT / "editor/importing/quality_figures.cpp"
    told = {name: (float(work), float(error)) for name, work, error in re.findall(r"\{importer::Quality::(\w+), ([\d.]+), ([\d.]+)\}", source.read_text())}
    page = {name: (figures[0], figures[1]) for name, figures in module.table_of(module.kept("levels")).items()}
    return [f"{source.relative_to(ROOT)}: {name} has {told.get(name)}, docs/measurements/trade.md {page.get(name)} (work of a draft, error in %)"
            for name in sorted(told.keys() | page.keys()) if told.get(name) != page.get(name)]


def quality_help(module, binaries):
    """What the importer's help says of the levels, in the order draft, standard, precise, against the page."""
    page = module.table_of(module.kept("levels"))
    if not (binaries / "detent-import").is_file():
        return []
    told = subprocess.run([str(binaries / "detent-import"), "--help"], capture_output=True, text=True).stdout
    levels = [page[name] for name in ("draft", "standard", "precise")]
    for said in ("{:.2f}, {:.2f} and {:.2f} % of the span".format(*(error for _, error, *_ in levels)),
                 "{:.2g}, {:.2g} and {:.2g} times the work".format(*(work for work, *_ in levels))):
        if said not in " ".join(told.split()):
            return [f"detent-import --help: of --quality docs/measurements/trade.md says {said}"]
    return []


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, type=Path)
    binaries = parser.parse_args().bin
    module, wrong = trade(), []
    page = (ROOT / "docs/measurements/trade.md").read_text()
    for name, (_, section) in module.SECTIONS.items():
        text = module.kept(name)
        if not text:
            wrong.append(f"docs/measurements/trade.md has no section {name}: tests/bench/trade --write --only {name}")
        elif section.advice not in text:
            wrong.append(f"docs/measurements/trade.md, {name}: the advice is not that of tests/bench/trade")
        if text and not (ROOT / f"docs/measurements/trade-{name}.svg").is_file():
            wrong.append(f"docs/measurements/trade-{name}.svg is not there")
    recommended = re.findall(r"\*\*Recommended: `([^`]+)`", page)
    pairs = [pair for line in recommended for pair in re.findall(r"(--[a-z-]+) ([\w-]+)", line)]
    if len(pairs) < 4:
        wrong.append(f"only {len(pairs)} settings are recommended on the page")
    for option, value in pairs:
        command = command_of(option, value)
        if command is None or not (binaries / command[0]).is_file():
            continue
        told = subprocess.run([str(binaries / command[0]), *command[1:], "--help"], capture_output=True, text=True).stdout
        entry = re.search(rf"^ +{option}\b.*(?:\n(?! +-).*)*", told, re.M)
        if not entry or not re.search(rf"(?:=|default: ){value}\b", entry[0]):
            wrong.append(f"{' '.join(command)} {option}: the page recommends {value}, the help has another default")
    wrong += quality_box(module) + quality_help(module, binaries)
    for line in wrong:
        print(line)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
