"""What scenes of the bench are made of: a Scene, files of text and rays, and the 210-sample sky."""
import array
import dataclasses
import math
import os


@dataclasses.dataclass(frozen=True)
class Scene:
    """What to render: scene files, options of both programs, view and size of the picture, file of rays, and where it
    has one the OBJ file of the same triangles."""
    name: str
    files: list
    options: list
    view: list
    size: tuple
    rays: str
    ray_count: int
    obj: str = ""

    @property
    def file_name(self):
        return self.name.replace(" ", "_")


def write(folder, name, text):
    with open(os.path.join(folder, name), "w", encoding="ascii") as file:
        file.write(text)
    return name


def write_rays(path, rays):
    """6 floats a ray, as `rtrace -ff` reads them."""
    values = array.array("f")
    for ray in rays:
        values.extend(ray)
    with open(path, "wb") as file:
        values.tofile(file)


def unit_vector(generator, lowest_z=-1.0):
    z = generator.uniform(lowest_z, 1.0)
    turn, r = generator.uniform(0, 2 * math.pi), math.sqrt(1 - z * z)
    return r * math.cos(turn), r * math.sin(turn), z


def rays_from_above(generator, count, low, high, away):
    """Rays towards points spread over a box, from a distance `away` in directions spread over the upper half."""
    for _ in range(count):
        target = [generator.uniform(a, b) for a, b in zip(low, high)]
        back = unit_vector(generator, 0.02)
        yield tuple(t + away * d for t, d in zip(target, back)) + tuple(-d for d in back)


def scaled(width, height, scale):
    """The size of a picture of `scale` times as many pixels."""
    return round(width * math.sqrt(scale)), round(height * math.sqrt(scale))


def sky_samples():
    """210 sky radiances, 21 azimuths x 10 zenith angles: brighter towards the horizon and towards azimuth 54 deg."""
    samples = []
    for column in range(21):
        for row in range(10):
            zenith, azimuth = math.radians(10 * row), math.radians(18 * column)
            glow = 1 + .6 * math.exp(-3 * (1 - math.cos(azimuth - math.radians(54)))) * math.sin(zenith)
            samples.append(18 + 14 * (1 - math.cos(zenith)) ** 2 * glow)
    return samples


def sky_text():
    """210-sample sky over a constant sea, Z up."""
    samples = " ".join(f"{value:.5g}" for value in sky_samples())
    return ("void brightfunc sky_table 4 skybr skyfuncs/hemisky.cal -rx 90 0 210 " + samples + "\n"
            "sky_table glow sky_glow 0 0 4 1 1 1 0\nsky_glow source sky 0 0 4 0 0 1 180\n"
            "void glow sea_glow 0 0 4 34 34 34 0\nsea_glow source sea 0 0 4 0 0 -1 180\n")


def sun_text(radiance):
    """A sun of 0.533 deg that is a light source."""
    return f"void light sun 0 0 3 {radiance:g} {radiance:g} {radiance:g}\nsun source solar 0 0 4 .4 -.6 .7 .533\n"
