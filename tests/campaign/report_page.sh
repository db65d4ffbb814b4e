#!/usr/bin/env bash
# The report of a real campaign in a real browser: before any run, and when it has ended.
# usage: report_page.sh DEMENS CAMPAIGN.toml CHROMIUM
set -euo pipefail
demens=$1 campaign=$2 chromium=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cp "$campaign" "$folder/impact.toml"
cd "$folder"

# page_body: writes the report, lets its scripts run, prints the page that they made, without the scripts.
page_body()
{
    "$demens" report impact.h5 >/dev/null
    timeout 120 "$chromium" --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --disable-quic --no-first-run \
        --disable-background-networking --disable-component-update --disable-sync --user-data-dir="$folder/profile" \
        --virtual-time-budget=20000 --dump-dom "file://$folder/impact.html" 2>/dev/null | sed '/^<script>/,/^<\/script>/d'
}

"$demens" new impact.toml >/dev/null
page_body >dom.html
grep -q '<body[^>]* data-errors="0"[^>]* data-ready="yes"' dom.html
grep -q 'No best fit yet' dom.html

mpirun --oversubscribe -n 2 "$demens" impact.h5 >/dev/null
page_body >dom.html
grep -q '<body[^>]* data-errors="0"[^>]* data-ready="yes"' dom.html
grep -q 'every target with a tolerance is met' dom.html
for plot in deviations convergence intervals response-0-1-static_friction timing; do
    grep -q "data-plot=\"$plot\" [^>]*data-marks=\"[1-9]" dom.html || { echo "no marks in plot $plot"; exit 1; }
done
# The friction coefficient of the best point, as the table shows it.
grep -q '<td><b>0\.2</b></td>' dom.html

# A film of the best run, which is simulated again; what there is no picture of, and what is not there, is said.
"$demens" report impact.h5 --film --film-frames 5 >again.txt
grep -q 'simulating run [0-9]* for its film' again.txt
grep -q '"films":\[{' impact.html
refused() { if "$demens" report impact.h5 --picture-runs "$1" 2>refused.txt >/dev/null; then exit 1; fi; grep -q "$2" refused.txt; }
refused 99 'there is no run 99; it has runs 0 to'
refused 0 'run 0 has no picture: its rig keeps none'
