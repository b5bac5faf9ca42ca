#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Puts the shots of a page, docs/results for example, where the programs of the figures look for those that are known:
shots_published.csv in the folder of a campaign, with the projectiles' masses and the pictures beside it. Pictures that
are there stay."""

import shutil
import sys
from pathlib import Path

import ogive_results
from ogive_results import InputError, KEY_COLUMNS, RECORD_COLUMNS, Row, csv_text, read_table, write_text


def joined_rows(page):
    """The rows of a campaign again, of which results_page.py made two tables."""
    record = {row.key(KEY_COLUMNS): row for row in read_table(page / "run_record.csv", KEY_COLUMNS + RECORD_COLUMNS)}
    rows = []
    for shot in read_table(page / "results" / "shots.csv", ogive_results.SHOT_COLUMNS):
        if shot.key(KEY_COLUMNS) not in record:
            raise InputError(f"{shot.where}: has no row in {page / 'run_record.csv'}: must have one")
        known = record[shot.key(KEY_COLUMNS)]
        rows.append(Row({**shot.text, **{column: known.text[column] for column in RECORD_COLUMNS}}, shot.where))
    return rows


def main():
    parser = ogive_results.OneLineParser(prog="take_published", description=__doc__)
    parser.add_argument("page", type=Path, help="folder that results_page.py made")
    parser.add_argument("folder", type=Path, help="of a campaign, vtk_out/figures for example")
    o = parser.parse_args()
    rows = joined_rows(o.page)
    if not rows:
        raise InputError(f"{o.page}: holds no shots: must be a page with results")
    write_text(o.folder / "shots_published.csv", csv_text(list(rows[0].text), rows))
    shutil.copyfile(o.page / "results" / "projectiles.csv", o.folder / "projectiles.csv")
    for picture in sorted([*o.page.glob("*.png"), *o.page.glob("*.svg")]):
        if not (o.folder / picture.name).exists():
            shutil.copyfile(picture, o.folder / picture.name)
    print(f"{o.folder / 'shots_published.csv'}: {len(rows)} shots")
    return 0


if __name__ == "__main__":
    sys.exit(ogive_results.run_main("take_published", main))
