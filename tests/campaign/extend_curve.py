"""A campaign with a measured curve goes on with another one, and with one more.

usage: extend_curve.py DEMENS TOML
"""
import math
import os
import subprocess
import sys
import tempfile

demens, toml = (os.path.abspath(name) for name in sys.argv[1:3])


def bounces(restitution, radius=0.005, start=0.055, gravity=9.81):
    """Time [s], height [m] and velocity [m/s] of a ball that is dropped onto a plane and bounces in no time."""
    fall = math.sqrt(2 * (start - radius) / gravity)
    for k in range(100):
        t, speed = 0.005 * k, 0.0
        height = start
        if t >= fall:
            t, speed, height = t - fall, restitution * gravity * fall, radius
            while t > 2 * speed / gravity and speed > 1e-3:
                t, speed = t - 2 * speed / gravity, speed * restitution
        yield 0.005 * k, max(radius, height + speed * t - 0.5 * gravity * t * t), speed - gravity * t


def call(*words, code=0):
    done = subprocess.run([demens, *words], capture_output=True, text=True)
    assert done.returncode == code, (words, done.returncode, done.stdout, done.stderr)
    return done.stdout + done.stderr


def found(said):
    """The best run's restitution, of the last table that a session prints."""
    return float([line.split() for line in said.splitlines() if line.split()[:1] == ["restitution"]][-1][1])


def write(file, restitution, what):
    with open(file, "w") as out:
        out.write("t_ms;z_mm\n" if what == "height" else "t_s,v_m_s\n")
        for t, height, velocity in bounces(restitution):
            out.write(f"{1e3 * t:.1f};{1e3 * height:.3f}\n" if what == "height" else f"{t:.3f},{velocity:.5f}\n")


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    with open(toml) as text:
        first = text.read()
    target = first[first.index("target.height_m"):].splitlines()[0]
    first = first.replace(target, 'target.height_m = { file = "camera.csv", time = "t_ms", value = "z_mm" }')
    first = first.replace("points = 8", "points = 6") + "[stop]\nno_improvement_waves = 2\n"
    # Two curves are recorded, of which one is measured at first.
    first = first.replace("[[factor]]", '[[experiment.response]]\nname = "speed"\nquantity = "velocity"\nof = "ball"\n'
                          'take = "mean"\n\n[[factor]]', 1)
    for name, restitution in (("camera", 0.6), ("other", 0.8)):
        write(name + ".csv", restitution, "height")
    write("speed.csv", 0.6, "velocity")
    with open("first.toml", "w") as out:
        out.write(first)
    assert abs(found(call("first.toml")) - 0.6) < 0.02

    # Another file: all runs are kept, and another restitution is found.
    with open("other.toml", "w") as out:
        out.write(first.replace("camera.csv", "other.csv"))
    call("extend", "first.h5", "--continue", "other.toml", "--output", "other.h5")
    said = call("extend", "first.h5", "--continue", "other.toml")
    runs = said[said.index("first.h5: ") + 10:].split()
    assert runs[0] == runs[3] and int(runs[0]) >= 6, said  # N of the N runs that have ended are kept
    assert "target.height_m.file: 'camera.csv', now 'other.csv'" in said, said
    assert abs(found(call("first.h5")) - 0.8) < 0.02

    # The same name with other content, then a curve of what was recorded, but not measured, at first.
    write("other.csv", 0.6, "height")
    said = call("extend", "first.h5", "--continue", "other.toml")
    assert "the file other.csv: other content" in said, said
    call("first.h5")
    with open("both.toml", "w") as out:
        out.write(first.replace("camera.csv", "other.csv").replace(
            'value = "z_mm" }', 'value = "z_mm" }\ntarget.speed = { file = "speed.csv", time = "t_s", value = "v_m_s" }'))
    said = call("extend", "first.h5", "--continue", "both.toml")
    assert "experiment.bounce.target.speed: new" in said, said
    assert abs(found(call("first.h5")) - 0.6) < 0.02

    # What is wrong in a new curve changes nothing.
    before = os.stat("first.h5").st_mtime_ns
    for text, message in ((first.replace("camera.csv", "nothing.csv"), "nothing.csv"),
                          (first.replace("z_mm", "height"), "height"), (first.replace("t_ms", "t_days"), "t_days")):
        with open("wrong.toml", "w") as out:
            out.write(text)
        said = call("extend", "first.h5", "--continue", "wrong.toml", code=2)
        assert "wrong.toml:" in said and message in said, said
    assert os.stat("first.h5").st_mtime_ns == before
