# Shared by the scripts of this folder: mpirun and the driver are given by CTest.
set -u
DRIVER=$1
MPIRUN=$2
fail() { echo "FAILED: $*" >&2; exit 1; }
# An empty folder of this test to work in.
enter_folder() { rm -rf "$1" && mkdir -p "$1" && cd "$1" || fail "cannot use the folder $1"; }
# Expects the exit code $1 of the command that follows; its output is in log.txt.
expect_code() {
  local expected=$1 code=0; shift
  "$@" >log.txt 2>&1 || code=$?
  [ "$code" -eq "$expected" ] || { cat log.txt; fail "exit code $code instead of $expected: $*"; }
}
expect_text() { grep -q -- "$1" "$2" || { cat "$2"; fail "'$1' is not in $2"; }; }
