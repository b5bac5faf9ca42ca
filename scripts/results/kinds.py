"""The kinds of checks that docs/results/acceptance.toml may name. Each takes a Check of checks.py, which knows
parameters, bounds and results, and returns what it measured as a list of (value, where or what); the worst of them
counts."""

import itertools
import math

from .data import close, metal_of, percent_of, short


class Missing(Exception):
    """What a check needs has not been computed."""


def plate_text(nose, thickness_mm):
    return f"{nose}, {short(thickness_mm)} mm"


def shot_text(row):
    velocity = short(row["initial_velocity_mps"], 5)
    method = "" if row["method"] == "sfm" else f"{row['method']}, "
    return f"{method}{row['model']}, {plate_text(row['nose'], row['thickness_mm'])}, {velocity} m/s"


def limit_against_test(check):
    check.unit("percent")
    measured = []
    for nose, thickness in check.plates():
        row = check.limit(nose, thickness)
        if row["test_limit_mps"] is None:
            raise Missing(f"no test, {plate_text(nose, thickness)}")
        limit, test = row["bisection_limit_mps"], row["test_limit_mps"]
        measured.append((percent_of(limit, test), f"{short(limit)} m/s, test {short(test)} m/s"))
    return measured


def residuals_against_tests(check):
    check.unit("mps")
    slowest, measured = check.value("from_velocity_mps", (int, float)), []
    for nose, thickness in check.plates():
        shots = check.shots(nose, thickness)
        for test in check.tests.shots_of(check.value("metal", str), nose, thickness):
            velocity = test["initial_velocity_mps"]
            if velocity < slowest:
                continue
            found = [s for s in shots if close(s["initial_velocity_mps"], velocity, 0.05)]
            if not found:
                raise Missing(f"no shot at {short(velocity)} m/s, {plate_text(nose, thickness)}")
            computed = found[0]["residual_velocity_mps"]
            measured.append((computed - test["residual_velocity_mps"],
                             f"{short(computed)} m/s, test {short(test['residual_velocity_mps'])} m/s, at "
                             f"{short(velocity)} m/s, the farthest off"))
    if not measured:
        raise Missing(f"no test at {short(slowest)} m/s or faster")
    return measured


def limits_rise(check):
    check.unit("mps")
    limits = [(t, check.limit(nose, t)["bisection_limit_mps"]) for nose, t in check.plates()]
    return [(b - a, f"from {short(s)} to {short(t)} mm, the smallest rise")
            for (s, a), (t, b) in zip(limits, limits[1:])]


def limits_differ(check):
    check.unit("percent")
    limits = [check.limit(nose, t)["bisection_limit_mps"] for nose, t in check.plates()]
    texts = " and ".join(short(limit) for limit in limits)
    return [(abs(percent_of(b, a)), f"{texts} m/s") for a, b in zip(limits, limits[1:])]


def every_row(check):
    quantity, per = check.value("quantity", str), check.value("per")
    factor = 100 if check.unit_of_quantity() == "percent" else 1
    if not check.results.shots:
        raise Missing("no shots")
    return [(factor * check.column(row, quantity) / (check.column(row, per) if per else 1), shot_text(row))
            for row in check.results.shots]


def perforating_velocities(check):
    check.unit("")
    fastest, model = check.value("up_to_velocity_mps", (int, float)), check.value("model", str)
    measured = []
    for nose, thickness in check.plates():
        shots = check.shots(nose, thickness)
        run = {s["initial_velocity_mps"] for s in shots}
        listed = {row["initial_velocity_mps"] for row in check.tests.listed
                  if row["use"] == "curve" and row["model"] in ("both", model) and row["nose"] == nose
                  and metal_of(row["material"]) == check.value("metal", str) and row["thickness_mm"] == thickness}
        if listed - run:
            raise Missing(f"{len(listed & run)} of {len(listed)} shots of the curve, {plate_text(nose, thickness)}")
        count = len({s["initial_velocity_mps"] for s in shots
                     if s["perforated"] and s["initial_velocity_mps"] <= fastest})
        measured.append((count, f"{plate_text(nose, thickness)}, the fewest"))
    return measured


def shot_value(check):
    quantity, per, less = check.value("quantity", str), check.value("per"), check.value("less") or 0
    factor, measured = 100 if check.unit_of_quantity() == "percent" else 1, []
    for nose, thickness in check.plates():
        row = check.shot(nose, thickness)
        value = check.column(row, quantity) - less
        if per:
            below = check.column(row, per) - less
            value = value / below if below > 0 else math.inf
        leaves = f", {short(row['residual_velocity_mps'])} m/s left" if quantity == "perforated" else ""
        measured.append((factor * value, shot_text(row) + leaves))
    return measured


def shots_compared(check):
    check.unit_of_quantity()
    quantity, nose = check.value("quantity", str), check.value("nose", str)
    larger, smaller = (check.shot(nose, check.value(name, (int, float))) for name in ("larger_at_mm", "smaller_at_mm"))
    a, b = check.column(larger, quantity), check.column(smaller, quantity)
    return [(a - b, f"{short(a)} at {short(larger['thickness_mm'])} mm, {short(b)} at "
                    f"{short(smaller['thickness_mm'])} mm")]


def particle_count(check):
    check.unit("percent")
    radius_mm, measured = check.value("disc_radius_mm", (int, float)), []
    for nose, thickness in check.plates():
        shots = check.shots(nose, thickness)
        if not shots:
            raise Missing(f"no shot, {plate_text(nose, thickness)}")
        quarter = math.pi / 4 * radius_mm**2 * thickness / shots[0]["spacing_mm"]**3
        count = check.column(shots[0], "particles")
        measured.append((percent_of(count, quarter), f"{short(count)} particles, {plate_text(nose, thickness)}"))
    return measured


def projectile_mass(check):
    check.unit("percent")
    mass_g, spacing_mm = check.value("mass_g", (int, float)), check.value("spacing_mm", (int, float))
    measured = []
    for nose in check.several("nose", str):
        found = [row for row in check.results.projectiles
                 if row["nose"] == nose and close(row["spacing_mm"], spacing_mm)]
        if not found:
            raise Missing(f"no shot with the {nose} nose")
        measured.append((percent_of(found[0]["projectile_mass_g"], mass_g),
                         f"{nose}, {short(found[0]['projectile_mass_g'])} g, the farthest off"))
    return measured


def fit_row(check, parameter):
    fit = check.value("fit", str)
    found = [row for row in check.results.fits if row["fit"] == fit and row["parameter"] == parameter]
    if not found:
        raise Missing(f"no {parameter} of the fit {fit}")
    return found[0]


def fit_constant(check):
    unit, parameters = check.unit("standard_errors", "percent"), check.several("parameter", str)
    references, measured = check.several("reference", (int, float)), []
    if len(parameters) != len(references):
        check.refuse("reference", "must be as many as parameter")
    for parameter, reference in zip(parameters, references):
        row = fit_row(check, parameter)
        if unit == "standard_errors" and not row["standard_error"]:
            raise Missing(f"no standard error of {parameter}")
        value = (percent_of(row["value"], reference) if unit == "percent"
                 else (row["value"] - reference) / row["standard_error"])
        measured.append((value, f"{parameter} = {short(row['value'])}, reference {short(reference)}"))
    return measured


def fit_stress(check):
    """Stress of the fitted modified law at room temperature against that of another one."""
    check.unit("percent")

    def stress(constants, strain, rate):
        return (constants["A_MPa"] + constants["B_MPa"] * strain**constants["a"]) * rate**constants["C"]

    names = ("A_MPa", "B_MPa", "a", "C")
    ours = {name: fit_row(check, name)["value"] for name in names}
    reference = {name: check.value(name, (int, float)) for name in names}
    measured = []
    for strain, rate in itertools.product(check.several("plastic_strain", (int, float)),
                                          check.several("rate_per_s", (int, float))):
        a, b = stress(ours, strain, rate), stress(reference, strain, rate)
        measured.append((percent_of(a, b), f"{short(a)} MPa, reference {short(b)} MPa, at {short(strain)} and "
                                           f"{short(rate)} 1/s, the farthest off"))
    return measured


def fit_misfit(check):
    check.unit("percent")
    return [(fit_row(check, "rms_percent")["value"], "root mean square over all curves")]


def picture(check):
    missing = [name for name in check.several("file", str) if not check.results.has_picture(name)]
    if missing:
        raise Missing(f"no {', '.join(missing)}")
    return [(0, ", ".join(check.several("file", str)))]


# Name: function, parameters that it needs, further ones that it takes.
PLATE = ("metal", "nose", "thickness_mm")
KINDS = {
    "limit_against_test": (limit_against_test, PLATE, ("widest_bracket_mps",)),
    "residuals_against_tests": (residuals_against_tests, (*PLATE, "from_velocity_mps"), ()),
    "limits_rise": (limits_rise, PLATE, ("widest_bracket_mps",)),
    "limits_differ": (limits_differ, PLATE, ("widest_bracket_mps",)),
    "every_row": (every_row, ("quantity",), ("per",)),
    "perforating_velocities": (perforating_velocities, (*PLATE, "up_to_velocity_mps"), ()),
    "shot_value": (shot_value, (*PLATE, "quantity"), ("per", "less", "velocity_mps")),
    "shots_compared": (shots_compared, ("metal", "nose", "quantity", "larger_at_mm", "smaller_at_mm"), ()),
    "particle_count": (particle_count, (*PLATE, "disc_radius_mm"), ()),
    "projectile_mass": (projectile_mass, ("nose", "mass_g"), ()),
    "fit_constant": (fit_constant, ("fit", "parameter", "reference"), ()),
    "fit_stress": (fit_stress, ("fit", "plastic_strain", "rate_per_s", "A_MPa", "B_MPa", "a", "C"), ()),
    "fit_misfit": (fit_misfit, ("fit",), ()),
    "picture": (picture, ("file",), ()),
}
