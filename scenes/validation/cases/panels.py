"""V2: the seven panels between sky and sea, which have a script and a report of their own."""
import os
import sys

from bench import HERE, Result

TITLE = "Seven panels"
METHOD = ("panels/run; its report beside this one has the pictures. Panels 6 and 7 against the quadrature of "
          "their table.")

BAR = 2e-4
UNIT = "W/(m²sr)"


def results(bench):
    output = bench.run(sys.executable, os.path.join(HERE, "panels", "run"), bench.programs, bench.folder,
                       accepted=(0, 1)).decode()
    rows, camera = [], ""
    for line in output.splitlines():
        if line.startswith("Seen from"):
            camera = "above" if "above" in line else "below"
        elif line[2:3].isdigit() and camera:
            rows.append(row_of(line, camera))
    if len(rows) != 14:
        raise SystemExit(f"validation: {len(rows)} rows from the panels in place of 14\n{output}")
    return rows


def row_of(line, camera):
    """From the columns of the panels' table."""
    closed_form, quadrature, rendered, scatter = (line[start:end].strip() for start, end in
                                                  ((41, 53), (53, 65), (65, 77), (77, 88)))
    return Result(f"{line[2:41].strip()}, from {camera}", UNIT, float(quadrature or closed_form), float(rendered),
                  float(scatter), BAR)
