#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# build.sh [target]...: sets up, configures and builds the release preset; says nothing where nothing is to be done.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

"$root/scripts/setup.sh"
cd "$root"
if [ ! -e build/release/build.ninja ]; then
  cmake --preset release >&2
fi
targets=()
[ $# -eq 0 ] || targets=(--target "$@")
# Standard output belongs to the program that is run next.
cmake --build --preset release "${targets[@]}" 2>&1 |
  { grep --line-buffered -v -e '^ninja: no work to do' -e 'Re-checking globbed directories' || true; } >&2
