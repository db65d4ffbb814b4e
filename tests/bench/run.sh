#!/usr/bin/env bash
# Installs what the benchmarks need, builds them, and makes the tables of RESULTS.md and SCALING.md. Options go to
# peers.py, e.g. `tests/bench/run.sh --rounds 5`. Half an hour; leave the machine alone meanwhile.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/cmake/setup.sh"

install_packages build bench
for program in engine_speed team_speed parts_bench; do
  build "$program" -DDEMENS_BENCHMARKS=ON
done
cd "$root"
bench=build/release/tests/bench states=out/bench

prepare() { # name, then options
  [ -e "$states/$1/state.txt" ] || "$bench/engine_speed" prepare "$states/$1" "${@:2}"
}
tile() { # from, to, boxes along x, along y
  [ -e "$states/$2/state.txt" ] || "$bench/engine_speed" tile "$states/$1" "$states/$2" --along-x "$3" --along-y "$4"
}
prepare box-1000 --kind box --spheres 1000
prepare box-4000 --kind box --spheres 4000
prepare box-20000 --kind box --spheres 20000
prepare box-50000 --kind box --spheres 50000
prepare drum-20000 --kind drum --spheres 20000
prepare drum-equal --kind drum --spheres 10000 --sizes equal
prepare drum-one-to-ten --kind drum --spheres 10000 --sizes one-to-ten
tile box-4000 box-52000 13 1
tile box-20000 box-500000 5 5

echo "# Parts of a step"
"$bench/parts_bench"
echo "# Beside its peers"
tests/bench/peers.py --states "$states" "$@"
echo "# Small and large beds"
for state in box-1000:12000 box-4000:3000 box-20000:600 box-500000:24; do
  echo "${state%%:*} $("$bench/engine_speed" run "$states/${state%%:*}" --warm-up 20 --steps "${state##*:}")"
done
echo "# Laws"
"$bench/engine_speed" laws "$states/box-4000" --rounds 9 --steps 40 --warm-up 100
echo "# A drum as a mesh"
"$bench/engine_speed" mantle "$states/drum-20000" --rounds 600 --steps 1
echo "# Sizes 1:10"
"$bench/engine_speed" compare "$states/drum-equal" "$states/drum-one-to-ten" --rounds 9 --steps 100
echo "# Two ranks"
tests/bench/scaling.py "$bench/team_speed" "$states"/box-{4000,20000,50000,52000} "$states/drum-20000" --rounds 5
