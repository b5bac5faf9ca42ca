#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# figures.sh [option]...: runs or resumes all shots of the paper's figures, draws them and makes the page
# docs/results/index.html; --help lists the options. Exit status 3 if a part fails, 2 for wrong options.
exec "$(dirname "${BASH_SOURCE[0]}")/results.sh" figures "$@"
