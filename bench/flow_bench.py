# SPDX-License-Identifier: GPL-3.0-or-later
"""What bench/flow_2d and bench/flow_3d share: runs of the program flow, its report, the table of figures and limits."""

import argparse
import json
import math
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

root = Path(__file__).resolve().parent.parent


class Least(float):
    """A limit from below; other limits are from above."""


def verdict(figure, limit):
    if limit is None:
        return ""
    is_least = isinstance(limit, Least)
    holds = figure >= limit if is_least else figure <= limit
    return f"{'>=' if is_least else '<='} {limit:g}  {'holds' if holds else 'MISSES'}"


class Bench:
    def __init__(self, program, names, time_limit=None):
        self.program, self.names, self.time_limit, self.failures = program, names, time_limit, 0
        self.all_names = []

    def wants(self, name):
        if name not in self.all_names:
            self.all_names.append(name)
        return not self.names or name in self.names

    def run(self, name, words, figures):
        """Runs `flow WORDS`; figures(folder, report) yields (what, figure, limit or None). Returns the report."""
        if not self.wants(name):
            return None
        print(f"\n{name}: {Path(self.program).name} {shlex.join(map(str, words))}", flush=True)
        with tempfile.TemporaryDirectory() as folder:
            error = self.fails([*words, "--quiet", "-o", folder])
            if error:
                self.row(f"run: {error}", 1, 0)
            path = Path(folder) / "report.json"
            if not path.exists():
                return None
            report = json.loads(path.read_text())
            for row in figures(Path(folder), report):
                self.row(*row)
            return report

    def fails(self, words):
        """What went wrong in a run, or nothing."""
        begin, used = time.monotonic(), cpu_seconds()
        with subprocess.Popen([self.program, *words], stderr=subprocess.PIPE, text=True) as process:
            try:
                message = process.communicate(timeout=self.time_limit)[1]
            except subprocess.TimeoutExpired:
                # Interrupted, the program ends its step and writes what it has.
                process.send_signal(signal.SIGINT)
                message = end_of(process, self.time_limit)
        self.wall, self.cpu = time.monotonic() - begin, cpu_seconds() - used
        lines = message.strip().splitlines() or ["no message"]
        return f"exit code {process.returncode}: {lines[-1]}" if process.returncode else None

    def row(self, what, figure, limit):
        if not isinstance(figure, (int, float)):
            print(f"  {what:44} {figure}", flush=True)
            return
        text = verdict(figure, limit)
        self.failures += text.endswith("MISSES")
        print(f"  {what:44} {figure:<12.6g} {text}", flush=True)

    def finish(self):
        """The exit code."""
        unknown = [name for name in self.names if name not in self.all_names]
        for name in unknown:
            print(f"no case has the name {name}; there are: {' '.join(self.all_names)}", file=sys.stderr)
        return 2 if unknown else 1 if self.failures else 0


def end_of(process, seconds):
    """The message of a process that ends soon, or is made to."""
    try:
        return process.communicate(timeout=seconds)[1]
    except subprocess.TimeoutExpired:
        process.kill()
        return process.communicate()[1]


def cpu_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def parser(description):
    result = argparse.ArgumentParser(description=description.split("\n")[0])
    result.add_argument("names", nargs="*", metavar="NAME", help="default: all")
    result.add_argument("--program", type=Path, default=root / "build/release/bin/flow")
    return result


def milliseconds(report):
    """Per step, of motion and deformation."""
    steps = report["steps"][1:]
    return sum(step["ms"]["targets"] + step["ms"]["deform"] for step in steps) / max(1, len(steps))


def label(report, step, number):
    return next((label for label in report["steps"][step]["labels"] if label["label"] == number), None)


def of_label(report, step, number, key):
    """A figure of a label, 0 when it is gone."""
    found = label(report, step, number)
    return found[key] if found else 0


def components(report, step, number):
    return of_label(report, step, number, "components")


def largest_change(report, key, number):
    """Of a figure of a label, against the start."""
    start = of_label(report, 0, number, key)
    return max(abs(of_label(report, k, number, key) - start) for k in range(len(report["steps"])))


def count(report, kind):
    return sum(event["kind"] == kind for event in report["events"])


def hausdorff(p, q):
    """Of two sets of points, over the diagonal of the first."""
    def one_way(a, b):
        return max(min(math.dist(x, y) for y in b) for x in a)
    low, high = ([side(x[k] for x in p) for k in range(len(p[0]))] for side in (min, max))
    return max(one_way(p, q), one_way(q, p)) / math.dist(low, high)
