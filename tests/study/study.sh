#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# study.sh <ogive> <folder>: a sweep of small shots that is stopped by a signal and resumes to the same state, processes
# that share a study, shots that fail. Works in the folder.
set -euo pipefail

ogive=$1
mkdir -p "$2"
cd "$2"
rm -rf ./*

fail() {
  echo "study.sh: $*" >&2
  exit 1
}

# sweep <folder> <argument>...: four shots that write frames, so that they take some seconds
sweep=("$ogive" sweep --spacing-mm 2 --sph-radius-mm 15 --clamp-radius-mm 30 --thickness-mm 4 --projectile rigid --end-us 40
  --output-every-us 0.5 --vary velocity_mps=200:350:50)
sweep() { "${sweep[@]}" --out "$@"; }

# start <folder> <argument>...: the same in the background, as a terminal would start it
start() {
  env --default-signal=INT "${sweep[@]}" --out "$@" > "$1.out" 2> "$1.err" &
  child=$!
}

# ends_with <status> <folder>
ends_with() {
  local status=0
  wait "$child" || status=$?
  [ "$status" -eq "$1" ] || fail "$2: status $status instead of $1: $(cat "$2.out" "$2.err")"
}

# wait_for <file>: until it is there
wait_for() {
  until [ -e "$1" ]; do
    kill -0 "$child" 2> /dev/null || fail "the study ended before $1: $(cat ./*.err)"
    sleep 0.01
  done
}

# rows <folder>: without what a run costs
rows() {
  awk -F, -v OFS=, 'NR == 1 { for (k = 1; k <= NF; ++k) cost[k] = $k ~ /^(wall_s|cpu_s|threads)$/ }
    $1 != "method" { for (k = 1; k <= NF; ++k) if (cost[k]) $k = ""; print }' "$1"/shots*.csv | sort
}

# shot <velocity>: name of its folder
shot() { echo "stabilised_mjc_weldox_460e_blunt_4mm_$1mps_2mm"; }

sweep whole --jobs 2 > whole.out 2> whole.err || fail "status $?: $(cat whole.err)"
[ "$(rows whole | wc -l)" -eq 4 ] || fail "rows: $(rows whole)"
[ ! -s whole.err ] || fail "on standard error: $(cat whole.err)"
grep -qx '4 shots run, 0 failed' whole.out || fail "$(cat whole.out)"

# Stopped while two shots run, then resumed from their checkpoints: the frames of before are not written again.
for signal in INT TERM HUP; do
  number=$(kill -l "$signal")
  start stopped --jobs 2
  wait_for "stopped/shots/$(shot 200)/frames/perforation_disc_0003.vtu"
  wait_for "stopped/shots/$(shot 250)/frames/perforation_disc_0003.vtu"
  kill "-$signal" "$child"
  ends_with $((128 + number)) stopped
  [ "$(cat stopped.err)" = "ogive sweep: stopped by SIG$signal; the same command resumes" ] || fail "$(cat stopped.err)"
  [ ! -e stopped/shots.csv ] || fail "a row of a shot that was stopped: $(cat stopped/shots.csv)"
  [ ! -e "stopped/shots/$(shot 300)" ] || fail "a shot began after the signal"
  for velocity in 200 250; do
    touch -d '2001-01-01' "stopped/shots/$(shot "$velocity")"/frames/*.vtu
  done
  sweep stopped --jobs 1 > stopped.out 2> stopped.err || fail "resumed: status $?: $(cat stopped.err)"
  for velocity in 200 250; do
    [ ! "stopped/shots/$(shot "$velocity")/frames/perforation_disc_0003.vtu" -nt whole.out ] || fail "$velocity m/s began anew"
  done
  diff <(rows whole) <(rows stopped) || fail "$signal: other rows"
  rm -r stopped
done

# A killed study has lost what its last checkpoints lack, no more.
start killed --jobs 2 --checkpoint-every-us 2
wait_for "killed/shots/$(shot 200)/checkpoint.bin"
kill -KILL "$child"
ends_with 137 killed
sweep killed --checkpoint-every-us 2 > killed.out 2> killed.err || fail "killed: status $?: $(cat killed.err)"
diff <(rows whole) <(rows killed) || fail "killed: other rows"

# Another process waits for neither a study nor its own shard, but may have another one.
start shared --shard 1/2 --jobs 1
wait_for "shared/shots/$(shot 200)"
for other in "" "--shard 1/2" "--shard 2/3"; do
  status=0
  # shellcheck disable=SC2086 # two words
  sweep shared $other > other.out 2> other.err || status=$?
  [ "$status" -eq 2 ] || fail "two processes ($other): status $status: $(cat other.out other.err)"
  grep -q '^ogive sweep: error: --out = shared: another process works on this study' other.err || fail "$(cat other.err)"
  [ "$(wc -l < other.err)" -eq 1 ] || fail "not one line: $(cat other.err)"
done
sweep shared --shard 2/2 > other.out 2> other.err || fail "another shard: status $?: $(cat other.err)"
ends_with 0 shared
[ ! -e shared/sweep.svg ] || fail "a shard drew"
diff <(rows whole) <(rows shared) || fail "shards: other rows"
sweep shared > merged.out || fail "merged: status $?"
grep -qx '0 shots run, 4 known before, 0 failed' merged.out || fail "merged: $(cat merged.out)"
sweep shared --no-run > drawn.out || fail "--no-run: status $?"
diff <(sed '1,/^0 shots run,/d' merged.out) drawn.out || fail "--no-run prints another table"

# A shot that fails does not stop the others.
mkdir -p failing/shots
echo "a file where a folder must be" > "failing/shots/$(shot 250)"
status=0
sweep failing > failing.out 2> failing.err || status=$?
[ "$status" -eq 3 ] || fail "a shot failed: status $status: $(cat failing.err)"
[ "$(wc -l < failing.err)" -eq 1 ] || fail "a shot failed: not one line: $(cat failing.err)"
grep -q "^ogive sweep: failed: $(shot 250): --out = failing/shots/$(shot 250): must be a folder" failing.err ||
  fail "a shot failed: $(cat failing.err)"
grep -qx '3 shots run, 1 failed' failing.out || fail "a shot failed: $(cat failing.out)"
rm "failing/shots/$(shot 250)"
sweep failing > failing.out || fail "tried again: status $?"
diff <(rows whole) <(rows failing) || fail "tried again: other rows"

# Another case in the folder; and a study with other columns.
status=0
sweep whole --friction 0.3 > other.out 2> other.err || status=$?
[ "$status" -eq 3 ] || fail "another case: status $status: $(cat other.err)"
[ "$(grep -c 'are of a case with another friction; give another --out or remove them$' other.err)" -eq 4 ] ||
  fail "another case: $(cat other.err)"
status=0
sweep whole --vary friction=0,0.1 > other.out 2> other.err || status=$?
[ "$status" -eq 2 ] || fail "other columns: status $status: $(cat other.err)"
grep -q '^ogive sweep: error: whole/shots.csv:1: ' other.err || fail "other columns: $(cat other.err)"
