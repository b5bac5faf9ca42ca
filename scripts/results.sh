#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# results.sh COMMAND [option]...: checks, page, pictures and tables of the results; --help lists the commands.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# Jinja2 and Markdown come from Debian; another Python that is first in the path may lack them.
python=python3
if ! python3 -c 'import jinja2, markdown, tomllib' 2>/dev/null; then
  "$root/scripts/setup.sh"
  python=/usr/bin/python3
fi
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$root/scripts exec "$python" -m results "$@"
