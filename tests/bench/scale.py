#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What thousands of pages cost: the figures of docs/guide/scale.md.

    /usr/bin/python3 tests/bench/scale.py pages NAME=GLOB... [--build FOLDER]
    /usr/bin/python3 tests/bench/scale.py cluster [--pages N] [--batches M] [--kind svg|log] [--profile local|slurm] [--kill] [--build FOLDER]

pages: each file alone by `detent-import --batch`: processor seconds, memory, bytes written; quartiles, and what a million such files would take.
cluster: N drawn pages in M batches by samples/cluster/Snakefile against one `detent-import --batch` of the same list: whether the reports are
equal, wall time, processor time, and for how long slots had no batch (start, between batches, end), which other work on the machine makes longer, never shorter. --kill: Snakemake, a batch and a page's process are killed (kill -9) on the way, and it is run again. slurm: one node, set up
as tests/samples/cluster_test.py does, as root.
"""

import argparse
import glob
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests/samples"))
import cluster_test  # noqa: E402

A_MILLION = 1_000_000
SUFFIX = {"svg": ".svg", "log": ".csv"}


# ---- pages

def alone(program, path):
    """Processor seconds, MB at most, bytes of results and of the report, of one file."""
    with tempfile.TemporaryDirectory() as folder:
        process = subprocess.Popen([program, "--batch", path, "--out-dir", folder, "--jobs", "1"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   env={**os.environ, "OMP_THREAD_LIMIT": "1"})
        _, _, used = os.wait4(process.pid, 0)
        sizes = {file.name: file.stat().st_size for file in Path(folder).iterdir()}
        overlay = sum(size for name, size in sizes.items() if name.endswith(".overlay.png"))
        return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024, sum(sizes.values()) - overlay, overlay


def at(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))]


def pages(program, kinds):
    print("| files | number | processor, s: median | mean | 95 % | memory, MB: median | most | kB a file | of these pictures | a million: CPU hours | TB |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for kind in kinds:
        name, pattern = kind.split("=", 1)
        files = sorted(path for path in glob.glob(pattern, recursive=True) if os.path.isfile(path))
        if not files:
            sys.exit(f"scale.py: no file is named {pattern}.")
        seconds, memory, small, pictures = zip(*(alone(program, path) for path in files))
        mean, kB = sum(seconds) / len(files), sum(small + pictures) / len(files) / 1000
        print(f"| {name} | {len(files)} | {at(seconds, 0.5):.2f} | {mean:.2f} | {at(seconds, 0.95):.2f} | {at(memory, 0.5):.0f} | {max(memory):.0f} | {kB:.0f} | "
              f"{sum(pictures) / len(files) / 1000:.0f} | {mean * A_MILLION / 3600:.0f} | {kB * 1000 * A_MILLION / 1e12:.2f} |", flush=True)


# ---- a cluster

def draw(build, folder, count, kind):
    """Pages of buttons that differ: graphs as SVG, or logs of a force meter."""
    sys.path.insert(0, str(build / "python"))
    import detent
    names = ["B", "C", "D", "E", "F"]
    samples = [detent.load(ROOT / f"samples/buttons/{name}.button.json") for name in names]
    log = (ROOT / "samples/plots/force-meter-log.csv").read_text()
    for number in range(count):
        factor = 0.7 + 0.6 * (number // len(samples)) / max(1, count // len(samples))
        target = folder / f"page-{number:05}{SUFFIX[kind]}"
        if kind == "log":
            target.write_text(log + "\n" * (number % 997))
        else:
            target.write_text(samples[number % len(samples)].edited(detent.edits.scale_force(factor), detent.edits.scale_travel(2 - factor)).svg())


TIMED = """#!/bin/sh
case " $* " in *" --batch "*) ;; *) exec {program} "$@" ;; esac
begun=$(date +%s.%N)
{program} "$@"
code=$?
echo "$begun $(date +%s.%N)" >> {times}
exit $code
"""


def slots_idle_s(times, begun, ended, slots):
    """Seconds in which a slot had no batch, of all slots together."""
    busy = sum(min(ended, float(last)) - max(begun, float(first)) for first, last in (line.split() for line in times.read_text().splitlines()))
    return slots * (ended - begun) - busy


class Run(cluster_test.OneNode):
    """The rig of the tests, with pages and batches of this run."""

    def runTest(self):
        pass

    def prepare(self, arguments, build):
        cluster_test.ROOT, cluster_test.BIN = ROOT, build / "bin"
        self.PROFILE = arguments.profile
        self.size = -(-arguments.pages // arguments.batches)
        if arguments.profile == "slurm":
            self.setUp()
        else:
            cluster_test.Cluster.setUp(self)
        shutil.rmtree(self.folder / "pages")
        (self.folder / "pages").mkdir()
        draw(build, self.folder / "pages", arguments.pages, arguments.kind)
        self.times = self.folder / "times"
        self.timed = self.folder / "timed-import"
        self.timed.write_text(TIMED.format(program=build / "bin/detent-import", times=self.times))
        self.timed.chmod(0o755)

    def environment(self):
        return super().environment() if self.PROFILE == "slurm" else cluster_test.Cluster.environment(self)

    def command(self, *more):
        words = [str(word) for word in super().command(*more)]
        own = {"batch": f"batch={self.size}", "program": f"program={self.timed}"}
        return [own.get(word.split("=")[0], word) for word in words if not word.startswith("options=")]


def used_s():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def killed(run, arguments):
    """Starts it and kills Snakemake, and a batch of the next start, each after a third of what was left; unlocks."""
    for what in ("snakemake", "batch"):
        done = run.handled() if (run.folder / "out/batches").is_dir() else 0
        process = run.begin()
        cluster_test.until(lambda: (run.folder / "out/batches").is_dir() and run.handled() > done + (arguments.pages - done) / 3, "a third done")
        if what == "snakemake":
            process.send_signal(signal.SIGKILL)
            process.wait()
            time.sleep(2)
            run.snakemake("--unlock")
        else:
            batches = cluster_test.children_of(process.pid, "detent-import")
            job = run.told("squeue", "--noheader", "--states=RUNNING", "--format=%A").split() if run.PROFILE == "slurm" else []
            if job:
                run.told("scancel", "--signal=KILL", "--full", job[0])
            elif batches:
                os.kill(random.choice(batches), signal.SIGKILL)
            process.wait()


def cluster(arguments, build):
    run = Run()
    cluster_test.LONGEST_WAIT_s = 36000
    run.prepare(arguments, build)
    try:
        names = sorted(str(path.relative_to(run.folder)) for path in (run.folder / "pages").iterdir())
        (run.folder / "list").write_text("\n".join(names) + "\n")
        slots = os.cpu_count()
        begun, used = time.perf_counter(), used_s()
        subprocess.run([build / "bin/detent-import", "--batch", "@list", "--out-dir", "serial", "--jobs", str(slots)], cwd=run.folder, check=True, capture_output=True,
                       env={**os.environ, "OMP_THREAD_LIMIT": "1"})
        alone_s, alone_cpu_s = time.perf_counter() - begun, used_s() - used
        begun, used = time.perf_counter(), used_s()
        if arguments.kill:
            killed(run, arguments)
        first_s = time.time()
        run.snakemake()
        idle_s = slots_idle_s(run.times, first_s, time.time(), slots)
        took_s, cpu_s = time.perf_counter() - begun, used_s() - used
        equal = cluster_test.graphs(run.folder / "out/all.jsonl") == cluster_test.graphs(run.folder / "serial/report.jsonl")
        print(f"{arguments.pages} pages ({arguments.kind}), {arguments.batches} batches, {arguments.profile}{', killed twice' if arguments.kill else ''}, {slots} slots: "
              f"report {'equal' if equal else 'NOT EQUAL'}; {took_s:.1f} s; --batch alone {alone_s:.1f} s, processor {alone_cpu_s:.1f} s; over it {100 * (took_s / alone_s - 1):+.1f} % of time"
              f"; slots without a batch for {idle_s:.1f} s in all{' of the last start' if arguments.kill else ''}"
              + (f", {100 * (cpu_s / alone_cpu_s - 1):+.1f} % of processor time" if arguments.profile == "local" else ""))  # Slurm's jobs are no children
        return 0 if equal else 1
    finally:
        run.doCleanups()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", type=Path, default=ROOT / "build/release")
    what = parser.add_subparsers(dest="what", required=True)
    of_pages = what.add_parser("pages")
    of_pages.add_argument("kinds", nargs="+")
    of_cluster = what.add_parser("cluster")
    of_cluster.add_argument("--pages", type=int, default=2000)
    of_cluster.add_argument("--batches", type=int, default=8)
    of_cluster.add_argument("--kind", choices=SUFFIX, default="svg")
    of_cluster.add_argument("--profile", choices=("local", "slurm"), default="local")
    of_cluster.add_argument("--kill", action="store_true")
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    if arguments.what == "pages":
        pages(build / "bin/detent-import", arguments.kinds)
        return 0
    return cluster(arguments, build)


if __name__ == "__main__":
    sys.exit(main())
