#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""browser_test.py <ogive> <folder>: a page of `ogive view` in Chromium. Skipped where Chromium or three.js is missing."""
import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

from browser import Browser, chromium, pixels

SKIPPED = 77
SHOT = ["--spacing-mm", "2", "--sph-radius-mm", "15", "--clamp-radius-mm", "30", "--thickness-mm", "4", "--projectile",
        "rigid", "--velocity-mps", "200", "--end-us", "40", "--output-every-us", "10", "--no-picture", "--quiet"]
ogive, folder = sys.argv[1], Path(sys.argv[2])


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        for arguments in (["shoot", *SHOT, "--out", folder / "shot"], ["view", folder / "shot"]):
            subprocess.run([ogive, *arguments], check=True, stdout=subprocess.DEVNULL)
        cls.browser = Browser((620, 400))
        cls.addClassCleanup(cls.browser.__exit__)
        cls.browser.open((folder / "shot/view.html").resolve())
        cls.browser.wait_for("document.body && document.body.dataset.readyMs")

    def setUp(self):
        self.browser.press("2")
        self.browser.press("Home")
        self.wait_for_frame(0)

    def tearDown(self):
        self.assertEqual(self.browser.problems, [])

    def wait_for_frame(self, k):
        self.browser.wait_for(f"document.body.dataset.frame === '{k}'")

    def text(self, element):
        return self.browser.value(f"document.getElementById('{element}').textContent")

    def changed_by(self, act):
        before = self.browser.picture("main")
        act()
        return self.browser.picture("main") != before

    def test_picture_is_not_blank(self):
        width, height, colours = pixels(self.browser.picture("main"))
        drawn = [colour for colour in colours if colour != (255, 255, 255)]
        # Plate and projectile fill a good part of the view, in many shades.
        self.assertGreater(len(drawn), width * height / 20)
        self.assertGreater(len(set(drawn)), 50)

    def test_slider_changes_picture_time_and_curve(self):
        def slide():
            self.browser.value("document.getElementById('time').value = 3;"
                               "document.getElementById('time').dispatchEvent(new Event('input'))")
            self.wait_for_frame(3)

        mark = "document.querySelector('#curve circle').getAttribute('cx')"
        before = self.browser.value(mark)
        self.assertTrue(self.text("when").startswith("0.0 µs, 200.0 m/s"), self.text("when"))
        self.assertTrue(self.changed_by(slide))
        self.assertTrue(self.text("when").startswith("30."), self.text("when"))
        self.assertGreater(float(self.browser.value(mark)), float(before) + 50)

    def test_keyboard(self):
        press = self.browser.press
        press("ArrowRight")
        self.wait_for_frame(1)
        press("End")
        last = self.browser.value("document.getElementById('time').max")
        self.wait_for_frame(last)
        for name, act in (("field", lambda: press("f")), ("view", lambda: press("5")), ("cut", lambda: press("c")),
                          ("turned", lambda: press("ArrowLeft", shift=True)), ("lines", lambda: press("m")),
                          ("hidden", lambda: press("h")), ("shown", lambda: press("h")),
                          ("zoom", lambda: press("+")), ("section", lambda: press("1"))):
            with self.subTest(name):
                self.assertTrue(self.changed_by(act))
        press(" ")
        self.browser.wait_for("document.body.dataset.frame === '1'")
        self.assertEqual(self.text("play"), "pause")
        press(" ")
        self.assertEqual(self.text("play"), "play")

    def test_values_under_pointer(self):
        self.browser.press("1")
        x, y = self.browser.value("(() => { const b = document.getElementById('canvas').getBoundingClientRect();"
                                  "return [b.x + b.width / 2, b.y + b.height / 4]; })()")
        self.browser.point(x, y)
        self.browser.wait_for("!document.getElementById('values').hidden")
        values = self.text("values")
        self.assertTrue(values.startswith("projectile, hex"), values)
        self.assertIn("speed: 200 m/s", values)
        self.browser.point(5, 395)
        self.browser.wait_for("document.getElementById('values').hidden")

    def test_range(self):
        def narrow():
            self.browser.value("document.getElementById('high').value = 0.01;"
                               "document.getElementById('high').dispatchEvent(new Event('change'))")

        self.browser.press("End")
        self.wait_for_frame(self.browser.value("document.getElementById('time').max"))
        self.browser.value("document.getElementById('field').selectedIndex = 0;"
                           "document.getElementById('field').dispatchEvent(new Event('change'))")
        self.assertTrue(self.changed_by(narrow))
        self.assertTrue(self.text("ticks").endswith("0.01"), self.text("ticks"))


if __name__ == "__main__":
    missing = [name for name, there in (("chromium", chromium()), (
        "libjs-three", os.path.exists("/usr/share/javascript/three/three.min.js"))) if not there]
    if missing:
        print("SKIPPED: needs the Debian packages", ", ".join(missing))
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)
