#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# performance.sh [--insert] [option of bench_step]...: times the steps of a shot and prints the tables of
# docs/performance.md in Markdown; --insert puts them there too. Let nothing else run. BENCH_STEP names another program
# than that of build/release; bench_step --help lists its options.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
insert=
if [ "${1:-}" = --insert ]; then
  insert=yes
  shift
fi
[ -n "${BENCH_STEP:-}" ] || "$root/scripts/build.sh" bench_step

# As scripts/run.sh does.
export GOMP_SPINCOUNT="${GOMP_SPINCOUNT:-3000}"

tables=$(mktemp)
trap 'rm -f "$tables"' EXIT
"${BENCH_STEP:-$root/build/release/bench/bench_step}" "$@" | tee "$tables"
[ -z "$insert" ] || "$root/scripts/insert_tables.py" "$root/docs/performance.md" --mark 'tables: bench/performance.sh' < "$tables"
