#!/usr/bin/env bash
# own_metal.sh OGIVE FOLDER: runs the commands of docs/own_metal.md, with coarse and short shots, and compares what they
# print with the page.
set -euo pipefail
ogive=$1
page=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/docs/own_metal.md
rm -rf "$2"
mkdir -p "$2"
cd "$2"

fail() {
  printf 'own_metal.sh: %s\n' "$1" >&2
  exit 1
}

# block N: the N-th block of code of the page.
block() {
  awk -v n="$1" '/^```/{if (inside) {inside = 0} else {inside = 1; count++} next} inside && count == n' "$page"
}

# compare N FILE: the N-th block of the page is what the file has.
compare() {
  block "$1" >expected
  diff expected "$2" || fail "block $1 of the page is not what is printed"
}

run() {
  command -v gnuplot >/dev/null || [[ $* != *--plot* ]] || return 0
  "$ogive" "$@"
}

# My steel from a card.
block 1 >my_steel.k
run materials import my_steel.k --out my_steel.toml >printed
compare 3 printed
run materials show my_steel.toml --plot my_steel.svg
run materials check my_steel.toml >printed
[[ $(<printed) == "my_steel.toml: Steel 4340, model jc, is a metal for --material" ]] || fail "check: $(<printed)"
coarse=(--threads 1 --no-picture --no-vtk --quiet)
run shoot --material my_steel.toml --damage jc --thickness-mm 8 --spacing-mm 2 "${coarse[@]}" --end-us 30 --out steel

# My aluminium from a mill certificate.
run materials from-tensile --yield-mpa 276 --uts-mpa 310 --elongation-pct 12 --young-gpa 68.9 \
  --name "AA6061-T651, my plate" --out my_alloy.toml >printed
compare 6 printed
core=(--nose ogival --calibre-radius-head 3 --diameter-mm 6.17 --length-mm 27.6 --mass-g 5.25 --projectile rigid
  --method paper --lattice ring)
run shoot "${core[@]}" --friction 0.02 --material my_alloy.toml --thickness-mm 12.7 --velocity-mps 600 \
  --spacing-mm 1.4 --sph-radius-mm 9 --clamp-radius-mm 60 "${coarse[@]}" --out core
# The measured limit is 391 m/s: 600 m/s leave sqrt(600^2 - 391^2) = 455 m/s by Recht and Ipson. Particles of 1.4 mm, a
# quarter of the core's diameter, take some 50 m/s more; finer ones are on the page.
velocity=$(sed -n 's/.*"residual_velocity_mps": \([0-9.]*\).*/\1/p' core/summary.json)
awk -v v="$velocity" 'BEGIN {exit !(v > 360 && v < 500)}' || fail "residual velocity = $velocity m/s"
