#!/bin/sh
# What a campaign survives: 10 times kill -9 of the program and of its workers, a stop, a run that fails, a change of plan.
# usage: campaign_test.sh GPF WORKDIR
set -eu
gpf=$1
work=$2
rm -rf "$work" && mkdir -p "$work" && cd "$work"
fail() { echo "FAILED: $1" >&2; exit 1; }
ok() { echo "ok - $1"; }

campaign() { # campaign LENGTHS REPLICAS
  cat << EOT
title = "A small campaign"
replicas = $2
[axes]
length_over_width = [$1]
wall_tangential_restitution = [0.9, 0.5, [0.1, 0.9], 0.1, 0.0]
[scene]
geometry = "channel"
area_fraction = 0.2
width_over_diameter = 12
normal_restitution = 0.9
[run]
start_up = 10
duration = 30
bins = 4
density_modes = 4
EOT
}
campaign "1, 1.5, 2, 3, 4" 8 > campaign.toml
hashes() { # name and trace hash of every record
  for record in "$1"/records/*.h5; do
    echo "${record##*/} $(h5dump -a /trace_hash "$record" | sed -n 's/.*(0): //p')"
  done
}

"$gpf" campaign plan campaign.toml -o whole | grep -q "25 point(s), 200 run(s), 200 missing" || fail "not 200 runs"
"$gpf" campaign run whole -j 2 2> whole.log || fail "the undisturbed campaign"
hashes whole > whole.hashes
[ "$(wc -l < whole.hashes)" -eq 200 ] || fail "not 200 records"
ok "200 runs undisturbed"

# Killed ten times, each time some milliseconds later; every second time one of its workers as well.
"$gpf" campaign plan campaign.toml -o killed > /dev/null
for n in 1 2 3 4 5 6 7 8 9 10; do
  setsid "$gpf" campaign run killed -j 2 --checkpoint-period 0.05 2> killed.log &
  pid=$!
  sleep "0.$((10 + n * 3))"
  [ $((n % 2)) -eq 0 ] || pkill -KILL -P "$pid" || true
  kill -KILL "$pid" || fail "it ended before it could be killed"
  set +e
  wait "$pid" 2> /dev/null
  got=$?
  set -e
  [ "$got" -eq 137 ] || fail "status $got of a campaign that was killed"
  find killed/records -name '*.h5' 2> /dev/null | sort > "done.$n"
  [ "$n" -eq 1 ] || [ -z "$(comm -23 "done.$((n - 1))" "done.$n")" ] || fail "a finished run was lost"
done
# Workers whose parent was killed write checkpoints and end: on a busy machine not at once.
for _ in $(seq 300); do
  pgrep -f "^$gpf campaign run killed -j 2 --checkpoint-period" > /dev/null || break
  sleep 0.2
done
left=$("$gpf" campaign missing killed | wc -l)
[ "$left" -gt 0 ] || fail "it was done before it was killed for the tenth time"
"$gpf" campaign run killed -j 2 2> last.log || { cat last.log >&2; fail "going on after ten kills"; }
[ -z "$("$gpf" campaign missing killed)" ] || fail "something is still missing"
hashes killed > killed.hashes
cmp whole.hashes killed.hashes || fail "other bits after ten kills"
[ -z "$(find killed/records -name '*.part' -o -name '*.checkpoint')" ] || fail "something half done was left behind"
ok "killed ten times ($left of 200 left then), the same bits"

# One entry at a time, as a job array does; stopped by a signal it says so with status 75.
"$gpf" campaign plan campaign.toml -o tasks > /dev/null
"$gpf" campaign run tasks --task 17 2> /dev/null || fail "--task"
[ "$("$gpf" campaign missing --array tasks)" = "0-16,18-199" ] || fail "the wrong task was done"
set +e
"$gpf" campaign run tasks -j 2 2> /dev/null &
pid=$!
sleep 0.2
kill -USR1 "$pid"
wait "$pid"
[ $? -eq 75 ] || fail "status of a stopped campaign"
"$gpf" campaign run tasks --task 200 2> err.txt
[ $? -eq 2 ] || fail "a task that does not exist was accepted"
set -e
grep -q "no entry 200" err.txt || fail "no reason for refusing a task"
ok "tasks one by one, and a stop"

# More points: only the new ones are run.
campaign "1, 1.5, 2, 3, 4, 5" 8 > campaign.toml
"$gpf" campaign plan campaign.toml -o whole | grep -q "30 point(s), 240 run(s), 40 missing" || fail "planning more points"
"$gpf" campaign run whole -j 2 2> more.log || fail "running more points"
grep -q "40 run(s) missing" more.log || fail "it ran more than the new points"
page=$("$gpf" campaign collect whole)
[ "$page" = whole/phase.md ] && [ -s whole/phase.svg ] || fail "no phase diagram"
[ "$(wc -l < whole/phase.csv)" -eq 31 ] || fail "a table of the wrong size"
[ "$(find whole/snapshots -name '*.svg' | wc -l)" -eq 30 ] || fail "not a snapshot at each point"
grep -q "plug" whole/phase.md || fail "no structures in the table"
ok "new points only, and their diagram"

# A run that fails leaves its reason.
mkdir -p broken
"$gpf" campaign plan campaign.toml -o broken > /dev/null
chmod 755 broken && mkdir -p broken/records
name=$(sed -n '4s/.*"record":"\([0-9a-f]*\)".*/\1/p' broken/manifest.jsonl)
mkdir "broken/records/$name.h5" # in the way of the record
set +e
"$gpf" campaign run broken --task 3 2> err.txt
[ $? -eq 4 ] || { cat err.txt >&2; fail "status of a campaign with a failed run"; }
set -e
"$gpf" campaign missing broken | grep -q "^3	.*failed: " || fail "the reason of a failure is not listed"
rmdir "broken/records/$name.h5"
"$gpf" campaign run broken --task 3 2> /dev/null || fail "a failed run is done again"
"$gpf" campaign missing broken | grep -q "^3	" && fail "a run that succeeded is listed as missing"
ok "failures are listed with their reason until they succeed"

# USR1 that comes before the program listens ends it; the batch script puts the task back into the queue all the same.
mkdir -p bin
printf '#!/bin/sh\necho "$*" > %s\n' "$PWD/requeued" > bin/scontrol
printf '#!/bin/sh\nkill -USR1 "$PPID"\nsleep 60\n' > bin/deaf
chmod 755 bin/scontrol bin/deaf
sed "s|^'.*' campaign run|'$PWD/bin/deaf' campaign run|" whole/job.slurm > deaf.slurm
set +e
PATH="$PWD/bin:$PATH" SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID=3 sh deaf.slurm
[ $? -eq 138 ] || fail "status of a task that was ended by USR1"
set -e
[ "$(cat requeued)" = "requeue 7_3" ] || fail "a task that was stopped at once was not requeued"
ok "a stop before the program listens"
