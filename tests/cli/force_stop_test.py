#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""detent-play force on a board behind a pseudo terminal: Ctrl-C, SIGTERM and an unplugged cable leave no force.

Prints how long the end took; nothing here is a timed test.
"""
import argparse
import os
import pty
import re
import signal
import subprocess
import sys
import threading
import time
import tty


def with_sum(body):
    total = 0
    for byte in body.encode():
        total ^= byte
    return f"{body}*{total:02X}\n".encode()


class Board:
    """Answers docs/reference/force-protocol.md with a handle that is held at 2 mm, and keeps every force it was sent."""

    def __init__(self):
        self.master, self.slave = pty.openpty()
        tty.setraw(self.slave)
        self.port = os.ttyname(self.slave)
        self.forces, self.lines, self.open = [], [], True
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self):
        received = b""
        while self.open:
            try:
                received += os.read(self.master, 256)
            except OSError:
                return
            *lines, received = received.split(b"\n")
            for line in lines:
                self.answer(line.decode().rsplit("*", 1)[0])

    def answer(self, body):
        self.lines.append(body)
        if body == "?":
            os.write(self.master, with_sum("I,test,10000,10000000,1000,0,2"))
        elif body.startswith("L,"):
            os.write(self.master, with_sum(body))
        elif match := re.fullmatch(r"F,(\d+),(-?\d+)", body):
            self.forces.append(int(match[2]) * 1e-6)
            # A finger that gives way a little: the handle follows a small push, as one in order does.
            place_nm = 2000000 - int(2e6 * max(-0.09, min(0.09, self.forces[-1])))
            os.write(self.master, with_sum(f"P,{match[1]},{int(time.monotonic() * 1e6)},{place_nm},0"))

    def close(self):
        self.open = False
        os.close(self.slave)
        os.close(self.master)


def running(program, button, board, tries=5):
    """The program, its force risen. On a busy machine the board may seem too slow at first: then it is asked again."""
    command = [program, "force", button, "--device", f"serial:{board.port}", "--rate", "100", "--json", "--log", "stop.csv"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    deadline = time.monotonic() + 30
    while not board.forces or board.forces[-1] < 0.3:
        if process.poll() is not None:
            words = process.communicate()
            assert tries > 1 and b"answers after" in words[1], words
            return running(program, button, board, tries - 1)
        assert time.monotonic() < deadline, "the force never rose"
        time.sleep(0.02)
    return process


def ended(process):
    begin = time.monotonic()
    output, errors = process.communicate(timeout=30)
    return time.monotonic() - begin, output, errors


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--button", required=True)
    arguments = parser.parse_args()
    for number in (signal.SIGINT, signal.SIGTERM):
        board = Board()
        process = running(arguments.program, arguments.button, board)
        process.send_signal(number)
        seconds, _, errors = ended(process)
        print(f"{number.name}: ended after {seconds:.2f} s, code {process.returncode}")
        assert process.returncode in (0, 130), errors
        # The table is taken away before the stop is lifted for whoever comes next.
        assert board.lines[-2:] == ["X", "U"] and board.forces[-1] == 0, (board.lines[-3:], board.forces[-3:])
        board.close()
    board = Board()
    process = running(arguments.program, arguments.button, board)
    board.close()
    time.sleep(1)
    assert process.poll() is None, "a lost cable ended the program"
    process.send_signal(signal.SIGINT)
    seconds, _, errors = ended(process)
    print(f"unplugged, then SIGINT: ended after {seconds:.2f} s, code {process.returncode}")
    assert process.returncode in (0, 130), errors
    return 0


if __name__ == "__main__":
    sys.exit(main())
