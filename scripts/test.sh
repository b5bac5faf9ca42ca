#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test.sh [ctest options]: sets up, builds everything and runs all tests.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/scripts/build.sh"
cd "$root"
exec "$root/scripts/with_display.sh" ctest --preset release --parallel "$(nproc)" "$@"
