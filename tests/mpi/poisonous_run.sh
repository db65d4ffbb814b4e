#!/bin/bash
# A run that kills the program is not begun for ever: it becomes `quarantined`, and the rest of the campaign is there. So it
# is where points do everything that a point can do.
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

# Every poison in one campaign: healthy up to x = 0.2, then NaN, for ever, particles lost, an exception, no memory, segmentation faults.
"$DRIVER" create all.h5 'nan_above = 0.2' 'hang_above = 0.5' 'escape_above = 0.6' 'throw_above = 0.65' 'memory_above = 0.8' \
  'crash_above = 0.9' 'crash_signal = 11' '[run]' 'run_wall_time_s = 0.2' || fail "create"
for starts in $(seq 1 40); do
  "$MPIRUN" -n 2 "$DRIVER" run all.h5 1 24 >log.txt 2>&1 && break
done
"$DRIVER" dump all.h5 >all.txt || fail "dump"
# The factor x is the first number behind the reason; runs of the second experiment (y alone) are healthy whatever it is.
/usr/bin/python3 - all.txt <<'CHECK' || { cat all.txt; fail "statuses are not those of the points"; }
import re, sys
bands = [(0.9, 7, "signal 11"), (0.8, 6, "not enough memory"), (0.65, 6, "no sphere fits"), (0.6, 3, "3 spheres have left"),
         (0.5, 5, "not done at its limit"), (0.2, 2, "is nan"), (0.0, 1, "")]
seen = {reason: 0 for _, _, reason in bands}
for line in open(sys.argv[1]):
    found = re.match(r"run (\d+) wave \d+ point \d+ seed \d+ status (\d+) reason '(.*?)' (\S+)", line)
    if not found or int(found[1]) % 3 == 2:  # of three runs a point the last is of the other experiment
        assert not found or (found[2], found[3]) == ("1", ""), line
        continue
    status, reason = next((s, r) for least, s, r in bands if float.fromhex(found[4]) > least)
    assert int(found[2]) == status and reason in found[3], line
    seen[reason] += 1
assert all(seen.values()) and sum(seen.values()) == 48, seen
CHECK
"$DRIVER" status all.h5 >status.txt
for reason in 'quarantined' 'not a number' 'timed out' 'escaped' 'error'; do expect_text "$reason" status.txt; done
