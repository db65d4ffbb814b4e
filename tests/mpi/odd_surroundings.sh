#!/bin/bash
# What surrounds a campaign changes between two sessions or is not as usual: it is moved while it is half done, its folder becomes
# read-only, the clock jumps by a year to and fro, files cannot be locked. Each time it ends as if nothing had been.
. "$(dirname "$0")/common.sh"
ODD_SYSTEM=$4
. "$(dirname "$0")/own_disk.sh"
enter_folder odd-surroundings

"$DRIVER" create plain.h5 'milliseconds = 30' || fail "create"
expect_code 0 "$MPIRUN" -n 2 "$DRIVER" run plain.h5 2 4
"$DRIVER" dump plain.h5 >plain.txt
# The campaign $1 has the results of the undisturbed one.
expect_same() { "$DRIVER" dump "$1" >dump.txt && diff plain.txt dump.txt || fail "$2: other results"; }

# Runs a while of $1 and is asked to stop.
begin() {
  "$DRIVER" create "$1" 'milliseconds = 30' || fail "create"
  "$MPIRUN" -n 2 "$DRIVER" run "$1" 2 4 >log.txt 2>&1 &
  until ls "$1".parts/run-*.h5 >/dev/null 2>&1; do sleep 0.02; kill -0 $! 2>/dev/null || break; done
  kill -TERM $!; wait $!
}

# Moved, and copied without what lies beside it: its runs in progress are made again.
mkdir here there copy
begin here/campaign.h5
cp here/campaign.h5 copy/
mv here/campaign.h5* there/
for place in there copy; do
  expect_code 0 "$MPIRUN" -n 2 "$DRIVER" run $place/campaign.h5 2 4
  expect_same $place/campaign.h5 "moved, $place"
done

# The clock of the one rank is years off that of the other, and jumps between any two looks.
begin clock.h5
expect_code 0 "$MPIRUN" -n 1 -x LD_PRELOAD="$ODD_SYSTEM" -x ODD_CLOCK=31536000 "$DRIVER" run clock.h5 2 4 : -n 1 "$DRIVER" run clock.h5 2 4
expect_same clock.h5 "jumping clock"
begin clock2.h5
LD_PRELOAD="$ODD_SYSTEM" ODD_CLOCK=31536000 "$DRIVER" status clock2.h5 >status.txt || fail "status under a jumping clock"

# No locks: said, and goes on.
begin locks.h5
expect_code 0 "$MPIRUN" -n 2 -x LD_PRELOAD="$ODD_SYSTEM" -x ODD_LOCKS=1 "$DRIVER" run locks.h5 2 4
expect_text 'this file system seems to have no locks' log.txt
expect_same locks.h5 "no locks"

# Read-only: the command says which file it cannot write, and changes nothing; reading goes on.
if can_mount; then
  mkdir disk && mount -t tmpfs none disk || fail "cannot mount"
  trap 'umount disk' EXIT
  begin disk/campaign.h5
  "$DRIVER" dump disk/campaign.h5 >before.txt
  mount -o remount,ro disk || fail "cannot make it read-only"
  expect_code 1 "$MPIRUN" -n 2 "$DRIVER" run disk/campaign.h5 2 4
  expect_text 'disk/campaign.h5' log.txt
  expect_text 'Read-only file system' log.txt
  expect_code 0 "$DRIVER" status disk/campaign.h5
  "$DRIVER" dump disk/campaign.h5 | diff before.txt - || fail "a read-only campaign has changed"
  mount -o remount,rw disk || fail "cannot make it writable"
  expect_code 0 "$MPIRUN" -n 2 "$DRIVER" run disk/campaign.h5 2 4
  expect_same disk/campaign.h5 "read-only for a while"
fi
