"""Runs a program and says what it cost."""
import os
import subprocess
import time


class Cost:
    """user + system seconds, elapsed seconds and the most memory held, in MB."""

    def __init__(self, cpu, elapsed, peak):
        self.cpu, self.elapsed, self.peak = cpu, elapsed, peak


def timed(words, folder, environment, stdin=None, stdout=None):
    """The cost of a command that reads the file `stdin` and writes the file `stdout`, names relative to `folder`."""
    source = open(os.path.join(folder, stdin), "rb") if stdin else subprocess.DEVNULL
    target = open(os.path.join(folder, stdout), "wb") if stdout else subprocess.DEVNULL
    messages = open(os.path.join(folder, "stderr.txt"), "wb")
    try:
        start = time.monotonic()
        child = subprocess.Popen(words, cwd=folder, env=environment, stdin=source, stdout=target, stderr=messages)
        _, status, usage = os.wait4(child.pid, 0)
        elapsed = time.monotonic() - start
        child.returncode = os.waitstatus_to_exitcode(status)
    finally:
        for file in (source, target, messages):
            if not isinstance(file, int):
                file.close()
    if child.returncode:
        with open(os.path.join(folder, "stderr.txt"), encoding="utf-8", errors="replace") as file:
            raise SystemExit(f"bench: {' '.join(words)}\nended with status {child.returncode}: {file.read().strip()}")
    return Cost(usage.ru_utime + usage.ru_stime, elapsed, usage.ru_maxrss / 1024)
