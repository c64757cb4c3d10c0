"""Runs a program and says what it cost."""
import os
import subprocess
import threading
import time

SAMPLE_SECONDS = 0.01


class Cost:
    """user + system seconds, elapsed seconds and the most memory held, in MB."""

    def __init__(self, cpu, elapsed, peak):
        self.cpu, self.elapsed, self.peak = cpu, elapsed, peak


class PeakMemory(threading.Thread):
    """Follows VmHWM of a process until it ends. wait4's ru_maxrss will not do: it starts from what this Python
    process held when it forked."""

    def __init__(self, process):
        super().__init__()
        self.path = f"/proc/{process}/status"
        self.megabytes = 0.0
        self.ended = threading.Event()

    def run(self):
        pause = SAMPLE_SECONDS / 20
        while not self.ended.wait(pause):
            try:
                with open(self.path, encoding="ascii") as status:
                    for line in status:
                        if line.startswith("VmHWM:"):
                            self.megabytes = int(line.split()[1]) / 1024
            except OSError:
                return
            pause = min(SAMPLE_SECONDS, 1.5 * pause)


def run_child(words, folder, environment, stdin, stdout, stderr):
    start = time.monotonic()
    child = subprocess.Popen(words, cwd=folder, env=environment, stdin=stdin, stdout=stdout, stderr=stderr)
    memory = PeakMemory(child.pid)
    memory.start()
    _, status, usage = os.wait4(child.pid, 0)
    elapsed = time.monotonic() - start
    child.returncode = os.waitstatus_to_exitcode(status)
    memory.ended.set()
    memory.join()
    return child.returncode, Cost(usage.ru_utime + usage.ru_stime, elapsed, memory.megabytes)


def timed(words, folder, environment, stdin=None, stdout=None):
    """The cost of a command that reads the file `stdin` and writes the file `stdout`, names relative to `folder`."""
    messages = os.path.join(folder, "stderr.txt")
    with (open(os.path.join(folder, stdin) if stdin else os.devnull, "rb") as source,
          open(os.path.join(folder, stdout) if stdout else os.devnull, "wb") as target,
          open(messages, "wb") as errors):
        status, cost = run_child(words, folder, environment, source, target, errors)
    if status:
        with open(messages, encoding="utf-8", errors="replace") as file:
            raise SystemExit(f"bench: {' '.join(words)}\nended with status {status}: {file.read().strip()}")
    return cost
