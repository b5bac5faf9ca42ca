#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# sizes.sh: lines of the files in apps, scripts + bench and include, tests aside. Tables of tests (apps/data) and lists of
# cases count with the rest.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

lines() { # folder...
  printf '%-18s %6d lines in %d files\n' "$(printf '%s + ' "$@" | sed 's/ + $//')" \
    "$(git ls-files -z -- "$@" | xargs -0 cat | wc -l)" "$(git ls-files -- "$@" | wc -l)"
}
lines apps
lines scripts bench
lines include
