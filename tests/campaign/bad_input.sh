#!/usr/bin/env bash
# Bad input through the executable: a message that names the place, the exit code, and no file left behind.
# usage: bad_input.sh DEMENS CAMPAIGN.toml
set -uo pipefail
demens=$1 good=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0

fail() {
    echo "FAILED: $*"
    failures=$((failures + 1))
}

# expect CODE PATTERN COMMAND...: the exit code, and a line of the output that matches.
expect() {
    local code=$1 pattern=$2 got
    shift 2
    timeout 120 "$@" >output 2>&1
    got=$?
    [ "$got" -eq "$code" ] || fail "$*: exit code $got instead of $code: $(cat output)"
    grep -qE -- "$pattern" output || fail "$*: no line matches '$pattern': $(cat output)"
    rm output
}

# only FILE...: nothing else lies in the folder.
only() {
    local found wanted
    found=$(ls -A | sort | tr '\n' ' ')
    wanted=$(printf '%s\n' "$@" | sort | tr '\n' ' ')
    [ "$found" = "$wanted" ] || fail "files '$found' instead of '$wanted'"
}

# refused PATTERN SED_SCRIPT: the good campaign changed by the script is refused and leaves no file.
refused() {
    sed "$2" "$good" >bad.toml
    cmp -s "$good" bad.toml && fail "nothing changed by $2"
    expect 2 "^demens: error: bad.toml:[0-9]+: $1" "$demens" new bad.toml
    only bad.toml
}

refused 'contact.steel_steel.restituton = 1: unknown key; did you mean "restitution"' 's|restitution = 1.0|restituton = 1.0|'
refused 'material.steel.density = "heavy": must be a number' 's|density = 7800|density = "heavy"|'
refused 'factor\[1\].lower = 0.5: must be below upper = 0.3' 's|lower = 0.05|lower = 0.5|'
refused 'factor\[1\].path = "contact.steel_steel.friction": names nothing' 's|steel_steel.static_friction|steel_steel.friction|'
refused 'experiment.oblique.target.rebound: the rig impact has no such response; did you mean rebound_spin_rad_s' \
    's|target.tangential_restitution|target.rebound|'
refused 'experiment.oblique: .*steel meets glass, but there is no table \[contact.steel_glass\]' \
    's|wall_material = "steel"|wall_material = "glass"|; s|^\[contact|[material.glass]\ndensity = 2500\n[contact|'
refused 'experiment.oblique: the rig impact cannot run this: .*time_step_s' 's|angle_deg = 75|angle_deg = 75\ntime_step_s = 0.01|'
refused 'design.points = 50: 50 design points need 50 runs' 's|points = 5|points = 50|'
# An engine that is not here: nothing is printed of the campaign, and no file is made, before it is refused.
sed 's|^\[design\]|[run]\nengine = "cuda"\n[design]|' "$good" >bad.toml
cmp -s "$good" bad.toml && fail "no [design] to put [run] before"
if ! command -v nvidia-smi >/dev/null; then
    expect 2 'run.engine = "cuda", and this process sees no CUDA device' "$demens" bad.toml
    "$demens" bad.toml 2>&1 | grep -q 'the design has' && fail "the design is printed of a campaign that is refused"
    only bad.toml
fi
rm bad.toml

cp "$good" good.toml
expect 2 'missing.toml: cannot be read' "$demens" new missing.toml
expect 2 '"statsu" is neither a subcommand nor a file; did you mean "status"' "$demens" statsu
expect 2 'FILE.toml is required' "$demens" new
only good.toml

# What is no campaign file stays as it was.
echo "not a campaign" >other.h5
for command in run status report "replay --run 0"; do
    # shellcheck disable=SC2086
    expect 2 'other.h5: ' "$demens" $command other.h5
done
expect 2 'other.h5: exists already' "$demens" new good.toml -o other.h5
[ "$(cat other.h5)" = "not a campaign" ] || fail "other.h5 was changed"
rm -f other.h5 other.h5.lock
only good.toml

# Under mpirun one message, and the same exit code.
sed 's|restitution = 1.0|restituton = 1.0|' "$good" >bad.toml
mpirun --oversubscribe -n 3 "$demens" bad.toml >output 2>&1
[ $? -eq 2 ] || fail "mpirun: not exit code 2: $(cat output)"
[ "$(grep -c 'unknown key; did you mean' output)" -eq 1 ] || fail "mpirun: not one message: $(cat output)"
rm bad.toml output
only good.toml

# A campaign file is not lost to another input.
expect 0 'wrote good.h5' "$demens" new good.toml
cp good.h5 before.h5
expect 2 'good.h5: exists already' "$demens" new good.toml
sed -i 's|restitution = 1.0|restitution = 0.9|' good.toml
expect 2 'good.h5: was made of another input' "$demens" good.toml
expect 2 'there is no run 5; it has runs 0 to 4' "$demens" replay good.h5 --run 5
cmp -s good.h5 before.h5 || fail "good.h5 was changed"
expect 0 'wrote good.h5' "$demens" new good.toml --force
cmp -s good.h5 before.h5 && fail "good.h5 was not replaced"
# A campaign of a newer format is not touched.
if /usr/bin/python3 -c 'import h5py' 2>/dev/null; then
    /usr/bin/python3 -c 'import h5py; h5py.File("good.h5", "r+").attrs["format_version"] = 1000'
    cp good.h5 before.h5
    for command in run status report "replay --run 0"; do
        # shellcheck disable=SC2086
        expect 2 'good.h5: .*1000' "$demens" $command good.h5
    done
    cmp -s good.h5 before.h5 || fail "a campaign of a newer format was changed"
else
    echo "NOT TESTED for want of python3-h5py: a campaign of a newer format"
fi
rm -f before.h5 good.h5 good.h5.lock

# What is given in the place of something else is told as what it is.
printf 'a,b,y\n0,0,1\n1,0,2\n0,1,3\n1,1,4\n0.5,0.5,2.5\n' >table.csv
printf '[fit]\ntable = "table.csv"\nmodel = "linear"\n[[factor]]\ncolumn = "a"\n[[response]]\ncolumn = "y"\n' >fit.toml
"$demens" new good.toml >/dev/null 2>&1
cp good.h5 before.h5
expect 0 '^y: 5 runs' "$demens" fit fit.toml
for command in "fit" "extend good.h5 --continue" "run"; do
    # shellcheck disable=SC2086
    expect 2 'table.csv:1: is a table, and no TOML file|not a campaign file' "$demens" $command table.csv
done
expect 2 'good.h5: is an HDF5 file, e.g. a campaign file' "$demens" fit good.h5
expect 2 'good.h5: is an HDF5 file, e.g. a campaign file' "$demens" extend good.h5 --continue good.h5
expect 2 'this is a campaign: `demens new good.toml`' "$demens" fit good.toml
expect 2 'this is the file of a fit: `demens fit fit.toml`' "$demens" extend good.h5 --continue fit.toml
refit() { # PATTERN SED_SCRIPT
    sed "$2" fit.toml >bad.toml
    cmp -s fit.toml bad.toml && fail "nothing changed by $2"
    expect 2 "$1" "$demens" fit bad.toml
}
refit 'bad.toml:5: factor\[1\].column = "c": table.csv has no column `c`; its columns are a, b, y' 's|"a"|"c"|'
refit 'bad.toml:7: response\[1\].column = "z": table.csv has no column' 's|"y"|"z"|'
refit 'bad.toml:2: fit.table = "nothing.csv": there is no such file' 's|table.csv|nothing.csv|'
refit 'bad.toml:5: factor\[1\].column = "a": none of its values in table.csv, 0 to 1, is between lower = 20 and upper = 30' \
    's|"a"|"a"\nlower = 20\nupper = 30|'
refit 'bad.toml:7: factor\[1\].lower = 0: must be above 0 where log_scale' 's|"a"|"a"\nlog_scale = true\nlower = 0|'
refit 'bad.toml: response `y`: 5 runs cannot determine' 's|"linear"|"quadratic"\nselection = "none"|; s|column = "a"|column = "a"\n[[factor]]\ncolumn = "b"|'
expect 2 'good.h5: no run of it has ended' "$demens" extend good.h5 --runs 3
expect 2 'run 0 has not been run yet' "$demens" replay good.h5 --run 0 --check
expect 2 '^--runs: "many" must be a number above 0' "$demens" extend good.h5 --runs many
expect 2 '^--runs: "-3" must be a number above 0' "$demens" extend good.h5 --runs -3
expect 2 '"stats" is neither a subcommand nor a file; did you mean "status"' "$demens" stats good.h5
cmp -s good.h5 before.h5 || fail "good.h5 was changed by what was refused"
rm -f bad.toml table.csv fit.toml good.h5 before.h5 good.h5.lock

# A file that cannot be written whole is not there at all.
(
    trap '' XFSZ
    ulimit -f 1
    "$demens" new good.toml >output 2>&1
    [ $? -eq 1 ]
) || fail "full disk: not exit code 1: $(cat output)"
grep -q 'good.h5' output || fail "full disk: the message does not name the file: $(cat output)"
rm output
only good.toml

[ "$failures" -eq 0 ] && echo "all passed"
exit $((failures > 0))
