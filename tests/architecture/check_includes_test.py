#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows that check_includes.py fires: plants one mistake per rule in a copy of the project and expects exactly that finding.

What the project itself violates at the moment is compared away, so that a mistake elsewhere does not hide a broken check.
"""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
import check_includes  # noqa: E402

HERE = Path(__file__).resolve().parent
PROJECT = HERE.parent.parent
TABLE = check_includes.Table(HERE / "include_table.toml")


def copy_of_project(folder):
    """Sources and build files of the project, without git, and something for every other top-level entry."""
    for file in check_includes.files_of(PROJECT):
        if file.endswith(check_includes.SOURCES) or file.endswith("CMakeLists.txt") or "/" not in file:
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(PROJECT / file, folder / file)
    for entry in TABLE.top_level:
        if not (folder / entry).exists():
            (folder / entry).mkdir()
            (folder / entry / "placeholder").touch()


class PlantedMistake(unittest.TestCase):
    """All tests share one copy: copying and checking it takes a second. Each test removes what it planted."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.root = Path(folder.name)
        copy_of_project(cls.root)
        cls.before = cls.check()

    @classmethod
    def check(cls):
        return set(check_includes.Checker(cls.root, TABLE).violations())

    def write(self, path, text):
        """Writes a file; the end of the test restores it."""
        kept = path.read_text() if path.exists() else None
        self.addCleanup(path.unlink if kept is None else lambda: path.write_text(kept))
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def plant(self, file, *lines):
        self.write(self.root / file, "\n".join(lines) + "\n")

    def append(self, file, line):
        """Adds a line at the end of a file; gives its number."""
        text = (self.root / file).read_text()
        self.write(self.root / file, text + line + "\n")
        return text.count("\n") + 1

    def list_header(self, folder, header):
        self.append(f"{folder}/CMakeLists.txt", f"# HEADERS {header}")

    def expect(self, *places):
        """Exactly these (file, line, rule) and no others are found since setUp; what is planted carries no licence line."""
        found = {(violation.file, violation.line, violation.rule) for violation in self.check() - self.before
                 if violation.rule != "licence"}
        self.assertEqual(found, set(places))

    # One test per rule.

    def test_nothing_planted(self):
        self.expect()

    def test_a_file_without_a_licence_line(self):
        self.plant("tests/model/planted_test.cpp", "#pragma once")
        self.plant("tests/model/licensed_test.cpp", f"// {check_includes.LICENCE}", "// why")
        self.plant("tests/planted.py", "#!/usr/bin/env python3", f"# {check_includes.LICENCE}")
        found = {(violation.file, violation.line) for violation in self.check() - self.before if violation.rule == "licence"}
        self.assertEqual(found, {("tests/model/planted_test.cpp", 1)})

    def test_model_uses_a_library(self):
        self.plant("model/planted.cpp", "// why", "#include <nlohmann/json.hpp>")
        self.expect(("model/planted.cpp", 2, "third party"))

    def test_model_file_may_use_its_library(self):
        self.plant("model/file/planted.cpp", "#include <nlohmann/json.hpp>", '#include "model/result.h"')
        self.expect()

    def test_model_includes_importer(self):
        self.plant("model/planted.cpp", '#include "importer/importer.h"')
        self.expect(("model/planted.cpp", 1, "direction"))

    def test_importer_step_includes_a_later_one(self):
        steps = ["page/page.h", "frame/plot_frame.h", "axes/axis_calibration.h", "trace/curve_trace.h",
                 "strokes/stroke_pair.h", "fit/fit_stroke.h"]
        wanted = set()
        for here, step in enumerate(steps):
            file = f"importer/{step.split('/')[0]}/planted.cpp"
            self.plant(file, *(f'#include "importer/{other}"' for other in steps))
            wanted |= {(file, line, "direction") for line in range(here + 2, len(steps) + 1)}
        self.expect(*wanted)

    def test_a_circle_through_sources(self):
        self.plant("model/planted_above.h", "#pragma once", "// what both need")
        self.plant("model/planted_above.cpp", '#include "model/planted_above.h"', '#include "model/planted_below.h"')
        self.plant("model/planted_below.h", "#pragma once", '#include "model/planted_above.h"')
        self.list_header("model", "planted_above.h planted_below.h")
        self.expect(("model/planted_below.h", 2, "circle"))

    def test_json_is_dumped_by_hand(self):
        self.plant("model/file/planted.cpp", "// json.dump() is a comment", "auto text = json.dump(2);", "auto more = json->dump();")
        self.expect(("model/file/planted.cpp", 2, "json text"), ("model/file/planted.cpp", 3, "json text"))

    def test_log_stands_beside_strokes(self):
        self.plant("importer/log/planted.cpp", '#include "importer/strokes/stroke_pair.h"',
                   '#include "importer/trace/curve_trace.h"', '#include "importer/fit/fit_stroke.h"')
        self.expect(("importer/log/planted.cpp", 2, "direction"), ("importer/log/planted.cpp", 3, "direction"))

    def test_step_includes_the_front_door(self):
        self.plant("importer/axes/planted.cpp", '#include "importer/importer.h"')
        self.expect(("importer/axes/planted.cpp", 1, "direction"))

    def test_step_uses_the_library_of_another(self):
        self.plant("importer/frame/planted.cpp", "#include <tesseract/baseapi.h>")
        self.plant("importer/fit/planted.cpp", "#include <opencv2/core.hpp>")
        self.expect(("importer/frame/planted.cpp", 1, "third party"), ("importer/fit/planted.cpp", 1, "third party"))

    def test_importer_and_playback_never_meet(self):
        self.plant("playback/realtime/planted.h", "#pragma once")
        self.list_header("playback", "realtime/planted.h")
        self.plant("importer/planted.cpp", '#include "playback/realtime/planted.h"')
        self.plant("playback/prepare/planted.cpp", '#include "importer/importer.h"')
        self.expect(("importer/planted.cpp", 1, "importer and playback never meet"),
                    ("playback/prepare/planted.cpp", 1, "importer and playback never meet"))

    def test_playback_folders(self):
        self.plant("playback/prepare/planted.h", "#pragma once")
        self.list_header("playback", "prepare/planted.h")
        self.plant("playback/realtime/planted.cpp", '#include "playback/prepare/planted.h"', '#include "model/button.h"')
        self.plant("playback/device/planted.cpp", '#include "playback/prepare/planted.h"', "#include <portaudio.h>",
                   '#include "model/result.h"', '#include "model/button.h"')
        self.plant("playback/offline/planted.cpp", '#include "playback/prepare/planted.h"', "#include <sndfile.h>",
                   "#include <portaudio.h>")
        self.expect(("playback/realtime/planted.cpp", 1, "direction"), ("playback/realtime/planted.cpp", 2, "direction"),
                    ("playback/device/planted.cpp", 1, "direction"),
                    ("playback/device/planted.cpp", 4, "direction"), ("playback/offline/planted.cpp", 3, "third party"))

    def test_callback_asks_a_clock(self):
        self.plant("playback/realtime/planted.cpp", "#include <array>", "#include <chrono>", "#include <mutex>",
                   "#include <readerwriterqueue/readerwriterqueue.h>")
        self.expect(("playback/realtime/planted.cpp", 2, "callback"), ("playback/realtime/planted.cpp", 3, "callback"))

    def test_nothing_includes_editor(self):
        self.plant("editor/planted.h", "#pragma once")
        self.list_header("editor", "planted.h")
        self.plant("playback/planted.cpp", '#include "editor/planted.h"')
        self.expect(("playback/planted.cpp", 1, "nothing includes editor"))

    def test_editor_passes_the_front_door_by(self):
        self.plant("editor/planted.cpp", '#include "importer/importer.h"', '#include "importer/trace/trace_loop.h"',
                   "#include <QWidget>", "#include <qcustomplot.h>", '#include "planted.moc"')
        self.expect(("editor/planted.cpp", 2, "front door"))

    def test_program_passes_the_door_of_the_switch_library_by(self):
        self.plant("importer/program/planted.cpp", '#include "importer/switch_library.h"', '#include "importer/library/store.h"')
        self.expect(("importer/program/planted.cpp", 2, "direction"))

    def test_library_in_a_shared_header(self):
        self.plant("editor/planted.cpp", '#include "importer/importer.h"')
        line = self.append("importer/trace/curve_trace.h", "#include <opencv2/core.hpp>")  # reached through importer.h
        self.expect(("importer/trace/curve_trace.h", line, "third party in a shared header"))

    def test_posix_outside_its_places(self):
        self.plant("importer/page/planted.cpp", "#include <sys/mman.h>")
        self.plant("model/file/planted.cpp", "#include <unistd.h>")
        self.plant("importer/batch/planted.cpp", "#include <sys/wait.h>")
        self.plant("playback/device/planted.cpp", "#include <termios.h>")
        self.expect(("importer/page/planted.cpp", 1, "POSIX"), ("model/file/planted.cpp", 1, "POSIX"))

    def test_unknown_library(self):
        self.plant("importer/page/planted.cpp", "#include <zstd.h>")
        self.expect(("importer/page/planted.cpp", 1, "unknown library"))

    def test_form_of_an_include(self):
        self.plant("model/planted.cpp", '#include "result.h"', "#include <model/result.h>", "#include MODEL_HEADER",
                   '# include "model/result.cpp"', '// #include "nowhere.h"', '/* #include "nowhere.h"', "*/")
        self.expect(("model/planted.cpp", 1, "form"), ("model/planted.cpp", 2, "form"), ("model/planted.cpp", 3, "form"),
                    ("model/planted.cpp", 4, "headers only"))

    def test_tests_keep_the_form_too(self):
        self.plant("tests/model/planted_test.cpp", '#include "../../model/result.h"', "#include <catch2/catch.hpp>",
                   'const char* text = R"(', '#include "nowhere.h"', ')";')
        self.expect(("tests/model/planted_test.cpp", 1, "form"))

    def test_room_includes_a_test(self):
        self.plant("tests/model/planted.h", "#pragma once")
        self.plant("model/planted.cpp", '#include "tests/model/planted.h"')
        self.expect(("model/planted.cpp", 1, "direction"))

    def test_header_in_no_header_set(self):
        self.plant("model/planted.h", "#pragma once")
        self.expect(("model/planted.h", 1, "header set"))

    def test_top_level(self):
        self.addCleanup(shutil.rmtree, self.root / "utils")
        (self.root / "utils").mkdir()
        (self.root / "utils" / "strings.txt").touch()
        self.addCleanup((self.root / "LICENSE").write_text, (self.root / "LICENSE").read_text())
        (self.root / "LICENSE").unlink()
        self.expect(("utils", 1, "top level"), ("LICENSE", 1, "top level"))

    def test_program_says_file_line_and_fails(self):
        """As CTest runs it: the exit code and the printed place. A checkout counts only what git tracks."""
        command = [sys.executable, str(HERE / "check_includes.py"), "--root", str(self.root)]
        self.plant("model/planted.cpp", "", '#include "importer/importer.h"')
        run = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(run.returncode, 1)
        self.assertRegex(run.stdout, r"(?m)^model/planted\.cpp:2: model may not include importer .*\[direction\]$")

        self.addCleanup(shutil.rmtree, self.root / ".git")
        subprocess.run(["git", "init", "-q", str(self.root)], check=True)
        run = subprocess.run(command, capture_output=True, text=True)
        self.assertNotIn("planted", run.stdout)
        subprocess.run(["git", "-C", str(self.root), "add", "model/planted.cpp"], check=True)
        run = subprocess.run(command, capture_output=True, text=True)
        self.assertIn("model/planted.cpp:2:", run.stdout)


if __name__ == "__main__":
    unittest.main()
