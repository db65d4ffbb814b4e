#!/usr/bin/env python3
"""A made-up powder in place of a simulation: angle of a heap and discharge time from two coefficients of friction, with
the scatter of a packing. Reads parameters.json, writes results.json and series.csv."""
import json
import math
import random

given = json.load(open("parameters.json"))
mu, rolling = given["parameters"]["static_friction"], given["parameters"]["rolling_friction"]
random.seed(given["seed"])
angle = math.degrees(math.atan(0.25 + 0.45 * mu + 0.8 * rolling)) + random.gauss(0, 0.1)
time = 2 * (1 + 0.8 * mu ** 2 + 0.2 * rolling) + random.gauss(0, 0.005)
json.dump({"angle_deg": angle, "discharge_s": time}, open("results.json", "w"))
with open("series.csv", "w") as file:
    file.write("time [s],mass [kg]\n")
    for k in range(11):
        file.write(f"{0.1 * k * time},{1 - 0.1 * k}\n")
