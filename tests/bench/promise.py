#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What an import's confidence is worth, counted: runs the importer over pages whose right answer is known, and writes docs/measurements/import-confidence.md.

promise.py count IMPORT_PROGRAM ROWS.jsonl [--corpus DIR] [--seeds A,B,...] [--fresh FIRST:COUNT] [--source NAME] [--jobs N]
promise.py write --calibration ROWS.jsonl... --test ROWS.jsonl...

`count` imports every page with `--sure 0`, so that one run answers for every bar, and appends a row a page. `write` puts the tables of two
such counts of different seeds into docs/measurements/import-confidence.md: one from which confidences may be set, one that was not looked at
before. Pages, by source:
    real, rendered, ref, web   of the corpus; the importer was built on them
    honesty                    the corpus' drawn plots and charts that are none, of --seeds; nobody built on these
    scanned, photographed      the same of other seeds, printed and laid on a scanner or before a camera by `as_scan` and `as_photo`
    vector                     SVG and PDF pages, --fresh FIRST:COUNT, of tests/accuracy/draw_plots.py, of numbers its gate does not use; one in five
                               measures something that is no force over travel and must be refused
Wrong: accepted and more than 2 % of the span from the truth (mean of both strokes), a stroke invented, or accepted though it must be
refused. Accepted without a known answer: not counted. Needs Debian's python3-numpy, python3-pil and python3-matplotlib, and gnuplot. Runs for minutes to hours.
"""
import argparse
import concurrent.futures
import json
import math
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "accuracy"))
WRONG = 0.02  # of the span
TIMEOUT_s = 180


# -- pages: one dictionary each, `may`: import, refuse or either -------------------------------------------------------------------

def corpus_items(corpus, folder):
    for path in sorted((corpus / folder).glob("*/meta.json")):
        meta, item = json.loads(path.read_text()), path.parent
        if meta.get("class") == "multi":
            continue
        plot = meta.get("input") or next(p.name for p in sorted(item.iterdir()) if p.stem == "plot")
        yield {"name": f"{folder}/{item.name}", "file": str((item / plot).resolve()), "truth": str(item / "truth.csv"), "may": "import",
               "page": meta.get("import_page"), "frame_pt": meta.get("frame_pt"), "drawn_as": class_of_item(meta, plot)}


def class_of_item(meta, plot):
    style = set(meta.get("style", []))
    if "photo" in style:
        return "photo"
    if "scan" in style:
        return "scan"
    return "vector" if "vector" in style or plot.endswith(".svg") else "picture"


def web_items(corpus):
    folder = corpus / "web"
    for entry in json.loads((folder / "catalog.json").read_text()):
        yield {"name": f"web/{entry['id']}", "web": entry, "folder": str(folder), "may": "import", "drawn_as": "picture"}
    for entry in json.loads((folder / "negatives.json").read_text()):
        yield {"name": f"web/{entry['file']}", "file": str(folder / entry["file"]), "page": entry.get("page", 1), "may": "refuse",
               "drawn_as": "picture"}


def honesty_cases(corpus, folder, seed):
    """One seed of the corpus' plots that try honesty, drawn into `folder`."""
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run([sys.executable, str(corpus / "honesty" / "make.py"), str(folder), "--seed", str(seed)], check=True, stdout=subprocess.DEVNULL)
    for case in json.loads((folder / "cases.json").read_text()):
        file = folder / case["file"]
        truth = folder / f"{file.stem}.truth.csv"
        yield {"name": f"honesty-{seed}/{file.name}", "file": str(file), "truth": str(truth) if truth.exists() else None, "may": case["may"],
               "drawn_as": "picture"}


def degraded(cases, degrade, drawn_as):
    """The same pages on paper."""
    for case in cases:
        source = Path(case["file"])
        file = source.with_name(f"{source.stem}.{drawn_as}.jpg")
        degrade(source, file, random.Random(f"{drawn_as} {case['name']}"))
        yield {**case, "name": case["name"].replace("honesty", f"honesty-{drawn_as}"), "file": str(file), "drawn_as": drawn_as}


def opened(file):
    from PIL import Image, ImageOps
    picture = ImageOps.exif_transpose(Image.open(file))
    if picture.mode in ("RGBA", "LA", "P"):
        picture = picture.convert("RGBA")
        picture = Image.alpha_composite(Image.new("RGBA", picture.size, "white"), picture)
    return picture.convert("RGB")


def lit(picture, chance, unevenness, grain):
    """Light that falls off to one side, and the grain of a sensor."""
    import numpy
    from PIL import Image
    noise = numpy.random.default_rng(chance.getrandbits(32))
    values = numpy.asarray(picture, float)
    height, width = values.shape[:2]
    angle = chance.uniform(0, 2 * math.pi)
    y, x = numpy.mgrid[0:height, 0:width]
    light = 1 - unevenness * (0.5 + 0.5 * (math.cos(angle) * (2 * x / width - 1) + math.sin(angle) * (2 * y / height - 1)) / math.sqrt(2))
    values = values * light[..., None] * (0.93 + 0.05 * chance.random()) + noise.normal(0, grain, values.shape[:2])[..., None]
    return Image.fromarray(numpy.clip(values, 0, 255).astype("uint8"))


def as_scan(source, file, chance):
    """On a flatbed: half a degree to two askew, soft, slightly uneven, the paper not white, JPEG."""
    from PIL import Image, ImageFilter
    picture = opened(source)
    scale = chance.uniform(1.0, 1.8)
    picture = picture.resize((int(picture.width * scale), int(picture.height * scale)), Image.LANCZOS)
    picture = picture.rotate(chance.uniform(-2, 2), Image.BICUBIC, expand=True, fillcolor="white")
    picture = picture.filter(ImageFilter.GaussianBlur(chance.uniform(0.4, 1.0)))
    lit(picture, chance, 0.06, chance.uniform(1.5, 4)).save(file, quality=chance.randrange(65, 92))


def as_photo(source, file, chance):
    """Before a camera: tilted by up to 25 degrees, on a darker table, uneven light, blur, grain, JPEG."""
    import numpy
    from PIL import Image, ImageFilter
    sheet = opened(source)
    scale = 1400 / sheet.width
    sheet = sheet.resize((1400, int(sheet.height * scale)), Image.LANCZOS)
    width, height = sheet.size
    tilt, turn, lean = math.radians(chance.uniform(3, 25)), chance.uniform(0, 2 * math.pi), math.radians(chance.uniform(-4, 4))
    axis = (math.cos(turn), math.sin(turn))
    far = 2.2 * width  # of the camera
    corners = []
    for x, y in ((0, 0), (width, 0), (width, height), (0, height)):
        u, v = x - width / 2, y - height / 2
        u, v = u * math.cos(lean) - v * math.sin(lean), u * math.sin(lean) + v * math.cos(lean)
        along, across = u * axis[0] + v * axis[1], -u * axis[1] + v * axis[0]
        across, depth = across * math.cos(tilt), across * math.sin(tilt)
        u, v = along * axis[0] - across * axis[1], along * axis[1] + across * axis[0]
        corners.append((u * far / (far + depth), v * far / (far + depth)))
    margin = 60
    left, top = min(c[0] for c in corners) - margin, min(c[1] for c in corners) - margin
    shown = [(c[0] - left, c[1] - top) for c in corners]
    size = (int(max(c[0] for c in shown) + margin), int(max(c[1] for c in shown) + margin))
    rows, values = [], []
    for (x, y), (u, v) in zip(shown, ((0, 0), (width, 0), (width, height), (0, height))):  # PIL maps the result to the source
        rows += [[x, y, 1, 0, 0, 0, -u * x, -u * y], [0, 0, 0, x, y, 1, -v * x, -v * y]]
        values += [u, v]
    mapping = numpy.linalg.solve(numpy.array(rows), numpy.array(values))
    photo = sheet.transform(size, Image.PERSPECTIVE, tuple(mapping), Image.BICUBIC, fillcolor=(120, 100, 84))
    photo = photo.filter(ImageFilter.GaussianBlur(chance.uniform(0.5, 1.2)))
    lit(photo, chance, 0.25, chance.uniform(2, 5)).save(file, quality=chance.randrange(75, 93))


OTHERS = (("Time (s)", "Force (N)"), ("Travel (mm)", "Pressure (kPa)"), ("Position (mm)", "Stiffness (N/mm)"), ("Angle (deg)", "Torque (mNm)"),
          ("Cycles (x1000)", "Force (gf)"), ("Temperature (C)", "Force (cN)"))


def vector_pages(folder, first, count):
    """SVG and PDF pages of the accuracy gate's styles, numbers it never draws, line widths and inks of their own."""
    import draw_plots
    folder.mkdir(parents=True, exist_ok=True)
    for number in range(first, first + count):
        kind = ("svg", "pdf")[number % 2]
        chance = random.Random(f"vector {number}")
        plain, graph_lines = draw_plots.STYLES[kind], draw_plots.graph_lines
        inks = chance.choice((("black", "black"), ("#c8102e", "#0b5cad"), ("#2e8b37", "#7b3fa0"), ("#0b5cad", "#0b5cad")))
        draw_plots.STYLES[kind] = draw_plots.Style(**{**vars(plain), "inks": inks, "width": chance.uniform(0.8, 3.5)})
        other = chance.choice(OTHERS) if number % 5 == 0 else None
        if other:
            def retitled(*arguments, titles=other):
                return [f"set xlabel '{titles[0]}'" if line.startswith("set xlabel") else
                        f"set ylabel '{titles[1]}'" if line.startswith("set ylabel") else line for line in graph_lines(*arguments)]
            draw_plots.graph_lines = retitled
        page = draw_plots.draw(folder, kind, number)
        draw_plots.STYLES[kind], draw_plots.graph_lines = plain, graph_lines
        truth = folder / f"{page['file']}.truth.csv"
        rows = [f"{stroke},{x:.6g},{force / 9.80665e-3:.6g}\n" for stroke in ("press", "release") for x, force in page["graphs"][0][stroke]]
        truth.write_text("stroke,displacement_mm,force_gf\n" + "".join(rows))
        yield {"name": f"vector/{page['file']}", "file": str(folder / page["file"]), "truth": str(truth), "may": "refuse" if other else "import",
               "drawn_as": "vector"}


# -- judging ---------------------------------------------------------------------------------------------------------------------

def imported(program, words):
    try:
        run = subprocess.run([program, "--sure", "0", *map(str, words), "--json"], capture_output=True, text=True, timeout=TIMEOUT_s,
                             stdin=subprocess.DEVNULL)
        return run.returncode, json.loads(run.stdout)
    except subprocess.TimeoutExpired:
        return "timeout", {}
    except ValueError:
        return run.returncode, {}


def distance(truth, result):
    """Mean orthogonal distance of the strokes as a share of the span, by the corpus' score.py; infinite where a stroke is missing or invented."""
    import score
    import numpy
    true, found = score.read(truth, False), score.read(result, True)
    if set(true) != set(found):
        return math.inf
    every, mine = (numpy.vstack([p for lines in side.values() for p in lines]) for side in (true, found))
    spans = numpy.ptp(every, axis=0)
    if any(not 0.5 < a / b < 2 for a, b in zip(numpy.ptp(mine, axis=0), spans)):
        return math.inf  # off by a factor: no need to measure
    parts = [score.pair([score.simplify(p) / spans for p in true[s]], [score.simplify(p) / spans for p in found[s]])["mean"] for s in true]
    return float(sum(parts) / len(parts))


def vertex(a, b, c):
    """Of the parabola through three points whose middle one is the highest or lowest."""
    if not a[0] < b[0] < c[0]:  # in a wall: no parabola
        return b[0], b[1]
    left, right = (b[1] - a[1]) / (b[0] - a[0]), (c[1] - b[1]) / (c[0] - b[0])
    bend = (right - left) / (c[0] - a[0])
    if bend == 0:
        return b[0], b[1]
    x = (a[0] + b[0]) / 2 - left / (2 * bend)
    return x, a[1] + left * (x - a[0]) + bend * (x - a[0]) * (x - b[0])


def tactile_errors(truth, answer):
    """(mm off, sigma_mm, N off, sigma_N) of every tactile point reported that the truth has too: its extremum within 0.2 mm."""
    import score
    true, rows = score.read(truth, False), []
    for stroke, sign in (("press", 1), ("release", -1)):
        points = true.get(stroke, [[]])[0]
        for found in answer.get(stroke, {}).get("tactile_points", []):
            near = sorted((p for p in points if abs(p[0] - found["displacement_mm"]) < 0.2), key=lambda p: p[0])
            best = max(range(len(near)), key=lambda i: sign * near[i][1], default=0)
            if 3 <= best < len(near) - 3:
                x_mm, force_gf = vertex(near[best - 1], near[best], near[best + 1])
                rows.append((found["displacement_mm"] - x_mm, found["sigma_mm"], found["force_N"] - force_gf / score.GF_PER_N, found["sigma_N"]))
    return rows


def judged_web(program, page):
    """As evaluate_web.py judges: right where every catalogued tick has its value and both strokes are there."""
    import evaluate_web
    seen = {}

    def run(_, *words):
        if words[0] == "--list":
            answered = subprocess.run([program, *map(str, words), "--json"], capture_output=True, text=True, timeout=TIMEOUT_s, stdin=subprocess.DEVNULL)
            try:
                return answered.returncode, json.loads(answered.stdout)
            except ValueError:
                return answered.returncode, {}
        seen["answer"] = imported(program, words)
        return seen["answer"]
    evaluate_web.run = run
    row = evaluate_web.judge(page["web"], program, Path(page["folder"]))
    wrong = not row["calibrated"] or row["several"] or not row["complete"]
    return row["exit"], seen["answer"][1], wrong


def judged(program, page):
    with tempfile.TemporaryDirectory() as folder:
        result, wrong, off = Path(folder) / "result.csv", None, None
        if "web" in page:
            code, answer, wrong = judged_web(program, page)
        else:
            from evaluate_tools import pick_graph
            words = [page["file"], "--csv", result]
            if page.get("page"):
                words += ["--page", page["page"]]
            if page.get("frame_pt"):
                words += pick_graph(program, page["file"], {"import_page": page["page"], "frame_pt": page["frame_pt"]}, TIMEOUT_s)
            code, answer = imported(program, words)
            if code == 0 and page["may"] == "refuse":
                wrong = True
            elif code == 0 and page.get("truth"):
                off = distance(page["truth"], result)
                wrong = bool(off > WRONG)
    return {"name": page["name"], "may": page["may"], "drawn_as": page["drawn_as"], "exit": code,
            "class": answer.get("page_class", page["drawn_as"]), "confidence": answer.get("confidence") if code == 0 else None,
            "wrong": wrong if code == 0 else None, "distance": off if off is None or math.isfinite(off) else 1.0,
            "tactile": tactile_errors(page["truth"], answer) if off is not None and off < WRONG else []}


def pages_of(source, corpus, seeds, fresh, folder):
    if source in ("real", "rendered"):
        return corpus_items(corpus, source)
    if source == "ref":
        return corpus_items(corpus, "datasheets/ref")
    if source == "web":
        return web_items(corpus)
    if source == "vector":
        return vector_pages(folder / "vector", *fresh)
    cases = (case for seed in seeds for case in honesty_cases(corpus, folder / f"{source}-{seed}", seed + {"honesty": 0, "scanned": 1, "photographed": 2}[source]))
    if source == "scanned":
        return degraded(cases, as_scan, "scan")
    return degraded(cases, as_photo, "photo") if source == "photographed" else cases


SOURCES = ("vector", "honesty", "scanned", "photographed", "real", "rendered", "ref", "web")


def count(a):
    corpus = Path(a.corpus or os.environ.get("DETENT_CORPUS") or ROOT.parent / "shared" / "corpus")
    if not (corpus / "score.py").exists():
        sys.exit(f"promise.py: {corpus} holds no corpus. Pass --corpus DIR")
    sys.path.insert(0, str(corpus))
    with tempfile.TemporaryDirectory() as folder, open(a.rows, "a") as rows, concurrent.futures.ProcessPoolExecutor(a.jobs) as pool:
        for source in a.source or SOURCES:
            pages = pages_of(source, corpus, a.seeds, a.fresh, Path(a.keep or folder))
            for done in concurrent.futures.as_completed([pool.submit(judged, a.program, page) for page in pages]):
                rows.write(json.dumps({"source": source, **done.result()}) + "\n")
                rows.flush()


# -- the document ----------------------------------------------------------------------------------------------------------------

PAGE = ROOT / "docs/measurements/import-confidence.md"
BARS = (0.5, 0.8, 0.9, 0.95, 0.99)
FEW_BARS = (0.5, 0.9)  # of tables that only stand beside the one that counts
CLASSES = ("vector", "picture", "scan", "photo")
BUILT_ON = ("real", "rendered", "ref", "web")


def upper_bound(wrong, count, sure=0.95):
    """Clopper and Pearson's one-sided bound: the largest share of wrong ones under which so few would still be seen in 1 - `sure` of all counts."""
    if wrong >= count:
        return 1.0
    low, high = 0.0, 1.0
    for _ in range(60):
        share = (low + high) / 2
        seen = sum(math.comb(count, k) * share**k * (1 - share) ** (count - k) for k in range(wrong + 1))
        low, high = (share, high) if seen > 1 - sure else (low, share)
    return high


def read_rows(files):
    return [json.loads(line) for file in files for line in Path(file).read_text().splitlines()]


def accepted(rows, bar):
    """How many are accepted with a known answer, and how many of them wrong."""
    known = [row for row in rows if row["confidence"] is not None and row["confidence"] >= bar and row["wrong"] is not None]
    return len(known), sum(row["wrong"] for row in known)


def cells(rows, bar):
    count, wrong = accepted(rows, bar)
    legible = [row for row in rows if row["may"] == "import"]
    read = sum(row["confidence"] is not None and row["confidence"] >= bar and not row["wrong"] for row in legible)
    share = f"{100 * read / len(legible):.0f} %" if legible else "-"
    return [str(count), str(wrong), f"{100 * upper_bound(wrong, count):.1f} %", share]


def table(rows, title, bars=BARS):
    lines = [f"### {title}", "", "| class | confidence from | accepted | wrong | at most wrong (95 %) | legible pages read right |", "|---|---|---|---|---|---|"]
    for name in CLASSES:
        of_class = [row for row in rows if row["class"] == name]
        reached = [bar for bar in bars if accepted(of_class, bar)[0]]
        columns = [", ".join(column) for column in zip(*(cells(of_class, bar) for bar in reached))]
        if reached:
            lines.append(f"| {name} ({len(of_class)} pages) | {', '.join(f'{bar:g}' for bar in reached)} | {' | '.join(columns)} |")
    return "\n".join(lines)


def promise(rows, bar=0.9, asked=0.005):
    """One line a class: what the test pages bear out."""
    lines = []
    for name in CLASSES:
        count, wrong = accepted([row for row in rows if row["class"] == name], bar)
        if count == 0:
            lines.append(f"- **{name}**: nothing is accepted from {bar:g} on, so nothing is promised there.")
            continue
        needed = next(n for n in range(1, 5000) if upper_bound(wrong, n) <= asked)
        bound = f"at confidence {bar:g} or more at most {100 * upper_bound(wrong, count):.1f} % are wrong ({wrong} of {count} were)"
        lines.append(f"- **{name}**: {bound}. " + ("That is the promise asked for." if needed <= count else
                     f"For 1 in {1 / asked:.0f} it takes {needed} accepted pages with no more wrong: **too few pages**."))
    return "\n".join(lines)


def sigma_lines(rows):
    """Of all pages read right: how often the truth lies within the tactile points' errors."""
    lines = ["| class | tactile points | place within 68.3 % | within 95.0 % | force within 68.3 % | within 95.0 % |", "|---|---|---|---|---|---|"]
    for name in CLASSES:
        errors = [error for row in rows if row["class"] == name for error in row["tactile"]]
        if not errors:
            continue

        def within(off, sigma, times):
            return 100 * sum(abs(error[off]) <= times * error[sigma] for error in errors) / len(errors)
        lines.append(f"| {name} | {len(errors)} | {within(0, 1, 1):.0f} | {within(0, 1, 1.96):.0f} | {within(2, 3, 1):.0f} | {within(2, 3, 1.96):.0f} |")
    return "\n".join(lines)


def write(a):
    calibration, test = read_rows(a.calibration), read_rows(a.test)
    fresh = [row for row in test if row["source"] not in BUILT_ON]
    known = [row for row in calibration + test if row["source"] in BUILT_ON]
    parts = [promise(fresh), table(fresh, "Test: pages that nobody looked at before"),
             table([row for row in calibration if row["source"] not in BUILT_ON], "Calibration: pages the worth of a class was set on", FEW_BARS),
             table(known, "The corpus, on which the importer was built", FEW_BARS),
             "### Errors of tactile points, all pages read right, in per cent\n\n" + sigma_lines(calibration + test)]
    from coverage import with_section
    PAGE.write_text(with_section(PAGE.read_text(encoding="utf-8"), "counted", "\n\n".join(parts)), encoding="utf-8")


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    counting = commands.add_parser("count")
    counting.add_argument("program")
    counting.add_argument("rows")
    counting.add_argument("--corpus")
    counting.add_argument("--seeds", type=lambda text: [int(s) for s in text.split(",")], default=[31, 61])
    counting.add_argument("--fresh", type=lambda text: [int(n) for n in text.split(":")], default=[1000, 200])
    counting.add_argument("--source", action="append", choices=SOURCES)
    counting.add_argument("--jobs", type=int, default=os.cpu_count())
    counting.add_argument("--keep", help="draw the pages here and leave them")
    counting.set_defaults(run=count)
    writing = commands.add_parser("write")
    writing.add_argument("--calibration", nargs="+", required=True)
    writing.add_argument("--test", nargs="+", required=True)
    writing.set_defaults(run=write)
    a = parser.parse_args(arguments)
    a.run(a)


if __name__ == "__main__":
    main()
