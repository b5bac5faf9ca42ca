#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# projectiles.sh <ogive> <folder>: the guide's worked cases with projectiles at a coarse size. A bullet's core and a fragment
# simulator at aluminium far above and far below the measured limit, an oblique and yawed shot whose projectile turns, a body
# of revolution from a file, a bullet whose jacket peels off. Works in the folder.
set -euo pipefail

ogive=$1
examples=$(cd "$(dirname "$0")/../../examples" && pwd)
mkdir -p "$2"
cd "$2"
rm -rf ./*

fail() {
  echo "projectiles.sh: $*" >&2
  exit 1
}

# shoot <folder> <option>...
shoot() {
  "$ogive" shoot "${@:2}" --no-picture --no-vtk --quiet --out "$1" > "$1.log" 2>&1 || fail "$1: $(cat "$1.log")"
}

# number <folder> <key>: of its summary
number() {
  sed -n "s/^  \"$2\": \(.*[^,]\),\{0,1\}$/\1/p" "$1/summary.json"
}

# require_between <folder> <key> <low> <high>
require_between() {
  local value
  value=$(number "$1" "$2")
  awk -v x="$value" -v low="$3" -v high="$4" 'BEGIN { exit !(x + 0 >= low && x + 0 <= high) }' ||
    fail "$1: $2 = $value, not between $3 and $4"
}

# require_verdict <folder> <verdict>
require_verdict() {
  [ "$(number "$1" verdict)" = "\"$2\"" ] || fail "$1: $(number "$1" verdict) instead of $2"
}

plate=(--material "$examples/aa6061_t651_jc.toml" --clamp-radius-mm 60)
core=(--projectile apm2_762_core --thickness-mm 25.4 --spacing-mm 1.2 --sph-radius-mm 10)
fsp=(--projectile fsp_20mm --thickness-mm 12.7 --spacing-mm 2.5 --sph-radius-mm 18)

# V50 of the whole bullet: 597 m/s.
shoot core_through "${core[@]}" "${plate[@]}" --velocity-mps 850
require_verdict core_through perforated
require_between core_through residual_velocity_mps 300 800
require_between core_through projectile_mass_g 5.2 5.3
shoot core_held "${core[@]}" "${plate[@]}" --velocity-mps 350
require_verdict core_held stopped

# V50: 218 m/s.
shoot fsp_through "${fsp[@]}" "${plate[@]}" --velocity-mps 400
require_verdict fsp_through perforated
require_between fsp_through projectile_mass_g 53.7 53.8
require_between fsp_through projectile_scaled_jacobian 0.5 1
shoot fsp_held "${fsp[@]}" "${plate[@]}" --velocity-mps 100
require_verdict fsp_held stopped

# A rigid projectile that comes at an angle turns; the table and the history show how far.
shoot yawed --rigid --obliquity-deg 20 --pitch-deg 4 --extent half --thickness-mm 4 --spacing-mm 2 --sph-radius-mm 22 \
  --clamp-radius-mm 40 --velocity-mps 250 --end-us 120
require_between yawed turn_deg 0.2 30
require_between yawed energy_error 0 0.01
grep -q "turned by" yawed.log || fail "the table lacks the projectile's turn: $(cat yawed.log)"
head -n 1 yawed/history.csv | grep -q ',speed_m_per_s,deflection_deg,turn_deg,spin_rad_per_s$' ||
  fail "history.csv lacks the projectile's motion"

# The case of a profile needs its file no more.
printf 'z_mm,r_mm\n0,2\n12,6\n14,6\n15,5\n17,5\n18,6\n30,6\n' > grooved.csv
profile=(--thickness-mm 4 --spacing-mm 1 --sph-radius-mm 9 --clamp-radius-mm 30 --velocity-mps 300 --end-us 20 --rigid)
shoot grooved --profile grooved.csv "${profile[@]}"
rm grooved.csv
shoot again --config grooved/case.toml
[ "$(number grooved state_hash)" = "$(number again state_hash)" ] || fail "case.toml of a profile gives another shot"

# An own mesh of two parts, by its file and by that of a projectile; its case needs neither any more. Analytic mass of the
# cylinder: 12 mm in diameter, 12 mm of steel (7850) and 12 mm of copper (8960 kg/m3), 22.81 g.
mesh=(--thickness-mm 4 --spacing-mm 1.5 --sph-radius-mm 10 --clamp-radius-mm 40 --velocity-mps 400)
shoot two_parts --projectile "$examples/two_parts.toml" "${mesh[@]}"
require_verdict two_parts perforated
require_between two_parts projectile_mass_g 22.80 22.83
require_between two_parts projectile_volume_mm3 2714.3 2714.4
require_between two_parts energy_error 0 0.005
cp "$examples/two_parts.k" mine.k
shoot by_file --projectile-mesh mine.k --part-metals 1=arne_tool_steel,2=ofhc_copper "${mesh[@]}"
rm mine.k
[ "$(number two_parts state_hash)" = "$(number by_file state_hash)" ] || fail "an own mesh and its projectile's file differ"
shoot from_case --config by_file/case.toml
[ "$(number two_parts state_hash)" = "$(number from_case state_hash)" ] || fail "case.toml of an own mesh gives another shot"
shoot rigid_mesh --projectile "$examples/two_parts.toml" --rigid "${mesh[@]}" --end-us 40
require_between rigid_mesh projectile_mass_g 22.80 22.83

# The whole bullet, rigid: a jacket that yields folds at its tip.
shoot bullet --projectile apm2_762 --rigid --material aa6061_t651 --thickness-mm 12.7 --clamp-radius-mm 60 \
  --spacing-mm 1 --sph-radius-mm 10 --velocity-mps 500
require_verdict bullet perforated
require_between bullet projectile_mass_g 10.69 10.71
require_between bullet energy_error 0 0.001

# Deformable, with parts that touch: the jacket peels off and is left behind, its hexes at the tip are removed. The shot is
# that of the core. Energy within 0.5 %: what is removed is booked.
shoot peeling --projectile apm2_762 --parts touching --thickness-mm 6 --clamp-radius-mm 50 --spacing-mm 1.2 \
  --sph-radius-mm 10 --velocity-mps 800
require_verdict peeling perforated
[ "$(number peeling followed_part)" = '"core"' ] || fail "peeling: follows $(number peeling followed_part)"
require_between peeling residual_velocity_mps 500 790
require_between peeling removed_hexes 10 1000
require_between peeling energy_error 0 0.005
jacket=$(grep -A2 '"name": "jacket"' peeling/summary.json | sed -n 's/.*"velocity_mps": \(.*\)/\1/p')
awk -v x="$jacket" 'BEGIN { exit !(x + 0 < 500) }' || fail "peeling: the jacket flies on at $jacket m/s"
grep -q "mass was in hexes that have been removed" peeling.log || fail "peeling: no warning: $(cat peeling.log)"

# A fragment simulator whose head mushrooms and folds back; without contact that knows folds a particle was lost there.
shoot fsp_fast --projectile fsp_20mm --thickness-mm 12 --velocity-mps 900 --spacing-mm 2
require_between fsp_fast energy_error 0 0.005
[ "$(number fsp_fast verdict)" != '"undecided"' ] || fail "fsp_fast: undecided"

# A tube: pi (10^2 - 7^2) 40 mm3.
shoot tube --bore-radius-mm 7 --bore-depth-mm 40 --length-mm 40 --thickness-mm 4 --spacing-mm 2 --clamp-radius-mm 40 \
  --velocity-mps 300 --end-us 40
require_between tube projectile_volume_mm3 6408.8 6408.9

"$ogive" projectiles | grep -q 'fsp_20mm: 19.9 mm in diameter' || fail "ogive projectiles lacks fsp_20mm"
