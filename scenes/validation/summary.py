"""Writes report.html: the tables, methods, commands and scenes of a run on one page, in the look of the panels'."""
import html
import os

from panels.report import STYLE, listing

EXTRA = """
th:nth-child(2), td:nth-child(2) { width: auto } th:first-child, td:first-child { text-align: left; width: 40% }
th:nth-child(2), td:nth-child(2) { text-align: right }
nav a { margin-right: .8rem }
"""


def table(rows):
    cells = ["<table><tr><th>quantity</th><th>closed form</th><th>value</th><th>unit</th><th>standard error</th>"
             "<th>error %</th><th>sigmas</th><th>bar</th><th></th></tr>"]
    for row in rows:
        error = f"{row.standard_error:.2g}" + ("" if row.noisy else " (rounding)")
        figure = "" if row.figure_agrees else f" (figure {row.figure})"
        verdict = '<td class="ok">ok</td>' if row.within else f'<td class="off">off{figure}</td>'
        cells.append(f"<tr><td>{html.escape(row.quantity)}</td><td>{row.number(row.closed_form)}</td>"
                     f"<td>{row.number(row.value)}</td>"
                     f"<td>{html.escape(row.unit)}</td><td>{error}</td><td>{row.error_percent:+.5f}</td>"
                     f"<td>{row.sigmas:.2f}</td><td>{html.escape(row.bar_text)}</td>{verdict}</tr>")
    return "\n".join(cells) + "</table>"


def section(name, case, rows, bench):
    good = all(row.within for row in rows)
    parts = [f'<h2 id="{name}">{name} {html.escape(case.TITLE)} <span class="{"ok" if good else "off"}">'
             f'{"ok" if good else "off"}</span></h2>', f"<p>{html.escape(case.METHOD)}</p>"]
    if os.path.exists(os.path.join(bench.folder, "report.html")):
        parts.append(f'<p><a href="{name}/report.html">Report with pictures</a></p>')
    commands = [command.replace(bench.programs + os.sep, "") for command in bench.commands]
    parts += [table(rows), "<details><summary>commands</summary><pre>"
              f"{html.escape(chr(10).join(dict.fromkeys(commands)))}</pre></details>"]
    parts += [listing(bench.folder, file) for file in sorted(os.listdir(bench.folder))
              if file.endswith((".rad", ".cal"))]
    return "\n".join(parts)


def write_summary(folder, tables, verdict, good):
    """tables: name of a case -> its module, rows and bench."""
    links = " ".join(f'<a href="#{name}">{name}</a>' for name in tables)
    parts = [
        "<!DOCTYPE html><html lang=en><head><meta charset=utf-8><title>Validation</title>"
        '<meta name=viewport content="width=device-width,initial-scale=1"><link rel=icon href="data:,">'
        f"<style>{STYLE}{EXTRA}</style></head><body>",
        "<h1>Against closed forms</h1>",
        f'<p><span class="{"ok" if good else "off"}">{html.escape(verdict)}</span></p><nav>{links}</nav>',
        *(section(name, *table_of_case) for name, table_of_case in tables.items()),
        "<p>Closed forms are computed beside the scenes, with nothing of the renderer's, and agree with the "
        "published figures where there are any. The standard error comes from the scatter of independent rays or groups of them; "
        "where there is none it is the rounding of 32 bit floats or of printed digits. An error counts against the bar "
        "and against four standard errors.</p></body></html>",
    ]
    with open(os.path.join(folder, "report.html"), "w", encoding="utf-8") as file:
        file.write("\n".join(parts) + "\n")
