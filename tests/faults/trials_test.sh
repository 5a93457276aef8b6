#!/bin/sh
# What `gpf faults` survives: signals and kill -9 while runs with a fault in them are made; then it gives the same
# answers, from the runs that were done too.
# usage: trials_test.sh GPF WORKDIR REFERENCE
set -eu
gpf=$1 work=$2 reference=$3
rm -rf "$work" && mkdir -p "$work" && cd "$work"
fail() { echo "FAILED: $1" >&2; exit 1; }
try() { "$gpf" faults "walls exchanged" --claim algo.walls --store "$1" --reference "$reference" -j 2; }

try whole > whole.txt 2> err.txt || { cat err.txt >&2; fail "an undisturbed trial"; }
grep -q "algo.walls *caught" whole.txt || { cat whole.txt >&2; fail "exchanged walls are not caught"; }
runs=$(grep -c " done" err.txt) || fail "it made no runs"
echo "ok - an undisturbed trial of $runs runs"

stopped=0
for signal in TERM INT KILL; do  # each when one more run is done
  : > err.txt  # the trial empties it too, but perhaps after it has been looked at
  "$gpf" faults "walls exchanged" --claim algo.walls --store cut --reference "$reference" -j 2 \
    > cut.txt 2> err.txt &
  pid=$!
  for _ in $(seq 600); do
    if grep -q " done" err.txt || ! kill -0 "$pid" 2> /dev/null; then break; fi
    sleep 0.1
  done
  kill -s "$signal" "$pid" 2> /dev/null || true
  set +e
  wait "$pid"
  got=$?
  set -e
  case $got in
    75 | 137) stopped=$((stopped + 1)) ;;
    0) ;; # it was faster than the signal
    *) cat err.txt >&2; fail "SIG$signal: exit status $got" ;;
  esac
  [ "$got" -eq 0 ] || [ ! -s cut.txt ] || fail "SIG$signal: an answer of a trial that was stopped"
done
[ "$stopped" -gt 0 ] || fail "no trial was stopped: it is too short for this test"
try cut > cut.txt 2> err.txt || { cat err.txt >&2; fail "a trial does not go on after signals"; }
cmp whole.txt cut.txt || fail "other answers after signals"
again=$(grep -c " done" err.txt || true)
[ "$again" -le $((runs - stopped)) ] || fail "it made $again runs again"
[ -z "$(find cut -name '*.part' -o -name '*.checkpoint')" ] || fail "something was left over"
echo "ok - the same answers after $stopped interruptions, the last $again of $runs runs after them"
