#!/bin/sh
# A campaign as a job array on a real Slurm of one node, started here for the purpose: a task that is told to stop and is
# requeued, one that is killed, a controller that is killed, a cancelled array of which only the rest is submitted again;
# the bits of the local pool in the end. Exit status 77: no Slurm can be started here, and why.
# usage: slurm_test.sh GPF WORKDIR
set -eu
gpf=$1
work=$2
fail() {
  echo "FAILED: $1" >&2
  squeue -r -o "%i %T %r" >&2 2> /dev/null || true
  tail -n 20 "$conf/slurmctld.log" "$conf/slurmd.log" "$work"/slurm-*.out >&2 2> /dev/null || true
  exit 1
}
skip() { echo "skipped: $1"; exit 77; }
ok() { echo "ok - $1"; }
for program in slurmctld slurmd munged sbatch; do
  command -v $program > /dev/null || skip "there is no $program"
done
[ "$(id -u)" -eq 0 ] || skip "slurmd starts jobs for others only as root"
rm -rf "$work" && mkdir -p "$work" && cd "$work"

# The node, its keys and sockets; short paths, for a socket's name has 107 characters at most.
conf=$(mktemp -d -t gpf-slurm.XXXXXX)
processes=""
finish() {
  # shellcheck disable=SC2086  # a list
  kill -KILL $processes 2> /dev/null || true
  pkill -KILL -f "$gpf campaign run $work" 2> /dev/null || true
  rm -rf "$conf"
}
trap finish EXIT
trap 'exit 1' INT TERM
port=$((20000 + $$ % 20000))
cat > "$conf/slurm.conf" << EOT
ClusterName=gpf
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$conf/munge.socket,cred_expire=10
CredType=cred/munge
SlurmUser=root
StateSaveLocation=$conf/state
SlurmdSpoolDir=$conf/spool
SlurmctldPidFile=$conf/slurmctld.pid
SlurmdPidFile=$conf/slurmd.pid
SlurmctldLogFile=$conf/slurmctld.log
SlurmdLogFile=$conf/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SwitchType=switch/none
MpiDefault=none
JobRequeue=1
ReturnToService=2
KillWait=5
SchedulerParameters=batch_sched_delay=1,sched_interval=1
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
EOT
mkdir "$conf/state" "$conf/spool"
head -c 1024 /dev/urandom > "$conf/munge.key" && chmod 400 "$conf/munge.key"
export SLURM_CONF="$conf/slurm.conf"
start() { "$@" > /dev/null 2>&1 & processes="$processes $!"; }
start munged --foreground --force --key-file="$conf/munge.key" --socket="$conf/munge.socket" \
  --pid-file="$conf/munged.pid" --log-file="$conf/munged.log" --seed-file="$conf/munged.seed"
until [ -S "$conf/munge.socket" ] || [ $((tries = ${tries:-0} + 1)) -gt 50 ]; do sleep 0.1; done
start_controller() { start slurmctld -D; controller=$!; }
start_controller
start slurmd -D
wait_for() { # wait_for SECONDS command...: 0 as soon as it succeeds
  tries=$(($1 * 5))
  shift
  until "$@"; do
    [ $((tries -= 1)) -gt 0 ] || return 1
    sleep 0.2
  done
}
idle() { sinfo -h -o %T 2> /dev/null | grep -q idle; }
wait_for 30 idle || { tail -n 5 "$conf"/*.log; skip "the node does not come up"; }

cat > campaign.toml << EOT
title = "On a cluster"
replicas = 4
[axes]
length_over_width = [1, 1.1]
[scene]
geometry = "channel"
area_fraction = 0.3
width_over_diameter = 31
normal_restitution = 0.9
wall_tangential_restitution = 0.6
[run]
start_up = 10
duration = 600
density_modes = 4
EOT
"$gpf" campaign plan campaign.toml -o local > /dev/null
"$gpf" campaign plan campaign.toml -o cluster > /dev/null

submit() { sbatch --parsable --array="$("$gpf" campaign missing --array cluster)" cluster/job.slurm; }
state() { squeue -h -r -j "$1" -o %T 2> /dev/null; }
# A controller that is killed before it wrote which tasks it had started starts them twice, which slurmd refuses, and the
# node is drained until someone says that it is well.
resume() { ! sinfo -h -o %T 2> /dev/null | grep -q drain || scontrol update "NodeName=$(hostname -s)" State=RESUME; }
running() { resume && [ "$(state "$1" | grep -c RUNNING)" -ge "$2" ]; }
ended() { resume && left_of_it=$(state "$1") && [ -z "$left_of_it" ]; } # not when the controller does not answer
job=$(submit)
wait_for 60 running "$job" 2 || fail "no task is running"
# The first task is told to stop, as before its time is up (the signal goes to the script): checkpoint, status 75,
# requeued. The second one is killed: it fails, and stays missing.
task() { pgrep -o -f "campaign run '?$work/cluster'? --task $1\$"; }
works() { [ -n "$(task 0)" ] && [ -n "$(task 1)" ]; }
wait_for 30 works || fail "there is no process of a running task"
kill -USR1 "$(ps -o ppid= -p "$(task 0)" | tr -d ' ')" || fail "there is no process of task 0"
kill -KILL "$(task 1)" || fail "there is no process of task 1"
requeued() { scontrol show job "${job}_0" | grep -q "Restarts=1"; }
wait_for 60 requeued || fail "a stopped task was not requeued"
ok "a task that is told to stop is requeued"
# The controller is killed and started again; what it knew of the requeued task is on disk by then.
touch "$conf/requeued"
saved() { [ "$conf/state/job_state" -nt "$conf/requeued" ]; }
wait_for 30 saved || fail "the controller does not save its state"
kill -KILL "$controller"
sleep 1
start_controller
wait_for 60 running "$job" 1 || fail "no task is running after the controller was killed"
ok "tasks go on when the controller was killed"
# What is left is cancelled, and only that is submitted again.
one_done() { [ "$("$gpf" campaign missing cluster | wc -l)" -lt 8 ]; }
wait_for 60 one_done || fail "no task gets done"
scancel "$job"
wait_for 30 ended "$job" || fail "the cancelled array does not end"
left=$("$gpf" campaign missing cluster | wc -l)
[ "$left" -gt 0 ] || fail "nothing was left to submit again"
job=$(submit)
wait_for 200 ended "$job" || fail "the second array does not end"
[ -z "$("$gpf" campaign missing cluster)" ] || fail "something is still missing"
ok "$left of 8 submitted again, and nothing is missing"

"$gpf" campaign run local -j 2 2> /dev/null || fail "the local pool"
hashes() {
  for record in "$1"/records/*.h5; do
    echo "${record##*/} $(h5dump -a /trace_hash "$record" | sed -n 's/.*(0): //p')"
  done
}
[ "$(hashes local)" = "$(hashes cluster)" ] || fail "other bits on the cluster than here"
ok "the same bits as here"
