#!/usr/bin/env python3
"""Writes what a campaign's runs predict of photographs: mean profile, mask and occupancy, with their scatter.

usage: make_prediction.py DEMENS FOLDER EXPERIMENT CAMPAIGN.h5...

The occupancy of each run (kept with `keep_picture`) is mirrored into the photographs' sense of turning, written as a picture and
read by `demens observe` with the photographs' circle and cut. In FOLDER: EXPERIMENT-occupancy.png, the mean over the runs, and
EXPERIMENT-certainty.png, the share of the runs whose occupancy is over the cut (all: black), and EXPERIMENT-mask.png (bed black), where it is so in half
of them, each 406 x 406 pixels with the circle at (203, 203), radius 203; EXPERIMENT-profile.csv, mean and scatter; EXPERIMENT-members.csv, each run with its factors.
"""
import json
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

import h5py
import numpy as np

demens, folder, experiment, *files = sys.argv[1:]
pixels, cut = 406, 10  # of 255, as in campaign.toml


def write_png(path, grey):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + row.tobytes() for row in grey.astype(np.uint8))
    head = struct.pack(">IIBBBBB", grey.shape[1], grey.shape[0], 8, 0, 0, 0, 0)
    with open(path, "wb") as png:
        png.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def darkness(share):
    return np.rint(255 * (1 - np.clip(share, 0, 1)))


def observed(paths, cut):
    said = subprocess.run([demens, "observe", *paths, "--radius-mm", "42", "--circle-px", "203,203,203", "--trust-circle", "--threshold",
                           str(cut), "--rotation", "clockwise", "--write", os.path.join(os.path.dirname(paths[0]), "out"), "--json"],
                          check=True, capture_output=True, text=True).stdout
    return json.loads(said)


shares, factors = [], []
for file in files:
    with h5py.File(file) as campaign:
        names = [name.decode() for name in campaign["experiments/name"][:]]
        factor_names = [name.decode() for name in campaign["factors/name"][:]]
        for wave in sorted(campaign["waves"]):
            runs = campaign[f"waves/{wave}/runs"]
            picture = campaign[f"profiles/{wave}/{experiment}/picture"]
            for row in np.flatnonzero((runs["experiment"][:] == names.index(experiment)) & (runs["status"][:] == 1)):
                start, count = int(picture["first_sample"][row]), int(picture["samples"][row])
                shares.append(picture["values"][start:start + count, 1].reshape(pixels, pixels)[:, ::-1])
                factors.append(campaign[f"waves/{wave}/design"][int(runs["point"][row] - runs["point"][0])])
mean = np.mean(shares, axis=0)
os.makedirs(folder, exist_ok=True)
write_png(f"{folder}/{experiment}-occupancy.png", darkness(mean))
certainty = np.mean([share > cut / 255 for share in shares], axis=0)
write_png(f"{folder}/{experiment}-certainty.png", darkness(certainty))
with tempfile.TemporaryDirectory() as scratch:
    paths = []
    for k, share in enumerate(shares):
        paths.append(f"{scratch}/run-{k:02}.png")
        write_png(paths[-1], darkness(share))
    runs = observed(paths, cut)["pictures"]
    together = f"{scratch}/mean.png"
    write_png(together, darkness(certainty))
    of_mean = observed([together], 127)["pictures"][0]
    shutil.copy(next(f"{scratch}/out/{name}" for name in os.listdir(f"{scratch}/out") if name.endswith("mean-mask.png")),
                f"{folder}/{experiment}-mask.png")
key = next(k for k in of_mean["profile"] if k != "x_mm")
heights = np.array([[np.nan if z is None else z for z in run["profile"][key]] for run in runs])
with open(f"{folder}/{experiment}-profile.csv", "w") as table:
    table.write("# height of the bed's surface over the drum's axis, x from left to right as the camera sees it; of runs that have a height there\n")
    table.write("x_mm,mean_mm,sd_mm,least_mm,largest_mm,runs\n")
    for k, x in enumerate(of_mean["profile"]["x_mm"]):
        there = heights[~np.isnan(heights[:, k]), k]
        if len(there) > len(runs) / 2:
            sd = np.std(there, ddof=1) if len(there) > 1 else np.nan
            table.write(f"{x:.3f},{np.mean(there):.3f},{sd:.3f},{there.min():.3f},{there.max():.3f},{len(there)}\n")
with open(f"{folder}/{experiment}-members.csv", "w") as table:
    table.write(",".join(factor_names) + "," + ",".join(f"{x:.3f}" for x in of_mean["profile"]["x_mm"]) + "\n")
    for run, values in zip(heights, factors):
        table.write(",".join(f"{v:.6g}" for v in values) + "," + ",".join("" if np.isnan(z) else f"{z:.3f}" for z in run) + "\n")
for name in ("angle_of_repose_deg", "area_percent", "r2"):
    values = np.array([run[name] for run in runs])
    print(f"{experiment} {name}: {values.mean():.4g} +- {np.std(values, ddof=1):.2g} over {len(values)} runs")
