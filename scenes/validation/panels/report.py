"""Writes report.html: the tables, pictures, commands and scene of a run in one file that needs nothing else."""
import base64
import html
import os

STYLE = """
:root { color-scheme: light dark; --line: #8884; --good: #2a8a3e; --bad: #c62828 }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 76rem; margin: 2rem auto; padding: 0 1rem }
h1 { font-size: 1.7rem; margin-bottom: .2rem } h2 { font-size: 1.15rem; margin-top: 2rem }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; width: 100% }
th, td { padding: .25rem .7rem; text-align: right; border-bottom: 1px solid var(--line); white-space: nowrap }
th:nth-child(2), td:nth-child(2) { text-align: left; width: 40% }
img { max-width: 100%; display: block; border-radius: 4px }
pre { overflow-x: auto; padding: .8rem; border: 1px solid var(--line); border-radius: 4px; font-size: .85rem }
figcaption { opacity: .75; font-size: .9rem; margin-top: .3rem } figure { margin: 1rem 0 }
.ok { color: var(--good); font-weight: 600 } .off { color: var(--bad); font-weight: 600 }
"""


def picture(folder, name, caption):
    with open(os.path.join(folder, name), "rb") as file:
        data = base64.b64encode(file.read()).decode("ascii")
    return (f'<figure><img alt="{html.escape(caption)}" src="data:image/png;base64,{data}">'
            f"<figcaption>{html.escape(caption)}</figcaption></figure>")


def table(rows):
    cells = ["<table><tr><th></th><th>panel</th><th>closed form</th><th>quadrature</th><th>rendered</th>"
             "<th>standard error</th><th>error %</th><th>sigmas</th><th></th></tr>"]
    for row in rows:
        quadrature = "" if row.quadrature is None else f"{row.quadrature:.5f}"
        error = f"{row.standard_error:.6f}" if row.noisy else f"{row.standard_error:.6f} (rounding)"
        verdict = '<td class="ok">ok</td>' if row.good else '<td class="off">off</td>'
        cells.append(f"<tr><td>{row.number}</td><td>{html.escape(row.what)}</td><td>{row.analytic:.5f}</td>"
                     f"<td>{quadrature}</td><td>{row.rendered:.5f}</td><td>{error}</td>"
                     f"<td>{row.error_percent:+.5f}</td><td>{row.sigmas:.2f}</td>{verdict}</tr>")
    return "\n".join(cells) + "</table>"


def listing(folder, name):
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return f"<details><summary>{name}</summary><pre>{html.escape(file.read())}</pre></details>"


def write_report(folder, scene, tables, bars, commands):
    """tables: caption -> rows. `scene` is the folder of the scene files, `commands` what a user would type."""
    good = all(row.good for rows in tables.values() for row in rows)
    verdict = f'<span class="{"ok" if good else "off"}">{"Every panel" if good else "Not every panel"} is {bars}.</span>'
    parts = [
        "<!DOCTYPE html><html lang=en><head><meta charset=utf-8><title>Seven panels</title>"
        '<meta name=viewport content="width=device-width,initial-scale=1"><link rel=icon href="data:,">'
        f"<style>{STYLE}</style></head><body>",
        "<h1>Seven panels between sky and sea</h1>",
        "<p>Surfaces that emit and reflect, in 8–12 µm: sky 31.48, sea 34.34, panels 37.35 times their emissivity, in "
        f"W·m⁻²·sr⁻¹ (black bodies at 15, 20 and 25 °C). {verdict}</p>",
        picture(folder, "horizon.png", "The panels before the horizon, 1 to 7 from the left. The mirror (3) shows the same "
                "horizon as behind it and so cannot be told from the background; 5 and 6 show it weaker, and the lobe "
                "of 7 is too wide to show it."),
    ]
    for caption, rows in tables.items():
        parts += [f"<h2>Seen {html.escape(caption)}</h2>", table(rows)]
    parts += [
        "<p>Radiances in W·m⁻²·sr⁻¹. The standard error comes from the scatter of the pixels of a panel; where there is "
        "none it is the rounding of 32 bit floats. The quadrature integrates the BRDF table itself; the error is the "
        "larger of the two differences.</p>",
        picture(folder, "above.png", "From above, orthographic: the picture that is measured."),
        picture(folder, "below.png", "From below."),
        "<h2>How to make it</h2>",
        f"<pre>{html.escape(chr(10).join(commands))}</pre>",
        *(listing(scene, name) for name in ("sky.rad", "panels.rad", "render.opt")),
        "</body></html>",
    ]
    with open(os.path.join(folder, "report.html"), "w", encoding="utf-8") as file:
        file.write("\n".join(parts) + "\n")
