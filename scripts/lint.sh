#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# lint.sh [file or folder]...: clang-format and clang-tidy over these sources, or over all of include/, instances/, apps/, tests/,
# bench/ and examples/. Headers are read together in one translation unit: one for each would parse Eigen and VTK again and again.
# Needs clang-format, clang-tidy and libomp-dev (Debian 12 has version 14), and what scripts/setup.sh installs. The exit
# status is 1 if there is a finding.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
for tool in clang-format clang-tidy cmake; do
  command -v "$tool" >/dev/null && continue
  printf 'lint: %s is missing; as root run\n  apt-get install clang-format clang-tidy libomp-dev\n' "$tool" >&2
  exit 2
done

[ $# -gt 0 ] || set -- "$root"/{include,instances,apps,tests,bench,examples}
mapfile -t files < <(realpath "$@" | xargs -I {} find {} \( -name '*.hpp' -o -name '*.cpp' \) -not -path '*/package/*' | sort)
status=0
clang-format --dry-run -Werror "${files[@]}" || status=1

# The commands of all programs as Clang takes them.
build=$root/build/lint
cmake -S "$root" -B "$build" -G Ninja -D CMAKE_BUILD_TYPE=Debug -D CMAKE_EXPORT_COMPILE_COMMANDS=ON \
  -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON -D CMAKE_C_COMPILER=clang -D CMAKE_CXX_COMPILER=clang++ >/dev/null

mapfile -t sources < <(printf '%s\n' "${files[@]}" | grep '\.cpp$')
mapfile -t headers < <(printf '%s\n' "${files[@]}" | grep '\.hpp$')
tidy() { clang-tidy --quiet "$@" 2> >(grep -vE '^[0-9]+ warnings? (treated|generated)|^Suppressed|^Use -header' >&2 || true); }
export -f tidy
if [ "${#headers[@]}" -gt 0 ]; then
  all=$build/all_headers.cpp
  printf '#include "%s"\n' "${headers[@]}" >"$all"
  vtk=$(find /usr/include -maxdepth 1 -name 'vtk-*' | sed 's/^/-isystem /')
  # shellcheck disable=SC2086 # several words
  tidy "$all" -- -std=c++20 -fopenmp -I"$root/include" -I"$root/apps" -I"$root/tests" \
    -I"$root/tests/fem" -isystem /usr/include/eigen3 $vtk || status=1
fi
if [ "${#sources[@]}" -gt 0 ]; then
  printf '%s\0' "${sources[@]}" |
    xargs -0 -n 1 -P "${LINT_JOBS:-$(nproc)}" bash -c 'tidy -p "$0" "$1"' "$build" || status=1
fi
exit "$status"
