#!/bin/bash
# The whole program killed at random moments: the same runs, responses and analysis as of one that nobody disturbed.
. "$(dirname "$0")/common.sh"
. "$(dirname "$0")/kills.sh"
DEMENS=$3
CAMPAIGN=$(cd "$(dirname "$0")" && pwd)/kill_demens.toml
enter_folder kill-demens

new_campaign() { cp "$CAMPAIGN" "$1.toml"; } # demens makes NAME.h5 of it
session() { SESSION=("$DEMENS" "$1.toml"); }
new_campaign undisturbed
expect_code 0 "$MPIRUN" -n 1 "$DEMENS" undisturbed.toml
"$DRIVER" dump undisturbed.h5 >undisturbed.txt || fail "dump"
kill_many_times
