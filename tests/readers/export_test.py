"""Files of `gpf export` in the programs that they are for: what these read is compared with the record.

usage: export_test.py READER GPF WORKDIR; READER is a function below. Exit status 77 when it is not installed."""
import json
import pathlib
import shutil
import subprocess
import sys

try:
    import h5py
    import numpy
except ImportError as missing:
    print("skipped:", missing)
    sys.exit(77)

SCENE = """[scene]
geometry = "{geometry}"
particles = 200
area_fraction = 0.3
{size}
normal_restitution = 0.9
{walls}
[run]
start_up = 2
duration = 4
snapshots = [1, 3]
"""
KINDS = {"channel": SCENE.format(geometry="channel", size="width_over_diameter = 15",
                                 walls="wall_tangential_restitution = 0.8") + "density_modes = 3\n",
         "periodic": SCENE.format(geometry="periodic", size="length_over_width = 2", walls="")}
passed = 0


def check(condition, what):
    global passed
    if not condition:
        sys.exit(f"FAILED: {what}")
    passed += 1
    print(f"ok {passed} - {what}")


class Flow:
    """A record, what gpf says of it, and its states as h5py reads them from the record itself."""

    def __init__(self, gpf, folder, kind):
        self.gpf, self.kind, self.record = gpf, kind, folder / f"{kind}.h5"
        self.scene = folder / f"{kind}.toml"
        self.scene.write_text(KINDS[kind])
        self.summary = json.loads(self.call("run", self.scene, "-o", self.record, "--json"))
        with h5py.File(self.record) as file:
            self.time = numpy.append(file["snapshots/time"][:], file.attrs["time"])
            self.position, self.velocity = (
                numpy.concatenate([file[f"snapshots/{name}"][:], file[f"final/{name}"][:][None]])
                for name in ("position", "velocity"))

    def call(self, *arguments):
        return subprocess.run([self.gpf, *map(str, arguments)], check=True, capture_output=True, text=True).stdout

    def export(self, form, *options):
        return pathlib.Path(self.call("export", self.record, "--format", form, *options).split("\n")[0])

    def box(self):
        with h5py.File(self.export("h5md-2d", "--force")) as file:
            length, width = file["particles/disks/box/edges"]
            return length, width, file["parameters/diameter"][()]

    def is_same(self, states, of=slice(None)):
        """states: (time, positions, velocities); z must be 0 and the rest the record's, to the last bit."""
        time, position, velocity = map(numpy.asarray, states)
        check(numpy.array_equal(time, self.time[of]), f"{self.kind}: times {time}")
        for what, read, own in (("positions", position, self.position), ("velocities", velocity, self.velocity)):
            check(numpy.array_equal(read[..., :2], own[of]), f"{self.kind}: {what} are the record's, bit by bit")
            check(not read[..., 2:].any(), f"{self.kind}: {what} have no z")


def read_h5md(path):
    with h5py.File(path) as file:
        return [file["particles/disks"][name][:] for name in ("position/time", "position/value", "velocity/value")]


def reads_h5py(flow):
    for form, dimension in (("h5md", 3), ("h5md-2d", 2)):
        flow.is_same(read_h5md(flow.export(form, "--force")))
        with h5py.File(flow.export(form, "--author", "A. Reader", "--force")) as file:
            particles, box = file["particles/disks"], file["particles/disks/box"]
            check(list(file["h5md"].attrs["version"]) == [1, 1], "H5MD 1.1")
            check(file["h5md/author"].attrs["name"] == b"A. Reader", "the author is told")
            check(file["h5md/creator"].attrs["name"] == b"gpf", "and the creator")
            check(box.attrs["dimension"] == dimension, f"{dimension} dimensions")
            walls = b"periodic" if flow.kind == "periodic" else b"none"
            check(list(box.attrs["boundary"]) == [b"periodic", walls, b"none"][:dimension], "boundaries")
            check(particles["velocity/time"] == particles["position/time"], "velocities share the positions' times")
            check(list(particles["position/step"]) == [0, 1, 2], "steps count")
            check(particles["species"].shape == (200,) and not particles["species"][:].any(), "one species")
            check((particles["radius"][:] == file["parameters/diameter"][()] / 2).all(), "radii")
            energy = (flow.velocity**2).sum(axis=2).mean(axis=1) / 2
            check(numpy.allclose(file["observables/kinetic_energy/value"][:], energy, rtol=1e-13), "energy")
            temperature = file["observables/granular_temperature/value"][:]
            check(((temperature > 0) & (temperature <= energy)).all(), "granular temperature")
            check(b'geometry = "%s"' % flow.kind.encode() in file["parameters/scene"][()], "the scene is told")
            check(file["parameters/trace_hash"][()].decode() == flow.summary["trace_hash"], "and the trace hash")
    if flow.kind == "channel":  # from the start the frames pass the states of the run
        frames = read_h5md(flow.export("h5md", "--frames", 4, "--interval", 1, "--from-start", "--force"))
        check(list(frames[0]) == [0, 1, 2, 3], "a trajectory from the start")
        flow.is_same([array[[1, 3]] for array in frames], slice(0, 2))
        late = read_h5md(flow.export("h5md", "--frames", 2, "--force"))
        # The engine lays positions on a grid of 2^-52 before it begins.
        check(late[0][0] == flow.time[-1] and abs(late[1][0, :, :2] - flow.position[-1]).max() < 2**-50, "one from the end")


def reads_h5dump(flow):
    if shutil.which("h5dump") is None:
        print("skipped: no h5dump")
        sys.exit(77)
    path = flow.export("h5md")
    dump = lambda *options: subprocess.run(["h5dump", *options, path], check=True, capture_output=True, text=True).stdout
    check('GROUP "disks"' in dump("-H"), "h5dump lists the groups")
    values = dump("-y", "-m", "%.17g", "-d", "/particles/disks/position/value").split("DATA {")[1].split("}")[0]
    read = numpy.array([float(value) for value in values.replace(",", " ").split()]).reshape(3, 200, 3)
    check(numpy.array_equal(read[..., :2], flow.position), "h5dump prints the record's positions")


def reads_mdanalysis(flow):
    import MDAnalysis
    universe = MDAnalysis.Universe.empty(200, trajectory=True)
    universe.load_new(str(flow.export("h5md")), convert_units=False)
    check(len(universe.atoms) == 200 and len(universe.trajectory) == 3, "MDAnalysis sees disks and frames")
    box = [*flow.box(), 90, 90, 90]
    for frame, time, position, velocity in zip(universe.trajectory, flow.time, flow.position, flow.velocity):
        check(frame.time == time, f"time {time}")
        check(numpy.allclose(frame.dimensions, box, rtol=1e-6), f"box {frame.dimensions}")
        # MDAnalysis keeps single precision.
        check(numpy.array_equal(frame.positions[:, :2], position.astype("f4")), "positions")
        check(numpy.array_equal(frame.velocities[:, :2], velocity.astype("f4")), "velocities")
        check(numpy.isclose(frame.data["kinetic_energy"], (velocity**2).sum(axis=1).mean() / 2), "energy")


def reads_ase(flow):
    import ase.io
    frames = ase.io.read(flow.export("xyz"), ":")
    flow.is_same([[f.info["Time"] for f in frames], [f.positions for f in frames], [f.arrays["velo"] for f in frames]])
    length, width, diameter = flow.box()
    for frame in frames:
        check(numpy.array_equal(frame.cell, numpy.diag([length, width, diameter])), "cell")
        check(list(frame.pbc) == [True, flow.kind == "periodic", False], "boundaries")
        check((frame.arrays["radius"] == diameter / 2).all(), "radii")


def is_table(flow, column, size):
    """column(name): of a table of profiles or modes; all that gpf says is there, number by number."""
    found = 0
    for name, told in flow.summary.items():
        if isinstance(told, dict) and isinstance(told.get("mean"), list) and (
                name.startswith("density_power") == (size == "modes")):
            found += 1
            for part, read in (("mean", column(name)), ("error", column(name + "_error"))):
                own = numpy.array(told[part], dtype=float)  # null: nan
                check(numpy.array_equal(read, own, equal_nan=True), f"{name}: {part}, to the last bit")
    check(found >= 3, f"{found} quantities")


def reads_numpy(flow):
    path = flow.export("csv")
    profiles = numpy.genfromtxt(path, delimiter=",", names=True)
    is_table(flow, profiles.__getitem__, "profiles")
    check(numpy.array_equal(profiles["y"], flow.summary["y"]) and profiles["bin"][0] == 1, "bins")
    if flow.kind == "channel":
        modes = numpy.genfromtxt(path.with_stem(path.stem + "-modes"), delimiter=",", names=True)
        is_table(flow, modes.__getitem__, "modes")
        check(list(modes["k"]) == [1, 2, 3], "wavenumbers")


def reads_pandas(flow):
    import pandas
    path = flow.export("csv")
    profiles = pandas.read_csv(path, float_precision="round_trip")
    is_table(flow, lambda name: profiles[name].to_numpy(), "profiles")
    scalars = pandas.read_csv(path.with_stem(path.stem + "-scalars"), index_col="quantity", float_precision="round_trip")
    told = {**flow.summary, **flow.summary.get("energy_budget", {})}
    found = 0
    for name, row in scalars.iterrows():
        own = numpy.array([told[name]["mean"], told[name]["error"]], dtype=float)
        check(numpy.array_equal(row.to_numpy(dtype=float), own, equal_nan=True), f"{name}, to the last bit")
        found += 1
    check(found >= 5, f"{found} numbers")


def main():
    reader, gpf, work = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]).resolve()
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    for kind in KINDS:
        try:
            globals()["reads_" + reader](Flow(gpf, work, kind))
        except ImportError as missing:
            print("skipped:", missing)
            return 77
    print(f"{passed} passed, 0 failed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
