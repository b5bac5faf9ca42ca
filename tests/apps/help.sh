#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# help.sh <ogive> <folder>: help, version, the metals and the completion for bash. Works in the folder.
set -euo pipefail

ogive=$1
mkdir -p "$2"
cd "$2"
rm -rf ./*

fail() {
  echo "help.sh: $*" >&2
  exit 1
}

commands=(shoot limit sweep mesh calibrate draw view materials)

echo "ogive alone: every command and three examples"
help=$("$ogive") || fail "status $?"
[ "$help" = "$("$ogive" --help)" ] && [ "$help" = "$("$ogive" -h)" ] || fail "--help prints another text"
for command in "${commands[@]}"; do
  grep -q "^  $command  *[a-z]" <<< "$help" || fail "$command is missing: $help"
done
[ "$(sed -n '/^Examples:/,/^$/p' <<< "$help" | grep -c '^  ogive ')" -eq 3 ] || fail "not three examples: $help"
! grep -q '^   ' <<< "$help" || fail "a command takes two lines: $help"
[ "$(wc -l <<< "$help")" -le 24 ] || fail "does not fit a terminal: $help"
grep -qx 'ogive [0-9]*\.[0-9]*\.[0-9]*' <<< "$("$ogive" --version)" || fail "--version: $("$ogive" --version)"

echo "--help is short and --help-all long, in at most 100 columns"
for command in "${commands[@]}"; do
  grep -qx "ogive $command [0-9.]*" <<< "$("$ogive" "$command" --version)" || fail "$command --version"
  for flag in --help -h --help-all; do
    text=$("$ogive" "$command" "$flag" 2>&1) || fail "$command $flag: status $?"
    head -n 1 <<< "$text" | grep -q "^ogive $command" || fail "$command $flag: $text"
    [ -z "$(awk 'length > 100' <<< "$text")" ] || fail "$command $flag: $(awk 'length > 100' <<< "$text")"
  done
  [ "$("$ogive" "$command" --help | grep -c '^  -')" -le 20 ] || fail "$command --help is long"
done

echo "the metals"
list=$("$ogive" materials)
[ "$list" = "$("$ogive" materials list)" ] || fail "materials: not the list"
grep -q '^weldox_460e ' <<< "$list" || fail "materials list: $list"
for metal in weldox_460e aa5083_h116 aa5083_h116_25mm; do
  for model in mjc jc; do
    "$ogive" materials show "$metal" --model "$model" > metal.toml || fail "materials show $metal: status $?"
    checked=$("$ogive" materials check metal.toml)
    [ "$checked" = "metal.toml: $metal, model $model, is a metal for --material" ] || fail "materials check: $checked"
    cmp <("$ogive" materials show metal.toml | tail -n +2) <(tail -n +2 metal.toml) || fail "$metal: reads back as another"
  done
done

echo "completion"
code=$("$ogive" completion)
bash -n <<< "$code" || fail "completion is no bash"
eval "$code"

# completes <expected> <word>...: what the last word becomes, one a line
completes() {
  COMP_WORDS=(ogive "${@:2}")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  COMPREPLY=()
  _ogive || true # 1 without a match
  [ "${COMPREPLY[*]}" = "$1" ] || fail "${*:2} becomes ${COMPREPLY[*]} instead of $1"
}
completes "shoot sweep" s
completes "completion" comp
completes "--thickness-mm" shoot --thick
completes "--thickness-mm" limit --quiet --thick
completes "blunt conical ogival hemispherical chisel sphere profile mesh" shoot --nose ""
completes "conical chisel" shoot --nose c
completes "aa5083_h116 aa5083_h116_25mm" mesh --material aa50
completes "--no-vtk" shoot --no-v
completes "--config" shoot --conf
completes "--help --help-all" sweep --hel
completes "--width-mps" limit --wid
completes "" shoot --width
completes "" nothing --thick
grep -q -- '-F _ogive ogive' <<< "$(complete -p ogive)" || fail "completion is not set: $(complete -p)"
for command in "${commands[@]}"; do
  COMP_WORDS=(ogive "$command" --) COMP_CWORD=2
  _ogive || true # 1 without a match
  listed=$(printf '%s\n' "${COMPREPLY[@]}" | grep -v -e '^--no-' | sort)
  helped=$("$ogive" "$command" --help-all | sed -n 's/^  \(--[a-z0-9-]*\).*/\1/ip' | sort)
  [ "$listed" = "$helped" ] || fail "$command: completion and --help-all differ: $(diff <(echo "$listed") <(echo "$helped"))"
done
