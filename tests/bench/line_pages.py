#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""On how many pages of the corpus does each line of the importer run?

line_pages.py [--most N] [--least-lines N] [--under PATH] [--annotate DIR] [--jobs N] [--corpus DIR]

Builds detent-import with clang's block counters in build/line-pages, imports every page of the corpus once (real, rendered,
datasheets/ref, web, foreign, unexpected, and the cases of honesty/make.py; default quality, a refusal counts as well) and prints the
stretches of lines that ran on at most N pages (--most, default 1), with these pages. A rule that few pages reach is the first candidate
for removal (docs/develop/decisions/0508); what only other options reach (--quality precise, a given frame, tables) shows as 0 here.
--annotate writes every source with the number of pages before each line. Needs clang-14, llvm-symbolizer-14 and numpy.
"""
import argparse
import concurrent.futures as cf
import os
import re
import subprocess
import tempfile
from collections import defaultdict
from pathlib import Path

import ablate
import numpy as np

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build/line-pages"


def built() -> Path:
    BUILD.mkdir(parents=True, exist_ok=True)
    counting = BUILD / "line_pages.o"
    subprocess.run(["clang++-14", "-std=c++20", "-O1", "-c", str(ROOT / "tests/bench/line_pages.cpp"), "-o", str(counting)], check=True)
    subprocess.run(["cmake", "-S", str(ROOT), "-B", str(BUILD), "-G", "Ninja", "--log-level=WARNING", "--preset", "import",
                    "-DCMAKE_CXX_COMPILER=clang++-14", "-DCMAKE_POSITION_INDEPENDENT_CODE=OFF", "-DCMAKE_CXX_FLAGS_RELEASE=-DNDEBUG",
                    "-DCMAKE_CXX_FLAGS=-O1 -g1 -fsanitize-coverage=inline-8bit-counters,pc-table",
                    f"-DCMAKE_EXE_LINKER_FLAGS={counting} -no-pie"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", str(BUILD), "--parallel", str(os.cpu_count())], check=True, stdout=subprocess.DEVNULL)
    return BUILD / "bin/detent-import"


def pages_of(program: Path, corpus: Path, honesty: Path) -> list[tuple[str, list[str]]]:
    """(name, command line without the program) of every page."""
    pages = [(str(plot), [str(plot), *arguments]) for _, plot, arguments in ablate.items(program, corpus, 1, 0)]
    for folder in ("foreign", "unexpected"):
        pages += [(f"{folder}/{file.parent.name}", [str(file)]) for file in sorted((corpus / folder / "items").glob("*/plot.*"))]
    pages += [(f"honesty/{file.name}", [str(file)]) for file in sorted(honesty.iterdir()) if file.suffix not in (".csv", ".json")]
    return pages


def counted(program: Path, page: list[str], out: Path) -> None:
    out.mkdir()
    subprocess.run([str(program), *page, "--json", "-o", str(out / "result.json")], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL, timeout=300, env={**os.environ, "DETENT_LINE_PAGES": str(out)}, check=False)


def ran(out: Path, blocks: int) -> np.ndarray:
    """Which blocks ran on a page: the program and the processes it starts."""
    seen = np.zeros(blocks, bool)
    for file in out.glob("*.counters"):
        counters = np.fromfile(file, np.uint8)
        if len(counters) == blocks:
            seen |= counters > 0
    return seen


def lines_of(program: Path, addresses: np.ndarray) -> list[tuple[str, int] | None]:
    """File below the project's root and line of each block; the innermost function where several are one."""
    asked = "".join(f"{address:#x}\n" for address in addresses)
    said = subprocess.run(["llvm-symbolizer-14", f"--obj={program}"], input=asked, capture_output=True, text=True, check=True).stdout
    found: list[tuple[str, int] | None] = []
    for block in said.strip().split("\n\n"):
        own = [line.rsplit(":", 2) for line in block.split("\n")[1::2] if line.startswith(str(ROOT))]
        found.append((str(Path(own[0][0]).relative_to(ROOT)), int(own[0][1])) if own else None)
    return found


def stretches(pages_at: dict[int, set[str]], most: int) -> list[list[int]]:
    """Lines in a row that ran on at most `most` pages."""
    runs: list[list[int]] = []
    for line in sorted(pages_at):
        if len(pages_at[line]) > most:
            runs.append([])
        elif line > 0:
            if not runs:
                runs.append([])
            runs[-1].append(line)
    return [run for run in runs if run]


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    options.add_argument("--most", type=int, default=1)
    options.add_argument("--least-lines", type=int, default=4)
    options.add_argument("--under", default="importer/(frame|axes|trace|strokes|callouts|[a-z_]+[.]cpp)", help="regular expression of paths")
    options.add_argument("--annotate", type=Path)
    options.add_argument("--jobs", type=int, default=os.cpu_count())
    options.add_argument("--corpus", type=Path, default=ROOT.parent / "shared/corpus")
    given = options.parse_args()

    program = built()
    with tempfile.TemporaryDirectory() as scratch:
        honesty, outputs = Path(scratch) / "honesty", Path(scratch) / "out"
        honesty.mkdir(), outputs.mkdir()
        subprocess.run(["python3", str(given.corpus / "honesty/make.py"), str(honesty), "--seed", "1"], check=True, stdout=subprocess.DEVNULL)
        pages = pages_of(program, given.corpus, honesty)
        with cf.ThreadPoolExecutor(given.jobs) as pool:
            list(pool.map(lambda k: counted(program, pages[k][1], outputs / str(k)), range(len(pages))))
        addresses = np.fromfile(next(outputs.glob("*/addresses")), np.uintp)[::2]
        blocks = len(addresses)
        lines = lines_of(program, addresses)
        pages_at: dict[str, dict[int, set[str]]] = defaultdict(lambda: defaultdict(set))
        for where in filter(None, lines):
            pages_at[where[0]][where[1]] = set()
        for k, (name, _) in enumerate(pages):
            for block in np.flatnonzero(ran(outputs / str(k), blocks)):
                if where := lines[block]:
                    pages_at[where[0]][where[1]].add(name)

    print(f"{len(pages)} pages")
    for file in sorted(pages_at):
        source = (ROOT / file).read_text(encoding="utf-8").split("\n")
        if given.annotate:
            target = given.annotate / file
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text("".join(f"{len(pages_at[file][n]) if n in pages_at[file] else '':>5}| {line}\n" for n, line in enumerate(source, 1)))
        if not re.match(given.under, file):
            continue
        for run in stretches(pages_at[file], given.most):
            if run[-1] - run[0] + 1 >= given.least_lines:
                on = sorted(set().union(*(pages_at[file][n] for n in run)))
                print(f"{file}:{run[0]}-{run[-1]}  {source[run[0] - 1].strip()[:80]}  [{', '.join(on[:4])}]")


if __name__ == "__main__":
    main()
