# SPDX-License-Identifier: BSD-3-Clause
"""Checks, page, pictures and tables of the results: what scripts/results.sh runs."""
