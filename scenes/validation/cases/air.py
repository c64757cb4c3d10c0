"""V11: an isothermal absorbing medium along the camera's rays (-mp)."""
import math

from bench import Result
from closed_forms import LONG_WAVE, band_radiance

TITLE = "Air along camera rays"
METHOD = ("rtrace -mp with a table of one row at 1 km, transmittance exp(-τ) and path radiance (1 - exp(-τ)) "
          "B(15 °C), before a black panel of 25 °C: at the row, halfway to it and at twice its distance, where "
          "the table is interpolated and extrapolated.")

BAR = 5e-4
UNIT = "W/(m²sr)"
PANEL, AIR = 298.15, 288.15              # K
DISTANCE = 1000.0                        # m
DEPTHS = {0.1: "36.78782", 0.5: "35.03729", 1.0: "33.63683", 2.0: "32.27220"}

SCENE = """# V11. A black panel at 25 degrees Celsius.

void thermal black
0
0
3 {panel} 8 12

black ring panel
0
0
8 0 0 0  0 0 1  0 1
"""


def results(bench):
    octree = bench.octree("panel", SCENE.format(panel=PANEL))
    panel, air = (band_radiance(temperature, *LONG_WAVE) for temperature in (PANEL, AIR))
    [emission] = bench.planck("-b", *LONG_WAVE, AIR)
    rows = []
    for depth, figure in DEPTHS.items():
        transmittance = math.exp(-depth)
        table = f"air_{depth:g}.txt"
        bench.write(table, f"# Air of 15 degrees Celsius, optical depth {depth:g} at {DISTANCE:g} m: distance, "
                           "transmittance, path radiance\n"
                           f"{DISTANCE!r} {transmittance!r} {(1 - transmittance) * emission!r}\n")
        for share, where in ((1, ""), (.5, ", halfway"), (2, ", twice as far")):
            through = math.exp(-depth * share)
            [seen] = bench.trace(octree, [(0, 0, DISTANCE * share, 0, 0, -1)], "-mp", table)
            rows.append(Result(f"τ = {depth:g}{where}", UNIT, panel * through + air * (1 - through), seen, 0, BAR,
                               figure if share == 1 else ""))
    return rows
