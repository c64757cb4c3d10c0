"""What the cases share: our programs, random rays, estimates with their standard errors, and results."""
import array
import dataclasses
import math
import os
import random
import shlex
import subprocess

HERE = os.path.dirname(os.path.abspath(__file__))
SIGMAS = 4.0                 # standard errors within which a result must agree
FLOAT_ROUNDING = 1e-6        # relative; the standard error of what has no noise, for values that are 32 bit floats
TEXT_ROUNDING = 1e-9         # the same for values printed with nine digits

# Lobes however weak are sampled, and light paths end by Russian roulette alone, which loses no energy.
PATHS = ("-ab", 1000, "-aa", 0, "-as", 0, "-st", 0, "-lr", 0)
# Added after all others to interpolate diffuse interreflection: walls reflect at most a half, so that 16 bounces leave
# out less than 2e-5.
CACHED = ("-ab", 16, "-ad", 512, "-as", 0, "-ar", 100, "-lr", 100, "-lw", 1e-6)
HUGE = ("-ar", 10 ** 8)    # and for scenes a million times larger than what is measured in them
SPLIT_PATHS = (*PATHS, "-ad", 64, "-lw", 2e-3)      # 64 rays from the first hit, of which each goes on alone


@dataclasses.dataclass(frozen=True)
class Estimate:
    """A mean and the standard error of it."""
    mean: float
    error: float

    def __mul__(self, factor):
        return Estimate(self.mean * factor, self.error * abs(factor))


def mean_of(values):
    """Estimate from independent values."""
    count = len(values)
    mean = math.fsum(values) / count
    variance = math.fsum((value - mean) ** 2 for value in values) / (count - 1) if count > 1 else 0.0
    return Estimate(mean, math.sqrt(variance / count))


def mean_of_groups(values, size):
    """Estimate from groups of `size` values each; the groups, not their values, are independent."""
    return mean_of([math.fsum(values[i:i + size]) / size for i in range(0, len(values), size)])


@dataclasses.dataclass(frozen=True)
class Result:
    """A quantity, what it should be and what we have. `bar` is relative, or with `absolute` in the quantity's unit;
    `figure` is the published number, as it is written, that the closed form must agree with."""
    quantity: str
    unit: str
    closed_form: float
    value: float
    scatter: float
    bar: float
    figure: str = ""
    absolute: bool = False
    rounding: float = FLOAT_ROUNDING

    @property
    def error(self):
        return self.value - self.closed_form

    @property
    def error_percent(self):
        return round(100 * self.error / self.closed_form, 5) + 0.0     # no -0.00000

    @property
    def standard_error(self):
        return max(self.scatter, self.rounding * abs(self.closed_form))

    @property
    def noisy(self):
        return self.scatter > self.rounding * abs(self.closed_form)

    @property
    def sigmas(self):
        return abs(self.error) / self.standard_error

    @property
    def share_of_bar(self):
        off = abs(self.error) if self.absolute else abs(self.error / self.closed_form)
        return off / self.bar

    @property
    def figure_agrees(self):
        """Whether the figure is the closed form, give or take one unit of its last digit."""
        if not self.figure:
            return True
        digits = len(self.figure.partition(".")[2])
        return abs(float(self.figure) - self.closed_form) <= 1.01 * 10 ** -digits

    @property
    def within_bar(self):
        return self.share_of_bar <= 1 and self.figure_agrees    # NaN is not

    @property
    def within(self):
        return self.within_bar and self.sigmas <= SIGMAS    # nor here

    def number(self, value):
        """A value of the quantity as text: six decimals, fewer for large ones."""
        return f"{value:.{max(0, 6 - max(0, math.ceil(math.log10(abs(self.closed_form) / 1000))))}f}"

    @property
    def bar_text(self):
        return f"{self.bar:.3g} {self.unit}".rstrip() if self.absolute else f"{100 * self.bar:g} %"


class Bench:
    """Runs our programs in the output folder. One for each case, named for it, so that its random numbers do not
    depend on which other cases are run."""

    def __init__(self, programs, folder, name, accuracy=0):
        self.folder = os.path.join(folder, name)
        os.makedirs(self.folder, exist_ok=True)
        self.programs = programs
        self.random = random.Random(name)
        self.commands = []
        self.cached = (*CACHED, "-aa", accuracy) if accuracy > 0 else ()
        self.environment = {name: value for name, value in os.environ.items() if name != "RENDER_OPTIONS"}
        self.environment["PATH"] = programs + os.pathsep + self.environment.get("PATH", "")
        self.environment["RAYPATH"] = os.pathsep.join([".", HERE, os.path.join(programs, os.pardir, "lib"),
                                                       os.path.join(HERE, os.pardir, os.pardir, "lib")])

    def run(self, *words, standard_input=b"", accepted=(0,)):
        """Standard output of a command, as bytes. Its exit status must be among those `accepted`."""
        words = [str(word) for word in words]
        self.commands.append(shlex.join(words))
        result = subprocess.run(words, cwd=self.folder, env=self.environment, input=standard_input,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        if result.returncode not in accepted:
            raise SystemExit(f"validation: '{shlex.join(words)}' ended with status {result.returncode}\n"
                             + result.stderr.decode(errors="replace"))
        return result.stdout

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def read(self, name):
        with open(os.path.join(self.folder, name), encoding="utf-8") as file:
            return file.read()

    def octree(self, name, scene):
        """Compiles a scene's text, which stays in the folder as `name`.rad. Returns the octree's name."""
        self.write(name + ".rad", scene)
        with open(os.path.join(self.folder, name + ".oct"), "wb") as file:
            file.write(self.run("oconv", name + ".rad"))
        self.commands[-1] += f" > {name}.oct"
        return name + ".oct"

    def trace(self, octree, rays, *options, cached=True, interpolation=()):
        """What rtrace says of rays: a list of values, that of the first channel for a grey scene. A ray is six
        numbers, origin and direction. Where this run
        interpolates: cached, whether it does here; interpolation, options of the scene's own for that."""
        return self.trace_channels(octree, rays, 3, *options, cached=cached, interpolation=interpolation)[::3]

    def trace_channels(self, octree, rays, channels, *options, cached=True, interpolation=()):
        """All channels of one ray after the other."""
        data = array.array("d", (number for ray in rays for number in ray))
        output = self.run("rtrace", "-h-", "-w-", "-fdf", "-n", 2, *options, *((*self.cached, *interpolation) if cached and self.cached else ()), octree, standard_input=data.tobytes())
        values = array.array("f", output)
        if len(values) != channels * len(data) // 6:
            raise SystemExit(f"validation: {len(values)} values of {channels} channels for {len(data) // 6} rays")
        if not all(map(math.isfinite, values)):
            raise SystemExit("validation: a radiance is not finite")
        return values

    def planck(self, *words):
        """Numbers that the program planck prints."""
        return [float(word) for word in self.run("planck", *words).split()]

    def lattice(self, count, dimensions=2):
        """`count` points of the unit cube, evenly spread and shifted at random: multiples of powers of 1/g, the root of
        g^(d+1) = g + 1 (a golden number of d dimensions). Such lattices are independent of each other, the points of
        one are not."""
        root = 2.0
        for _ in range(40):
            root = (1 + root) ** (1 / (dimensions + 1))
        axes = [(self.random.random(), root ** -(axis + 1)) for axis in range(dimensions)]
        return [tuple((shift + i * step) % 1 for shift, step in axes) for i in range(count)]


def on_sphere(u, v):
    """Point of the unit sphere for a point of the unit square, uniform."""
    z = 2 * u - 1
    r, phi = math.sqrt(1 - z * z), 2 * math.pi * v
    return r * math.cos(phi), r * math.sin(phi), z


def lambertian(u, v):
    """Direction around z for a point of the unit square, with density cos / pi."""
    r, phi = math.sqrt(u), 2 * math.pi * v
    return r * math.cos(phi), r * math.sin(phi), math.sqrt(1 - u)


def turned(local, axis):
    """A direction around z, turned to be one around `axis`, a unit vector (Duff et al., JCGT 6 (2017))."""
    x, y, z = axis
    sign = math.copysign(1.0, z)
    a = -1 / (sign + z)
    b = x * y * a
    u = (1 + sign * x * x * a, sign * b, -sign * x)
    v = (b, sign + y * y * a, -y)
    return tuple(local[0] * u[i] + local[1] * v[i] + local[2] * axis[i] for i in range(3))


def along(point, direction, distance):
    return tuple(p + d * distance for p, d in zip(point, direction))


def looking_at(point, direction, distance):
    """The ray that reaches `point` from `direction` (a unit vector away from it), begun at `distance`."""
    return *along(point, direction, distance), *(-d for d in direction)


def grey_wall(name, emissivity, temperature, band=(8, 12)):
    """A diffuse grey surface of this emissivity and temperature as modifier `name`."""
    r = 1 - emissivity
    return (f"void plastic {name}_skin\n0\n0\n5 {r!r} {r!r} {r!r} 0 0\n\n"
            f"void thermal {name}\n1 {name}_skin\n0\n3 {temperature!r} {band[0]} {band[1]}\n\n")
