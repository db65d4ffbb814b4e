# kill -9 of mpirun at random moments, KILLS times (8), in campaigns that are gone on with until they end; each ends with the
# same results, bit for bit, as undisturbed.txt. The script that includes this defines
#   new_campaign NAME     makes NAME.h5, or what it is made of
#   session NAME          sets the array SESSION to the command that goes on with it
# and may set RANKS, the numbers of ranks to choose from.
kills=0 campaigns=1
RANDOM=${SEED:-20} # the moments and numbers of ranks
RANKS=(1 2 3)

# One session, killed, or not when $1 is `end`.
go_on() {
  local name=campaign-$campaigns code=0
  [ -e $name.h5 ] || new_campaign $name
  session $name
  "$MPIRUN" -n ${RANKS[RANDOM % ${#RANKS[@]}]} "${SESSION[@]}" >>$name.log 2>&1 &
  local pid=$!
  [ "$1" = end ] || { sleep "$(printf '%d.%03d' $((RANDOM % 3)) $((100 + RANDOM % 900)))"; kill -9 $pid 2>/dev/null; }
  wait $pid 2>/dev/null || code=$?
  if [ $code -eq 137 ]; then
    kills=$((kills + 1))
    [ ! -e $name.h5 ] || "$DRIVER" status $name.h5 >status.txt || fail "status after kill $kills"
  elif [ $code -eq 0 ]; then
    "$DRIVER" dump $name.h5 >$name.txt || fail "dump"
    diff undisturbed.txt $name.txt || fail "$name differs after kills"
    [ -z "$(ls -d $name.h5.* 2>/dev/null)" ] || fail "left over: $(ls -d $name.h5.*)"
    campaigns=$((campaigns + 1))
  else
    tail -5 $name.log; fail "exit code $code"
  fi
}

kill_many_times() {
  while [ $kills -lt ${KILLS:-8} ]; do go_on kill; done
  go_on end
  echo "the same after $kills kills in $((campaigns - 1)) campaigns"
}
