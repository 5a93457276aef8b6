#!/bin/sh
# What `gpf run` survives: signals, kill -9, a second process, refused input, a limit on file size.
# usage: run_test.sh GPF WORKDIR
set -eu
gpf=$1
work=$2
rm -rf "$work" && mkdir -p "$work" && cd "$work"
passed=0
fail() { echo "FAILED: $1" >&2; exit 1; }
ok() { passed=$((passed + 1)); echo "ok $passed - $1"; }
expect() { # expect STATUS description command...
  want=$1 what=$2
  shift 2
  set +e
  "$@" > out.txt 2> err.txt
  got=$?
  set -e
  [ "$got" -eq "$want" ] || { cat out.txt err.txt >&2; fail "$what: exit status $got, not $want"; }
  ok "$what"
}
field() { sed -n "s/.*\"$1\":\"\{0,1\}\([^,\"}]*\).*/\1/p" "$2"; }

cat > scene.toml << 'EOT'
[scene]
geometry = "channel"
particles = 300
area_fraction = 0.3
width_over_diameter = 31
normal_restitution = 0.9
wall_tangential_restitution = [0.9, 0.1]
seed = 5
[run]
start_up = 10
duration = 30
detail = "correlations"
density_modes = 3
sample_interval = 0.0625
snapshots = [0.5, 12, 24.1, 40]
EOT
arrays() { h5dump -g /arrays -g /snapshots "$1" | tail -n +2; }

expect 0 "an undisturbed run" "$gpf" run scene.toml -o whole.h5 --json
cp out.txt whole.json
[ "$(wc -l < whole.json)" -eq 1 ] || fail "--json printed more than one line"
[ ! -s err.txt ] || fail "something was written to a pipe besides the JSON"
for key in collisions collisions_per_second wall_seconds time trace_hash y mean_velocity area_fraction \
  granular_temperature pressure_xx pressure_yy pressure_xy kurtosis_x kurtosis_y mean_flow slip_velocity knudsen_number \
  density_power_even energy_budget; do
  grep -q "\"$key\":" whole.json || fail "--json lacks $key"
done
ok "--json has every key"
hash=$(field trace_hash whole.json)
h5dump -d /snapshots/time whole.h5 | grep -q "(0): 0.5, 12, 24.125, 40" || fail "no snapshots at the samples nearest to their times"
[ ${#hash} -eq 16 ] || fail "no trace hash"

# Stopped by each signal in turn, resumed each time.
for signal in TERM INT USR1; do
  "$gpf" run scene.toml -o stopped.h5 --resume --json > out.txt 2> err.txt &
  pid=$!
  sleep 0.15
  kill -s "$signal" "$pid" 2> /dev/null || true
  set +e
  wait "$pid"
  got=$?
  set -e
  case $got in
    75) [ -f stopped.h5.checkpoint ] || fail "no checkpoint after SIG$signal" ;;
    0) ;; # it was faster than the signal
    *) cat err.txt >&2; fail "SIG$signal: exit status $got" ;;
  esac
done
expect 0 "a run stopped by signals goes on to its end" "$gpf" run scene.toml -o stopped.h5 --resume --json
[ "$(field trace_hash out.txt)" = "$hash" ] || fail "another hash after signals"
for key in mean_velocity pressure_xy density_power_odd energy_budget; do
  a=$(sed "s/.*\"$key\"://;s/}.*//" whole.json) b=$(sed "s/.*\"$key\"://;s/}.*//" out.txt)
  [ "$a" = "$b" ] || fail "another $key after signals"
done
arrays whole.h5 > whole.arrays
arrays stopped.h5 | cmp -s whole.arrays - || fail "other distributions or correlations after signals"
ok "the same hash and the same measurements"
[ ! -e stopped.h5.checkpoint ] || fail "the checkpoint was left behind"

# Killed at moments spread over the run.
for k in 1 2 3 4 5 6 7 8 9 10; do
  "$gpf" run scene.toml -o killed.h5 --resume --checkpoint-period 0 > out.txt 2> err.txt &
  pid=$!
  sleep "0.0$((k * 3 % 10))"
  kill -9 "$pid" 2> /dev/null || true
  wait "$pid" 2> /dev/null || true
  [ ! -e killed.h5 ] || "$gpf" run scene.toml -o killed.h5 --resume > /dev/null || fail "a half record under its final name"
done
expect 0 "a run killed ten times goes on to its end" "$gpf" run scene.toml -o killed.h5 --resume --json
[ "$(field trace_hash out.txt)" = "$hash" ] || fail "another hash after kill -9"
arrays killed.h5 | cmp -s whole.arrays - || fail "other distributions or correlations after kill -9"
ok "the same hash after kill -9"

expect 2 "an existing record is not overwritten" "$gpf" run scene.toml -o whole.h5
expect 0 "--resume of a finished run prints its record" "$gpf" run scene.toml -o whole.h5 --resume --json
[ "$(field trace_hash out.txt)" = "$hash" ] || fail "another hash from the record"
sed 's/seed = 5/seed = 6/' scene.toml > other.toml
expect 2 "--resume with another scene is refused" "$gpf" run other.toml -o whole.h5 --resume
expect 0 "--force replaces a record" "$gpf" run other.toml -o whole.h5 --force
head -c 3000 killed.h5 > half.h5
expect 2 "a truncated record is refused" "$gpf" run scene.toml -o half.h5 --resume

sed 's/seed = 5/sede = 5/' scene.toml > typo.toml
expect 2 "an unknown key is refused" "$gpf" run typo.toml -o typo.h5
grep -q "typo.toml:8" err.txt || fail "no file and line"
grep -q "seed" err.txt || fail "the nearest key is not named"
[ ! -e typo.h5 ] || fail "a record was written for refused input"
expect 2 "no sub-command is refused" "$gpf"
expect 4 "a missing folder is a storage error" "$gpf" run scene.toml -o missing/x.h5
expect 4 "a missing scene is a storage error" "$gpf" run missing.toml -o x.h5
(ulimit -f 8 && trap '' XFSZ && expect 4 "a file-size limit is a storage error" "$gpf" run scene.toml -o full.h5) || fail "file-size limit"
[ ! -e full.h5 ] || fail "a half record under its final name"

sed 's/duration = 30/duration = 3000/' scene.toml > long.toml
"$gpf" run long.toml -o long.h5 > /dev/null 2>&1 &
pid=$!
sleep 0.3
expect 4 "a second process on the same record is refused" "$gpf" run long.toml -o long.h5
kill -9 "$pid"
wait "$pid" 2> /dev/null || true
echo "$passed checks passed"
