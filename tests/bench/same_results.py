#!/usr/bin/env python3
"""Whether two programs make the same of a campaign: every response of every run that both files have, bit for bit.

usage: same_results.py OLD.h5 NEW.h5 [more pairs]

Runs are matched by wave, experiment, replicate and design point, so that a campaign whose later waves went elsewhere is
compared as far as it went the same way. Series that both files name alike are compared too. Exits 1 where a number differs.
"""
import sys

import h5py
import numpy as np


def runs(file):
    """(wave, experiment, replicate, point as bytes) -> (status, wave, row), in the order of the file."""
    found = {}
    for wave, group in file["waves"].items():
        if "runs/status" not in group:
            continue
        design, first = group["design"][:], group["design"].attrs["first_point"]
        table = group["runs"]
        columns = zip(table["experiment"][:], table["replicate"][:], table["point"][:], table["status"][:])
        for row, (experiment, replicate, point, status) in enumerate(columns):
            found[wave, experiment, replicate, design[point - first].tobytes()] = (status, wave, row)
    return found


def same(a, b):
    return np.array_equal(a, b, equal_nan=True)


def responses(file, wave, row):
    for experiment, data in file["waves"][wave]["responses"].items():
        for name, value in zip(data.attrs["columns"].astype(str), data[row]):
            if np.isfinite(value):
                yield f"{experiment}.{name}", value


def series(file, wave, row):
    for experiment, group in file.get(f"series/{wave}", {}).items():
        if "samples" not in group or "values" not in group:
            continue
        first, count = group["first_sample"][row], group["samples"][row]
        for column, name in enumerate(group["values"].attrs["columns"].astype(str)):
            if count > 0:
                yield f"{experiment}.{name}", group["values"][first:first + count, column]


def compare(old, new):
    ours, theirs = runs(new), runs(old)
    both = [key for key in theirs if key in ours]
    differing, numbers, samples, largest = set(), 0, 0, 0.0
    for key in both:
        (old_status, wave, old_row), (new_status, _, new_row) = theirs[key], ours[key]
        if old_status != new_status:
            differing.add(f"{key[:3]}: status {old_status} and {new_status}")
        now = dict(responses(new, wave, new_row))
        for name, value in responses(old, wave, old_row):
            numbers += 1
            if now.get(name) != value:
                differing.add(name)
                largest = max(largest, abs(now.get(name, np.nan) / value - 1)) if value else largest
        now = dict(series(new, wave, new_row))
        for name, values in series(old, wave, old_row):
            if name in now:
                samples += len(values)
                if not same(now[name], values):
                    differing.add(f"series {name}")
    print(f"{len(both)} of {len(theirs)} runs are in both files: {numbers} responses and {samples} samples compared, "
          + ("all the same bits" if not differing else
             f"different: {', '.join(sorted(differing))} (responses by up to {largest:.3g} of their value)"))
    return not differing and both


if __name__ == "__main__":
    if len(sys.argv) < 3 or len(sys.argv) % 2 == 0:
        sys.exit(__doc__)
    alike = True
    for old_name, new_name in zip(sys.argv[1::2], sys.argv[2::2]):
        with h5py.File(old_name) as old, h5py.File(new_name) as new:
            print(f"{old_name} and {new_name}: ", end="")
            alike = bool(compare(old, new)) and alike
    sys.exit(0 if alike else 1)
