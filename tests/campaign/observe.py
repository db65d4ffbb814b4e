#!/usr/bin/env python3
"""`demens observe` as a user types it: photographs, frames of other codes, their comparison, and what is refused.
usage: observe.py DEMENS"""
import json
import math
import os
import struct
import subprocess
import sys
import tempfile
import zlib

demens = os.path.abspath(sys.argv[1])
RADIUS_MM, RADIUS_PX, SIZE = 42.0, 100, 204


def write_png(name, angle_deg, height_px, contrast=200):
    """A bed below a line through (0, height) that climbs to the left, in a drum that turns clockwise."""
    slope, rows = -math.tan(math.radians(angle_deg)), []
    for row in range(SIZE):
        line = bytearray([0])
        for column in range(SIZE):
            x, z = column + 0.5 - SIZE / 2, SIZE / 2 - row - 0.5
            above = (z - height_px - slope * x) * math.cos(math.radians(angle_deg))
            share = min(1, max(0, above / 3 + 0.5))  # passes over three pixels
            outside = math.hypot(x, z) > RADIUS_PX
            line.append(250 if outside else int(250 - contrast * (1 - share)))
        rows.append(bytes(line))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(name, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", SIZE, SIZE, 8, 0, 0, 0, 0))
                   + chunk(b"IDAT", zlib.compress(b"".join(rows))) + chunk(b"IEND", b""))


def bed(angle_deg, height_mm, spacing=0.5):
    """Spheres [mm] below a line that climbs towards +x; the drum's axis is y."""
    slope, radius = math.tan(math.radians(angle_deg)), 0.75 * spacing
    n = int(RADIUS_MM / spacing)
    for i in range(-n, n):
        for k in range(-n, n):
            x, z = (i + 0.5) * spacing, (k + 0.5) * spacing
            if math.hypot(x, z) < RADIUS_MM and (height_mm + slope * x - z) * math.cos(math.radians(angle_deg)) > radius:
                yield x, z, radius


def run(*arguments, code=0):
    done = subprocess.run([demens, "observe", *arguments, "--radius-mm", str(RADIUS_MM)], capture_output=True, text=True)
    assert done.returncode == code, (arguments, done.returncode, done.stdout, done.stderr)
    return done.stdout if code == 0 else done.stderr


def near(value, expected, tolerance):
    assert value is not None and abs(value - expected) <= tolerance, (value, expected)


PIXEL_MM = RADIUS_MM / RADIUS_PX
CIRCLE = ["--circle-px", "102,102,100", "--rotation", "clockwise"]

with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    write_png("a.png", 30, -10)
    write_png("b.png", 32, -10)

    # One photograph: what it was made from.
    picture = json.loads(run("a.png", *CIRCLE, "--json"))["pictures"][0]
    near(picture["angle_of_repose_deg"], 30, 0.3)
    segment = math.acos(0.1 * math.cos(math.radians(30)))
    near(picture["area_percent"], 100 / math.pi * (segment - math.sin(segment) * math.cos(segment)), 0.3)
    near(picture["cut_darkness"], 105, 2)
    for x, height in zip(picture["profile"]["x_mm"], picture["profile"]["height_mm"]):
        if height is not None:
            near(height, -10 * PIXEL_MM - x * math.tan(math.radians(30)), 0.5 * PIXEL_MM)
    assert sum(height is not None for height in picture["profile"]["height_mm"]) >= 14

    # Two: their scatter, as a table and as targets.
    table = run("a.png", "b.png", *CIRCLE)
    assert "standard deviation" in table and "angle_of_repose_deg" in table, table
    targets = run("a.png", "b.png", *CIRCLE, "--targets")
    line = next(line for line in targets.splitlines() if line.startswith("target.angle_of_repose_deg"))
    near(float(line.split("value = ")[1].split(",")[0]), 31, 0.3)
    near(float(line.split("sd = ")[1].split(" ")[0]), math.sqrt(2), 0.1)
    rows = run("a.png", "b.png", *CIRCLE, "--csv").splitlines()
    assert len(rows) == 3 and rows[0].startswith("picture,area_percent,angle_of_repose_deg,r2,cut_darkness"), rows
    assert '"mean of 2 files"' in run("a.png", "b.png", *CIRCLE, "--csv", "--take", "mean")

    # Frames of another code on the photograph's raster, mirrored as the photograph is.
    with open("bed.dump", "w", encoding="utf-8") as file:
        spheres = list(bed(30, -10 * PIXEL_MM))
        for step in (1, 2):
            file.write(f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n{len(spheres)}\n"
                       "ITEM: BOX BOUNDS pp pp ff\n-1 1\n-1 1\n-1 1\nITEM: ATOMS id x y z radius\n")
            for k, (x, z, radius) in enumerate(spheres):
                file.write(f"{k} {x / 1000} 0 {z / 1000} {radius / 1000}\n")
    document = json.loads(run("bed.dump", "--reference", "a.png", *CIRCLE, "--json", "--write", "out"))
    picture = document["pictures"][0]
    near(picture["angle_of_repose_deg"], 30, 0.3)
    assert picture["pixels"] == [SIZE, SIZE]
    near(picture["mismatch_mm2"], 0, 25)  # of 3325 mm2: a tenth of a pixel along the chord is 2.4 mm2
    assert len(os.listdir("out")) == 8, os.listdir("out")
    # The mask that was written is the picture that was measured.
    again = json.loads(run("out/bed-mask.png", "--reference", "bed.dump", *CIRCLE, "--json", "--trust-circle"))
    near(again["pictures"][0]["mismatch_mm2"], 0, 0.5)
    # The same bed 2 deg steeper: two sectors of 2 deg.
    wedge = json.loads(run("b.png", "--reference", "a.png", *CIRCLE, "--json"))["pictures"][0]["mismatch_mm2"]
    near(wedge, 2 * math.radians(2) / 2 * 0.6 * RADIUS_MM**2, 8)
    # Other axes and units: seen along x, right is -y; a drum that turns the other way is mirrored.
    for sense, rotation in ((-1, "counterclockwise"), (1, "clockwise")):
        with open("bed.csv", "w", encoding="utf-8") as file:
            file.write("x,y_mm,z_mm,r_mm\n" + "".join(f"0,{sense * x + 5},{z},{r}\n" for x, z, r in bed(25, 0)))
        other = json.loads(run("bed.csv", "--axis", "x", "--centre-mm", "0,5,0", "--frames-rotation", rotation, "--json"))
        near(other["pictures"][0]["angle_of_repose_deg"], 25, 0.3)

    # What cannot be right is refused, with the file's name.
    write_png("flat.png", 30, -10, contrast=0)
    with open("no_radius.dump", "w", encoding="utf-8") as file:
        file.write("ITEM: TIMESTEP\n1\nITEM: NUMBER OF ATOMS\n0\nITEM: ATOMS id x y z\n")
    with open("half.png", "wb") as file, open("a.png", "rb") as whole:
        file.write(whole.read()[:300])
    for arguments, message in [
        (["flat.png", *CIRCLE], "flat.png: the contrast does not separate"),
        (["a.png", "--circle-px", "110,102,100"], "cut by the edge"),
        (["a.png", "--circle-px", "103.5,102,100", "--rotation", "clockwise"], "is not the rim that the picture shows"),
        (["a.png", "--circle-px", "102,102,100"], "a.png: the bed climbs to the left by 30 deg"),
        (["a.png", "--circle-px", "102,102"], "give X,Y,R"),
        (["half.png"], "half.png: damaged"),
        (["none.png"], "none.png"),
        (["a.gif"], "its name tells no kind of file"),
        (["no_radius.dump"], "no column of radii"),
        (["bed.dump", "--frames-unit", "mm"], "this is no bed in it"),
        (["a.png", *CIRCLE, "--targets"], "one picture has no scatter"),
        (["a.png", *CIRCLE, "--threshold", "dark"], "--threshold dark: give auto, or"),
        (["a.png", *CIRCLE, "--closing", "4"], "--closing 4: an odd number"),
        (["a.png", *CIRCLE, "--reference", "a.png", "bed.dump"], "files of one kind"),
    ]:
        error = run(*arguments, code=2)
        assert message in error, (arguments, error)
