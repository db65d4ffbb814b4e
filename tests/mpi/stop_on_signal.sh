#!/bin/bash
# SIGUSR1 lets runs in progress end and leaves with exit code 75; SIGTERM gives them up (mpirun, which passes it on,
# leaves with its own code). Neither blames a run, and the campaign goes on as if nothing had happened.
. "$(dirname "$0")/common.sh"
enter_folder stop-on-signal

# Sends signal $1 while runs of $2 ms are in progress, expects the exit code $3, ends the campaign, and leaves its
# results in $1.txt.
stop_and_go_on() {
  local signal=$1 milliseconds=$2 expected=$3 code=0
  "$DRIVER" create "$signal.h5" "milliseconds = $milliseconds" || fail "create"
  "$MPIRUN" -n 2 "$DRIVER" run "$signal.h5" 1 4 >log.txt 2>&1 &
  local pid=$!
  until ls "$signal".h5.parts/journal-rank-000* >/dev/null 2>&1; do sleep 0.1; done
  sleep 0.5
  "$DRIVER" status "$signal.h5" >status.txt || fail "status"
  expect_text "running, process" status.txt
  kill "-$signal" $pid
  wait $pid || code=$?
  [ $code -eq $expected ] || { cat log.txt; fail "exit code $code after SIG$signal"; }
  cat "$signal".h5.parts/journal-* >"$signal.journal"
  expect_code 0 "$MPIRUN" -n 2 "$DRIVER" run "$signal.h5" 1 4
  "$DRIVER" dump "$signal.h5" >"$signal.txt" || fail "dump"
}

stop_and_go_on USR1 700 75
[ "$(grep -c ' START ' USR1.journal)" -eq "$(grep -c ' END ' USR1.journal)" ] || fail "SIGUSR1 cut a run off"
[ "$(grep -c ' START ' USR1.journal)" -lt 12 ] || fail "SIGUSR1 did not stop anything"

stop_and_go_on TERM 700 1
[ "$(grep -cE ' (DRAIN|STOP) ' TERM.journal)" -ge 1 ] || fail "SIGTERM gave up no run"

diff USR1.txt TERM.txt || fail "the results depend on how the campaign was stopped"
[ "$(grep -c 'status 1 ' TERM.txt)" -eq 12 ] || fail "not every run is finished"
