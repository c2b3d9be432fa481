#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Workflow engines that are disturbed: python3 tests/bench/disturb.py [--pages N] [--build FOLDER] [--engine NAME...]

N drawn pages (one in 16 SVG, the rest logs of a force meter) are read by Snakemake on Slurm, Snakemake alone, GNU parallel and `detent-import
--batch --resume`, one after the other in the same folder of pages. Each disturbance first replaces pages by others, older than all results,
so that there is work; after it the engine runs until it is content, and its merged report is compared line by line with a serial run.
Slurm: one node, set up as tests/samples/cluster_test.py does, as root.
"""

import argparse
import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import scale

cluster_test = scale.cluster_test
until = cluster_test.until
LISTS = 10
LONG_AGO_s = 1e9
AWAY_s = 15  # longer than Slurm's programs ask for (MessageTimeout=2)


def scaled_log(log, factor):
    return re.sub(r"^(\d+,[^,]*,)(-?[\d.]+)", lambda row: f"{row[1]}{float(row[2]) * factor:.4f}", log, flags=re.M)


def as_written(name):
    """A name as a report has it: bytes that are no UTF-8 are replaced."""
    return os.fsencode(name).decode(errors="replace")


class Pages:
    """The pages on disk, and what a serial run makes of each content."""

    def __init__(self, folder, build, count):
        sys.path.insert(0, str(build / "python"))
        import detent
        self.edits, self.samples = detent.edits, [detent.load(scale.ROOT / f"samples/buttons/{name}.button.json") for name in "BCDEF"]
        self.log = (scale.ROOT / "samples/plots/force-meter-log.csv").read_text()
        self.folder, self.program, self.drawn, self.truth = folder, build / "bin/detent-import", 0, {}
        (folder / "pages").mkdir()
        for number in range(count):
            self.write(f"page-{number:04}{'.csv' if number % 16 else '.svg'}")

    def write(self, name, age_s=None):
        """A page with numbers that no page had before."""
        self.drawn += 1
        factor = 0.6 + 0.0005 * self.drawn
        path = self.folder / "pages" / name
        if name.endswith(".svg"):
            button = self.samples[self.drawn % len(self.samples)].edited(self.edits.scale_force(2 - factor), self.edits.scale_travel(factor))
            path.write_text(button.svg())
        else:
            path.write_text(scaled_log(self.log, factor))
        if age_s:
            os.utime(path, (age_s, age_s))

    def names(self):
        return sorted(os.listdir(self.folder / "pages"))

    def replace(self, every=16, phase=0):
        for name in self.names()[phase % every::every]:
            self.write(name, LONG_AGO_s)

    def serial(self, names, out):
        """Reports of names, page by page."""
        (self.folder / "serial.list").write_text("".join(f"pages/{name}\n" for name in names), errors="surrogateescape")
        subprocess.run([self.program, "--batch", "@serial.list", "--out-dir", out, "--quality", "draft", "--jobs", "1"], cwd=self.folder, check=False,
                       capture_output=True, env={**os.environ, "OMP_THREAD_LIMIT": "1"})
        return cluster_test.graphs(self.folder / out / "report.jsonl")

    def expected(self):
        """What a serial run reports, put together from serial runs of the contents."""
        digest = {name: hashlib.sha256((self.folder / "pages" / name).read_bytes()).hexdigest() for name in self.names()}
        unseen = [name for name in self.names() if digest[name] not in self.truth]
        for name in unseen:
            self.truth[digest[name]] = []
        if unseen:
            written = {as_written(name): digest[name] for name in unseen}
            for graph in self.serial(unseen, "unseen"):
                self.truth[written[graph["input"].removeprefix("pages/")]].append(graph)
            shutil.rmtree(self.folder / "unseen")
        return [{**graph, "input": f"pages/{as_written(name)}"} for name in self.names() for graph in self.truth[digest[name]]]


def page_at_work(folder):
    """The process of a page: below a batch of that folder."""
    def its(pid):
        try:
            return os.readlink(f"/proc/{pid}/cwd") == str(folder)
        except OSError:
            return False

    batches = [pid for pid in cluster_test.children_of(1, "detent-import") if its(pid)]
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            words = stat.read_text().rsplit(")", 1)
            if words[0].endswith("(detent-import") and int(words[1].split()[1]) in batches:
                return int(stat.parent.name)
        except (OSError, ValueError):
            continue
    return 0


class Snakemake(scale.Run):
    def __init__(self, profile, pages, build):
        super().__init__()
        cluster_test.ROOT, cluster_test.BIN = scale.ROOT, build / "bin"
        cluster_test.LONGEST_WAIT_s = 1800
        self.PROFILE, self.pages = profile, pages
        (cluster_test.OneNode if profile == "slurm" else cluster_test.Cluster).setUp(self)
        shutil.rmtree(self.folder)
        self.folder, self.out = pages.folder, f"out-{profile}"

    def command(self, *more):
        size = -(-len(self.pages.names()) // LISTS)
        own = {"batch": f"batch={size}", "out": f"out={self.out}"}
        return [own.get(word.split("=")[0], word) for word in map(str, cluster_test.Cluster.command(self, *more))]

    def content(self):
        """Runs it as a user does who repeats the command until it ends well."""
        for _ in range(3):
            subprocess.run(self.command("--unlock"), cwd=self.folder, env=self.environment(), capture_output=True, check=False)
            ran = subprocess.run(self.command(), cwd=self.folder, env=self.environment(), capture_output=True, text=True, check=False)
            if ran.returncode == 0:
                return
        raise AssertionError(ran.stderr[-2000:])

    def report(self):
        return self.folder / self.out / "all.jsonl"

    def at_work(self, process):
        if self.PROFILE == "slurm":
            until(lambda: self.running_jobs() or process.poll() is not None, "a job running")
        else:
            until(lambda: cluster_test.children_of(process.pid, "detent-import") or process.poll() is not None, "a batch running")

    def disturbed(self, what):
        process = self.begin()
        self.at_work(process)
        what(process)
        process.wait()

    def kill_engine(self, number=signal.SIGKILL):
        self.disturbed(lambda process: process.send_signal(number))

    def kill_job(self):
        self.disturbed(lambda process: [self.told("scancel", "--signal=KILL", "--full", job) for job in self.running_jobs()[:1]])

    def kill_batch(self):
        self.disturbed(lambda process: cluster_test.kill_one(process.pid, "detent-import"))

    def kill_page(self):
        def kill(process):
            until(lambda: page_at_work(self.folder) or process.poll() is not None, "a page at work")
            page = page_at_work(self.folder)
            if page:
                os.kill(page, signal.SIGKILL)
        self.disturbed(kill)

    def lose_controller(self, number):
        def lose(process):
            self.controller.send_signal(number)
            self.controller.wait()
            time.sleep(AWAY_s)
            self.controller = self.slurm_daemon("slurmctld")
            until(lambda: "idle" not in self.told("sinfo", "--noheader", "--format=%T") or process.poll() is not None, "the controller back")
            time.sleep(AWAY_s)
            self.release()
        self.disturbed(lose)

    def release(self):
        """What its messages ask of the administrator. Slurm drains a node that has a job of which a killed controller remembers no launch, and holds the job."""
        if "drain" in self.told("sinfo", "--noheader", "--format=%T"):
            self.told("scontrol", "update", f"nodename={self.host}", "state=resume")
        for job in self.told("squeue", "--noheader", "--states=PENDING", "--format=%A %r").splitlines():
            if "held" in job:
                self.told("scontrol", "release", job.split()[0])

    def lose_node(self):
        def lose(process):
            self.node.kill()
            self.node.wait()
            time.sleep(AWAY_s)
            self.node = self.slurm_daemon("slurmd", "-N", self.host)
        self.disturbed(lose)

    def slurm_daemon(self, name, *more):
        process = super().slurm_daemon(name, *more)
        if name == "slurmd":
            self.node = process
        return process

    def hold_job(self):
        def hold(process):
            until(lambda: self.told("squeue", "--noheader", "--states=PENDING", "--format=%A").split() or process.poll() is not None, "a job waiting")
            for job in self.told("squeue", "--noheader", "--states=PENDING", "--format=%A").split()[:1]:
                self.told("scontrol", "hold", job)
                time.sleep(AWAY_s)
                self.told("scontrol", "release", job)
        self.disturbed(hold)

    def forget(self):
        shutil.rmtree(self.folder / ".snakemake")


ODD = ["log {3f2504e0}.csv", "#it's $HOME 100%.csv", "[1]*, -ü.csv", "-dash.csv", "@at.csv", " space.csv", "{batch}.csv", "semi;colon&.csv", "\"quoted\".csv",
       "back\\slash.csv", "\udcff not UTF-8.csv"]


def rename_oddly(pages):
    for old, new in zip([name for name in pages.names() if re.fullmatch(r"page-\d*[13579]\.csv", name)][3::17], ODD):
        os.rename(pages.folder / "pages" / old, pages.folder / "pages" / new)


def swap(pages):
    """Two pages exchange their names: nothing is new but the order."""
    first, second = (pages.folder / "pages" / name for name in [name for name in pages.names() if name.endswith(".csv")][10:12])
    between = pages.folder / "between"
    first.rename(between)
    second.rename(first)
    between.rename(second)


def add_and_remove(pages):
    pages.write("a first page.csv", LONG_AGO_s)
    (pages.folder / "pages" / pages.names()[len(pages.names()) // 3]).unlink()


def replace_by_same_size(pages):
    for name in [name for name in pages.names() if name.endswith(".csv")][7::31]:
        path = pages.folder / "pages" / name
        text = path.read_text()
        path.write_text(text.replace("35.7", "35.6", 1).replace("simulated", "stimulate"))
        os.utime(path, (LONG_AGO_s, LONG_AGO_s))


class Recipe:
    """The recipe for GNU parallel in docs/guide/scale.md."""

    def __init__(self, pages, build):
        self.pages, self.folder, self.bin = pages, pages.folder, build / "bin"
        text = (scale.ROOT / "docs/guide/scale.md").read_text()
        recipe = re.search(r"^```sh\n(parallel .*?)^```$", text, re.S | re.M)[1]
        self.read, self.merge = recipe.replace("--resume", "--resume --quality draft").strip().split("\n")
        (self.folder / "lists").mkdir()
        names = pages.names()
        size = -(-len(names) // LISTS)
        for number in range(LISTS):
            self.write_list(f"list {number}", names[number * size:(number + 1) * size])

    def write_list(self, list_name, names):
        (self.folder / f"lists/{list_name}.txt").write_text("".join(f"./pages/{name}\n" for name in names), errors="surrogateescape")

    def lists(self):
        return {path: path.read_text(errors="surrogateescape").splitlines() for path in sorted((self.folder / "lists").iterdir())}

    def follow(self):
        """Lists name the pages there are: renamed ones stay in place, gone ones leave, new ones make a list between old ones."""
        there = {f"./pages/{name}" for name in self.pages.names()}
        listed = {name for names in self.lists().values() for name in names}
        for path, names in self.lists().items():
            kept = [name for name in names if name in there]
            if kept != names:
                path.write_text("".join(f"{name}\n" for name in kept), errors="surrogateescape")
        new = sorted(there - listed)
        if new:
            self.write_list(f"list {len(self.lists()) // 2} and {len(self.lists())}", [name.removeprefix("./pages/") for name in new])

    def environment(self):
        return {**os.environ, "PATH": f"{self.bin}:/usr/bin:/bin", "HOME": str(self.folder)}

    def run(self, line, **more):
        return subprocess.Popen(["bash", "-c", line], cwd=self.folder, env=self.environment(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True, **more)

    def content(self):
        self.follow()
        for _ in range(3):
            if self.run(self.read).wait() == 0:
                break
        assert self.run(self.merge).wait() == 0

    def report(self):
        return self.folder / "all.jsonl"

    def disturbed(self, what):
        self.follow()
        process = self.run(self.read)
        until(lambda: cluster_test.children_of(process.pid, "detent-import") or process.poll() is not None, "a list read")
        what(process)
        process.wait()
        until(lambda: not [path for path in Path("/proc").glob("[0-9]*/cmdline") if self.at_work(path)], "the batches left behind ended")

    def at_work(self, path):
        try:
            words = path.read_bytes().split(b"\0")
            return any(word.startswith(b"@lists/") for word in words) and os.readlink(path.parent / "cwd") == str(self.folder)
        except OSError:
            return False

    def kill_engine(self, number=signal.SIGKILL):
        self.disturbed(lambda process: os.killpg(process.pid, number))

    def kill_engine_alone(self):
        def kill(process):
            for stat in Path("/proc").glob("[0-9]*/stat"):
                try:
                    words = stat.read_text().rsplit(")", 1)
                    if words[0].endswith("(perl") and int(words[1].split()[1]) in (process.pid, os.getpid()):
                        os.kill(int(stat.parent.name), signal.SIGKILL)
                except (OSError, ValueError):
                    continue
        self.disturbed(kill)

    def kill_batch(self):
        self.disturbed(lambda process: cluster_test.kill_one(process.pid, "detent-import"))

    def expected(self, whole):
        by_page = {}
        for graph in whole:
            by_page.setdefault("./" + graph["input"], []).append(graph)
        return [{**graph, "input": as_written(page)} for names in self.lists().values() for page in names for graph in by_page[as_written(page)]]


class Alone(Recipe):
    """detent-import --batch @list --resume, without an engine."""

    def __init__(self, pages, build):
        self.pages, self.folder, self.bin = pages, pages.folder, build / "bin"
        self.read = "OMP_THREAD_LIMIT=1 exec detent-import --batch @alone.list --out-dir alone --resume --quality draft --jobs 2"
        self.merge = "true"

    def follow(self):
        (self.folder / "alone.list").write_text("".join(f"pages/{name}\n" for name in self.pages.names()), errors="surrogateescape")

    def report(self):
        return self.folder / "alone/report.jsonl"

    def expected(self, whole):
        return whole

    def disturbed(self, what):
        self.follow()
        before = self.done()
        process = self.run(self.read)
        until(lambda: self.done() > before or process.poll() is not None, "a page done")
        what(process)
        process.wait()

    def done(self):
        try:
            return (self.folder / "alone/report.done").stat().st_mtime_ns
        except OSError:
            return 0

    def kill_page(self):
        def kill(process):
            page = next(iter(cluster_test.children_of(process.pid, "detent-import", b"")), 0)
            if page:
                os.kill(page, signal.SIGKILL)
        self.disturbed(kill)

    def tear(self, name, share):
        """A file ends in the middle, as after a power cut."""
        path = self.folder / "alone" / name
        path.write_bytes(path.read_bytes()[:int(path.stat().st_size * share)])


def disturbances(engine, pages):
    replace = lambda phase: lambda: pages.replace(phase=phase)  # noqa: E731
    if isinstance(engine, Snakemake) and engine.PROFILE == "slurm":
        yield "first run, Snakemake killed", None, engine.kill_engine
        yield "a job killed", replace(1), engine.kill_job
        yield "a page's process killed", replace(2), engine.kill_page
        yield "controller restarted", replace(3), lambda: engine.lose_controller(signal.SIGTERM)
        yield "controller killed and lost for a while", replace(4), lambda: engine.lose_controller(signal.SIGKILL)
        yield "the node's daemon killed and restarted", replace(5), engine.lose_node
        yield "a job held, then released", replace(6), engine.hold_job
        yield "pages replaced by older ones", replace(7), None
    elif isinstance(engine, Snakemake):
        yield "first run, a batch killed", None, engine.kill_batch
        yield "Snakemake killed, begun again beside its batches", replace(8), engine.kill_engine
        yield "Snakemake interrupted (Ctrl-C)", replace(9), lambda: engine.kill_engine(signal.SIGINT)
        yield "pages renamed, odd names", lambda: rename_oddly(pages), None
        yield "pages replaced by older ones of the same size", lambda: replace_by_same_size(pages), None
        yield "a page added in front, one removed", lambda: add_and_remove(pages), None
        yield "Snakemake's memory lost, pages older", replace(10), engine.forget
        yield "two pages exchange their names", lambda: swap(pages), None
    elif isinstance(engine, Alone):
        yield "first run, killed", None, engine.kill_engine
        yield "terminated", replace(14), lambda: engine.kill_engine(signal.SIGTERM)
        yield "a page's process killed", replace(15), engine.kill_page
        yield "the report torn", None, lambda: engine.tear("report.jsonl", 0.613)
        yield "the list of done pages torn", None, lambda: engine.tear("report.done", 0.371)
        yield "pages replaced by older ones, two exchange their names", lambda: (pages.replace(phase=0), swap(pages)), None
    else:
        yield "first run, parallel and its batches killed", None, engine.kill_engine
        yield "parallel killed, its batches live on", replace(11), engine.kill_engine_alone
        yield "a batch killed", replace(12), engine.kill_batch
        yield "terminated", replace(13), lambda: engine.kill_engine(signal.SIGTERM)
        yield "a list between old ones", lambda: pages.write("page-0100b.csv", LONG_AGO_s), None
        yield "pages renamed, odd names", lambda: rename_oddly(pages), None


def differences(found, wanted):
    """Pages of which lines are missing, extra or different."""
    def by_page(graphs):
        pages = {}
        for graph in graphs:
            pages.setdefault(graph["input"], []).append(graph)
        return pages
    found, wanted = by_page(found), by_page(wanted)
    return sorted(page for page in found.keys() | wanted.keys() if found.get(page) != wanted.get(page))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--pages", type=int, default=500)
    parser.add_argument("--build", type=Path, default=scale.ROOT / "build/release")
    parser.add_argument("--engine", nargs="+", default=["slurm", "local", "parallel", "alone"])
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    folder = Path(scale.tempfile.mkdtemp())
    pages = Pages(folder, build, arguments.pages)
    lost = 0
    begun = time.monotonic()
    print("| engine | disturbance | pages | lines | different | order |\n|---|---|---|---|---|---|", flush=True)
    for name in arguments.engine:
        engine = {"parallel": Recipe, "alone": Alone}[name](pages, build) if name in ("parallel", "alone") else Snakemake(name, pages, build)
        try:
            for what, prepare, disturb in disturbances(engine, pages):
                if prepare:
                    prepare()
                if disturb:
                    disturb()
                engine.content()
                wanted = pages.expected()
                if isinstance(engine, Recipe):
                    wanted = engine.expected(wanted)
                found = cluster_test.graphs(engine.report())
                different = differences(found, wanted)
                lost += len(different) + (found != wanted)
                print(f"| {name} | {what} | {len(pages.names())} | {len(found)} | {len(different)} | {'same' if found == wanted else 'NOT THE SAME'} |", flush=True)
                for page in different[:3]:
                    print(f"   {page!r}", file=sys.stderr, flush=True)
        finally:
            if isinstance(engine, Snakemake):
                engine.doCleanups()
    serial = pages.serial(pages.names(), "serial-whole")
    whole = serial == pages.expected()
    print(f"A serial run of the pages as they are at the end {'equals' if whole else 'DOES NOT EQUAL'} what was compared with; {time.monotonic() - begun:.0f} s.")
    shutil.rmtree(folder, ignore_errors=True)
    return 1 if lost or not whole else 0


if __name__ == "__main__":
    sys.exit(main())
