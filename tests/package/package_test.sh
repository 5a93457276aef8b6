#!/bin/sh
# The Debian packages of a finished build: made, unpacked into a folder, and used from there alone.
# usage: package_test.sh BUILD SOURCE CPACK WORKDIR
set -eu
build=$1 source=$2 cpack=$3 work=$4
for tool in dpkg-deb dpkg-shlibdeps readelf ldd; do
  command -v "$tool" > /dev/null || { echo "no $tool: skipped"; exit 77; }
done
rm -rf "$work" && mkdir -p "$work/elsewhere" && cd "$work"
fail() { echo "FAILED: $1" >&2; exit 1; }
ok() { echo "ok - $1"; }

# Compressed as fast as may be.
"$cpack" --config "$build/CPackConfig.cmake" -B packages -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip > cpack.log 2>&1 || { cat cpack.log >&2; fail "cpack"; }
program=$(echo packages/gpf_*.deb) development=$(echo packages/libgpf-dev_*.deb)
dpkg-deb -x "$program" program
dpkg-deb -x "$development" development
ok "two packages: $(du -sk "$program" | cut -f 1) kB and $(du -sk "$development" | cut -f 1) kB"

# Every library that the program names belongs to a package that the package depends on.
depends=$(dpkg-deb -f "$program" Depends | tr ',|' '\n\n' | sed 's/^ *//; s/[ :].*//')
ldd program/usr/bin/gpf > libraries
for library in $(readelf -d program/usr/bin/gpf | sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p'); do
  case $library in
    libgpf_simulate.so)  # the package's own, for the best level of this processor
      best=$("$(readelf -l program/usr/bin/gpf | sed -n 's/.*interpreter: \(.*\)]/\1/p')" --help |
        sed -n 's,^ *\(x86-64-v[34]\) (supported.*,glibc-hwcaps/\1/,p' | head -n 1)
      awk -v name="$library" '$1 == name { print $3 }' libraries | grep -q "^$work/program/usr/.*/gpf/$best$library\$" ||
        fail "not the package's own $best$library: $(grep "$library" libraries)"
      continue ;;
  esac
  # Its last folder and its name: /lib and /usr/lib may be one.
  path=$(awk -v name="$library" '$1 == name { print $3 }' libraries | sed 's,.*\(/[^/]*/[^/]*\)$,\1,')
  owner=$(dpkg-query -S "*$path" | head -n 1 | sed 's/:.*//')
  printf '%s\n' "$depends" | grep -qx "$owner" || fail "$library is of $owner, which is not among: $depends"
done
printf '%s\n' "$depends" | grep -q "^libhdf5" || fail "no HDF5 among: $depends"
ok "the packages it depends on"
for wanted in libhdf5-dev libfmt-dev libgsl-dev libfftw3-dev nlohmann-json3-dev; do
  dpkg-deb -f "$development" Depends | grep -q "$wanted" || fail "libgpf-dev does not depend on $wanted"
done

for file in usr/bin/gpf usr/share/doc/gpf/copyright usr/share/doc/gpf/changelog.gz usr/share/man/man1/gpf.1.gz \
  usr/share/man/man1/gpf-validate.1.gz usr/share/bash-completion/completions/gpf \
  usr/share/fish/vendor_completions.d/gpf.fish usr/share/zsh/vendor-completions/_gpf usr/share/gpf/reference/errata.toml; do
  [ -s "program/$file" ] || fail "no $file"
done
for package in program development; do
  dpkg-deb -c "$(eval echo "\$$package")" | awk '$2 != "root/root" || $1 !~ /^(drwxr-xr-x|-rwxr-xr-x|-rw-r--r--)$/' > wrong
  [ ! -s wrong ] || fail "owners or permissions: $(cat wrong)"
  ! grep -rlF -e "$source" -e "$build" "$package" > wrong || fail "these name the folder of the build: $(cat wrong)"
done
case $(dpkg-deb -f "$program" Version) in
  *+native) grep -q 'GPF_NATIVE:BOOL=ON' "$build/CMakeCache.txt" || fail "called native and is not" ;;
  *) ! grep -q 'GPF_NATIVE:BOOL=ON' "$build/CMakeCache.txt" || fail "for this machine's CPU and does not say so" ;;
esac
ok "files, owners, no trace of the build's folders"

# An empty folder and an empty environment: what it reads is what was unpacked.
gpf() { (cd elsewhere && env -i PATH=/usr/bin:/bin HOME="$work/elsewhere" "$work/program/usr/bin/gpf" "$@"); }
gpf --version > version.txt
version=$(dpkg-deb -f "$program" Version | sed 's/+native//')
[ "$(head -n 1 version.txt)" = "gpf $version" ] || fail "--version says $(head -n 1 version.txt)"
for fact in commit 'physics version' compiler flags HDF5 GSL FFTW3 fmt Eigen3 nlohmann_json CLI11; do
  grep -q "^$fact: ." version.txt || fail "--version does not say $fact"
done
[ "$(gpf --version --json | python3 -c 'import json, sys; print(json.load(sys.stdin)["version"])')" = "$version" ] ||
  fail "--version --json"
ok "--version"
printf '%s\n' '[scene]' 'geometry = "channel"' 'particles = 100' 'area_fraction = 0.3' 'width_over_diameter = 10' \
  'normal_restitution = 0.9' 'wall_tangential_restitution = 0.9' 'seed = 1' '[run]' 'start_up = 1' 'duration = 2' \
  > elsewhere/scene.toml
gpf run scene.toml -o out.h5 --json > run.json
grep -q '"trace_hash"' run.json || fail "a run printed $(cat run.json)"
gpf explain algo.walls > explain.txt
gpf validate algo.walls > validate.txt 2>&1 || { cat validate.txt >&2; fail "gpf validate algo.walls: exit status $?"; }
grep -q 'algo.walls.*pass' validate.txt || { cat validate.txt >&2; fail "no verdict"; }
ok "a run, and a claim judged with the installed references"
