#!/bin/bash
# slurm/demens.sbatch under a real Slurm of one node, made for this test: the signal before the time limit stops the
# campaign, Slurm starts the job again, and the campaign ends with the same results as without Slurm.
. "$(dirname "$0")/common.sh"
DEMENS=$3
SOURCE=$(cd "$(dirname "$0")/../.." && pwd)
if [ "$(id -u)" -ne 0 ] || ! command -v slurmctld slurmd sbatch munged >/dev/null; then
  echo "SKIPPED: needs root and the packages slurmctld slurmd slurm-client munge"; exit 77
fi
for daemon in munged slurmctld slurmd; do
  if pgrep -x $daemon >/dev/null; then echo "SKIPPED: $daemon runs here already"; exit 77; fi
done
enter_folder slurm-requeue
HERE=$PWD
RUN=$(mktemp -d /tmp/demens-slurm.XXXXXX) # MUNGE wants a path that only root can write to, and sockets a short one
chmod 755 "$RUN"

stop_all() {
  local daemons
  daemons=$(cat "$RUN"/*.pid 2>/dev/null)
  for attempt in $(seq 1 20); do kill $daemons 2>/dev/null || break; sleep 0.5; done
  rm -rf "$RUN"
}
trap stop_all EXIT

head -c 1024 /dev/urandom >"$RUN/munge.key" && chmod 400 "$RUN/munge.key"
munged --force --key-file="$RUN/munge.key" --socket="$RUN/munge.socket" --pid-file="$RUN/munged.pid" \
       --log-file="$RUN/munged.log" --seed-file="$RUN/munge.seed" || fail "munged"
export SLURM_CONF=$RUN/slurm.conf
cat >"$SLURM_CONF" <<END
ClusterName=test
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$RUN/munge.socket,cred_expire=5
CryptoType=crypto/munge
StateSaveLocation=$RUN/state
SlurmdSpoolDir=$RUN/spool
SlurmctldPidFile=$RUN/slurmctld.pid
SlurmdPidFile=$RUN/slurmd.pid
SlurmctldLogFile=$RUN/slurmctld.log
SlurmdLogFile=$RUN/slurmd.log
SlurmctldPort=16817
SlurmdPort=16818
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
ReturnToService=2
MinJobAge=600
NodeName=$(hostname) NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$(hostname) Default=YES MaxTime=INFINITE State=UP OverSubscribe=FORCE
END
mkdir "$RUN/state" "$RUN/spool"
slurmctld || fail "slurmctld: $(tail -3 "$RUN/slurmctld.log")"
slurmd || fail "slurmd: $(tail -3 "$RUN/slurmd.log")"

# Waits until the command succeeds; $1: seconds.
within() {
  local end=$((SECONDS + $1)); shift
  until "$@"; do [ $SECONDS -lt $end ] || return 1; sleep 0.5; done
}
job_state() { scontrol -o show job "$JOB" 2>/dev/null | grep -q "JobState=$1"; }

# The driver stands for demens, with a campaign that takes a while.
"$DRIVER" create free.h5 'milliseconds = 0' && "$DRIVER" create campaign.h5 'milliseconds = 400' || fail "create"
expect_code 0 "$MPIRUN" -n 1 "$DRIVER" run free.h5 2 8
"$DRIVER" dump free.h5 >free.txt
printf '#!/bin/bash\nexec "%s" run "$1" 2 8\n' "$DRIVER" >stand-in && chmod +x stand-in
JOB=$(DEMENS=$HERE/stand-in sbatch --parsable --ntasks=2 --time=10 --output="$HERE/job.log" "$SOURCE/slurm/demens.sbatch" campaign.h5) ||
  fail "sbatch"
within 60 job_state RUNNING || { tail "$RUN/slurmctld.log"; fail "the job does not start"; }
within 60 test -d campaign.h5.parts || { cat job.log; fail "no run begins"; }
scancel --batch --signal=USR1 "$JOB" # what Slurm sends before the time limit
within 60 grep -q 'exit code 75' job.log || { cat job.log; fail "the job did not stop"; }
within 200 grep -q 'start 2,' job.log || { scontrol show job "$JOB"; cat job.log; fail "the job was not started again"; }
within 120 job_state COMPLETED || { cat job.log; fail "the job did not end"; }
"$DRIVER" dump campaign.h5 >campaign.txt || fail "dump"
diff free.txt campaign.txt || fail "the results depend on Slurm"

# One wave as a job array of two tasks, gathered by the next session.
"$DRIVER" create array.h5 'milliseconds = 50' || fail "create"
expect_code 0 "$MPIRUN" -n 1 "$DRIVER" plan array.h5 8
printf '#!/bin/bash\nexec "%s" shards "$2" $SLURM_ARRAY_TASK_ID $SLURM_ARRAY_TASK_COUNT\n' "$DRIVER" >stand-in
JOB=$(sbatch --parsable --array=0-1 --ntasks=1 --output="$HERE/array-%a.log" --wrap="'$MPIRUN' -n 1 '$HERE/stand-in' run '$HERE/array.h5'")
within 90 sh -c 'ls array.h5.parts/run-*.h5 2>/dev/null | wc -l | grep -qx 24' || { cat array-*.log; fail "shards are missing"; }
within 60 sh -c '! squeue -h | grep -q .' || fail "the array does not end"
expect_code 0 "$MPIRUN" -n 1 "$DRIVER" run array.h5 2 8
"$DRIVER" dump array.h5 >array.txt || fail "dump"
diff free.txt array.txt || fail "the results depend on the job array"
# A campaign as a chain of job arrays of three tasks, one of which hangs at first and is killed.
cp "$SOURCE/tests/campaign/impact.toml" impact.toml
expect_code 0 "$MPIRUN" -n 2 "$DEMENS" impact.toml
"$DRIVER" dump impact.h5 >impact.txt || fail "dump"
cp impact.toml chain.toml
expect_code 0 "$DEMENS" new chain.toml
cat >stand-in <<END
#!/bin/bash
if [ "\$4" = 1 ] && [ ! -e hung ]; then touch hung; exec sleep 1000; fi
exec "$DEMENS" "\$@"
END
JOB=$(DEMENS=$HERE/stand-in DEMENS_TASK="--time=10 --output=$HERE/chain-%a.log" sbatch --parsable --output="$HERE/chain.log" \
      "$SOURCE/slurm/waves.sbatch" chain.h5 3) || fail "sbatch"
within 90 test -e hung || { cat chain*.log; fail "no task begins"; }
within 60 sh -c '[ "$(squeue -h -r -t RUNNING -n demens-task | wc -l)" = 1 ]' || { squeue; fail "the other tasks do not end"; }
scancel --name=demens-task
within 200 sh -c '! squeue -h | grep -q .' || { squeue; cat chain*.log; fail "the chain does not end"; }
expect_text 'exit code 0' <(cat chain.log demens-waves-*.log)
"$DRIVER" dump chain.h5 >chain.txt || fail "dump"
diff impact.txt chain.txt || fail "the results depend on the chain of job arrays"
echo "stopped, started again and ended: $(grep -c 'start ' job.log) starts"
