#!/bin/bash
# The whole program, killed at random moments: 20 times kill -9 of mpirun, in campaigns that are gone on with until they
# end; each ends with the same runs, responses and analysis, bit for bit, as one that nobody disturbed.
. "$(dirname "$0")/common.sh"
DEMENS=$3
CAMPAIGN=$(cd "$(dirname "$0")" && pwd)/kill_demens.toml
enter_folder kill-demens
RANDOM=${SEED:-7}

cp "$CAMPAIGN" undisturbed.toml
expect_code 0 "$MPIRUN" -n 1 "$DEMENS" undisturbed.toml
"$DRIVER" dump undisturbed.h5 >undisturbed.txt || fail "dump"

kills=0 campaigns=1
# Goes on without a kill when $1 is `end`.
go_on() {
  local file=campaign-$campaigns code=0
  [ -e $file.h5 ] || cp "$CAMPAIGN" $file.toml
  "$MPIRUN" -n $((1 + RANDOM % 3)) "$DEMENS" $file.toml >>$file.log 2>&1 &
  local pid=$!
  [ "$1" = end ] || { sleep "$(printf '%d.%03d' $((RANDOM % 3)) $((100 + RANDOM % 900)))"; kill -9 $pid 2>/dev/null; }
  wait $pid 2>/dev/null || code=$?
  if [ $code -eq 137 ]; then
    kills=$((kills + 1))
  elif [ $code -eq 0 ]; then
    "$DRIVER" dump $file.h5 >$file.txt || fail "dump"
    diff undisturbed.txt $file.txt || fail "$file differs after kills"
    campaigns=$((campaigns + 1))
  else
    tail -5 $file.log; fail "exit code $code"
  fi
}
while [ $kills -lt 20 ]; do go_on kill; done
go_on end
echo "the same after $kills kills in $((campaigns - 1)) campaigns"
