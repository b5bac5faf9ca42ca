"""scripts/results: a page of made-up results, and the rows that campaigns keep."""

import re
import unittest
from unittest import mock

from made_up import LIMITS, SCRIPTS, SHOT_HEADER, SHOTS, Folders, run
from results import published
from results.data import read_shots


class Page(Folders):
    BEYOND = SCRIPTS.parent / "docs" / "results" / "acceptance_beyond.toml"

    def page(self, folder, out):
        done = run("page", folder, out, "--checks", self.checks, "--checks", self.BEYOND)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def test_tables_and_page(self):
        out = self.folder / "page"
        (self.folder / "figure_6.svg").write_text("<svg/>")
        self.page(self.folder, out)
        text = (out / "index.html").read_text()
        self.assertIn('<span class="status good">agrees</span>', text)
        self.assertIn("<li>Against the tests: 2 agree</li>", text)
        self.assertIn("<li>Against the paper: 1 not run yet</li>", text)
        figure = text[text.index('<h2 id="figure_9">'):text.index('<h2 id="figure_10">')]
        self.assertRegex(figure, r"against the tests</dt><dd>.*agrees</span>.*-1.36 %, bound: within 6 %")
        self.assertRegex(figure, r"what is seen</dt><dd>–")
        self.assertIn("Limits are known to 5 m/s", text[text.index('<h2 id="acceptance">'):])
        self.assertIn("@media print", text)
        self.assertNotIn("modified law, ours", text)
        self.assertIn('<img src="figure_6.svg"', text)
        self.assertIn("1 passed, 2 failed", text)
        self.assertNotRegex(text, r'(src|href)="(http:|//|/)')
        self.assertNotIn("<script", text)
        rows = (out / "data" / "shots.csv").read_text().splitlines()
        self.assertEqual(rows[0].split(",")[-1], "particles")
        self.assertEqual(rows[2], "paper,mjc,weldox_460e,blunt,12,184,0.6,31.25,1,11,0.0002,0,25820")
        self.assertIn("wall_s", (out / "run_record.csv").read_text())
        (self.folder / "figure_6.svg").unlink()
        self.page(self.folder, out)
        self.assertFalse((out / "figure_6.svg").exists())

    def test_order_parts_and_times_leave_no_trace_in_the_tables(self):
        self.page(self.folder, self.folder / "page")
        other = self.folder.parent / "other"
        other.mkdir()
        (other / "nose_shapes_limits.csv").write_text(LIMITS)
        (other / "limits.csv").write_text(LIMITS)
        (other / "shots.1-of-2.csv").write_text("\n".join(
            [SHOT_HEADER, SHOTS[2].replace(",10,1,", ",77,2,"), SHOTS[0], "paper,mjc,weldox_460e,bl"]))
        (other / "shots.2-of-2.csv").write_text("\n".join([SHOT_HEADER, SHOTS[1], SHOTS[0], ""]))
        self.page(other, other / "page")
        for name in ("shots.csv", "limits.csv", "projectiles.csv", "fits.csv"):
            self.assertEqual((self.folder / "page" / "data" / name).read_bytes(),
                             (other / "page" / "data" / name).read_bytes(), name)
        # A page's own tables are results, too.
        again = run("accept", other / "page" / "data", "--checks", self.checks)
        self.assertEqual(again.stdout, self.accept().stdout)

    def test_masses_come_from_the_summaries(self):
        for name in ("paper_mjc_weldox_460e_blunt_12mm_184mps_0.6mm", "paper_mjc_weldox_460e_blunt_12mm_303.5mps_0.6mm"):
            (self.folder / "shots" / name).mkdir(parents=True)
            (self.folder / "shots" / name / "summary.json").write_text(
                '{"nose": "blunt", "spacing_mm": 0.59, "projectile_mass_g": 197.25, "added_mass_g": -1e-14, '
                '"fault": null}')
        (self.folder / "shots" / name / "summary.json").write_text('{"nose": "bl')  # being written
        self.page(self.folder, self.folder / "page")
        self.assertEqual((self.folder / "page" / "data" / "projectiles.csv").read_text(),
                         "nose,spacing_mm,projectile_mass_g,added_mass_g\nblunt,0.6,197.250000,0.000000\n")

    def test_older_limits_are_told(self):
        (self.folder / "limits.csv").write_text(LIMITS.replace(",180,184,182,", ",179,184,181.5,"))
        self.assertIn("the limit is older than the shots", self.page(self.folder, self.folder / "page").stderr)

    def test_a_method_beyond_the_paper_has_a_section_and_leaves_the_figures_alone(self):
        page = self.folder / "page" / "index.html"
        self.page(self.folder, page.parent)
        before = page.read_text()
        self.assertNotIn("Beyond the paper", before)
        ours = [row.replace("paper,", "stabilised,", 1).replace(",31.25,", ",35,").replace(",38.8,", ",58.2,")
                for row in SHOTS[:2]]
        (self.folder / "shots.csv").write_text("\n".join([SHOT_HEADER, *SHOTS, *ours, ""]))
        limit = LIMITS.splitlines()[1].replace("paper,", "stabilised,", 1).replace(",184.5,", ",180,")
        (self.folder / "limits.csv").write_text(LIMITS + limit + "\n")
        self.page(self.folder, page.parent)
        after = page.read_text()
        board_before, board_after = (re.sub('<td class="number".*?</td>', "", text[:text.index('<h2 id="figure_1">')]
                                            .partition('<h2 id="scoreboard">')[2]) for text in (before, after))
        self.assertEqual(board_before, board_after)
        self.assertEqual((before.count("<dt>method</dt>"), after.count("<dt>method</dt><dd>stabilised</dd>")), (0, 7))
        section = after[after.index('<h2 id="beyond">'):after.index('<h2 id="acceptance">')]
        self.assertRegex(section, r"good..pass.*stabilised_limit_12mm")
        self.assertRegex(section, r"missing.*stabilised_limit_20mm")
        # 20.4 and 58.2 s for the shots that took the paper's method 20.4 and 38.8 s.
        self.assertIn("stabilised: 1.33 times the processor time", section)

    def test_a_shot_that_was_decided_at_last_counts_once(self):
        undecided = SHOTS[1].replace(",31.25,1,", ",,,").replace(",ab,", ",aa,")
        (self.folder / "shots.csv").write_text("\n".join([SHOT_HEADER, SHOTS[0], undecided, SHOTS[1], ""]))
        self.assertEqual([row["perforated"] for row in read_shots(self.folder)], [0, 1])

    def test_wrong_input(self):
        self.require_refused(run("page", self.folder, self.folder),
                             "must not be the folder with the results")
        self.require_refused(run("page", self.folder / "none", self.folder / "page"), "holds no shots*.csv")
        self.assertFalse((self.folder / "page").exists())

    def test_shots_of_a_page_go_back_to_a_campaign(self):
        page, again = self.folder.parent / "page", self.folder.parent / "again"
        (self.folder / "figure_6.svg").write_text("<svg/>")
        for arguments in (("page", self.folder, page), ("published", page, again)):
            done = run(*arguments)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((again / "shots_published.csv").read_text(), (self.folder / "shots.csv").read_text())
        self.assertIn("3 shots", done.stdout)
        self.assertTrue((again / "figure_6.svg").exists())
        record = page / "run_record.csv"
        record.write_text(record.read_text().splitlines()[0] + "\n")
        self.require_refused(run("published", page, again), "has no row in")

    def test_rows_of_a_campaign_are_kept_and_taken_up_again(self):
        again = self.folder.parent / "again"
        with mock.patch.object(published, "KEPT", self.folder.parent / "kept"):
            published.take_kept(again)
            self.assertFalse(again.exists())  # nothing is kept yet
            published.keep(self.folder)
            picture = self.folder / "figure_10.png"
            picture.write_bytes(b"sections")
            published.keep_pictures([picture])
            published.take_kept(again)
            self.assertEqual((again / picture.name).read_bytes(), b"sections")
            found = read_shots(again)
            self.assertEqual([row.text for row in found], [row.text for row in read_shots(self.folder)])
            self.assertTrue((again / "projectiles.csv").exists())
            # One more shot joins those that are kept; rows of a page do not.
            row = dict(found[0].text, initial_velocity_mps="777")
            (again / "shots.csv").write_text(",".join(row) + "\n" + ",".join(row.values()) + "\n")
            published.keep(again)
            self.assertEqual(len(read_shots(published.KEPT)), len(found) + 1)
            (again / "shots_published.csv").write_text((again / "shots.csv").read_text().replace("777", "888"))
            published.keep(again)
            self.assertEqual(len(read_shots(published.KEPT)), len(found) + 1)


if __name__ == "__main__":
    unittest.main()
