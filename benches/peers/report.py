"""The table for reading, and what was measured where."""

import importlib.metadata
import json
import math
import platform
import subprocess
import tomllib

from peers import ACCURACY_SCENES, FRAME, FRAME_SCENE, SAME, SPRING_SCENES, TIME_STEP
from workers import HERE, MADE

PACKAGES = {
    "numpy": ["numpy"],
    "scipy": ["scipy", "numba"],
    "numba": ["numba"],
    "taichi": ["taichi"],
    "warp": ["warp-lang"],
    "newton": ["newton", "warp-lang"],
    "mujoco": ["mujoco"],
}
ERRORS = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8]
"""m"""
CRATES = {"textbook": "glam", "ode_solvers": "ode_solvers", "diffsol": "diffsol", "rapier3d": "rapier3d"}


def processor():
    try:
        with open("/proc/cpuinfo") as file:
            return next(line.split(":", 1)[1].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


def version(family):
    """Of what was measured."""
    try:
        if family == "hooke":
            described = subprocess.run(
                ["git", "describe", "--always", "--dirty"], cwd=HERE, capture_output=True, text=True, check=True
            )
            return described.stdout.strip()
        if family == "cannon":
            return "cannon-es " + json.loads((MADE / "node/node_modules/cannon-es/package.json").read_text())["version"]
        if family in CRATES:
            lock = tomllib.loads((HERE / "rust" / "Cargo.lock").read_text())["package"]
            # Others of that name may be there for the sake of other crates: ours is the newest.
            return CRATES[family] + " " + [p["version"] for p in lock if p["name"] == CRATES[family]][-1]
        return ", ".join(f"{package} {importlib.metadata.version(package)}" for package in PACKAGES[family])
    except (OSError, subprocess.CalledProcessError, importlib.metadata.PackageNotFoundError):
        return "not installed"


def figure(value):
    """Two or three digits, as a reader wants them."""
    if not math.isfinite(value):
        return ""
    if value >= 100:
        return f"{value:.0f}"
    return f"{value:.1f}" if value >= 10 else f"{value:.2g}"


def small(value):
    return f"{value:.1e}" if math.isfinite(value) else ""


def versions(rows):
    """By family."""
    return {family: version(family) for family in {row.peer.family for row in rows}}


def text(rows, date, machine, versions):
    parts = [heading(date, machine, versions), references, springs, accuracy, ahead, frames, absent]
    made = [part if isinstance(part, str) else part(rows) for part in parts]
    return "\n".join(part for part in made if part)


def heading(date, machine, versions):
    known = "; ".join(f"{family}: {text}" for family, text in sorted(versions.items()))
    return f"""# Hooke beside its peers
Made by `benches/peers/run` on {date}, {machine}, one core; `benches/peers/README.md` says how to read it.
Processor time, set-up and compilation excluded; all rows of a table and scene were measured in turn in the same run.
Each figure is the median of the repeats; `peers.csv` beside this has the minimum too, and everything else.

{known}.
"""


def table(header, lines):
    rule = ["---"] + ["---:"] * (len(header) - 1)
    return "\n".join("| " + " | ".join(cells) + " |" for cells in [header, rule, *lines]) + "\n"


def unique(values):
    return list(dict.fromkeys(values))


def name(peer):
    return f"**{peer.label}**" if peer.family == "hooke" else peer.label


def springs(rows):
    rows = [row for row in rows if row.table == "springs"]
    scenes = [scene for scene in SPRING_SCENES if any(row.scene == scene for row in rows)]
    at = {(row.peer, row.scene): row for row in rows}

    def rank(peer):
        values = [at[peer, scene].median for scene in scenes if (peer, scene) in at]
        return min((value for value in values if math.isfinite(value)), default=math.inf)

    lines = []
    for peer in sorted(unique(row.peer for row in rows), key=rank):
        cells = [figure(at[peer, scene].median) or "–" for scene in scenes]
        cloth = at.get((peer, "cloth-32"))
        error = f"{cloth.error:.2e}" if cloth and math.isfinite(cloth.error) else "–"
        order = f"{cloth.order:.2f}" if cloth and math.isfinite(cloth.order) else "–"
        lines.append([name(peer), *cells, error, order])
    apart = []
    for peer in unique(row.peer for row in rows):
        far = [
            f"{scene} {small(at[peer, scene].error)}"
            for scene in scenes
            if scene != "cloth-32" and math.isfinite(at[peer, scene].error)
        ]
        if far:
            apart.append(f"- {name(peer)}: " + ", ".join(far))
    return (
        f"## Semi-implicit Euler, {TIME_STEP:g} s a step: ns per spring and step (balls: per particle)\n"
        + table(["", *scenes, "error, m", "order"], lines)
        + "\n“error” is the largest position error on cloth-32 at t = 1 s, “order” what halving the step makes of it: "
        + "the scheme itself has 5.16e-03 m there.\n"
        + "\nLargest distance, m, from the f64 textbook loop on the other scenes after some steps (see the README):\n"
        + "\n".join(apart)
        + "\n"
    )


def references(rows):
    met = [
        f"{row.scene}: {row.peer.label} at {row.setting:g} {small(row.error)} m"
        for row in rows
        if row.table == "reference"
    ]
    if not met:
        return ""
    return "The references in `tests/reference` were met, largest distance at t = 1 s: " + "; ".join(met) + ".\n"


def curve(rows):
    done = [f"{figure(row.median)} / {small(row.error)}" for row in rows if row.repeats]
    return "; ".join(done) or "–"


def accuracy(rows):
    rows = [row for row in rows if row.table == "accuracy"]
    if not rows:
        return ""
    scenes = [scene for scene in ACCURACY_SCENES if any(row.scene == scene for row in rows)]
    lines = []
    for peer in unique(row.peer for row in rows):
        cells = [curve([row for row in rows if row.peer == peer and row.scene == scene]) for scene in scenes]
        lines.append([name(peer), *cells])
    return "## Accuracy per second: CPU ms to t = 1 s / largest position error there, m\n" + table(["", *scenes], lines)


def fastest(rows, is_ours, error):
    """Whose median time is the shortest of those of the same equation whose error is no larger."""
    good = [row for row in rows if is_ours(row) and row.repeats and row.peer.equation == SAME and row.error <= error]
    return min(good, key=lambda row: row.median, default=None)


def ahead(rows):
    """Hooke and the fastest of the others at each error."""
    rows = [row for row in rows if row.table == "accuracy"]
    lines = []
    for scene in ACCURACY_SCENES:
        of_scene = [row for row in rows if row.scene == scene]
        for error in ERRORS:
            ours = fastest(of_scene, lambda row: row.peer.family == "hooke", error)
            others = fastest(of_scene, lambda row: row.peer.family != "hooke", error)
            if ours and others:
                found = [f"{row.peer.label}, {figure(row.median)} ms" for row in (ours, others)]
                lines.append([scene, f"{error:.0e}", *found, figure(others.median / ours.median)])
    if not lines:
        return ""
    header = ["scene", "error, m", "Hooke's fastest", "the fastest of the others", "times"]
    return "## Fastest to reach an error at t = 1 s\n" + table(header, lines)


def frames(rows):
    rows = [row for row in rows if row.table == "frames"]
    if not rows:
        return ""
    lines = []
    for row in rows:
        setting = (
            "1/60 s" if row.setting == FRAME else f"tolerance {row.setting:.0e}" if math.isfinite(row.setting) else ""
        )
        lines.append([name(row.peer), row.peer.scheme, setting, figure(row.median) or "–", small(row.error) or "–"])
    header = ["", "scheme", "step or tolerance", "ms per frame", "error at 1 s, m"]
    return f"## Large steps: {FRAME_SCENE}, 60 frames a second\n" + table(header, lines)


def at_setting(row):
    return "" if math.isnan(row.setting) else f" at {row.setting:.3g}"


def absent(rows):
    noted = [f"- {row.table}, {row.scene}, {row.peer.label}{at_setting(row)}: {row.note}" for row in rows if row.note]
    return "## Without a figure, and why\n" + "\n".join(noted) + "\n" if noted else ""
