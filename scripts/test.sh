#!/usr/bin/env bash
# test.sh [ctest options]: sets up, builds everything and runs all tests.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/scripts/build.sh"

cd "$root"
export OMP_WAIT_POLICY="${OMP_WAIT_POLICY:-passive}"
display=()
# VTK's pictures need a display, even where no window opens.
[ -n "${DISPLAY:-}" ] || display=(xvfb-run -a)
exec "${display[@]}" ctest --preset release "$@"
