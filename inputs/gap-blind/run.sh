#!/bin/sh
# The bank, then campaigns of packs with it. Each step goes on where it was stopped.
# usage: run.sh DEMENS RANKS FOLDER bank
#        run.sh DEMENS RANKS FOLDER PACK...   a campaign of each, what `demens gap` says, and the answer
set -eu
demens=$1 ranks=$2 folder=$3
shift 3
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$folder"
if [ "$1" = bank ]; then
    [ -e "$folder/bank.toml" ] || python3 "$here/make_campaign.py" --bank "$folder/bank.toml"
    exec mpirun -n "$ranks" "$demens" gap bank "$folder/bank.toml" --points-per-effect 6
fi
for pack in "$@"; do
    name=$(basename "$pack")
    [ -e "$folder/$name.toml" ] || python3 "$here/make_campaign.py" "$pack" "$folder/$name.toml" bank.h5
    mpirun -n "$ranks" "$demens" "$folder/$name.toml" >"$folder/$name.txt"
    "$demens" gap "$folder/$name.h5" --json >"$folder/$name.json"
    python3 "$here/answer.py" "$folder/$name.json" "$folder/$name.answer.json"
    echo "$name: $folder/$name.answer.json"
done
