"""The Python module against the program: the same bits, errors as exceptions, other threads and Ctrl-C.

usage: module_test.py GPF SOURCE, in a folder to work in."""
import json
import pathlib
import signal
import subprocess
import sys
import threading
import time
import warnings

import gpf
import h5py
import numpy

SCENE = """[scene]
geometry = "channel"
particles = 150
area_fraction = 0.3
width_over_diameter = 15
normal_restitution = 0.9
wall_tangential_restitution = 0.8
[run]
start_up = 2
duration = {duration}
density_modes = 2
"""
SHORT = SCENE.format(duration=4)
ENDLESS = SCENE.format(duration=1e6)
passed = 0


def check(condition, what):
    global passed
    if not condition:
        sys.exit(f"FAILED: {what}")
    passed += 1
    print(f"ok {passed} - {what}")


def raises(kind, call, *words):
    try:
        call()
    except Exception as error:
        check(type(error) is kind and all(word in str(error) for word in words), f"{kind.__name__}: {error}")
    else:
        sys.exit(f"FAILED: no {kind.__name__}")


def is_what_the_program_finds(program):
    pathlib.Path("scene.toml").write_text(SHORT)
    pathlib.Path("seven.toml").write_text(SHORT.replace("[run]", "seed = 7\n[run]"))
    for scene, seed, file in (("scene.toml", None, "scene.toml"), (SHORT, 7, "seven.toml")):
        own = gpf.run(scene, seed=seed)
        told = json.loads(subprocess.run([program, "run", file, "-o", "run.h5", "--force", "--json"], check=True,
                                         capture_output=True, text=True).stdout)
        check(own.trace_hash == told["trace_hash"], f"seed {seed}: trace hash {own.trace_hash}")
        check(own.time == told["time"] and numpy.array_equal(own.bins, told["y"]), "time and bins")
        told.update(told.pop("energy_budget"))
        for name, (mean, error) in own.quantities.items():
            for read, printed in ((mean, told[name]["mean"]), (error, told[name]["error"])):
                check(numpy.array_equal(read, numpy.array(printed, dtype=float), equal_nan=True), name)
        check(own.quantities["mean_velocity"].mean.shape == own.bins.shape == (9,), "a profile is an array over bins")
        check(isinstance(own.quantities["mean_flow"].mean, float), "a number is a float")
        for record in (own, gpf.read("run.h5")):
            with h5py.File("run.h5") as file:
                check(numpy.array_equal(record.positions, file["final/position"][:]), "positions")
                check(numpy.array_equal(record.velocities, file["final/velocity"][:]), "velocities")
        check(gpf.run(own.scene).trace_hash == own.trace_hash, "its own scene gives it again")
        own.write("own.h5")
        check(gpf.read(pathlib.Path("own.h5")).trace_hash == own.trace_hash, "written and read")


def errors_are_exceptions():
    raises(ValueError, lambda: gpf.run("[scene]\ngeometri = 1\n"), "scene:2:1", "did you mean")
    raises(ValueError, lambda: gpf.read("scene.toml"))
    raises(OSError, lambda: gpf.read("none.h5"), "none.h5")
    raises(OSError, lambda: gpf.run("none.toml"), "none.toml")
    raises(OSError, lambda: gpf.run(SHORT).write("none/own.h5"))
    raises(ValueError, lambda: gpf.run(SHORT, seed=-1))
    raises(TypeError, lambda: gpf.run(SHORT, seed="one"))
    raises(TypeError, lambda: gpf.run(None))
    # Without the TC model a dense inelastic gas collapses (claim limits.collapse).
    collapse = SHORT.replace("0.9", "0.2", 1).replace("[run]", "tc_time = 0\n[run]")
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        raises(RuntimeError, lambda: gpf.run(collapse), "collapse")
    check(any(w.category is UserWarning and "collapse" in str(w.message) for w in caught), "warned before")


def other_threads_run():
    done = []
    thread = threading.Thread(target=lambda: done.append(gpf.run(SCENE.format(duration=200))))
    thread.start()
    turns = 0
    while thread.is_alive():
        time.sleep(0.005)
        turns += 1
    check(turns > 10 and len(done) == 1, f"{turns} turns of another thread during a run")


def control_c_ends_a_run():
    threading.Timer(0.5, lambda: signal.raise_signal(signal.SIGINT)).start()
    begun = time.monotonic()
    try:
        gpf.run(ENDLESS)
        sys.exit("FAILED: an endless run ended")
    except KeyboardInterrupt:
        check(time.monotonic() - begun < 20, "Ctrl-C ends a run")
    check(gpf.run(SHORT).time > 0, "and the next one runs")


def main():
    check(gpf.__version__, f"gpf {gpf.__version__}")
    is_what_the_program_finds(sys.argv[1])
    errors_are_exceptions()
    other_threads_run()
    control_c_ends_a_run()
    print(f"{passed} passed, 0 failed")


if __name__ == "__main__":
    main()
