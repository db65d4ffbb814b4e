"""The campaign file is what CAMPAIGN_FILE.md says, seen by h5py alone: every dataset has its place, units and numbers."""
import os
import re
import subprocess
import sys
import zlib

driver, mpirun, document = sys.argv[1:4]
try:
    import h5py
    import numpy
except ImportError:
    print("SKIPPED: this Python has no h5py (Debian: python3-h5py)")
    sys.exit(77)

os.makedirs("read-with-h5py", exist_ok=True)
os.chdir("read-with-h5py")
for name in os.listdir("."):
    os.remove(name)
subprocess.run([driver, "create", "campaign.h5", "throw_above = 0.8"], check=True)
subprocess.run([mpirun, "-n", "2", driver, "run", "campaign.h5", "2", "5"], check=True)


def text_of(item, attribute):
    return item.attrs[attribute].decode()


def texts_of(item, attribute):
    return list(item.attrs[attribute].astype(str))


with h5py.File("campaign.h5") as file:
    assert text_of(file, "format") == "demens campaign" and file.attrs["format_version"] == 2
    assert re.fullmatch(r"[0-9a-f]{40}(-dirty)?|unknown", text_of(file, "git_commit")), text_of(file, "git_commit")
    assert text_of(file, "ended") == "as many waves as asked for"
    assert file["input/toml"].asstr()[()].startswith("[campaign]\nname = \"formula\"")
    assert list(file["factors/path"].asstr()) == ["experiment.x", "experiment.y"]
    assert list(file["factors/upper"]) == [1, 1]
    assert list(file["targets/value"]) == [1.5, 0.5] and list(file["targets/units"].asstr()) == ["m", "1"]
    assert numpy.isnan(file["targets/sd"][0]) and file["targets/sd"][1] == 0.1

    def check_sum(name, item):
        if isinstance(item, h5py.Dataset):
            numbers = numpy.zeros(item.shape, item.dtype)
            if item.size:
                item.id.read(h5py.h5s.ALL, h5py.h5s.ALL, numbers)
            assert zlib.crc32(numbers.tobytes()) == item.attrs["crc32"], name

    file.visititems(check_sum)
    checked = 0
    for number in (0, 1):
        wave, runs = file[f"waves/{number:04}"], file[f"waves/{number:04}/runs"]
        assert list(runs["run"]) == list(range(15 * number, 15 * number + 15))
        design, first = wave["design"][:], wave["design"].attrs["first_point"]
        slow, fast = wave["responses/slow"], wave["responses/fast"]
        assert texts_of(slow, "columns") == ["map_value", "length_m"] and texts_of(slow, "units") == ["1", "m"]
        snapshots, series = file[f"snapshots/{number:04}"], file[f"series/{number:04}"]
        for row in range(15):
            x, y = design[runs["point"][row] - first]
            ours, others = (slow, fast) if runs["experiment"][row] == 0 else (fast, slow)
            values = series["slow" if runs["experiment"][row] == 0 else "fast"]
            begin, count = values["first_sample"][row], values["samples"][row]
            landmarks = numpy.flatnonzero(snapshots["run"][:] == runs["run"][row])
            assert numpy.isnan(others[row]).all()
            if runs["experiment"][row] == 0 and x > 0.8:
                assert runs["status"][row] == 6 and runs["reason"].asstr()[row] == "no sphere fits"
                assert numpy.isnan(ours[row]).all() and count == 0 and len(landmarks) == 0
                continue
            checked += 1
            assert runs["status"][row] == 1 and runs["reason"].asstr()[row] == ""
            assert ours[row][1] == 2 * x + y
            energy = dict(zip(texts_of(runs["energy"], "columns"), runs["energy"][row]))
            if x > 0.5:
                assert energy["potential"] == x and energy["lost_to_friction"] == 0.5 and energy["turned_over"] == 2
            else:
                assert numpy.isnan(list(energy.values())).all()
            table = values["values"][begin:begin + count]
            assert texts_of(values["values"], "columns") == ["time_s", "value"]
            assert table.tolist() == [[0, x], [0.5, 2 * x + y], [1, 7]]
            assert [snapshots["name"].asstr()[s] for s in landmarks] == ["settled", "final"]
            for s in landmarks:
                begin, count = snapshots["first_particle"][s], snapshots["particle_count"][s]
                particles = snapshots["particles"][begin:begin + count]
                assert count == 1 + int(runs["seed"][row]) % 5
                begin, hulls = snapshots["first_hull"][s], snapshots["hull_count"][s]
                assert snapshots["hull"][begin:begin + hulls].tolist() == (list(range(-1, count - 1)) if x > 0.5 else [])
                assert particles.tolist() == [[p, 0.25, 0.5 if x > 0.5 else 0.125, 0.0625] for p in range(count)]
    assert 0 < checked <= 30

    # Units on everything with a dimension, and a line in the document for every dataset.
    text = open(document).read()
    def visit(path, item):
        if not isinstance(item, h5py.Dataset):
            return
        assert item.dtype.kind == "S" or item.shape == () or "units" in item.attrs, f"{path} has no units"
        name = path.split("/")[-1]
        assert name in text or "/responses/" in path or "/optimum/" in path, f"{path} is not documented"
    file.visititems(visit)
print("read", checked, "finished runs")
