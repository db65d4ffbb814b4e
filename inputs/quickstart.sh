#!/usr/bin/env bash
# Calibrates a small real case on this machine: installs the packages that are missing, builds demens, runs
# inputs/drawdown-quartz/quick.toml and writes its report. A repeated call goes on with what is there;
# --fresh starts the campaign anew.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/cmake/setup.sh"

case "${1-}" in
    '' | --fresh) ;;
    *) sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}"; [ "$1" = --help ]; exit ;;
esac

install_packages build
build demens -DDEMENS_TESTS=OFF

demens=$root/build/release/demens
campaign=$root/out/quickstart/drawdown-quartz.h5
report=${campaign%.h5}.html
mkdir -p "$(dirname "$campaign")"
[ "${1-}" != --fresh ] || rm -rf "$(dirname "$campaign")"/*
[ -e "$campaign" ] || "$demens" new "$root/inputs/drawdown-quartz/quick.toml" --output "$campaign"
mpirun -n 2 "$demens" "$campaign"
"$demens" report "$campaign" --output "$report" >/dev/null
echo "Report: $report"
