#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# accept.sh [folder]: compares the results in docs/results, or in the folder of a campaign, with the checks in
# docs/results/acceptance*.toml; --help lists the options. Exit status 1 if a check fails or lacks its data.
exec "$(dirname "${BASH_SOURCE[0]}")/results.sh" accept "$@"
