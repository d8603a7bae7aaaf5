"""One picture of it all, as SVG: time per spring by scene, and time against error."""

import math

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

from peers import ACCURACY, ACCURACY_SCENES, SPRING_SCENES  # noqa: E402

HOOKE = "#d1361f"
INK, FAINT, BAND = "#22303c", "#d5dbe0", "#fdf0ea"
SCENE_COLOURS = ["#1b4f72", "#2e86c1", "#85c1e9", "#1e8449", "#b7950b", "#8e44ad"]
PEER_COLOURS = ["#1b4f72", "#2e86c1", "#1e8449", "#76b041", "#b7950b", "#8e44ad", "#7f8c8d", "#34495e", "#c27ba0"]
LARGE_PEERS = {"marker": "x", "s": 32, "color": "#7f8c8d"}
LARGE_OURS = {"marker": "*", "s": 80, "color": HOOKE}
STYLE = {
    "font.family": "DejaVu Sans",
    "font.size": 9,
    "text.color": INK,
    "axes.labelcolor": INK,
    "axes.edgecolor": FAINT,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "xtick.color": INK,
    "ytick.color": INK,
    "svg.hashsalt": "hooke",
}


def write(rows, path):
    with plt.rc_context(STYLE):
        figure = plt.figure(figsize=(11, 11.5), layout="constrained")
        upper, lower = figure.subfigures(2, 1, height_ratios=[1.15, 1])
        throughput(upper.subplots(), [row for row in rows if row.table == "springs" and row.repeats])
        for axes, scene in zip(lower.subplots(1, 2), ACCURACY_SCENES):
            accuracy(axes, scene, [row for row in rows if row.scene == scene and row.repeats])
        # Both panels draw the same peers in the same colours.
        handles = {label: handle for axes in lower.axes for handle, label in zip(*axes.get_legend_handles_labels())}
        lower.legend(handles.values(), handles, frameon=False, fontsize=8, loc="outside lower center", ncols=4)
        figure.savefig(path, metadata={"Date": None, "Title": "Hooke beside its peers"})
        plt.close(figure)


def unique(values):
    return list(dict.fromkeys(values))


def plain(value, _):
    return f"{value:g}"


def headline(axes, title, subtitle):
    axes.set_title(title, loc="left", fontsize=12, fontweight="bold", pad=22)
    axes.text(0, 1.02, subtitle, transform=axes.transAxes, va="bottom", fontsize=8.5, color="#5d6d7e")


def throughput(axes, rows):
    """A line a peer, a dot a scene."""
    at = {(row.peer, row.scene): row.median for row in rows}

    def middle(peer):
        logs = [math.log(value) for (other, _), value in at.items() if other is peer]
        return sum(logs) / len(logs)

    ranked = sorted(unique(row.peer for row in rows), key=middle, reverse=True)
    for place, peer in enumerate(ranked):
        ours = peer.family == "hooke"
        values = [value for (other, _), value in at.items() if other is peer]
        if ours:
            axes.axhspan(place - 0.5, place + 0.5, color=BAND, zorder=0)
        axes.plot([min(values), max(values)], [place, place], color=HOOKE if ours else FAINT, linewidth=2, zorder=1)
    for scene, colour in zip(SPRING_SCENES, SCENE_COLOURS):
        points = [(at[peer, scene], place) for place, peer in enumerate(ranked) if (peer, scene) in at]
        if points:
            axes.scatter(*zip(*points), s=42, color=colour, edgecolor="white", linewidth=0.7, label=scene, zorder=2)
    axes.set_xscale("log")
    axes.xaxis.set_major_formatter(plain)
    axes.set_yticks(range(len(ranked)), [peer.label for peer in ranked])
    for tick, peer in zip(axes.get_yticklabels(), ranked):
        if peer.family == "hooke":
            tick.set_color(HOOKE)
            tick.set_fontweight("bold")
    axes.tick_params(axis="y", length=0)
    axes.grid(axis="x", which="major", color=FAINT, linewidth=0.7)
    axes.set_axisbelow(True)
    axes.set_xlabel("ns per spring and step (balls: per particle), logarithmic")
    axes.legend(loc="lower left", frameon=False, ncols=1, title="scene", title_fontsize=9, alignment="left")
    headline(axes, "Time for one step, semi-implicit Euler", "one core, processor time, median; left is faster")


def accuracy(axes, scene, rows):
    """Time to t = 1 s against the error there; large steps are single points."""
    rows = [row for row in rows if row.table in ("accuracy", "frames")]
    others = [peer for peer in ACCURACY if peer.family != "hooke"]
    colour_of = dict(zip([peer.name for peer in others], PEER_COLOURS))
    for peer in unique(row.peer for row in rows if row.table == "accuracy"):
        points = [(row.error, row.median) for row in rows if row.peer is peer]
        ours = peer.family == "hooke"
        colour, width = (HOOKE, 2.2) if ours else (colour_of[peer.name], 1.3)
        dashes = {"semi-implicit Euler": "-", "velocity Verlet": "--"}.get(peer.scheme, "-.") if ours else "-"
        mark = ("s" if peer.name.endswith("f32") else "D") if ours else "o"
        label = peer.label
        axes.plot(*zip(*points), dashes, color=colour, linewidth=width, marker=mark, markersize=4.5, label=label)
    large = [row for row in rows if row.table == "frames" and row.error < 3]
    for row in large:
        ours = row.peer.family == "hooke"
        # Milliseconds a frame, 60 of them.
        axes.scatter(row.error, 60 * row.median, zorder=3, **(LARGE_OURS if ours else LARGE_PEERS))
    if large:
        axes.scatter([], [], label="peers at large steps", **LARGE_PEERS)
        axes.scatter([], [], label="Hooke at large steps", **LARGE_OURS)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.yaxis.set_major_formatter(plain)
    axes.invert_xaxis()
    axes.grid(which="major", color=FAINT, linewidth=0.7)
    axes.set_xlabel("largest position error at t = 1 s, m (right is better)")
    axes.set_ylabel("processor time to t = 1 s, ms (lower is better)")
    headline(axes, f"Time against error, {scene}", "each curve: one method at several time steps or tolerances")
