#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# figures.sh [--quick] [--page] [--published] [--method NAME] [--jobs N]: runs or resumes all shots of the paper's
# figures, draws them and makes the page docs/results/index.html.
#   --quick        coarse: particles 1.5 mm apart, in vtk_out/figures_quick; the page goes to its folder page/
#   --page         runs no shots; draws what is missing and makes the page
#   --published    takes the shots and pictures of the page as done, which the project holds for the full size, and runs
#                  what it lacks, but no shots for pictures
#   --method NAME  runs the shots with this method, stabilised or adaptive, which adds its curves and pictures [sfm]
#   --jobs N       shots at a time, as many as cores if not given
# What is done already is not done again. Programs that fail do not stop the others; the exit status is then 3, and 2 for
# wrong options. FIGURES, PAGE and PROGRAMS name other folders for the shots, the page and the programs.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

refuse() {
  echo "figures: error: $1" >&2
  exit 2
}
quick="" page_only="" published="" jobs="" method=sfm
while [ $# -gt 0 ]; do
  case $1 in
    --quick) quick=yes ;;
    --page) page_only=yes ;;
    --published) published=yes ;;
    --method)
      [[ ${2:-} =~ ^(sfm|stabilised|adaptive)$ ]] || refuse "--method = ${2:-}: must be sfm, stabilised or adaptive"
      method=$2
      shift
      ;;
    --jobs)
      [[ ${2:-} =~ ^[1-9][0-9]*$ ]] || refuse "--jobs = ${2:-}: must be a whole number from 1"
      jobs=$2
      shift
      ;;
    --help)
      sed -n '3,/^set /{s/^# \{0,1\}//p}' "$0"
      exit 0
      ;;
    *) refuse "$1: unknown option; there are --quick, --page, --published, --method NAME, --jobs N and --help" ;;
  esac
  shift
done

campaigns=(steel_blunt nose_shapes aluminium_conical)
spacing=0.6
figures=vtk_out/figures
page=docs/results
if [ -n "$quick" ]; then
  spacing=1.5
  figures=vtk_out/figures_quick
  page=$figures/page
fi
[ -z "${FIGURES:-}" ] || figures=$(realpath -m "$FIGURES")
[ -z "${PAGE:-}" ] || page=$(realpath -m "$PAGE")
programs=build/release/apps
if [ -n "${PROGRAMS:-}" ]; then
  programs=$(realpath -m "$PROGRAMS")
else
  "$root/scripts/build.sh" perforate calibrate section "${campaigns[@]}"
fi
cd "$root"
# As scripts/run.sh does.
export GOMP_SPINCOUNT="${GOMP_SPINCOUNT:-3000}"

failed=()
# attempt text command [argument]...: goes on if the command fails and remembers it
attempt() {
  local status=0
  "${@:2}" || status=$?
  [ "$status" -eq 0 ] || failed+=("$1 (exit status $status)")
}

[ -z "$published" ] || scripts/take_published.py "$page" "$figures"

campaign() { # name [option]...
  "$programs/$1" ${quick:+--quick} ${published:+--no-pictures} --method "$method" --out "$figures" --spacing-mm "$spacing" "${@:2}"
}
for name in "${campaigns[@]}"; do
  if [ -n "$page_only" ]; then
    attempt "$name" campaign "$name" --no-run > /dev/null
  else
    attempt "$name" campaign "$name" ${jobs:+--jobs "$jobs"}
  fi
done

# fits: Figs. 1 to 3, unless they are newer than the curves and the program
fits() {
  local done_at=$figures/figures_1_to_3/aluminium_power/fit.json
  if [ -e "$done_at" ] && { [ -n "$page_only" ] || [ -z "$(find apps/data "$programs/calibrate" -newer "$done_at" \
    \( -name 'synthetic_*' -o -name calibrate \))" ]; }; then
    return
  fi
  mkdir -p "$figures"
  CALIBRATE=$programs/calibrate bench/figures_1_to_3.sh "$figures/figures_1_to_3" > "$figures/figures_1_to_3.md" ||
    return
  echo "figures 1 to 3: $figures/figures_1_to_3"
}
attempt "figures 1 to 3" fits

# The folder of a shot, as the campaigns name it; those of pictures are of the modified law.
shot() { # method material nose thickness velocity
  local prefix=${1#sfm}
  echo "$figures/shots/${prefix:+${prefix}_}mjc_$2_$3_$4mm_$5mps_${spacing}mm"
}

# times series... -- time...: those times that all the series have frames for, separated by commas
times() {
  local last=() series
  while [ "$1" != -- ]; do
    last+=("$(sed -nE 's/.*timestep="([0-9.eE+-]+)".*/\1/p' "$1/perforation.pvd" | tail -n 1)")
    shift
  done
  shift
  printf '%s\n' "$@" | awk -v ends="${last[*]}" '
    BEGIN { n = split(ends, end, " ") }
    { for (k = 1; k <= n; ++k) if ($1 > end[k]) next; list = list (list == "" ? "" : ",") $1 }
    END { print list }'
}

# draw number[_what] series... -- option...: draws the figure unless it is newer than the series
draw() {
  local picture=$figures/figure_$1.png stale=
  shift
  [ -e "$picture" ] || stale=yes
  while [ "$1" != -- ]; do
    [ ! "$1/perforation.pvd" -nt "$picture" ] || stale=yes
    shift
  done
  shift
  [ -n "$stale" ] || return 0
  mkdir -p "$figures"
  attempt "$picture" scripts/with_display.sh "$programs/section" "$@" --out "$picture"
  [ ! -e "$picture" ] || echo "figure: $picture"
}

# there number series...: whether all series have frames and have ended; says which do not
there() {
  local number=$1 series all=yes
  shift
  for series in "$@"; do
    if [ ! -e "$series/perforation.pvd" ] || [ ! -e "$series/summary.json" ]; then
      echo "figure $number is left out: no shot with frames in $series"
      all=
    fi
  done
  [ -n "$all" ]
}

draw 4 -- --projectiles
draw 5 -- --mesh --thickness-mm 12 --spacing-mm "$spacing" --nose blunt

# pictures method [suffix [text]]: Figs. 7, 8, 10 and 14 with a method
pictures() {
  local method=$1 suffix=${2:-} text=${3:-} at time_us plate pair series labels=() sections=()
  local steel_10 steel_6 aluminium_15
  steel_10=$(shot "$method" weldox_460e blunt 10 180)
  steel_6=$(shot "$method" weldox_460e blunt 6 160)
  if there "7$suffix" "$steel_10"; then
    at=$(times "$steel_10" -- 0 10 20 30 40 50 60 80)
    draw "7$suffix" "$steel_10" -- --series "$steel_10" --times-us "$at" \
      --title "Fig. 7: 10 mm Weldox 460 E, blunt, 180 m/s$text"
    draw "7_temperature$suffix" "$steel_10" -- --series "$steel_10" --times-us "$at" --colour temperature \
      --title "Fig. 7: 10 mm Weldox 460 E, blunt, 180 m/s$text"
  fi
  if there "8$suffix" "$steel_6" "$steel_10"; then
    at=$(times "$steel_6" "$steel_10" -- 0 15 30 45 60)
    for plate in '(a) 6 mm' '(b) 10 mm'; do
      for time_us in ${at//,/ }; do labels+=("$plate, $time_us µs"); done
    done
    draw "8$suffix" "$steel_6" "$steel_10" -- --series "$steel_6" "$steel_10" --times-us "$at" --label "${labels[@]}" \
      --columns $((${#labels[@]} / 2)) --title "Fig. 8: Weldox 460 E, blunt: (a) 6 mm, 160 m/s; (b) 10 mm, 180 m/s$text"
  fi

  labels=()
  for pair in 6:110 8:135 10:160 12:195 16:240 20:310; do
    series=$(shot "$method" weldox_460e blunt "${pair%:*}" "${pair#*:}")
    there "10$suffix" "$series" || continue
    sections+=("$series")
    labels+=("${pair%:*} mm, ${pair#*:} m/s")
  done
  if [ "${#sections[@]}" -eq 6 ]; then
    draw "10$suffix" "${sections[@]}" -- --series "${sections[@]}" --label "${labels[@]}" --columns 3 --times-us last \
      --title "Fig. 10: Weldox 460 E, blunt, last frame$text"
  fi

  aluminium_15=$(shot "$method" aa5083_h116 conical 15 214)
  if there "14$suffix" "$aluminium_15"; then
    at=$(times "$aluminium_15" -- 0 40 80 120 160 200 280 360)
    draw "14$suffix" "$aluminium_15" -- --series "$aluminium_15" --times-us "$at" \
      --title "Fig. 14: 15 mm AA5083-H116, conical, 214 m/s$text"
  fi
}
pictures sfm
for beyond in stabilised adaptive; do
  [ -z "$(compgen -G "$figures/shots/${beyond}_*")" ] || pictures "$beyond" "_$beyond" ", $beyond"
done

attempt page python3 scripts/results_page.py --spacing-mm "$spacing" "$figures" "$page"
for line in "${failed[@]}"; do
  echo "figures: failed: $line" >&2
done
[ "${#failed[@]}" -eq 0 ] || exit 3
