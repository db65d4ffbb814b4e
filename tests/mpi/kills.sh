# Sessions interrupted at random moments, KILLS times (8), in campaigns that are gone on with until they end; each ends with
# the same results, bit for bit, as undisturbed.txt. The script that includes this defines
#   new_campaign NAME     makes NAME.h5, or what it is made of
#   session NAME          sets the array SESSION to the command that goes on with it
# and may set RANKS, the numbers of ranks to choose from; SIGNALS; VICTIMS: `mpirun`, `rank` for one of the ranks.
kills=0 campaigns=1
RANDOM=${SEED:-20} # the moments, signals, victims and numbers of ranks
RANKS=(1 2 3) SIGNALS=(KILL) VICTIMS=(mpirun)
declare -A sent # number of times, by signal and victim

# Sends a signal to the mpirun whose process is $1, or to one of its ranks.
interrupt() {
  [ -n "$1" ] || return # it has ended
  local signal=${SIGNALS[RANDOM % ${#SIGNALS[@]}]} victim=${VICTIMS[RANDOM % ${#VICTIMS[@]}]} target=$1 ranks
  if [ $victim = rank ]; then
    ranks=($(pgrep -P "$1"))
    [ ${#ranks[@]} -eq 0 ] || target=${ranks[RANDOM % ${#ranks[@]}]}
  fi
  kill -$signal $target 2>/dev/null && sent[$signal,$victim]=$((${sent[$signal,$victim]:-0} + 1))
}

# One session, interrupted, or not when $1 is `end`.
go_on() {
  local name=campaign-$campaigns code=0 begun=$SECONDS
  [ -e $name.h5 ] || new_campaign $name
  session $name
  timeout --kill-after=10 300 "$MPIRUN" -n ${RANKS[RANDOM % ${#RANKS[@]}]} "${SESSION[@]}" >$name.log 2>&1 &
  local timeout=$!
  [ "$1" = end ] || {
    sleep "$(printf '%d.%03d' $((RANDOM % 3)) $((100 + RANDOM % 900)))"
    interrupt "$(pgrep -P $timeout)"
  }
  wait $timeout 2>/dev/null || code=$?
  # A segmentation fault is none of these: Open MPI may have one when a signal meets the end of a session, while its libraries
  # are taken down. What it would do to results shows in them.
  # Open MPI may also wait for ever for ranks that were interrupted while they joined each other; it says so.
  [ $((SECONDS - begun)) -lt 300 ] || grep -q 'PMIX ERROR' $name.log || fail "it hangs, see $name.log"
  ! grep -E 'terminate called|Assertion|cannot be read back' $name.log || fail "see $name.log"
  if [ $code -eq 0 ]; then
    "$DRIVER" dump $name.h5 >$name.txt || fail "dump"
    diff undisturbed.txt $name.txt || fail "$name differs after kills"
    [ -z "$(ls -d $name.h5.* 2>/dev/null)" ] || fail "left over: $(ls -d $name.h5.*)"
    campaigns=$((campaigns + 1))
  elif [ "$1" = end ]; then
    tail -5 $name.log; fail "exit code $code"
  else
    kills=$((kills + 1))
    [ ! -e $name.h5 ] || "$DRIVER" status $name.h5 >status.txt || fail "status after kill $kills"
  fi
}

kill_many_times() {
  while [ $kills -lt ${KILLS:-8} ]; do go_on kill; done
  go_on end
  echo "the same after $kills interruptions in $((campaigns - 1)) campaigns;$(for key in "${!sent[@]}"; do echo -n " $key ${sent[$key]}"; done)"
}
