"""Whether the recipes in packaging/ agree with the project, as far as that can be told without their programs."""
import ast
import json
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
VERSION = re.search(r'version\[\] = "([\d.]+)"', (ROOT / "include/ogive/version.hpp").read_text())[1]
OPTIONS = set(re.findall(r"option\((OGIVE_\w+)", (ROOT / "CMakeLists.txt").read_text()))
RECIPES = [path for path in (ROOT / "packaging").rglob("*") if path.is_file()]


def constants(path):
    """The texts that stand in a Python file."""
    return [node.value for node in ast.walk(ast.parse(path.read_text(), path))
            if isinstance(node, ast.Constant) and isinstance(node.value, str)]


class Recipes(unittest.TestCase):
    def test_python_is_valid(self):
        python = [path for path in RECIPES if path.suffix == ".py"]
        self.assertEqual(3, len(python))
        for path in python:
            ast.parse(path.read_text(), path)

    def test_vcpkg(self):
        port = json.loads((ROOT / "packaging/vcpkg/ogive/vcpkg.json").read_text())
        self.assertEqual(VERSION, port["version-semver"])
        self.assertRegex(port["name"], r"^[a-z0-9]+(-[a-z0-9]+)*$")
        self.assertTrue({"name", "version-semver", "description", "license", "dependencies"} <= port.keys())
        for dependency in port["dependencies"]:
            self.assertTrue(isinstance(dependency, str) or "name" in dependency)

    def test_versions(self):
        self.assertIn(VERSION, constants(ROOT / "packaging/conan/conanfile.py"))
        self.assertIn(VERSION, constants(ROOT / "packaging/spack/packages/ogive/package.py"))

    def test_options_exist(self):
        portfile = (ROOT / "packaging/vcpkg/ogive/portfile.cmake").read_text()
        self.assertEqual(set(), set(re.findall(r"-D(OGIVE_\w+)", portfile)) - OPTIONS)
        for recipe in ("conan/conanfile.py", "spack/packages/ogive/package.py"):
            named = {f"OGIVE_{text}" for text in constants(ROOT / "packaging" / recipe) if text.startswith("BUILD_")}
            self.assertEqual(4, len(named))
            self.assertEqual(set(), named - OPTIONS)

    def test_citation(self):
        citation = (ROOT / "CITATION.cff").read_text()
        self.assertIn(f"\nversion: {VERSION}\n", citation)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
