"""docs/doxygen/check_links.py finds what is broken on a site, and nothing else."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "docs/doxygen/check_links.py"


def check(**files):
    """Status and output for a site of these pages; `menu` is Doxygen's menudata.js."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            target = "menudata.js" if name == "menu" else f"{name}.html"
            pathlib.Path(folder, target).write_text(text, encoding="utf-8")
        run = subprocess.run([sys.executable, SCRIPT, folder], capture_output=True, text=True, check=False)
        return run.returncode, run.stdout


class Links(unittest.TestCase):
    def test_good_site(self):
        status, text = check(a='<a href="b.html#here">b</a><a href="#own" id="own">own</a>',
                             b='<p id="here"><a name="there" href="a.html">a</a><a href="https://example.org">far</a>',
                             menu='{url:"a.html"},{url:"b.html#there"}')
        self.assertEqual((0, "2 pages, 5 links checked, 0 broken; 1 to other sites not followed\n"), (status, text))

    def test_what_is_broken(self):
        for site, reason in (({"a": '<img src="gone.png">'}, "a.html:1: gone.png: no such file"),
                             ({"a": '<a href="#gone">x</a>'}, "a.html:1: #gone: no such place"),
                             ({"a": '<a href="../outside.html">x</a>'}, "no such file"),
                             ({"a": "", "menu": '{url:"gone.html"}'}, "menudata.js:1: gone.html: no such file")):
            status, text = check(**site)
            self.assertEqual(1, status)
            self.assertIn(reason, text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
