"""A disk that fails once: every call that touches the campaign's files fails in turn, on 1 and 2 ranks. Each time the
command ends in bounded time, with an error that names the file or as if nothing had happened, never by a signal; and the
next command, on a sound disk, makes of the campaign what it is when nothing fails.

Arguments: session_driver mpirun demens library [every: all places instead of a spread]

With `every` what was tried is kept in a file that is named after the programs, so that the sweep, which takes hours, goes on where
it was stopped; another build begins anew."""
import hashlib, os, shutil, subprocess, sys
from pathlib import Path

driver, mpirun, _, library = sys.argv[1:5]
every = sys.argv[5:] == ["every"]
kinds = {"writing": "write,pwrite,fsync,fdatasync,ftruncate,rename", "reading": "read,pread,close"}
spread = 4  # places of each kind, number of ranks and failing rank, where not all are taken
run = ["run", "campaign.h5", "2", "3"]
patience = 60  # [s] far more than a run takes
folder = "failing-disk-everywhere" if every else "failing-disk"


def command(ranks, arguments, failing=None):
    environment = dict(os.environ)
    options = [mpirun, "-n", str(ranks)]
    for name, value in (failing or {}).items():
        options += ["-x", f"{name}={value}"]
    if failing is not None:
        options += ["-x", f"LD_PRELOAD={library}"]
    return subprocess.run(options + [driver] + arguments, env=environment, timeout=patience, capture_output=True,
                          text=True)


def dump():
    result = subprocess.run([driver, "dump", "campaign.h5"], capture_output=True, text=True, timeout=patience)
    return result.stdout if result.returncode == 0 else "cannot be read: " + result.stderr


def fresh():
    for path in Path(".").glob("campaign.h5*"):
        shutil.rmtree(path) if path.is_dir() else path.unlink()
    subprocess.run([driver, "create", "campaign.h5"], check=True)


def number_of_calls(ranks, rank, kind):
    fresh()
    Path("calls").unlink(missing_ok=True)
    result = command(ranks, run, {"FAIL_PATH": "campaign.h5", "FAIL_RANK": rank, "FAIL_CALLS": kinds[kind],
                                  "FAIL_COUNT": Path("calls").absolute()})
    if result.returncode != 0:
        sys.exit(f"FAILED: counting on {ranks} ranks: {result.stderr}")
    return int(Path("calls").read_text())


def fail_at(ranks, rank, kind, place, right):
    """What came of a failure: "error" or "unharmed"; anything else is a fault."""
    fresh()
    told = Path("told")
    told.unlink(missing_ok=True)
    where = f"call {place} of rank {rank} of {ranks}"
    try:
        result = command(ranks, run, {"FAIL_PATH": "campaign.h5", "FAIL_RANK": rank, "FAIL_CALLS": kinds[kind], "FAIL_AT": place,
                                      "FAIL_TOLD": told.absolute()})
    except subprocess.TimeoutExpired:
        return f"FAULT: {where} ({told.read_text().strip()}): hangs"
    where += f" ({told.read_text().strip() if told.exists() else 'not reached'})"
    outcome = "unharmed" if result.returncode == 0 else "error"
    if result.returncode == 0 and dump() != right:
        return f"FAULT: {where}: exit 0 and another campaign"
    if result.returncode not in (0, 1, 2):
        return f"FAULT: {where}: exit {result.returncode}\n{result.stderr}"
    if result.returncode != 0 and "campaign.h5" not in result.stderr:
        return f"FAULT: {where}: the error names no file\n{result.stderr}"
    if command(ranks, run).returncode != 0:
        return f"FAULT: {where}: cannot go on"
    return outcome if dump() == right else f"FAULT: {where}: goes on to another campaign"


class Outcomes:
    """What came of each place, kept in a file where all places are tried."""

    def __init__(self):
        self.known, self.file = {}, None
        if not every:
            return
        programs = b"".join(Path(program).read_bytes() for program in (driver, library, __file__))
        self.file = Path(f"outcomes-{hashlib.sha256(programs).hexdigest()[:12]}.txt")
        for line in self.file.read_text().splitlines() if self.file.exists() else []:
            place, _, outcome = line.partition(": ")
            self.known[place] = outcome

    def of(self, place, trial):
        if place not in self.known:
            self.known[place] = trial().replace("\n", " | ")
            if self.file:
                with self.file.open("a") as out:
                    out.write(f"{place}: {self.known[place]}\n")
        return self.known[place]


def main():
    if not every:
        shutil.rmtree(folder, ignore_errors=True)
    Path(folder).mkdir(exist_ok=True)
    os.chdir(folder)
    outcomes = Outcomes()
    fresh()
    if command(1, run).returncode != 0:
        sys.exit("FAILED: the campaign without any failure")
    right = dump()
    faults, counts = [], {}
    for ranks, rank in ((2, 1), (2, 0), (1, 0)):
        for kind in kinds:
            calls = number_of_calls(ranks, rank, kind)
            # Reads are many and alike, and tried again when they fail.
            step = max(1, calls // (spread if not every else calls if kind == "writing" else 40))
            for place in range(1 + step // 2, calls + 1, step):
                outcome = outcomes.of(f"{ranks} ranks, rank {rank}, {kind} {place}",
                                      lambda: fail_at(ranks, rank, kind, place, right))
                if outcome.startswith("FAULT"):
                    print(outcome, flush=True)
                    faults.append(outcome)
                    outcome = "fault"
                key = f"{ranks} ranks, rank {rank} fails {kind} ({calls} calls)"
                counts[key, outcome] = counts.get((key, outcome), 0) + 1
    for (key, outcome), count in counts.items():
        print(f"{key}: {count} {outcome}")
    sys.exit(1 if faults else 0)


main()
