#!/usr/bin/env bash
# Makes the tables of README.md: bash tests/bench/calibration/run.sh BUILD_FOLDER (configured with -DDEMENS_BENCHMARKS=ON)
set -euo pipefail
build=$(cd "$1" && pwd)
root=$(cd "$(dirname "$0")/../../.." && pwd)
cmake --build "$build" --target calibration_coverage calibration_economy calibration_recovery \
                                 calibration_stopping
"$build/tests/bench/calibration/calibration_economy" "$root/inputs/auger-table/auger_lactose_doe.csv" 5
"$build/tests/bench/calibration/calibration_recovery" 20
"$build/tests/bench/calibration/calibration_coverage" 100 3
"$build/tests/bench/calibration/calibration_stopping" 12
