#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# coverage.sh [ctest option]...: builds the preset coverage, runs the tests and prints which share of the lines of
# include/ they reach, by file. A template that nothing instantiates has no lines; a header without any is
# named. Needs gcovr (apt-get install gcovr) besides what scripts/setup.sh installs. The exit status is 1 below 90 %.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
if ! command -v gcovr >/dev/null; then
  printf 'coverage: gcovr is missing; as root run\n  apt-get install gcovr\n' >&2
  exit 2
fi
"$root/scripts/setup.sh"
cd "$root"
build=build/coverage
cmake --preset coverage >/dev/null
cmake --build --preset coverage >&2
find "$build" -name '*.gcda' -delete
# Threads that count in the same line of the cache wait for each other; tests of threads ask for their number.
OMP_NUM_THREADS=1 ctest --preset coverage "$@" >&2

table=$(mktemp)
trap 'rm -f "$table"' EXIT
status=0
gcovr "$build" --root "$root" --filter "$root/include/ogive/" --exclude-unreachable-branches --fail-under-line 90 --txt \
  --csv "$table" || status=1
find include/ogive -name '*.hpp' | sort | while IFS= read -r header; do
  grep -q "^$header," "$table" || printf 'no lines: %s\n' "$header"
done
exit "$status"
