"""The page of results: index.html, which opens from the disk, beside it the pictures, data/*.csv with what was computed
and run_record.* with how. Nothing is judged here: see checks.py and verdicts.py."""

import json
import os
import re
import shutil
import sys
from pathlib import Path
from typing import NamedTuple

import jinja2
import markdown
from markupsafe import Markup

from . import data
from .checks import FILES, QUESTIONS, run_checks
from .data import (KEY_COLUMNS, LAWS, PROGRAMS, RECORD_COLUMNS, ROOT, InputError, close, csv_text, ended_by_time,
                   half_width_mps, of_plate, percent_of, plate_of, short, stale_limits, write_text)
from .kinds import shot_text
from .verdicts import headline, of_figure, of_method, read_facts, summary, verdicts_of


class Table(NamedTuple):
    """Cells are texts; columns in `numbers` are flush right."""
    header: list
    rows: list
    numbers: range


def signed(value, decimals=1):
    return "–" if value is None else f"{value:+.{decimals}f}".replace("-", "−")


def fixed(value, decimals=1, error=None):
    """A number with its error, if there is one; a dash for None."""
    return "–" if value is None else f"{value:.{decimals}f}" + ("" if error is None else f" ± {error:.{decimals}f}")


class Page:
    """All that was read, the results of the checks, and the tables that the template lays out."""

    def __init__(self, folder, checks, spacing_mm=None):
        self.results, self.tests, self.facts = data.Results(folder), data.Tests(spacing_mm), read_facts()
        self.spacing_mm = spacing_mm
        self.late_shots = "; ".join(f"{shot_text(s)}: {short(s['residual_velocity_mps'])} m/s" for s in self.results.shots
                                    if ended_by_time(s))
        self.methods = sorted({row["method"] for row in self.results.shots})
        self.beyond_methods = [method for method in self.methods if method != "paper"]
        results = run_checks(self.results, self.tests, checks)
        self.checks = of_method(results, "paper")
        self.beyond = [r for r in results if r.method in self.beyond_methods]

    def checks_of(self, figure, method="paper"):
        return of_figure(of_method([*self.checks, *self.beyond], method), figure)

    def of_listed(self, rows, plate, model, method="paper"):
        """Rows of shots or limits of a plate, with the particle distance of the list."""
        metal, nose, thickness_mm = plate
        return of_plate(rows, *plate, model, method, spacing_mm=self.tests.distance_mm(nose, metal, thickness_mm))

    def limit(self, plate, model, method="paper"):
        return next(iter(self.of_listed(self.results.limits, plate, model, method)), None)

    def shot(self, plate, velocity_mps, model):
        return next((s for s in self.of_listed(self.results.shots, plate, model)
                     if close(s["initial_velocity_mps"], velocity_mps, 0.05)), None)

    def shots_of_figure(self, figure):
        """Rows of the shots that a figure needs: those of its pictures and all of the series of its curves."""
        def needs(row, shot):
            return (row["figure"] == figure and row["model"] in ("both", shot["model"])
                    and all(row[column] == shot[column] for column in ("material", "nose", "thickness_mm"))
                    and (row["use"] == "curve" or row["initial_velocity_mps"] == shot["initial_velocity_mps"]))

        return [shot for shot in self.results.shots if any(needs(row, shot) for row in self.tests.listed)]

    def core_minutes(self, shots):
        return sum(s["cpu_s"] for s in shots if s.get("cpu_s")) / 60

    def picture_shots(self, figure):
        """(row of the list, row of the shot or None) for each shot of a picture."""
        return [(row, self.shot(plate_of(row), row["initial_velocity_mps"], row["model"])) for row in self.tests.listed
                if row["figure"] == figure and row["use"] == "picture"]

    def missing_shots(self, figure):
        return "; ".join(f"{short(row['thickness_mm'])} mm, {short(row['initial_velocity_mps'])} m/s"
                         for row, shot in self.picture_shots(figure) if shot is None)

    def cost(self, fact):
        """Processor time of the shots of a figure, min."""
        if "runs_of" in fact:
            return f"with Fig.\u00a0{fact['runs_of']}"
        minutes = self.core_minutes(self.shots_of_figure(fact["number"]))
        return short(minutes, 2) if minutes else "–"

    def scoreboard(self, method="paper"):
        """(fact, verdicts, headline, cost) of each figure that a method has checks for, and of all runs; all figures of
        the paper's method."""
        facts = [*self.facts, {"number": 0, "title": "Every run: energy and contact"}]
        found = [(fact, self.checks_of(fact["number"], method)) for fact in facts]
        return [(fact, verdicts_of(results), headline(fact, results),
                 self.cost(fact) if fact["number"] else short(self.core_minutes(self.results.shots), 3))
                for fact, results in found if results or (fact["number"] and method == "paper")]

    def counted(self):
        """How many figures agree with the paper, the tests and so on: (question, text)."""
        for question, text in QUESTIONS.items():
            words = [verdicts[question].word for fact, verdicts, *_ in self.scoreboard() if fact["number"]]
            yield text, ", ".join(f"{words.count(word)} {plural}" for word, plural in (
                ("agrees", "agree"), ("partly", "partly"), ("differs", "differ"), ("not run yet", "not run yet"))
                if word in words) or "no checks"

    def constants(self, fact):
        """Fitted constants beside published ones. Both laws: a is n, b is m."""
        names = (("A_MPa", "A_MPa", 1), ("B_MPa", "B_MPa", 1), ("a", "n", 4), ("C", "C", 5), ("b", "m", 4))
        rows = [[published["text"], *(f"{published[name]:g}" if name in published else "–" for name, *_ in names), "–"]
                for published in fact.get("published", [])]
        for fit in fact.get("fits", []):
            values = {row["parameter"]: row for row in self.results.fits if row["fit"] == fit["fit"]}
            if not values:
                continue
            cells = []
            for name, other, decimals in names:
                row = values.get(name) or values.get(other)
                cells.append(fixed(row["value"], decimals, row["standard_error"]) if row else "–")
            rms = values.get("rms_percent")
            rows.append([fit["text"], *cells, fixed(rms and rms["value"], 2)])
        return Table(["", "A, MPa", "B, MPa", "a (n)", "C", "b (m)", "misfit, %"], rows, range(1, 7))

    def has_fits(self, fact):
        return any(row["fit"] == fit["fit"] for fit in fact.get("fits", []) for row in self.results.fits)

    def plates_of(self, fact):
        return [(group["metal"], group["nose"], thickness) for group in fact.get("tests", [])
                for thickness in group["thickness_mm"]]

    def _limit_cells(self, plate, model, method="paper"):
        row = self.limit(plate, model, method)
        computed = row and row["bisection_limit_mps"]
        return [fixed(computed, 1, row and half_width_mps(row)),
                signed(percent_of(computed, self.tests.limit_mps(*plate)))]

    def limits_beside_tests(self, fact):
        rows = []
        for plate in self.plates_of(fact):
            test, paper = self.tests.limit_mps(*plate), self.tests.paper_velocity_mps(*plate)
            rows.append([plate_name(plate), short(test), *(c for model in LAWS for c in self._limit_cells(plate, model)),
                         short(paper), signed(percent_of(paper, test))])
        return Table(["plate", "test, m/s", "MJC, m/s", "error, %", "JC, m/s", "error, %", "paper*, m/s", "error, %"], rows,
                     range(1, 8))

    def sources_of_tests(self, fact):
        tests = filter(None, (self.tests.limit_of(*plate) for plate in self.plates_of(fact)))
        return "; ".join(dict.fromkeys(f"{test['source']} ({test['confidence']})" for test in tests))

    def shots_beside_tests(self, fact):
        rows = []
        for plate in self.plates_of(fact) if "runs_of" not in fact else []:
            for test in self.tests.shots_of(*plate):
                velocity, residual = test["initial_velocity_mps"], test["residual_velocity_mps"]
                found = [self.shot(plate, velocity, model) for model in LAWS]
                if not any(found):
                    continue
                cells = [f"{short(plate[2])} mm, {plate[1]}", fixed(velocity), fixed(residual)]
                for row in found:
                    computed = row and row["residual_velocity_mps"]
                    cells += [fixed(computed), signed(None if computed is None else computed - residual)]
                rows.append(cells)
        return Table(["plate", "initial, m/s", "test, m/s", "MJC, m/s", "error, m/s", "JC, m/s", "error, m/s"], rows,
                     range(1, 7))

    def table_of_picture(self, fact):
        columns = {"plug_mass_g": 1, "plug_thickness_mm": 1, "dishing_mm": 1, "kept_fraction": 2,
                   "band_temperature_K": 0, "core_temperature_K": 0}
        rows = []
        for listed, shot in self.picture_shots(fact["number"]):
            rows.append([f"{short(listed['thickness_mm'])} mm, {listed['nose']}", short(listed["initial_velocity_mps"]),
                         short(self.tests.limit_mps(*plate_of(listed)))])
            rows[-1] += ["not run yet"] + ["–"] * 7 if shot is None else [
                {None: "undecided", 0: "no"}.get(shot["perforated"], "yes"), fixed(shot["residual_velocity_mps"]),
                *(fixed(shot.get(name), decimals) for name, decimals in columns.items())]
        return Table(["plate", "initial, m/s", "measured limit, m/s", "perforated", "residual, m/s", "plug, g", "plug, mm",
                      "dishing, mm", "kept in the way", "band, K", "plug's core, K"], rows, (1, 2, *range(4, 11)))

    def limits(self):
        rows = []
        for r in sorted(self.results.limits, key=lambda r: (*steel_first(plate_of(r)), r["model"] != "mjc", r["method"])):
            limit, fit, test, paper = (r[c] for c in ("bisection_limit_mps", "fit_limit_mps", "test_limit_mps",
                                                      "paper_velocity_mps"))

            def parameter(name, r=r):
                origin = r.get(f"fit_{name}_origin")
                return fixed(r[f"fit_{name}"], 2, r[f"fit_{name}_se"]) + (
                    f" ({origin})" if origin and origin != "fitted" else "")

            rows.append([plate_name(plate_of(r)),
                         LAWS.get(r["model"], r["model"]) + ("" if len(self.methods) < 2 else f", {r['method']}"),
                         short(r["spacing_mm"]),
                         fixed(limit, 1, half_width_mps(r)) + ("" if r["consistent"] else " †"),
                         fixed(fit, 1, r["fit_limit_se_mps"]), parameter("a"), parameter("p"),
                         signed(fit - limit if fit and limit else None),
                         short(r["fit_points"]) if r["fit_points"] else "–", short(test), signed(percent_of(limit, test)),
                         short(paper), signed(percent_of(paper, test))])
        return Table(["plate", "law", "particles, mm", "bisection, m/s", "fit v_bl, m/s", "a", "p", "fit − bisection, m/s", "shots",
                      "test, m/s", "error, %", "paper, m/s", "error, %"], rows, range(2, 13))

    def beyond_limits(self):
        methods = ["paper", *self.beyond_methods]
        plates = {plate_of(r) for r in self.results.limits if r["method"] != "paper"}
        rows = [[plate_name(plate), short(self.tests.limit_mps(*plate)),
                 *(cell for method in methods for cell in self._limit_cells(plate, "mjc", method))]
                for plate in sorted(plates, key=steel_first)]
        heads = [text for method in ("paper's method", *methods[1:]) for text in (f"{method}, m/s", "error, %")]
        return Table(["plate", "test, m/s", *heads], rows, range(1, 2 + len(heads)))

    def cost_ratio(self, method):
        """Processor time of a method's shots over that of the paper's method for the same shots; None without any."""
        def seconds(method):
            return {s.key(KEY_COLUMNS[1:]): s["cpu_s"] for s in self.results.shots
                    if s["method"] == method and s.get("cpu_s")}

        ours, paper = seconds(method), seconds("paper")
        both = sorted(ours.keys() & paper.keys())
        return sum(ours[key] for key in both) / sum(paper[key] for key in both) if both else None


def plate_name(plate):
    return f"{short(plate[2])} mm {plate[0]}, {plate[1]}"


def steel_first(plate):
    return plate[0] != "Weldox 460 E", *plate[1:]


def document(name, link_prefix):
    return from_markdown((ROOT / "docs" / name).read_text(encoding="utf-8"), link_prefix)


def from_markdown(text, link_prefix):
    """Markdown without its title as HTML. Links to files get `link_prefix`, or are dropped if it is None."""
    text = re.sub(r"^(?!- | )(.+)\n(?=- )", r"\1\n\n", text, flags=re.MULTILINE)  # lists need a blank line before
    text = markdown.markdown(re.sub(r"^# .*\n", "", text), extensions=["tables"])
    if link_prefix is None:
        text = re.sub(r'<a href="(?!https?:)[^"]*">(.*?)</a>', r"\1", text)
    else:
        text = re.sub(r'href="(?!https?:)', f'href="{link_prefix}', text)
    text = text.replace("<table>", '<div class="scroll"><table>').replace("</table>", "</table></div>")
    return Markup(text.replace("h2>", "h3>"))


def build_of(folder):
    """Compiler, build type and flags of a build folder, as far as they are there."""
    def content(pattern):
        file = next(iter(sorted(folder.glob(pattern))), None)
        return file.read_text(encoding="utf-8", errors="replace") if file else ""

    cache = dict(re.findall(r"^([\w-]+):\w+=(.*)$", content("CMakeCache.txt"), re.MULTILINE))
    compiler = dict(re.findall(r'set\(CMAKE_CXX_COMPILER_(ID|VERSION) "([^"]*)"\)',
                               content("CMakeFiles/*/CMakeCXXCompiler.cmake")))
    # Those of the program that runs the shots.
    flags = re.search(r"^build apps/\S*ogive\w*\.dir/\S*main\.cpp\.o:.*\n(?:  .*\n)*?  FLAGS = (.*)",
                      content("build.ninja"), re.MULTILINE)
    return {"compiler": " ".join(compiler.values()) or None, "build_type": cache.get("CMAKE_BUILD_TYPE"),
            "flags": flags[1] if flags else None}


def cpu_models(record):
    """This machine's and those of an earlier record: the rows of a page may come from several machines."""
    try:
        text = Path("/proc/cpuinfo").read_text(encoding="utf-8", errors="replace")
    except OSError:
        text = ""
    found = re.findall(r"^model name\s*:\s*(.*)$", text, re.MULTILINE)
    return sorted({*(data.read_json(record).get("cpu_models", []) if record.exists() else []),
                   *(name.strip() for name in found)})


def run_record(page, before):
    shots = page.results.shots
    return {"version": sorted({s["version"] for s in shots if s.get("version")}), **build_of(PROGRAMS.parent),
            "cpu_models": cpu_models(before), "cores": os.cpu_count(), "shots": len(shots),
            "threads": sorted({int(s["threads"]) for s in shots if s.get("threads")}),
            "core_minutes": round(page.core_minutes(shots), 1)}


def write_tables(results, out):
    """What was computed, without how long it took and with what: two campaigns can be compared byte for byte."""
    columns = list(results.shots[0].text) if results.shots else list(data.SHOT_COLUMNS)
    for name, header, rows in (
            ("data/shots.csv", [c for c in columns if c not in RECORD_COLUMNS], results.shots),
            ("data/limits.csv", list(results.limits[0].text) if results.limits else data.LIMIT_COLUMNS, results.limits),
            ("data/projectiles.csv", data.PROJECTILE_COLUMNS, results.projectiles),
            ("data/fits.csv", data.FIT_COLUMNS, results.fits),
            ("run_record.csv", [*KEY_COLUMNS, *(c for c in RECORD_COLUMNS if c in columns)], results.shots)):
        write_text(out / name, csv_text(header, rows))


def copy_pictures(facts, folder, out):
    """Copies the pictures that are there, takes those away that are not, and returns the names of the former."""
    there = set()
    for picture in (picture for fact in facts for picture in fact["pictures"]):
        source, target = folder / picture.get("from", picture["file"]), out / picture["file"]
        if source.exists():
            shutil.copyfile(source, target)
            there.add(picture["file"])
        else:
            target.unlink(missing_ok=True)
    return there


def link_prefix_of(out):
    """From the page to docs/; None where the page lies outside the project."""
    relative = os.path.relpath(ROOT / "docs", out.resolve())
    return relative.replace(os.sep, "/") + "/" if out.resolve().is_relative_to(ROOT) else None


def make_page(folder, out, checks=None, spacing_mm=None):
    """Makes the page of the results in `folder`."""
    if out.resolve() == folder.resolve():
        raise InputError(f"OUT = {out}: must not be the folder with the results")
    page = Page(folder, checks or FILES, spacing_mm)
    out.mkdir(parents=True, exist_ok=True)
    write_tables(page.results, out)
    record = run_record(page, out / "run_record.json")
    write_text(out / "run_record.json", json.dumps(record, indent=2, ensure_ascii=False) + "\n")
    pictures, prefix = copy_pictures(page.facts, folder, out), link_prefix_of(out)
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(Path(__file__).parent / "templates"), autoescape=True,
                                     trim_blocks=True, lstrip_blocks=True, undefined=jinja2.StrictUndefined)
    environment.filters["short"] = short
    environment.globals.update(summary=summary, shot_text=shot_text, stale_limits=stale_limits,
                               questions=QUESTIONS, verdicts_of=verdicts_of, headline=headline,
                               document=lambda name: document(name, prefix))
    write_text(out / "index.html", environment.get_template("page.html").render(page=page, pictures=pictures, record=record,
                                                                                prefix=prefix) + "\n")
    for line in stale_limits(page.results):
        print(f"results: {line}", file=sys.stderr)
    print(f"{out / 'index.html'}: {len(page.results.shots)} shots, {len(pictures)} pictures, checks: "
          f"{summary([*page.checks, *page.beyond])}")
