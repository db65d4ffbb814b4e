#!/bin/bash
# Sessions killed at random moments, with runs that take long enough for most kills to hit some, and waves that depend
# on the responses of the last one.
. "$(dirname "$0")/common.sh"
. "$(dirname "$0")/kills.sh"
enter_folder kill-at-random-moments
WAVES=12 POINTS=8 # 24 runs a wave

"$DRIVER" create undisturbed.h5 'milliseconds = 0' || fail "create"
expect_code 0 "$MPIRUN" -n 1 "$DRIVER" run undisturbed.h5 $WAVES $POINTS
"$DRIVER" dump undisturbed.h5 >undisturbed.txt || fail "dump"
[ "$(grep -c 'status 1 ' undisturbed.txt)" -eq $((WAVES * POINTS * 3)) ] || fail "not every run is finished"

# The campaigns differ in one option that neither responses nor seeds depend on.
new_campaign() { "$DRIVER" create "$1.h5" 'milliseconds = 60' || fail "create"; }
session() { SESSION=("$DRIVER" run "$1.h5" $WAVES $POINTS); }
kill_many_times
