#!/usr/bin/env bash
# Fuzzes the readers of files:  tests/fuzz/run.sh SECONDS [READER...]   (README.md here)
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/cmake/setup.sh"
cd "$root"
seconds=${1:?usage: tests/fuzz/run.sh SECONDS [READER...]}
shift
all=(campaign_toml fit_toml csv particle_csv frames stl picture campaign_file)
readers=("${@:-${all[@]}}")

command -v ccache >/dev/null && export CMAKE_CXX_COMPILER_LAUNCHER=ccache
cmake --preset asan >/dev/null
cmake --build --preset asan --target "${readers[@]/#/fuzz_}"

# Words of the input, which chance would not find.
mkdir -p build/fuzz
cat ensemble/input/CAMPAIGN_INPUT.md tao_calib/FIT.md src/rig/custom/CUSTOM.md | grep -oE '[a-z_]{3,}' | sort -u |
    sed 's/.*/"&"/' >build/fuzz/words.dict

# seeds READER: files to begin with, into build/fuzz/seeds/READER
seeds() {
    local to=build/fuzz/seeds/$1
    rm -rf "$to" && mkdir -p "$to" "build/fuzz/corpus/$1"
    local from=()
    case $1 in
    campaign_toml | fit_toml) mapfile -t from < <(git ls-files 'inputs/*.toml' 'tests/*.toml') ;;
    csv | particle_csv) mapfile -t from < <(git ls-files 'inputs/*.csv' 'tests/*.csv') ;;
    esac
    [ -d "tests/fuzz/seeds/$1" ] && from+=("tests/fuzz/seeds/$1"/*)
    local file
    for file in "${from[@]}"; do cp "$file" "$to/${file//\//_}"; done
}

fuzz() {
    seeds "$1"
    local log=build/fuzz/$1.log
    if ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 "build/asan/tests/fuzz/fuzz_$1" -max_total_time="$seconds" -timeout=20 \
        -rss_limit_mb=2048 -max_len=65536 -dict=build/fuzz/words.dict -print_final_stats=1 -artifact_prefix="build/fuzz/$1-" \
        "build/fuzz/corpus/$1" "build/fuzz/seeds/$1" >"$log" 2>&1; then
        echo "$1: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") cases, no fault"
    else
        tail -40 "$log"
        echo "$1: a fault, see $log and build/fuzz/$1-*"
        return 1
    fi
}
export -f fuzz seeds
export seconds
printf '%s\n' "${readers[@]}" | xargs --max-procs="$(nproc)" -I{} bash -c 'set -euo pipefail; fuzz {}'
