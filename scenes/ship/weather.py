"""The hour at which the ship is seen: a clear afternoon, a fresh breeze, the sun on the starboard quarter. Bearings are
degrees from the bow, clockwise seen from above; x points to the bow, y to port, z up."""
import math
from collections import namedtuple

# air, sea and the black sky of the same irradiance in K; sunlight on a plane across it and of the sky in W·m⁻²; heat
# transfer to the wind in W·m⁻²·K⁻¹
Weather = namedtuple("Weather", "air sea sky sun_elevation sun_bearing direct diffuse wind_transfer")

AFTERNOON = Weather(air=288.0, sea=286.5, sky=266.0, sun_elevation=32.0, sun_bearing=118.0, direct=720.0, diffuse=80.0,
                    wind_transfer=22.0)


def direction(elevation, bearing):
    """Unit vector towards it."""
    up, around = math.radians(elevation), math.radians(bearing)
    return math.cos(up) * math.cos(around), -math.cos(up) * math.sin(around), math.sin(up)
