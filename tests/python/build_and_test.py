"""Builds the Python module from the source, installs it, and runs module_test.py and the example with it.

usage: build_and_test.py GPF SOURCE WORKDIR CXX CC GENERATOR; exit status 77 without pybind11 or numpy."""
import glob
import os
import pathlib
import subprocess
import sys

try:
    import numpy  # noqa: F401
except ImportError as missing:
    print("skipped:", missing)
    sys.exit(77)


def call(*command, **more):
    print("+", *command, flush=True)
    return subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          **more)


def must(*command, **more):
    done = call(*command, **more)
    if done.returncode != 0:
        sys.exit(f"FAILED: exit status {done.returncode}\n{done.stdout}")
    return done.stdout


def main():
    gpf, source, work, cxx, cc, generator = sys.argv[1:]
    source, work = pathlib.Path(source), pathlib.Path(work)
    tree, prefix = work / "tree", work / "prefix"
    configured = call("cmake", "-S", source, "-B", tree, "-G", generator, f"-DCMAKE_CXX_COMPILER={cxx}",
                      f"-DCMAKE_C_COMPILER={cc}", "-DCMAKE_BUILD_TYPE=Release", "-DGPF_NATIVE=ON", "-DGPF_PYTHON=ON",
                      "-DGPF_BUILD_PROGRAM=OFF", "-DGPF_BUILD_TESTS=OFF", f"-DPython_EXECUTABLE={sys.executable}")
    if configured.returncode != 0:
        if "provided by \"pybind11\"" in configured.stdout or "Could NOT find Python" in configured.stdout:
            print("skipped: no pybind11, or no headers of Python")
            return 77
        sys.exit("FAILED: configuring\n" + configured.stdout)
    must("cmake", "--build", tree, "--target", "gpf_python", "--parallel", "2")
    must("cmake", "--install", tree, "--prefix", prefix, "--component", "python")
    folder = f"{prefix}/lib/python{sys.version_info.major}.{sys.version_info.minor}/site-packages"
    if not glob.glob(f"{folder}/gpf*.so"):
        sys.exit(f"FAILED: no module in {folder}")
    python = {**os.environ, "PYTHONPATH": folder, "MPLBACKEND": "agg", "MPLCONFIGDIR": str(work)}
    print(must(sys.executable, "-B", source / "tests/python/module_test.py", gpf, source, cwd=work, env=python))
    picture = work / "flow.png"
    picture.unlink(missing_ok=True)
    shown = must(sys.executable, "-B", source / "verify/python/example.py", cwd=work, env=python)
    if not (picture.exists() and picture.stat().st_size > 5000 or shown.count("\n") == 18):
        sys.exit(f"FAILED: the example draws nothing and prints\n{shown}")
    print("ok - the example draws" if picture.exists() else "ok - the example prints")
    return 0


if __name__ == "__main__":
    sys.exit(main())
