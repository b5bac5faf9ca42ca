#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# performance.sh [--insert] [--before FILE] [option of bench_step]...: times the steps of a shot and prints the tables of
# docs/performance.md in Markdown; --insert puts them there too, --before compares with the numbers of an earlier version.
# Let nothing else run. All numbers stay in vtk_out/bench/performance.json. bench_step --help lists its options.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
options=()
while [ $# -gt 0 ]; do
  case "$1" in
  --insert) options+=("$1") && shift ;;
  --before) options+=("$1" "${2:?performance: --before needs a file}") && shift 2 ;;
  *) break ;;
  esac
done
"$root/scripts/build.sh" bench_step
numbers=$root/vtk_out/bench/performance.json
mkdir -p "$root/vtk_out/bench"
GOMP_SPINCOUNT="${GOMP_SPINCOUNT:-3000}" "$root/build/release/bench/bench_step" "$@" > "$numbers"
"$root/scripts/results.sh" performance "$numbers" "${options[@]}"
