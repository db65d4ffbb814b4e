#!/usr/bin/env python3
"""Writes the campaign of the rehearsal: a drum at three speeds and one held out, two slots of a draw down and one held out, about 1,000 grains.

usage: make_campaign.py CAMPAIGN.toml [BANK.h5]
"""
import sys

output, bank = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else ""
# standard deviations of what is measured, about those of a single run between packings
drum_targets = {"angle_of_repose_deg": 0.25, "area_percent": 0.1, "energy_mJ_kg": 0.4, "avalanche_energy_mJ_kg": 0.8}
slot_targets = {"angle_of_repose_deg": 1.0, "shear_angle_deg": 2.0, "mass_flow_kg_s": 0.003, "final_mass_kg": 0.00015, "bulk_density_kg_m3": 6.0}
# speed, turns that are left out, turns that are measured, samples a turn
drums = {"drum_6rpm": (6, 0.18, 0.6, 2000), "drum_15rpm": (15, 0.28, 0.9, 800), "drum_36rpm": (36, 0.7, 1.5, 333), "drum_60rpm": (60, 1, 2.5, 200)}
slots = {"slot_16mm": 16, "slot_22mm": 22, "slot_28mm": 28}
# what the diagnosis knows; what the rigs allow beside these is drawn as something outside its list
effects = ["liquid_bridges", "area_cohesion", "wall_friction", "cover_friction", "fill_mass", "drum_speed", "fines", "static_above_kinetic", "vibration", "lean"]

text = """# Rehearsal of the diagnosis on withheld effects; made by make_campaign.py.
[campaign]
name = "rehearsal"
seed = 48

[material.grain]
density = 2500.0
youngs_modulus = 5e6

[material.liner]
density = 2500.0
youngs_modulus = 5e6

[material.glass]
density = 2500.0
youngs_modulus = 5e6

[contact.grain_grain]
rolling = "epsd2"
restitution = 0.5
static_friction = 0.5 # a factor
rolling_friction = 0.1 # a factor

[contact.grain_liner]
rolling = "epsd2"
restitution = 0.5
static_friction = 0.7
rolling_friction = 0.1

[contact.grain_glass]
rolling = "epsd2"
restitution = 0.5
static_friction = 0.25
rolling_friction = 0.1

[size_distribution.sieved] # equal numbers
classes_mm = [2.64, 2.82, 3.00, 3.18, 3.36]
mass_fraction = [0.1334127, 0.1626045, 0.1957713, 0.2331668, 0.2750447]
"""


def targets(values):
    return "".join(f"target.{name} = {{ value = 1.0, scale = {sd}, sd = {sd} }}\n" for name, sd in values.items())


for name, (speed, discard, measure, samples) in drums.items():
    text += f"""
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
speed_rpm = {speed:.1f}
mass_kg = 0.036
discard_turns = {discard}
measure_turns = {measure}
samples_per_turn = {samples}
""" + targets(drum_targets)
for name, width in slots.items():
    text += f"""
[[experiment]]
name = "{name}"
rig = "drawdown"
replicates = 2
material = "grain"
wall_material = "liner"
window_material = "glass"
size_distribution = "sieved"
mass_kg = 0.039
bulk_density = 1000.0   # loose: the bed is not levelled
filling_friction = 10.0 # filled with the same friction as all else
box_width_mm = 50.0
box_depth_mm = 15.0
lower_box_width_mm = 100.0
drop_height_mm = 60.0
slot_width_mm = {width:.1f}
gate_speed_m_s = 1.0
series_interval_s = 0.002
""" + targets(slot_targets)
names = ", ".join(f'"{effect}"' for effect in effects)
text += f"""
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
points = 40

[stop]
waves = 0 # the bank's runs are enough
runs = 1000

[gap]
held_out = ["drum_60rpm", "slot_28mm"]
effects = [{names}]
form_floor = 0.01 # the same code measures and diagnoses
packings = 4
effects_in_full = 2
"""
if bank:
    text += f'\n[run]\nbank = "{bank}"\n'
with open(output, "w") as file:
    file.write(text)
