#!/usr/bin/env python3
"""Writes a campaign from a pack of measurements (`packs/caseNN`), or the bank of all of them.

usage: make_campaign.py --bank BANK.toml
       make_campaign.py PACK CAMPAIGN.toml [BANK.h5]

What was measured are the targets. Conditions are the nominal ones, 28 g and 39 g, so that all cases share one bank; what depends on the mass of
a drum is brought to 28 g by the mass that was weighed (within 5 %, else this stops), with the powers that simulations with 5 % more grains have.
Standard deviations are those of one measurement between replicates, pooled over the open packs (four, without an effect), over
the root of the number of replicates. The friction of the glass (0.25 +- 0.02) is a factor of a narrow range.
"""
import json
import os
import sys

# between replicates of the open packs, in the response's unit, at 28 g
sd = {
    "drum_low": {"angle_of_repose_deg": 0.20, "area_percent": 0.090, "energy_mJ_kg": 0.78, "avalanche_energy_mJ_kg": 0.58},
    "drum_mid": {"angle_of_repose_deg": 0.14, "area_percent": 0.073, "energy_mJ_kg": 0.34, "avalanche_energy_mJ_kg": 0.92},
    "drum_high": {"angle_of_repose_deg": 0.12, "area_percent": 0.060, "energy_mJ_kg": 0.33, "avalanche_energy_mJ_kg": 0.67},
    "slot_narrow": {"angle_of_repose_deg": 2.5, "shear_angle_deg": 1.9, "mass_flow_kg_s": 0.0030, "final_mass_kg": 0.00020,
                    "bulk_density_kg_m3": 7.5},
    "slot_wide": {"angle_of_repose_deg": 0.85, "shear_angle_deg": 1.9, "mass_flow_kg_s": 0.0056, "final_mass_kg": 0.00016,
                  "bulk_density_kg_m3": 7.4},
}
power_of_mass = {"area_percent": 0.91, "energy_mJ_kg": 0.43} # of a drum's fill
nominal_g = {"drum_low": 28.0, "drum_mid": 28.0, "drum_high": 28.0, "slot_narrow": 39.0, "slot_wide": 39.0}
speed_rpm = {"drum_low": 6.0, "drum_mid": 15.0, "drum_high": 36.0}
slot_mm = {"slot_narrow": 16.0, "slot_wide": 22.0}
turns = {"drum_low": (0.18, 0.6, 2000), "drum_mid": (0.28, 0.9, 800), "drum_high": (0.7, 1.5, 333)}

header = """# {name}; made by make_campaign.py.
[campaign]
name = "{name}"
seed = {seed}

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
static_friction = 0.25 # a factor
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

[[factor]]
path = "contact.grain_glass.static_friction"
name = "glass_friction"
lower = 0.2
upper = 0.3

[design]
points = 36

[search]
batch = 4

[stop]
waves = {waves}
runs = 200

[gap]
held_out = ["drum_high", "slot_wide"]
effects = [{names}]
form_floor = {form_floor}
packings = 4
screening_packings = 2
effects_in_full = 2
"""
form_floor = 0.005 # the four open cases say 0.0021 (`demens gap floor`); few cells tell a variance no better than within a factor of two

# name, typical amplitude, its sign, what a unit of it is, what it sets: what the packs' README lists, as far as demens has it
effects = [
    ("cohesion", 2.5, "positive", "energy density over 7400 J/m3", ['path = "contact.grain_grain.added_energy_density", per_unit = 7400.0']),
    ("capillary", 0.25, "positive", "surface tension over that of water", ['path = "contact.grain_grain.added_surface_tension", per_unit = 0.072']),
    ("rolling_law", 1.0, "positive", "a constant torque instead of EPSD2, at an amplitude of 1",
     [f'path = "contact.grain_{other}.rolling", value = "constant_torque"' for other in ("grain", "liner", "glass")]),
    ("liner_friction", 0.5, "negative", "share of the liner's friction", ['path = "contact.grain_liner.static_friction", relative = 1.0']),
    ("covers_friction", 1.2, "positive", "share of the glass's friction", ['path = "contact.grain_glass.static_friction", relative = 1.0']),
    ("drum_fill", 0.08, "either", "share of the drum's fill",
     [f'path = "experiment.{drum}.mass_kg", relative = 1.0' for drum in speed_rpm]),
    ("drum_rpm", 0.2, "either", "share of the drum's speed", ['path = "experiment.speed_rpm", relative = 1.0']),
    ("drag", 200.0, "positive", "viscosity of the gas over that of air", ['path = "experiment.gas_viscosity_Pa_s", per_unit = 1.8e-5']),
    ("fine_grains", 0.12, "positive", "share of the mass that is of 1.8 mm",
     ['path = "experiment.tail_mm", value = 1.8', 'path = "experiment.tail_mass_fraction", per_unit = 1.0']),
    ("soft_grains", 0.9, "positive", "share of the modulus that is missing", ['path = "material.grain.youngs_modulus", relative = -1.0']),
    ("tilted_axis", 4.0, "positive", "angle [deg]", ['path = "experiment.tilt_deg", per_unit = 1.0']),
    ("slow_gate", 0.85, "positive", "share of the gate's speed that is missing", ['path = "experiment.gate_speed_m_s", relative = -1.0']),
    ("shaking", 0.5, "positive", "acceleration over gravity, at 50 Hz", ['path = "experiment.vibration_m_s2.z", per_unit = 9.81']),
]


def experiments_text(lines_of):
    """All experiments; lines_of(name) are their targets."""
    text = ""
    for name in nominal_g:
        mass = 1e-3 * nominal_g[name]
        if name in turns:
            discard, measure, samples = turns[name]
            text += drum.format(name=name, speed=speed_rpm[name], mass=mass, discard=discard, measure=measure, samples=samples)
        else:
            text += slot.format(name=name, mass=mass, slot=slot_mm[name])
        text += lines_of(name)
    return text


def effects_text():
    text = ""
    for name, typical, sign, doc, settings in effects:
        settings = ", ".join("{ " + setting + " }" for setting in settings)
        text += f'\n[[effect]]\nname = "{name}"\ntypical = {typical}\nsign = "{sign}"\ndoc = "{doc}"\nset = [{settings}]\n'
    return text


def write(output, name, seed, waves, lines_of, gap=""):
    names = ", ".join(f'"{effect[0]}"' for effect in effects)
    with open(output, "w") as file:
        file.write(header.format(name=name, seed=seed) + experiments_text(lines_of)
                   + footer.format(waves=waves, form_floor=form_floor, names=names) + gap + effects_text())


def write_bank(output):
    # nothing is measured: values say what is looked at, and are not used
    write(output, "bank of the packs", 20261, 0,
          lambda name: "".join(f"target.{response} = {{ value = 1.0, scale = {one:.3g} }}\n" for response, one in sd[name].items()))


def write_case(pack, output, bank):
    report = json.load(open(os.path.join(pack, "report.json")))
    measured = json.load(open(os.path.join(pack, "responses.json")))

    def lines_of(name):
        runs = [run for run in report["runs"] if run["condition"] == name]
        for run in runs:
            for key, nominal in (("fill_mass_g", nominal_g[name]), ("speed_rpm", speed_rpm.get(name)), ("slot_width_mm", slot_mm.get(name))):
                if nominal and abs(run[key] / nominal - 1) > (0.05 if key == "fill_mass_g" else 0.01):
                    sys.exit(f"{pack}: {name}: {key} is {run[key]}, the bank has {nominal}")
        text = ""
        for response, one in sd[name].items():
            power = power_of_mass.get(response, 0) if name in turns else 0
            values = [value * (nominal_g[name] / run["fill_mass_g"]) ** power
                      for value, run in zip(measured[name][response]["replicates"], runs) if value is not None]
            if values:
                deviation = one / len(values) ** 0.5
                text += f"target.{response} = {{ value = {sum(values) / len(values):.6g}, scale = {deviation:.3g}, sd = {deviation:.3g} }}\n"
        return text

    waves = 0 if bank else 3 # with the bank's runs no search is needed
    write(output, report["case"], 1, waves, lines_of, f'\n[run]\nbank = "{bank}"\n' if bank else "")


if sys.argv[1] == "--bank":
    write_bank(sys.argv[2])
else:
    write_case(sys.argv[1], sys.argv[2], sys.argv[3] if len(sys.argv) > 3 else "")
