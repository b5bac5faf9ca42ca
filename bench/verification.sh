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
trap 'rm -f "$tables" "$tables.page"' EXIT
status=0
"${VERIFICATION:-$root/build/release/bench/verification}" "$@" | tee "$tables" || status=$?
# Lines that are off belong into the page too; wrong input or a crash do not.
[ -n "$insert" ] && [ "$status" -le 1 ] || exit "$status"

# Each table stands between two lines that name it. What was not computed stays as it was.
page=$root/docs/verification.md
awk -v tables="$tables" '
  function is_mark(line) { return line ~ /^<!-- table: [a-z_]+ \(bench\/verification.sh\) -->$/ }
  BEGIN {
    while ((getline line < tables) > 0)
      if (is_mark(line)) inside = inside == "" ? line : ""
      else if (inside != "") text[inside] = text[inside] line "\n"
    inside = ""
  }
  is_mark($0) {
    inside = inside == "" ? $0 : ""
    print
    if (inside in text) printf "\n%s\n", text[inside]
    next
  }
  !(inside in text)' "$page" > "$tables.page"
cp "$tables.page" "$page"
exit "$status"
