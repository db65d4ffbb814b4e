#!/usr/bin/env python3
"""Writes a campaign from a pack of measurements (`packs/caseNN`): what was measured as targets, what is reported as conditions.

usage: make_campaign.py PACK CAMPAIGN.toml

Standard deviations are those of one measurement between replicates, pooled over the open packs (four, without an effect), over
the root of the number of replicates. The friction of the covers (0.25 +- 0.02) is an effect with that typical amplitude, not a factor.
"""
import json
import os
import sys

pack, output = sys.argv[1:3]

# between replicates of the open packs, in the response's unit
sd = {
    "drum_low": {"angle_of_repose_deg": 0.20, "area_percent": 0.16, "energy_mJ_kg": 0.82, "avalanche_energy_mJ_kg": 0.58},
    "drum_mid": {"angle_of_repose_deg": 0.14, "area_percent": 0.10, "energy_mJ_kg": 0.27, "avalanche_energy_mJ_kg": 0.92},
    "drum_high": {"angle_of_repose_deg": 0.12, "area_percent": 0.16, "energy_mJ_kg": 0.28, "avalanche_energy_mJ_kg": 0.67},
    "slot_narrow": {"angle_of_repose_deg": 2.5, "shear_angle_deg": 1.9, "mass_flow_kg_s": 0.0030, "final_mass_kg": 0.00020,
                    "bulk_density_kg_m3": 7.5},
    "slot_wide": {"angle_of_repose_deg": 0.85, "shear_angle_deg": 1.9, "mass_flow_kg_s": 0.0056, "final_mass_kg": 0.00016,
                  "bulk_density_kg_m3": 7.4},
}
turns = {"drum_low": (0.18, 0.6, 2000), "drum_mid": (0.28, 0.9, 800), "drum_high": (0.7, 1.5, 333)}

header = """# {name}: measurements of another code, treated as if they were real; made by make_campaign.py.
[campaign]
name = "{name}"
seed = 1

[material.grain]
density = 2500.0
youngs_modulus = 5e6
poisson_ratio = 0.3

[material.liner]
density = 2500.0
youngs_modulus = 5e6
poisson_ratio = 0.3

[material.glass]
density = 2500.0
youngs_modulus = 5e6
poisson_ratio = 0.3

[contact.grain_grain]
rolling = "epsd2"
restitution = 0.5
static_friction = 0.5 # a factor
rolling_friction = 0.1 # a factor

[contact.grain_liner]
rolling = "epsd2"
restitution = 0.5
static_friction = 0.70
rolling_friction = 0.10

[contact.grain_glass]
rolling = "epsd2"
restitution = 0.5
static_friction = 0.25
rolling_friction = 0.10

[size_distribution.sieved] # equal numbers
classes_mm = [2.64, 2.82, 3.00, 3.18, 3.36]
mass_fraction = [0.1334127, 0.1626045, 0.1957713, 0.2331668, 0.2750447]
"""
drum = """
[[experiment]]
name = "{name}"
rig = "drum"
material = "grain"
wall_material = "liner"
end_material = "glass"
size_distribution = "sieved"
radius_mm = 30.0
width_mm = 20.0
ends = "turning"
speed_rpm = {speed}
mass_kg = {mass:.6f}
discard_turns = {discard}
measure_turns = {measure}
samples_per_turn = {samples}
"""
slot = """
[[experiment]]
name = "{name}"
rig = "drawdown"
replicates = 2
material = "grain"
wall_material = "liner"
window_material = "glass"
size_distribution = "sieved"
mass_kg = {mass:.6f}
bulk_density = 1000.0   # loose, so that the lid does not touch: the bed is not levelled
filling_friction = 10.0 # filled with the same friction as all else
box_width_mm = 50.0
box_depth_mm = 15.0
lower_box_width_mm = 100.0
drop_height_mm = 60.0
slot_width_mm = {slot}
gate_speed_m_s = 1.0
series_interval_s = 0.002
"""
footer = """
[[factor]]
path = "contact.grain_grain.static_friction"
lower = 0.2
upper = 0.8

[[factor]]
path = "contact.grain_grain.rolling_friction"
lower = 0.02
upper = 0.3
scale = "log"

[design]
points = 16

[search]
batch = 4

[stop]
waves = 3
runs = 200

[gap]
held_out = ["drum_high", "slot_wide"]
form_floor = {form_floor}
packings = 6
screening_packings = 2
"""
form_floor = 0.02

report = json.load(open(os.path.join(pack, "report.json")))
measured = json.load(open(os.path.join(pack, "responses.json")))
name = report["case"]
text = header.format(name=name)
for condition in turns | {"slot_narrow": None, "slot_wide": None}:
    runs = [run for run in report["runs"] if run["condition"] == condition]
    mass = 1e-3 * sum(run["fill_mass_g"] for run in runs) / len(runs)
    if condition in turns:
        discard, measure, samples = turns[condition]
        text += drum.format(name=condition, speed=runs[0]["speed_rpm"], mass=mass, discard=discard, measure=measure, samples=samples)
    else:
        text += slot.format(name=condition, mass=mass, slot=runs[0]["slot_width_mm"])
    for response, one in sd[condition].items():
        values = [value for value in measured[condition][response]["replicates"] if value is not None]
        if values:
            deviation = one / len(values) ** 0.5
            text += f"target.{response} = {{ value = {sum(values) / len(values):.6g}, scale = {deviation:.3g}, sd = {deviation:.3g} }}\n"
with open(output, "w") as file:
    file.write(text + footer.format(form_floor=form_floor))
