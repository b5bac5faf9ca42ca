#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# output.sh <ogive> <folder>: a shot whose output has no reader, no room or no place runs to its end and writes its files;
# the status shows what could not be printed. A command that only prints may lose its reader. Works in the folder.
set -euo pipefail

ogive=$1
mkdir -p "$2"
cd "$2"
rm -rf ./*

shot=(--spacing-mm 2 --sph-radius-mm 15 --clamp-radius-mm 30 --thickness-mm 4 --projectile rigid --velocity-mps 200
  --end-us 20 --no-picture --checkpoint-every-us 5)

fail() {
  echo "output.sh: $*" >&2
  exit 1
}

# require_whole <folder>: all files of a shot that has come to its end
require_whole() {
  local file
  for file in summary.json history.csv perforation.pvd case.toml checkpoint.bin; do
    [ -s "$1/$file" ] || fail "$1/$file is missing"
  done
  tail -n 1 "$1/summary.json" | grep -qx '}' || fail "$1/summary.json is not whole"
}

# require_status <status> <file of standard error> <text>
require_status() {
  [ "$1" -eq 3 ] || fail "status $1 instead of 3: $(cat "$2")"
  grep -qx "ogive.*: error: standard output could not be written$3" "$2" || fail "\"$3\" is not in: $(cat "$2")"
}

status=0
"$ogive" shoot "${shot[@]}" --out plain > plain.out 2> plain.err || status=$?
[ "$status" -eq 0 ] || fail "status $status of a shot with room for its output: $(cat plain.err)"
require_whole plain

status=0
"$ogive" --version > /dev/full 2> version.err || status=$?
require_status "$status" version.err ": No space left on device"

status=0
"$ogive" shoot "${shot[@]}" --out full --quiet > /dev/full 2> full.err || status=$?
require_status "$status" full.err ".*"
require_whole full

# A reader that is gone before the closing table.
set +e
"$ogive" shoot "${shot[@]}" --out unread --quiet 2> unread.err | true
status=${PIPESTATUS[0]}
"$ogive" shoot "${shot[@]}" --out both 2>&1 | head -2 > both.out
both=${PIPESTATUS[0]}
set -e
require_status "$status" unread.err ".*"
require_whole unread
[ "$both" -eq 3 ] || fail "status $both of a shot whose reader left"
require_whole both

# No place at all: no file may take what is printed.
status=0
"$ogive" shoot "${shot[@]}" --out closed --quiet >&- 2> closed.err || status=$?
require_status "$status" closed.err ".*"
require_whole closed
grep -rq 'residual velocity' closed && fail "a file took what was printed"

# A pipe whose reader has left: it has seen enough of a list or a help.
mkfifo gone
exec 3<>gone 4>gone 3<&-
for command in --help --version completion projectiles materials "materials show lead" "shoot --help-all"; do
  status=0
  # shellcheck disable=SC2086 # words of a command
  "$ogive" $command >&4 2> printed.err || status=$?
  [ "$status" -eq 0 ] && [ ! -s printed.err ] || fail "$command: status $status without a reader: $(cat printed.err)"
  status=0
  # shellcheck disable=SC2086
  "$ogive" $command > /dev/full 2> printed.err || status=$?
  require_status "$status" printed.err ".*"
done
status=0
"$ogive" materials from-tensile --yield-mpa 276 --uts-mpa 310 --young-gpa 68.9 --out alloy.toml >&4 2> alloy.err || status=$?
require_status "$status" alloy.err ".*"
[ -s alloy.toml ] || fail "alloy.toml is missing"
exec 4>&-

hash() { grep state_hash "$1/summary.json"; }
for folder in full unread both closed; do
  [ "$(hash plain)" = "$(hash $folder)" ] || fail "$folder differs from plain"
done
