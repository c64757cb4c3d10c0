"""A closed room with the irradiance cache: both programs trade error for time there, so both are held against a
converged picture instead of against each other.

That picture is ours without a cache, rendered once and kept in the folder, as two with different seeds: their
difference says what noise is left in their mean.
"""
import math
import os
import random
import statistics
import zlib

from exr import read_exr
from hdr import difference, read_floats
from programs import Task, run_task
from scene_parts import Scene, scaled, write
from timing import timed

USUAL = "-ad 512 -as 128"
CACHE = "-ab 3 -aa .1 -ar 64 -lr 8 -lw 1e-5 -dj 0".split()
# Ours at other numbers of rays, to find the cheapest that is not worse than RADIANCE at its own.
OTHERS = ("-ad 256 -as 64", "-ad 384 -as 96", "-ad 448 -as 112", "-ad 480 -as 120")
# Paths, some of them guided to the panels, that end by roulette alone; all those of a pixel start through its middle.
CONVERGED = "-ab 3 -aa 0 -ad 1 -as 0 -gs 8 -spp 2048 -lr 0 -lw 1e-3 -dj 0 -pj 0 -ps 1 -pa 0".split()
SEEDS = (7, 8)
MOST_BIAS = 0.03
SIZE = 80, 52


def room_scene(folder, scale):
    """A room of 6 by 4 by 3 m with a table, a ball and a post; the light comes from a ceiling panel and a wall heater
    that are `glow` without a radius, so all of it is indirect and goes through the cache."""
    generator = random.Random(12)
    text = ("void plastic wall 0 0 5 .6 .6 .6 0 0\nvoid plastic brick 0 0 5 .6 .4 .3 0 0\nvoid plastic carpet 0 0 5 .3 .35 .4 0 0\n"
            "void plastic wood 0 0 5 .45 .3 .2 0 0\nvoid glow panel 0 0 4 20 20 20 0\nvoid glow heater 0 0 4 12 9 6 0\n"
            "carpet polygon floor 0 0 12 0 0 0 6 0 0 6 4 0 0 4 0\nwall polygon ceiling 0 0 12 0 0 3 0 4 3 6 4 3 6 0 3\n"
            "wall polygon south 0 0 12 0 0 0 0 0 3 6 0 3 6 0 0\nbrick polygon north 0 0 12 0 4 0 6 4 0 6 4 3 0 4 3\n"
            "wall polygon west 0 0 12 0 0 0 0 4 0 0 4 3 0 0 3\nwall polygon east 0 0 12 6 0 0 6 0 3 6 4 3 6 4 0\n"
            "panel polygon light 0 0 12 2 1 2.98 2 3 2.98 4 3 2.98 4 1 2.98\n"
            "heater polygon heat 0 0 12 1 3.98 .3 2.5 3.98 .3 2.5 3.98 1 1 3.98 1\n"
            "wood ring table 0 0 8 3.6 2 .8 0 0 1 0 .9\nwood ring table_under 0 0 8 3.6 2 .76 0 0 -1 0 .9\n"
            "wood cylinder rim 0 0 7 3.6 2 .76 3.6 2 .8 .9\nwood cylinder leg 0 0 7 3.6 2 0 3.6 2 .76 .06\n"
            "wall sphere ball 0 0 4 1.6 2.4 .5 .5\nbrick cylinder post 0 0 7 5.2 3.3 0 5.2 3.3 3 .2\n")
    text += "".join(f"wood sphere apple_{i} 0 0 4 {3.6 + generator.uniform(-.5, .5):.3f} {2 + generator.uniform(-.5, .5):.3f} .88 .08\n"
                    for i in range(6))
    write(folder, "room.rad", text)
    size = scaled(*SIZE, scale)
    return Scene("room", ["room.rad"], CACHE, "-vtv -vp .5 .4 1.6 -vd .8 .62 -.2 -vu 0 0 1 -vh 70 -vv 50".split(), size,
                 "room.rays", size[0] * size[1])


def size_options(scene):
    return ["-x", str(scene.size[0]), "-y", str(scene.size[1])]


def reference_name(scene, folder, seed):
    """Another scene, view or option makes another file."""
    with open(os.path.join(folder, scene.files[0]), encoding="ascii") as file:
        what = " ".join([file.read(), *size_options(scene), *scene.view, *CONVERGED, str(seed)])
    return os.path.join(folder, f"room_{zlib.crc32(what.encode()):08x}.exr")


def converged(ours, scene, folder):
    """The values of the reference and the noise in them, relative to their mean."""
    pictures = []
    for seed in SEEDS:
        name = reference_name(scene, folder, seed)
        if not os.path.exists(name):
            words = ours.command("rpict", threads=0) + ["-t", "0", *size_options(scene), *scene.view, *CONVERGED, "-seed",
                                                        str(seed), "-o", name, "room.ours.oct"]
            timed(words, folder, ours.environment)
        pictures.append(read_exr(name))
    _, noise = difference(*pictures)
    return [sum(values) / len(values) for values in zip(*pictures)], noise / len(SEEDS)


class Contender:
    """A program with options: what its runs cost, and how far their values are off. Efficiency is 1 / (RMSE^2 x
    seconds)."""

    def __init__(self, programs, options):
        self.programs, self.options, self.costs = programs, options, []
        self.biases, self.squares = [], []

    def run(self, scene, folder, reference, noise, seed):
        """Each run draws other rays: ours by -seed, RADIANCE of itself."""
        options = [*scene.options, *self.options.split()] + (["-seed", str(seed)] if self.programs.label == "ours" else [])
        task = Task("room", "rtrace", ["-h", "-w-", "-fff", "-ov", *options, "room.{label}.oct"], "raw", scene.rays,
                    read_floats)
        cost, output = run_task(self.programs, scene, task, folder)
        bias, rms = difference(read_floats(output), reference)
        self.costs.append(cost)
        self.biases.append(bias)
        self.squares.append(max(0.0, rms ** 2 - noise ** 2))

    @property
    def seconds(self):
        return statistics.median(cost.cpu for cost in self.costs)

    @property
    def error(self):
        return math.sqrt(statistics.fmean(self.squares))

    @property
    def bias(self):
        return statistics.fmean(self.biases)

    def as_good_as(self, other):
        return self.error <= other.error and abs(self.bias) <= MOST_BIAS

    def line(self, other):
        ratio = ""
        if other:
            efficiency = (other.error / self.error) ** 2 * other.seconds / self.seconds
            ratio = f"{other.seconds / self.seconds:7.2f}x{efficiency:12.2f}"
        return (f"{self.programs.label:10}{self.options:26}{self.seconds:8.2f}{max(c.peak for c in self.costs):7.0f}"
                f"{100 * self.bias:+10.3f}{100 * self.error:10.3f}{ratio}")


def compare_room(ours, theirs, runs, scale, folder):
    """Prints the table of the room."""
    scene = room_scene(folder, scale)
    for programs in filter(None, (ours, theirs)):
        run_task(programs, scene, Task("oconv", "oconv", ["-w", *scene.files], "oct"), folder)
    timed(ours.command("vwrays") + ["-ff", *size_options(scene), "-pa", "0", "-pj", "0", *scene.view], folder,
          ours.environment, None, scene.rays)
    reference, noise = converged(ours, scene, folder)
    print(f"\nroom, {scene.size[0]} x {scene.size[1]} rays, {' '.join(CACHE)}\nerrors against a converged picture; the "
          f"{100 * noise:.2f} % of noise in it are taken off the RMSE\n{'program':10}{'options':26}{'s':>8}{'MB':>7}"
          f"{'bias %':>10}{'RMSE %':>10}" + (f"{'ratio':>8}{'efficiency':>12}" if theirs else ""), flush=True)
    radiance = Contender(theirs, USUAL) if theirs else None
    own = [Contender(ours, options) for options in (USUAL, *OTHERS)]
    everybody = list(filter(None, [radiance, *own]))
    for run in range(runs):
        for contender in everybody:
            contender.run(scene, folder, reference, noise, run + 1)
    for contender in everybody:
        print(contender.line(radiance), flush=True)
    if radiance:
        good = [contender for contender in own if contender.as_good_as(radiance)]
        best = min(good, key=lambda contender: contender.seconds, default=None)
        limit = f"at no higher RMSE and bias within {100 * MOST_BIAS:g} %"
        print(f"{limit}: {radiance.seconds / best.seconds:.2f}x, with {best.options}" if best else f"none is {limit}")
