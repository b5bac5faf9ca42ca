#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# beyond.sh [--insert] [folder]: prints the tables of docs/beyond.md, in Markdown, and runs the shots behind them that the
# folder does not hold yet; READ_ONLY=1 runs none. --insert puts those of one PART there too, without rows whose shots the
# folder lacks. PART names one of them:
#   limits      against the tests, all methods, and residual velocities: of the page of results
#   stabilised  what the parameters of --method stabilised do at 12 and 6 mm
#   adaptive    shots with --method adaptive
#   damage      what its limits at 6 and 12 mm depend on
#   mesh        all limits of blunt projectiles on steel with other sizes of hexes; METHOD=stabilised: of particles;
#               THICKNESSES="6 12": these plates, SIZES=0.8: this size
#   dishing     what is left of the dishing of a plate that holds
#   cost        against the paper's method, of the shots on the page of results
#   timing      one shot for each plate and nose, with the paper's method and METHOD one after the other
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
if [ "${1:-}" = --insert ]; then
  shift
  if [ "${PART:-all}" = all ]; then
    echo 'beyond: error: PART = all: must name one part with --insert' >&2
    exit 2
  fi
  tables=$(mktemp)
  trap 'rm -f "$tables"' EXIT
  "$here/beyond.sh" "$@" | tee "$tables"
  "$here/../scripts/insert_tables.py" "$here/../docs/beyond.md" \
    --mark "tables: ${METHOD:+METHOD=$METHOD }PART=$PART bench/beyond.sh" < "$tables"
  exit
fi
folder=${1:-$here/../vtk_out/beyond}
source "$here/shots.sh"

# limit_of_test, limit_of_page thickness: of the blunt nose on steel, m/s
limit_of_test() { awk -F, -v t="$1" '$2 == "Weldox 460 E" && $3 == "blunt" && $4 == t { print $5 }' "$root/apps/data/experiment_limits.csv"; }
limit_of_page() {
  awk -F, -v t="$1" -v method="${METHOD:-adaptive}" '$1 == method && $2 == "mjc" && $3 == "weldox_460e" && $4 == "blunt" && $5 == t { print $9 }' \
    "$root/docs/results/results/limits.csv"
}

one() { # name text [option]...
  shoot "stabilised_$1" --method stabilised --model mjc --no-picture --spacing-mm 0.8 "${@:3}"
  [ -e "$folder/stabilised_$1/summary.json" ] || return 0
  echo "| $2 | $(number "stabilised_$1" initial_velocity_mps %.1f) | $(test_velocity "stabilised_$1") |" \
    "$(number "stabilised_$1" residual_velocity_mps %.1f) | $(number "stabilised_$1" plug_mass_g %.1f) |" \
    "$(number "stabilised_$1" failed_particles %d) | $(number "stabilised_$1" dishing_mm %.2f) |" \
    "$(number "stabilised_$1" hourglass_fraction %.2f 100) | $(number "stabilised_$1" energy_error %.3f 100) |" \
    "$(number "stabilised_$1" cpu_s %.0f) |"
}

both() { # name text [option]...
  one "12mm_224.7_$1" "12 mm, $2" --velocity-mps 224.7 "${@:3}"
  one "6mm_170_$1" "6 mm, $2" --thickness-mm 6 --velocity-mps 170 "${@:3}"
}

# Of all three methods, on the page of results.
limits_table() {
  echo 'Limits by bisection on the page of results, modified law, 0.6 mm, against the tests; what lies between two shots more' \
    'than 5 m/s apart is not known better yet:'
  echo
  echo "| nose | plate | tests, m/s | the paper's method, m/s | off | stabilised, m/s | off | adaptive, m/s | off |"
  echo '|---|---|---|---|---|---|---|---|---|'
  awk -F, '
    NR == 1 { for (k = 1; k <= NF; ++k) column[$k] = k; next }
    $2 == "mjc" {
      plate = $4 "," $5 " mm " $3
      if (!(plate in test)) order[++n] = plate
      test[plate] = $column["test_limit_mps"]
      found[plate, $1] = $column["bisection_limit_mps"]
      stopped = $column["highest_stopped_mps"]
      perforated = $column["lowest_perforated_mps"]
      wide[plate, $1] = stopped != "" && perforated - stopped > 5 ? stopped " to " perforated : ""
    }
    function off(plate, method,   limit) {
      limit = found[plate, method]
      if (wide[plate, method] != "") return wide[plate, method] " | –"
      return limit == "" ? "– | –" : sprintf("%.1f | %+.1f %%", limit, 100 * (limit / test[plate] - 1))
    }
    END {
      for (k = 1; k <= n; ++k) {
        split(order[k], part, ",")
        if (found[order[k], "stabilised"] found[order[k], "adaptive"] == "") continue
        printf "| %s | %s | %.1f | %s | %s | %s |\n", part[1], part[2], test[order[k]], off(order[k], "sfm"),
          off(order[k], "stabilised"), off(order[k], "adaptive")
      }
    }' "$root/docs/results/results/limits.csv"
}

# Of the stabilised particles, on the page of results.
residuals_table() {
  echo '12 mm of steel, blunt, stabilised, on the page of results, modified law, 0.6 mm, at the velocities of measured shots:'
  echo
  echo '| initial, m/s | test, m/s | computed, m/s | plug, g | dishing at the end, mm | bonds, % of energy | energy error, % |'
  echo '|---|---|---|---|---|---|---|'
  awk -F, '
    FNR == 1 { for (k = 1; k <= NF; ++k) column[$k] = k; ++file; next }
    file == 1 { if ($2 == "Weldox 460 E" && $3 == "blunt" && $4 == 12) test[$5] = $6; next }
    $1 == "stabilised" && $2 == "mjc" && $3 == "weldox_460e" && $4 == "blunt" && $5 == 12 && $6 in test {
      printf "| %.1f | %.1f | %.1f | %.1f | %.2f | %.2f | %.4f |\n", $6, test[$6], $column["residual_velocity_mps"],
        $column["plug_mass_g"], $column["dishing_mm"], 100 * $column["hourglass_fraction"], 100 * $column["energy_error"]
    }' "$root/apps/data/experiment_shots.csv" "$root/docs/results/results/shots.csv"
}

stabilised_tables() {
  echo 'Stabilised, one parameter at a time, particles 0.8 mm apart:'
  echo
  echo '| case | initial, m/s | test, m/s | computed, m/s | plug, g | failed particles | dishing at the end, mm |' \
    'bonds, % of energy | energy error, % | processor, s |'
  echo '|---|---|---|---|---|---|---|---|---|---|'
  both 'base' 'as it is'
  both 'no_damage' 'no damage' --damage none
  both 'softening_0' 'Dc 0' --damage-softening 0
  both 'softening_0.6' 'Dc 0.6' --damage-softening 0.6
  both 'length_0.15' 'ℓ 0.15 mm' --damage-length-mm 0.15
  both 'length_0.3' 'ℓ 0.3 mm' --damage-length-mm 0.3
  both 'everywhere' 'ℓ 0.4 mm, at any stress' --damage-length-mm 0.4 --damage-length-scope everywhere
  both 'own' "each particle's own pressure" --damage-pressure own
  both 'everywhere_own' 'both of these' --damage-length-mm 0.4 --damage-length-scope everywhere --damage-pressure own
  both 'control_0' 'no bonds' --control-stiffness 0
  both 'control_0.1' 'stiffness of bonds 0.1' --control-stiffness 0.1
  both 'control_0.6' 'stiffness of bonds 0.6' --control-stiffness 0.6
  both 'cubic' 'cubic lattice' --lattice cubic
  both 'rigid' 'rigid projectile' --projectile rigid
  both 'friction' 'friction 0.1' --friction 0.1
  both 'edge_0.2' 'edge radius 0.2 mm' --edge-radius-mm 0.2
  both 'edge_0.5' 'edge radius 0.5 mm' --edge-radius-mm 0.5
  both 'edge_1' 'edge radius 1 mm' --edge-radius-mm 1
}

adaptive() { # name text [option]...
  shoot "adaptive_$1" --method adaptive "${@:3}"
  [ -e "$folder/adaptive_$1/summary.json" ] || return 0
  echo "| $2 | $(number "adaptive_$1" initial_velocity_mps %.1f) | $(test_velocity "adaptive_$1") |" \
    "$(number "adaptive_$1" residual_velocity_mps %.1f) | $(number "adaptive_$1" plug_mass_g %.1f) |" \
    "$(number "adaptive_$1" failed_hexes %d), $(number "adaptive_$1" distorted_hexes %d) |" \
    "$(number "adaptive_$1" dishing_mm %.2f), $(number "adaptive_$1" dishing_at_rest_mm %.2f) |" \
    "$(number "adaptive_$1" hourglass_fraction %.2f 100) |" \
    "$(number "adaptive_$1" energy_error %.4f 100) | $(number "adaptive_$1" largest_intrusion_mm %.3f) |" \
    "$(number "adaptive_$1" cpu_s %.0f) |"
}

adaptive_tables() {
  local head='| case | initial, m/s | test, m/s | computed, m/s | plug, g | hexes failed, distorted | dishing at the end, at rest, mm | hourglass,'
  head+=' % of energy | energy error, % | intrusion, mm | processor, s |'
  echo 'Hexes that turn into particles, the plate that ℓ was chosen on, 12 mm, hexes of 0.6 mm:'
  echo
  echo "$head"
  echo '|---|---|---|---|---|---|---|---|---|---|---|'
  local v
  for v in 181.5 200.4 244.2 303.5 399.6; do adaptive "12mm_$v" '12 mm' --velocity-mps "$v"; done
  echo
  echo 'Other plates and noses:'
  echo
  echo "$head"
  echo '|---|---|---|---|---|---|---|---|---|---|---|'
  for v in 150 160; do adaptive "6mm_$v" '6 mm' --thickness-mm 6 --velocity-mps "$v"; done
  adaptive 20mm_310 '20 mm' --thickness-mm 20 --velocity-mps 310
  adaptive conical_12mm_317.9 '12 mm, conical' --nose conical --velocity-mps 317.9
  echo
  echo 'Size of the hexes:'
  echo
  echo "$head"
  echo '|---|---|---|---|---|---|---|---|---|---|---|'
  local size
  for size in 1.2 0.8 0.6 0.45; do
    local name=_${size}mm
    [ "$size" = 0.6 ] && name=
    adaptive "12mm_244.2$name" "12 mm, hexes of $size mm" --velocity-mps 244.2 --spacing-mm "$size"
    adaptive "6mm_160$name" "6 mm, hexes of $size mm" --thickness-mm 6 --velocity-mps 160 --spacing-mm "$size"
  done
  # Lengths with which failure strains at 0.6 mm are those of the exponent 1/4.
  local pair
  for pair in 0.5:0.363 1:0.467; do
    for size in 1.2 0.8; do
      adaptive "12mm_244.2_${size}mm_exponent_${pair%:*}" "12 mm, hexes of $size mm, exponent ${pair%:*}, ℓ ${pair#*:} mm" \
        --velocity-mps 244.2 --spacing-mm "$size" --damage-length-exponent "${pair%:*}" --damage-length-mm "${pair#*:}"
    done
  done
}

# limit thickness name [option]...: the middle of the bracket, m/s; hexes (METHOD=stabilised: particles) of 1.2 mm unless
# an option says otherwise
limit() {
  local out=$folder/limit_${METHOD:+${METHOD}_}$1mm_$2 guess
  guess=$(limit_of_page "$1")
  guess=${guess:-$((80 + 9 * $1))}
  if [ ! -e "$out/limit_fit.csv" ] && [ -z "${READ_ONLY:-}" ]; then
    "$root/scripts/with_display.sh" "${PERFORATE:-$root/build/release/apps/perforate}" limit --method "${METHOD:-adaptive}" --quiet --no-vtk \
      --no-picture --spacing-mm 1.2 --thickness-mm "$1" --velocity-mps "$guess" --out "$out" "${@:3}" \
      > "$out.log" 2>&1 || echo "$out ended with status $?: see $out.log" >&2
  fi
  sed -nE 's/^  limit by bisection +([0-9.]+) .*/\1/p' "$out.log" 2> /dev/null || true # no log: no row
}

limits() { # name text [option]...
  local thin thick
  thin=$(limit 6 "$1" "${@:3}")
  thick=$(limit 12 "$1" "${@:3}")
  [ -n "$thin" ] && [ -n "$thick" ] || return 0
  echo "| $2 | $thin | $thick | $(awk "BEGIN { printf \"%.2f\", $thin / $thick }") |"
}

damage_tables() {
  echo 'Hexes that turn into particles, hexes of 1.2 mm: limits by bisection to 2.5 m/s.'
  echo
  echo '| case | 6 mm, m/s | 12 mm, m/s | 6 mm over 12 mm |'
  echo '|---|---|---|---|'
  awk -F, '/,Weldox 460 E,blunt,(6|12),/ { limit[$4] = $5 }
    END { printf "| tests | %.1f | %.1f | %.2f |\n", limit[6], limit[12], limit[6] / limit[12] }' \
    "$root/apps/data/experiment_limits.csv"
  # Of the same steel, as commonly quoted.
  local older=$folder/weldox_460e_boervik_2001.toml metal
  limits base 'as it is'
  metal=$(find "$folder/limit_12mm_base" -name material.toml 2> /dev/null | sort | head -n 1) || true
  [ -z "$metal" ] || sed -E 's/^(name = ).*/\1"weldox_460e_boervik_2001"/; s/^(source = ).*/\1"D1 to D5 of Boervik et al. 2001"/
    s/^D1 = .*/D1 = 0.0705/; s/^D2 = .*/D2 = 1.732/; s/^D3 = .*/D3 = -0.54/; s/^D4 = .*/D4 = -0.0123/; s/^D5 = .*/D5 = 0/' \
    "$metal" > "$older"
  if [ -e "$older" ]; then
    limits older 'D1 to D5 of Børvik et al. 2001' --material "$older"
    limits older_softening_0.3 'the same, Dc 0.3, ℓ 0.6 mm' --material "$older" --damage-softening 0.3 --damage-length-mm 0.6
  fi
  limits softening_0.3 'Dc 0.3' --damage-softening 0.3
  limits softening_1 'Dc 1' --damage-softening 1
  limits length_0.1 'ℓ 0.1 mm' --damage-length-mm 0.1
  limits length_0.5 'ℓ 0.5 mm' --damage-length-mm 0.5
  limits rigid 'rigid projectile' --projectile rigid
  limits clamp 'clamped at 125 mm' --clamp-radius-mm 125
  limits friction 'friction 0.1' --friction 0.1
}

dishing_table() {
  echo 'Plate of 12 mm at 181.5 m/s, modified law, 2 ms more after the shot is decided; the test left 2.92 mm (Børvik et al.' \
    '2002, IJIE 27:19, quoted):'
  echo
  echo '| method | size, mm | computed, m/s | dishing at the end, mm | at rest, mm |'
  echo '|---|---|---|---|---|'
  local method size name
  for name in adaptive_1.2 adaptive_0.8 adaptive_0.6 stabilised_0.6; do
    method=${name%_*} size=${name#*_}
    shoot "rest_$name" --method "$method" --model mjc --velocity-mps 181.5 --spacing-mm "$size" --settle-us 2000 --no-picture
    [ -e "$folder/rest_$name/summary.json" ] || continue
    echo "| $method | $size | $(number "rest_$name" residual_velocity_mps %.1f) | $(number "rest_$name" dishing_mm %.2f) |" \
      "$(number "rest_$name" dishing_at_rest_mm %.2f) |"
  done
}

mesh_tables() {
  local what='Hexes that turn into particles' size_of=hexes
  [ "${METHOD:-adaptive}" = adaptive ] || what='Stabilised' size_of=particles
  echo "$what, other sizes of $size_of: limits by bisection to 2.5 m/s. Those with 0.6 mm are those of the page of results."
  echo
  echo "| plate | tests, m/s | $size_of of 1.2 mm | 0.8 mm | 0.6 mm | 0.45 mm | 0.8 mm against 0.6 mm | 0.45 mm against 0.6 mm |"
  echo '|---|---|---|---|---|---|---|---|'
  local thickness size row
  for thickness in ${THICKNESSES:-6 8 10 12 16 20}; do
    declare -A found=([0.6]=$(limit_of_page "$thickness"))
    for size in ${SIZES:-1.2 0.8 0.45}; do
      found[$size]=$(limit "$thickness" "mesh_${size}mm" --model mjc --spacing-mm "$size")
    done
    row="| $thickness mm | $(limit_of_test "$thickness")"
    for size in 1.2 0.8 0.6 0.45; do row+=" | ${found[$size]:-–}"; done
    for size in 0.8 0.45; do
      row+=" | $(awk -v a="${found[$size]:-0}" -v b="${found[0.6]:-0}" \
        'BEGIN { if (a * b > 0) printf "%+.1f %%", 100 * (a / b - 1); else printf "–" }')"
    done
    echo "$row |"
    unset found
  done
}

# Of shots that the paper's method and `method` have. Not run side by side: part of them on another CPU or beside other
# work.
cost_table() { # method
  echo "Processor time of the same shots on the page of results, modified law, as it was when each was run, $1:"
  echo
  echo "| nose | plate | shots | the paper's method, s | $1, s | ratio |"
  echo '|---|---|---|---|---|---|'
  awk -F, -v method="$1" '
    NR == 1 { for (k = 1; k <= NF; ++k) if ($k == "cpu_s") cpu = k; next }
    $2 == "mjc" { seconds[$1, $3 "," $4 "," $5, $6] = $cpu; if ($1 == method) shot[++n] = $3 "," $4 "," $5 SUBSEP $6 }
    function row(nose, plate, shots, sfm, other) {
      printf "| %s | %s | %d | %.0f | %.0f | %.2f |\n", nose, plate, shots, sfm, other, other / sfm
    }
    END {
      for (k = 1; k <= n; ++k) {
        if (!(("sfm" SUBSEP shot[k]) in seconds)) continue
        split(shot[k], part, SUBSEP)
        if (!(part[1] in shots)) order[++m] = part[1]
        ++shots[part[1]]
        sfm[part[1]] += seconds["sfm", shot[k]]
        other[part[1]] += seconds[method, shot[k]]
      }
      for (k = 1; k <= m; ++k) {
        split(order[k], name, ",")
        row(name[2], name[3] " mm " name[1], shots[order[k]], sfm[order[k]], other[order[k]])
        all += shots[order[k]]
        all_sfm += sfm[order[k]]
        all_other += other[order[k]]
      }
      if (all > 0) row("all", "", all, all_sfm, all_other)
    }' "$root/docs/results/run_record.csv"
}

cost_tables() {
  cost_table adaptive
  echo
  cost_table stabilised
}

timing_table() { # METHOD=stabilised: of that method
  local method=${METHOD:-adaptive}
  echo "Processor time of one shot with either method, one after the other, one thread, modified law, 0.6 mm:"
  echo
  echo "| nose | plate | initial, m/s | the paper's method, s | $method, s | ratio |"
  echo '|---|---|---|---|---|---|'
  local nose thickness v material name way
  for name in blunt:6:200 blunt:8:215 blunt:10:230 blunt:12:244.2 blunt:16:305 blunt:20:350 conical:12:355.6 \
    ogival:12:355.6 conical:15:270:aa5083_h116; do
    IFS=: read -r nose thickness v material <<< "$name"
    material=${material:-weldox_460e}
    name=${nose}_${material}_${thickness}mm_$v
    for way in sfm "$method"; do
      shoot "timing_${way}_$name" --method "$way" --model mjc --material "$material" --nose "$nose" --threads 1 \
        --thickness-mm "$thickness" --velocity-mps "$v" --spacing-mm 0.6 --no-picture
    done
    [ -e "$folder/timing_${method}_$name/summary.json" ] || continue
    echo "$nose,$thickness mm $material,$v,$(value "timing_sfm_$name" cpu_s),$(value "timing_${method}_$name" cpu_s)"
  done | awk -F, '
    function row(nose, plate, v, sfm, other) {
      printf "| %s | %s | %s | %.0f | %.0f | %.2f |\n", nose, plate, v, sfm, other, other / sfm
    }
    { row($1, $2, $3, $4, $5); sfm += $4; other += $5 }
    END { if (NR > 0) row("all", "", "", sfm, other) }'
}

# all_tables table...: with empty lines between them
all_tables() {
  local table first=yes
  for table in "$@"; do
    [ -n "$first" ] || echo
    first=
    "$table"
  done
}

made_by beyond.sh
case ${PART:-all} in
  limits) all_tables limits_table residuals_table ;;
  stabilised) stabilised_tables ;;
  adaptive) adaptive_tables ;;
  damage) damage_tables ;;
  mesh) mesh_tables ;;
  dishing) dishing_table ;;
  cost) cost_tables ;;
  timing) timing_table ;;
  all)
    all_tables limits_table residuals_table stabilised_tables adaptive_tables damage_tables mesh_tables
    echo
    METHOD=stabilised mesh_tables
    echo
    all_tables dishing_table cost_tables timing_table
    echo
    METHOD=stabilised timing_table
    ;;
  *)
    echo "beyond: error: PART = $PART: must be limits, stabilised, adaptive, damage, mesh, dishing, cost, timing or all" >&2
    exit 2
    ;;
esac
