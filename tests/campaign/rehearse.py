"""Rehearses a few cases on the impact of a ball: drawn and sealed, diagnosed in a folder without their truths, scored.

usage: rehearse.py DEMENS MPIRUN TOML.in
"""
import hashlib
import json
import os
import shutil
import subprocess
import sys
import tempfile

blocked = """
[campaign]
name = "blocked"

[material.grain]
density = 2500.0
youngs_modulus = 1e6

[contact.grain_grain]
restitution = 0.5
static_friction = 0.5

[size_distribution.equal]
classes_mm = [3.0]
mass_fraction = [1.0]

[[experiment]]
name = "slot"
rig = "drawdown"
material = "grain"
wall_material = "grain"
window_material = "grain"
size_distribution = "equal"
mass_kg = 0.004
bulk_density = 1000.0
box_width_mm = 20.0
box_depth_mm = 15.0
lower_box_width_mm = 40.0
drop_height_mm = 20.0
slot_width_mm = 4.0
target.mass_flow_kg_s = { value = 1.0, scale = 0.003, sd = 0.003 }

[[factor]]
path = "contact.grain_grain.static_friction"
lower = 0.5
upper = 0.9

[gap]
effects = ["fill_mass"]
"""
demens, mpirun, template = sys.argv[1:4]
cases = 6


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def experiment(name, speed, angle, responses):
    text = f'\n[[experiment]]\nname = "{name}"\nrig = "impact"\nmaterial = "ball"\nwall_material = "plate"\n'
    text += f"speed_m_s = {speed}\nangle_deg = {angle}\n"
    for response, sd in responses.items():
        text += f"target.{response} = {{ value = 1.0, scale = {sd}, sd = {sd} }}\n"
    return text


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    normal = {"normal_restitution": 0.004, "largest_overlap_um": 0.15, "contact_time_us": 0.6}
    oblique = dict(normal, tangential_restitution=0.004, rebound_spin_rad_s=1.0)
    text = experiment("straight", 1, 0, normal) + experiment("slanted", 1, 30, oblique) + experiment("flat", 1, 65, oblique)
    text += experiment("fast", 3, 45, oblique)
    for name, (speed, angle) in {"slow": (0.05, 0), "grazing": (1.0, 85)}.items():
        text += experiment(name, speed, angle, {"contact_time_us": 0.6})
    with open(template) as given, open("campaign.toml", "w") as campaign:
        campaign.write(given.read().replace("@EXPERIMENTS@", text).replace(
            "form_floor = 0.01", 'form_floor = 0.01\neffects = ["softening", "wall_friction"]'))

    # all cases share runs
    run(mpirun, "-n", "2", demens, "gap", "bank", "campaign.toml", "-o", "bank.h5", "--points-per-effect", "6")
    with open("campaign.toml", "a") as campaign:
        campaign.write('\n[run]\nbank = "bank.h5"\n')
    said = run(mpirun, "-n", "2", demens, "gap", "rehearse", "draw", "campaign.toml", "-o", "rehearsal", "--cases", str(cases))
    seals = json.load(open("rehearsal/seals.json"))
    assert len(seals) == cases and all(seal in said for seal in seals.values()), said
    again = run(mpirun, "-n", "2", demens, "gap", "rehearse", "draw", "campaign.toml", "-o", "rehearsal", "--cases", str(cases))
    assert again == "", "what is drawn stays: " + again

    # the diagnosis has the cases alone; nothing in them tells the truth: neither names nor times nor digits
    shutil.copytree("rehearsal/cases", "blind/cases")
    times = {os.stat(f"rehearsal/cases/{name}{file}").st_mtime_ns for name in seals for file in ("", "/campaign.toml")}
    assert len(times) == 1, times
    os.rename("rehearsal", "elsewhere")
    texts = {name: open(f"blind/cases/{name}/campaign.toml").read() for name in seals}
    for name, text in texts.items():
        assert os.listdir(f"blind/cases/{name}") == ["campaign.toml"]
        other = [line for line in text.splitlines() if "target." not in line and not line.startswith("name = ")]
        first = [line for line in texts["case01"].splitlines() if "target." not in line and not line.startswith("name = ")]
        assert other == first, "but for the measured values all cases say the same"
        values = [line.split("value = ")[1].split(",")[0].split("e")[0] for line in text.splitlines() if "value = " in line]
        values = [value for value in values if value != "1.0"]  # of experiments that are not made
        assert len(values) == 18 and all(len(value.strip("-0.").replace(".", "")) >= 12 for value in values), values
    print(run(mpirun, "-n", "2", demens, "gap", "rehearse", "diagnose", "blind"))
    os.rename("elsewhere", "rehearsal")
    for name in seals:
        shutil.copy(f"blind/cases/{name}/answer.json", f"rehearsal/cases/{name}/answer.json")
        sealed = json.load(open(f"rehearsal/truth/{name}.json"))
        canonical = sealed["salt"] + json.dumps(sealed["truth"], sort_keys=True, separators=(",", ":"))
        # numbers are written alike by both programs but for exponents, which these have none of
        assert hashlib.sha256(canonical.encode()).hexdigest() == seals[name], (name, canonical)
        assert any("runs are taken from bank.h5" in note for note in json.load(open(f"blind/cases/{name}/answer.json"))["notes"])
    scores = run(demens, "gap", "rehearse", "score", "rehearsal")
    print(scores)
    assert "single effect: right cause first" in scores and "Brier score" in scores and "right by the rule cosine" in scores, scores
    assert "located: cells beyond the floor" in scores and " of them moved" in scores, scores
    # what is drawn is new each time, so that the scores themselves are not for a test

    truth = json.load(open("rehearsal/truth/case01.json"))
    truth["truth"]["kind"] = "none" if truth["truth"]["kind"] != "none" else "single"
    json.dump(truth, open("rehearsal/truth/case01.json", "w"))
    broken = subprocess.run([demens, "gap", "rehearse", "score", "rehearsal"], capture_output=True, text=True)
    assert broken.returncode == 2 and "not the one that was sealed" in broken.stderr, broken

    # what cannot be measured is drawn anew, not for ever: through this slot nothing flows
    with open("blocked.toml", "w") as campaign:
        campaign.write(blocked)
    stuck = subprocess.run([demens, "gap", "rehearse", "draw", "blocked.toml", "-o", "blocked", "--cases", "1", "--repeats", "1"],
                           capture_output=True, text=True)
    assert stuck.returncode == 2 and stuck.stdout.count("drawn anew") == 9, stuck
    assert "in 10 draws no run of slot has finished" in stuck.stderr and "demens status" in stuck.stderr, stuck.stderr
    assert os.listdir("blocked/truth").count("case01.json") == 1 and len(json.load(open("blocked/seals.json"))) == 1
