#!/usr/bin/env bash
# A campaign of the rig `custom` with files beside it: once made, the campaign file needs them no more, and a run is replayed bit
# for bit.
# usage: custom.sh DEMENS
set -euo pipefail
demens=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir parts
printf 'x,y,z,radius\n0,0,0.02,0.005\n0.002,0,0.035,0.005\n' >parts/two.csv
cat >parts/plate.stl <<'STL'
solid plate
facet normal 0 0 1
outer loop
vertex -50 -50 0
vertex 50 -50 0
vertex 0 80 0
endloop
endfacet
endsolid plate
STL
cat >custom.toml <<'TOML'
[campaign]
name = "two spheres on a plate"
[material.glass]
density = 2500
[contact.glass_glass]
restitution = 0.5
static_friction = 0.4
[[experiment]]
name = "bench"
rig = "custom"
target.height_m = { value = 0.02, scale = 0.01 }
[[experiment.particles]]
name = "two"
source = "csv"
material = "glass"
file = "parts/two.csv"
[[experiment.wall]]
name = "plate"
shape = "mesh"
material = "glass"
file = "parts/plate.stl"
unit_mm = 1
[[experiment.wall.motion]]
kind = "oscillation"
amplitude_mm = [0, 0, 1]
frequency_hz = 20
[[experiment.stage]]
name = "drop"
duration_s = 0.05
[[experiment.stage]]
name = "fall"
duration_s = 0.15
[[experiment.response]]
name = "height_m"
quantity = "centre_of_mass"
take = "mean"
[[factor]]
path = "experiment.bench.wall.plate.motion.1.frequency_hz"
lower = 10
upper = 30
[design]
points = 3
[stop]
waves = 0
TOML

"$demens" try custom.toml --picture seen.png >try.txt
grep -q 'wrote seen.png: fall, 0.2' try.txt
[ "$(head -c 4 seen.png | tail -c 3)" = PNG ]
"$demens" new custom.toml >new.txt
grep -q 'warning: experiment.bench: wall.plate: 3 edges with one triangle only' new.txt
rm -r parts
mpirun --oversubscribe -n 2 "$demens" custom.h5 >run.txt
grep -q '3 runs finished, 0 failed' run.txt
"$demens" replay custom.h5 --run 1 --check >replay.txt
grep -q 'height_m .* the same bits' replay.txt
# It can begin where a stage does, and only as the run that it was.
"$demens" replay custom.h5 --run 1 --checkpoints kept >kept.txt
grep -q 'wrote kept/run-1-stage-1-fall.checkpoint' kept.txt
"$demens" replay custom.h5 --run 1 --from kept/run-1-stage-1-fall.checkpoint --check | diff <(grep bits replay.txt) <(grep bits /dev/stdin)
code=0
"$demens" replay custom.h5 --run 0 --from kept/run-1-stage-1-fall.checkpoint 2>error.txt || code=$?
[ $code -eq 2 ] && grep -q 'is of run 1; give --run 1' error.txt

# Without its files the TOML file is refused, by key and line.
code=0
"$demens" new custom.toml -o other.h5 2>message.txt || code=$?
[ "$code" -eq 2 ]
grep -q 'custom.toml:16: experiment.bench.particles.two.file = "parts/two.csv": parts/two.csv cannot be read' message.txt

"$demens" rigs custom >list.txt
grep -q '^\[\[experiment.wall.motion\]\]' list.txt
grep -q ' kind = "rotation"' list.txt
