#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# run.sh [options]: sets up, builds and runs perforate with these options (--help lists them). Relative names count from
# the current folder. The exit status is perforate's.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/scripts/build.sh" perforate
exec "$root/scripts/with_display.sh" "$root/build/release/apps/perforate" "$@"
