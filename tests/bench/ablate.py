#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is each threshold worth? Changes every one of a step, alone, over plots with known truth, and prints what that costs.

ablate.py IMPORT_ABLATION STEP... [--corpus DIR] [--every N] [--factor F] [--jobs N] [--only NAME]

IMPORT_ABLATION: the program of the target `import_ablation`. STEP: the part of a threshold's name before the dot ("choice",
"chroma", "follow", "palette"). Thresholds are found in the sources: tuned("step.name", VALUE). Each is tried at VALUE / F and VALUE * F
(default 2) on every N-th item (default 6) of real, rendered and datasheets/ref of the corpus (default: ../shared/corpus beside the
checkout). Columns: items no longer imported, items newly imported, items traced worse / better by more than a tenth (and 0.005 % of
span), mean trace distance over the items that both import, in per cent of span. A threshold that changes nothing either way is worth
nothing on these items: look at more of them, then remove it.
"""
import argparse, concurrent.futures as cf, json, os, re, statistics, subprocess, sys, tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TUNED = re.compile(r'tuned\("([a-z]+)\.(\w+)",\s*(-?[\d.]+)\)')


def thresholds(steps):
    found = {}
    for source in sorted((ROOT / "importer").rglob("*.*")):
        for step, name, value in TUNED.findall(source.read_text(encoding="utf-8", errors="replace")):
            if step in steps:
                found[f"{step}.{name}"] = float(value)
    return found


def items(corpus, every):
    for folder in ("real", "rendered", "datasheets/ref"):
        kept = [p for p in sorted((corpus / folder).iterdir()) if (p / "meta.json").exists()]
        for item in kept[::every]:
            meta = json.loads((item / "meta.json").read_text())
            if meta.get("class") == "multi" or meta.get("frame_pt"):
                continue
            plot = meta.get("input") or next(q.name for q in sorted(item.iterdir()) if q.stem == "plot")
            yield item, item / plot, meta.get("import_page")


def distance(program, item, tuned, corpus):
    """Mean distance of the traced strokes from the truth as a share of the span; None: not imported."""
    folder, plot, page = item
    with tempfile.TemporaryDirectory() as tmp:
        out = Path(tmp) / "trace.csv"
        command = [program, str(plot.resolve()), "--trace-csv", str(out)] + (["--page", str(page)] if page else [])
        subprocess.run(command, capture_output=True, stdin=subprocess.DEVNULL, timeout=300, env={**os.environ, "DETENT_TUNED": tuned})
        if not out.exists():
            return None
        scored = subprocess.run([sys.executable, str(corpus / "score.py"), str(folder / "truth.csv"), str(out)], capture_output=True, text=True)
        score = json.loads(scored.stdout.strip().splitlines()[-1])
        parts = [score[k] for k in ("press_dist_mean", "release_dist_mean") if score.get(k) is not None]
        return sum(parts) / len(parts) if parts else None


def compared(standard, changed):
    both = [(a, b) for a, b in zip(standard, changed) if a is not None and b is not None]
    lost = sum(a is not None and b is None for a, b in zip(standard, changed))
    won = sum(a is None and b is not None for a, b in zip(standard, changed))
    worse = sum(b > 1.1 * a + 5e-5 for a, b in both)
    better = sum(a > 1.1 * b + 5e-5 for a, b in both)
    mean = [100 * statistics.mean(side) for side in zip(*both)] if both else [0, 0]
    return lost, won, worse, better, mean


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program"), parser.add_argument("step", nargs="+"), parser.add_argument("--only")
    parser.add_argument("--corpus", type=Path, default=ROOT.parent / "shared/corpus"), parser.add_argument("--every", type=int, default=6)
    parser.add_argument("--factor", type=float, default=2), parser.add_argument("--jobs", type=int, default=1)
    a = parser.parse_args()
    chosen = {k: v for k, v in thresholds(a.step).items() if not a.only or a.only in k}
    if not chosen:
        sys.exit(f"no threshold of {', '.join(a.step)} in the sources; steps are the words before the dot in tuned(\"step.name\", ...)")
    plots = list(items(a.corpus, a.every))
    with cf.ThreadPoolExecutor(a.jobs) as pool:
        run = lambda tuned: list(pool.map(lambda item: distance(a.program, item, tuned, a.corpus), plots))
        standard = run("")
        print(f"{len(plots)} items, {sum(d is not None for d in standard)} imported; {len(chosen)} thresholds")
        print(f"{'threshold':28} {'value':>8} {'tried':>8}  lost  won worse better   mean % (standard -> tried)")
        for name, value in chosen.items():
            for tried in (value / a.factor, value * a.factor):
                lost, won, worse, better, mean = compared(standard, run(f"{name}={tried!r}"))
                verdict = "" if lost + won + worse + better else "   nothing"
                print(f"{name:28} {value:8g} {tried:8g} {lost:5} {won:4} {worse:5} {better:6}   {mean[0]:.4f} -> {mean[1]:.4f}{verdict}", flush=True)


if __name__ == "__main__":
    main()
