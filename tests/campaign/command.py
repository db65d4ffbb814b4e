#!/usr/bin/env python3
"""Another program is calibrated like a rig: a function in Python, under mpirun; how its runs may end.

usage: command.py DEMENS MPIEXEC inputs/any-program
"""
import csv
import os
import shutil
import subprocess
import sys
import tempfile

demens, mpiexec, inputs = (os.path.abspath(name) if os.sep in name else name for name in sys.argv[1:4])


def run(*command, code=0):
    result = subprocess.run(command, capture_output=True, text=True)
    assert result.returncode == code, f"{command}: {result.returncode}\n{result.stdout}\n{result.stderr}"
    return result.stdout + result.stderr


def changed(**pieces):
    text = open("python.toml").read()
    for old, new in pieces.values():
        assert old in text, old
        text = text.replace(old, new)
    with open("other.toml", "w") as file:
        file.write(text)
    return "other.toml"


def check_calibration():
    # Each run begins an MPI program of its own first, although it is the child of one.
    one = changed(mpi=('command = "python3 model.py"', f'command = "{mpiexec} -n 1 true && python3 model.py"'))
    summary = run(mpiexec, "-n", "2", demens, one)
    assert "the targets can be met together" in summary, summary
    run(demens, "export", "other.h5")
    rows = {row["name"]: row for row in csv.DictReader(open("other.export/factors.csv"))}
    for name, truth in (("static_friction", 0.5), ("rolling_friction", 0.13)):
        low, high = float(rows[name]["interval_lower"]), float(rows[name]["interval_upper"])
        assert low < truth < high and high - low < 0.3, rows[name]
    curve = open("other.export/series.powder.csv").read().split("\n")
    assert curve[0] == "time [s],mass [kg]" and curve[1] == "0,1", curve[:3]


def check_ends():
    fails = changed(fails=("python3 model.py", "echo no licence >&2; exit 3"))
    text = run(demens, "try", fails, code=1)
    assert "the command has the exit code 3; its last line: no licence" in text, text
    slow = changed(slow=('expected_s = 0.1', 'time_limit_s = 0.3'), command=("python3 model.py", "sleep 60"))
    text = run(demens, "try", slow, code=1)
    assert "timed out: the command took more than 0.3 s" in text, text
    silent = changed(silent=("python3 model.py", "true"))
    text = run(demens, "try", silent, code=1)
    assert "the command has written no results.json" in text, text
    less = changed(less=("python3 model.py", r"""echo '{\"angle_deg\": 30}' > results.json"""), series=('series = "series.csv"\n', ""))
    text = run(demens, "try", less, code=1)
    assert 'results.json has no number "discharge_s"' in text, text
    fill = changed(fill=('file = "model.py"', 'file = "model.py"\nfill = true'))
    with open("model.py", "a") as file:
        file.write("# ${cohesion}\n")
    text = run(demens, "new", fill, "-o", "fill.h5", code=2)
    assert "${cohesion} is no parameter of the experiment" in text, text


with tempfile.TemporaryDirectory() as folder:
    for name in ("python.toml", "model.py"):
        shutil.copy(os.path.join(inputs, name), folder)
    os.chdir(folder)
    check_calibration()
    check_ends()
