"""Writes index.html: the pictures, figures and commands of both bands in one file that needs nothing else."""
import base64
import html
import os

from atmosphere import BANDS
from weather import AFTERNOON

STYLE = """
:root { color-scheme: light dark; --line: #8884 }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 70rem; margin: 2rem auto; padding: 0 1rem }
h1 { font-size: 1.7rem; margin-bottom: .2rem } h2 { font-size: 1.15rem; margin-top: 2rem }
table { border-collapse: collapse; font-variant-numeric: tabular-nums }
th, td { padding: .25rem 1rem; text-align: right; border-bottom: 1px solid var(--line) }
th:first-child, td:first-child { text-align: left }
img { max-width: 100%; display: block; border-radius: 4px }
pre { overflow-x: auto; padding: .8rem; border: 1px solid var(--line); border-radius: 4px; font-size: .85rem }
figcaption { opacity: .75; font-size: .9rem; margin-top: .3rem } figure { margin: 1rem 0 }
"""
TITLES = {"lwir": "Long wave", "mwir": "Mid wave"}
WHAT = {
    "lwir": "Skin temperatures and little else: the sunlit side, the rooms behind the plating, the funnel's casing. The "
            "sea shows the sky that it reflects, colder nearby; towards the horizon both sink into the air's own glow. "
            "The panes of the bridge are coated and show the cold sky higher up.",
    "mwir": "Sunlight adds to what the plating emits, and heat counts for more: uptakes, casing and the plume's carbon "
            "dioxide stand out, and the sea returns them as glitter.",
}


def band_name(name):
    return "{:g}–{:g} µm".format(*BANDS[name].band)


def picture(folder, name, caption):
    with open(os.path.join(folder, name), "rb") as file:
        data = base64.b64encode(file.read()).decode("ascii")
    return (f'<figure><img alt="{html.escape(caption)}" src="data:image/png;base64,{data}">'
            f"<figcaption>{html.escape(caption)}</figcaption></figure>")


def section(folder, name):
    what = f"{band_name(name)}, apparent temperature in °C: that of a black body with the same radiance in the band"
    return [f"<h2>{TITLES[name]}, {band_name(name)}</h2>", f"<p>{WHAT[name]}</p>",
            picture(folder, name + "_near_white_hot.png", f"From 380 m, white hot. {what}."),
            picture(folder, name + "_far_white_hot.png", f"From 2 km, white hot. {what}."),
            picture(folder, name + "_far_false_colour.png", "The same in false colours over a wider range.")]


def table(figures):
    head = "".join(f"<th>{band_name(name)}</th><th>lowest</th><th>highest</th>" for name in figures)
    rows = [f"<table><tr><th>°C, mean of</th>{head}</tr>"]
    for label in next(iter(figures.values())):
        cells = "".join(f"<td>{values[label][0]:.1f}</td><td>{values[label][2]:.1f}</td><td>{values[label][3]:.1f}</td>"
                        for values in figures.values())
        rows.append(f"<tr><td>{html.escape(label)}</td>{cells}</tr>")
    return "\n".join(rows) + "</table>"


def write_page(folder, figures, commands):
    """figures: band -> region -> (mean, deviation, lowest, highest) in °C; commands: what a user would type."""
    parts = [
        "<!DOCTYPE html><html lang=en><head><meta charset=utf-8><title>A frigate in two bands</title>"
        '<meta name=viewport content="width=device-width,initial-scale=1"><link rel=icon href="data:,">'
        f"<style>{STYLE}</style></head><body>",
        "<h1>A frigate in two bands</h1>",
        "<p>Seen from 380 m and from 2 km, 26 and 32 m above the sea, on a clear afternoon: air "
        f"{AFTERNOON.air - 273.15:.1f} °C, sea {AFTERNOON.sea - 273.15:.1f} °C, the sun {AFTERNOON.sun_elevation:g}° high "
        "on the starboard quarter. Each plate has the temperature at which sun, sky, sea, wind and the room behind it "
        "balance; it emits by that, reflects ship, sea and sky by a BRDF table, and is seen through the air between.</p>",
        *(line for name in figures for line in section(folder, name)),
        "<h2>Apparent temperatures from 2 km</h2>", table(figures),
        "<h2>How to make it</h2>", f"<pre>{html.escape(chr(10).join(commands))}</pre>",
        "</body></html>",
    ]
    with open(os.path.join(folder, "index.html"), "w", encoding="utf-8") as file:
        file.write("\n".join(parts) + "\n")
