#!/usr/bin/env bash
# On a machine with a CUDA device: builds the engine alone with nvcc, runs the tests that need a device, times batches of
# drums beside one core, and writes the table of GPU.md to the folder given (default out/gpu). Needs nvcc, CMake, fmt,
# CLI11 and GoogleTest; no MPI, HDF5 or PETSc. About five minutes.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
out=${1:-$root/out/gpu} seconds=${2:-20}
mkdir -p "$out"
cd "$root"

cmake --preset cuda -DDEMENS_BENCHMARKS=ON >"$out/configure.log"
cmake --build --preset cuda --parallel --target unit_batch unit_programme parity_contacts gpu_speed batch_speed engine_speed >"$out/build.log"
ctest --preset cuda -L '^(gpu|parity)$' --output-on-failure | tee "$out/tests.log"

bench=build/cuda/tests/bench
drum=$out/drum-5000
[ -e "$drum/state.txt" ] || "$bench/engine_speed" prepare "$drum" --kind drum --spheres 5000

# row OPTION...: the state so often
row() { "$bench/gpu_speed" "$drum" --seconds "$seconds" "$@"; }
{
  nvidia-smi --query-gpu=name,driver_version --format=csv,noheader
  echo "| state | replicas x spheres | rolling | particle-steps/s | us a step | steps a search | contacts a sphere |"
  echo "|---|---|---|---|---|---|---|"
  row
  row --replicas 16
  row --replicas 256
  row --along-y 200
  row --replicas 256 --rolling none
  row --replicas 256 --rolling constant_torque
  row --cpu
  for diameter in 3 1.5; do
    "$bench/batch_speed" --runs 64 --diameter $diameter
  done
} | tee "$out/table.md"
