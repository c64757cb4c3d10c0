"""The scenes of the bench, in materials that RADIANCE has too, so that both programs get the same text.

Each maker writes its files into a folder and returns a Scene; `scale` multiplies its rays.
"""
import os
import random
import sys

from make_hull import write_ship
from scene_parts import Scene, rays_from_above, scaled, sky_text, sun_text, unit_vector, write, write_rays

HERE = os.path.dirname(os.path.abspath(__file__))
PANELS = os.path.join(HERE, os.pardir, "scenes", "validation", "panels")

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
    return Scene("panels", [os.path.join(PANELS, "sky.rad"), "panels_plain.rad"],
                 "-ab 1 -ad 256 -as 0 -aa 0 -st 0 -lr 8 -lw 1e-6".split(),
                 ["-vf", os.path.join(PANELS, "above.vf")], scaled(640, 96, scale), "panels.rays", count)


def sky_scene(folder, scale):
    """Nothing but the sampled sky: what a function costs that is evaluated for every ray."""
    write(folder, "sky210.rad", sky_text())
    generator = random.Random(8)
    count = round(1000000 * scale)
    write_rays(os.path.join(folder, "sky.rays"), ((0, 0, 0) + unit_vector(generator, 0.0) for _ in range(count)))
    return Scene("sky 210", ["sky210.rad"], ["-ab", "0"], "-vth -vp 0 0 0 -vd 0 0 1 -vu 0 1 0 -vh 180 -vv 180".split(),
                 scaled(1000, 1000, scale), "sky.rays", count)


def ship_scene(name, detail, size, count, folder):
    """A ship under sun and sampled sky, with two diffuse bounces; its triangles as .rad and as OBJ. There are enough
    rays for ours, too, to trace longer than it loads."""
    scene = Scene(name, ["hull_sky.rad", f"ship_{detail:g}.rad"],
                  "-ab 2 -ad 16 -as 0 -aa 0 -dj 0 -lr 4 -lw 1e-4".split(),
                  "-vtv -vp 190 -150 35 -vd -.65 .75 -.13 -vu 0 0 1 -vh 36 -vv 18.46".split(), size,
                  f"ship_{detail:g}.rays", count, f"ship_{detail:g}.obj")
    with (open(os.path.join(folder, scene.files[1]), "w", encoding="ascii") as file,
          open(os.path.join(folder, scene.obj), "w", encoding="ascii") as obj):
        triangles = write_ship(file, detail, infrared=False, obj=obj)
    print(f"bench: {name} of {triangles} triangles", file=sys.stderr)
    write(folder, "hull_sky.rad", sky_text() + sun_text(4e5))
    write_rays(os.path.join(folder, scene.rays),
               rays_from_above(random.Random(9), count, (0, -7, 0), (120, 7, 15), 100))
    return scene


def hull_scene(folder, scale):
    """200 000 triangles: traversal, shadow rays and two diffuse bounces."""
    return ship_scene("hull", 1.0, scaled(1600, 800, scale), round(150000 * scale), folder)


def large_hull_scene(folder, scale):
    """A million triangles: the same where most of the hierarchy lies beyond the caches, and loading matters."""
    return ship_scene("hull 1M", 2.24, scaled(2000, 1000, scale), round(200000 * scale), folder)


def glint_scene(bounces):
    """Makes scenes of rough metal under a small bright sun and a constant sky: the lobe's value for the light source,
    16 rays drawn from it and, with a diffuse bounce, a hemisphere of 64."""
    def scene(folder, scale):
        name = f"glint ab{bounces}"
        write(folder, "glint.rad", sun_text(2e5) + "void glow sky_glow 0 0 4 20 20 20 0\nsky_glow source sky 0 0 4 0 0 1 360\n"
              "void metal brushed 0 0 5 .7 .7 .7 .9 .2\nvoid metal worn 0 0 5 .6 .6 .6 .6 .1\n"
              "brushed ring plate 0 0 8 0 0 0 0 0 1 0 6\n" +
              "".join(f"worn sphere ball_{i} 0 0 4 {2 * i - 4} {(i * 7 % 5) - 2} 1 .9\n" for i in range(5)))
        count = round((300000 if bounces == 0 else 60000) * scale)
        write_rays(os.path.join(folder, f"glint_ab{bounces}.rays"),
                   rays_from_above(random.Random(10), count, (-4, -3, 0), (4, 3, 1), 20))
        size = scaled(800, 400, scale if bounces == 0 else scale / 4)
        return Scene(name, ["glint.rad"], f"-ab {bounces} -ad 64 -as 0 -aa 0 -ss 16 -st 0 -dj 0 -lr 6 -lw 1e-4".split(),
                     "-vtv -vp 0 -12 7 -vd 0 .86 -.5 -vu 0 0 1 -vh 56 -vv 29.8".split(), size,
                     f"glint_ab{bounces}.rays", count)
    return scene


def lights_scene(lamps, options, size, count):
    """Makes halls with `lamps` small `light` spheres over a floor with pillars, seen from below the lamps: what light
    sources cost and the rays towards them. With -dt 0 each is asked for its shadow, else the brightest are."""
    def scene(folder, scale):
        kind = "" if "-dt 0" in options else " dt"
        name = f"lights {lamps}{kind}".replace("000", "k")
        generator = random.Random(11)
        text = ["void light lamp 0 0 3 500 500 500\nvoid plastic floor 0 0 5 .5 .5 .5 0 0\nvoid plastic stone 0 0 5 .3 .3 .3 0 0\n"
                "floor polygon ground 0 0 12 -5 -5 0 45 -5 0 45 30 0 -5 30 0\n"]
        text += [f"lamp sphere lamp_{i} 0 0 4 {generator.uniform(0, 40):.3f} {generator.uniform(0, 25):.3f} "
                 f"{generator.uniform(2.5, 3.5):.3f} .04\n" for i in range(lamps)]
        text += [f"stone cylinder pillar_{i} 0 0 7 {4 * (i % 10) + 2} {4 * (i // 10) + 2} 0 {4 * (i % 10) + 2} "
                 f"{4 * (i // 10) + 2} 2 .3\n" for i in range(60)]
        write(folder, f"lights_{lamps}.rad", "".join(text))
        rays = round(count * scale)
        write_rays(os.path.join(folder, f"lights_{lamps}.rays"),
                   ((generator.uniform(0, 40), generator.uniform(0, 25), 2.2, 0, 0, -1) for _ in range(rays)))
        return Scene(name, [f"lights_{lamps}.rad"], options.split(),
                     "-vtl -vp 20 12.5 2.3 -vd 0 0 -1 -vu 0 1 0 -vh 40 -vv 25".split(), scaled(*size, scale),
                     f"lights_{lamps}.rays", rays)
    return scene


SCENES = {
    "panels": panels_scene, "sky": sky_scene, "hull": hull_scene, "hull-1m": large_hull_scene,
    "glint-0": glint_scene(0), "glint-1": glint_scene(1),
    "lights-100": lights_scene(100, "-ab 0 -dt 0 -dj 0", (200, 125), 20000),
    "lights-1000": lights_scene(1000, "-ab 0 -dt 0 -dj 0", (112, 70), 5000),
    "lights-1000-dt": lights_scene(1000, "-ab 0 -dt .05 -dc .5 -dj 0", (112, 70), 5000),
}
