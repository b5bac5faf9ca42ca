#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# completion.sh <file>: whether bash completes commands, options and names with that script.
set -euo pipefail
# shellcheck disable=SC1090 # the file is the argument
source "$1"

# completes <expected words> <word>...: the last word is completed.
completes() {
  local expected=$1
  shift
  COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
  _ogive || true # compgen fails where nothing fits
  [ "${COMPREPLY[*]}" = "$expected" ] && return
  printf 'completion: %s: gives "%s": must give "%s"\n' "$*" "${COMPREPLY[*]}" "$expected" >&2
  exit 1
}

completes shoot ogive sh
completes --thickness-mm ogive shoot --thick
completes conical ogive limit --nose con
completes '--times-us' ogive draw --times
completes '' ogive shoot --no-such-option
