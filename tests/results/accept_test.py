"""scripts/results: checks with made-up results."""

import re
import unittest

from made_up import CHECKS, LIMITS, SHOT_HEADER, SHOTS, Folders, run
from results.checks import run_checks
from results.data import Results, Tests


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


if __name__ == "__main__":
    unittest.main()
