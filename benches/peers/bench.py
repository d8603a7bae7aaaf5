"""All peers beside Hooke, in turn on one core, in processor time: see README.md. Run it by `run`."""

import argparse
import datetime
import math
import sys
from dataclasses import dataclass

import numpy as np

import chart
import peers
import report
from rows import Row, load, save
from workers import HERE, MADE, Failed, Worker, items

RESULTS = HERE.parent / "results"
REFERENCES = HERE.parent.parent / "tests" / "reference"
CHECK_STEPS = {"cloth-64": 200, "cloth-256": 50, "rope-1000": 200, "jelly-16": 500, "balls": 500}
"""After so many steps positions are compared with the f64 textbook loop's: the block and the balls have bounced."""
REFERENCE_ERROR = 1e-8
"""m; a perturbation of that size grows 156 times on the rope in 1 s, so digits beyond it mean little."""
SLOW = 15
"""Times the processor time of a measurement."""
TOO_SLOW_TO_CHECK = 60
"""s"""


@dataclass
class Effort:
    """How long it is looked at: repeats of a measurement, and the processor time of each at most, s."""

    repeats: int
    seconds: float


def say(text):
    print(text, file=sys.stderr, flush=True)


def reference(scene):
    return np.load(REFERENCES / f"{scene}.npz")["position"][-1]


def distance(answer, positions):
    """The largest of any particle, m."""
    return float(np.linalg.norm(np.reshape(answer["position"], (-1, 3)) - positions, axis=1).max())


def in_turn(jobs, repeats):
    """Calls each job once a round, each time another one first; a job returns a time. Times by job."""
    times = [[] for _ in jobs]
    for turn in range(repeats):
        for place in range(len(jobs)):
            chosen = (place + turn) % len(jobs)
            times[chosen].append(jobs[chosen]())
    return times


def start(chosen, table, scene):
    """A worker for each peer that can be had, and rows for the others."""
    workers, rows = [], []
    for peer in chosen:
        if why := peer.missing.get(scene):
            rows.append(Row(table, scene, peer, note=why))
            continue
        try:
            workers.append(Worker(peer, scene))
        except Failed as failed:
            say(f"  {peer.label}: {failed}")
            rows.append(Row(table, scene, peer, note=str(failed)))
    return workers, rows


def throughput(chosen, scene, effort):
    """Nanoseconds per spring and step, or per particle where there are no springs."""
    say(f"springs, {scene}")
    workers, rows = start(chosen, "springs", scene)
    truth = None
    measured = []
    for worker in workers:
        row = Row("springs", scene, worker.peer, setting=peers.TIME_STEP, unit="ns")
        try:
            few = worker.run(peers.TIME_STEP, 20 * peers.TIME_STEP)["cpu"] / 20
            row.steps = max(5, min(1000, round(effort.seconds / few)))
            measured.append((worker, row, few))
        except Failed as failed:
            row.note = str(failed)
        rows.append(row)
    jobs = []
    for worker, row, _ in measured:

        def measure(worker=worker, steps=row.steps):
            return worker.run(peers.TIME_STEP, steps * peers.TIME_STEP)["cpu"] / (steps * items(scene)) * 1e9

        jobs.append(measure)
    for (_, row, _), times in zip(measured, in_turn(jobs, effort.repeats)):
        row.measured(times)
    for worker, row, few in measured:
        try:
            if scene == "cloth-32":
                check_order(worker, row, reference(scene))
            else:
                truth = textbook_positions(scene) if truth is None else truth
                check_steps(worker, row, few, truth)
        except Failed as failed:
            row.note = str(failed)
    for worker in workers:
        worker.stop()
    return rows


def check_order(worker, row, truth):
    errors = [distance(worker.run(dt, 1.0, state=True), truth) for dt in (peers.TIME_STEP, peers.TIME_STEP / 2)]
    row.error, row.order = errors[0], math.log2(errors[0] / errors[1])


def textbook_positions(scene):
    worker = Worker(peers.Peer("textbook:DVec3", ""), scene)
    answer = worker.run(peers.TIME_STEP, CHECK_STEPS[scene] * peers.TIME_STEP, state=True)
    worker.stop()
    return np.reshape(answer["position"], (-1, 3))


def check_steps(worker, row, step_time, truth):
    steps = CHECK_STEPS[row.scene]
    if step_time * steps > TOO_SLOW_TO_CHECK:
        row.note = "too slow to check here"
        return
    row.error = distance(worker.run(peers.TIME_STEP, steps * peers.TIME_STEP, state=True), truth)


def to_one_second(chosen, table, scene, effort, unit, scale):
    """Time to t = 1 s at each setting, and the error there."""
    say(f"{table}, {scene}")
    workers, rows = start(chosen, table, scene)
    truth = reference(scene)
    jobs, measured = [], []
    for worker in workers:
        before = None
        for setting in worker.peer.settings_for(scene):
            row = Row(table, scene, worker.peer, setting=setting, unit=unit)
            rows.append(row)
            try:
                answer = worker.run(setting, 1.0, state=True)
            except Failed as failed:
                row.note = str(failed)
                continue
            row.error = distance(answer, truth)
            if not row.error < 10:
                row.note = "diverges"
                continue
            if before and math.isfinite(before.error):
                row.order = math.log(before.error / row.error) / math.log(before.setting / setting)
            before = row
            # What takes long is measured by that one run: its time is not what noise could change much.
            row.measured([answer["cpu"] * scale])
            if answer["cpu"] < SLOW * effort.seconds:
                measured.append(row)
                jobs.append(lambda w=worker, s=setting: w.run(s, 1.0)["cpu"] * scale)
    for row, times in zip(measured, in_turn(jobs, effort.repeats)):
        row.measured(times)
    for worker in workers:
        worker.stop()
    return rows


def main():
    parser = argparse.ArgumentParser(prog="benches/peers/run", description=__doc__)
    parser.add_argument("--quick", action="store_true", help="two scenes, few repeats; kept out of benches/results")
    parser.add_argument("--only", metavar="NAME", help="Hooke, and the peers with this in their name")
    parser.add_argument("--redraw", action="store_true", help="only the table and the chart, from peers.csv")
    arguments = parser.parse_args()
    if arguments.redraw:
        rows, *about = load(RESULTS / "peers.csv")
        return show(rows, RESULTS, *about)

    def chosen(table):
        return [
            peer
            for peer in table
            if not arguments.only
            or peer.family == "hooke"
            or arguments.only.lower() in f"{peer.name} {peer.label}".lower()
        ]

    effort = Effort(repeats=3, seconds=0.03) if arguments.quick else Effort(repeats=7, seconds=0.2)
    scenes = ["cloth-32", "rope-1000"] if arguments.quick else peers.SPRING_SCENES
    partial = arguments.quick or arguments.only
    folder = MADE / "partial-results" if partial else RESULTS
    folder.mkdir(parents=True, exist_ok=True)

    rows = []
    for scene in peers.ACCURACY_SCENES if not partial else []:
        rows += to_one_second(peers.REFERENCES, "reference", scene, Effort(1, 0.0), "ms", 1e3)
    for row in rows:
        if not row.error < REFERENCE_ERROR:
            sys.exit(f"{row.peer.label} is {row.error:.1e} m from the reference of {row.scene}")
    for scene in scenes:
        rows += throughput(chosen(peers.SPRINGS), scene, effort)
    for scene in ["rope-100"] if arguments.quick else peers.ACCURACY_SCENES:
        rows += to_one_second(chosen(peers.ACCURACY), "accuracy", scene, effort, "ms", 1e3)
    rows += to_one_second(chosen(peers.FRAMES), "frames", peers.FRAME_SCENE, effort, "ms/frame", 1e3 * peers.FRAME)
    show(rows, folder, datetime.date.today().isoformat(), report.processor(), report.versions(rows))


def show(rows, folder, date, machine, versions):
    save(rows, folder / "peers.csv", date, machine, versions)
    (folder / "peers.md").write_text(report.text(rows, date, machine, versions))
    chart.write(rows, folder / "peers.svg")
    print((folder / "peers.md").read_text())


if __name__ == "__main__":
    main()
