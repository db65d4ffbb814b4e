"""Diagnoses made-up gaps of the impact of a ball: none, and a ball that is softer than the model has it.

usage: gap.py DEMENS MPIRUN TOML.in [CHROMIUM], with which the page is looked at in a real browser
"""
import json
import os
import re
import subprocess
import sys
import tempfile

demens, mpirun, template = sys.argv[1:4]
chromium = sys.argv[4] if len(sys.argv) > 4 else None
conditions = {"straight": (1.0, 0), "slanted": (1.0, 30), "flat": (1.0, 65), "fast": (3.0, 45)}
candidates = {"slow": (0.05, 0), "grazing": (1.0, 85)}
measured_responses = ("normal_restitution", "tangential_restitution", "rebound_spin_rad_s", "largest_overlap_um",
                      "contact_time_us")
with open(template) as text:
    campaign = text.read()


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def experiments(targets):
    text = ""
    for name, (speed, angle) in conditions.items():
        text += f'\n[[experiment]]\nname = "{name}"\nrig = "impact"\nmaterial = "ball"\nwall_material = "plate"\n'
        text += f"speed_m_s = {speed}\nangle_deg = {angle}\n"
        for response, value in targets.get(name, {"normal_restitution": 1.0}).items():
            sd = max(0.005 * abs(value), 1e-3)
            text += f"target.{response} = {{ value = {value}, scale = {sd}, sd = {sd} }}\n"
    for name, (speed, angle) in candidates.items():  # what might be measured next
        text += f'\n[[experiment]]\nname = "{name}"\nrig = "impact"\nmaterial = "ball"\nwall_material = "plate"\n'
        text += f"speed_m_s = {speed}\nangle_deg = {angle}\ntarget.contact_time_us = {{ scale = 1, sd = 0.5 }}\n"
        text += "target.normal_restitution = { scale = 0.01, sd = 0.005 }\n"
    return campaign.replace("@EXPERIMENTS@", text)


def reality(*settings):
    """Responses of the model with what is set, printed by `demens try`."""
    with open("reality.toml", "w") as text:
        text.write(experiments({}))
    targets, name = {}, ""
    for line in run(demens, "try", "reality.toml", *(word for path in settings for word in ("--set", path))).splitlines():
        words = line.split()
        if line and not line.startswith(" "):
            name = words[0]
            targets[name] = {}
        elif words and words[0] in measured_responses and not (name == "straight" and words[0] in measured_responses[1:3]):
            targets[name][words[0]] = float(words[1])
    targets = {name: targets[name] for name in conditions}
    assert set(targets) == set(conditions) and all(len(t) >= 3 for t in targets.values()), targets
    return targets


def diagnose(name, ranks, *settings):
    with open(name + ".toml", "w") as text:
        text.write(experiments(reality(*settings)))
    said = run(demens, "new", name + ".toml")
    assert "diagnosis:" in said and "held out" in said, said
    said = run(mpirun, "-n", str(ranks), demens, name + ".h5")
    for word in ("Where:", "Which:", "How far:", "Next:", "Assumed:"):
        assert word in said, said
    print(said[said.index("Where:"):])
    assert run(demens, "gap", name + ".h5") == said[said.index("Where:"):]
    return json.loads(run(demens, "gap", name + ".h5", "--json"))


def look_at_page(name):
    """The report of a diagnosed campaign: no errors in its scripts, something in each plot of the gap."""
    run(demens, "report", name + ".h5")
    options = ("--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--disable-quic", "--no-first-run",
               "--disable-background-networking", "--disable-component-update", "--disable-sync", "--virtual-time-budget=20000")
    page = subprocess.run([chromium, *options, f"--user-data-dir={os.getcwd()}/profile", "--dump-dom",
                           f"file://{os.getcwd()}/{name}.html"], capture_output=True, text=True, timeout=120).stdout
    assert re.search(r'<body[^>]* data-errors="0"[^>]* data-ready="yes"', page)
    for plot in ("gap-cells", "gap-hypotheses", "gap-closures", "gap-signatures"):
        assert re.search(f'data-plot="{plot}" [^>]*data-marks="[1-9]', page), plot


with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
    os.chdir(folder)
    factors = ("contact.ball_plate.static_friction=0.31", "contact.ball_plate.restitution=0.62")
    none = diagnose("none", 2, *factors)
    assert none["which"]["verdict"] == "nothing beyond the floor" and not none["which"]["named"], none["which"]
    assert any(note.startswith("not testable") and "lean" in note for note in none["notes"]), "the impact has no gravity"
    assert all(cell["finding"] != "beyond the floor" for cell in none["where"]["cells"])

    # the same laws made what was measured: forms are right to less than a hundredth
    floor = re.search(r"form_floor = ([0-9.]+) ", run(demens, "gap", "floor", "none.h5"))
    assert floor and float(floor[1]) < 0.01, floor

    soft = diagnose("soft", 2, "material.ball.youngs_modulus=3.5e8", *factors)
    which, where = soft["which"], soft["where"]
    assert which["global_p"] < 0.05 and which["none"] < 0.05, which
    # the contact knows mass over stiffness alone: a softer ball is a heavier one, or a softer plate
    assert [group for group in which["named_groups"] + [which["named"]] if "softening" in group], which
    beyond = [cell["cell"].split(".")[1] for cell in where["cells"] if cell["finding"] == "beyond the floor"]
    assert {"largest_overlap_um", "contact_time_us"} <= set(beyond) and "tangential_restitution" not in beyond, beyond
    absorbed = {effect["effect"]: effect["absorbed_share"] for effect in which["effects"]}
    assert absorbed["wall_friction"] > 0.9, "friction is a factor: recalibration hides it"
    closures = {effect["effect"]: effect for effect in soft["how_far"]["effects"]}
    assert closures["softening"]["closure"] > 0.8 and not closures["softening"]["at_floor"], closures

    assert {one["experiment"] for one in soft["next"]} == set(candidates) and soft["next"][0]["value"] == 1, soft["next"]

    if chromium:
        look_at_page("soft")

    # the same bits on another number of ranks, whatever stopped it before
    os.rename("soft.h5", "two_ranks.h5")
    again = diagnose("soft", 1, "material.ball.youngs_modulus=3.5e8", *factors)
    assert again == soft

    # runs shared between campaigns of these rigs: the same answer on any number of ranks, with none for signatures
    with open("bank.toml", "w") as text:
        text.write(experiments({}))
    run(mpirun, "-n", "2", demens, "gap", "bank", "bank.toml", "--points-per-effect", "6")
    shared = open("soft.toml").read().replace("waves = 3", "waves = 0") + '\n[run]\nbank = "bank.h5"\n'
    answers = []
    for ranks in (1, 2):
        with open(f"shared{ranks}.toml", "w") as text:
            text.write(shared)
        said = run(demens, "new", f"shared{ranks}.toml")
        assert "runs of bank.h5, CRC-32 " in said, said
        run(mpirun, "-n", str(ranks), demens, f"shared{ranks}.h5")
        answers.append(json.loads(run(demens, "gap", f"shared{ranks}.h5", "--json")))
    assert answers[0] == answers[1]
    which = answers[0]["which"]
    assert [group for group in which["named_groups"] + [which["named"]] if "softening" in group], which
    run(demens, "report", "shared1.h5") # though no run of it has snapshots
    with open("denser.toml", "w") as text:
        text.write(shared.replace("density = 2500", "density = 2600"))
    refused = subprocess.run([demens, "new", "denser.toml"], capture_output=True, text=True)
    assert refused.returncode == 2 and "material.ball.density is 2600.0 here, 2500.0 there" in refused.stderr, refused

    plan = run(mpirun, "-n", "2", demens, "gap", "plan", "soft.toml")
    print(plan)
    assert "softening" in plan and "200 twins of each cause" in plan and "outside the list, 1 %" in plan and "next grazing" in plan, plan
    effects = run(demens, "effects", "soft.toml")
    assert "softening" in effects and "plate_modulus" in effects and "drum_speed" not in effects, effects
    wrong = subprocess.run([demens, "gap", "none.toml"], capture_output=True, text=True)
    assert wrong.returncode == 2, wrong
