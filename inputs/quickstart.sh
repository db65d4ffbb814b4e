#!/usr/bin/env bash
# Calibrates a small real case on this machine: installs the packages that are missing, builds demens, runs
# inputs/drum-quick/campaign.toml and writes its report. A repeated call goes on with what is there.
#   --fresh    starts the campaign anew
#   --demo     runs inputs/sphere-rebound/campaign.toml instead, which ends in seconds
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/cmake/setup.sh"

case=drum-quick fresh=
for option; do
    case "$option" in
        --fresh) fresh=yes ;;
        --demo) case=sphere-rebound ;;
        *) sed -n '2,5s/^# \?//p' "${BASH_SOURCE[0]}"; [ "$option" = --help ]; exit ;;
    esac
done

install_packages build
build demens -DDEMENS_TESTS=OFF

demens=$root/build/release/demens
campaign=$root/out/quickstart/$case.h5
report=${campaign%.h5}.html
mkdir -p "$(dirname "$campaign")"
[ -z "$fresh" ] || rm -rf "$campaign" "$campaign".* "$report"
[ -e "$campaign" ] || "$demens" new "$root/inputs/$case/campaign.toml" --output "$campaign"
mpirun -n 2 "$demens" "$campaign"
"$demens" report "$campaign" --output "$report" >/dev/null
echo "Report: $report"
