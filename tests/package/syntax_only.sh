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

arguments=() object=
while [ $# -gt 1 ]; do
  case "$1" in
  -o) object=$2 && shift ;;
  -MF | -MT) shift ;;
  -c | -MD) ;;
  *) arguments+=("$1") ;;
  esac
  shift
done

# Reading Eigen takes most of the time: headers that include it have it from a precompiled header.
before=()
if "${arguments[@]}" -M "$1" | grep -q /Eigen/Core; then
  {
    flock 9
    if ! [ -e eigen.hpp.gch ]; then
      echo '#include <Eigen/Dense>' >eigen.hpp
      "${arguments[@]}" -c -x c++-header eigen.hpp -o eigen.hpp.gch
    fi
  } 9>eigen.lock
  before=(-include eigen.hpp)
fi
"${arguments[@]}" "${before[@]}" -fsyntax-only "$1"
: >"$object"
