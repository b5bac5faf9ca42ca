#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# verification.sh [--insert] [option of verification]...: computes the ladder of docs/verification.md and prints its
# tables in Markdown; --insert puts them there too. The exit status is 1 if a line is off. VERIFICATION names another
# program than that of build/release; verification --help lists its options.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
insert=
if [ "${1:-}" = --insert ]; then
  insert=yes
  shift
fi
[ -n "${VERIFICATION:-}" ] || "$root/scripts/build.sh" verification

# As scripts/run.sh does.
export GOMP_SPINCOUNT="${GOMP_SPINCOUNT:-3000}"

tables=$(mktemp)
trap 'rm -f "$tables"' EXIT
status=0
"${VERIFICATION:-$root/build/release/tests/verification}" "$@" | tee "$tables" || status=$?
# Lines that are off belong into the page too; wrong input or a crash do not.
[ -z "$insert" ] || [ "$status" -gt 1 ] || "$root/scripts/results.sh" insert "$root/docs/verification.md" < "$tables"
exit "$status"
