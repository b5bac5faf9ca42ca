"""scripts/results: bounds, verdicts, numbers and texts."""

import tempfile
import unittest
from pathlib import Path

from made_up import SHOT_HEADER, SHOTS, run
from results.checks import Bound, Result
from results.data import ended_by_time, read_shots, short
from results.page import from_markdown
from results.verdicts import counts, headline, of_method, verdict_of


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


if __name__ == "__main__":
    unittest.main()
