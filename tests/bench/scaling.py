#!/usr/bin/env python3
"""Times one simulation on one and two ranks and predicts it on 64: the model of SCALING.md, as Markdown.

usage: scaling.py TEAM_SPEED STATE... [--rounds 6] [--keep FILE]

STATE is a folder of `engine_speed prepare`. Every round times every state on one rank and on two, with and without
overlap; of each number the smallest of all rounds counts, as others that use the machine only ever add to it.
--keep adds this session's rounds to those in FILE.
"""
import argparse
import json
import math
import os
import statistics
import subprocess

REACH = 1.41  # of a ghost beyond a box, in distances between particles: (radius + largest radius + skin) / spacing
IMBALANCE = 1.03  # a rank with most work over the mean: particles that flow, cuts of 1 %
PARTNERS = 26  # of a box amidst others


def measure(program, state, mode, steps):
    ranks, options = mode
    command = ["mpirun", "-n", str(ranks), program, state, "--warm-up", "60", "--steps", str(steps),
               "--repeats", "1", "--fastest", "0.1", *options]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


MODES = {"alone": (1, ["--alone"]), "two": (2, []), "two, no overlap": (2, ["--no-overlap"])}


def best(rounds, key, which):
    """The smallest mean (0) or largest (1) over the ranks."""
    values = [r[key][which] for r in rounds if r[key][which] > 0]
    return min(values) if values else 0.0


def line_through(points):
    """Least squares: constant and slope."""
    n = len(points)
    mean_x, mean_y = sum(x for x, _ in points) / n, sum(y for _, y in points) / n
    spread = sum((x - mean_x) ** 2 for x, _ in points)
    slope = sum((x - mean_x) * (y - mean_y) for x, y in points) / spread if spread > 0 else 0.0
    return mean_y - slope * mean_x, slope


def per_particle(m):
    return best(m["alone"], "compute_us", 0) / best(m["alone"], "particles_here", 0)


class Model:
    """Costs in microseconds, from the smallest times measured."""

    def __init__(self, measured):
        self.per_particle = sorted((best(m["alone"], "particles_here", 0), per_particle(m))
                                   for m in measured.values() if m["kind"] == "box")
        ghosts, exchanges, reduces, rebuilds, alone_rebuilds = [], [], [], [], []
        for m in measured.values():
            two, plain = m["two"] + m["two, no overlap"], m["two, no overlap"]
            n, g = best(two, "particles_here", 0), best(two, "ghosts", 0)
            ghosts.append((best(two, "compute_us", 0) - n * per_particle(m)) / g)
            exchanges.append((best(plain, "bytes_received", 0), best(plain, "exchange_us", 0)))
            reduces.append(best(two, "reduce_us", 0))
            if best(m["alone"], "rebuild_step_us", 0) > 0 and best(two, "rebuild_step_us", 1) > 0:
                alone = best(m["alone"], "rebuild_step_us", 0) - best(m["alone"], "compute_us", 0)
                alone_rebuilds.append(alone / best(m["alone"], "particles_here", 0))
                rebuilds.append((best(two, "rebuild_step_us", 1) - best(two, "compute_us", 0)) / (n + g))
        self.ghost = max(statistics.median(ghosts), 0.0)
        self.message, self.byte = (max(cost, 0.0) for cost in line_through(exchanges))
        self.reduce = sum(reduces) / len(reduces)
        mean = lambda values: sum(values) / len(values) if values else 0.0
        self.rebuild, self.alone_rebuild = mean(rebuilds), mean(alone_rebuilds)

    def particle(self, n):
        """Of one particle where a rank has n; the caches hold few better. Straight in log n between what was measured."""
        known = self.per_particle
        if n <= known[0][0] or len(known) == 1:
            return known[0][1]
        for (n0, t0), (n1, t1) in zip(known, known[1:]):
            if n <= n1:
                return t0 + (t1 - t0) * math.log(n / n0) / math.log(n1 / n0)
        return known[-1][1]

    def one_rank(self, n, rebuilds):
        return n * (self.particle(n) + rebuilds * self.alone_rebuild)

    def rank_of_many(self, n, ranks, rebuilds):
        """The terms of a step of a rank that has n particles in a cube amidst others."""
        ghosts = (n ** (1 / 3) + 2 * REACH) ** 3 - n
        compute = n * self.particle(n)
        return {"compute": compute,
                "ghosts": ghosts * self.ghost,
                "messages": PARTNERS * self.message + 72 * ghosts * self.byte,
                "reduce": self.reduce * math.log2(ranks),
                "imbalance": (IMBALANCE - 1) * compute,
                "rebuilds": rebuilds * self.rebuild * (n + ghosts)}


def table(measured):
    print("| state | particles | one rank [us] | two ranks [us] | times | without overlap [us] | compute of a rank [us] "
          "| ghosts | bytes | exchange [us] | reduce [us] | rebuild one, two [us] |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|")
    for state, m in measured.items():
        one, two, plain = (best(m[k], "step_us", 1) for k in MODES)
        both = m["two"] + m["two, no overlap"]
        print(f"| {os.path.basename(state)} | {best(m['alone'], 'particles_here', 0):.0f} | {one:.0f} | {two:.0f} "
              f"| {one / min(two, plain):.2f} | {plain:.0f} | {best(both, 'compute_us', 0):.0f} | {best(both, 'ghosts', 0):.0f} "
              f"| {best(both, 'bytes_received', 0):.0f} | {best(m['two, no overlap'], 'exchange_us', 0):.1f} "
              f"| {best(both, 'reduce_us', 0):.1f} "
              f"| {best(m['alone'], 'rebuild_step_us', 0):.0f}, {best(both, 'rebuild_step_us', 1):.0f} |")


def predictions(model, ranks, rebuilds):
    print("\n| particles | ranks | particles a rank | " +
          " | ".join(model.rank_of_many(1e4, 2, 0)) + " | step [us] | one rank [us] | times faster | efficiency |")
    print("|" + "---|" * 13)
    for total in (1e6, ranks * 1e6):
        terms = model.rank_of_many(total / ranks, ranks, rebuilds)
        step = sum(terms.values())
        alone = model.one_rank(total, rebuilds)
        share = model.one_rank(total / ranks, rebuilds)
        print(f"| {total:.3g} | {ranks} | {total / ranks:.0f} | " + " | ".join(f"{t:.0f}" for t in terms.values()) +
              f" | {step:.0f} | {alone:.0f} | {alone / step:.1f} | {share / step:.2f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("states", nargs="+")
    parser.add_argument("--rounds", type=int, default=6)
    parser.add_argument("--keep")
    parser.add_argument("--ranks", type=int, default=64, help="to predict")
    arguments = parser.parse_args()
    measured = {}
    if arguments.keep and os.path.exists(arguments.keep):
        with open(arguments.keep) as file:
            measured = json.load(file)
    for _ in range(arguments.rounds):
        for state in arguments.states:
            with open(os.path.join(state, "state.txt")) as file:
                header = file.readline().split()
            kind, particles = header[0], int(header[6])
            rounds = measured.setdefault(state, {"kind": kind} | {mode: [] for mode in MODES})
            for mode, how in MODES.items():
                rounds[mode].append(measure(arguments.program, state, how, max(40, min(600, 6_000_000 // particles))))
    if arguments.keep:
        with open(arguments.keep, "w") as file:
            json.dump(measured, file)
    table(measured)
    model = Model(measured)
    print(f"\nCompute: {', '.join(f'{1e3 * t:.1f} ns a particle of {n:.0f}' for n, t in model.per_particle)}; "
          f"{1e3 * model.ghost:.0f} ns a ghost; {model.message:.1f} us a message, {1e-3 / model.byte if model.byte > 0 else math.inf:.1f} GB/s; "
          f"{model.reduce:.1f} us a reduction of two ranks; a rebuild {1e3 * model.alone_rebuild:.0f} ns a particle on one "
          f"rank, {1e3 * model.rebuild:.0f} ns a particle and ghost in a team.")
    for rebuilds in (0, 0.01):
        print(f"\n{'At rest, no rebuilds' if rebuilds == 0 else f'In flow, a rebuild every {1 / rebuilds:.0f} steps'}:")
        predictions(model, arguments.ranks, rebuilds)


if __name__ == "__main__":
    main()
