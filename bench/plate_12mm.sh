#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# plate_12mm.sh [folder]: the four measured shots on 12 mm Weldox 460 E with a blunt nose, as the default case, with a
# rigid projectile, with the standard form and with the cubic lattice; a hemispherical nose, which the paper does not
# have. Shots that the folder holds already are not run again. Prints a table in Markdown.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=${1:-$here/../vtk_out/plate_12mm}
source "$here/shots.sh"

velocities=(200.4 244.2 303.5 399.6)
four() { # name text [option]...
  local name=$1 text=$2 v
  shift 2
  for v in "${velocities[@]}"; do
    shoot "${name}_$v" --velocity-mps "$v" "$@"
    row "${name}_$v" "$text"
  done
}
one() { # name text [option]...
  shoot "$1" "${@:3}"
  row "$1" "$2"
}

made_by plate_12mm.sh
table
four ring 'ring lattice'
four rigid 'rigid projectile' --projectile rigid
four standard 'standard form' --form standard
four cubic 'cubic lattice' --lattice cubic
one hemispherical 'hemispherical nose' --nose hemispherical --velocity-mps 355.6
