"""V3: closed enclosures of one temperature. Whatever their walls are made of, they are as bright as a black body, in
every direction; and what a wall by itself emits is what Kirchhoff's law leaves it."""
import functools
import math
import os

from bench import PATHS, SIGMAS, Result, looking_at, mean_of, on_sphere, turned
from cases.furnace_walls import BANDS, DATA, SPECTRAL_WALLS, TABLES, WALLS, table
from cases.wall_emissivity import glass_emissivity, metal_emissivity, plastic_emissivity, table_emissivity
from closed_forms import LONG_WAVE, band_radiance
from panels.quadrature import Table

TITLE = "Isothermal enclosures"
METHOD = ("A thermal sphere of each material, and a black one around it for those that let light through; rays "
          "within it that meet the wall at 0 to 87°, the row is for the worst angle. Then walls alone in the "
          "cold, whose emissivity is 1 - R - T by a formula or by quadrature; its bar is absolute.")

BAR = 1e-3
UNIT = "W/(m²sr)"
FIGURE = "38.50042"
TEMPERATURE = 300.0          # K
ANGLES = (0, 45, 75, 87)     # degrees of incidence
RAYS = 600                   # for each angle
CHANNELS = 8
OPTIONS = (*PATHS, "-ad", 1, "-lw", 3e-4)      # one ray from each diffuse hit


def cached(material):
    """Interpolated everywhere from a few values, which so need to be exact: roulette spares more of their rays. What it
    leaves of walls that reflect .9 fades after twice as many bounces as -lw counts on; where a hit has many rays, as
    those of tables and mixtures, their mean needs less."""
    least_weight = 1e-6 if "mix" in material else 1e-5 if "nrlbrdf" in material else 1e-17
    return ("-ab", 200, "-ad", 64, "-lr", 0, "-lw", least_weight, "-aa", 1)


ENCLOSURE = """# V3. An enclosure of 300 K: a sphere of this material, in a black one in case it lets light through.

{material}
void thermal wall
1 {modifier}
0
3 {temperature} 8 12

wall bubble enclosure
0
0
4 0 0 0 1

void thermal black_wall
0
0
3 {temperature} 8 12

black_wall bubble beyond
0
0
4 0 0 0 3
"""

ALONE = """# V3. A wall of 300 K with nothing around it: what it emits.

{material}
void thermal wall
1 {modifier}
0
{temperature}

wall ring plate
0
0
8 0 0 0  0 0 1  0 1
"""


def worst(rows):
    """That which comes closest to its bar or to four standard errors."""
    return max(rows, key=lambda row: max(row.sigmas / SIGMAS, row.share_of_bar))


def rays_to_wall(bench, degrees):
    """From within the unit sphere to random points of it at this angle of incidence."""
    angle = math.radians(degrees)
    for _ in range(RAYS):
        normal = on_sphere(bench.random.random(), bench.random.random())
        azimuth = 2 * math.pi * bench.random.random()
        local = (math.sin(angle) * math.cos(azimuth), math.sin(angle) * math.sin(azimuth), math.cos(angle))
        yield looking_at(normal, turned(local, tuple(-x for x in normal)), math.cos(angle))


def furnace(bench, name, material, number):
    octree = bench.octree(f"furnace_{number}", ENCLOSURE.format(material=material, temperature=TEMPERATURE,
                                                                modifier="m" if material else "void"))
    rays = [ray for degrees in ANGLES for ray in rays_to_wall(bench, degrees)]
    radiances = bench.trace(octree, rays, *OPTIONS, interpolation=cached(material))
    estimates = [mean_of(radiances[i * RAYS:(i + 1) * RAYS]) for i in range(len(ANGLES))]
    closed = band_radiance(TEMPERATURE, *LONG_WAVE)
    return worst([Result(f"{name}, {degrees}°", UNIT, closed, seen.mean, seen.error, BAR, FIGURE)
                  for degrees, seen in zip(ANGLES, estimates)])


def spectral(bench, name, material, number):
    """Each channel is CHANNELS times the radiance in its band; channel 0 has the longest waves."""
    octree = bench.octree(f"spectral_{number}", ENCLOSURE.format(material=material, temperature=TEMPERATURE,
                                                               modifier="m"))
    low, high = LONG_WAVE
    rays = [ray for degrees in ANGLES for ray in rays_to_wall(bench, degrees)]
    channels = ("-co+", "-cs", CHANNELS, "-cw", 1000 * low, 1000 * high)
    values = bench.trace_channels(octree, rays, CHANNELS, *channels, *OPTIONS, interpolation=cached(material))
    width = (high - low) / CHANNELS
    rows = []
    for c in range(CHANNELS):
        band = (high - (c + 1) * width, high - c * width)
        seen = mean_of(values[c::CHANNELS])
        rows.append(Result(f"{name}, {band[0]:g}–{band[1]:g} µm", UNIT,
                           CHANNELS * band_radiance(TEMPERATURE, *band), seen.mean, seen.error, BAR))
    return rows


def alone(bench):
    """Emissivity: radiance in the cold over that of a black body."""
    walls = [("black", "", lambda cosine: 1.0),
             ("plastic, diffuse .9", "", lambda cosine: .1),
             ("plastic, smooth", "", functools.partial(plastic_emissivity, .4, .1)),
             ("metal, smooth", "", functools.partial(metal_emissivity, .7)),
             ("trans, smooth", "", functools.partial(plastic_emissivity, .7, .1)),
             ("plastic, rough .3", "", lambda cosine: 1 - .3 - .7 * .6),
             ("metal, rough .3", "", lambda cosine: 1 - .6),
             ("trans, rough .15", "", lambda cosine: 1 - .1 - .9 * .7),
             ("glass", "", functools.partial(glass_emissivity, .8)),
             ("plastic, diffuse .9", ".75", lambda cosine: .75)]
    walls = [(f"{name}{', ε stated' if stated else ''}", WALLS[name], stated, emissivity)
             for name, stated, emissivity in walls]
    walls += [(f"nrlbrdf, {file}", table(file, 1024), "",
               functools.partial(table_emissivity, Table(os.path.join(bench.folder, file)))) for file in TABLES]
    black_body = band_radiance(TEMPERATURE, *LONG_WAVE)
    rows = []
    for number, (name, material, stated, emissivity) in enumerate(walls):
        numbers = f"4 {TEMPERATURE} 8 12 {stated}" if stated else f"3 {TEMPERATURE} 8 12"
        octree = bench.octree(f"alone_{number}", ALONE.format(material=material, temperature=numbers,
                                                              modifier="m" if material else "void"))
        candidates = []
        for degrees in ANGLES:
            angle = math.radians(degrees)
            ray = (-math.sin(angle), 0, math.cos(angle), math.sin(angle), 0, -math.cos(angle))
            seen = mean_of(bench.trace(octree, RAYS * [ray], *OPTIONS, interpolation=cached(material)))
            seen *= 1 / black_body
            candidates.append(Result(f"emissivity of {name}, {degrees}°", "", emissivity(math.cos(angle)), seen.mean,
                                     seen.error, BAR, absolute=True))
        rows.append(worst(candidates))
    return rows


def results(bench):
    for command in TABLES.values():
        bench.run(*command)
    for name, text in DATA.items():
        bench.write(name, text)
    bench.write("bands.brdf", "".join(f"#% band {band}\n{bench.read(file)}" for band, file in BANDS))
    rows = [furnace(bench, name, material, number) for number, (name, material) in enumerate(WALLS.items())]
    for number, (name, material) in enumerate(SPECTRAL_WALLS.items()):
        rows += spectral(bench, name, material, number)
    return rows + alone(bench)
