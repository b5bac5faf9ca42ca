#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# accept.sh [folder]: holds the results in docs/results, or in the folder of a campaign, against
# docs/results/acceptance.toml; --help lists the options. Exit status 1 if a check fails or lacks its data.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

command -v python3 >/dev/null || "$root/scripts/setup.sh"
exec python3 "$root/scripts/accept.py" "$@"
