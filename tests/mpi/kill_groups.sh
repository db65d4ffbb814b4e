#!/bin/bash
# Runs that two ranks share: finished on two and on four ranks, killed and gone on with, stopped by a signal; the results
# are the same bits.
. "$(dirname "$0")/common.sh"
. "$(dirname "$0")/kills.sh"
DEMENS=$3
CAMPAIGN=$(cd "$(dirname "$0")" && pwd)/kill_groups.toml
enter_folder kill-groups
RANKS=(2 4) KILLS=4

new_campaign() { cp "$CAMPAIGN" "$1.toml"; }
session() { SESSION=("$DEMENS" "$1.toml"); }
new_campaign undisturbed
expect_code 2 "$MPIRUN" -n 1 "$DEMENS" undisturbed.toml
expect_text "ranks_per_group = 2" log.txt
expect_code 0 "$MPIRUN" -n 2 "$DEMENS" undisturbed.toml
"$DRIVER" dump undisturbed.h5 >undisturbed.txt || fail "dump"
runs=$(grep -c '^run ' undisturbed.txt)
[ "$(grep -c 'status 1 ' undisturbed.txt)" -eq "$runs" ] || fail "not every run is finished"
expect_code 0 "$MPIRUN" -n 2 "$DEMENS" replay undisturbed.h5 --run 3 --check --frames frames
[ -s frames/particles.pvd ] || fail "no frames"
expect_code 0 "$DEMENS" replay undisturbed.h5 --run 3
expect_text "mpirun -n 2 does" log.txt
kill_many_times

# One rank of a group alone is asked to stop: the group gives up its run, and the campaign ends as if it had not been.
new_campaign stopped
"$MPIRUN" -n 2 "$DEMENS" stopped.toml >log.txt 2>&1 &
mpirun=$!
until ls stopped.h5.parts/journal-rank-000* >/dev/null 2>&1; do sleep 0.02; done
kill -TERM "$(pgrep -P $mpirun | tail -1)"
wait $mpirun
code=$?
[ $code -eq 75 ] || [ $code -eq 0 ] || { cat log.txt; fail "exit code $code after SIGTERM to one rank"; }
expect_code 0 "$MPIRUN" -n 2 "$DEMENS" stopped.toml
"$DRIVER" dump stopped.h5 >stopped.txt || fail "dump"
diff undisturbed.txt stopped.txt || fail "stopping one rank of a group changed the results"
