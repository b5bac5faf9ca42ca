"""Made-up results for the tests of scripts/results."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))

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
