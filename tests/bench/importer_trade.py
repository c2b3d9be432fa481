#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Accuracy, time and memory of detent-import on the evaluation corpus, per class and quality level.

importer_trade.py PROGRAM [--corpus DIR] [--quality draft,standard,precise] [--classes NAME,...] [--limit N] [--jobs N]
                          [--write DOCS_DIR] [--items FILE.jsonl]

One import per item and level, without hints, writes both `--trace-csv` and `--csv`; score.py of the corpus scores them
(its docstring defines the distance: mean orthogonal, as a share of the axis span). Columns: ok = exit 0 and every true
stroke present; wrong = exit 0 although the trace is off by more than 2 %; swapped strokes; tactile = press tactile point
within 0.02 mm and 0.7 gf of the fitted graph, of the items that have one. `--write` puts docs/measurements/bench-importer.md and, where
gnuplot is installed, its picture docs/measurements/bench-importer.svg. Needs Debian's python3-numpy. Without the corpus it says SKIPPED.
"""
import argparse, concurrent.futures, contextlib, io, json, os, statistics, subprocess, sys, tempfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
NOT_YET = {"scan", "photo", "lowres", "dashed", "markers"}


def classes(corpus):
    """Class name -> items, as the figures asked of the importer name them."""
    groups = {}
    for item in sorted(corpus.glob("real/*")) + sorted(corpus.glob("rendered/*")) + sorted(corpus.glob("datasheets/ref/*")):
        meta = json.loads((item / "meta.json").read_text())
        style = set(meta.get("style", []))
        if meta.get("class") == "multi":
            continue
        if item.parent.name == "real":
            name = "real, single" if meta["class"] == "single" else "real, press only"
        elif item.parent.name == "ref":
            name = "datasheets/ref"
        elif style & NOT_YET:
            name = "reported only (scans, photos, low resolution, dashed, markers)"
        elif "vector" in style:
            name = "vector PDF and SVG"
        else:
            name = "rendered, one colour" if "mono" in style else "rendered, two colours"
        groups.setdefault(name, []).append((item, meta))
    return groups


def score(corpus, truth, result):
    """score.py's figures for one pair of files."""
    sys.path.insert(0, str(corpus))
    import score as scorer
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        scorer.main(["score.py", str(truth), str(result)])
    return json.loads(out.getvalue())


def mean_distance(scored):
    d = [scored[k] for k in ("press_dist_mean", "release_dist_mean") if k in scored]
    return None if not d or None in d else sum(d) / len(d)


def run_item(program, corpus, item, meta, quality):
    sys.path.insert(0, str(corpus))
    from evaluate_tools import pick_graph
    plot = meta.get("input") or next(p.name for p in sorted(item.iterdir()) if p.stem == "plot")
    row = {"id": item.name, "quality": quality}
    with tempfile.TemporaryDirectory() as folder:
        fit, trace = Path(folder, "fit.csv"), Path(folder, "trace.csv")
        command = [program, str((item / plot).resolve()), "--csv", str(fit), "--trace-csv", str(trace), "--json", "--quality", quality]
        if meta.get("import_page"):
            command += ["--page", str(meta["import_page"])]
        if meta.get("frame_pt"):
            command += pick_graph(program, item / plot, meta, 60)
        try:
            # A process of its own for each import, so that its peak memory is its own.
            timed = ["/usr/bin/time", "-f", "%M %e %U", "-o", f"{folder}/time"] + command
            done = subprocess.run(timed, capture_output=True, text=True, timeout=120, stdin=subprocess.DEVNULL)
        except subprocess.TimeoutExpired:
            return {**row, "exit": "timeout"}
        row["exit"] = done.returncode
        kilobytes, wall, user = Path(folder, "time").read_text().split()[-3:]
        row["s"], row["cpu_s"], row["MB"] = float(wall), float(user), float(kilobytes) / 1024
        if done.returncode == 0:
            row["confidence"] = json.loads(done.stdout)["confidence"]
            for what, path in (("trace", trace), ("fit", fit)):
                scored = score(corpus, item / "truth.csv", path)
                row[what] = mean_distance(scored)
                row[what + "_swapped"] = bool(scored.get("strokes_swapped"))
                peak = scored.get("press_peak")
                if peak and peak.get("truth_mm") is not None:
                    error = (peak["nearest_err_mm"], peak["nearest_err_gf"])
                    row[what + "_peak_ok"] = None not in error and abs(error[0]) <= 0.02 and abs(error[1]) <= 0.7
        else:
            row["said"] = done.stderr.strip()[-200:]
    row["ok"] = row.get("trace") is not None and row.get("fit") is not None
    return row


def percentile(values, share):
    values = sorted(values)
    return values[min(len(values) - 1, int(share * len(values)))] if values else float("nan")


def summary(rows):
    ok = [r for r in rows if r["ok"]]
    peaks = [r["fit_peak_ok"] for r in ok if "fit_peak_ok" in r]
    column = lambda key: [r[key] for r in ok]
    median = lambda values: statistics.median(values) if values else float("nan")
    return {
        "n": len(rows), "ok": len(ok) / max(1, len(rows)),
        "wrong": sum(r["trace"] > 0.02 for r in ok), "swapped": sum(r["trace_swapped"] for r in ok),
        "trace_median": median(column("trace")), "trace_p90": percentile(column("trace"), 0.9),
        "fit_median": median(column("fit")), "fit_p90": percentile(column("fit"), 0.9),
        "peak": sum(peaks) / len(peaks) if peaks else None, "peaks": len(peaks),
        "s_median": median([r["s"] for r in rows if "s" in r]), "s_max": max((r["s"] for r in rows if "s" in r), default=0),
        "MB_max": max((r["MB"] for r in rows if "MB" in r), default=0),
    }


HEAD = ("| class | quality | n | ok | wrong > 2 % | swapped | trace median / p90 % | fit median / p90 % | tactile point | s median / max | MB max |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|")


def table_row(name, quality, s):
    tactile = "" if s["peak"] is None else f"{s['peak']:.0%} of {s['peaks']}"
    return (f"| {name} | {quality} | {s['n']} | {s['ok']:.1%} | {s['wrong']} | {s['swapped']} "
            f"| {100 * s['trace_median']:.3f} / {100 * s['trace_p90']:.3f} | {100 * s['fit_median']:.3f} / {100 * s['fit_p90']:.3f} "
            f"| {tactile} | {s['s_median']:.2f} / {s['s_max']:.2f} | {s['MB_max']:.0f} |")


PAGE_HEAD = ("| class | n | ok | wrong > 2 % | trace median / p90 % | fit median / p90 % | tactile point |\n"
             "|---|---|---|---|---|---|---|")


def page_row(name, s):
    """The row of a class on the page, which shows level standard alone."""
    tactile = "" if s["peak"] is None else f"{s['peak']:.0%} of {s['peaks']}"
    return (f"| {name} | {s['n']} | {s['ok']:.1%} | {s['wrong']} | {100 * s['trace_median']:.3f} / {100 * s['trace_p90']:.3f} "
            f"| {100 * s['fit_median']:.3f} / {100 * s['fit_p90']:.3f} | {tactile} |")


def write_picture(folder, points):
    """Error against time, one line per class, with gnuplot; left out where gnuplot is not installed."""
    data, plots = [], []
    for name, series in points.items():
        data.append(f"${'d' + str(len(plots))} << EOD\n" + "\n".join(f"{t} {e}" for t, e in series) + "\nEOD")
        plots.append(f"$d{len(plots)} with linespoints lw 2 title '{name}'")
    script = "\n".join(data) + f"""
set terminal svg size 900,520 font 'sans,13'
set output '{folder / 'bench-importer.svg'}'
set logscale xy; set grid
set xlabel 'median time of one import, s (draft, standard, precise from left to right)'
set ylabel 'median distance of the fitted graph, % of span'
set key outside
plot {', '.join(plots)}
"""
    with contextlib.suppress(FileNotFoundError):
        subprocess.run(["gnuplot"], input=script, text=True, check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--corpus", default=os.environ.get("DETENT_CORPUS", str(SOURCE.parent / "shared" / "corpus")))
    parser.add_argument("--quality", default="draft,standard,precise")
    parser.add_argument("--classes", help="names that a class must start with, comma separated")
    parser.add_argument("--limit", type=int, help="items per class")
    parser.add_argument("--jobs", type=int, default=1, help="imports at once; 1 for times that mean something")
    parser.add_argument("--write", help="folder for bench-importer.md and .svg")
    parser.add_argument("--items", help="file for one JSON line per import")
    a = parser.parse_args()
    corpus = Path(a.corpus)
    if not (corpus / "score.py").exists():
        print(f"SKIPPED: no corpus at {corpus}; set DETENT_CORPUS")
        return
    page_lines, items, points = [PAGE_HEAD], [], {}
    print(HEAD, flush=True)
    for name, members in classes(corpus).items():
        if a.classes and not any(name.startswith(c.strip()) for c in a.classes.split(",")):
            continue
        for quality in a.quality.split(","):
            with concurrent.futures.ProcessPoolExecutor(a.jobs) as pool:
                jobs = [pool.submit(run_item, a.program, corpus, i, m, quality) for i, m in members[: a.limit]]
                rows = [{**j.result(), "class": name} for j in jobs]
            s = summary(rows)
            print(table_row(name, quality, s), flush=True)
            if quality == "standard":
                page_lines.append(page_row(name, s))
            items += rows
            points.setdefault(name, []).append((s["s_median"], 100 * s["fit_median"]))
    if a.items:
        Path(a.items).write_text("".join(json.dumps(r) + "\n" for r in items))
    if a.write:
        page = Path(a.write, "bench-importer.md")
        before, marks, after = page.read_text().partition("<!-- importer_trade.py -->\n")
        after = after.split("<!-- end -->", 1)[1]
        page.write_text(before + marks + "\n".join(page_lines) + "\n<!-- end -->" + after)
        write_picture(Path(a.write), points)


if __name__ == "__main__":
    main()
