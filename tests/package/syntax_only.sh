#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# syntax_only.sh compiler argument... -o object ... source: compiles a file that includes one header of include/ without
# making code. The object is left empty, so that the next build sees that it is up to date.
set -euo pipefail
include=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../include" && pwd)

# A header that another one includes before all else is compiled alone there: nothing comes before it. It gets no object,
# so that the next build looks again. Headers that need VTK do not count, as they are not compiled everywhere.
header=$(sed -n 's/^#include <\(.*\)>.*/#include "\1"/p' "${!#}")
first_includes=$(find "$include" -name '*.hpp' ! -path '*/io/vtk*' ! -path '*/io/read_frame*' -exec awk '
  FNR == 1 { begun = 0 }
  !begun && !/^(\/\/.*|#pragma once|)$/ { begun = 1; print }' {} +)
if grep -qxF "$header" <<<"$first_includes"; then exit; fi

"$@" -fsyntax-only
while [ "$1" != -o ]; do shift; done
: > "$2"
