#!/usr/bin/env python3
"""Writes the answer to a case in the packs' form from what `demens gap CASE.h5 --json` says.

usage: answer.py GAP.json ANSWER.json

A pair counts for both of its effects by half. What is unknown to the diagnosis is a cause of the packs' list that demens cannot have (grains that are no
spheres; a law of rolling other than the one that is tried) or one outside the list: `unknown` is shared out among these by their priors, each cause of the list
being as probable as another and one outside it as three of them.
"""
import json
import sys

names = {
    "cohesion": "cohesion", "capillary": "capillary", "rolling_law": "rolling_law", "liner_friction": "liner_friction", "covers_friction": "glass_friction",
    "drum_fill": "fill_mass", "drum_rpm": "drum_speed", "drag": "air_drag", "fine_grains": "fines", "soft_grains": "stiffness", "tilted_axis": "drum_tilt",
    "slow_gate": "gate", "shaking": "vibration",
}
share_of_unknown = {"shape": 0.25, "rolling_law": 0.10, "unknown": 0.65}
least = 0.002 # of every name: no answer is certain

found = json.load(open(sys.argv[1]))
probabilities = dict.fromkeys(["none", "shape", "unknown", *names.values()], 0.0)
for hypothesis in found["which"]["hypotheses"]:
    for effect in hypothesis["effects"]:
        if effect in names: # else it is "none" or "unknown"
            probabilities[names[effect]] += hypothesis["probability"] / len(hypothesis["effects"])
probabilities["none"] += found["which"]["none"]
for name, share in share_of_unknown.items():
    probabilities[name] += share * found["which"]["unknown"]
total = sum(max(p, least) for p in probabilities.values())
answer = {"probabilities": {name: round(max(p, least) / total, 5) for name, p in probabilities.items()},
          "located": [cell["cell"] for cell in found["where"]["cells"] if cell["finding"] == "beyond the floor"]}
answer["probabilities"]["none"] += round(1 - sum(answer["probabilities"].values()), 5) # of rounding
closures = [effect for effect in (found["how_far"] or {"effects": []})["effects"] if effect["cells"]]
if closures:
    best = closures[0] # the most probable effect
    if best["closure"] is not None:
        answer["closure"] = best["closure"]
    answer["held_out"] = {when: {cell["cell"]: cell["measured"] - cell[key] for cell in best["cells"]}
                          for when, key in (("base", "before"), ("corrected", "after"))}
with open(sys.argv[2], "w") as file:
    json.dump(answer, file, indent=1)
    file.write("\n")
