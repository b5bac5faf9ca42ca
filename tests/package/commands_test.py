"""docs/doxygen/commands.py makes a page of each subcommand from the help of a program."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "docs/doxygen/commands.py"

OVERVIEW = """tool COMMAND [options]: a tool

Commands:
  shoot                           shoot at a plate
  completion                      print completion: source <(tool completion)

Examples:
  tool shoot
"""

SHOOT = """ogive shoot [options]
Fires one shot. Prints
the residual velocity.
In brackets: the default, and its source.

Plate:
  --thickness-mm X                of the plate; 0.05 to 500 mm [12: paper, Fig. 11]
  --layer-materials NAME,NAME,... of the plates, as for --material,
                                  with commas [those of --material: the same]
  --a-flag-that-needs-a-line-of-its-own NAME|FILE.toml
                                  a metal, or a file: one of my_steel, or
                                  another [none]

General:
  --help                          print help

Examples:
  ogive shoot --thickness-mm 8 \\
    --out quick

Exit status: 0 done; 2 wrong input, nothing
was run; 130, 143 or 129 interrupted; 1 anything else.
"""

HEADER = "| option | meaning | limits | default | source or note |\n| --- | --- | --- | --- | --- |\n"


def pages(*program):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, SCRIPT, f"{folder}/pages", *program], check=True)
        return {path.name: path.read_text(encoding="utf-8") for path in pathlib.Path(folder, "pages").iterdir()}


class Commands(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            fake = pathlib.Path(folder, "ogive")
            fake.write_text(f"#!{sys.executable}\nimport sys\n"
                            f"print({{'shoot': {SHOOT!r}, 'completion': '_ogive() {{ :; }}'}}.get(sys.argv[1], {OVERVIEW!r}), end='')\n",
                            encoding="utf-8")
            fake.chmod(0o755)
            cls.pages = pages(fake)

    def test_list(self):
        self.assertEqual({"commands.md", "command_shoot.md", "command_completion.md"}, set(self.pages))
        self.assertTrue(self.pages["commands.md"].endswith(
            "| command | task |\n| --- | --- |\n| [ogive shoot](@ref command_shoot) | shoot at a plate |\n"
            "| [ogive completion](@ref command_completion) | print completion: source `<(tool completion)` |\n"))

    def test_syntax_and_purpose(self):
        self.assertTrue(self.pages["command_shoot.md"].startswith(
            "# ogive shoot {#command_shoot}\n\nShoot at a plate.\n\n```\nogive shoot [options]\n```\n\n"
            "Fires one shot. Prints the residual velocity.\n\n## Plate\n\n"))

    def test_options_in_groups_and_long_lines(self):
        self.assertIn("## Plate\n\n" + HEADER +
                      "| `--thickness-mm X` | of the plate | 0.05 to 500 mm | 12 | paper, Fig. 11 |\n"
                      "| `--layer-materials NAME,NAME,...` | of the plates, as for `--material`, with commas |  | "
                      "those of `--material` | the same |\n"
                      "| `--a-flag-that-needs-a-line-of-its-own NAME\\|FILE.toml` | a metal, or a file: one of `my_steel`, or "
                      "another |  | none |  |\n\n## General\n\n" + HEADER + "| `--help` | print help |  |  |  |\n\n",
                      self.pages["command_shoot.md"])

    def test_examples_and_exit_statuses(self):
        self.assertTrue(self.pages["command_shoot.md"].endswith(
            "## Examples\n\n```\nogive shoot --thickness-mm 8 \\\n  --out quick\n```\n\n## Exit status\n\n"
            "| status | meaning |\n| --- | --- |\n| 0 | done |\n| 2 | wrong input, nothing was run |\n"
            "| 130, 143 or 129 | interrupted |\n| 1 | anything else |\n"))

    def test_a_command_without_help_has_its_summary(self):
        self.assertEqual("# ogive completion {#command_completion}\n\nPrint completion: source `<(tool completion)`.\n",
                         self.pages["command_completion.md"])

    def test_without_a_program(self):
        for found in (pages(), pages("/no/such/program")):
            self.assertEqual(["commands.md"], list(found))
            self.assertIn("{#commands}", found["commands.md"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
