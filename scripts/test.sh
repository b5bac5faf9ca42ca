#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test.sh [ctest options]: sets up, builds everything and runs all tests.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)

"$root/scripts/build.sh"
cd "$root"
# As the programs do for themselves.
export GOMP_SPINCOUNT="${GOMP_SPINCOUNT:-3000}"
exec ctest --preset release --parallel "$(nproc)" "$@"
