"""A folder of programs, ours or RADIANCE's, and the tasks that both are given."""
import dataclasses
import os
from typing import Callable, Optional

from hdr import read_floats, read_hdr
from timing import timed

ONE_RAY = "one.rays"     # for the task "load": all that a program does besides tracing
THREADED = ("rpict", "rtrace")
ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))


class Programs:
    """A folder of programs and the library path they get."""

    def __init__(self, label, folder, libraries, threads_option):
        self.label, self.folder, self.threads_option = label, os.path.abspath(folder), threads_option
        self.environment = {name: value for name, value in os.environ.items() if name != "RENDER_OPTIONS"}
        self.environment["RAYPATH"] = os.pathsep.join(["."] + [os.path.abspath(path) for path in libraries])

    def command(self, name, threads=1):
        path = os.path.join(self.folder, name)
        if not os.access(path, os.X_OK):
            raise SystemExit(f"bench: no program {name} in {self.folder}")
        return [path] + (["-n", str(threads)] if self.threads_option and name in THREADED else [])


def our_programs(folder):
    return Programs("ours", folder, [os.path.join(ROOT, "lib")], threads_option=True)


def their_programs(folder, library):
    """RADIANCE's, with rayinit.cal from `library` or, without it, from $RAYPATH."""
    extra = [library] if library else os.environ.get("RAYPATH", "").split(os.pathsep)
    return Programs("radiance", folder, [path for path in extra if path] + [os.path.join(ROOT, "lib")], False)


@dataclasses.dataclass(frozen=True)
class Task:
    """A run of a program; {label} in its options stands for whose it is."""
    name: str
    program: str
    options: list
    suffix: str                      # of the file with its standard output
    stdin: Optional[str] = None
    reader: Optional[Callable] = None  # of the output, if values can be compared
    rays: int = 0                    # primary ones


def tasks_of(scene):
    octree = scene.file_name + ".{label}.oct"
    width, height = scene.size
    picture = ["-t", "0", "-ps", "1", "-pj", "0", "-pa", "0", "-x", str(width), "-y", str(height)]
    tasks = [
        Task("oconv", "oconv", ["-w", *scene.files], "oct"),
        Task("load", "rtrace", ["-h", "-w-", "-fff", *scene.options, octree], "one", ONE_RAY),
        Task("rpict", "rpict", [*picture, *scene.view, *scene.options, octree], "hdr", None, read_hdr, width * height),
        Task("rtrace", "rtrace", ["-h", "-w-", "-fff", "-ov", *scene.options, octree], "raw", scene.rays, read_floats,
             scene.ray_count),
    ]
    if scene.obj:
        tasks.insert(0, Task("obj2mesh", "obj2mesh", [scene.obj], "rtm"))
    return tasks


def run_task(programs, scene, task, folder, threads=1):
    """What it cost and the file of its output."""
    words = programs.command(task.program, threads) + [word.format(label=programs.label) for word in task.options]
    output = f"{scene.file_name}.{programs.label}.{task.suffix}"
    return timed(words, folder, programs.environment, task.stdin, output), os.path.join(folder, output)
