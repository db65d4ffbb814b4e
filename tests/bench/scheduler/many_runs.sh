#!/usr/bin/env bash
# What very many trivial runs cost, and whether what tells of them stays usable (README.md here): time of the clock and of the
# processors, largest memory of a process, sizes.  tests/bench/scheduler/many_runs.sh [RUNS] [RANKS]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
source "$root/cmake/setup.sh"
runs=${1:-50000} ranks=${2:-2}
demens=${DEMENS:-$root/build/release/demens}
out=$root/out/many-runs
rm -rf "$out" && mkdir -p "$out" && cd "$out"
sed "s/^points = .*/points = $runs/; s/^waves = .*/waves = 0/; s/^runs = .*/runs = $runs/" "$root/tests/campaign/impact.toml" >many.toml
cat >>many.toml <<'TOML'

[[factor]]
path = "contact.steel_steel.restitution"
lower = 0.5
upper = 1.0
TOML

# measured WHAT COMMAND...: a line of the table
measured() {
    local what=$1
    shift
    /usr/bin/time -f '%e %U %S %M' -o time.txt "$@" >output.txt 2>&1 || { cat output.txt; return 1; }
    awk -v what="$what" '{ printf "| %s | %.1f s | %.1f s | %.0f MB |\n", what, $1, $2 + $3, $4 / 1000 }' <(tail -1 time.txt)
}
echo "| $runs runs, $ranks ranks | of the clock | of the processors | largest process |"
echo "|---|---|---|---|"
measured "\`new\`" "$demens" new many.toml
measured "\`mpirun -n $ranks demens\`" mpirun -n "$ranks" "$demens" many.h5 --log-level error
measured "\`status\`" "$demens" status many.h5
measured "\`report\`" "$demens" report many.h5
measured "\`export\`" "$demens" export many.h5
if browser=$(command -v chromium); then
    measured "the page in a browser" timeout 600 "$browser" --headless --no-sandbox --disable-gpu --disable-dev-shm-usage \
        --user-data-dir="$out/profile" --timeout=600000 --dump-dom "file://$out/many.html"
    grep -q 'data-errors="0"[^>]* data-ready="yes"' output.txt || echo "(the page was not ready)"
    rm -rf profile
fi
ls -l many.h5 many.html | awk '{ printf "%s: %.0f MB\n", $NF, $5 / 1e6 }'
