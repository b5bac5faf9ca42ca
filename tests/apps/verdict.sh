#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# verdict.sh <ogive> <folder>: verdicts of shots whose plug is far lighter than a gram, of one that is stopped and of one
# that is undecided; and that nothing of a user's is overwritten without a word. Works in the folder.
set -euo pipefail

ogive=$1
mkdir -p "$2"
cd "$2"
rm -rf ./*

# A tenth of a plate of 3 mm: the plug weighs some milligrams.
small=(--diameter-mm 2 --thickness-mm 0.3 --spacing-mm 0.1 --sph-radius-mm 1.6 --clamp-radius-mm 8 --projectile rigid
  --no-picture --no-vtk --quiet --threads 1)

fail() {
  echo "verdict.sh: $*" >&2
  exit 1
}

# value <folder> <key>: of summary.json
value() { sed -n "s/^  \"$2\": \"\{0,1\}\([^\",]*\)\"\{0,1\},\{0,1\}$/\1/p" "$1/summary.json"; }

require_value() {
  [ "$(value "$1" "$2")" = "$3" ] || fail "$1: $2 is $(value "$1" "$2") instead of $3"
}

"$ogive" shoot "${small[@]}" --velocity-mps 250 --out through > through.out
require_value through verdict perforated
require_value through perforated true
awk -v v="$(value through residual_velocity_mps)" -v m="$(value through plug_mass_g)" \
  'BEGIN { exit !(v > 100 && v < 250 && m > 0 && m < 0.1) }' || fail "through: $(cat through.out)"

"$ogive" shoot "${small[@]}" --velocity-mps 30 --out stopped > stopped.out
require_value stopped verdict stopped
require_value stopped residual_velocity_mps 0.0

"$ogive" shoot "${small[@]}" --velocity-mps 250 --end-us 1 --out later > later.out
require_value later verdict undecided
require_value later perforated null
require_value later residual_velocity_mps null
grep -q 'perforated  *undecided: at 1.* us the projectile moves at .* m/s ' later.out ||
  fail "no reason: $(cat later.out)"
"$ogive" shoot "${small[@]}" --velocity-mps 250 --resume --out later > later.out
for key in verdict state_hash steps largest_intrusion_mm; do require_value later $key "$(value through $key)"; done

echo "results of another case are moved aside, and that is reported"
echo mine > later/notes.txt
"$ogive" shoot "${small[@]}" --velocity-mps 260 --out later > later.out 2> later.err
grep -q 'later: its results are of a case with another velocity_mps; they are now in .*later_before_1$' later.err ||
  fail "no word: $(cat later.err)"
[ -e later_before_1/notes.txt ] && [ -e later_before_1/history.csv ] || fail "files are missing"
require_value later_before_1 initial_velocity_mps 250.0

echo "a case file of the user's is not overwritten"
mkdir own
printf '# mine\nthickness_mm = 0.3\nout = "own"\n' > own/case.toml
cp own/case.toml before.toml
status=0
"$ogive" shoot --config own/case.toml "${small[@]}" > own.out 2> own.err || status=$?
[ "$status" -eq 2 ] && cmp before.toml own/case.toml || fail "own: status $status: $(cat own.err)"
grep -q -- '--config = own/case.toml: must not be case.toml in the folder for the results' own.err ||
  fail "own: $(cat own.err)"

echo "a warning for constants of damage that make no sense"
"$ogive" materials show weldox_460e | sed 's/^D3 = [^ ]*/D3 = 0.952/' > rising.toml
"$ogive" materials check rising.toml > check.out
grep -q '^warning: .*rises with tension' check.out || fail "check: $(cat check.out)"
"$ogive" shoot "${small[@]}" --material rising.toml --damage jc --end-us 1 --out rising > /dev/null 2> rising.err
grep -q '^ogive shoot: warning: .*rises with tension' rising.err || fail "rising: $(cat rising.err)"
