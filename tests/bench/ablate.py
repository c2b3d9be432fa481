#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is each threshold of the importer worth? Changes every one of a step, alone, over plots with known truth.

ablate.py STEP... [--screen] [--together] [--bare] [--only TEXT] [--nothing FILE] [--every N] [--from K] [--factor F] [--jobs N] [--corpus DIR] [--list]

STEP: a folder of importer/ ("frame", "axes", "trace", "fit", ...) or "." for what lies in importer/ itself. A copy of the sources is
built in build/ablation in which each threshold of these steps takes its value from the environment: named constants (`constexpr double kReach = 0.3;`) and
defaults of options, with --bare also decimal fractions that stand in expressions. What the language wants
to know while it compiles (array sizes) stays as it is. Each threshold is tried at VALUE / F and VALUE * F (default 2) on every N-th item
(default 6; from the K-th on) of real, rendered, datasheets/ref and web of the corpus (default: ../shared/corpus beside the checkout).

Table: items no longer imported, items newly imported (of pages that are no force graph: "lies"), items traced worse / better by
more than a tenth (and 0.005 % of span), largest change of a confidence, mean trace distance over the items that both import.
--screen stops at the first item on which anything at all is different, and names it. What is left as "nothing" may be a guard against pages that
were not among the items: --nothing FILE takes only those of such a run, for other items, and --together changes those of one source file at
once. What nothing ever asked for goes.
"""
import argparse, concurrent.futures as cf, functools, json, os, re, shutil, statistics, subprocess, sys, tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build/ablation"
NUMBER = r"-?\d[\d']*(?:\.\d+)?(?:[eE][+-]?\d+)?"
TYPES = {"double": "double", "float": "float", "int": "int"}
CONSTANT = re.compile(r"(?P<head>(?:(?:inline|static) )*)constexpr (?P<type>[\w:]+) (?P<rest>[^;(){}]*=[^;{}]*);")
MEMBER = re.compile(r"(?<=[\n ;{])(?P<type>double|float|int) (?P<name>\w+) = (?P<value>" + NUMBER + r")(?P<suffix>F?);")
DECLARATOR = re.compile(r"(?P<name>\w+)(?P<equals>\s*=\s*)(?P<value>" + NUMBER + r")F?(?=\s*(?:,|$))")
FRACTION = re.compile(r"(?<![\w.\"])(?P<value>\d+\.\d+(?:[eE][+-]?\d+)?)(?P<suffix>F?)(?![\w.])")
APART = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])'|^#[^\n]*", re.S | re.M)


def blanked(text):
    """`text` with comments, strings and directives as blanks, so that places stay the same."""
    return APART.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)


def options_around(plain, place):
    """Whether `place` stands directly in a struct of options or limits: what a step is told, not what it found."""
    opened = list(re.finditer(r"struct (\w+)[^;{}]*\{", plain[:place]))
    return bool(opened) and re.search(r"(Options|Limits)$", opened[-1][1]) is not None and "}" not in plain[opened[-1].end() : place]


class Source:
    """One file and the places in it where a threshold stands."""

    def __init__(self, path, bare, text=None):
        self.path, self.name = path, path.relative_to(ROOT / "importer").as_posix()
        self.text = path.read_text(encoding="utf-8") if text is None else text
        self.edits, self.values = {}, {}  # (first, last) -> (threshold or None, new text); threshold -> value
        plain = blanked(self.text)
        taken = []
        for m in CONSTANT.finditer(plain):
            taken.append(m.span())
            self.edits[m.start(), m.start("rest")] = (None, f"{m['head']}{'inline ' if path.suffix == '.h' and 'static' in m['head'] and 'inline' not in m['head'] else ''}const {m['type']} ")
            if m["type"] in TYPES:
                for d in DECLARATOR.finditer(m["rest"]):
                    self.place(d["name"], m["type"], d["value"], m.start("rest") + d.start("value"), m.start("rest") + d.end())
        for m in MEMBER.finditer(plain):
            if options_around(plain, m.start()) and not any(a <= m.start() < b for a, b in taken):
                taken.append(m.span())
                self.place(m["name"], m["type"], m["value"], m.start("value"), m.end("suffix"))
        if bare:
            for m in FRACTION.finditer(plain):
                if float(m["value"]) not in (0, 1, 2) and not any(a <= m.start() < b for a, b in taken):
                    line = plain.count("\n", 0, m.start()) + 1
                    self.place(f"{line}:{m['value']}", "float" if m["suffix"] else "double", m["value"], m.start(), m.end())

    def place(self, name, kind, value, first, last):
        value = value.replace("'", "")
        threshold, n = f"{self.name}:{name}", 1
        while threshold in self.values:
            n += 1
            threshold = f"{self.name}:{name}#{n}"
        if float(value) == 0:
            return
        self.values[threshold] = int(value) if kind == "int" else float(value)
        self.edits[first, last] = (threshold, f'DETENT_TUNED({kind}, "{threshold}", {value})')

    def rewritten(self, fixed):
        """The text with thresholds from the environment, but for those in `fixed`; a `constexpr` stays one where nothing in it changes."""
        out, at = [], 0
        for (first, last), (threshold, new) in sorted(self.edits.items()):
            if threshold in fixed or (threshold is None and (self.name, self.text.count("\n", 0, first) + 1) in fixed):
                continue
            out += [self.text[at:first], new]
            at = last
        return "".join(out) + self.text[at:]


def refused(log, sources):
    """What a failed build names: thresholds by name, and the whole of each line that it complains about."""
    fixed, names = set(), set(re.findall(r"[‘'](?:\w+::)*(?:\(anonymous namespace\)::|\{anonymous\}::)?(\w+)[’'] is not usable in a constant expression", log))
    names |= set(re.findall(r"the value of [‘'](?:[^’']*::)?(\w+)[’']", log))
    lines = {(Path(f).as_posix(), int(n)) for f, n in re.findall(r"source/importer/([\w./-]+):(\d+):\d+: (?:error|note)", log)}
    for source in sources:
        for (first, last), (threshold, _) in source.edits.items():
            line = source.text.count("\n", 0, first) + 1
            if (source.name, line) in lines or (threshold and threshold.split(":")[1].split("#")[0] in names):
                fixed.add(threshold if threshold else (source.name, line))
            elif threshold is None and any(re.match(rf"{n}\b", source.text[last:]) for n in names):
                fixed.add((source.name, line))
    return fixed


def built(sources, jobs):
    """Builds the copy; returns its detent-import and the thresholds that can be changed."""
    copy = BUILD / "source"
    copy.mkdir(parents=True, exist_ok=True)
    for name in subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines():
        to = copy / name
        if (ROOT / name).is_file() and not (to.exists() and to.read_bytes() == (ROOT / name).read_bytes()):
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, to)
    flags = f"-include {ROOT}/tests/bench/tuned.h"
    subprocess.run(["cmake", "--preset", "import", "-S", str(copy), "-B", str(BUILD / "build"), "-DDETENT_PRECOMPILE=OFF", "-DDETENT_WERROR=OFF",
                    f"-DCMAKE_CXX_FLAGS={flags}", "--log-level=ERROR"], cwd=copy, stdout=subprocess.DEVNULL, check=True)
    fixed = set()
    for attempt in range(12):
        for source in sources:
            to, text = copy / "importer" / source.name, source.rewritten(fixed)
            if to.read_text(encoding="utf-8") != text:
                to.write_text(text, encoding="utf-8")
        made = subprocess.run(["cmake", "--build", str(BUILD / "build"), "--parallel", str(jobs), "--target", "detent-import", "--", "-k", "0"],
                              capture_output=True, text=True, env={**os.environ, "LC_ALL": "C.UTF-8"})
        if made.returncode == 0:
            break
        more = refused(made.stdout + made.stderr, sources) - fixed
        if not more:
            sys.exit("ablate.py: the copy does not compile, and nothing in it is known to be the reason:\n" + made.stdout[-4000:])
        fixed |= more
    else:
        sys.exit(f"ablate.py: the copy in {copy} does not compile after {attempt + 1} attempts; build it by hand to see why.")
    program = next(p for p in (BUILD / "build").rglob("detent-import") if p.is_file())
    return program, {k: v for source in sources for k, v in source.values.items() if k not in fixed}


def items(program, corpus, every, first):
    sys.path.insert(0, str(corpus))
    from evaluate_tools import pick_graph

    for folder in ("real", "rendered", "datasheets/ref"):
        kept = [p for p in sorted((corpus / folder).iterdir()) if (p / "meta.json").exists()]
        single = [(p, m) for p, m in ((p, json.loads((p / "meta.json").read_text())) for p in kept) if m.get("class") != "multi"]
        for item, meta in single[first::every]:
            plot = meta.get("input") or next(q.name for q in sorted(item.iterdir()) if q.stem == "plot")
            arguments = ["--page", str(meta["import_page"])] if meta.get("import_page") else []
            yield item, item / plot, arguments + (pick_graph(str(program), item / plot, meta, 120) if meta.get("frame_pt") else [])
    web = corpus / "web"
    for catalogue in ("catalog.json", "negatives.json"):
        kept = json.loads((web / catalogue).read_text()) if (web / catalogue).exists() else []
        for entry in kept[first::every]:
            name = entry.get("file") or entry["pdf"]
            plot = next((p for p in (web / "img" / name, web / "pdf" / name, web / name) if p.exists()), None)
            if plot:
                yield catalogue == "negatives.json", plot, ["--page", str(entry.get("page", 1))]


class Outcome:
    """What one import came to."""

    def __init__(self, program, item, tuned, corpus):
        truth, plot, arguments = item
        self.name = truth.name if isinstance(truth, Path) else plot.name
        with tempfile.TemporaryDirectory() as tmp:
            out = Path(tmp) / "trace.csv"
            command = [program, str(plot.resolve()), "--json", "--trace-csv", str(out), *arguments]
            try:
                done = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=120, env={**os.environ, "DETENT_TUNED": tuned})
                self.code, self.confidence = done.returncode, max([0.0] + [float(c) for c in re.findall(r'"confidence": ([\d.]+)', done.stdout)[:1]])
            except subprocess.TimeoutExpired:
                self.code, self.confidence = -1, 0.0
            self.trace = out.read_text() if out.exists() else ""
        self.imported, self.must_refuse = self.code == 0, truth is True
        self.truth, self.scorer = (truth / "truth.csv" if isinstance(truth, Path) else None), corpus / "score.py"

    @functools.cached_property
    def distance(self):
        """Mean of the traced strokes from the truth as a share of the span; None: not imported, or no truth."""
        if not (self.trace and self.truth):
            return None
        with tempfile.NamedTemporaryFile("w", suffix=".csv") as traced:
            traced.write(self.trace), traced.flush()
            scored = subprocess.run([sys.executable, str(self.scorer), str(self.truth), traced.name], capture_output=True, text=True)
        try:
            score = json.loads(scored.stdout.strip().splitlines()[-1])
        except (IndexError, ValueError):
            return None
        parts = [score[k] for k in ("press_dist_mean", "release_dist_mean") if score.get(k) is not None]
        return statistics.mean(parts) if parts else None

    def __eq__(self, other):
        return (self.code, self.trace) == (other.code, other.trace) and abs(self.confidence - other.confidence) < 1e-3


def compared(standard, changed):
    pairs = list(zip(standard, changed))
    both = [(a.distance, b.distance) for a, b in pairs if a.distance is not None and b.distance is not None]
    lost, won = sum(a.imported and not b.imported for a, b in pairs), sum(b.imported and not a.imported for a, b in pairs)
    lies = sum(b.imported and not a.imported and a.must_refuse for a, b in pairs)
    worse, better = sum(b > 1.1 * a + 5e-5 for a, b in both), sum(a > 1.1 * b + 5e-5 for a, b in both)
    surer = max((abs(a.confidence - b.confidence) for a, b in pairs), default=0)
    means = [100 * statistics.mean(side) for side in zip(*both)] if both else [0, 0]
    same = all(a == b for a, b in pairs)
    return f"{lost:5} {won:4} {lies:4} {worse:5} {better:6} {surer:6.3f}   {means[0]:.4f} -> {means[1]:.4f}{'   nothing' if same else ''}"


def scaled(value, factor):
    """A count stays one, and above zero."""
    return max(1, round(value * factor)) if isinstance(value, int) and value > 0 else value * factor


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("step", nargs="+"), parser.add_argument("--only", default=""), parser.add_argument("--list", action="store_true"), parser.add_argument("--nothing", type=Path), parser.add_argument("--together", action="store_true")
    parser.add_argument("--from", dest="first", type=int, default=0)
    parser.add_argument("--screen", action="store_true"), parser.add_argument("--bare", action="store_true")
    parser.add_argument("--corpus", type=Path, default=ROOT.parent / "shared/corpus"), parser.add_argument("--every", type=int, default=6)
    parser.add_argument("--factor", type=float, default=2), parser.add_argument("--jobs", type=int, default=1)
    a = parser.parse_args()
    sources = []
    for step in a.step:
        folder = ROOT / "importer" / step
        if not folder.is_dir():
            sys.exit(f"ablate.py: importer/ has no folder '{step}'; steps are its folders, and '.' what lies beside them.")
        sources += [Source(p, a.bare) for p in sorted(folder.glob("*") if step == "." else folder.rglob("*")) if p.suffix in (".cpp", ".h")]
    if a.list:
        print("\n".join(f"{k} {v:g}" for s in sources for k, v in s.values.items() if a.only in k))
        return
    program, values = built(sources, max(a.jobs, os.cpu_count() or 1))
    left = [line.split()[0] for line in a.nothing.read_text().splitlines() if line.endswith("nothing")] if a.nothing else values
    chosen = {k: v for k, v in values.items() if a.only in k and k in left}
    if not chosen:
        sys.exit(f"ablate.py: no threshold of {', '.join(a.step)} has '{a.only}' in its name; --list shows them.")
    plots = list(items(program, a.corpus.resolve(), a.every, a.first))
    with cf.ThreadPoolExecutor(a.jobs) as pool:
        standard = list(pool.map(lambda item: Outcome(program, item, "", a.corpus), plots))
        print(f"{len(plots)} items, {sum(o.imported for o in standard)} imported; {len(chosen)} thresholds", flush=True)
        if a.screen:
            groups = {}
            for threshold in chosen:
                groups.setdefault(threshold.split(":")[0] if a.together else threshold, []).append(threshold)

            def first_change(group):
                for item, usual in zip(plots, standard):
                    for factor in (1 / a.factor, a.factor):
                        tuned = ",".join(f"{t}={scaled(chosen[t], factor)!r}" for t in groups[group])
                        if not Outcome(program, item, tuned, a.corpus) == usual:
                            return group, f"times {factor:g}: {usual.name}"
                return group, "nothing"
            for group, what in pool.map(first_change, groups):
                print(f"{group:58} {chosen[groups[group][0]] if not a.together else len(groups[group]):8g}   {what}", flush=True)
            return
        print(f"{'threshold':58} {'value':>8} {'tried':>8}  lost  won lies worse better  surer   mean % (standard -> tried)")
        for threshold, value in chosen.items():
            for other in (scaled(value, 1 / a.factor), scaled(value, a.factor)):
                changed = list(pool.map(lambda item: Outcome(program, item, f"{threshold}={other!r}", a.corpus), plots))
                print(f"{threshold:58} {value:8g} {other:8g} {compared(standard, changed)}", flush=True)


if __name__ == "__main__":
    main()
