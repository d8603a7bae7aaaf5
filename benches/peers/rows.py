"""A figure, and how it goes to the CSV file and comes back."""

import csv
import math
import statistics
from dataclasses import dataclass

import peers

COLUMNS = (
    "date,machine,table,scene,peer,name,version,equation,scheme,setting,steps,repeats,unit,minimum,median,error_m,order,note"
).split(",")


@dataclass
class Row:
    """One figure, or why there is none."""

    table: str
    scene: str
    peer: peers.Peer
    setting: float = math.nan
    """Time step, s, or tolerance."""
    steps: int = 0
    """Of a measurement, where that is not the whole second."""
    unit: str = ""
    repeats: int = 0
    minimum: float = math.nan
    median: float = math.nan
    error: float = math.nan
    """m, largest distance of any particle: at t = 1 s from the reference, or after some steps from the f64 textbook."""
    order: float = math.nan
    note: str = ""

    def measured(self, times):
        """In `unit`, one a repeat."""
        self.repeats, self.minimum, self.median = len(times), min(times), statistics.median(times)


def save(rows, path, date, machine, versions):
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for row in rows:
            peer = row.peer
            about = [date, machine, row.table, row.scene, peer.label, peer.name, versions[peer.family]]
            how = [peer.equation, peer.scheme, number(row.setting), row.steps or "", row.repeats, row.unit]
            found = [*map(number, (row.minimum, row.median, row.error, row.order)), row.note]
            writer.writerow(about + how + found)


def number(value):
    return "" if math.isnan(value) else f"{value:.6g}"


def load(path):
    """The rows, the date, the machine and the versions."""

    def real(text):
        return float(text) if text else math.nan

    rows, known, versions = [], {}, {}
    with open(path, newline="") as file:
        for line in csv.DictReader(file):
            key = line["table"], line["name"]
            peer = known.setdefault(key, peers.Peer(line["name"], line["peer"], line["equation"], line["scheme"]))
            versions[peer.family] = line["version"]
            row = Row(line["table"], line["scene"], peer, real(line["setting"]), int(line["steps"] or 0), line["unit"])
            row.repeats, row.note = int(line["repeats"]), line["note"]
            row.minimum, row.median, row.error, row.order = map(
                real, (line["minimum"], line["median"], line["error_m"], line["order"])
            )
            rows.append(row)
    return rows, line["date"], line["machine"], versions
