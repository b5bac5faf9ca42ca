#!/usr/bin/env bash
# run.sh [options]: sets up, builds and runs perforate with these options (--help lists them). Relative names count from
# the current folder. The exit status is perforate's.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/scripts/build.sh" perforate

# Threads that wait in a busy loop slow a machine down that has other work.
export OMP_WAIT_POLICY="${OMP_WAIT_POLICY:-passive}"
display=()
# VTK's pictures need a display, even where no window opens.
[ -n "${DISPLAY:-}" ] || display=(xvfb-run -a)
exec "${display[@]}" "$root/build/release/apps/perforate" "$@"
