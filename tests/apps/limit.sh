#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# limit.sh <ogive> <folder>: finds the ballistic limit of a coarse thin plate, interrupts and resumes it, and runs no
# shot twice. Works in the folder.
set -euo pipefail

ogive=$1
mkdir -p "$2"
cd "$2"
rm -rf ./*

fail() {
  echo "limit.sh: $*" >&2
  exit 1
}

# column <name> <file>: its values, without the header
column() {
  awk -F, -v name="$1" 'NR == 1 { for (k = 1; k <= NF; ++k) if ($k == name) c = k } NR > 1 { print $c }' "$2"
}

# results <file>: rows of shots without what a run costs
results() {
  awk -F, -v OFS=, 'NR == 1 { for (k = 1; k <= NF; ++k) cost[k] = $k ~ /^(wall_s|cpu_s|threads)$/ }
    { for (k = 1; k <= NF; ++k) if (cost[k]) $k = ""; print }' "$1" | sort
}

# limit <folder> <argument>...: the command of all parts of this test
limit() {
  "$ogive" limit --spacing-mm 2 --sph-radius-mm 15 --clamp-radius-mm 30 --thickness-mm 4 --projectile rigid --method paper \
    --lattice ring --width-mps 20 --velocity-mps 100 --out "$@"
}

limit whole > whole.out || fail "status $?: $(cat whole.out)"
grep -q '^  limit by bisection  *[0-9.]* +- [0-9.]* m/s$' whole.out || fail "no limit: $(cat whole.out)"
grep -q '^  limit of the fit  *[0-9.]* ' whole.out || fail "no fit: $(cat whole.out)"
grep -q "^  files  *whole/shots.csv, whole/limits.csv$" whole.out || fail "no files: $(cat whole.out)"
# The limit is printed as soon as it is known, before the faster shots that show the curve.
[ "$(sed -n '/limit by bisection/,$p' whole.out | grep -c ' m/s, [0-9]* s, energy error ')" -eq 4 ] ||
  fail "printed late: $(cat whole.out)"
[ -s whole/limit.svg ] || ! command -v gnuplot > /dev/null || fail "no picture"

# The record of the prediction confirms the same search, refuses another case, and shows that it was changed.
grep -q "^  record  *whole/prediction.json$" whole.out || fail "no record: $(cat whole.out)"
limit checked --check whole/prediction.json > checked.out || fail "status $?: $(cat checked.out)"
shots=$(grep -c state_hash whole/prediction.json)
[ "$shots" -eq $(($(wc -l < whole/shots.csv) - 1)) ] || fail "$shots shots in the record"
grep -q "^  earlier prediction  *confirmed, $shots of $shots shots bit-identical$" checked.out || fail "$(cat checked.out)"
# Rows alone are no prediction: they may be of another case.
mkdir rows
cp whole/shots.csv rows
status=0
limit rows --check whole/prediction.json > rows.out || status=$?
[ "$status" -eq 3 ] || fail "rows alone: status $status"
grep -q "^  record  *none: rows/shots/.*: " rows.out || fail "$(cat rows.out)"
[ ! -e rows/prediction.json ] || fail "rows alone make a record"
status=0
limit other --thickness-mm 4.2 --check whole/prediction.json 2> other.err || status=$?
[ "$status" -eq 2 ] || fail "another case: status $status"
grep -q "whole/prediction.json: must be of this case: thickness_mm is 4.2 instead of 4$" other.err ||
  fail "$(cat other.err)"
sed 's/"limit_mps": [0-9]/&0/' whole/prediction.json > changed.json
status=0
limit other --check changed.json 2> other.err || status=$?
[ "$status" -eq 2 ] || fail "a changed record: status $status"
grep -q "changed.json: must be a prediction.json of ogive limit, unchanged: its hash is " other.err || fail "$(cat other.err)"
[ ! -e other ] || fail "something was run: $(ls other)"

# The limit lies where the table says: the fastest that was stopped and the slowest that was not, 20 m/s apart at most.
paste -d, <(column initial_velocity_mps whole/shots.csv) <(column perforated whole/shots.csv) |
  awk -F, '$2 == 0 && $1 > stopped { stopped = $1 }
    $2 == 1 && (low == "" || $1 < low) { low = $1 }
    END { print stopped; print low; exit !(low > stopped && low - stopped <= 20) }' > bracket ||
  fail "another bracket: $(cat whole/shots.csv)"
diff bracket <(column highest_stopped_mps whole/limits.csv; column lowest_perforated_mps whole/limits.csv) ||
  fail "limits.csv has another bracket: $(cat whole/limits.csv)"
[ "$(column bisection_limit_mps whole/limits.csv)" = "$(awk '{ sum += $1 } END { print sum / 2 }' bracket)" ] ||
  fail "limits.csv has another limit: $(cat whole/limits.csv)"
grep -q "limit by bisection  *$(awk '{ sum += $1 } END { printf "%.1f", sum / 2 }' bracket) " whole.out ||
  fail "another limit is printed: $(cat whole.out)"
shots=$(find whole/shots -name summary.json | wc -l)
[ "$shots" -eq $(($(wc -l < whole/shots.csv) - 1)) ] || fail "$shots shots, shots.csv: $(cat whole/shots.csv)"

# The processor time of a shot is its own, not that of all shots before it: no more than all cores have in its wall time.
for summary in whole/shots/*/summary.json; do
  awk -F'[:,]' -v cores="$(nproc)" '/"cpu_s"/ { cpu = $2 } /"wall_s"/ { wall = $2 } END { exit !(cpu > 0 && cpu <= cores * wall + 0.1) }' \
    "$summary" || fail "processor time: $(grep '_s"' "$summary")"
done

# Again: nothing is run, the same is printed.
cp whole/shots.csv shots.csv
cp whole/limits.csv limits.csv
touch -d '2001-01-01' whole/shots/*/summary.json
# require_nothing_run <standard output>: the same files and results as of the first run, without a new shot
require_nothing_run() {
  diff <(grep '^  ' whole.out) <(grep '^  ' "$1") || fail "another result"
  ! grep '^[1-9][0-9]* shots* run' "$1" || fail "shots were run"
  diff <(results shots.csv) <(results whole/shots.csv) || fail "another table of shots"
  cmp limits.csv whole/limits.csv || fail "another table of limits"
  [ -z "$(find whole -name summary.json -newermt '2002-01-01')" ] || fail "a shot was run twice"
}
limit whole > again.out || fail "again: status $?"
require_nothing_run again.out
limit whole --no-run > again.out || fail "--no-run: status $?"
require_nothing_run again.out

# Without their table, shots get their rows from their summaries.
rm whole/shots.csv
limit whole > again.out || fail "without a table: status $?"
require_nothing_run again.out

# A shot without row and summary is run anew, to the same result.
rm whole/shots.csv "$(find whole/shots -name summary.json | sort | head -n 1)"
limit whole > again.out || fail "without a shot: status $?"
diff <(results shots.csv) <(results whole/shots.csv) || fail "another table of shots"
cmp limits.csv whole/limits.csv || fail "another table of limits"
[ "$(find whole -name summary.json -newermt '2002-01-01' | wc -l)" -eq 1 ] || fail "not one shot was run"

# Interrupted, it resumes to the same.
(
  trap - INT
  exec env --default-signal=TERM "$ogive" limit --spacing-mm 2 --sph-radius-mm 15 --clamp-radius-mm 30 --thickness-mm 4 \
    --projectile rigid --method paper --lattice ring --width-mps 20 --velocity-mps 100 --out stopped
) > stopped.out 2> stopped.err &
child=$!
until [ "$(wc -l 2> /dev/null < stopped/shots.csv || echo 0)" -ge 2 ]; do
  kill -0 "$child" || fail "stopped too early: $(cat stopped.err)"
  sleep 0.01
done
kill -TERM "$child" || fail "stopped too late"
status=0
wait "$child" || status=$?
[ "$status" -eq 143 ] || fail "status $status instead of 143: $(cat stopped.err)"
grep -qx 'ogive limit: stopped by SIGTERM; the same command resumes' stopped.err || fail "$(cat stopped.err)"
! grep -q 'limit by bisection' stopped.out || fail "a limit of an interrupted search: $(cat stopped.out)"
limit stopped > stopped.out || fail "resumed: status $?"
cmp limits.csv stopped/limits.csv || fail "resumed: another table of limits"
diff <(results shots.csv) <(results stopped/shots.csv) || fail "resumed: another table of shots"

# With other arrangements of the particles the first limit stays, and mean, scatter and interval follow from all.
limit whole --repeats 3 > repeats.out || fail "--repeats: status $?: $(cat repeats.out)"
diff <(grep 'limit by bisection' whole.out) <(grep 'limit by bisection' repeats.out) || fail "--repeats: another first limit"
[ "$(column seed whole/limits.csv | sort | paste -sd ' ')" = "0 1 2" ] || fail "seeds: $(cat whole/limits.csv)"
column bisection_limit_mps whole/limits.csv | awk '
  { v[NR] = $1; sum += $1 } END { m = sum / NR; for (k in v) s += (v[k] - m)^2; printf "%.2f,%.2f\n", m, sqrt(s / (NR - 1)) }' > mean
[ "$(paste -d, <(column mean_mps whole/repeats.csv) <(column standard_deviation_mps whole/repeats.csv))" = "$(cat mean)" ] ||
  fail "mean and deviation $(cat mean): $(cat whole/repeats.csv)"
grep -q '^  90 % interval  *[-0-9.]* to [0-9.]* m/s$' repeats.out || fail "no interval: $(cat repeats.out)"
limit whole --repeats 3 > again.out || fail "--repeats again: status $?"
! grep '^[1-9][0-9]* shots* run' again.out || fail "--repeats again: shots were run"
diff <(grep '^  ' repeats.out) <(grep '^  ' again.out) || fail "--repeats again: another result"
limit whole > again.out || fail "without --repeats: status $?"
cmp limits.csv whole/limits.csv || fail "without --repeats: another table of limits"

# Results of another case are not taken for those of this one, and stay.
status=0
limit whole --friction 0.3 > other.out 2> other.err || status=$?
[ "$status" -eq 3 ] || fail "another case in the folder: status $status: $(cat other.out other.err)"
grep -q '^ogive limit: failed: .* are of a case with another friction; give another --out' other.err ||
  fail "another case in the folder: $(cat other.err)"
! grep -q 'limit by bisection' other.out || fail "the limit of another case: $(cat other.out)"
cmp limits.csv whole/limits.csv || fail "another case in the folder: another table"

# One process at a time.
status=0
flock whole/.lock "$ogive" limit --thickness-mm 4 --spacing-mm 2 --out whole > locked.out 2> locked.err || status=$?
[ "$status" -eq 2 ] || fail "two processes: status $status: $(cat locked.err)"
grep -q '^ogive limit: error: --out = whole: another process works on this study' locked.err || fail "$(cat locked.err)"

"$ogive" mesh --spacing-mm 2 --sph-radius-mm 15 --clamp-radius-mm 30 --thickness-mm 4 --nose ogival \
  --calibre-radius-head 2 --extent half --obliquity-deg 10 --out mesh > mesh.out
grep -q '^  projectile ' mesh.out || fail "no quality: $(cat mesh.out)"
grep -q 'DataSet' mesh/mesh.pvd || fail "no mesh"
