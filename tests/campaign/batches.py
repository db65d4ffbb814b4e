"""A campaign whose runs are computed many at once, as on a device: the same bits as one after another, on one rank
and on two, after SIGTERM and after SIGKILL.

usage: batches.py DEMENS MPIRUN IMPACT.toml; exit 77 where h5py is missing
"""
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time

try:
    import h5py
except ImportError:
    print("skipped: no h5py")
    sys.exit(77)

demens, mpirun, template = sys.argv[1:4]


def campaign(name, run, slow=False):
    text = open(template).read() + f'\n[run]\nengine = "cuda_on_host"\n{run}\n'
    if slow:  # so that there is time to interrupt it
        text = text.replace("angle_deg = 75", "angle_deg = 75\nrayleigh_fraction = 1e-4")
    with open(name + ".toml", "w") as file:
        file.write(text)
    subprocess.run([demens, "new", name + ".toml"], check=True, stdout=subprocess.DEVNULL)
    return name + ".h5"


def results(file):
    with h5py.File(file) as campaign:
        return [(campaign[f"waves/{wave}/runs/status"][:].tolist(), campaign[f"waves/{wave}/responses/oblique"][:].tolist(),
                 campaign[f"waves/{wave}/factors"][:].tolist() if f"waves/{wave}/factors" in campaign else None)
                for wave in sorted(campaign["waves"])]


def run(file, ranks):
    subprocess.run([mpirun, "-n", str(ranks), demens, file], check=True, stdout=subprocess.DEVNULL,
                   stderr=subprocess.DEVNULL)
    return results(file)


def interrupted(file, with_signal):
    process = subprocess.Popen([demens, file], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    journal = os.path.join(file + ".parts", "journal-rank-0000")
    while process.poll() is None and not (os.path.exists(journal) and open(journal).read().count("START") >= 4):
        time.sleep(0.01)
    assert process.poll() is None, process.stderr.read()
    process.send_signal(with_signal)
    process.wait()
    words = [line.split()[1] for line in open(journal).read().splitlines()]
    return process.returncode, words


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    expected = run(campaign("one", "runs_together = 1"), 1)
    assert all(status == 1 for wave in expected for status in wave[0]), expected
    assert run(campaign("three", "runs_together = 3"), 1) == expected
    assert run(campaign("two-ranks", ""), 2) == expected

    # More slots than there is memory for: half of them, and half again, until they fit.
    limit = 3 << 30
    subprocess.run([demens, campaign("little-memory", "runs_together = 8192")], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
    assert results("little-memory.h5") == expected

    code, words = interrupted(campaign("stopped", "runs_together = 4", slow=True), signal.SIGTERM)
    assert code == 75, code
    assert words.count("START") == 4 and words.count("DRAIN") == 4, words
    code, words = interrupted(campaign("killed", "runs_together = 4", slow=True), signal.SIGKILL)
    assert words.count("START") == 4 and words.count("END") == 0, words
    expected = run("stopped.h5", 1)
    assert run("killed.h5", 2) == expected
    print(expected)
