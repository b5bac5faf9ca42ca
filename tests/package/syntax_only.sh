#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# syntax_only.sh compiler argument... -o object ...: compiles without making code. The object is left empty, so that the
# next build sees that it is up to date.
set -euo pipefail
"$@" -fsyntax-only
while [ "$1" != -o ]; do shift; done
: > "$2"
