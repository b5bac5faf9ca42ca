"""scripts/results with small made-up results and pages."""

import contextlib
import io
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

sys.dont_write_bytecode = True
SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))

from results import cavity, figures, fits, gallery, limits, published, sweeps, tables, validation  # noqa: E402
from results.checks import Bound, Result, run_checks  # noqa: E402
from results.data import Results, Tests, cubic_particles, ended_by_time, read_shots, short  # noqa: E402
from results.page import from_markdown  # noqa: E402
from results.verdicts import counts, headline, of_method, verdict_of  # noqa: E402

SHOT_HEADER = ("method,model,material,nose,thickness_mm,initial_velocity_mps,spacing_mm,residual_velocity_mps,"
               "perforated,plug_thickness_mm,energy_error,largest_intrusion_mm,particles,steps,wall_s,cpu_s,threads,"
               "state_hash,version")
SHOTS = [
    "paper,mjc,weldox_460e,blunt,12,180,0.6,0,0,0,0.0001,0,25820,900,20.5,20.4,1,aa,0.1.0",
    "paper,mjc,weldox_460e,blunt,12,184,0.6,31.25,1,11,0.0002,0,25820,800,19.5,38.8,2,ab,0.1.0",
    "paper,mjc,weldox_460e,blunt,12,303.5,0.6,190,1,11.5,0.007,0,25820,700,10,9.9,1,ac,0.1.0",
]
LIMITS = """\
method,model,material,nose,thickness_mm,spacing_mm,highest_stopped_mps,lowest_perforated_mps,bisection_limit_mps,\
consistent,fit_limit_mps,fit_limit_se_mps,fit_a,fit_a_se,fit_a_origin,fit_p,fit_p_se,fit_p_origin,fit_points,\
fit_rms_mps,test_limit_mps,paper_velocity_mps
paper,mjc,weldox_460e,blunt,12,0.6,180,184,182,1,182.5,,0.84,,held,2,,held,2,1.5,184.5,195
"""
CHECKS = """\
[defaults]
method = "paper"
model = "mjc"
spacing_mm = 0.6
widest_bracket_mps = 5

[[check]]
id = "good"
figure = [6, 9]
statement = "The limit is near"
against = "tests"
reason = "Limits are known to 5 m/s"
kind = "limit_against_test"
metal = "Weldox 460 E"
nose = "blunt"
thickness_mm = 12
within_percent = 6

[[check]]
id = "bad"
figure = 0
statement = "Energy balances"
against = "seen"
reason = "It must"
kind = "every_row"
quantity = "energy_error"
below_percent = 0.5

[[check]]
id = "gone"
figure = 9
statement = "The thin plate's limit is near"
against = "paper"
reason = "The paper has it"
kind = "limit_against_test"
metal = "Weldox 460 E"
nose = "blunt"
thickness_mm = 6
within_percent = 6
"""


def run(*arguments, text=None):
    return subprocess.run([sys.executable, "-m", "results", *map(str, arguments)], capture_output=True, text=True, check=False,
                          input=text, env={**os.environ, "PYTHONPATH": str(SCRIPTS)})


class Folders(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name) / "campaign"
        self.folder.mkdir()
        (self.folder / "shots.csv").write_text("\n".join([SHOT_HEADER, *SHOTS, ""]))
        (self.folder / "limits.csv").write_text(LIMITS)
        self.checks = self.folder / "checks.toml"
        self.checks.write_text(CHECKS)

    def accept(self, *arguments):
        return run("accept", self.folder, "--checks", self.checks, *arguments)

    def require_refused(self, done, *texts):
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertRegex(done.stderr, r"^\w+: error: [^\n]*\n$")
        for text in texts:
            self.assertIn(text, done.stderr)


class Accept(Folders):
    def test_one_passes_one_fails_one_is_missing(self):
        done = self.accept()
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stdout.splitlines(), [
            "pass    tests good: The limit is near: -1.36 % (182 m/s, test 184.5 m/s); bound: within 6 %",
            "FAIL    seen  bad: Energy balances: 0.7 % (mjc, blunt, 12 mm, 303.5 m/s); bound: below 0.5 %",
            "missing paper gone: The thin plate's limit is near: no limit to 2.5 m/s by bisection, blunt, 6 mm; bound: "
            "within 6 %",
            "method paper: against the paper 0 of 1, against the tests 1 of 1",
            "every method: what is seen 0 of 1",
            "1 passed, 2 failed"])

    def test_reasons(self):
        done = self.accept("--reasons")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stdout.splitlines()[1::2][:3], [
            "        reason for the bound: Limits are known to 5 m/s", "        reason for the bound: It must",
            "        reason for the bound: The paper has it"])

    def test_several_files_of_checks(self):
        other = self.folder / "other.toml"
        other.write_text(CHECKS.replace('"paper"\nmodel', '"stabilised"\nmodel').replace('id = "', 'id = "other_'))
        done = self.accept("--checks", other)
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertEqual(done.stdout.splitlines()[-4:], [
            "method paper: against the paper 0 of 1, against the tests 1 of 1",
            "method stabilised: against the paper 0 of 1, against the tests 0 of 1", "every method: what is seen 0 of 2",
            "1 passed, 5 failed"])
        self.require_refused(self.accept("--checks", self.checks), "id = good: must be the id of one check only")

    def test_all_pass(self):
        self.checks.write_text(CHECKS[:CHECKS.index('[[check]]\nid = "bad"')])
        done = self.accept()
        self.assertEqual((done.returncode, done.stdout.splitlines()[-1]), (0, "1 passed, 0 failed"))

    def test_other_particle_distance_has_no_data(self):
        self.assertIn("missing tests good", self.accept("--spacing-mm", 1.5).stdout)

    def test_wide_bracket_is_no_limit(self):
        (self.folder / "limits.csv").write_text(LIMITS.replace(",180,184,182,", ",170,184,177,"))
        self.assertIn("missing tests good", self.accept().stdout)

    def test_shot_values(self):
        def outcome(text):
            check = ('[[check]]\nid = "x"\nfigure = 1\nstatement = "It is"\nagainst = "seen"\nreason = "So"\n'
                     'metal = "Weldox 460 E"\nnose = "blunt"\nthickness_mm = 12\n')
            self.checks.write_text(CHECKS[:CHECKS.index("[[check]]")] + check + text)
            done = self.accept()
            self.assertIn(done.returncode, (0, 1), done.stderr)
            return done.stdout.split()[0], re.search(r"It is: (\S+)", done.stdout)[1]

        ratio = 'kind = "shot_value"\nquantity = "plug_thickness_mm"\nper = "thickness_mm"\n'
        self.assertEqual(outcome(ratio + "above = 0.5\nbelow = 0.95"), ("pass", "0.917"))
        self.assertEqual(outcome(ratio + "at_least = 0.92"), ("FAIL", "0.917"))
        self.assertEqual(outcome(ratio + "velocity_mps = 303.5\nbelow = 0.95"), ("FAIL", "0.958"))
        self.assertEqual(outcome('kind = "shot_value"\nquantity = "plug_thickness_mm"\nless = 10\nat_least_mm = 1'),
                         ("pass", "1"))
        self.assertEqual(outcome('kind = "residuals_against_tests"\nfrom_velocity_mps = 300\nwithin_mps = 12')[0],
                         "missing")
        self.assertEqual(outcome('kind = "residuals_against_tests"\nfrom_velocity_mps = 303\nup_to_velocity_mps = 304\n'
                                 "within_mps = 12"), ("pass", "-9.7"))
        self.assertEqual(outcome('kind = "residuals_against_tests"\nfrom_velocity_mps = 500\nwithin_mps = 12')[0], "missing")
        # The paper names 195 m/s; the limit is 182 m/s.
        self.assertEqual(outcome('kind = "limit_against_paper"\nwithin_percent = 5'), ("FAIL", "-6.67"))
        nearer = ('kind = "nearer_law"\nmodel = "jc"\nthan = "mjc"\nfrom_velocity_mps = 303\nup_to_velocity_mps = 304\n'
                  "below_mps = 0")
        self.assertEqual(outcome(nearer)[0], "missing")
        # Test 199.7 m/s, modified law 190 m/s, classical law 195 m/s.
        with open(self.folder / "shots.csv", "a", encoding="utf-8") as shots:
            shots.write(SHOTS[2].replace(",mjc,", ",jc,").replace(",190,", ",195,") + "\n")
        self.assertEqual(outcome(nearer), ("pass", "-5"))
        self.assertEqual(outcome('kind = "particle_count"\ndisc_radius_mm = 24\nwithin_percent = 3'), ("pass", "+2.73"))
        self.assertEqual(outcome('kind = "perforating_velocities"\nup_to_velocity_mps = 406\nat_least = 6')[0],
                         "missing")

    def test_wrong_input(self):
        self.require_refused(self.accept("--no-such-option"), "--no-such-option")
        self.require_refused(run("accept", self.folder / "none"), "holds no shots*.csv")
        for old, new, text in (
                ('kind = "every_row"', 'kind = "some"', "check bad: kind = 'some': must be one of"),
                ("below_percent", "below_apples", "check bad: kind"),
                ('against = "seen"', 'against = "all"', "check bad: against = 'all': must be one of paper, tests, seen"),
                ('against = "seen"', "", "check bad: against = None: must be a text"),
                ('reason = "It must"', "", "check bad: reason = None: must be a text"),
                ("below_percent", "beneath", "check bad: beneath = 0.5: is unknown"),
                ("below_percent = 0.5", "", "check bad: bounds: must be"),
                ('quantity = "energy_error"', 'quantity = "mood"', "must be a column"),
                ('id = "bad"', 'id = "good"', "id = good: must be the id of one check only"),
                ("within_percent = 6", 'within_percent = "6"', "must be a number"),
                ("figure = 0", 'figure = "six"', "check bad: figure = 'six'")):
            self.checks.write_text(CHECKS.replace(old, new))
            self.require_refused(self.accept(), text)
        self.checks.write_text(CHECKS)
        (self.folder / "shots.csv").write_text("\n".join([SHOT_HEADER, SHOTS[0].replace("180", "fast"), ""]))
        self.require_refused(self.accept(), "shots.csv:2: initial_velocity_mps = 'fast': must be a finite number")

    def test_table_of_figures(self):
        done = self.accept("--figures")
        lines = done.stdout.splitlines()
        self.assertEqual(done.returncode, 0)
        self.assertEqual(lines[:4], [
            "Method `paper`:", "", "| figure | what it shows | against the paper | against the tests | what is seen | "
            "worst number |", "|---|---|---|---|---|---|"])
        self.assertEqual([line.split(" | ")[0] for line in lines[4:]], [f"| {k}" for k in range(1, 15)])
        self.assertEqual(lines[7], "| 4 | The projectiles | – | – | – | – |")
        self.assertEqual(lines[12], (
            "| 9 | Ballistic limit against thickness: Weldox 460 E, blunt | not run yet 0 of 1 | agrees 1 of 1; -1.36 %, "
            "bound: within 6 % | – | The limit is near: -1.36 % (182 m/s, test 184.5 m/s); bound: within 6 % |"))

    def test_a_method_beyond_the_paper_has_its_own_table_of_figures(self):
        self.checks.write_text(CHECKS.replace('"paper"\nmodel', '"stabilised"\nmodel'))
        lines = self.accept("--figures").stdout.splitlines()
        self.assertEqual(len([line for line in lines if "| – | – | – | – |" in line]), 14)
        self.assertEqual([line.split(" | ")[0] for line in lines[lines.index("Method `stabilised`:") + 4:]],
                         ["| 6", "| 9"])

    def test_the_project_s_own_checks_are_well_formed(self):
        done = run("accept", self.folder)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stdout.splitlines()[-1], r"^\d+ passed, \d+ failed$")
        results = run_checks(Results(self.folder), Tests())
        for method in ("paper", "stabilised"):
            blunt = {r.id for r in results if r.method == method and "mm steel, blunt: the limit is that of the tests"
                     in r.statement}
            self.assertEqual(len(blunt), 6, method)
            self.assertTrue(any("conical: residual" in r.statement for r in results if r.method == method), method)
        self.assertEqual(len([r for r in results if "the limit is the paper's" in r.statement]), 6)
        # The curves of Figs. 1 to 3 are synthetic: neither the paper nor tests can be compared with them.
        self.assertEqual({r.against for r in results if set(r.figures) & {1, 2, 3}}, {"seen"})


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
        self.assertEqual((before.count("<dt>method</dt>"), after.count("<dt>method</dt><dd>stabilised</dd>")), (0, 6))
        section = after[after.index('<h2 id="beyond">'):after.index('<h2 id="acceptance">')]
        self.assertRegex(section, r"good..pass.*stabilised_limit_12mm")
        self.assertRegex(section, r"missing.*stabilised_limit_20mm")
        # 20.4 and 58.2 s for the shots that took the paper's method 20.4 and 38.8 s.
        self.assertIn("stabilised: 1.33 times the processor time", section)

    def test_particles_that_do_not_lie_on_the_paper_s_lattice_are_told(self):
        page = self.folder / "page" / "index.html"
        self.page(self.folder, page.parent)
        self.assertIn("run on the ring lattice with version 0.1.0:", page.read_text())
        # `ogive shoot --method paper --spacing-mm 1.2` has as many.
        self.assertEqual(cubic_particles(12, 1.2), 3160)
        text = (self.folder / "shots.csv").read_text()
        (self.folder / "shots.csv").write_text(text.replace(",25820,", f",{cubic_particles(12, 0.6)},"))
        self.page(self.folder, page.parent)
        self.assertNotIn("ring lattice", page.read_text().split('<h2 id="scoreboard">')[0])

    def test_wrong_input(self):
        self.require_refused(run("page", self.folder, self.folder),
                             "must not be the folder with the results")
        self.require_refused(run("page", self.folder / "none", self.folder / "page"), "holds no shots*.csv")
        self.assertFalse((self.folder / "page").exists())

    def test_shots_of_a_page_go_back_to_a_campaign(self):
        page, again = self.folder.parent / "page", self.folder.parent / "again"
        (self.folder / "figure_6.svg").write_text("<svg/>")
        # One shot on the ring lattice: it is run again.
        shots = (self.folder / "shots.csv").read_text().replace(",25820,", f",{cubic_particles(12, 0.6)},", 2)
        (self.folder / "shots.csv").write_text(shots)
        for arguments in (("page", self.folder, page), ("published", page, again)):
            done = run(*arguments)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((again / "shots_published.csv").read_text(), "\n".join([*shots.splitlines()[:3], ""]))
        self.assertIn("2 shots, 1 on the ring lattice are left out", done.stdout)
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


class Parts(unittest.TestCase):
    def test_bounds(self):
        for relation, limit, measured, holds in (
                ("within", 6, -6, True), ("within", 6, 6.1, False), ("at_least", -24, -23, True),
                ("at_least", -24, -25, False), ("at_least", 2, 3, True), ("at_least", 2, -1, False),
                ("at_most", 5, 5, True), ("below", 5, 5, False), ("above", 0, 0, False), ("above", 0, 1, True)):
            bound = Bound(relation, limit, "mm")
            self.assertEqual(bound.holds(measured), holds, (relation, limit, measured))
            self.assertEqual(bound.share(measured) <= 1, holds, (relation, limit, measured))

    def test_verdicts(self):
        def results(*outcomes):
            return [Result(str(k), [1], "It is", "tests", "", "paper", status, number, "there", "", share)
                    for k, (status, share, number) in enumerate(outcomes)]

        good, bad, worse = ("pass", 0.5, "1 %"), ("FAIL", 1.5, "2 %"), ("FAIL", 3, "3 %")
        gone, drawn, undrawn = ("missing", 9, ""), ("pass", 0, ""), ("missing", 9, "")
        for outcomes, word, worst in (((good, drawn), "agrees", "0"), ((good, bad, worse), "partly", "2"),
                                      ((good, gone), "partly", "0"), ((bad, gone), "differs", "0"),
                                      ((gone, drawn), "not run yet", None), ((good, undrawn), "partly", "0"),
                                      ((drawn,), "agrees", None), ((), "–", None)):
            found = verdict_of(results(*outcomes))
            self.assertEqual((found.word, found.worst and found.worst.id), (word, worst), outcomes)
            self.assertEqual(found.count, len(outcomes))
        self.assertEqual(headline({}, results(good, worse)), "It is: 3 % (there); bound: ")
        self.assertEqual(headline({"headline": "verified"}, results(good, drawn)), "verified")
        self.assertEqual(headline({"headline": "verified"}, results(good, bad)), "It is: 2 % (there); bound: ")
        self.assertEqual(headline({}, results(drawn)), "–")
        self.assertEqual(counts(results(good, bad)), ["method paper: against the tests 1 of 2"])
        self.assertEqual(of_method(results(good), "stabilised"), [])

    def test_counts_and_yes_or_no_use_up_no_bound(self):
        cell = verdict_of([Result("x", [1], "", "seen", "", "all", "pass", "6", "", "at least 6", 0)]).cell()
        self.assertEqual(cell, "agrees 1 of 1")

    def test_numbers_for_readers(self):
        self.assertEqual([short(v) for v in (0.0117370, 182.53, 25820, 1e-12, None, -1.5)],
                         ["0.01174", "182.5", "25820", "1e-12", "–", "-1.5"])

    def test_markdown(self):
        text = from_markdown("# Title\n\nA `b|c` and [link](x.md):\n- one\n- two\n\n## Part\n\n| a | b |\n|---|---|\n| 1 \\| 2 "
                             "| **3** |\n", "../")
        self.assertNotIn("Title", text)
        self.assertIn('<p>A <code>b|c</code> and <a href="../x.md">link</a>:</p>', text)
        self.assertRegex(text, r"<li>one</li>\s*<li>two</li>")
        self.assertIn("<h3>Part</h3>", text)
        self.assertRegex(text, r'<div class="scroll"><table>(?s:.*)<td>1 \| 2</td>\s*<td><strong>3</strong></td>')
        self.assertNotIn("href", from_markdown("[link](x.md)", None))
        self.assertIn('href="https://x.org"', from_markdown("[link](https://x.org)", None))

    def test_shots_that_end_with_the_time(self):
        for nose, simulated_us, ended in (("blunt", 500.01, True), ("blunt", 499.9, False), ("conical", 600, False),
                                          ("conical", 1500.005, True), ("blunt", None, False)):
            self.assertEqual(ended_by_time({"nose": nose, "simulated_us": simulated_us}), ended)

    def test_rows_without_end_are_passed_over(self):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "shots.csv").write_text(SHOT_HEADER + "\n" + SHOTS[0] + "\n" + SHOTS[1])
            self.assertEqual(len(read_shots(folder)), 1)

    def test_figures_refuses_wrong_options(self):
        for arguments, text in ((["--jobs", "0"], "--jobs = 0: must be a whole number from 1"),
                                (["--fast"], "unrecognized arguments: --fast"),
                                (["--method", "fem"], "--method: invalid choice: 'fem'")):
            done = run("figures", *arguments)
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr, r"^\w+: error: [^\n]*\n$")
            self.assertIn(text, done.stderr)


class Tables(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        for patch in (mock.patch.object(sweeps, "FOLDER", self.folder), mock.patch.object(sweeps, "PROGRAM", "false"),
                      mock.patch.object(sweeps, "KEPT", self.folder / "kept")):
            patch.start()
            self.addCleanup(patch.stop)

    def leave(self, folder, name, **values):
        shot = self.folder / folder / "shots" / name
        shot.mkdir(parents=True)
        (shot / "summary.json").write_text(json.dumps({"version": "0.1.0", "fault": None, **values}))

    def table(self, name):
        with contextlib.redirect_stdout(io.StringIO()) as text:
            tables.make_tables(name)
        return text.getvalue().splitlines()

    def test_every_list_is_there_with_names_and_texts(self):
        for name, (page, blocks) in tables.TABLES.items():
            text = (SCRIPTS.parent / "docs" / f"{page}.md").read_text()
            self.assertEqual(text.count(f"<!-- tables: scripts/results.sh tables {name} -->"), 2, name)
            for sweep in (sweep for block in blocks for sweep in block.sweeps):
                names = [case["name"] for case in sweeps.cases(sweep)]
                self.assertEqual(len(names), len(set(names)), sweep)
                for case in sweeps.cases(sweep):
                    metal = case.get("material", "")
                    self.assertTrue(not metal.endswith(".toml") or metal in sweeps.METALS or (sweeps.CASES / metal).is_file(),
                                    case)

    def test_shots(self):
        self.leave("near_limit_8mm", "bonds", initial_velocity_mps=180.0, residual_velocity_mps=59.64, plug_mass_g=22.01,
                   test_residual_velocity_mps=84.31, test_origin="Recht-Ipson curve", energy_error=0.000141,
                   largest_intrusion_mm=0.0, momentum_error=2.3e-15, steps=2228)
        self.leave("near_limit_16mm", "bonds", initial_velocity_mps=265.0, fault={"what": "stopped"})
        lines = self.table("sensitivity")
        self.assertEqual(lines[0][:72], "Made by `scripts/results.sh tables sensitivity` with ogive 0.1.0. Tests ")
        self.assertEqual(lines[2:], [
            "Two plates near the limits of the tests, particles 0.8 mm apart:", "",
            "| case | initial, m/s | test, m/s | computed, m/s | plug, g | energy error, % | intrusion, mm | momentum error | "
            "steps |", "|---|---|---|---|---|---|---|---|---|",
            "| 8 mm, bonds against zero-energy modes, 0.3 | 180.0 | (84.3) | 59.6 | 22.0 | 0.014 | 0.000 | 2e-15 | 2228 |"])

    def test_values_that_are_missing(self):
        self.leave("stabilised_6mm", "base", initial_velocity_mps=170, residual_velocity_mps=0.0, failed_particles=26,
                   dishing_mm=13.92)
        self.assertEqual(self.table("stabilised")[-1], "| 6 mm, default | 170.0 | – | 0.0 | – | 26 | 13.92 | – | – | – |")

    def leave_limits(self, folder, head, *rows):
        """Rows without a bracket get one as wide as that of a search that has ended."""
        if "lowest_perforated_mps" not in head:
            head, rows = f"{head},highest_stopped_mps,lowest_perforated_mps", [f"{row},200,205" for row in rows]
        (self.folder / folder).mkdir()
        (self.folder / folder / "limits.csv").write_text("\n".join([head, *rows, ""]))

    def test_limits_beside_those_of_the_paper(self):
        head = "thickness_mm,highest_stopped_mps,lowest_perforated_mps,bisection_limit_mps"
        self.leave_limits("limits_paper", head, "6,110,115,112.5", "8,145,,", "12,190,195,192.5")
        self.leave_limits("limits_paper_standard", head, "12,180,185,182.5")
        lines = self.table("paper")
        self.assertEqual([line for line in lines if "mm |" in line], [
            "| 6 mm | 145.5 | 110 | 112.5 | +2.3 % | -22.7 % |", "| 12 mm | 184.5 | 195 | 192.5 | -1.3 % | +4.3 % |",
            "| 12 mm | 184.5 | 195 | 182.5 | -6.4 % | -1.1 % |"])
        self.assertIn("The same with the standard form", lines[-5])

    def test_repeated_limits(self):
        self.leave_limits("repeats", "thickness_mm,seed,highest_stopped_mps,lowest_perforated_mps,bisection_limit_mps",
                          "12,0,189.5,190.5,190", "12,2,196.5,197.5,197", "12,1,191.5,192.5,192", "20,0,280,285,282.5",
                          "16,0,217,227,222")  # a search that has not ended
        # As in tests/fit/repeated_limit.cpp: mean 193, variance 13, t(0.95, 2) = 2.920.
        self.assertEqual(self.table("repeats")[-2:], [
            "| 12 mm | 184.5 | 190.0 | 192.0 | 197.0 | 193.0 | 3.6 | 186.9 to 199.1 | +4.6 % |",
            "| 20 mm | 293.9 | 282.5 | – | – | – | – | – | – |"])
        # Brackets that agree leave the interval as wide as they are.
        mean, deviation, half = limits.repeated_limit([(190, 3), (190, 3)])
        self.assertEqual((mean, deviation), (190, 0))
        self.assertAlmostEqual(half, 6.3138 * math.sqrt(3 / 2), places=4)

    def test_limits_in_other_sizes(self):
        head = "thickness_mm,diameter_mm,spacing_mm,sph_radius_mm,clamp_radius_mm,bisection_limit_mps"
        self.leave_limits("scale", head, "6,10,0.3,12,125,202", "12,20,0.6,24,250,192.5", "24,40,1.2,48,500,")
        self.assertEqual(self.table("scale")[-3:], ["| half | 6 | 10 | 0.3 | 202.0 | +4.9 % |",
                                                    "| that of the tests | 12 | 20 | 0.6 | 192.5 | +0.0 % |",
                                                    "| double | 24 | 40 | 1.2 | – | – |"])
        # Only the lengths differ between the cases: the plate's and the projectile's over the particle distance are the same.
        ratios = {tuple(float(case[key]) / float(case["spacing_mm"]) for key in case if key.endswith("_mm"))
                  for case in sweeps.cases(tables.TABLES["scale"][1][0].sweeps[0])}
        self.assertEqual(ratios, {(20, 20 / 0.6, 1, 40, 250 / 0.6)})

    def test_limits_with_other_particles(self):
        head = "thickness_mm,seed,bisection_limit_mps"
        self.leave_limits("limits_stabilised_0.45mm", head, "6,0,136")
        self.leave_limits("repeats", head, "6,0,140.5", "6,1,139", "8,0,157")
        self.assertEqual(self.table("sizes_stabilised")[6:8], [
            "| 6 mm | 145.5 | – | 136.0 | 140.5 | – | -3.2 % |", "| 8 mm | 154.3 | – | – | 157.0 | – | – |"])

    def test_cost(self):
        record = self.folder / "run_record.csv"
        record.write_text("method,model,material,nose,thickness_mm,initial_velocity_mps,spacing_mm,cpu_s,version\n" + "".join(
            f"{method},mjc,weldox_460e,blunt,{thickness},200,0.6,{seconds},0.1.0\n" for method, thickness, seconds in (
                ("paper", 6, 10), ("stabilised", 6, 25), ("paper", 12, 20), ("stabilised", 12, 20), ("paper", 8, 7))))
        with mock.patch.object(tables, "PAGE", self.folder):
            self.assertEqual(self.table("cost")[-3:], [
                "| blunt | 6 mm weldox_460e | 1 | 10 | 25 | 2.50 |", "| blunt | 12 mm weldox_460e | 1 | 20 | 20 | 1.00 |",
                "| all |  | 2 | 30 | 45 | 1.50 |"])

    def test_accuracy_of_the_default_method(self):
        head = "material,nose,thickness_mm,spacing_mm,seed,highest_stopped_mps,lowest_perforated_mps,bisection_limit_mps"
        self.leave_limits("repeats", head, "weldox_460e,blunt,6,0.6,0,138,143,140.5", "weldox_460e,blunt,6,0.6,1,137,141,139")
        (self.folder / "repeats" / "shots.csv").write_text(
            "material,nose,thickness_mm,spacing_mm,seed,initial_velocity_mps,cpu_s,version\n" + "".join(
                f"weldox_460e,blunt,{row},0.1.0\n" for row in ("6,0.6,0,143,50", "6,0.6,1,141,70", "8,0.6,0,141,900")))
        self.leave_limits("sharp", "material,nose,thickness_mm,spacing_mm,bisection_limit_mps",
                          "aa5083_h116,conical,15,1,211.5")
        self.leave_limits("open", "material,projectile,thickness_mm,sph_radius_mm,clamp_radius_mm,spacing_mm,bisection_limit_mps",
                          "/a/b/aa6061_t651_jc.toml,fsp_20mm,12.7,24,150,1,204.9")
        self.assertEqual(self.table("accuracy")[-3:], [
            "| blunt, 6 to 20 mm Weldox 460 E | 1 | -4.0 % | -4.0 % | chosen on |",
            "| cone, 15 to 25 mm AA5083-H116 | 1 | -2.4 % | -2.4 % | known |",
            "| 20 mm fragment simulator, 12.7 mm AA6061-T651 | 1 | -6.0 % | -6.0 % | chosen on |"])
        # Mean of two arrangements; the brackets allow (2.5^2 + 2^2) / 6, the limits differ by 0.75^2 * 2.
        half = 6.3138 * math.sqrt((2.5 ** 2 + 2 ** 2) / 6 / 2)
        self.assertEqual(self.table("validation")[-3:], [
            f"| blunt, 6 mm Weldox 460 E | 0.6 | 145.5 ± 5 | 139.8 ± {half:.1f} | 2 | -4.0 % | chosen on | – | 2 |",
            "| conical, 15 mm AA5083-H116 | 1 | 216.8 ± 5 | 211.5 ± 2.5 | 1 | -2.4 % | known | – | 0 |",
            "| 20 mm FSP at 12.7 mm AA6061-T651 | 1 | 218.0 | 204.9 ± 2.5 | 1 | -6.0 % | chosen on | – | 0 |"])
        picture = self.folder / "limits.svg"
        with contextlib.redirect_stdout(io.StringIO()):
            validation.draw(tables.ALL_LIMITS, picture)
        drawn = picture.read_text()
        self.assertIn("20 mm fragment simulator, 12.7 mm AA6061-T651", drawn)
        self.assertNotIn("APM2", drawn)  # of which there is no limit
        self.assertEqual(self.table("open")[-1], "| 20 mm FSP at 12.7 mm AA6061-T651 | 1 | 218 | 204.9 | -6.0 % | – | – |")
        self.assertEqual(self.table("sharp")[-1], "| conical, 15 mm AA5083-H116 | 216.8 | 211.5 | -2.4 % |")

    def test_no_shot_is_an_error(self):
        done = run("tables", "no_such_table")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("tables = no_such_table: must be one of plate_12mm, sensitivity,", done.stderr)
        with self.assertRaisesRegex(tables.InputError, "no shot has been run"):
            tables.make_tables("dishing")

    def test_metals_with_other_constants(self):
        text = 'name = "aa"\nA_MPa = 200 # yield stress\nB_MPa = 300\n'
        self.assertEqual(sweeps.changed_metal(text, "b_0.9.toml", {"B_MPa": lambda v: 0.9 * v}),
                         'name = "b_0.9"\nA_MPa = 200 # yield stress\nB_MPa = 270\n')
        with self.assertRaisesRegex(tables.InputError, "D1: is no constant"):
            sweeps.changed_metal(text, "b.toml", {"D1": lambda v: 2 * v})

    def test_cavity_expansion(self):
        # Without hardening the integral is ln(E/(sqrt(3) Y)).
        self.assertAlmostEqual(cavity.expansion_stress(300e6, 70e9, 0) / 1e6,
                               300 / math.sqrt(3) * (1 + math.log(70e3 / (math.sqrt(3) * 300))), 4)
        core = {"projectile": "7.62 mm APM2 core", "thickness_mm": "20", "obliquity_deg": "0", "yield_MPa": "300",
                "young_GPa": "70", "ludwik_n": "0"}
        # The energy of 5.25 g is the work of that stress on the hole.
        work = cavity.expansion_stress(300e6, 70e9, 0) * 20e-3 * math.pi * (6.17e-3 / 2) ** 2
        self.assertAlmostEqual(cavity.limit_mps(core), math.sqrt(2 * work / 5.25e-3), 6)
        for change in ({"obliquity_deg": "30"}, {"yield_MPa": ""}, {"projectile": "20 mm FSP"}):
            self.assertIsNone(cavity.limit_mps({**core, **change}))

    def test_rows_are_kept_and_taken_up_again(self):
        program = self.folder / "ogive"
        program.write_text('#!/bin/sh\nwhile [ "$1" != --out ]; do shift; done\n[ -f "$2/shots.csv" ] || echo version > '
                           '"$2/shots.csv"\necho 1.2.3 >> "$2/shots.csv"\ncp "$2/shots.csv" "$2/limits.csv"\n')
        program.chmod(0o755)
        limit, = tables.TABLES["sharp"][1][0].sweeps
        shot = tables.TABLES["measured"][1][0].sweeps[0]
        (self.folder / limit.folder).mkdir()
        (self.folder / shot.folder).mkdir()
        (self.folder / shot.folder / "shots" / "304").mkdir(parents=True)
        (self.folder / shot.folder / "shots" / "304" / "summary.json").write_text(
            '{"fault": null, "initial_velocity_mps": 303.5, "residual_velocity_mps": 208.6, "particles": 25820}')
        with mock.patch.object(sweeps, "PROGRAM", program), contextlib.redirect_stderr(io.StringIO()):
            sweeps.run(limit)
            sweeps.run(shot)
            shutil.rmtree(self.folder / limit.folder)
            shutil.rmtree(self.folder / shot.folder)
            sweeps.run(limit)
        rows = "version\n1.2.3\n1.2.3\n"
        self.assertEqual((self.folder / limit.folder / "shots.csv").read_text(), rows)
        self.assertEqual((self.folder / "kept" / limit.folder / "limits.csv").read_text(), rows)
        self.assertEqual(sweeps.versions(limit), {"1.2.3"})
        self.assertEqual((self.folder / "kept" / shot.folder / "shots.csv").read_text(), "version\n1.2.3\n")
        self.assertEqual(sweeps.summary(shot, "304"), {"initial_velocity_mps": 303.5, "residual_velocity_mps": 208.6})
        self.assertIsNone(sweeps.summary(shot, "400"))
        with_own_metals = tables.TABLES["sensitivity"][1][0].sweeps[0]
        self.assertFalse(sweeps.is_kept(with_own_metals))
        self.assertTrue(sweeps.is_kept(shot))
        shown = {key for column in (*tables.SHOTS, *tables.STABILISED, *tables.CONES, *tables.DISHINGS)
                 for key in column.keys.split()}
        self.assertEqual(shown - set(sweeps.SHOWN_KEYS), {"case_spacing_mm"})

    def test_sweeps_get_all_options(self):
        program = self.folder / "ogive"
        program.write_text('#!/bin/sh\n[ "$1" = sweep ] || { echo \'name = "x"\'; echo "rate_floor_per_s = 1"; exit; }\n'
                           f'echo "$@" > {self.folder}/said; cat "$2" >> {self.folder}/said\n')
        program.chmod(0o755)
        with mock.patch.object(sweeps, "PROGRAM", program), contextlib.redirect_stderr(io.StringIO()):
            sweeps.run(tables.TABLES["sensitivity"][1][0].sweeps[0], 2)
        said = (self.folder / "said").read_text().splitlines()
        folder = self.folder / "sensitivity"
        self.assertEqual(said[0], f"sweep {folder}/cases.csv --jobs 2 --method paper --lattice ring --no-vtk --no-picture "
                                  f"--out {folder}")
        self.assertTrue(said[-1].endswith(f",{folder}/floor_100.toml"))
        self.assertEqual((folder / "floor_100.toml").read_text(), 'name = "floor_100"\nrate_floor_per_s = 100\n')


class Gallery(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def test_page_is_that_of_the_rows(self):
        root = SCRIPTS.parent
        rows = gallery.kept()
        self.assertEqual([case["name"] for case in gallery.cases()], list(rows), "scripts/results.sh gallery --run --insert")
        self.assertIn(gallery.text_of(rows), (root / "docs" / "gallery.md").read_text(encoding="utf-8"))
        for name in rows:
            self.assertLessEqual((gallery.PICTURES / f"{name}.png").stat().st_size, gallery.MOST_BYTES)
        for case in gallery.cases():
            for word in gallery.shot(case):
                self.assertTrue(not word.endswith(".toml") or (root / word).is_file(), word)

    def test_missing_shots_are_run_drawn_and_kept(self):
        program = self.folder / "ogive"
        program.write_text('#!/bin/sh\nwhile [ "$1" != --out ]; do [ "$1" != --series ] || drawn=yes; shift; done\n'
                           f'mkdir -p {self.folder}/shots; [ -z "$drawn" ] || {{ echo png > "$2"; exit; }}\n'
                           'mkdir -p "$2"; echo \'{"verdict": "perforated", "initial_velocity_mps": 200, "residual_velocity_mps": '
                           '98.7, "plug_mass_g": 12.3, "test_residual_velocity_mps": null, "particles": 9, "cpu_s": 1.25, '
                           '"version": "0.1.0"}\' > "$2/summary.json"\n')
        program.chmod(0o755)
        one = {"name": "one", "text": "One", "material": "../../examples/aa6061_t651_jc.toml", "rigid": "true", "nose": "",
               "velocity_mps": "200", "spacing_mm": "1.2"}
        with (mock.patch.object(gallery, "cases", lambda: [one]), mock.patch.object(gallery, "ROWS", self.folder / "rows.csv"),
              mock.patch.object(gallery, "PICTURES", self.folder / "pictures"),
              mock.patch.object(gallery, "FOLDER", str(self.folder / "shots")), contextlib.redirect_stderr(io.StringIO())):
            gallery.run_missing_shots(program)
            text = gallery.text_of(gallery.kept())
            one["velocity_mps"] = "210"
            self.assertEqual({}, gallery.kept())
        self.assertIn("| ![One](gallery/one.png) | One | 200 m/s before the plate, 99 m/s behind it; plug of 12.3 g | 1.2 | 9 | 1.2 |",
                      text)
        self.assertIn(f"ogive shoot --material examples/aa6061_t651_jc.toml --rigid --velocity-mps 200 --spacing-mm 1.2 --out "
                      f"{self.folder}/shots/one\n", text)


class Figures(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        self.campaign = figures.Campaign(self.folder, self.folder, 0.6)
        self.commands = []
        patch = mock.patch.object(figures.Campaign, "attempt", lambda _, *command, **__: self.commands.append(command))
        patch.start()
        self.addCleanup(patch.stop)
        self.find_ffmpeg("/usr/bin/ffmpeg")

    def find_ffmpeg(self, place):
        patch = mock.patch.object(figures.shutil, "which", lambda _: place)
        patch.start()
        self.addCleanup(patch.stop)

    def leave(self, name, *times):
        folder = self.folder / "shots" / name
        folder.mkdir(parents=True)
        (folder / "summary.json").write_text("{}")
        frames = "".join(f'<DataSet timestep="{time}" part="0" file="{time}.vtm"/>' for time in times)
        (folder / "perforation.pvd").write_text(f'<?xml version="1.0"?><VTKFile><Collection>{frames}</Collection></VTKFile>')
        rows = "".join(f"{time},{180 - time}\n" for time in times)
        (folder / "history.csv").write_text("time_us,velocity_m_per_s\n" + rows)
        return folder

    def test_pictures_of_the_shots_that_are_there(self):
        thick = self.leave("stabilised_mjc_weldox_460e_blunt_10mm_180mps_0.6mm", 0, 20, 41.5)
        thin = self.leave("stabilised_mjc_weldox_460e_blunt_6mm_160mps_0.6mm", 0, 30)
        with contextlib.redirect_stdout(io.StringIO()) as said:
            self.campaign.pictures("stabilised")
        drawn = [list(map(str, command)) for command in self.commands]
        self.assertEqual([Path(command[0]).name for command in drawn], [
            "figure_7_stabilised.png", "figure_7_temperature_stabilised.png", "figure_7_stabilised.webm",
            "figure_8_stabilised.png"])
        self.assertEqual(drawn[0][2:7], ["draw", "--series", str(thick), "--times-us", "0,10,20,40"])
        self.assertEqual(drawn[2][2:6], ["draw", "--series", str(thick), "--title"])
        self.assertEqual(drawn[2][7:8], ["--animate"])
        self.assertEqual(drawn[3][2:13], ["draw", "--series", str(thin), str(thick), "--times-us", "0,15,30", "--label",
                                          "(a) 6 mm, 0 µs, 180 m/s", "(a) 6 mm, 15 µs, 180 m/s", "(a) 6 mm, 30 µs, 150 m/s",
                                          "(b) 10 mm, 0 µs, 180 m/s"])
        self.assertIn("figure 14_stabilised is left out: no shot with frames", said.getvalue())

    def test_a_picture_newer_than_its_series_stays(self):
        self.leave("paper_mjc_aa5083_h116_conical_15mm_214mps_0.6mm", 0, 400)
        picture = self.folder / "figure_14.png"
        picture.touch()
        self.find_ffmpeg(None)
        for age, commands in ((-100, 1), (100, 1)):
            series = (self.folder / "shots/paper_mjc_aa5083_h116_conical_15mm_214mps_0.6mm/perforation.pvd").stat().st_mtime
            os.utime(picture, (series + age, series + age))
            with contextlib.redirect_stdout(io.StringIO()):
                self.campaign.pictures("paper")
            self.assertEqual(len(self.commands), commands)

    def test_fits_are_made_when_curves_or_program_are_newer(self):
        program, last = self.folder / "ogive", self.folder / "aluminium_power" / "fit.json"
        program.touch()
        self.assertFalse(fits.are_done(self.folder, program, page_only=True))
        last.parent.mkdir()
        last.touch()
        self.assertTrue(fits.are_done(self.folder, program))
        os.utime(last, (1, 1))
        self.assertFalse(fits.are_done(self.folder, program))
        self.assertTrue(fits.are_done(self.folder, program, page_only=True))


class Fits(unittest.TestCase):
    FIT = {"A_MPa": 1, "B_MPa": 2, "a": 3, "n": 3, "C": 4, "b": 5, "m": 5, "rms_percent": 6, "version": "0.1.0"}

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        self.program, self.curves = self.folder / "ogive", self.folder / "curves"
        fit = {**self.FIT, "standard_error": self.FIT, "simultaneous": self.FIT,
               "quasi_static": {"A_MPa": 1, "B_MPa": 2, "rate_per_s": 7.4e-4}}
        self.program.write_text('#!/bin/sh\necho "$@" >> ' + f"{self.folder}/commands\n"
                                'while [ "$1" != --out ]; do shift; done\nmkdir -p "$2"\n'
                                f"echo '{json.dumps(fit)}' > \"$2/fit.json\"\n")
        self.program.chmod(0o755)
        self.curves.mkdir()

    def fit(self, *arguments):
        return run("fits", "--program", self.program, "--folder", self.folder / "fits", *arguments)

    def test_synthetic_curves(self):
        done = self.fit()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("from synthetic curves.", done.stdout)
        self.assertEqual(done.stdout.count("law that made the curves"), 2)
        commands = (self.folder / "commands").read_text().splitlines()
        self.assertEqual(len(commands), 7)
        self.assertRegex(commands[0],
                         r"^calibrate --data \S*/synthetic_weldox_460e.csv --name Weldox 460 E synthetic --melting-K")

    def test_curves_of_the_user(self):
        (self.curves / "aa5083_h116.csv").write_text("")
        done = self.fit("--curves", self.curves)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("from measured curves.", done.stdout)
        self.assertIn("| paper, Table 2 |", done.stdout)
        self.assertNotIn("Table 1", done.stdout)
        self.assertNotIn("law that made the curves", done.stdout)
        commands = (self.folder / "commands").read_text().splitlines()
        self.assertEqual(len(commands), 3)
        self.assertTrue(all(f"--data {self.curves}/aa5083_h116.csv --name AA5083-H116 --melting-K" in c for c in commands))

    def test_wrong_input(self):
        for arguments, text in (((), "must be a folder that holds weldox_460e.csv or aa5083_h116.csv"),
                                (("--insert",), "must not go with --curves")):
            done = self.fit("--curves", self.curves, *arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn(text, done.stderr)
            self.assertFalse((self.folder / "commands").exists())


class InsertTables(Folders):
    PAGE = "# Page\n\n<!-- table: one (a) -->\n\n| 1 |\n\n<!-- table: one (a) -->\n\ntext\n<!-- tables: P=q b -->\nold\n" \
           "<!-- tables: P=q b -->\nend\n"

    def setUp(self):
        super().setUp()
        self.page = self.folder / "page.md"
        self.page.write_text(self.PAGE)

    def insert(self, text, *arguments):
        return run("insert", self.page, *arguments, text=text)

    def test_tables_between_their_marks_are_replaced(self):
        done = self.insert("lost\n<!-- table: one (a) -->\n| 2 |\n<!-- table: one (a) -->\n")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.page.read_text(), self.PAGE.replace("| 1 |", "| 2 |"))

    def test_all_of_the_input_with_a_mark(self):
        done = self.insert("| 3 |\n| 4 |\n", "--mark", "tables: P=q b")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.page.read_text(), self.PAGE.replace("old", "\n| 3 |\n| 4 |\n"))
        self.insert("| 3 |\n| 4 |\n", "--mark", "tables: P=q b")
        self.assertEqual(self.page.read_text(), self.PAGE.replace("old", "\n| 3 |\n| 4 |\n"))

    def test_wrong_input_leaves_the_page_as_it_was(self):
        for text, arguments, said in (("| 3 |\n", ["--mark", "tables: c"], "has no <!-- tables: c -->"),
                                      ("<!-- table: one (a) -->\n| 2 |\n", [], "<!-- table: one (a) --> occurs once"),
                                      ("| 2 |\n", [], "holds no table"),
                                      ("", ["--mark", "tables: P=q b"], "holds no table")):
            self.require_refused(self.insert(text, *arguments), said)
            self.assertEqual(self.page.read_text(), self.PAGE)


if __name__ == "__main__":
    unittest.main()
