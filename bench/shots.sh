# Sourced by the other scripts here: runs shots once and reads their summaries. Needs `folder`. PERFORATE names another
# program than that of build/release.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
[ -n "${PERFORATE:-}${READ_ONLY:-}" ] || "$root/scripts/build.sh" perforate
mkdir -p "$folder"

# value name key: a value of the shot's summary
value() { sed -nE "s/^  \"$2\": \"?([^\",]*)\"?,?\$/\1/p" "$folder/$1/summary.json"; }

# shoot name [option of perforate]...: runs the shot unless its summary is there
shoot() {
  local name=$1
  shift
  [ -e "$folder/$name/summary.json" ] && return
  [ -n "${READ_ONLY:-}" ] && return
  "$root/scripts/with_display.sh" "${PERFORATE:-$root/build/release/apps/perforate}" --quiet --no-vtk \
    --out "$folder/$name" "$@" > "$folder/$name.log" 2>&1 || {
    echo "$name ended with status $?: see $folder/$name.log" >&2
    rm -f "$folder/$name/summary.json" # no row, and the next call tries again
  }
}

# number name key format [factor]: a value, formatted; a dash where there is none
number() {
  local found
  found=$(value "$1" "$2")
  if [ -z "$found" ] || [ "$found" = null ]; then printf -- '–'; else awk "BEGIN { printf \"$3\", $found * ${4:-1} }"; fi
}

# test_velocity name: of a measured shot; in brackets where it lies on the curve through the measured limit
test_velocity() {
  local format=%.1f
  if grep -qs '"test_origin": "Recht' "$folder/$1/summary.json"; then format='(%.1f)'; fi
  number "$1" test_residual_velocity_mps "$format"
}

# row name text: one line of the table
row() {
  [ -e "$folder/$1/summary.json" ] || return 0
  echo "| $2 | $(number "$1" initial_velocity_mps %.1f) | $(test_velocity "$1") |" \
    "$(number "$1" residual_velocity_mps %.1f) | $(number "$1" plug_mass_g %.1f) |" \
    "$(number "$1" energy_error %.3f 100) | $(number "$1" largest_intrusion_mm %.3f) |" \
    "$(number "$1" momentum_error %.0e) | $(value "$1" steps) |"
}

table() {
  echo '| case | initial, m/s | test, m/s | computed, m/s | plug, g | energy error, % | intrusion, mm | momentum error | steps |'
  echo '|---|---|---|---|---|---|---|---|---|'
}

# made_by script: says where the numbers come from
made_by() {
  echo "Made by \`bench/$1\` with ogive $(sed -nE 's/.*version\[\] = "(.*)".*/\1/p' "$root/include/ogive/version.hpp")" \
    "on $(nproc) cores. Tests in brackets: no measured shot but the curve of Recht and Ipson through the measured limit, which" \
    "is known to 5 m/s; just above it the curve says little."
  echo
}
