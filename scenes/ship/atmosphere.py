#!/usr/bin/env python3
"""A clear marine atmosphere in two bands, simple enough to be written down: what the sky radiates, what the sun brings,
what the air on the way takes and gives. Where an atmosphere code is at hand, genirsky reads its files instead.

    atmosphere.py lwir|mwir sky > sky.txt       # 210 radiances for genirsky
    atmosphere.py lwir|mwir path > path.air     # for rpict's -mp

A share `opaque` of the band is black within metres (carbon dioxide and water lines); the rest has the optical depth
`zenith_depth` straight up and `per_km` along the surface. Radiance is in W·m⁻²·sr⁻¹ in the band, angles are in degrees.
"""
import argparse
import math
from collections import namedtuple

from weather import AFTERNOON

# band um; share of the band's black-body radiance that lines make opaque, and their depth per km; optical depth of the
# rest to the zenith and per km near the sea; height in km from which it radiates; sunlight let through and scattered
Air = namedtuple("Air", "band opaque opaque_per_km zenith_depth per_km height sun scattered")

BANDS = {
    "lwir": Air((8, 12), 0.02, 6.0, 0.42, 0.11, 1.7, 0.60, 0.0),
    "mwir": Air((3, 5), 0.32, 9.0, 0.26, 0.07, 1.5, 0.55, 0.10),
}
LAPSE = 6.5                             # K/km
SUN_KELVIN, SUN_HALF_ANGLE = 5772.0, 0.2666
FORWARD = 0.75                          # asymmetry of the haze that scatters sunlight

DISTANCES = (50, 100, 200, 400, 700, 1000, 1500, 2000, 3000, 5000, 10000, 20000, 40000)

C1, C2 = 1.191042972397188e8, 14387.768775043      # 2hc² in W·m⁻²·sr⁻¹·µm⁴ and hc/k in µm·K


def black_body(kelvin, band, steps=40):
    """Radiance in the band, by Simpson's rule."""
    low, high = band
    width = (high - low) / steps
    total = 0.0
    for i in range(steps + 1):
        wavelength = low + i * width
        weight = 1 if i in (0, steps) else 4 if i % 2 else 2
        total += weight * C1 / wavelength ** 5 / math.expm1(C2 / (wavelength * kelvin))
    return total * width / 3


def air_mass(zenith):
    """Kasten and Young, Applied Optics 28 (1989) 4735."""
    return 1 / (math.cos(math.radians(zenith)) + 0.50572 * (96.07995 - zenith) ** -1.6364)


def haze(cosine):
    """Henyey and Greenstein's phase function [1/sr]."""
    g = FORWARD
    return (1 - g * g) / (4 * math.pi * (1 + g * g - 2 * g * cosine) ** 1.5)


def sky_radiance(air, weather, zenith, bearing):
    """Air of the surface's temperature, cooler where it is seen further up, and sunlight that haze scatters."""
    mass = air_mass(zenith)
    opacity = 1 - math.exp(-air.zenith_depth * mass)
    glow = (air.opaque * black_body(weather.air, air.band)
            + (1 - air.opaque) * opacity * black_body(weather.air - LAPSE * air.height / mass, air.band))
    z, s = math.radians(zenith), math.radians(90 - weather.sun_elevation)
    turn = math.radians(bearing - weather.sun_bearing)
    cosine = math.cos(z) * math.cos(s) + math.sin(z) * math.sin(s) * math.cos(turn)
    sunlight = air.sun * black_body(SUN_KELVIN, air.band) * math.pi * math.sin(math.radians(SUN_HALF_ANGLE)) ** 2
    return glow + opacity * air.scattered * sunlight * haze(cosine)


def sky_text(air, weather):
    """21 lines, bearing 0, 18 .. 360, of ten radiances, zenith angle 0, 10 .. 90."""
    return "".join(" ".join(f"{sky_radiance(air, weather, 10 * h, 18 * r):.6g}" for h in range(10)) + "\n"
                   for r in range(21))


def path_text(air, weather):
    """Lines of distance in metres, transmittance and path radiance."""
    text = "#% bands {:g} {:g}\n".format(*air.band)
    for metres in DISTANCES:
        lines, rest = math.exp(-air.opaque_per_km * metres / 1000), math.exp(-air.per_km * metres / 1000)
        passed = air.opaque * lines + (1 - air.opaque) * rest
        text += f"{metres} {passed:.6g} {(1 - passed) * black_body(weather.air, air.band):.6g}\n"
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("band", choices=BANDS)
    parser.add_argument("what", choices=("sky", "path"))
    options = parser.parse_args()
    print({"sky": sky_text, "path": path_text}[options.what](BANDS[options.band], AFTERNOON), end="")


if __name__ == "__main__":
    main()
