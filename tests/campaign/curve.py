"""Finds a restitution from a measured curve: the height of a bouncing ball, from a camera that was started late.

usage: curve.py DEMENS MPIRUN TOML; exit 77 where h5py is missing.
"""
import math
import os
import random
import shutil
import subprocess
import sys
import tempfile

try:
    import h5py
except ImportError:
    print("skipped: no h5py")
    sys.exit(77)

demens, mpirun, toml = sys.argv[1:4]
restitution, late, sd = 0.6, 0.03, 0.3e-3


def height(t, radius=0.005, start=0.055, gravity=9.81):
    """Of the centre of a ball that is dropped onto a plane and bounces in no time."""
    fall = math.sqrt(2 * (start - radius) / gravity)
    if t < fall:
        return start - 0.5 * gravity * t * t
    t, speed = t - fall, restitution * gravity * fall
    while t > 2 * speed / gravity and speed > 1e-3:
        t, speed = t - 2 * speed / gravity, speed * restitution
    return radius + max(0.0, speed * t - 0.5 * gravity * t * t)


with tempfile.TemporaryDirectory() as folder:
    random.seed(3)
    with open(os.path.join(folder, "camera.csv"), "w") as camera:
        camera.write("t_ms;z_mm\n")
        for k in range(100):
            value = 1e3 * (height(0.005 * k + late) + random.gauss(0, sd))
            camera.write(f"{5 * k};{value:.3f}\n".replace(".", ","))
    shutil.copy(toml, os.path.join(folder, "curve.toml"))
    said = subprocess.run([mpirun, "-n", "2", demens, "curve.toml"], check=True, cwd=folder, capture_output=True,
                          text=True).stdout
    assert "of which" in said and "scatter by themselves" in said, said

    with h5py.File(os.path.join(folder, "curve.h5")) as file:
        waves = sorted(file["waves"])
        last = file["waves"][waves[-1]]
        estimate, (lower, upper) = last["optimum/estimate"][0], last["optimum/factor_interval"][0]
        columns = list(last["responses/bounce"].attrs["columns"].astype(str))
        shift = last["responses/bounce"][0][columns.index("height_m_shift")]
        run = last["runs/run"][0]
    print(f"restitution {estimate:.4f}, 95 % {lower:.4f} to {upper:.4f}; the camera was {1e3 * shift:.2f} ms late")
    assert lower < restitution < upper and upper - lower < 0.05
    assert abs(estimate - restitution) < 0.01
    assert abs(shift - late) < 0.002
    # What is handed on: a row a run, curves, and the best point as a campaign with all that it needs.
    subprocess.run([demens, "export", "curve.h5", "-o", "handed"], check=True, cwd=folder, stdout=subprocess.DEVNULL)
    with open(os.path.join(folder, "handed", "runs.bounce.csv")) as table:
        lines = table.read().splitlines()
    with h5py.File(os.path.join(folder, "curve.h5")) as file:
        runs = sum(len(file["waves"][wave]["runs/run"]) for wave in file["waves"])
        best = file["waves"][waves[-1]]["optimum/best_point"][0]
    assert len(lines) == runs + 1 and lines[0].startswith("run,wave,purpose,point") and lines[0].endswith("height_m_shift")
    with open(os.path.join(folder, "handed", "best.toml")) as text:
        assert f"restitution = {best}" in text.read()
    subprocess.run([demens, "new", "handed/best.toml"], check=True, cwd=folder, stdout=subprocess.DEVNULL)
    assert os.path.getsize(os.path.join(folder, "handed", "series.bounce.csv")) > 1000

    # A replay makes the same of the curve.
    replay = subprocess.run([demens, "replay", "curve.h5", "--run", str(run)], check=True, cwd=folder,
                            capture_output=True, text=True).stdout
    assert "DIFFERENT" not in replay and "height_m_8" in replay, replay
