#!/usr/bin/env bash
# Installs the packages that are missing, builds demens and runs its tests, all but those labelled `long`.
# Options go to ctest, e.g. `tests/run.sh -L unit` or `tests/run.sh -R report --output-on-failure`.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/cmake/setup.sh"

install_packages build test
build all -DDEMENS_TESTS=ON
# More at a time than cores: tests of sessions wait much of the time, for signals, disks and mpirun.
exec ctest --test-dir "$root/build/release" --label-exclude '^long$' --parallel "$(($(nproc) + 2))" --output-on-failure "$@"
