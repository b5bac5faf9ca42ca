#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# slurm.sh <ogive> <folder>: a Slurm cluster of this host alone, in the folder, runs a sweep as an array job of four
# shards. One task is killed and submitted again, one is requeued while it runs. The merged rows are those of one run
# without shards. Needs munged, slurmctld, slurmd and the commands of Slurm (Debian: slurm-wlm, munge); uses no file and
# no daemon of an installed cluster.
set -euo pipefail

PATH=$PATH:/usr/sbin
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
ogive=$(realpath "$1")
mkdir -p "$2"
cd "$2"
rm -rf ./*
folder=$PWD
node=$(hostname -s)

fail() {
  echo "slurm.sh: $*" >&2
  tail -q -n 20 ./*.log ./*.out ./*.txt >&2 || true
  exit 1
}

daemons=()
stop_daemons() {
  local k
  # Backwards: slurmd and slurmctld sign what they say with munged.
  for ((k = ${#daemons[@]} - 1; k >= 0; --k)); do
    kill "${daemons[k]}" 2> /dev/null || true
    wait "${daemons[k]}" || true
  done
}
trap stop_daemons EXIT

# wait_until <what for> <command>...
wait_until() {
  local k daemon
  for ((k = 0; k < 1200; ++k)); do
    if "${@:2}"; then return; fi
    for daemon in "${daemons[@]}"; do
      kill -0 "$daemon" 2> /dev/null || fail "a daemon has ended before $1"
    done
    sleep 0.1
  done
  fail "waited in vain until $1"
}

# free_port: one that nobody listens on
free_port() {
  local port
  for ((port = 20000 + RANDOM % 20000; ; ++port)); do
    if ! (: < "/dev/tcp/127.0.0.1/$port") 2> /dev/null; then
      echo "$port"
      return
    fi
  done
}

# Sockets have short names.
sockets=$(mktemp -d)
trap 'stop_daemons; rm -rf "$sockets"' EXIT
chmod 755 "$sockets"
mkdir state spool
dd if=/dev/urandom of=munge.key bs=1 count=1024 status=none
chmod 400 munge.key
munged --foreground --force --key-file="$folder/munge.key" --socket="$sockets/munge" --pid-file="$folder/munge.pid" \
  --log-file="$folder/munge.log" --seed-file="$folder/munge.seed" > munged.log 2>&1 &
daemons+=($!)
wait_until "munged listens" test -S "$sockets/munge"

cat > slurm.conf << END
ClusterName=ogive
SlurmctldHost=$node(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
# A requeued job waits until its credential has expired.
AuthInfo=socket=$sockets/munge,cred_expire=5
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
# Nothing here needs cgroups. Before Slurm 23.02 they cannot be switched off, but those of version 1 need not be there.
cgroups=disabled
case $(slurmd -V) in *" 2"[0-2].*) cgroups=cgroup/v1 ;; esac
echo "CgroupPlugin=$cgroups" > cgroup.conf
export SLURM_CONF=$folder/slurm.conf
slurmctld -D > slurmctld.out 2>&1 &
daemons+=($!)
slurmd -D > slurmd.out 2>&1 &
daemons+=($!)
is_idle() { [ "$(sinfo --noheader --format=%T 2> /dev/null)" = idle ]; }
wait_until "the node is idle" is_idle

# Eight shots, two for each task. A checkpoint every 2 us: what was killed has one.
sweep=("$ogive" sweep --spacing-mm 2 --sph-radius-mm 15 --clamp-radius-mm 30 --thickness-mm 4 --projectile rigid
  --checkpoint-every-us 2 --vary velocity_mps=200:270:10)
"${sweep[@]}" --out whole > whole.out || fail "without shards: status $?"

# rows <folder>: without what a run costs
rows() {
  awk -F, -v OFS=, 'NR == 1 { for (k = 1; k <= NF; ++k) cost[k] = $k ~ /^(wall_s|cpu_s|threads)$/ }
    $1 != "method" { for (k = 1; k <= NF; ++k) if (cost[k]) $k = ""; print }' "$1"/shots*.csv | sort
}

# is_under_way <shot>: it has a checkpoint and no result
is_under_way() {
  [ -e "parts/shots/stabilised_mjc_weldox_460e_blunt_4mm_$1mps_2mm/checkpoint.bin" ] || return 1
  [ ! -e "parts/shots/stabilised_mjc_weldox_460e_blunt_4mm_$1mps_2mm/summary.json" ] || fail "the shot at $1 m/s has ended too early"
}

# has_ended <task>: Slurm has no such job any more, or one that has ended
has_ended() { [ -z "$(squeue --noheader --states=PENDING,RUNNING,COMPLETING,CONFIGURING --jobs "$1" 2> /dev/null)" ]; }

# Task 2 has the shots at 210 and 250 m/s, task 3 those at 220 and 260 m/s.
job=$(sbatch --parsable "$here/study.slurm" "${sweep[@]}" --out parts)
wait_until "task 2 has a checkpoint" is_under_way 210
scancel --signal=KILL --batch "${job}_2"
wait_until "task 3 has a checkpoint" is_under_way 220
scontrol requeue "${job}_3"
wait_until "task 3 has stopped" grep -q 'stopped by SIGTERM; the same command resumes' "slurm-${job}_3.txt"
wait_until "the job has ended" has_ended "$job"
[ "$(rows parts | wc -l)" -eq 6 ] || fail "rows of three tasks: $(rows parts)"
[ ! -e parts/shots.2-of-4.csv ] || fail "task 2 was not killed"
again=$(sbatch --parsable --array=2 "$here/study.slurm" "${sweep[@]}" --out parts)
wait_until "task 2 has ended" has_ended "$again"

diff <(rows whole) <(rows parts) || fail "other rows"
for task in "${job}_1" "${again}_2" "${job}_3" "${job}_4"; do
  grep -qx '2 shots run, 0 failed' "slurm-$task.txt" || fail "task $task: $(cat "slurm-$task.txt")"
done

# Without shards nothing is left to run.
"${sweep[@]}" --out parts > merged.out || fail "merged: status $?"
grep -qx '0 shots run, 8 known before, 0 failed' merged.out || fail "merged: $(cat merged.out)"
diff <(sed -n 's/^  \([0-9]\)/\1/p' whole.out) <(sed -n 's/^  \([0-9]\)/\1/p' merged.out) || fail "another table"
echo "four tasks, one killed, one requeued: the same 8 rows as without shards"
