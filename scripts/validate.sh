#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# validate.sh [option]...: runs or resumes all comparisons with tests, puts their tables into docs/ and the README and
# draws measured and computed limits; --help lists the options.
exec "$(dirname "${BASH_SOURCE[0]}")/results.sh" validate "$@"
