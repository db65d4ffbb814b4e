#!/usr/bin/env bash
# How much of the time two ranks work in a campaign of 40 runs of unequal length (README.md here), as `status` says, and of the time
# of the whole command:  tests/bench/scheduler/forty_runs.sh [SEED...]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
source "$root/cmake/setup.sh"
demens=$root/build/release/demens
out=$root/out/forty-runs
mkdir -p "$out"
echo "| seed | waves | busy, as \`status\` says | command |"
echo "|---|---|---|---|"
for seed in "${@:-1}"; do
    for overlap in false true; do
        campaign=$out/$seed-$overlap.h5
        rm -rf "$campaign"*
        { sed "s/^seed = 1/seed = $seed/" "$here/forty_runs.toml"; printf '\n[search]\noverlap = %s\n' $overlap; } >"$out/campaign.toml"
        cp "$here/model.sh" "$out"
        "$demens" new "$out/campaign.toml" -o "$campaign" >/dev/null
        begin=$(date +%s.%N)
        mpirun -n 2 "$demens" "$campaign" >"${campaign%.h5}.log" 2>&1
        end=$(date +%s.%N)
        share=$("$demens" status "$campaign" --json | grep -oE '"busy_share":[0-9.]+' | tail -1 | cut -d: -f2)
        echo "| $seed | $([ $overlap = true ] && echo overlap || echo one after another) | $(awk "BEGIN {printf \"%.1f %%\", 100 * $share}") | $(awk "BEGIN {printf \"%.0f s\", $end - $begin}") |"
    done
done
