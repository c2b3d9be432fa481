#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""station_in_browser_test.py DETENT_PLAY [--trials N --kills N]: a participant's station in headless Chromium.

Real key and pointer events answer; the browser is killed at random moments and started again with the same profile, offline.
No answer may be lost, none may be kept that was not felt, and `study report` and `study merge` read what was downloaded.
--trials and --kills: how long the test with kills is. SKIPPED where Chromium or its driver is missing.
"""
import http.client, http.server, json, os, pathlib, random, shutil, signal, struct, subprocess, sys, tempfile, threading, time, unittest, wave

FIGURES = {name: int(sys.argv[sys.argv.index(f"--{name}") + 1]) if f"--{name}" in sys.argv else usual for name, usual in (("trials", 10), ("kills", 4))}
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "page"))
import page_in_browser_test as page

PROGRAM, BUTTONS = page.PROGRAM, page.BUTTONS
READY = "return document.documentElement.dataset.detent === 'ready'"


def play(*arguments, code=0):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == code, (done.returncode, done.stderr)
    return done


def events(text, kind):
    return [line for line in map(json.loads, text.splitlines()) if line.get("event") == kind]


def processes_below(pid):
    children, family = {}, [pid]
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            children.setdefault(int(stat.read_text().rpartition(")")[2].split()[1]), []).append(int(stat.parent.name))
        except OSError:  # ended meanwhile
            continue
    for process in family:
        family += children.get(process, [])
    return family[1:]


class Lab(http.server.BaseHTTPRequestHandler):
    """The experimenter's address."""
    received = []

    def do_POST(self):
        self.received.append(self.rfile.read(int(self.headers["Content-Length"])))
        self.send_response(204)
        self.send_header("Access-Control-Allow-Origin", "*")
        self.end_headers()

    def log_message(self, *_):
        pass


class Station(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not shutil.which("chromium") or not shutil.which("chromedriver"):
            raise unittest.SkipTest("Chromium or its driver is not installed")

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.browser = None
        self.addCleanup(lambda: self.browser and self.browser.close())

    def study(self, name, buttons, *options):
        play("study", "new", self.folder / name, *(BUTTONS / f"{b}.button.json" for b in buttons), "--seed", 7, *options)
        return self.folder / name

    def station(self, study, people="P01", *options):
        out = self.folder / f"{study.name}.html"
        made = subprocess.run([PROGRAM, "study", "station", study, "--participants", people, "-o", out, *options], capture_output=True, text=True)
        if made.returncode == 2 and "clang-14" in made.stderr:
            self.skipTest("this build has no engine for browsers")
        self.assertEqual(made.returncode, 0, made.stderr)
        return out

    def open(self, file, fragment=""):
        if self.browser is None:
            self.browser = page.Browser(self.folder)
        self.browser.do("POST", "/url", {"url": "about:blank"})
        self.browser.do("POST", "/url", {"url": file.as_uri() + fragment})
        self.browser.wait("return document.documentElement.dataset.detent")
        self.assertTrue(self.browser.run(READY), self.browser.run("return document.getElementById('message').textContent"))

    def click(self, css):
        self.browser.wait(f"return document.querySelector({css!r})")
        element = self.browser.do("POST", "/element", {"using": "css selector", "value": css})
        (key, value), = element.items()
        self.browser.do("POST", f"/element/{value}/click", {})

    def key(self, value):
        self.browser.act("key", {"type": "keyDown", "value": value}, {"type": "keyUp", "value": value})

    def press(self, *values):
        """Each key once, until the page says that its button was felt; then it is let go of and up."""
        for value in values:
            self.key(value)
            slot = "x" if value == "x" else int(value) - 1
            self.browser.wait(f"const pads = [...document.querySelectorAll('[data-slot]')]; return {json.dumps(slot)} === 'x' "
                              f"? pads.at(-1).hasAttribute('data-felt') : pads[{0 if slot == 'x' else slot}].hasAttribute('data-felt')")

    def begin(self):
        """From consent, or from a journal that is there, to the trial."""
        if self.browser.run("return !!document.getElementById('agree')"):
            self.click("#agree")
        elif self.browser.run("return !!document.getElementById('resume')"):
            self.click("#resume")
        self.browser.wait("return document.getElementById('begin')")
        self.assertTrue(self.browser.run("return document.getElementById('begin').disabled"))
        self.key(" ")
        self.browser.wait("return !document.getElementById('begin').disabled")
        self.click("#begin")
        self.browser.wait("return document.querySelector('#number, #rested, #end')")

    def shown(self):
        return self.browser.run("return document.getElementById('number')?.textContent")

    def journal(self):
        return self.browser.run("return detent.journal()")

    def answered(self):
        return len(events(self.journal(), "answer"))

    def until_answered(self, count, shown):
        """So many answers are kept, and the page has gone on from the trial that was shown."""
        self.browser.wait(f"return document.querySelector('#rested, #end') || document.getElementById('number')?.textContent !== {json.dumps(shown)}")
        self.browser.wait(f"return detent.journal().split('\\n').filter((l) => l.includes('\"event\":\"answer\"')).length === {count}")

    def answer(self, *values):
        """Presses, then the answer."""
        before, shown = self.answered(), self.shown()
        self.press(*values[:-1])
        self.key(values[-1])
        self.until_answered(before + 1, shown)

    def targets(self):
        return self.browser.run("return JSON.parse(document.getElementById('data').textContent).people[0].trials.map((t) => t.target)")

    def handed_over(self, study, person="P01"):
        """Downloaded by the page's own button and put into the study's folder."""
        into = self.folder / "downloads"
        into.mkdir(exist_ok=True)
        self.browser.do("POST", "/goog/cdp/execute", {"cmd": "Browser.setDownloadBehavior", "params": {"behavior": "allow", "downloadPath": str(into)}})
        self.click("#download")
        file = into / f"{person}.jsonl"
        end = time.monotonic() + 20
        # The browser makes an empty file of that name before it writes beside it.
        while not file.exists() or not file.stat().st_size or list(into.glob("*.crdownload")):
            self.assertLess(time.monotonic(), end, list(into.iterdir()))
            time.sleep(0.05)
        shutil.move(file, study / "participants" / file.name)
        return (study / "participants" / file.name).read_text()

    # ---- kills

    def kill(self):
        driver = self.browser.driver
        for process in processes_below(driver.pid):
            try:
                os.kill(process, signal.SIGKILL)
            except ProcessLookupError:
                pass
        driver.kill()
        driver.wait()
        self.browser = None

    def assert_offline(self):
        self.browser.do("POST", "/goog/cdp/execute", {"cmd": "Network.emulateNetworkConditions",
                        "params": {"offline": True, "latency": 0, "downloadThroughput": 0, "uploadThroughput": 0}})

    def test_killed_in_the_middle_offline_loses_no_answer_and_keeps_none_unfelt(self):
        trials, kills = FIGURES["trials"], FIGURES["kills"]
        study = self.study("killed", "AB", "--trials", trials)
        file, chance, refused = self.station(study), random.Random(1), 0
        amid = 0
        at = sorted(chance.sample(range(1, trials + 1), kills))
        self.open(file)
        self.assert_offline()
        self.begin()
        while self.answered() < trials:
            if self.browser.run("return !!document.getElementById('rested')"):
                self.click("#rested")
            self.browser.wait("return document.getElementById('number')")
            confirmed, kept = self.answered(), self.journal()
            self.key("a")  # nothing was pressed yet
            self.assertEqual((self.answered(), self.journal()), (confirmed, kept))
            refused += 1
            steps = ("1", "2", "x", chance.choice("ab"))
            if at and confirmed + 1 >= at[0]:
                at.pop(0)
                ending = threading.Timer(chance.uniform(0, 2), self.kill)
                ending.start()
                try:
                    self.answer(*steps)
                except (OSError, ValueError, AttributeError, http.client.HTTPException):
                    pass  # it was killed
                ending.join()
                self.open(file)
                self.assert_offline()
                told = self.journal()
                self.assertTrue(told.startswith(kept), "an answer that was confirmed is lost")
                self.assertIn(len(events(told, "answer")), (confirmed, confirmed + 1))
                amid += len(events(told, "answer")) == confirmed
                if len(events(told, "answer")) < trials:
                    self.begin()
                continue
            self.answer(*steps)
        text = self.handed_over(study)
        answers = events(text, "answer")
        self.assertEqual([a["trial"] for a in answers], list(range(1, trials + 1)))
        unfelt = [a["trial"] for a in answers if min(f["whole"] for f in a["felt"] + [a["felt_x"]]) < 1]
        self.assertEqual(unfelt, [])
        print(f"{trials} trials, {kills} kills offline, {amid} of them within a trial: 0 answers lost, 0 without a touch, {refused} answers before a press refused")
        report = json.loads(play("study", "report", study, "--json").stdout)
        self.assertEqual(report["trials"], trials)
        self.assertIn("complete", play("study", "status", study).stdout)
        play("study", "new", self.folder / "other", BUTTONS / "A.button.json", BUTTONS / "B.button.json", "--seed", 8, "--trials", trials)
        play("study", "run", self.folder / "other", "--participant", "P01", "--simulate", "perfect")
        play("study", "merge", study, self.folder / "other", "-o", self.folder / "merged")
        rows = self.folder / "rows.csv"
        play("study", "report", self.folder / "merged", "--csv", rows)
        self.assertEqual(sum(line.split(",")[1] == "killed-P01" for line in rows.read_text().splitlines()), trials)

    # ---- what is felt, kept and refused

    def test_stimuli_are_those_of_the_program(self):
        study = self.study("felt", ["C", "latch"], "--trials", 1, "--modes", "full,click-only", "--feel", "paper")
        self.open(self.station(study))
        order = self.browser.run("return JSON.parse(document.getElementById('data').textContent).stimuli.map((s) => [s.mode, s.button])")
        self.assertEqual(len(order), 4)
        for i, (mode, button) in enumerate(order):
            wav = self.folder / "reference.wav"
            play("render", BUTTONS / f"{['C', 'latch'][button]}.button.json", "--standard-press", "--feel", "paper", "--mode", mode, "-o", wav)
            expected, got = page.samples_of(wav), self.browser.run(f"return Array.from(detent.render({i}))")
            self.assertEqual(len(expected), len(got))
            self.assertLessEqual(max(abs(a - b) for a, b in zip(expected, got)), 1e-6)
            self.assertGreater(max(map(abs, got)), 0.05)

    def test_a_press_is_heard_at_its_delay_and_level(self):
        recording = self.folder / "click.wav"
        with wave.open(str(recording), "wb") as out:
            out.setnchannels(1)
            out.setsampwidth(2)
            out.setframerate(48000)
            out.writeframes(struct.pack("<3h", 16384, -8192, 4096))
        onsets = []
        for delay_ms, source in ((0, recording), (20, recording), (10, "rendered")):
            study = self.study(f"heard{delay_ms}", "B", "--kind", "rating", "--trials", 1, "--sound", source, "--sound-delay", delay_ms, "--sound-level", -6)
            self.open(self.station(study))
            felt, heard = self.browser.run("return detent.heard(0)")
            gain, late = 10 ** (-6 / 20), 48 * delay_ms
            if source == "rendered":
                self.assertGreater(max(map(abs, heard)), 0.01)
                self.assertLess(max(abs(h - gain * f) for h, f in zip(heard[late:], felt)), 1e-6)
                continue
            onsets.append(next(i for i, sample in enumerate(heard) if sample))
            for got, expected in zip(heard[onsets[-1]:onsets[-1] + 4], (0.5, -0.25, 0.125, 0)):
                self.assertAlmostEqual(got, gain * expected, 6)
            self.assertEqual(sum(1 for sample in heard if sample), 3)
        self.assertEqual(onsets[1] - onsets[0], 960)
        self.begin()
        self.key(" ")
        self.browser.wait("return document.querySelector('[data-felt]')")
        self.key("5")
        self.browser.wait("return document.getElementById('end')")
        header = json.loads(self.journal().splitlines()[0])
        self.assertEqual(header["sound"], {"source": "rendered", "level_dB": -6.0, "delay_ms": 10.0})

    def test_same_or_different(self):
        study = self.study("same", "AB", "--kind", "same-different", "--trials", 4)
        self.open(self.station(study))
        self.begin()
        for target in self.targets():
            self.answer("1", "2", "ab"[target])
        self.browser.wait("return document.getElementById('end')")
        told = events(self.handed_over(study), "answer")
        self.assertEqual(sorted((*a["choices"], a["x"], a["answer"]) for a in told),
                         [("A", "A", "same", "same"), ("A", "B", "different", "different"), ("B", "A", "different", "different"), ("B", "B", "same", "same")])
        [row] = json.loads(play("study", "report", study, "--json").stdout)["tables"][0]["rows"]
        self.assertEqual((row["hits_percent"], row["false_alarms_percent"]), (100, 0))

    def test_a_threshold_study_asks_what_the_program_asks(self):
        study = self.study("threshold", "C", "--kind", "threshold", "--quantity", "travel", "--trials", 6)
        shutil.copytree(study, self.folder / "copy")
        self.open(self.station(study))
        self.begin()
        for target in self.targets():
            self.answer("1", "2", "ab"[target])
        text = self.handed_over(study)
        play("study", "run", self.folder / "copy", "--participant", "P01", "--simulate", "perfect")
        own = (self.folder / "copy" / "participants" / "P01.jsonl").read_text()
        self.assertEqual([(a["choices"], a["x"], a["correct"]) for a in events(text, "answer")],
                         [(a["choices"], a["x"], a["correct"]) for a in events(own, "answer")])
        self.assertEqual(json.loads(play("study", "report", study, "--json").stdout)["trials"], 6)

    def test_ratings_by_pointer_pause_and_stop(self):
        study = self.study("rating", "AB", "--kind", "rating", "--trials", 2)
        self.open(self.station(study, "P01,P02"), "#P02")
        self.click("#agree")
        pad = "[data-slot='0']"
        for answered in range(2):
            if answered == 0:
                self.touch(pad)
                self.browser.wait("return !document.getElementById('begin').disabled")
                self.click("#begin")
            self.browser.wait("return document.querySelector('[data-answer]')?.disabled")
            shown = self.shown()
            self.touch(pad)
            self.browser.wait("return !document.querySelector('[data-answer]').disabled")
            self.click("[data-answer='6']")
            self.until_answered(answered + 1, shown)
        self.click("#pause")
        self.click("#resume")
        self.assertIn("3", self.shown())
        self.click("#stop")
        self.click("#stop-yes")
        self.browser.wait("return document.getElementById('end')")
        text = self.handed_over(study, "P02")
        self.assertEqual([a["rating"] for a in events(text, "answer")], [6, 6])
        self.assertEqual([e["reason"] for e in events(text, "end")], ["stopped by the participant"])
        self.assertIn("ended early", play("study", "status", study).stdout)

    def touch(self, css):
        self.browser.wait(f"return !!document.querySelector({json.dumps(css)})")
        (_, value), = self.browser.do("POST", "/element", {"using": "css selector", "value": css}).items()
        pad = {"element-6066-11e4-a52e-4f735466cecf": value}
        self.browser.act("pointer", {"type": "pointerMove", "origin": pad, "x": 0, "y": 0}, {"type": "pointerDown", "button": 0},
                         {"type": "pause", "duration": 30}, {"type": "pointerUp", "button": 0})

    def test_answers_are_sent_where_the_experimenter_says(self):
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Lab)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        study = self.study("sent", "AB", "--trials", 2)
        self.open(self.station(study, "P01", "--post", f"http://127.0.0.1:{server.server_port}/answers"))
        self.assert_offline()
        self.begin()
        self.answer("1", "2", "x", "a")
        self.answer("1", "2", "x", "b")
        self.browser.wait("return document.getElementById('message').textContent.includes('could not be sent')")
        self.assertEqual(Lab.received, [])
        self.browser.do("POST", "/goog/cdp/execute", {"cmd": "Network.emulateNetworkConditions",
                        "params": {"offline": False, "latency": 0, "downloadThroughput": -1, "uploadThroughput": -1}})
        self.click("#send")
        self.browser.wait("return document.getElementById('message').textContent.includes('have been sent')")
        self.assertEqual([body.decode() for body in Lab.received], [self.journal()])
        (study / "participants" / "P01.jsonl").write_bytes(Lab.received[0])
        self.assertEqual(json.loads(play("study", "report", study, "--json").stdout)["trials"], 2)

    def test_a_second_window_does_not_write_into_the_journal(self):
        study = self.study("twice", "AB", "--trials", 3)
        file = self.station(study)
        self.open(file)
        self.begin()
        first = self.browser.do("GET", "/window")
        second = self.browser.do("POST", "/window/new", {"type": "tab"})["handle"]
        self.browser.do("POST", "/window", {"handle": second})
        self.open(file)
        self.begin()
        self.answer("1", "2", "x", "a")
        self.browser.do("POST", "/window", {"handle": first})
        self.press("1", "2", "x")
        self.key("b")
        self.browser.wait("return document.getElementById('message').textContent.includes('another window')")
        self.assertEqual(self.answered(), 0)
        self.browser.do("POST", "/window", {"handle": second})
        self.assertEqual(self.answered(), 1)

    def test_a_page_with_other_trials_does_not_go_on(self):
        study = self.study("placed", "ABC", "--trials", 1, "--pairs-each", 1)
        self.open(self.station(study, "P01"))
        self.begin()
        self.answer("1", "2", "x", "a")
        text = self.journal()
        self.open(self.station(study, "P02,P01"), "#P01")  # now the second
        self.assertIn("another page", self.browser.run("return document.getElementById('screen').textContent"))
        self.assertEqual(self.handed_over(study), text)

    def test_who_declines_begins_no_journal(self):
        study = self.study("declined", "AB", "--trials", 1)
        self.open(self.station(study))
        self.click("#decline")
        self.browser.wait("return document.getElementById('end')")
        self.assertEqual(self.journal(), "")

    def test_what_a_browser_cannot_do_is_refused(self):
        study = self.study("refused", "AB", "--trials", 1)
        play("study", "run", study, "--participant", "P01", "--simulate", "perfect")
        timed = self.study("timed", "A", "--kind", "timing")
        out = self.folder / "out.html"
        for folder, options, word in ((study, ("--participants", "P01"), "already has simulated answers"), (study, ("--participants", "P02,p-2"), "named twice"),
                                      (study, ("--participants", "P 2"), "is not a participant's id"), (timed, ("--participants", "P01"), "timing study"),
                                      (study, ("--participants", "P02", "--post", "lab.example"), "not the address"),
                                      (study, ("--participants", "P02", "--post", "https://a b/"), "not the address")):
            self.assertIn(word, play("study", "station", folder, *options, "-o", out, code=2).stderr)
            self.assertFalse(out.exists())


if __name__ == "__main__":
    names = [a for a in sys.argv[1:] if a.startswith("Station.")]
    result = unittest.main(exit=False, verbosity=1, argv=[sys.argv[0], *names]).result
    if result.skipped and not result.testsRun - len(result.skipped):
        print("SKIPPED:", result.skipped[0][1])
    sys.exit(not result.wasSuccessful())
