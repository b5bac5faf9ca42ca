"""The kinds of checks that docs/results/acceptance.toml may name. Each takes a Check of checks.py, which knows parameters,
bounds and results, and yields what it measured as (value, where or what); the worst of them counts."""

import math

from .data import close, metal_of, percent_of, short

NUMBER = (int, float)


class Missing(Exception):
    """What a check needs has not been computed."""


def plate_text(nose, thickness_mm):
    return f"{nose}, {short(thickness_mm)} mm"


def shot_text(row):
    method = "" if row["method"] == "paper" else f"{row['method']}, "
    velocity = short(row["initial_velocity_mps"], 5)
    return f"{method}{row['model']}, {plate_text(row['nose'], row['thickness_mm'])}, {velocity} m/s"


def limit_against_test(check):
    for plate in check.plates():
        row = check.limit(*plate)
        limit, test = row["bisection_limit_mps"], row["test_limit_mps"]
        if test is None:
            raise Missing(f"no test, {plate_text(*plate)}")
        yield percent_of(limit, test), f"{short(limit)} m/s, test {short(test)} m/s"


def limit_against_paper(check):
    for plate in check.plates():
        limit = check.limit(*plate)["bisection_limit_mps"]
        paper = check.tests.paper_velocity_mps(check.value("metal", str), *plate)
        if paper is None:
            raise Missing(f"no velocity of the paper, {plate_text(*plate)}")
        yield percent_of(limit, paper), f"{short(limit)} m/s, paper {short(paper)} m/s"


def measured_shots(check, *models):
    """(initial velocity, measured residual velocity, those computed with each law) of the measured shots of a check."""
    slowest, fastest = check.value("from_velocity_mps", NUMBER), check.value("up_to_velocity_mps") or math.inf
    found = []
    for plate in check.plates():
        for test in check.tests.shots_of(check.value("metal", str), *plate):
            velocity = test["initial_velocity_mps"]
            if not slowest <= velocity <= fastest:
                continue
            shots = [next((s for s in check.shots(*plate, model) if close(s["initial_velocity_mps"], velocity, 0.05)), None)
                     for model in models]
            if None in shots:
                raise Missing(f"no shot at {short(velocity)} m/s, {plate_text(*plate)}")
            found.append((velocity, test["residual_velocity_mps"], *(shot["residual_velocity_mps"] for shot in shots)))
    if not found:
        raise Missing(f"no test from {short(slowest)} m/s on")
    return found


def residuals_against_tests(check):
    for velocity, test, computed in measured_shots(check, check.value("model", str)):
        yield computed - test, f"{short(computed)} m/s, test {short(test)} m/s, at {short(velocity)} m/s"


def nearer_law(check):
    """The error of one law minus that of another: negative where the first is nearer to the test."""
    model, other = check.value("model", str), check.value("than", str)
    for velocity, test, a, b in measured_shots(check, model, other):
        yield abs(a - test) - abs(b - test), (f"{model} {short(a)} m/s, {other} {short(b)} m/s, test {short(test)} m/s, at "
                                              f"{short(velocity)} m/s")


def limits_rise(check):
    limits = [(t, check.limit(nose, t)["bisection_limit_mps"]) for nose, t in check.plates()]
    for (s, a), (t, b) in zip(limits, limits[1:]):
        yield b - a, f"from {short(s)} to {short(t)} mm, the smallest rise"


def limits_differ(check):
    limits = [check.limit(*plate)["bisection_limit_mps"] for plate in check.plates()]
    for a, b in zip(limits, limits[1:]):
        yield abs(percent_of(b, a)), f"{' and '.join(map(short, limits))} m/s"


def every_row(check):
    quantity, per, factor = check.value("quantity", str), check.value("per"), check.factor()
    if not check.results.shots:
        raise Missing("no shots")
    for row in check.results.shots:
        yield factor * check.column(row, quantity) / (check.column(row, per) if per else 1), shot_text(row)


def perforating_velocities(check):
    fastest, model, metal = check.value("up_to_velocity_mps", NUMBER), check.value("model", str), check.value("metal", str)
    for nose, thickness in check.plates():
        shots = check.shots(nose, thickness)
        run = {s["initial_velocity_mps"] for s in shots}
        listed = {row["initial_velocity_mps"] for row in check.tests.listed
                  if row["use"] == "curve" and row["model"] in ("both", model) and row["nose"] == nose
                  and metal_of(row["material"]) == metal and row["thickness_mm"] == thickness}
        if listed - run:
            raise Missing(f"{len(listed & run)} of {len(listed)} shots of the curve, {plate_text(nose, thickness)}")
        count = len({s["initial_velocity_mps"] for s in shots
                     if s["perforated"] and s["initial_velocity_mps"] <= fastest})
        yield count, f"{plate_text(nose, thickness)}, the fewest"


def shot_value(check):
    quantity, per, less, factor = check.value("quantity", str), check.value("per"), check.value("less") or 0, check.factor()
    minus = check.value("minus")
    for plate in check.plates():
        row = check.shot(*plate)
        value = check.column(row, quantity) - less - (check.column(row, minus) if minus else 0)
        if per:
            below = check.column(row, per) - less
            value = value / below if below > 0 else math.inf
        leaves = f", {short(row['residual_velocity_mps'])} m/s left" if quantity == "perforated" else ""
        yield factor * value, shot_text(row) + leaves


def shots_compared(check):
    quantity, nose = check.value("quantity", str), check.value("nose", str)
    sizes = [check.value(name, NUMBER) for name in ("larger_at_mm", "smaller_at_mm")]
    a, b = (check.column(check.shot(nose, size), quantity) for size in sizes)
    yield a - b, f"{short(a)} at {short(sizes[0])} mm, {short(b)} at {short(sizes[1])} mm"


def particle_count(check):
    radius_mm = check.value("disc_radius_mm", NUMBER)
    for nose, thickness in check.plates():
        shots = check.shots(nose, thickness)
        if not shots:
            raise Missing(f"no shot, {plate_text(nose, thickness)}")
        quarter = math.pi / 4 * radius_mm**2 * thickness / shots[0]["spacing_mm"]**3
        count = check.column(shots[0], "particles")
        yield percent_of(count, quarter), f"{short(count)} particles, {plate_text(nose, thickness)}"


def projectile_mass(check):
    mass_g = check.value("mass_g", NUMBER)
    for nose in check.several("nose", str):
        found = [row["projectile_mass_g"] for row in check.results.projectiles
                 if row["nose"] == nose and close(row["spacing_mm"], check.distance_mm(nose))]
        if not found:
            raise Missing(f"no shot with the {nose} nose")
        yield percent_of(found[0], mass_g), f"{nose}, {short(found[0])} g, the largest error"


def fit_row(check, parameter):
    fit = check.value("fit", str)
    found = [row for row in check.results.fits if row["fit"] == fit and row["parameter"] == parameter]
    if not found:
        raise Missing(f"no {parameter} of the fit {fit}")
    return found[0]


def fit_constant(check):
    parameters, references = check.several("parameter", str), check.several("reference", NUMBER)
    if len(parameters) != len(references):
        check.refuse("reference", "must be as many as parameter")
    for parameter, reference in zip(parameters, references):
        row = fit_row(check, parameter)
        if not row["standard_error"]:
            raise Missing(f"no standard error of {parameter}")
        yield ((row["value"] - reference) / row["standard_error"],
               f"{parameter} = {short(row['value'])}, reference {short(reference)}")


def fit_misfit(check):
    yield fit_row(check, "rms_percent")["value"], "root mean square over all curves"


def picture(check):
    missing = [name for name in check.several("file", str) if not check.results.has_picture(name)]
    if missing:
        raise Missing(f"no {', '.join(missing)}")
    yield 0, ", ".join(check.several("file", str))


# Name: function, units of its bounds (None: that of its quantity), parameters that it needs, further ones that it takes.
PLATE = ("metal", "nose", "thickness_mm")
KINDS = {
    "limit_against_test": (limit_against_test, ("percent",), PLATE, ("widest_bracket_mps",)),
    "limit_against_paper": (limit_against_paper, ("percent",), PLATE, ("widest_bracket_mps",)),
    "residuals_against_tests": (residuals_against_tests, ("mps",), (*PLATE, "from_velocity_mps"), ("up_to_velocity_mps",)),
    "nearer_law": (nearer_law, ("mps",), (*PLATE, "than", "from_velocity_mps"), ("up_to_velocity_mps",)),
    "limits_rise": (limits_rise, ("mps",), PLATE, ("widest_bracket_mps",)),
    "limits_differ": (limits_differ, ("percent",), PLATE, ("widest_bracket_mps",)),
    "every_row": (every_row, None, ("quantity",), ("per",)),
    "perforating_velocities": (perforating_velocities, ("",), (*PLATE, "up_to_velocity_mps"), ()),
    "shot_value": (shot_value, None, (*PLATE, "quantity"), ("per", "less", "minus", "velocity_mps")),
    "shots_compared": (shots_compared, None, ("metal", "nose", "quantity", "larger_at_mm", "smaller_at_mm"), ()),
    "particle_count": (particle_count, ("percent",), (*PLATE, "disc_radius_mm"), ()),
    "projectile_mass": (projectile_mass, ("percent",), ("nose", "mass_g"), ()),
    "fit_constant": (fit_constant, ("standard_errors",), ("fit", "parameter", "reference"), ()),
    "fit_misfit": (fit_misfit, ("percent",), ("fit",), ()),
    "picture": (picture, (), ("file",), ()),
}
