#!/bin/bash
# Sessions killed or stopped at random moments, as a whole or by one of their ranks, with runs that take long enough for
# most signals to hit some, and waves that depend on the responses of the last one; then the same with waves that overlap.
# By hand for as long as one likes: KILLS_A_MODE=500.
. "$(dirname "$0")/common.sh"
. "$(dirname "$0")/kills.sh"
enter_folder kill-at-random-moments
SIGNALS=(KILL TERM INT USR1) VICTIMS=(mpirun rank)
WAVES=12 POINTS=8 # 24 runs a wave

# The campaigns differ in one option that neither responses nor seeds depend on.
new_campaign() { "$DRIVER" create "$1.h5" 'milliseconds = 60' || fail "create"; }
session() { SESSION=("$DRIVER" $mode "$1.h5" $WAVES $POINTS); }
for mode in run overlap; do
  rm -f undisturbed.h5
  "$DRIVER" create undisturbed.h5 'milliseconds = 0' || fail "create"
  expect_code 0 "$MPIRUN" -n 1 "$DRIVER" $mode undisturbed.h5 $WAVES $POINTS
  "$DRIVER" dump undisturbed.h5 >undisturbed.txt || fail "dump"
  [ "$(grep -c 'status 1 ' undisturbed.txt)" -eq $((WAVES * POINTS * 3)) ] || fail "not every run is finished"
  kills=0 KILLS=${KILLS_A_MODE:-6}
  kill_many_times
  campaigns=$((campaigns + 1))
done
