#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# run.sh [COMMAND] [options]: sets up, builds and runs ogive; without a command it shoots. --help lists the options.
# Relative names count from the current folder. The exit status is ogive's.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)

"$root/scripts/build.sh" ogive_main
[[ ${1:-} =~ ^[a-z] ]] || set -- shoot "$@"
exec "$root/build/release/apps/ogive" "$@"
