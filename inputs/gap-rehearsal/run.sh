#!/bin/sh
# Bank, 48 sealed cases, diagnosis without their truths, scores; goes on where it was stopped.
# usage: run.sh DEMENS RANKS FOLDER [CASES]
set -eu
demens=$1 ranks=$2 folder=$3 cases=${4:-48}
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$folder"
[ -e "$folder/bank.toml" ] || python3 "$here/make_campaign.py" "$folder/bank.toml"
[ -e "$folder/campaign.toml" ] || python3 "$here/make_campaign.py" "$folder/campaign.toml" bank.h5
mpirun -n "$ranks" "$demens" gap bank "$folder/bank.toml" --points-per-effect 14
mpirun -n "$ranks" "$demens" gap rehearse draw "$folder/campaign.toml" -o "$folder/rehearsal" --cases "$cases" \
    --outside "$(python3 "$here/make_campaign.py" --outside)"
mpirun -n "$ranks" "$demens" gap rehearse diagnose "$folder/rehearsal"
"$demens" gap rehearse score "$folder/rehearsal"
