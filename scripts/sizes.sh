#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# sizes.sh: lines (wc -l) of apps, scripts + bench and include; tables and lists of cases (*.csv, apps/data) and CMake
# files beside them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

lines() { git ls-files -z -- "$@" | xargs -0 -r cat | wc -l; }
for folders in apps 'scripts bench' include; do # shellcheck disable=SC2086 # several words
  code=$(lines $folders ':!*.csv' ':!apps/data' ':!*CMakeLists.txt' ':!*.cmake')
  printf '%-16s %6d lines, %5d of data and CMake beside them\n' "$folders" "$code" $(($(lines $folders) - code))
done
