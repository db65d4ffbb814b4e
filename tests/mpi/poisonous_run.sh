#!/bin/bash
# A run that kills the program is not begun for ever: it becomes `quarantined`, and the rest of the campaign is there.
. "$(dirname "$0")/common.sh"
enter_folder poisonous-run

# Starts a campaign again until it ends; $1: signal by which runs with x > 0.8 die. Leaves the number of starts.
run_until_done() {
  "$DRIVER" create "$1.h5" 'crash_above = 0.8' "crash_signal = $1" 'milliseconds = 20' || fail "create"
  for starts in $(seq 1 40); do
    "$MPIRUN" -n 2 "$DRIVER" run "$1.h5" 1 6 >log.txt 2>&1 && break
  done
  "$DRIVER" dump "$1.h5" >"$1.txt" || fail "dump"
  poisonous=$(grep -c 'status 7 ' "$1.txt")
  [ "$poisonous" -gt 0 ] || { cat log.txt "$1.txt"; fail "no run was quarantined"; }
  [ "$(grep -c 'status 1 ' "$1.txt")" -eq $((18 - poisonous)) ] || fail "healthy runs were lost"
}

run_until_done 11
expect_text 'ended the program 2 times (signal 11)' 11.txt
[ "$starts" -le $((2 * poisonous + 1)) ] || fail "$starts starts for $poisonous poisonous runs"
segmentation_faults=$poisonous

# Without a last word, as from the kernel when memory runs out, guilt shows only when nothing runs beside it.
run_until_done 9
expect_text 'died 3 times while this run was the only one in progress' 9.txt
[ "$poisonous" -eq "$segmentation_faults" ] || fail "$poisonous poisonous runs, not $segmentation_faults"
