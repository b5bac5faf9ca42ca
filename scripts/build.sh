#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# build.sh [target]...: sets up, configures and builds the release preset; says nothing where nothing is to be done.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

cd "$root"
# Another user's clone is taken as it was built.
[ ! -e build/release/apps/ogive ] || [ -w build/release ] || exit 0
"$root/scripts/setup.sh"
# A build folder that was moved still has the names of the folder that it was made in.
made_in=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' build/release/CMakeCache.txt 2>/dev/null || true)
[ -z "$made_in" ] || [ "$made_in" -ef "$root" ] || rm -rf build/release
if [ ! -e build/release/build.ninja ]; then
  cmake --preset release >&2
fi
targets=()
[ $# -eq 0 ] || targets=(--target "$@")
# Standard output belongs to the program that is run next.
cmake --build --preset release "${targets[@]}" 2>&1 |
  { grep --line-buffered -v -e '^ninja: no work to do' -e 'Re-checking globbed directories' || true; } >&2
