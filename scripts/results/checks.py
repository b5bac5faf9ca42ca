"""Compares results with the checks of docs/results/acceptance*.toml: one Result for each check."""

import itertools
import math
import re
from dataclasses import dataclass
from pathlib import Path

from .data import PAGE, InputError, close, half_width_mps, of_plate, read_toml, short
from .kinds import KINDS, NUMBER, Missing, limit_against_test, plate_text, residuals_against_tests, shot_text

FILES = (PAGE / "acceptance.toml", PAGE / "acceptance_beyond.toml")

# What a check compares the results with.
QUESTIONS = {"paper": "against the paper", "tests": "against the tests", "seen": "what is seen"}
UNITS = {"percent": "%", "mps": "m/s", "standard_errors": "standard errors"}
BOUND = re.compile(r"(within|at_least|at_most|above|below)(?:_(\w+))?")


@dataclass
class Bound:
    relation: str
    value: float
    unit: str

    def holds(self, measured):
        return {"within": abs(measured) <= self.value, "at_least": measured >= self.value,
                "at_most": measured <= self.value, "above": measured > self.value,
                "below": measured < self.value}[self.relation]

    def share(self, measured):
        """The used share of the bound: more than 1 where it does not hold."""
        size = abs(measured) if self.relation == "within" else measured
        share = size / self.value if size * self.value > 0 else 0
        # A floor above zero is used up by what is small, one below zero by what is large.
        if self.relation in ("at_least", "above") and self.value > 0 and share > 0:
            share = 1 / share
        return min(share, 1) if self.holds(measured) else max(share, 1.0001)

    def text(self):
        unit = UNITS.get(self.unit, self.unit)
        return f"{self.relation.replace('_', ' ')} {short(self.value)}{' ' + unit if unit else ''}"


@dataclass
class Result:
    """A check and its outcome."""
    id: str
    figures: list
    statement: str
    against: str  # paper, tests or seen
    reason: str  # for the bound
    method: str  # all: of no method in particular
    status: str  # pass, FAIL or missing
    number: str  # the measured one with its unit; empty for pictures and where it is missing
    where: str  # what the number belongs to, or what is missing
    bound: str
    share: float  # of the bound

    @property
    def measured(self):
        return f"{self.number} ({self.where})" if self.number else self.where

    def text(self):
        return f"{self.statement}: {self.measured}; bound: {self.bound}"

    def line(self):
        return f"{self.status:<7} {self.against:<5} {self.id}: {self.text()}"


class Check:
    """A [[check]] and the results that it judges."""

    def __init__(self, table, defaults, results, tests, file):
        self.results, self.tests, self.table, self.defaults = results, tests, table, defaults
        self.where = f"{file.name}: check {table.get('id', '?')}"
        for name in ("id", "statement", "kind", "against", "reason"):
            self.value(name, str)
        if table["against"] not in QUESTIONS:
            self.refuse("against", f"must be one of {', '.join(QUESTIONS)}")
        if table["kind"] not in KINDS:
            self.refuse("kind", f"must be one of {', '.join(KINDS)}")
        figures = table.get("figure")
        self.figures = figures if isinstance(figures, list) else [figures]
        if not self.figures or not all(isinstance(f, int) and 0 <= f <= 99 for f in self.figures):
            self.refuse("figure", "must be the number of a figure or a list of them, 0 for all runs")
        self.measure, units, needed, allowed = KINDS[table["kind"]]
        known = {"id", "figure", "statement", "against", "reason", "kind", "method", "model", *needed,
                 *allowed}
        self.method = self.value("method", str) if "metal" in needed else "all"
        self.bounds = []
        for name, value in table.items():
            match = BOUND.fullmatch(name)
            if name not in known and not match:
                self.refuse(name, f"is unknown: {table['kind']} takes {', '.join(sorted(known))} and bounds")
            if match:
                self.bounds.append(Bound(match[1], self.value(name, NUMBER), match[2] or ""))
        for name in needed:
            if name not in table:
                raise InputError(f"{self.where}: {name}: is required by {table['kind']}")
        if bool(self.bounds) == (table["kind"] == "picture") or len({bound.unit for bound in self.bounds}) > 1:
            raise InputError(f"{self.where}: bounds: must be one or more of the same unit, none for a picture")
        units = self.units_of_quantity() if units is None else units
        if self.bounds and self.bounds[0].unit not in units:
            self.refuse("kind", "takes bounds " + " or ".join("in " + u if u else "without unit" for u in units))

    def refuse(self, name, problem):
        raise InputError(f"{self.where}: {name} = {self.table.get(name)!r}: {problem}")

    def value(self, name, kind=None):
        """A value of the check or else of [defaults]."""
        value = self.table.get(name, self.defaults.get(name))
        if kind and (not isinstance(value, kind) or isinstance(value, bool)):
            self.refuse(name, "must be a text" if kind is str else "must be a number")
        return value

    def several(self, name, kind):
        """One value or a list of them, as a list."""
        values = self.value(name) if isinstance(self.value(name), list) else [self.value(name)]
        if not values or not all(isinstance(v, kind) and not isinstance(v, bool) for v in values):
            self.refuse(name, "must be a text or a list of texts" if kind is str else "must be a number or a list")
        return values

    def units_of_quantity(self):
        """The units of the bounds of a quantity, which ends with its own; the ratio of two has none. A number without unit
        may be held against percent."""
        ending = self.value("quantity", str).rsplit("_", 1)[-1]
        return (ending,) if ending in ("mm", "mps", "g", "K", "us") and not self.value("per") else ("", "percent")

    def factor(self):
        return 100 if self.bounds[0].unit == "percent" else 1

    def plates(self):
        """All noses with all thicknesses."""
        return list(itertools.product(self.several("nose", str), self.several("thickness_mm", NUMBER)))

    def distance_mm(self, nose, metal=None, thickness_mm=None):
        """Particle distance of the shots of a nose, on any plate or on one, that a check is about."""
        listed = self.tests.distance_mm(nose, metal, thickness_mm)
        if listed is None:
            self.refuse("nose", "must be of a plate that has a shot in figure_shots.csv")
        return listed

    def _series(self, rows, nose, thickness_mm, model=None):
        metal = self.value("metal", str)
        return of_plate(rows, metal, nose, thickness_mm, model or self.value("model", str), self.value("method", str),
                        spacing_mm=self.distance_mm(nose, metal, thickness_mm))

    def shots(self, nose, thickness_mm, model=None):
        """Those of the law of the check or of another one."""
        return self._series(self.results.shots, nose, thickness_mm, model)

    def shot(self, nose, thickness_mm):
        """The one that the check is about: at velocity_mps, or the slowest that perforated once the limit is known."""
        shots = self.shots(nose, thickness_mm)
        if "velocity_mps" in self.table:
            velocity = self.value("velocity_mps", NUMBER)
            found, what = [s for s in shots if close(s["initial_velocity_mps"], velocity)], f"at {short(velocity)} m/s"
        else:
            self.limit(nose, thickness_mm)
            found, what = [s for s in shots if s["perforated"]], "that perforated"
        if not found:
            raise Missing(f"no shot {what}, {plate_text(nose, thickness_mm)}")
        return min(found, key=lambda s: s["initial_velocity_mps"])

    def limit(self, nose, thickness_mm):
        """The row with a ballistic limit that bisection has found closely enough."""
        rows = self._series(self.results.limits, nose, thickness_mm)
        half = half_width_mps(rows[0]) if rows else None
        widest = self.value("widest_bracket_mps", NUMBER)
        if half is None or 2 * half > widest:
            raise Missing(f"no limit to {short(widest / 2)} m/s by bisection, {plate_text(nose, thickness_mm)}")
        return rows[0]

    def column(self, row, name):
        if name in row.text and not row.text[name]:
            raise Missing(f"no {name}, {shot_text(row)}")
        if row.get(name) is None or isinstance(row[name], str):
            self.refuse(name if name in self.table else "quantity",
                        f"must be a column of numbers of {', '.join(row.text)}")
        return row[name]

    def result(self):
        try:
            status, number, where, share = self.judged(list(self.measure(self)))
        except Missing as missing:
            status, number, where, share = "missing", "", str(missing), math.inf
        bound = " and ".join(bound.text() for bound in self.bounds) or "it is there"
        table = self.table
        return Result(table["id"], self.figures, table["statement"], table["against"], table["reason"], self.method, status,
                      number, where, bound, share)

    def is_yes_or_no(self):
        """Whether a bound that is kept is used up by nothing: counts, and whether a plate is perforated."""
        return self.table["kind"] == "perforating_velocities" or self.table.get("quantity") == "perforated"

    def judged(self, measured):
        """Status, number, what it belongs to and share of the worst value."""
        share, value, where = max(((max((b.share(v) for b in self.bounds), default=0), v, text)
                                   for v, text in measured), key=lambda found: found[0])
        if not self.bounds:
            return "pass", "", where, share
        unit = UNITS.get(self.bounds[0].unit, self.bounds[0].unit)
        deviates = (self.measure in (limit_against_test, residuals_against_tests)
                    or any(bound.relation == "within" for bound in self.bounds))
        number = f"{'+' if deviates and value > 0 else ''}{short(value, 3)}{' ' + unit if unit else ''}"
        if not all(bound.holds(value) for bound in self.bounds):
            return "FAIL", number, where, share
        return "pass", number, where, 0 if self.is_yes_or_no() else share


def run_checks(results, tests, files=FILES):
    """All checks of some files."""
    checks = []
    for file in files:
        tables = read_toml(file)
        defaults = tables.get("defaults", {})
        if not tables.get("check"):
            raise InputError(f"{file}: has no [[check]]")
        checks += [Check(table, defaults, results, tests, Path(file)) for table in tables["check"]]
    ids = [check.table["id"] for check in checks]
    for name in (name for name in ids if ids.count(name) > 1):
        raise InputError(f"{', '.join(map(str, files))}: id = {name}: must be the id of one check only")
    return [check.result() for check in checks]
