#!/usr/bin/env bash
# with_display.sh command [argument]...: runs the command, with a virtual display where there is no other: VTK draws
# only with one, though no window opens. The exit status is the command's.
set -euo pipefail

# Threads that wait in a busy loop slow a machine down that has other work.
export OMP_WAIT_POLICY="${OMP_WAIT_POLICY:-passive}"

if [ -n "${DISPLAY:-}" ]; then
  exec "$@"
fi
# Without -noreset the server restarts whenever its last window closes, and the next one may find it away.
exec xvfb-run -a -s "-screen 0 1280x1024x24 -nolisten tcp -noreset" "$@"
