"""scripts/results: tables are put into a page."""

import unittest

from made_up import Folders, run


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
