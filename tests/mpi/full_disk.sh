#!/bin/bash
# A full disk, here a small one in memory: a clear error that names the file, nothing half-written, no run blamed, and
# the same command goes on when there is room.
. "$(dirname "$0")/common.sh"
. "$(dirname "$0")/own_disk.sh"
can_mount || { echo "SKIPPED: a disk in memory can be mounted neither by mount nor in a name space of unshare"; exit 77; }
enter_folder full-disk
mkdir disk && mount -t tmpfs -o size=16m none disk || fail "cannot mount"
trap 'umount disk' EXIT

# Leaves $1 KiB free.
leave_free() {
  rm -f disk/ballast
  local room=$(($(df -k --output=avail disk | tail -1) - $1))
  head -c ${room}K /dev/zero >disk/ballast || fail "ballast"
}

# With $1 KiB free, the command fails, names the file, and leaves the campaign as it was.
expect_no_room() {
  leave_free "$1"; shift
  "$DRIVER" dump disk/campaign.h5 >before.txt || fail "dump"
  expect_code 1 "$MPIRUN" -n 2 "$@"
  expect_text 'No space left on device' log.txt
  expect_text 'disk/campaign.h5' log.txt
  "$DRIVER" dump disk/campaign.h5 >after.txt || fail "the campaign file is damaged"
  diff before.txt after.txt || fail "a failed command changed the campaign"
  [ -z "$(ls disk/campaign.h5.new disk/*/*.part 2>/dev/null)" ] || fail "half-written files are left: $(ls disk/*)"
}

"$DRIVER" create room.h5 || fail "create"
expect_code 0 "$MPIRUN" -n 2 "$DRIVER" run room.h5 1 4
"$DRIVER" dump room.h5 >room.txt

leave_free 8
expect_code 1 "$DRIVER" create disk/campaign.h5
[ -z "$(ls disk/campaign.h5* 2>/dev/null)" ] || fail "left of a campaign without room: $(ls disk)"
leave_free 64
"$DRIVER" create disk/campaign.h5 || fail "create"
for free in 4 24 600; do expect_no_room $free "$DRIVER" plan disk/campaign.h5 4; done
leave_free 2000
expect_code 0 "$MPIRUN" -n 2 "$DRIVER" plan disk/campaign.h5 4
for free in 4 8 16 24 100; do expect_no_room $free "$DRIVER" run disk/campaign.h5 1 4; done # journals and shards
expect_no_room 1200 "$DRIVER" run disk/campaign.h5 1 4 # all shards, but not the gathered wave
rm disk/ballast
expect_code 0 "$MPIRUN" -n 2 "$DRIVER" run disk/campaign.h5 1 4
"$DRIVER" dump disk/campaign.h5 >dump.txt
diff room.txt dump.txt || fail "the campaign that ran out of space differs"
[ "$(grep -c 'status 1 ' dump.txt)" -eq 12 ] || fail "not every run is finished"
