#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# sensitivity.sh [folder]: what the choices that the paper leaves open do to one shot (12 mm, blunt, 303.5 m/s, particles
# 1 mm apart), what the particle distance does to three plates, what moves two plates near their limit, where the method
# is too weak, and what friction and the aluminium's A, B and a do to conical noses. Shots that the folder holds already
# are not run again. Prints tables in Markdown.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=${1:-$here/../vtk_out/sensitivity}
source "$here/shots.sh"

one() { # name text [option]...
  shoot "$1" --spacing-mm 1 "${@:3}"
  row "$1" "$2"
}

made_by sensitivity.sh
table
one base 'as it is, 1 mm'
one spacing_1.2 'particle distance 1.2 mm' --spacing-mm 1.2
one spacing_0.8 'particle distance 0.8 mm' --spacing-mm 0.8
one cubic 'cubic lattice' --lattice cubic
one rigid 'rigid projectile' --projectile rigid
one standard 'standard form' --form standard
one wendland 'Wendland C2 kernel' --kernel wendland_c2
one variable 'variable smoothing length' --smoothing variable
one b_bar 'hexes with 2×2×2 points' --element selective_reduced
one jc 'classical Johnson–Cook' --model jc
one damage_jc 'damage by Eq. 4, failed particles without tension' --damage jc
one damage_jc_removal 'the same, failed particles removed' --damage jc --failure removal
one damage_cl 'damage by Cockcroft–Latham, failed particles without tension' --damage cockcroft_latham
one mie_gruneisen 'Mie–Grüneisen pressure' --pressure mie_gruneisen
one radius_18 'disc of particles 18 mm in radius' --sph-radius-mm 18
one clamp_150 'clamp at 150 mm' --clamp-radius-mm 150
one friction 'friction 0.1' --friction 0.1
one contact_0.02 'contact stiffness 0.02 (0.1)' --contact-stiffness 0.02
one contact_0.3 'contact stiffness 0.3 (0.1)' --contact-stiffness 0.3
one alpha_0.03 'linear viscosity 0.03 (0.06)' --linear-viscosity 0.03
one alpha_0.2 'linear viscosity 0.2 (0.06)' --linear-viscosity 0.2
one beta_0.5 'quadratic viscosity 0.5 (1.5)' --quadratic-viscosity 0.5
one beta_3 'quadratic viscosity 3 (1.5)' --quadratic-viscosity 3
# The rate floor belongs to the metal.
for floor in 0.001 100; do
  [ -e "$folder/floor_$floor.toml" ] || [ ! -e "$folder/base/material.toml" ] ||
    sed -E "s/^(rate_floor_per_s = )[^ ]+/\1$floor/" "$folder/base/material.toml" > "$folder/floor_$floor.toml"
  one "floor_$floor" "smallest rate $floor/s (1/s)" --material "$folder/floor_$floor.toml"
done

echo
echo 'Particle distance, three plates:'
echo
table
for shot in 6:160 12:224.7 12:303.5 20:335; do
  for spacing in 1.2 0.9 0.6 0.45; do
    thickness=${shot%:*} velocity=${shot#*:}
    shoot "${thickness}mm_${velocity}_$spacing" --thickness-mm "$thickness" --velocity-mps "$velocity" --spacing-mm "$spacing"
    row "${thickness}mm_${velocity}_$spacing" "$thickness mm, particle distance $spacing mm"
  done
done

# near name text [option]...: both plates not far above the limits of the tests, 154.3 and 236.9 m/s
near() {
  shoot "near_8mm_$1" --thickness-mm 8 --velocity-mps 180 --spacing-mm 0.8 "${@:3}"
  row "near_8mm_$1" "8 mm, $2"
  shoot "near_16mm_$1" --thickness-mm 16 --velocity-mps 265 --spacing-mm 0.8 "${@:3}"
  row "near_16mm_$1" "16 mm, $2"
}
echo
echo 'Two plates near the limits of the tests, particles 0.8 mm apart:'
echo
table
near base 'as it is'
near bonds 'bonds against zero-energy modes, 0.3' --control-stiffness 0.3
near bonds_0.1 'bonds against zero-energy modes, 0.1' --control-stiffness 0.1
near cubic 'cubic lattice' --lattice cubic
near standard 'standard form' --form standard
near wendland 'Wendland C2 kernel' --kernel wendland_c2
near rigid 'rigid projectile' --projectile rigid
near friction 'friction 0.1' --friction 0.1
near contact_0.3 'contact stiffness 0.3 (0.1)' --contact-stiffness 0.3
near alpha_0.2 'linear viscosity 0.2 (0.06)' --linear-viscosity 0.2
near radius_36 'disc of particles 36 mm in radius (24)' --sph-radius-mm 36
near b_bar 'hexes with 2×2×2 points' --element selective_reduced
near jc 'classical Johnson–Cook' --model jc
near damage_jc 'damage by Eq. 4, failed particles without tension' --damage jc

sharp() { # name text [option]...
  shoot "$1" --nose conical --spacing-mm 1.2 "${@:3}"
  row "$1" "$2"
}
echo
echo 'Conical nose, particles 1.2 mm apart:'
echo
table
sharp conical 'steel, 12 mm' --velocity-mps 355.6
for friction in 0 0.04 0.12; do
  sharp "conical_friction_$friction" "steel, 12 mm, friction $friction" --velocity-mps 355.6 --friction "$friction"
done
aluminium=(--material aa5083_h116 --thickness-mm 15 --velocity-mps 270)
sharp aluminium 'aluminium, 15 mm' "${aluminium[@]}"
for friction in 0 0.04 0.12; do
  sharp "aluminium_friction_$friction" "aluminium, 15 mm, friction $friction" "${aluminium[@]}" --friction "$friction"
done
for key in A_MPa B_MPa a; do
  for factor in 0.9 1.1; do
    changed=$folder/${key}_$factor.toml
    [ -e "$changed" ] || [ ! -e "$folder/aluminium/material.toml" ] ||
      awk -v key="$key" -v factor="$factor" '$1 == key { $3 *= factor } { print }' \
        "$folder/aluminium/material.toml" > "$changed"
    # A metal from a file has a friction of its own.
    sharp "aluminium_${key}_$factor" "aluminium, 15 mm, ${key%_MPa} times $factor" "${aluminium[@]}" \
      --material "$changed" --friction 0.02
  done
done
