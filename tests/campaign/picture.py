"""A drum beside a photograph: what is read of each run, on the photograph's raster.

usage: picture.py DEMENS MPIRUN TOML; exit 77 where h5py is missing.
"""
import math
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

try:
    import h5py
except ImportError:
    print("skipped: no h5py")
    sys.exit(77)

demens, mpirun, toml = sys.argv[1:4]


def write_photograph(path, columns=140, rows=150, x=70, y=72, radius=60, angle=30):
    """Grey PNG of a bed that fills half of the circle and climbs to the left."""
    lines = b""
    for row in range(rows):
        lines += b"\0"
        for column in range(columns):
            dx, dy = column + 0.5 - x, row + 0.5 - y
            below = dy * math.cos(math.radians(angle)) - dx * math.sin(math.radians(angle))
            dark = min(max(0.5 + below, 0), 1) if math.hypot(dx, dy) < radius else 0
            lines += bytes([round(240 - 220 * dark)])

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", columns, rows, 8, 0, 0, 0, 0))
                   + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b""))


with tempfile.TemporaryDirectory() as folder:
    write_photograph(os.path.join(folder, "drum.png"))
    shutil.copy(toml, os.path.join(folder, "picture.toml"))
    said = subprocess.run([mpirun, "-n", "2", demens, "picture.toml"], check=True, cwd=folder, capture_output=True,
                          text=True).stdout
    assert "the bed covers 50" in said and "120 pixels across" in said, said
    with h5py.File(os.path.join(folder, "picture.h5")) as file:
        assert (file["waves/0000/runs/status"][:] == 1).all(), file["waves/0000/runs/reason"][:]
        table = file["waves/0000/responses/drum"]
        columns = list(table.attrs["columns"].astype(str))
        friction = file["waves/0000/design"][:, 0]
        runs = [dict(zip(columns, row)) for row in table[:]]
        pictures = file["profiles/0000/drum/picture/samples"][:]
    heights = [name for name in columns if name.startswith("picture_") and name.endswith("_mm")]
    for mu, run in zip(friction, runs):
        print(f"friction {mu:.2f}: {run['picture_mismatch_mm2']:.1f} mm2, {run['picture_angle_deg']:.1f} deg, "
              f"{run['picture_area_percent']:.1f} %")
        # The mean picture and the mean over pictures see the same bed; closing fills the gaps between grains at the rim.
        assert abs(run["picture_angle_deg"] - run["angle_of_repose_deg"]) < 4
        assert -1 < run["picture_area_percent"] - run["area_percent"] < 6
        # Seen from where the drum turns clockwise the bed climbs to the left.
        assert run[heights[0]] > run[heights[-1]]
    smooth, rough = (runs[k] for k in sorted(range(len(runs)), key=lambda k: friction[k]))
    assert smooth["picture_angle_deg"] < rough["picture_angle_deg"] - 5
    assert (pictures == 120 * 120).all()
    page = os.path.join(folder, "picture.html")
    subprocess.run([demens, "report", "picture.h5"], check=True, cwd=folder, stdout=subprocess.DEVNULL)
    with open(page) as text:
        assert '"mismatch_mm2":' in text.read()
