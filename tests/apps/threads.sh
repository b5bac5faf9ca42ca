#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# threads.sh <ogive> <folder>: where no thread can be started the programs refuse in one line that names the remedy, and
# leave nothing behind. Works in the folder.
set -euo pipefail

ogive=$1
mkdir -p "$2"
cd "$2"
rm -rf ./*

fail() {
  echo "threads.sh: $*" >&2
  exit 1
}

# A process counts against its user's limit, which root does not have.
limited=(prlimit --nproc=1)
if [ "$(id -u)" -eq 0 ]; then
  limited=(setpriv --reuid=65534 --regid=65534 --clear-groups prlimit --nproc=1)
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
chmod 777 "$work"
if ! command -v prlimit > /dev/null || ! "${limited[@]}" "$ogive" --version > probe.out 2>&1; then
  echo "SKIPPED: no program can be run here as a user with a limit: $(cat probe.out)"
  exit 0
fi

# refuses <expected> <argument>...
refuses() {
  local status=0
  "${limited[@]}" "$ogive" "${@:2}" --out "$work/new/folder" > out 2> err || status=$?
  [ "$status" -eq 2 ] || fail "${*:2}: status $status instead of 2: $(cat err)"
  [ "$(wc -l < err)" -eq 1 ] || fail "${*:2}: not one line: $(cat err)"
  grep -qF -- "$1" err || fail "${*:2}: \"$1\" is not in: $(cat err)"
  [ ! -s out ] || fail "${*:2}: wrote to standard output: $(cat out)"
  [ ! -e "$work/new" ] || fail "${*:2}: left $(find "$work/new")"
}

case=(--spacing-mm 2 --sph-radius-mm 15 --clamp-radius-mm 30 --thickness-mm 4 --projectile rigid --velocity-mps 200
  --end-us 5)
refuses '--threads = 4: only 1 can be started (' shoot "${case[@]}" --threads 4
refuses '; give --threads 1, or raise the number of processes' shoot "${case[@]}" --threads 4
refuses '--threads = 4: only 1 can be started (' mesh "${case[@]}" --threads 4
refuses 'give fewer --jobs or --threads' sweep --vary velocity_mps=100,200 --threads 2 --jobs 2

# The remedy helps.
"${limited[@]}" "$ogive" shoot "${case[@]}" --threads 1 --no-picture --no-vtk --quiet --out "$work/one" > out 2> err ||
  fail "one thread: $(cat err)"
[ -s "$work/one/summary.json" ] || fail "one thread: no summary"
