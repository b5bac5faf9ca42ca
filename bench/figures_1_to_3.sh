#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# figures_1_to_3.sh [folder [folder for pictures]]: fits the laws to the computed curves in apps/data, the counterpart of
# Liu et al. 2012, Fig. 1 to 3. Prints tables in Markdown beside the paper's Tables 1 and 2 and, if a second folder is
# given, copies the pictures there. CALIBRATE names another program than that of build/release.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
folder=${1:-$root/build/figures_1_to_3}
pictures=${2:-}
[ -n "${CALIBRATE:-}" ] || "$root/scripts/build.sh" calibrate
calibrate=${CALIBRATE:-$root/build/release/apps/calibrate}
mkdir -p "$folder"

weldox=(--data "$root/apps/data/synthetic_weldox_460e.csv" --name 'Weldox 460 E computed' --melting-K 1800
  --density 7850 --specific-heat 452 --young-GPa 200 --poisson 0.33 --leave-out-from-K 473 --leave-out-to-K 673
  --predict-rates-per-s 0.0015,4.44,21.6,577)
aluminium=(--data "$root/apps/data/synthetic_aa5083_h116.csv" --name 'AA5083-H116 computed' --melting-K 893
  --density 2700 --specific-heat 910 --young-GPa 70 --poisson 0.3)

# fit name [option]...: one calibration
fit() { "$calibrate" --out "$folder/$1" "${@:2}" > "$folder/$1.log"; }

# The numbers of fit.json: "A_MPa", or "standard_error A_MPa" within an object. The first occurrence counts.
value() { # name key [object]
  sed -n "$([ -z "${3:-}" ] && echo 1 || echo "/^ *\"$3\": {/"),\$p" "$folder/$1/fit.json" |
    sed -nE "s/^ *\"$2\": ([^,]*),?\$/\1/p" | sed -n 1p
}
with_error() { # name key format
  printf "$3 ± $3" "$(value "$1" "$2")" "$(value "$1" "$2" standard_error)"
}
row() { # text name third fifth
  echo "| $1 | $(with_error "$2" A_MPa %.1f) | $(with_error "$2" B_MPa %.1f) | $(with_error "$2" "$3" %.4f) |" \
    "$(with_error "$2" C %.5f) | $(with_error "$2" "$4" %.4f) | $(printf %.2f "$(value "$2" rms_percent)") |"
}
plain() { # name text: all parameters at once
  local numbers=() key
  for key in A_MPa B_MPa a C b; do numbers+=("$(value "$1" "$key" simultaneous)"); done
  printf '| %s | %.1f | %.1f | %.4f | %.5f | %.4f | %.2f |\n' "$2" "${numbers[@]}" \
    "$(value "$1" rms_percent simultaneous)"
}
table() {
  echo '| | A, MPa | B, MPa | a (n) | C | b (m) | rms, % |'
  echo '|---|---|---|---|---|---|---|'
}

fit weldox "${weldox[@]}" --simultaneous
fit weldox_isothermal "${weldox[@]}" --isothermal
fit weldox_power "${weldox[@]}" --model jc --rate-factor power --reference-rate-per-s 5e-4
fit weldox_logarithmic "${weldox[@]}" --model jc --reference-rate-per-s 5e-4
fit aluminium "${aluminium[@]}"
fit aluminium_isothermal "${aluminium[@]}" --isothermal
fit aluminium_power "${aluminium[@]}" --model jc --rate-factor power --reference-rate-per-s 1

echo "Made by \`bench/figures_1_to_3.sh\` with ogive $(value weldox version | tr -d '"')."
echo
echo 'Weldox 460 E:'
echo
table
echo '| paper, Table 1 | 503 | 581 | 0.481 | 0.01 | 0.94 | |'
row 'MJC' weldox a b
printf '| MJC at 7.4e-4 1/s (Fig. 1a read as it stands) | %.1f | %.1f | %.4f | | | |\n' \
  "$(value weldox A_MPa quasi_static)" "$(value weldox B_MPa quasi_static)" "$(value weldox a)"
plain weldox 'MJC, all parameters at once'
row 'MJC, `--isothermal`' weldox_isothermal a b
row 'JC, power rate factor' weldox_power n m
echo '| law that made the curves | 490 | 383 | 0.45 | 0.0123 | 0.94 | |'
row 'JC, logarithmic rate factor' weldox_logarithmic n m
echo
echo 'AA5083-H116, A, B and a of the 15 mm plate:'
echo
table
echo '| paper, Table 2 | image | image | image | 0.0114 | 0.56 | |'
row 'MJC' aluminium a b
row 'MJC, `--isothermal`' aluminium_isothermal a b
row 'JC, power rate factor' aluminium_power n m
echo '| law that made the curves | 167 | 596 | 0.551 | 0.001 | 0.859 | |'

if [ -n "$pictures" ]; then
  mkdir -p "$pictures"
  for name in hardening rate_exponent thermal_exponent prediction; do
    cp "$folder/weldox/$name.svg" "$pictures/weldox_$name.svg"
  done
  cp "$folder/aluminium/plates.svg" "$pictures/aluminium_plates.svg"
fi
