"""The three scenes of the bench, in materials that RADIANCE has too, so that both programs get the same octree text.

Each maker writes its files into a folder and returns a Scene.
"""
import array
import math
import os
import random
import sys

from make_hull import write_ship

HERE = os.path.dirname(os.path.abspath(__file__))
PANELS = os.path.join(HERE, os.pardir, "scenes", "validation", "panels")


class Scene:
    """What to render: scene files, options of both programs, view and size of the picture, file of rays."""

    def __init__(self, name, files, options, view, size, rays, ray_count):
        self.name, self.files, self.options = name, files, options
        self.view, self.size, self.rays, self.ray_count = view, size, rays, ray_count


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


def write(folder, name, text):
    with open(os.path.join(folder, name), "w", encoding="ascii") as file:
        file.write(text)
    return name


PANEL_MATERIALS = """\
void glow panel_1  0 0 4 37.35 37.35 37.35 0
void plastic panel_2  0 0 5 1 1 1 0 0
void metal panel_3  0 0 5 1 1 1 1 0
void plastic panel_4  0 0 5 .5 .5 .5 0 0
void metal panel_5  0 0 5 .5 .5 .5 1 0
void mixfunc panel_6  4 panel_2 panel_3 .5 . 0 0
void plastic panel_7  0 0 5 .5 .5 .5 .2 .15
"""
SEVEN_PANELS = PANEL_MATERIALS + "".join(
    f"panel_{k + 1} polygon square_{k + 1} 0 0 12 {1.1 * k:g} 0 0 {1.1 * k + 1:g} 0 0 {1.1 * k + 1:g} 0 1 {1.1 * k:g} 0 1\n"
    for k in range(7))


def panels_scene(folder, scale):
    """The validation's sky, sea and squares, with materials of RADIANCE: glow, plastic, metal, rough metal, mixtures."""
    write(folder, "panels_plain.rad", SEVEN_PANELS)
    generator = random.Random(7)
    count = round(20000 * scale)
    write_rays(os.path.join(folder, "panels.rays"),
               ((generator.uniform(0, 7.6), -5, generator.uniform(0, 1) + 2.887, 0, .8660254, -.5) for _ in range(count)))
    size = round(640 * math.sqrt(scale)), round(96 * math.sqrt(scale))
    return Scene("panels", [os.path.join(PANELS, "sky.rad"), "panels_plain.rad"],
                 "-ab 1 -ad 256 -as 0 -aa 0 -st 0 -lr 8 -lw 1e-6".split(),
                 ["-vf", os.path.join(PANELS, "above.vf")], size, "panels.rays", count)


def sky_scene(folder, scale):
    """Nothing but the sampled sky: what a function costs that is evaluated for every ray."""
    write(folder, "sky210.rad", sky_text())
    generator = random.Random(8)
    count = round(1000000 * scale)
    write_rays(os.path.join(folder, "sky.rays"), ((0, 0, 0) + unit_vector(generator, 0.0) for _ in range(count)))
    side = round(1000 * math.sqrt(scale))
    return Scene("sky 210", ["sky210.rad"], ["-ab", "0"], "-vth -vp 0 0 0 -vd 0 0 1 -vu 0 1 0 -vh 180 -vv 180".split(),
                 (side, side), "sky.rays", count)


def hull_scene(folder, scale):
    """A ship of 200 000 triangles under sun and sampled sky: traversal, shadow rays and one diffuse bounce."""
    with open(os.path.join(folder, "hull.rad"), "w", encoding="ascii") as file:
        triangles = write_ship(file, 1.0, infrared=False)
    print(f"bench: hull of {triangles} triangles", file=sys.stderr)
    write(folder, "hull_sky.rad", sky_text() + "void light sun 0 0 3 4e5 4e5 4e5\n"
          "sun source solar 0 0 4 .4 -.6 .7 .533\n")
    generator = random.Random(9)
    count = round(100000 * scale)

    def ray():
        target = generator.uniform(0, 120), generator.uniform(-7, 7), generator.uniform(0, 15)
        away = unit_vector(generator, 0.02)
        return tuple(t + 100 * d for t, d in zip(target, away)) + tuple(-d for d in away)

    write_rays(os.path.join(folder, "hull.rays"), (ray() for _ in range(count)))
    size = round(960 * math.sqrt(scale)), round(480 * math.sqrt(scale))
    return Scene("hull", ["hull_sky.rad", "hull.rad"], "-ab 1 -ad 16 -as 0 -aa 0 -dj 0 -lr 4 -lw 1e-4".split(),
                 "-vtv -vp 190 -150 35 -vd -.65 .75 -.13 -vu 0 0 1 -vh 36 -vv 18.46".split(), size, "hull.rays", count)


SCENES = {"panels": panels_scene, "sky": sky_scene, "hull": hull_scene}
