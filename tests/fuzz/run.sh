#!/usr/bin/env bash
# Fuzzes the readers of files:  tests/fuzz/run.sh SECONDS|same [READER...]   (README.md here)
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/cmake/setup.sh"
cd "$root"
amount=${1:?usage: tests/fuzz/run.sh SECONDS|same [READER...]}
shift
# The number of cases of `same`, by how long a case takes: half a minute of a processor, a whole one for readers of campaigns and of
# what runs leave behind.
cases() {
    case $1 in
    stl) echo 500000 ;;
    fit_toml | picture | frames) echo 200000 ;;
    journal) echo 300000 ;;
    campaign_toml) echo 60000 ;;
    particle_csv | csv) echo 30000 ;;
    shard) echo 16000 ;;
    campaign_file) echo 6000 ;;
    esac
}
all=(campaign_file campaign_toml shard picture frames csv particle_csv fit_toml stl journal) # slow ones first
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
    local log=build/fuzz/$1.log how corpus begin=$SECONDS
    if [ "$amount" = same ]; then
        how=(-seed=1 -runs="$(cases "$1")" -timeout=120)
        corpus=build/fuzz/same/$1
        rm -rf "$corpus" && mkdir -p "$corpus"
    else
        how=(-max_total_time="$amount" -timeout=20)
        corpus=build/fuzz/corpus/$1
    fi
    if ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 "build/asan/tests/fuzz/fuzz_$1" "${how[@]}" \
        -rss_limit_mb=2048 -max_len=65536 -dict=build/fuzz/words.dict -print_final_stats=1 -artifact_prefix="build/fuzz/$1-" \
        "$corpus" "build/fuzz/seeds/$1" >"$log" 2>&1; then
        echo "$1: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") cases in $((SECONDS - begin)) s, no fault"
    else
        tail -40 "$log"
        echo "$1: a fault, see $log and build/fuzz/$1-*"
        return 1
    fi
}
export -f fuzz seeds cases
export amount
printf '%s\n' "${readers[@]}" | xargs --max-procs="$(nproc)" -I{} bash -c 'set -euo pipefail; fuzz {}'
