#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# materials.sh: draws the metals of the library into docs/materials and puts them, with their sources, into
# docs/materials.md.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
ogive=$root/build/release/apps/ogive
folder=$root/docs/materials
"$root/scripts/build.sh" ogive_main
mkdir -p "$folder"
names=$("$ogive" materials list | awk '/^name /{rows = 1; next} rows && NF == 0{exit} rows{print $1}')

# value KEY: the text of a key in the material file on standard input.
value() { sed -n "s/^$1 = \"\(.*\)\"\( *#.*\)\?\$/\1/p"; }

{
  for name in $names; do
    "$ogive" materials show "$name" --plot "$folder/$name.svg" >/dev/null
    rm "$folder/$name".*.csv
    file=$("$ogive" materials show "$name")
    printf '### %s\n\n' "$name"
    printf 'Source: %s.\n\nConfidence: %s.\n\n' "$(value source <<<"$file")" "$(value confidence <<<"$file")"
    printf '![Flow curves and failure strain of %s](materials/%s.svg)\n\n' "$name" "$name"
  done
} | "$root/scripts/results.sh" insert "$root/docs/materials.md" --mark 'tables: scripts/materials.sh'
