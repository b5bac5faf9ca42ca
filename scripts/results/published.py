"""The way back from a page to a campaign: shots_published.csv, where the programs of the figures find the shots that are
known, with the projectiles' masses and the pictures beside it. Pictures that are there stay."""

import shutil

from .data import KEY_COLUMNS, RECORD_COLUMNS, SHOT_COLUMNS, InputError, Row, csv_text, read_table, write_text


def joined_rows(page):
    """The rows of a campaign again, of which the page has two tables."""
    record = {row.key(KEY_COLUMNS): row for row in read_table(page / "run_record.csv", KEY_COLUMNS + RECORD_COLUMNS)}
    for shot in read_table(page / "data" / "shots.csv", SHOT_COLUMNS):
        known = record.get(shot.key(KEY_COLUMNS))
        if known is None:
            raise InputError(f"{shot.where}: has no row in {page / 'run_record.csv'}: must have one")
        yield Row({**shot.text, **{column: known.text[column] for column in RECORD_COLUMNS}}, shot.where)


def take_published(page, folder):
    rows = list(joined_rows(page))
    if not rows:
        raise InputError(f"{page}: holds no shots: must be a page with results")
    write_text(folder / "shots_published.csv", csv_text(list(rows[0].text), rows))
    shutil.copyfile(page / "data" / "projectiles.csv", folder / "projectiles.csv")
    for picture in sorted([*page.glob("*.png"), *page.glob("*.svg")]):
        if not (folder / picture.name).exists():
            shutil.copyfile(picture, folder / picture.name)
    print(f"{folder / 'shots_published.csv'}: {len(rows)} shots")
