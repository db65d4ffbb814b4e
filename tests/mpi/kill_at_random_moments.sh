#!/bin/bash
# kill -9 of mpirun at random moments, 20 times: the campaign then ends with the same results, bit for bit, as one that
# nobody disturbed.
. "$(dirname "$0")/common.sh"
enter_folder kill-at-random-moments
WAVES=16 POINTS=8 # 24 runs a wave
RANDOM=${SEED:-20}

"$DRIVER" create undisturbed.h5 'milliseconds = 0' || fail "create"
expect_code 0 "$MPIRUN" -n 1 "$DRIVER" run undisturbed.h5 $WAVES $POINTS
"$DRIVER" dump undisturbed.h5 >undisturbed.txt || fail "dump"

"$DRIVER" create killed.h5 'milliseconds = 60' || fail "create"
kills=0
for attempt in $(seq 1 60); do
  "$MPIRUN" -n $((1 + RANDOM % 3)) "$DRIVER" run killed.h5 $WAVES $POINTS >>killed.log 2>&1 &
  pid=$!
  sleep "$(printf '%d.%03d' $((RANDOM % 2)) $((200 + RANDOM % 800)))"
  if kill -9 $pid 2>/dev/null; then kills=$((kills + 1)); fi
  wait $pid 2>/dev/null
  [ $? -eq 137 ] || { tail -5 killed.log; fail "session $attempt was not killed: the campaign is too short for this test"; }
  "$DRIVER" status killed.h5 >status.txt || fail "status after kill $kills"
  [ $kills -eq 20 ] && break
done
expect_code 0 "$MPIRUN" -n 2 "$DRIVER" run killed.h5 $WAVES $POINTS
"$DRIVER" dump killed.h5 >killed.txt || fail "dump"
# The two campaigns differ in one option that no response depends on; seeds do not either.
diff undisturbed.txt killed.txt || fail "the killed campaign differs"
[ "$(grep -c 'status 1 ' killed.txt)" -eq $((WAVES * POINTS * 3)) ] || fail "not every run is finished"
[ -z "$(ls -d killed.h5.* 2>/dev/null)" ] || fail "left over: $(ls -d killed.h5.*)"
echo "the same after $kills kills"
