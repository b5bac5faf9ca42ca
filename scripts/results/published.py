"""What is known of a campaign, where the programs of the figures find it: shots_published.csv from a page, with the projectiles'
masses and the pictures beside it, and shots_kept.csv, the rows that are kept in bench/rows/figures from one machine to the
next, with the pictures, whose frames are not kept. Pictures that are there stay. Kept rows and pictures must be deleted after a
change of the method."""

import shutil

from .data import (KEY_COLUMNS, PROJECTILE_COLUMNS, RECORD_COLUMNS, ROOT, SHOT_COLUMNS, InputError, Row, csv_text,
                   read_projectiles, read_shots, read_table, write_text)

KEPT = ROOT / "bench" / "rows" / "figures"


def copy_missing(pictures, folder):
    for picture in sorted(pictures):
        if not (folder / picture.name).exists():
            shutil.copyfile(picture, folder / picture.name)


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
    copy_missing(page.glob("figure_*"), folder)
    print(f"{folder / 'shots_published.csv'}: {len(rows)} shots")


def take_kept(folder):
    """Puts the kept rows and pictures into the folder of a campaign."""
    if (KEPT / "shots.csv").exists():
        folder.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(KEPT / "shots.csv", folder / "shots_kept.csv")
        if not (folder / "projectiles.csv").exists():
            shutil.copyfile(KEPT / "projectiles.csv", folder / "projectiles.csv")
        copy_missing(KEPT.glob("figure_*"), folder)


def keep(folder):
    """Keeps the rows of a campaign, with those that are kept, unless some are those of a page."""
    if list(folder.glob("shots*.csv")) and not (folder / "shots_published.csv").exists():
        rows = read_shots(folder)
        KEPT.mkdir(parents=True, exist_ok=True)
        write_text(KEPT / "shots.csv", csv_text(list(rows[0].text), rows))
        write_text(KEPT / "projectiles.csv", csv_text(PROJECTILE_COLUMNS, read_projectiles(folder)))


def keep_pictures(pictures):
    for picture in pictures:
        shutil.copyfile(picture, KEPT / picture.name)
