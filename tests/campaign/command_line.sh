#!/usr/bin/env bash
# A campaign from TOML to report and replay, as a user types it.
# usage: command_line.sh DEMENS CAMPAIGN.toml
set -euo pipefail
demens=$1 campaign=$2
inputs=$(cd "$(dirname "$campaign")/../../inputs" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$campaign" "$folder/impact.toml"
cd "$folder"

# One simulation without a campaign: at the friction that was looked for, the rebound is the one that was measured.
"$demens" try impact.toml --plan >plan.txt
grep -q 'particles  *about 1$' plan.txt
! grep -q tangential_restitution plan.txt
"$demens" try impact.toml --set contact.steel_steel.static_friction=0.2 |
  awk '$1 == "tangential_restitution" { found = $2 } END { exit !(found > 0.8923 && found < 0.8933) }'
"$demens" try impact.toml --picture seen.png >try.txt
grep -q 'no picture' try.txt # one sphere and a plane, which the rig keeps no snapshot of
! "$demens" try impact.toml --set contact.steel_steel.static_fricton=0.2 2>try.txt
grep -q 'did you mean "contact.steel_steel.static_friction"' try.txt
test ! -e impact.h5

"$demens" new impact.toml >new.txt
grep -q '5 points, 5 runs' new.txt
# The design is in the file before anything is simulated.
"$demens" status impact.h5 | grep -q '^0 *design *5 *0'
mpirun --oversubscribe -n 2 "$demens" impact.h5 >run.txt

# The rebound was calculated for a friction coefficient of 0.2.
awk '$1 == "static_friction" { found = $2 } END { exit !(found > 0.199 && found < 0.201) }' run.txt

"$demens" status impact.h5
"$demens" report impact.h5 -o page.html
test -s page.html

"$demens" replay impact.h5 --run 3 --check --frames frames --frame-interval 1e-5 >replay.txt
grep -q 'tangential_restitution .* the same bits' replay.txt
test -s frames/particles.pvd

# Again: nothing is left to do, also when the TOML file is named and without mpirun.
"$demens" impact.toml >again.txt
diff <(grep -v wall run.txt) <(grep -v wall again.txt)

# Results that were made elsewhere: the design goes out, is filled in (here with what the runs gave) and comes back.
"$demens" export impact.h5 -o out >/dev/null
sed 's/runs = 40/runs = 40\nwall_time_s = 0/' impact.toml >offline.toml
"$demens" new offline.toml >/dev/null
"$demens" export offline.h5 -o design >/dev/null
grep -c 'not run,,.*,,$' design/runs.oblique.csv | grep -qx 5
! "$demens" new offline.toml --results design/runs.oblique.csv --output filled.h5 2>said.txt
grep -q 'no row has results' said.txt
"$demens" new offline.toml --results out/runs.oblique.csv --output filled.h5 >said.txt
grep -q 'runs of oblique are taken from out/runs.oblique.csv' said.txt
"$demens" run filled.h5 --gather >offline.txt || [ $? = 75 ]
awk '$1 == "static_friction" { found = $2 } END { exit !(found > 0.199 && found < 0.201) }' offline.txt

# The other command makes the same campaign in one, and tells of each run where that is asked for.
mkdir one
cp impact.toml one/
mpirun --oversubscribe -n 3 "$demens" one/impact.toml --log-level debug >/dev/null 2>told.txt
runs=$("$demens" status one/impact.h5 --json | grep -oE '"planned":[0-9]+' | head -1 | cut -d: -f2)
[ "$(grep -cE '^[0-9:.]+ rank [0-2]: run [0-9]+ of oblique, point [0-9]+, begins on group [0-2]; expected' told.txt)" = "$runs" ]
[ "$(grep -cE '^[0-9:.]+ rank [0-2]: run [0-9]+ of oblique is finished after [0-9.]+ s$' told.txt)" = "$runs" ]
rm one/impact.h5
"$demens" run one/impact.toml --log-level error >/dev/null 2>told.txt
test ! -s told.txt
! "$demens" --log-level debug status one/impact.h5 >/dev/null 2>told.txt # of what runs alone
grep -q 'log-level' told.txt
"$demens" replay one/impact.h5 --run 3 --check | diff <(grep bits replay.txt) <(grep bits /dev/stdin)

# Everything that a campaign may say can be listed.
"$demens" rigs impact >list.txt
grep -q 'angle_deg .* at least 0 and at most 89' list.txt
"$demens" laws >list.txt
grep -q 'restitution .* required' list.txt
"$demens" keys >list.txt
grep -q '^\[\[factor\]\]' list.txt
# A smaller drum is planned from the real one.
"$demens" scale "$inputs/drum-am-powders/scale-ti64.toml" >plan.txt
grep -q '^  break_energy_mJ_kg  *148.86  *29.772$' plan.txt
grep -q '^  Froude number .* kept$' plan.txt
grep -q '^  inertial number .* times 5$' plan.txt
"$demens" --help >list.txt
grep -q '75 .*run the same command again' list.txt

# What is no option is told with what is meant, also where a required one is missing for it.
! "$demens" replay impact.h5 --runn 3 2>said.txt
grep -q -- '--runn is no option of "replay"; did you mean "--run"?' said.txt
! "$demens" gap plan --jsn=1 impact.toml 2>said.txt
grep -q -- '--jsn is no option of "plan"; did you mean "--json"?' said.txt

# A subcommand's help is its own; the manual page and the completion of a shell know every option.
if "$demens" try --help | grep 'exit codes'; then exit 1; fi
"$demens" man >man.txt
grep -q '^\.B .*\\-\\-frame\\-interval' man.txt
"$demens" completion >completion.bash
bash -c 'source completion.bash; COMP_WORDS=(demens replay --fr); COMP_CWORD=2; _demens; [ "${COMPREPLY[0]}" = --frames ]'

# Targets that nothing reaches: that comes first, no interval is told, nothing is determined.
sed 's/value = 0.8928203230/value = 892.8/' impact.toml >far.toml
"$demens" far.toml >far.txt 2>far.log
grep -q '^  best run up to 1.78e+06 tolerances off the target: oblique.tangential_restitution$' far.txt
grep -q '^  fit: the targets cannot be met together' far.txt
grep -q 'static_friction .* none .* not determined: the targets are missed; the estimate is on the lower bound$' far.txt
grep -q 'best run so far up to 1.78e+06 tolerances off the target' far.log
"$demens" status far.h5 >far.txt
grep -q 'static_friction .*0.05   not determined: the targets are missed$' far.txt
