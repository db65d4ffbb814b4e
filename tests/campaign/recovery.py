"""Recovers friction coefficients from targets that the program itself produced with other packing seeds.

usage: recovery.py DEMENS MPIRUN TEMPLATE; exit 77 where h5py is missing.
"""
import math
import os
import subprocess
import sys
import tempfile

try:
    import h5py
except ImportError:
    print("skipped: no h5py")
    sys.exit(77)

demens, mpirun, template = sys.argv[1:4]
# A friction at which the responses still depend on it: beyond 0.4 they hardly do, less than one packing scatters.
truth = {"FRICTION": 0.25, "ROLLING": 0.08}
names = ["ANGLE_OF_REPOSE", "SHEAR_ANGLE", "MASS_FLOW", "FINAL_MASS"]


def run_campaign(folder, name, values):
    text = open(template).read()
    for key, value in values.items():
        text = text.replace(f"@{key}@", str(value))
    text = "\n".join(line for line in text.split("\n") if "@" not in line)
    toml = os.path.join(folder, name + ".toml")
    with open(toml, "w") as file:
        file.write(text)
    subprocess.run([mpirun, "-n", "2", demens, toml], check=True, stdout=subprocess.DEVNULL)
    return h5py.File(os.path.join(folder, name + ".h5"))


bounds = {"FRICTION_LOWER": 0.1, "FRICTION_UPPER": 1.2, "ROLLING_LOWER": 0.01, "ROLLING_UPPER": 0.25}
with tempfile.TemporaryDirectory() as folder:
    # The truth, eight packings of it. The targets there do not matter yet.
    made = run_campaign(folder, "truth", truth | bounds | dict.fromkeys(names, 1) | {n + "_SD": 1 for n in names} |
                        {"SEED": 99, "REPLICATES": 8, "DESIGN": "table", "WAVES": 0,
                         "TABLE": f"[[{truth['FRICTION']}, {truth['ROLLING']}]]"})
    responses = made["waves/0000/responses/bench"][:, :4]
    assert (made["waves/0000/runs/status"][:] == 1).all(), "a run of the truth failed"
    targets = {}
    for k, name in enumerate(names):
        column = [float(row[k]) for row in responses]
        mean = sum(column) / len(column)
        sd = math.sqrt(sum((v - mean) ** 2 for v in column) / (len(column) - 1))
        targets |= {name: mean, name + "_SD": sd}
        print(f"{name:18} {mean:8.4f} +- {sd:.4f}")

    found = run_campaign(folder, "found", {"FRICTION": 0.7, "ROLLING": 0.15} | bounds | targets |
                         {"SEED": 1, "REPLICATES": 1, "DESIGN": "latin_hypercube", "POINTS": 12, "WAVES": 3})
    last = sorted(found["waves"])[-1]
    runs = sum(len(found[f"waves/{wave}/runs/run"]) for wave in found["waves"])
    interval = found[f"waves/{last}/optimum/factor_interval"][:]
    verdict = found[f"waves/{last}/optimum/factor_verdict"][:]
    best = found[f"waves/{last}/optimum/best_point"][:]
    predicted = found[f"waves/{last}/optimum/predicted_point"][:]
    print(f"{runs} runs in {len(found['waves'])} waves")
    for k, (name, value) in enumerate(truth.items()):
        low, high = interval[k]
        print(f"{name:10} true {value}, best {best[k]:.4f}, predicted {predicted[k]:.4f}, 95 % interval "
              f"{low:.4f} to {high:.4f}, verdict {verdict[k]:.0f}")
        assert low <= value <= high, f"{name} = {value} is outside the stated interval"
    # The interval must say something: these targets exclude more than half of the range of the friction. (The verdict looks at
    # the interval over the value, whatever the range, and may still be "not determined".)
    low, high = interval[0]
    assert high - low < 0.5 * (bounds["FRICTION_UPPER"] - bounds["FRICTION_LOWER"]), "friction is not narrowed down"
