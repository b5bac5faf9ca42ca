#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# settle.sh <ogive> <folder>: a plate that holds is watched while it swings; the shot itself stays as it was, and a
# restart in that time ends with the same mean. Works in the folder.
set -euo pipefail

ogive=$1
mkdir -p "$2"
cd "$2"
rm -rf ./*

fail() {
  echo "settle.sh: $*" >&2
  exit 1
}
number() { # folder key: its value in the summary
  sed -n "s/^ *\"$2\": \"\{0,1\}\([^\",]*\)\"\{0,1\},\{0,1\}$/\1/p" "$1/summary.json"
}

case=(--spacing-mm 2 --sph-radius-mm 15 --clamp-radius-mm 30 --thickness-mm 4 --projectile rigid --velocity-mps 60
  --no-picture --no-vtk --quiet)
"$ogive" shoot "${case[@]}" --out plain > /dev/null
"$ogive" shoot "${case[@]}" --settle-us 300 --checkpoint-every-us 90 --out held > held.out
"$ogive" shoot --restart held/checkpoint.bin --out again --quiet > /dev/null

[ -z "$(number plain dishing_at_rest_mm)" ] || fail "a mean without --settle-us"
grep -q '^  dishing  *[0-9.]* mm at rest, mean over 30[0-9] us$' held.out || fail "not told: $(cat held.out)"
for key in residual_velocity_mps perforated ending; do
  [ "$(number plain $key)" = "$(number held $key)" ] || fail "$key differs: $(number plain $key), $(number held $key)"
done
awk -v a="$(number plain simulated_us)" -v b="$(number held simulated_us)" 'BEGIN { exit !(b - a > 300 && b - a < 302) }' ||
  fail "ran to $(number held simulated_us) us, not 300 us longer than $(number plain simulated_us)"
for key in dishing_at_rest_mm state_hash; do
  [ -n "$(number held $key)" ] || fail "no $key"
  [ "$(number again $key)" = "$(number held $key)" ] || fail "$key after the restart: $(number again $key)"
done

# Particles 2, 1 and 0.6 mm apart give 2.81, 2.92 and 2.99 mm: within a tenth of the finest.
awk -v rest="$(number held dishing_at_rest_mm)" 'BEGIN { exit !(rest > 2.7 && rest < 3.3) }' ||
  fail "a mean of $(number held dishing_at_rest_mm) mm"
