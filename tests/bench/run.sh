#!/usr/bin/env bash
# Installs what the benchmarks need, builds them, times the parts of a step, and compares the engine with its peers.
# Options go to peers.py, e.g. `tests/bench/run.sh --spheres 20000 --rounds 5`. Leave the machine alone meanwhile.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/cmake/setup.sh"

install_packages build bench
build engine_speed -DDEMENS_BENCHMARKS=ON
build parts_bench -DDEMENS_BENCHMARKS=ON
"$root/build/release/tests/bench/parts_bench"
cd "$root" && tests/bench/peers.py "$@"
