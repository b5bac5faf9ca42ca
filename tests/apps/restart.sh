#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# restart.sh <ogive> <folder>: interrupts, kills and fills the disk of small shots, lets them go on and compares them
# with one that nothing stopped: the state to its last bit, all files, the summary but for times. Works in the folder.
set -euo pipefail

ogive=$1
mkdir -p "$2"
cd "$2"
rm -rf ./*

# A frame every half microsecond makes the run long enough to be caught. --threads changes with each part.
shot=(--spacing-mm 2 --sph-radius-mm 16 --thickness-mm 8 --nose conical --velocity-mps 500 --damage jc --failure removal
  --smoothing variable --end-us 30 --output-every-us 0.5 --no-picture --quiet)

fail() {
  echo "restart.sh: $*" >&2
  exit 1
}

# start <folder> <argument>...: the program in the background, as a terminal would start it
start() {
  env --default-signal=INT "$ogive" shoot "${@:2}" > "${1##*/}.out" 2> "${1##*/}.err" &
  child=$!
}

# wait_for_rows <folder> <number>: until history.csv has them; false if the run ends before
wait_for_rows() {
  while [ "$(wc -l 2> /dev/null < "$1/history.csv" || echo 0)" -le "$2" ]; do
    kill -0 "$child" 2> /dev/null || return 1
    sleep 0.01
  done
}

# stop_with <signal> <status> <folder>
stop_with() {
  kill "-$1" "$child" || fail "the run in $3 ended too early: $(cat "$3.err")"
  local status=0
  wait "$child" || status=$?
  [ "$status" -eq "$2" ] || fail "$3: status $status instead of $2: $(cat "$3.err")"
}

# require_readable <folder>: whole rows, and a list of frames that are there
require_readable() {
  awk -F, 'NR == 1 { n = NF } NF != n || $0 == "" { exit 1 }' "$1/history.csv" || fail "$1/history.csv has a broken row"
  [ -z "$(tail -c 1 "$1/history.csv")" ] || fail "$1/history.csv ends within a row"
  grep -q '</VTKFile>' "$1/perforation.pvd" || fail "$1/perforation.pvd is not whole"
  local file
  for file in $(sed -n 's/.*file="\([^"]*\)".*/\1/p' "$1/perforation.pvd"); do
    tail -c 12 "$1/$file" | grep -q '</VTKFile>' || fail "$1/$file is not whole"
  done
}

# results <folder>: the summary without times and the machine's numbers
results() {
  sed -e '/"phase_s": {/,/}/d' -e '/"\(wall\|cpu\)_s"/d' -e '/"threads"/d' -e '/"ns_per_particle_step"/d' -e '/"peak_memory/d' \
    "$1/summary.json"
}

# require_same <folder>: as the run that nothing stopped
require_same() {
  diff <(results whole) <(results "$1") >&2 || fail "$1: another summary"
  local file
  for file in history.csv perforation.pvd material.toml $(cd whole && echo frames/*); do
    cmp "whole/$file" "$1/$file" >&2 || fail "$1: another $file"
  done
  [ "$(ls whole/frames)" = "$(ls "$1/frames")" ] || fail "$1: other frames"
  [ -z "$(find "$1" -name '*.part')" ] || fail "$1: half a file is left"
}

"$ogive" shoot "${shot[@]}" --threads 2 --out whole > whole.out
rows=$(wc -l < whole/history.csv)
[ "$rows" -gt 50 ] || fail "the shot is too short: $rows rows"
[ -e whole/checkpoint.bin ] || fail "no checkpoint of a shot that is undecided"

echo "SIGINT and SIGTERM: a checkpoint, a last frame, the command that goes on"
for signal in INT TERM; do
  out=by_$signal
  start "$out" "${shot[@]}" --threads 1 --out "$out"
  wait_for_rows "$out" 12 || true
  stop_with "$signal" "$([ "$signal" = INT ] && echo 130 || echo 143)" "$out"
  require_readable "$out"
  [ ! -e "$out/summary.json" ] || fail "$out: a summary of a run that has not ended"
  grep -q "^ogive shoot: interrupted by SIG$signal at " "$out.err" || fail "$out: $(cat "$out.err")"
  command=$(sed -n 's/^  //p' "$out.err")
  [ "$command" = "$(realpath "$ogive") shoot --restart $out/checkpoint.bin" ] ||
    fail "$out: no command: $(cat "$out.err")"
  # The last frame is one more than those of the regular times. Times in the series have eight digits.
  last=$(sed -n 's/.*timestep="\([^"]*\)".*/\1/p' "$out/perforation.pvd" | tail -n 1)
  awk -v last="$last" -F, 'END { exit !($1 <= last + 1e-5) }' "$out/history.csv" || fail "$out: no last frame"
  eval "$command" --threads 3 > "$out.out" 2>&1 || fail "$out: $(cat "$out.out")"
  require_same "$out"
done

echo "SIGINT again while it goes on, and in another folder"
start by_INT2 "${shot[@]}" --threads 2 --out by_INT2
wait_for_rows by_INT2 8 || true
stop_with INT 130 by_INT2
start by_INT2 --restart by_INT2/checkpoint.bin --threads 1
wait_for_rows by_INT2 25 || true
stop_with INT 130 by_INT2
mkdir elsewhere
cp by_INT2/checkpoint.bin elsewhere/
(cd elsewhere && "$ogive" shoot --restart checkpoint.bin --threads 4 --no-vtk > ../elsewhere.out)
cmp whole/history.csv elsewhere/history.csv || fail "elsewhere: another history"
diff <(results whole) <(results elsewhere) >&2 || fail "elsewhere: another summary"
"$ogive" shoot --restart by_INT2/checkpoint.bin --out new_folder > new_folder.out
cmp whole/history.csv new_folder/history.csv || fail "new_folder: another history"
diff <(results whole) <(results new_folder) >&2 || fail "new_folder: another summary"
"$ogive" shoot --restart by_INT2/checkpoint.bin > by_INT2.out
require_same by_INT2

echo "The same signal many times at once, as from a batch system: a checkpoint all the same"
start twice "${shot[@]}" --threads 2 --out twice
wait_for_rows twice 12 || true
for times in {1..50}; do kill -TERM "$child" 2> /dev/null || break; done
status=0
wait "$child" || status=$?
[ "$status" -eq 143 ] && [ -e twice/checkpoint.bin ] || fail "twice: status $status: $(cat twice.err)"

echo "The same command with --resume, twice stopped, and once more after the end"
for rows in 8 25; do
  start resumed "${shot[@]}" --threads 2 --out resumed --resume
  wait_for_rows resumed "$rows" || true
  stop_with TERM 143 resumed
done
# A run that begins puts the checkpoint aside.
[ ! -e resumed/checkpoint_before.bin ] || fail "resumed: from the beginning"
for times in 1 2; do
  "$ogive" shoot "${shot[@]}" --threads 1 --out resumed --resume > resumed.out
  require_same resumed
done

echo "kill -9, twice in a run"
start killed "${shot[@]}" --threads 2 --checkpoint-every-us 2 --out killed
wait_for_rows killed 17 || true
stop_with KILL 137 killed
require_readable killed
start killed --restart killed/checkpoint.bin
wait_for_rows killed 40 || true
stop_with KILL 137 killed
require_readable killed
"$ogive" shoot --restart killed/checkpoint.bin --threads 1 > killed.out
require_same killed

echo "kill -9 at any moment"
start any "${shot[@]}" --checkpoint-every-us 1 --out any
for moment in 1 2 3 4 5 6; do
  until [ -e any/checkpoint.bin ]; do
    kill -0 "$child" || fail "any: $(cat any.err)"
    sleep 0.01
  done
  sleep "0.0$((moment * 37 % 10))"
  kill -KILL "$child" 2> /dev/null || break
  wait "$child" || true
  require_readable any
  start any --restart any/checkpoint.bin
done
wait "$child" || fail "any: $(cat any.err)"
require_same any

echo "a later end"
"$ogive" shoot "${shot[@]}" --end-us 11 --checkpoint-every-us 100 --out later > later.out
"$ogive" shoot --restart later/checkpoint.bin --end-us 30 > later.out
require_same later

echo "a new run in the folder keeps the checkpoint of the old one under another name"
cp -r later again
"$ogive" shoot "${shot[@]}" --end-us 2 --out again > again.out
cmp later/checkpoint.bin again/checkpoint_before.bin || fail "the old checkpoint has gone"
cmp -s later/checkpoint.bin again/checkpoint.bin && fail "the old checkpoint has the name of the new one"

echo "a disk that is full: status 3, the old checkpoint stays"
start full "${shot[@]}" --checkpoint-every-us 2 --out full
wait_for_rows full 12 || true
stop_with KILL 137 full
cp full/checkpoint.bin before.bin
status=0
(
  trap '' XFSZ
  ulimit -f 40 # the frames fit, a checkpoint does not
  exec "$ogive" shoot --restart full/checkpoint.bin
) > full.out 2> full.err || status=$?
[ "$status" -eq 3 ] || fail "full: status $status: $(cat full.err)"
grep -q "^ogive shoot: error: cannot write full/.*: File too large$" full.err || fail "full: $(cat full.err)"
grep -q -- "--restart full/checkpoint.bin$" full.err || fail "full: no command: $(cat full.err)"
cmp before.bin full/checkpoint.bin || fail "full: another checkpoint"
require_readable full
"$ogive" shoot --restart full/checkpoint.bin > full.out
require_same full

mkdir disk
if mount -t tmpfs -o size=40m tmpfs disk 2> /dev/null; then
  trap 'umount "$PWD/disk" 2> /dev/null || true' EXIT
  start disk/full "${shot[@]}" --checkpoint-every-us 2 --out disk/full
  wait_for_rows disk/full 12 || true
  head -c 100M /dev/zero > disk/filler 2> /dev/null || true
  status=0
  wait "$child" || status=$?
  [ "$status" -eq 3 ] || fail "disk: status $status: $(cat full.err)"
  grep -q "^ogive shoot: error: cannot write disk/full/.*: No space left on device$" full.err || fail "disk: $(cat full.err)"
  require_readable disk/full
  rm disk/filler
  "$ogive" shoot --restart disk/full/checkpoint.bin > disk.out
  require_same disk/full
  umount disk
else
  echo "skipped: no file system of a fixed size can be mounted here"
fi
echo "all as it should be"
