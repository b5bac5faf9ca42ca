#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# limit.sh <perforate> <folder>: finds the ballistic limit of a coarse thin plate, stops on the way, goes on, and runs
# nothing twice. Works in the folder.
set -euo pipefail

perforate=$1
mkdir -p "$2"
cd "$2"
rm -rf ./*

fail() {
  echo "limit.sh: $*" >&2
  exit 1
}

case=(--spacing-mm 2 --sph-radius-mm 15 --clamp-radius-mm 30 --thickness-mm 4 --projectile rigid --width-mps 20)
"$perforate" limit "${case[@]}" --velocity-mps 100 --out whole > whole.out || fail "status $?"
grep -q 'limit by bisection *[0-9.]* +- ' whole.out || fail "no limit: $(cat whole.out)"
grep -q 'limit of the fit' whole.out || fail "no fit"
# The limit is said as soon as it is known, before the faster shots that show the curve.
[ "$(sed -n '/limit by bisection/,$p' whole.out | grep -c 'm/s  residual')" -eq 4 ] || fail "said late: $(cat whole.out)"
[ -s whole/limit.svg ] || ! command -v gnuplot > /dev/null || fail "no picture"

# The limit lies where the table says: the fastest that was stopped and the slowest that was not, 20 m/s apart at most.
awk -F, 'NR > 1 && $3 == 0 && $1 > stopped { stopped = $1 }
  NR > 1 && $3 == 1 && (low == "" || $1 < low) { low = $1 }
  END { exit !(low > stopped && low - stopped <= 20) }' whole/limit.csv || fail "another bracket: $(cat whole/limit.csv)"
shots=$(find whole -name summary.json | wc -l)
[ "$shots" -eq $(($(wc -l < whole/limit.csv) - 1)) ] || fail "$shots shots, limit.csv: $(cat whole/limit.csv)"

# The processor time of a shot is its own, not that of all shots before it: no more than all cores have in its wall time.
for summary in whole/*/summary.json; do
  awk -F'[:,]' -v cores="$(nproc)" '/"cpu_s"/ { cpu = $2 } /"wall_s"/ { wall = $2 } END { exit !(cpu > 0 && cpu <= cores * wall + 0.1) }' \
    "$summary" || fail "processor time: $(grep '_s"' "$summary")"
done

# Again: nothing is run, all is said.
touch -d '2001-01-01' whole/*/summary.json
"$perforate" limit "${case[@]}" --velocity-mps 100 --out whole > again.out
diff whole.out again.out || fail "another result"
[ -z "$(find whole -name summary.json -newermt '2002-01-01')" ] || fail "a shot was run twice"

# A shot without its result is run anew, to the same.
cp whole/limit.csv before.csv
rm "$(find whole -name summary.json | sort | head -n 1)"
"$perforate" limit "${case[@]}" --velocity-mps 100 --out whole > again.out
cmp before.csv whole/limit.csv || fail "another table"

"$perforate" limit --width-mps 0 > /dev/null 2> error && fail "a width of 0 is taken"
grep -q '^perforate: error: --width-mps = 0: must lie between' error || fail "$(cat error)"

"$perforate" mesh "${case[@]:0:8}" --nose ogival --calibre-radius-head 2 --extent half --obliquity-deg 10 --out mesh > mesh.out
grep -q '^  projectile ' mesh.out || fail "no quality: $(cat mesh.out)"
grep -q 'DataSet' mesh/mesh.pvd || fail "no mesh"
