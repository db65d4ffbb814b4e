#!/usr/bin/env python3
"""Times this engine and its peers side by side on the same states; writes a table.

Every code starts from the same particles (position, velocity, spin), with the same law, time step and neighbour
skin, on one core. The codes take turns; the table gives the median of the rounds, and the most memory that a run
had, input and all, over the number of particles. Peers that are not installed (Debian packages liggghts and lammps)
are left out.

    tests/bench/peers.py --build build/release --spheres 20000 --rounds 5
"""
import argparse
import json
import math
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
CASES = [("box", "none"), ("box", "epsd2"), ("drum", "none"), ("drum", "epsd2")]
FRACTION = re.compile(r"Loop time of ([0-9.eE+-]+)")


def run(command, folder):
    """What the command prints, and the most memory it had [bytes]."""
    with tempfile.TemporaryFile("w+") as out, tempfile.TemporaryFile("w+") as errors:
        child = subprocess.Popen([str(word) for word in command], cwd=folder, stdout=out, stderr=errors,
                                 env={**os.environ, "OMP_NUM_THREADS": "1"})
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0), errors.seek(0)
        text = out.read()
        if child.returncode != 0:
            raise RuntimeError(f"{' '.join(map(str, command))} failed:\n{text[-2000:]}{errors.read()[-2000:]}")
    return text, 1024 * usage.ru_maxrss


def header(state):
    kind, width, depth, spin, time_step, skin, spheres = (state / "state.txt").open().readline().split()
    return dict(kind=kind, width=float(width), depth=float(depth), spin=float(spin), dt=float(time_step),
                skin=float(skin), spheres=int(spheres))


def demens(options, state, rolling):
    out, memory = run([options.engine, "run", state, "--rolling", rolling, "--warm-up", str(options.warm_up),
                       "--steps", str(options.steps)], state)
    result = json.loads(out)
    return result["seconds"], result["coordination"], memory


def deck(program, options, state, rolling):
    """Runs the deck of a code of the LAMMPS family; None where it cannot do the case."""
    h = header(state)
    name = pathlib.Path(program).name.replace("lmp", "lammps")
    script = HERE / name / f"{h['kind']}.in"
    if name == "lammps" and rolling != "none":
        return None
    variables = dict(data=state / "state.data", rolling=f"rolling_friction {rolling}" if rolling != "none" else "",
                     dt=h["dt"], skin=h["skin"], width=h["width"], depth=h["depth"], warmup=options.warm_up,
                     steps=options.steps, stl=state / "drum.stl", front=-h["depth"] / 2, back=h["depth"] / 2,
                     radius=h["width"], spin=h["spin"],
                     period=2 * math.pi / h["spin"] if h["spin"] else 1)
    command = [program, "-in", script, "-log", "none"]
    for key, value in variables.items():
        command += ["-var", key, str(value) if str(value) else " "]
    out, memory = run(command, state)
    coordination = float(out[:out.rindex("Loop time")].strip().splitlines()[-1].split()[1])
    return float(FRACTION.findall(out)[-1]), coordination, memory


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=str(HERE.parents[1] / "build/release"), help="build folder")
    parser.add_argument("--spheres", type=int, default=20000)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--warm-up", type=int, default=1000)
    parser.add_argument("--steps", type=int, default=2000)
    parser.add_argument("--states", default="out/bench", help="folder of the prepared states, reused when there")
    options = parser.parse_args()
    options.engine = str(pathlib.Path(options.build).resolve() / "tests/bench/engine_speed")

    codes = {"demens": demens}
    for program in ("liggghts", "lmp"):
        path = shutil.which(program)
        if path:
            codes["lammps" if program == "lmp" else program] = (
                lambda o, s, r, path=path: deck(path, o, s, r))

    print("| case | code | million particle-steps/s | coordination | bytes per particle | demens is faster by |")
    print("|---|---|---|---|---|---|")
    for kind, rolling in CASES:
        state = (pathlib.Path(options.states) / f"{kind}-{options.spheres}").resolve()
        if not (state / "state.txt").exists():
            run([options.engine, "prepare", state, "--kind", kind, "--spheres", str(options.spheres)], ".")
        seconds, coordination, memory = {}, {}, {}
        for _ in range(options.rounds):
            for code, time in codes.items():
                measured = time(options, state, rolling)
                if measured:
                    seconds.setdefault(code, []).append(measured[0])
                    coordination[code], memory[code] = measured[1:]
        for code, times in seconds.items():
            speed = options.spheres * options.steps / statistics.median(times) * 1e-6
            ratio = statistics.median(t / d for t, d in zip(times, seconds["demens"]))
            print(f"| {kind}, rolling {rolling} | {code} | {speed:.2f} | {coordination[code]:.2f} | "
                  f"{memory[code] / options.spheres:.0f} | {ratio:.2f} |", flush=True)


if __name__ == "__main__":
    main()
