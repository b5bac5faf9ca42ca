#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# fuzz.sh [--runs N] [target]...: builds the preset fuzz and tries each reader, or those that are named, with N inputs
# (1,000,000 unless said otherwise) that libFuzzer makes from the seeds in tests/fuzz/seeds. What a target learns stays in
# build/fuzz/corpus and is where the next run begins. An input that a reader crashes, hangs or takes too much memory on
# is left in build/fuzz/found: mend the reader and keep the input with the seeds, which ctest tries. Needs clang and
# libomp-dev besides what scripts/setup.sh installs. Exit status 1 if such an input was found.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
runs=1000000
targets=()
while [ $# -gt 0 ]; do
  case "$1" in
  --runs)
    runs=${2:-}
    if ! [[ $runs =~ ^[1-9][0-9]{0,11}$ ]]; then
      printf 'fuzz: error: --runs = %s: must be a whole number from 1 on\n' "$runs" >&2
      exit 2
    fi
    shift 2
    ;;
  *)
    if ! [ -d "$root/tests/fuzz/seeds/$1" ]; then
      printf 'fuzz: error: target = %s: must be one of %s\n' "$1" "$(ls "$root/tests/fuzz/seeds" | paste -sd " ")" >&2
      exit 2
    fi
    targets+=("$1")
    shift
    ;;
  esac
done
if ! command -v clang++ >/dev/null; then
  printf 'fuzz: clang++ is missing; as root run\n  apt-get install clang libomp-dev\n' >&2
  exit 2
fi
[ "${#targets[@]}" -gt 0 ] || mapfile -t targets < <(ls "$root/tests/fuzz/seeds")

"$root/scripts/setup.sh"
cd "$root"
cmake --preset fuzz >/dev/null
cmake --build --preset fuzz >&2

# A model of a few particles is slower on several threads; memory that was freed is kept from use for a while only.
export OMP_NUM_THREADS=1 ASAN_OPTIONS=quarantine_size_mb=16
mkdir -p build/fuzz/found
status=0
for target in "${targets[@]}"; do
  corpus=build/fuzz/corpus/$target
  mkdir -p "$corpus"
  log=build/fuzz/$target.log
  begun=$SECONDS
  # No reader may need more than a few times the largest file that it takes, nor long.
  if "build/fuzz/tests/fuzz_$target" -runs="$runs" -max_len=4096 -timeout=10 -malloc_limit_mb=64 -rss_limit_mb=1024 \
    -artifact_prefix="build/fuzz/found/$target-" "$corpus" "tests/fuzz/seeds/$target" >"$log" 2>&1; then
    printf '%-18s %s, %d s\n' "$target" "$(sed -n 's/^Done \([0-9]*\) runs.*/\1 inputs/p' "$log")" $((SECONDS - begun))
  else
    status=1
    printf '%-18s failed, see %s\n' "$target" "$log"
    grep -E '^(SUMMARY|must hold|Test unit written|==[0-9]+== ERROR)|runtime error' "$log" || tail -n 3 "$log"
  fi
done
exit "$status"
