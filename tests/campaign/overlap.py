"""Waves of a search that overlap: the same runs and analyses on one, two and three ranks, and after a stop; half a
batch each, the second one planned before the first one has results.

usage: overlap.py DEMENS MPIRUN IMPACT.toml; exit 77 where h5py is missing
"""
import glob
import os
import signal
import subprocess
import sys
import tempfile
import time

try:
    import h5py
except ImportError:
    print("skipped: no h5py")
    sys.exit(77)

demens, mpirun, template = sys.argv[1:4]


def campaign(name, overlap):
    text = open(template).read().replace(", tolerance = 0.0005", "").replace(
        "angle_deg = 75", "angle_deg = 75\nrayleigh_fraction = 0.0005")  # runs of some tenths of a second
    text = text.replace("waves = 5", "waves = 4\nno_improvement_waves = 0")
    with open(name + ".toml", "w") as file:
        file.write(text + f"\n[search]\nbatch = 4\noverlap = {str(overlap).lower()}\n")
    return name + ".toml"


def content(file):
    """Everything that must not depend on ranks and moments, bit for bit."""
    found = {}

    def note(path, item):
        if isinstance(item, h5py.Dataset) and path.split("/")[-1] not in ("wall_time", "start_time", "group"):
            found[path] = item[()].tobytes() if item.dtype.kind in "fiu" else [bytes(text) for text in item[()].ravel()]

    with h5py.File(file) as h5:
        h5["waves"].visititems(note)
        waves = [(str(wave.attrs["purpose"]), len(wave["design"]), int(wave.attrs.get("planned_ahead", 0)))
                 for wave in (h5["waves"][name] for name in sorted(h5["waves"]))]
        wall_time = sum(float(h5["waves"][name].attrs["wall_time_s"]) for name in h5["waves"])
        ends = h5["waves"]
        runs = sum(float(ends[name]["runs/wall_time"][:].sum()) for name in ends)
    return found, waves, wall_time, runs


def start(toml, ranks):
    return subprocess.Popen([mpirun, "-n", str(ranks), demens, toml], stdout=subprocess.DEVNULL,
                            stderr=subprocess.DEVNULL)


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    results = {}
    for ranks in (1, 2, 3):
        assert start(campaign(f"on-{ranks}", True), ranks).wait() == 0
        results[ranks], waves, wall_time, runs = content(f"on-{ranks}.h5")
        assert waves[0] == ("b'design'" if "b'" in waves[0][0] else "design", 5, 0), waves
        searches = [wave for wave in waves if "search" in wave[0]]
        assert [wave[1:] for wave in searches] == [(2, 0), (2, 1), (2, 1), (2, 1)], waves
        # Overlapping waves share out the time that passed: no more than that of all runs one after another, and what
        # lies between.
        assert wall_time >= runs / ranks * 0.99, (wall_time, runs)
        assert results[ranks] == results[1], [path for path in results[1] if results[ranks].get(path) != results[1][path]]

    toml = campaign("stopped", True)
    parts = "stopped.h5.parts"

    def starts():
        journals = glob.glob(parts + "/journal-*")
        try:
            return sum(open(journal).read().count(" START ") for journal in journals)
        except FileNotFoundError:  # the wave is over
            return 0

    stops = 0
    while True:
        before = starts()
        process = start(toml, 2)
        while process.poll() is None and stops < 4:
            if starts() >= before + 3:
                process.send_signal(signal.SIGTERM)
                stops += 1
                break
            time.sleep(0.005)
        code = process.wait()
        if code == 0:
            break
        assert stops > 0, code
    stopped = content("stopped.h5")
    assert stops > 0, "never stopped"
    assert stopped[0] == results[1], [path for path in results[1] if stopped[0].get(path) != results[1][path]]
    assert not os.path.exists(parts)
    print(f"{len(results[1])} datasets the same on 1, 2 and 3 ranks and after {stops} stops")
