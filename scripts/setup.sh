#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs the tools and libraries that ogive needs and that are missing, with Debian's or Ubuntu's apt-get.
# Does nothing, and needs neither network nor root, where all are there.
set -euo pipefail

# A command, or - for a library; and the package that brings it.
needed='
g++          g++
cmake        cmake
ninja        ninja-build
gnuplot      gnuplot-nox
python3      python3
-            python3-jinja2
-            python3-markdown
-            libeigen3-dev
-            catch2
-            libcli11-dev
-            libtomlplusplus-dev
-            nlohmann-json3-dev
-            libvtk9-dev
-            libgl1-mesa-dri
-            libegl-dev
-            libjs-three
'

is_installed() {
  [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null || true)" = installed ]
}

if ! command -v dpkg-query >/dev/null; then
  printf 'setup: this is neither Debian nor Ubuntu; install what corresponds to these packages:%s\n' \
    "$(awk 'NF { printf " %s", $2 }' <<<"$needed")" >&2
  exit 0
fi

missing=()
while read -r command package; do
  [ -n "$package" ] || continue
  if [ "$command" = - ]; then
    is_installed "$package" || missing+=("$package")
  else
    command -v "$command" >/dev/null || missing+=("$package")
  fi
done <<<"$needed"
[ "${#missing[@]}" -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    printf 'setup: missing packages, and neither root nor sudo to install them; as root run\n  apt-get install %s\n' \
      "${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

printf 'setup: installing %s\n' "${missing[*]}" >&2
log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y "$@" </dev/null >>"$log" 2>&1; }
if ! { apt update && apt install --no-install-recommends "${missing[@]}"; }; then
  tail -n 30 "$log" >&2
  printf 'setup: apt-get could not install: %s\n' "${missing[*]}" >&2
  exit 1
fi
