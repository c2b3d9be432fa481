#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""samples/cluster as a user runs it, on this machine and on a Slurm of one node that it sets up: cluster_test.py --root FOLDER --bin FOLDER

Slurm needs root, slurmctld, slurmd and munged; Snakemake has to be Debian's; GNU parallel runs the recipe of docs/scale.md. What is absent
is SKIPPED.
"""

import argparse
import csv
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = BIN = None
SNAKEMAKE = "/usr/bin/snakemake"
LONGEST_WAIT_s = 120
STATUS = Path(__file__).resolve().parents[2] / "samples/cluster/profiles/slurm/status.sh"
# Slurm's job states (squeue's manual) by what Snakemake is to be told; held ones wait for a person.
RUNNING = " PENDING CONFIGURING RUNNING COMPLETING SUSPENDED STOPPED RESIZING REQUEUED REQUEUE_FED SIGNALING STAGE_OUT"
HELD = " RESV_DEL_HOLD REQUEUE_HOLD SPECIAL_EXIT REVOKED"
FAILED = " BOOT_FAIL CANCELLED DEADLINE FAILED NODE_FAIL OUT_OF_MEMORY PREEMPTED TIMEOUT"
ODD_NAMES = [os.fsdecode(b"log {3f2504e0} \xff.csv"), "#it's $HOME 100%.csv", "[1]*, -ü.csv", "log-1.csv"]
# Stands in for detent-import: waits until a file is there, and tells of each batch that begins and of two that share a folder.
WATCHED = """#!/bin/bash
case " $* " in *" --batch "*) ;; *) exec {program} "$@" ;; esac
[[ "$*" =~ batches/([0-9]+).list ]]
exec 8>>{folder}/at-work-${{BASH_REMATCH[1]}}
flock -n 8 || echo "${{BASH_REMATCH[1]}}" >> {folder}/twice
echo "${{BASH_REMATCH[1]}}" >> {folder}/begun
until [ -e {folder}/go ]; do sleep 0.1; done
{program} "$@"
"""


def missing(*programs):
    places = "/usr/bin:/usr/sbin:/sbin:/bin"
    absent = [name for name in programs if not shutil.which(name, path=places)]
    if absent:
        print("SKIPPED", ", ".join(absent), "not installed")
    return bool(absent)


def until(what, description):
    end = time.monotonic() + LONGEST_WAIT_s
    while not what():
        if time.monotonic() > end:
            raise AssertionError(f"in {LONGEST_WAIT_s} s not: {description}")
        time.sleep(0.05)


def graphs(report):
    """The lines of a report without what no two runs share."""
    kept = [json.loads(line) for line in Path(report).read_text().splitlines()]
    for graph in kept:
        graph.pop("seconds", None)
        graph.pop("outputs", None)
    return kept


def children_of(process, name, word=b"--batch"):
    """Ids of the batches of a name below one, however deep."""
    parents = {}
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            words = stat.read_text().rsplit(")", 1)
            parents[int(stat.parent.name)] = (int(words[1].split()[1]), words[0].split("(", 1)[1])
        except (OSError, ValueError):
            continue

    def below(pid):
        while pid in parents and pid != process:
            pid = parents[pid][0]
        return pid == process

    def batch(pid):  # and not one that is asked for its version
        try:
            return word in Path(f"/proc/{pid}/cmdline").read_bytes()
        except OSError:
            return False

    return [pid for pid, (_, its) in parents.items() if its == name and below(pid) and batch(pid)]


def kill_one(process, name):
    """Kills the first process of a name below one; false where there is none, or it was quicker."""
    try:
        os.kill(min(children_of(process, name)), signal.SIGKILL)
    except (ValueError, ProcessLookupError):
        return False
    return True


class Cluster(unittest.TestCase):
    PROFILE = "local"

    def setUp(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        (self.folder / "pages").mkdir()
        self.program = BIN / "detent-import"
        for name in ODD_NAMES:
            shutil.copy(ROOT / "samples/plots/force-meter-log.csv", self.folder / "pages" / name)
        for number in range(2):
            shutil.copy(ROOT / "samples/plots/brown-one-ink.png", self.folder / f"pages/plot {number}.png")
        (self.folder / "pages/broken.png").write_text("not a picture")

    def command(self, *more):
        return [SNAKEMAKE, "-s", ROOT / "samples/cluster/Snakefile", "--profile", ROOT / f"samples/cluster/profiles/{self.PROFILE}", *more,
                "--config", "pages=pages/*", "out=out", "batch=3", f"program={self.program}", "options=--quality draft"]

    def environment(self):
        return {**os.environ, "PATH": "/usr/bin:/usr/sbin:/bin:/sbin", "HOME": str(self.folder)}

    def snakemake(self, *more):
        ran = subprocess.run(self.command(*more), cwd=self.folder, env=self.environment(), capture_output=True, text=True, check=False)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        return ran.stderr

    def begin(self):
        process = subprocess.Popen(self.command(), cwd=self.folder, env=self.environment(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def watch(self):
        """From here on batches begin only once go() is called."""
        self.program = self.folder / "watched"
        self.program.write_text(WATCHED.format(program=BIN / "detent-import", folder=self.folder))
        self.program.chmod(0o755)

    def go(self):
        (self.folder / "go").touch()

    def begun(self):
        try:
            return sorted((self.folder / "begun").read_text().split())
        except FileNotFoundError:
            return []

    def assert_as_serial(self):
        pages = sorted(str(path.relative_to(self.folder)) for path in (self.folder / "pages").iterdir())
        subprocess.run([BIN / "detent-import", "--batch", *pages, "--out-dir", "serial", "--quality", "draft"], cwd=self.folder, check=True,
                       capture_output=True)
        self.assertEqual(graphs(self.folder / "out/all.jsonl"), graphs(self.folder / "serial/report.jsonl"))
        self.assertEqual(len(graphs(self.folder / "out/all.jsonl")), 7)

    def handled(self):
        return sum(len(path.read_text().splitlines()) for path in (self.folder / "out/batches").glob("*/report.done"))


def may_mount():
    """Disks of a size and nodes that do not see a folder are mounted for a test, which takes root."""
    allowed = os.getuid() == 0 and subprocess.run(["unshare", "--mount", "mount", "-t", "tmpfs", "none", "/mnt"], capture_output=True, check=False).returncode == 0
    if not allowed:
        print("SKIPPED a full disk, a node without the pages: mounting is not allowed")
    return allowed


@unittest.skipIf(missing(SNAKEMAKE), "no Snakemake")
class OneMachine(Cluster):
    def test_a_run_gives_what_a_serial_one_gives_and_is_not_repeated(self):
        self.snakemake()
        self.assert_as_serial()
        with open(self.folder / "out/table.csv", newline="") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual([row["status"] for row in rows].count("ok"), 6)
        self.assertIn("Nothing to be done", self.snakemake())
        page = self.folder / "pages/log-1.csv"
        half_as_far = [re.sub(r"^((?:[^,]*,){2})([-\d.]+)", lambda row: row[1] + str(float(row[2]) / 2), line) for line in page.read_text().splitlines()]
        page.write_text("\n".join(half_as_far) + "\n")
        os.utime(page, (1e9, 1e9))  # older than the results, as cp -p, rsync -a and unzip leave it
        self.assertNotIn("batches/00000.jsonl.list", self.snakemake())
        self.assert_as_serial()
        travels = [graph["travel_mm"] for graph in graphs(self.folder / "out/all.jsonl") if graph["input"] == "pages/log-1.csv"]
        self.assertAlmostEqual(travels[0], 2.0, delta=0.01)
        page.rename(self.folder / "pages/zuletzt.csv")
        self.snakemake()
        self.assert_as_serial()
        shutil.rmtree(self.folder / ".snakemake")  # what Snakemake knows of former runs
        page = self.folder / "pages/zuletzt.csv"
        shutil.copy(ROOT / "samples/plots/force-meter-log.csv", page)
        os.utime(page, (1e9, 1e9))
        self.snakemake()
        self.assert_as_serial()

    def test_names_that_no_list_can_hold_are_refused(self):
        for odd, more in (("page\nbreak.csv", []), (None, ["out=o{u}t"])):
            if odd:
                shutil.copy(ROOT / "samples/plots/force-meter-log.csv", self.folder / "pages" / odd)
            ran = subprocess.run([*self.command(), *more], cwd=self.folder, env=self.environment(), capture_output=True, text=True, check=False)
            self.assertNotEqual(ran.returncode, 0)
            self.assertRegex(ran.stderr + ran.stdout, "Rename it" if odd else "without them")
            if odd:
                (self.folder / "pages" / odd).unlink()

    def test_a_killed_snakemake_goes_on_without_two_at_one_batch(self):
        self.watch()
        process = self.begin()
        until(self.begun, "a batch begun")
        process.send_signal(signal.SIGKILL)  # its batches live on
        process.wait()
        before = len(self.begun())
        self.snakemake("--unlock")
        again = self.begin()
        until(lambda: (self.folder / "out/batches/00000.jsonl").exists() or children_of(again.pid, "flock", b"") or len(self.begun()) > before, "the batches asked for again")
        self.go()
        self.assertEqual(again.wait(LONGEST_WAIT_s), 0)
        self.assert_as_serial()
        self.assertFalse((self.folder / "twice").exists())

    def test_a_killed_importer_is_repeated(self):
        process = self.begin()
        until(lambda: kill_one(process.pid, "detent-import"), "an importer killed")
        self.assertEqual(process.wait(LONGEST_WAIT_s), 0)
        self.assert_as_serial()

    def test_a_full_disk_fails_the_batch_by_name_and_leaves_no_table(self):
        if not may_mount():
            return
        out = self.folder / "out"
        out.mkdir()
        subprocess.run(["mount", "-t", "tmpfs", "-o", "size=600k", "none", out], check=True)
        self.addCleanup(subprocess.run, ["umount", "--lazy", out], check=False)
        ran = subprocess.run(self.command(), cwd=self.folder, env=self.environment(), capture_output=True, text=True, check=False)
        self.assertNotEqual(ran.returncode, 0)
        self.assertRegex(ran.stderr, r"pages/plot \d\.png: its results cannot be written")
        self.assertFalse((out / "all.jsonl").exists())
        self.assertFalse((out / "table.csv").exists())
        subprocess.run(["mount", "-o", "remount,size=60m", out], check=True)
        self.snakemake()
        self.assert_as_serial()

    def test_a_node_without_the_pages_fails_the_batch_by_name(self):
        if not may_mount():
            return
        node = self.folder / "node"  # what sbatch would be: the job where the pages are not to be seen
        node.write_text(f'#!/bin/sh\nexec unshare --mount sh -c \'mount -t tmpfs none {self.folder}/pages && exec sh "$0"\' "$1"\n')
        node.chmod(0o755)
        ran = subprocess.run([*self.command(), "--cluster", node, "--jobs", "2", "--restart-times", "0"], cwd=self.folder, env=self.environment(),
                             capture_output=True, text=True, check=False)
        self.assertNotEqual(ran.returncode, 0)
        self.assertRegex(ran.stderr + ran.stdout, r"pages/")
        self.assertFalse((self.folder / "out/all.jsonl").exists())
        self.assertFalse((self.folder / "out/table.csv").exists())
        self.snakemake()
        self.assert_as_serial()

    def test_an_absent_program_is_said_by_name(self):
        command = [word if "program=" not in str(word) else "program=/nowhere/detent-import" for word in self.command()]
        ran = subprocess.run(command, cwd=self.folder, env=self.environment(), capture_output=True, text=True, check=False)
        self.assertNotEqual(ran.returncode, 0)
        self.assertRegex(ran.stderr + ran.stdout, "/nowhere/detent-import cannot be run on ")
        self.assertFalse((self.folder / "out/all.jsonl").exists())


@unittest.skipIf(missing(SNAKEMAKE, "slurmctld", "slurmd", "munged", "sbatch"), "no Slurm")
class OneNode(Cluster):
    PROFILE = "slurm"

    def setUp(self):
        if os.getuid() != 0:
            print("SKIPPED Slurm: its daemons need root")
            self.skipTest("not root")
        super().setUp()
        self.slurm = Path(tempfile.mkdtemp(prefix="slurm"))
        self.addCleanup(shutil.rmtree, self.slurm, ignore_errors=True)
        self.begin_munge()
        self.write_configuration()
        self.controller = self.slurm_daemon("slurmctld")
        self.slurm_daemon("slurmd", "-N", self.host)
        until(lambda: "idle" in self.told("sinfo", "--noheader", "--format=%T"), "the node idle")

    def environment(self):
        return {**super().environment(), "SLURM_CONF": str(self.slurm / "slurm.conf")}

    def told(self, *command):
        return subprocess.run(command, env=self.environment(), capture_output=True, text=True, check=False).stdout

    def daemon(self, command):
        process = subprocess.Popen(command, env=self.environment(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)
        return process

    def slurm_daemon(self, name, *more):
        return self.daemon([shutil.which(name, path="/usr/sbin"), "-D", "-f", self.slurm / "slurm.conf", *more])

    def begin_munge(self):
        key = self.slurm / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        self.slurm.chmod(0o755)
        self.socket = self.slurm / "munge.socket"
        self.daemon(["/usr/sbin/munged", "--foreground", f"--socket={self.socket}", f"--key-file={key}", f"--pid-file={self.slurm}/munge.pid",
                     f"--log-file={self.slurm}/munge.log", f"--seed-file={self.slurm}/munge.seed"])
        until(self.socket.exists, "munge's socket")

    def write_configuration(self):
        self.host = socket.gethostname().split(".")[0]
        ports = []
        for _ in range(2):
            with socket.socket() as free:
                free.bind(("", 0))
                ports.append(free.getsockname()[1])
        memory_MB = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") >> 20
        (self.slurm / "state").mkdir()
        (self.slurm / "spool").mkdir()
        (self.slurm / "slurm.conf").write_text(f"""ClusterName=test
SlurmctldHost={self.host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
AuthType=auth/munge
AuthInfo=socket={self.socket}
CredType=cred/munge
StateSaveLocation={self.slurm}/state
SlurmdSpoolDir={self.slurm}/spool
SlurmctldPidFile={self.slurm}/slurmctld.pid
SlurmdPidFile={self.slurm}/slurmd.pid
SlurmctldLogFile={self.slurm}/slurmctld.log
SlurmdLogFile={self.slurm}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MessageTimeout=2
SchedulerParameters=sched_interval=1,batch_sched_delay=0,sched_min_interval=0
NodeName={self.host} NodeAddr=127.0.0.1 CPUs={os.cpu_count()} RealMemory={memory_MB * 9 // 10} State=UNKNOWN
PartitionName=all Nodes={self.host} Default=YES MaxTime=INFINITE State=UP
""")

    def running_jobs(self):
        return self.told("squeue", "--noheader", "--states=RUNNING", "--format=%A").split()

    def status(self, job, **environment):
        ran = subprocess.run(["sh", STATUS, job], cwd=self.folder, env={**self.environment(), **environment}, capture_output=True, text=True, check=True)
        return ran.stdout.strip(), ran.stderr

    def test_a_job_that_is_killed_is_repeated(self):
        process = self.begin()
        until(self.running_jobs, "a job running")
        self.told("scancel", "--signal=KILL", "--full", self.running_jobs()[0])
        self.assertEqual(process.wait(3 * LONGEST_WAIT_s), 0)
        self.assert_as_serial()

    def test_a_controller_that_is_away_fails_no_job_and_repeats_no_batch(self):
        self.watch()
        asked = self.slurm / "asked"
        shim = self.slurm / "bin/scontrol"
        shim.parent.mkdir()
        shim.write_text(f'#!/bin/sh\n/usr/bin/scontrol "$@"\ncode=$?\necho "$code $*" >> {asked}\nexit $code\n')
        shim.chmod(0o755)
        with_shim = {**self.environment(), "PATH": f"{shim.parent}:{self.environment()['PATH']}"}
        process = subprocess.Popen([*self.command("--restart-times", "0"), ], cwd=self.folder, env=with_shim, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        until(lambda: len(self.begun()) >= min(2, os.cpu_count()), "the batches at work")
        job = self.running_jobs()[0]
        self.assertEqual(self.status(job)[0], "running")
        self.controller.terminate()
        self.controller.wait()
        until(lambda: "1 --oneliner show job" in asked.read_text(), "Snakemake's question without an answer")
        self.assertEqual(self.status(job)[0], "running")
        self.controller = self.slurm_daemon("slurmctld")
        until(lambda: self.running_jobs(), "the controller back")
        self.go()
        self.assertEqual(process.wait(LONGEST_WAIT_s), 0)
        self.assert_as_serial()
        self.assertEqual(self.begun(), ["00000", "00001", "00002"])
        self.assertEqual(self.status("4000000")[0], "failed")  # never was

    def test_a_held_job_is_named_once(self):
        (self.folder / ".snakemake").mkdir()
        job = self.told("sbatch", "--parsable", "--hold", "--output=/dev/null", "--wrap=true").strip()
        state, said = self.status(job)
        self.assertEqual(state, "running")
        self.assertIn(f"scontrol release {job}", said)
        self.assertEqual(self.status(job), ("running", ""))
        self.told("scontrol", "release", job)
        until(lambda: self.status(job)[0] == "success", "the job done")

    def test_every_state_has_its_answer(self):
        shim = self.slurm / "bin/scontrol"
        shim.parent.mkdir()
        shim.write_text('#!/bin/sh\necho "JobId=7 JobState=$STATE Reason=None"\n')
        shim.chmod(0o755)
        path = f"{shim.parent}:{self.environment()['PATH']}"
        answers = {state: self.status("7", PATH=path, STATE=state) for state in (RUNNING + HELD + FAILED).split()}
        self.assertEqual({state for state, (answer, _) in answers.items() if answer == "running"}, set((RUNNING + HELD).split()))
        self.assertEqual({state for state, (answer, _) in answers.items() if answer == "failed"}, set(FAILED.split()))
        self.assertEqual({state for state, (_, said) in answers.items() if said}, set(HELD.split()))
        self.assertEqual(self.status("7", PATH=path, STATE="COMPLETED")[0], "success")
        valid = subprocess.run(["squeue", "--states=none-of-them"], env=self.environment(), capture_output=True, text=True, check=False).stderr
        listed = {word.upper() for word in re.findall(r"[a-z_]+", valid.lower().partition("include:")[2])}
        self.assertIn("RUNNING", listed)
        self.assertEqual(listed - set((RUNNING + HELD + FAILED + " COMPLETED").split()), set())


@unittest.skipIf(missing("parallel"), "no GNU parallel")
class GnuParallel(unittest.TestCase):
    """The recipe of docs/scale.md for lists of pages."""

    def run_recipe(self, pages):
        scale = next(path for path in (ROOT / "docs").rglob("scale.md")).read_text()
        recipe = re.search(r"^```sh\n(parallel .*?)^```$", scale, re.S | re.M)[1]
        environment = {**os.environ, "PATH": f"{BIN}:/usr/bin:/bin", "HOME": str(self.folder)}
        ran = subprocess.run(["bash", "-euo", "pipefail", "-c", recipe], cwd=self.folder, env=environment, capture_output=True, text=True, check=False)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertEqual([graph["input"] for graph in graphs(self.folder / "all.jsonl")], pages)

    def write_list(self, name, *pages):
        (self.folder / f"lists/{name}.txt").write_text("".join(f"{page}\n" for page in pages))

    def test_lists_that_are_added_changed_renamed_and_repeated(self):
        self.folder = Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        (self.folder / "lists").mkdir()
        for page in "one", "two", "three", "four":
            shutil.copy(ROOT / "samples/plots/force-meter-log.csv", self.folder / f"{page} {{}}.csv")
        self.write_list("a", "one {}.csv")
        self.write_list("c", "three {}.csv")
        self.run_recipe(["one {}.csv", "three {}.csv"])
        self.write_list("b", "two {}.csv")  # between old ones
        self.run_recipe(["one {}.csv", "two {}.csv", "three {}.csv"])
        self.write_list("a", "one {}.csv", "four {}.csv")  # a page more
        (self.folder / "lists/c.txt").rename(self.folder / "lists/d d.txt")
        self.run_recipe(["one {}.csv", "four {}.csv", "two {}.csv", "three {}.csv"])
        page = self.folder / "two {}.csv"
        page.write_text("no table")  # another page under the old name, older than the results
        os.utime(page, (1e9, 1e9))
        self.run_recipe(["one {}.csv", "four {}.csv", "two {}.csv", "three {}.csv"])
        self.assertEqual([graph["status"] for graph in graphs(self.folder / "all.jsonl")].count("ok"), 3)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--root", type=Path, required=True)
    parser.add_argument("--bin", type=Path, required=True)
    chosen, rest = parser.parse_known_args()
    ROOT, BIN = chosen.root.resolve(), chosen.bin.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
