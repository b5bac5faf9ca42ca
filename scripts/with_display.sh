#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# with_display.sh command [argument]...: runs the command, with a virtual display where there is no other: VTK draws
# only with one, though no window opens. The exit status is the command's.
set -euo pipefail

# Threads that wait long in a busy loop slow a machine down that has other work; threads that sleep at once wake up
# late, a tenth of a step on two cores. A short loop is neither.
export GOMP_SPINCOUNT="${GOMP_SPINCOUNT:-3000}"

if [ -n "${DISPLAY:-}" ]; then
  exec "$@"
fi
# Without -noreset the server restarts whenever its last window closes, and the next one may find it away.
exec xvfb-run -a -s "-screen 0 1280x1024x24 -nolisten tcp -noreset" "$@"
