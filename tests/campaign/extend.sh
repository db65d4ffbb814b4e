#!/usr/bin/env bash
# Campaigns that go on: with more runs, other targets, one more factor or experiment, from another material.
# usage: extend.sh DEMENS CAMPAIGN.toml
set -euo pipefail
demens=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$2" "$folder/impact.toml"
cd "$folder"

# expect CODE TEXT COMMAND...: its exit code and something that it says; a refusal leaves the campaign file as it is
expect()
{
  local code=$1 text=$2 found=0
  shift 2
  local before=$(md5sum *.h5)
  "$@" >said.txt 2>&1 || found=$?
  if [ "$found" != "$code" ] || ! grep -qF -- "$text" said.txt; then
    echo "$*: exit code $found instead of $code, or not said: $text"
    cat said.txt
    exit 1
  fi
  [ "$code" = 0 ] || [ "$before" = "$(md5sum *.h5)" ]
}
runs_of() { "$demens" status "$1" --json | python3 -c 'import json, sys; print(json.load(sys.stdin)["runs"]["done"])'; }
found() { awk -v name="$1" '$1 == name { found = $2 } END { print found }' said.txt; }
within() { awk -v x="$1" -v a="$2" -v b="$3" 'BEGIN { exit !(x > a && x < b) }' || { echo "$1 is not in $2 to $3"; exit 1; }; }

"$demens" new impact.toml >/dev/null
expect 2 'say how the campaign goes on' "$demens" extend impact.h5
# Half of the first wave is finished beside the file: these runs are kept, too, when a factor is added.
"$demens" run impact.h5 --task 0 --tasks 2 >/dev/null 2>&1 || true
cp -r impact.h5 part.h5
cp -r impact.h5.parts part.h5.parts
rm -rf impact.h5.parts
mpirun --oversubscribe -n 2 "$demens" impact.h5 >/dev/null 2>&1
first=$(runs_of impact.h5)

# Bad input is refused before anything is touched.
expect 2 'no such file' "$demens" extend nothing.h5 --runs 3
expect 2 '--runs' "$demens" extend impact.h5 --runs 0
expect 2 'says what impact.h5 was made of' "$demens" extend impact.h5 --continue impact.toml
sed 's/diameter_mm = 4/diameter_mm = 5/' impact.toml >other.toml
expect 2 'experiment.oblique.diameter_mm is 5.0 here, 4.0 there' "$demens" extend impact.h5 --continue other.toml
expect 2 'exists already' "$demens" extend impact.h5 --continue other.toml --output impact.h5
sed 's/upper = 0.3/upper = 0.01/' impact.toml >wrong.toml
expect 2 'wrong.toml' "$demens" extend impact.h5 --continue wrong.toml

# More runs, though the goal is reached; a run keeps its bits.
"$demens" replay impact.h5 --run 3 --check >before.txt
expect 0 'at most 6 runs, whether or not its goals are met' "$demens" extend impact.h5 --runs 6
mpirun --oversubscribe -n 2 "$demens" impact.h5 >said.txt 2>&1
[ "$(runs_of impact.h5)" -gt "$first" ] && [ "$(runs_of impact.h5)" -le $((first + 6)) ]
"$demens" replay impact.h5 --run 3 --check | diff <(grep bits before.txt) <(grep bits /dev/stdin)
"$demens" status impact.h5 | grep -q '^extended .*6 more runs'
"$demens" impact.toml >/dev/null 2>&1 # still what it was made of

# A TOML file that says something else is not passed over in silence.
sed -i 's/value = 0.8928203230/value = 0.8660254038/' impact.toml # 1 - 2 mu / tan(75 deg), mu = 0.25
expect 0 'experiment.oblique.target.tangential_restitution.value: 0.892820323' "$demens" impact.h5
expect 2 'demens extend impact.h5 --continue impact.toml' "$demens" impact.toml
# Another target: all runs stay where they are, and the other friction is found.
all=$(runs_of impact.h5)
expect 0 "$all of the $all runs that have ended are kept" "$demens" extend impact.h5 --continue impact.toml
! ls impact.before-1.h5 2>/dev/null
"$demens" replay impact.h5 --run 3 --check | diff <(grep bits before.txt) <(grep bits /dev/stdin)
mpirun --oversubscribe -n 2 "$demens" impact.h5 >said.txt 2>&1
within "$(found static_friction)" 0.249 0.251
"$demens" status impact.h5 --json | grep -q '"changes":\["experiment.oblique.target'
"$demens" report impact.h5 >/dev/null
grep -q '"changes":\["experiment.oblique.target.tangential_restitution.value' impact.html

# One more factor and one more experiment: what is kept is written anew, the file as it was stays.
sed 's/\[design\]/[[factor]]\npath = "contact.steel_steel.restitution"\nlower = 0.8\nupper = 1.0\n[[experiment]]\nname = "straight"\nrig = "impact"\nmaterial = "steel"\nwall_material = "steel"\ndiameter_mm = 4\nspeed_m_s = 1\nangle_deg = 0\ntarget.normal_restitution = { value = 0.9, scale = 0.01, tolerance = 0.002 }\n\n[design]/; s/points = 5/points = 8/' impact.toml >more.toml
cp impact.h5 is.h5
ln impact.h5 impact.before-1.h5 # as an extension that was killed leaves it
expect 0 'impact.before-1.h5' "$demens" extend impact.h5 --continue more.toml
grep -q 'factor.restitution: new' said.txt
grep -q 'experiment.straight: is here only' said.txt
cmp impact.before-1.h5 is.h5
mpirun --oversubscribe -n 2 "$demens" impact.h5 >said.txt 2>&1
within "$(found restitution)" 0.89 0.91
# mu (1 + e) is what the oblique impact tells: 0.25 * 2 / 1.9
within "$(found static_friction)" 0.258 0.268
expect 2 'replay it there' "$demens" replay impact.h5 --run 3
"$demens" replay impact.before-1.h5 --run 3 --check | diff <(grep bits before.txt) <(grep bits /dev/stdin)

# Runs of a wave in progress.
expect 0 '3 of the 3 runs that have ended are kept' "$demens" extend part.h5 --continue more.toml
test ! -e part.h5.parts && test -d part.before-1.h5.parts

# Another material: nothing holds, and its campaign begins with the best point of the first one.
sed 's/density = 7800/density = 2500/' more.toml >glass.toml
expect 0 '0 of the' "$demens" extend impact.h5 --continue glass.toml --output glass.h5
"$demens" status glass.h5 | grep -qE '^0 +design +(18|20) +0'
mpirun --oversubscribe -n 2 "$demens" glass.h5 >said.txt 2>&1
within "$(found restitution)" 0.89 0.91
