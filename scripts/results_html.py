"""The sections of the page of results. Nothing is judged here: that is accept.py's."""

from accept import status_of_figure, summary
from acceptance_kinds import percent_of, shot_text
from html_text import STYLE, escape, from_markdown, plus_minus, signed, status, table, unordered
from ogive_results import LAWS, ROOT, half_width_mps, metal_of, short
from results_limits import beyond_section, limits_section, test_limit_of



class Page:
    """What the sections share: everything that was read, and the results of the checks."""

    def __init__(self, facts, results, tests, checks, beyond, record, spacing_mm, pictures, link_prefix):
        self.facts, self.results, self.tests, self.checks, self.beyond = facts, results, tests, checks, beyond
        self.record, self.spacing_mm, self.pictures, self.link_prefix = record, spacing_mm, pictures, link_prefix
        self.methods = sorted({row["method"] for row in results.shots})
        self.methods_beyond = [method for method in self.methods if method != "sfm"]

    def checks_of(self, figure):
        return [result for result in self.checks if figure in result.figures]

    def limit(self, metal, nose, thickness_mm, model, method="sfm"):
        for row in self.results.limits:
            if (metal_of(row["material"]) == metal and row["nose"] == nose and row["method"] == method
                    and row["model"] == model and abs(row["thickness_mm"] - thickness_mm) < 1e-6
                    and abs(row["spacing_mm"] - self.spacing_mm) < 1e-6):
                return row
        return None

    def shot(self, metal, nose, thickness_mm, velocity_mps, model, method="sfm"):
        for row in self.results.shots:
            if (metal_of(row["material"]) == metal and row["nose"] == nose and row["model"] == model
                    and row["method"] == method and abs(row["thickness_mm"] - thickness_mm) < 1e-6
                    and abs(row["initial_velocity_mps"] - velocity_mps) < 0.05
                    and abs(row["spacing_mm"] - self.spacing_mm) < 1e-6):
                return row
        return None

    def shots_of_figure(self, figure):
        """Rows of the shots that a figure needs: those of its pictures and all of the series of its curves."""
        listed = [row for row in self.tests.listed if row["figure"] == figure]
        found = []
        for shot in self.results.shots:
            for row in listed:
                same = (row["model"] in ("both", shot["model"]) and row["material"] == shot["material"]
                        and row["nose"] == shot["nose"] and row["thickness_mm"] == shot["thickness_mm"])
                if same and (row["use"] == "curve" or row["initial_velocity_mps"] == shot["initial_velocity_mps"]):
                    found.append(shot)
                    break
        return found

    def core_minutes(self, shots):
        return sum(s["cpu_s"] for s in shots if s.get("cpu_s")) / 60


def picture_shots_missing(page, figure):
    return [row for row in page.tests.listed if row["figure"] == figure and row["use"] == "picture" and not page.shot(
        metal_of(row["material"]), row["nose"], row["thickness_mm"], row["initial_velocity_mps"], row["model"])]


def cost_text(page, fact):
    if "runs_of" in fact:
        return f'with Fig.&nbsp;{fact["runs_of"]}'
    minutes = page.core_minutes(page.shots_of_figure(fact["number"]))
    return short(minutes, 2) if minutes else "–"


def tally(results):
    """How many of the checks passed."""
    passed, missing = (sum(r.status == word for r in results) for word in ("pass", "missing"))
    return (f'<span class="note">{passed} of {len(results)} checks' + (f", {missing} without data" if missing else "") +
            "</span>")


def deciding(result):
    """The number that decides."""
    if result is None:
        return "–"
    return f"{escape(result.statement)}: <strong>{escape(result.measured)}</strong>; asked: {escape(result.limit)}"


def scoreboard(page):
    rows, counts = [], {}
    for fact in page.facts:
        number = fact["number"]
        word, decides = status_of_figure(page.checks_of(number))
        counts[word] = counts.get(word, 0) + 1
        rows.append([f'<a href="#figure_{number}">{number}</a>',
                     f'{escape(fact["title"])}<br><span class="note">{escape(fact["shows"])}</span>',
                     f"{status(word)}<br>{tally(page.checks_of(number))}", deciding(decides), cost_text(page, fact)])
    general = page.checks_of(0)
    if general:
        word, decides = status_of_figure(general)
        word = {"reproduced": "pass", "partly": "FAIL", "not": "FAIL"}.get(word, word)
        rows.append(["all", "Every run: energy and contact", f"{status(word)}<br>{tally(general)}", deciding(decides),
                     short(page.core_minutes(page.results.shots), 3)])
    said = ", ".join(f"{counts[word]} {text}" for word, text in
                     (("reproduced", "reproduced"), ("partly", "partly reproduced"), ("not", "not reproduced"),
                      ("not run yet", "not run yet")) if counts.get(word))
    return "\n".join([
        "<h2 id=scoreboard>Scoreboard</h2>",
        f"<p>Of {len(page.facts)} figures: {said}. Checks: {summary(page.checks)}, missing data counted as failed. A "
        "figure is reproduced if all of its checks passed, partly if some did, not if none did.</p>",
        table(["Fig.", "what it shows", "status", "what decides", "cost, core min"], rows, numbers=(4,), stack=True),
        "<p class=note>What decides: of the checks that failed the one farthest beyond its limit, else the one nearest "
        "to it. Cost: processor time of the shots; a shot that several figures need counts for each.</p>"])


def check_item(result):
    return (f'{status(result.status)} {escape(result.statement)}: {escape(result.measured)}'
            f' <span class=note>(asked: {escape(result.limit)})</span>')


def pictures_of(page, fact):
    parts = []
    for picture in fact["pictures"]:
        name, caption = escape(picture["file"]), escape(picture["caption"])
        if picture["file"] in page.pictures:
            parts.append(f'<figure><a href="{name}"><img src="{name}" alt="{caption}"></a>'
                         f"<figcaption>{caption}</figcaption></figure>")
            continue
        if picture.get("method"):
            continue
        missing = picture_shots_missing(page, fact["number"])
        shots = "; ".join(f'{short(s["thickness_mm"])} mm, {short(s["initial_velocity_mps"])} m/s' for s in missing)
        why = f" Shots not run yet: {escape(shots)}." if missing else ""
        parts.append(f'<p class=empty>{caption} Not drawn yet.{why}</p>')
    missing = picture_shots_missing(page, fact["number"])
    if missing and any(picture["file"] in page.pictures for picture in fact["pictures"]):
        shots = "; ".join(f'{short(s["thickness_mm"])} mm, {short(s["initial_velocity_mps"])} m/s' for s in missing)
        parts.append(f"<p class=note>Shots not run yet and not in the picture: {escape(shots)}.</p>")
    return "\n".join(parts)


def plates_of(fact):
    return [(group["metal"], group["nose"], thickness) for group in fact.get("tests", [])
            for thickness in group["thickness_mm"]]


def limits_beside_tests(page, fact):
    rows, sources = [], []
    for metal, nose, thickness in plates_of(fact):
        test = test_limit_of(page, metal, nose, thickness)
        limit_mps = test["ballistic_limit_mps"] if test else None
        cells = [f"{short(thickness)} mm {escape(metal)}, {escape(nose)}", short(limit_mps)]
        if test:
            sources.append(f'{test["source"]} ({test["confidence"]})')
        paper_mps = page.tests.paper_velocity_mps(metal, nose, thickness)
        for model in LAWS:
            row = page.limit(metal, nose, thickness, model)
            computed = row["bisection_limit_mps"] if row else None
            half = half_width_mps(row) if row else None
            cells += [plus_minus(computed, half),
                      signed(percent_of(computed, limit_mps) if computed and limit_mps else None)]
        cells += [short(paper_mps), signed(percent_of(paper_mps, limit_mps) if paper_mps and limit_mps else None)]
        rows.append(cells)
    if not rows:
        return ""
    return "\n".join([
        "<h3>Limits beside the tests</h3>",
        table(["plate", "test, m/s", "MJC, m/s", "off, %", "JC, m/s", "off, %", "paper*, m/s", "off, %"], rows,
              numbers=range(1, 8)),
        f"<p class=note>Tests: {escape('; '.join(dict.fromkeys(sources)))}. Computed limits by bisection, ± half of "
        "the last bracket. * Strike velocity that the paper names as close to its limit.</p>"])


def shots_beside_tests(page, fact):
    if "runs_of" in fact:
        return ""
    rows = []
    for metal, nose, thickness in plates_of(fact):
        for test in page.tests.shots_of(metal, nose, thickness):
            residual = test["residual_velocity_mps"]
            cells = [f"{short(thickness)} mm, {escape(nose)}", f'{test["initial_velocity_mps"]:.1f}', f"{residual:.1f}"]
            found = [page.shot(metal, nose, thickness, test["initial_velocity_mps"], model) for model in LAWS]
            if not any(found):
                continue
            for row in found:
                computed = row["residual_velocity_mps"] if row else None
                cells += [plus_minus(computed, None), signed(None if computed is None else computed - residual)]
            rows.append(cells)
    if not rows:
        return ""
    return "<h3>Residual velocities beside measured shots</h3>" + table(
        ["plate", "initial, m/s", "test, m/s", "MJC, m/s", "off, m/s", "JC, m/s", "off, m/s"], rows,
        numbers=range(1, 7))


def picture_shots(page, fact):
    rows = []
    for listed in page.tests.listed:
        if listed["figure"] != fact["number"] or listed["use"] != "picture":
            continue
        shot = page.shot(metal_of(listed["material"]), listed["nose"], listed["thickness_mm"],
                         listed["initial_velocity_mps"], listed["model"])
        cells = [f'{short(listed["thickness_mm"])} mm, {escape(listed["nose"])}', short(listed["initial_velocity_mps"])]
        test = test_limit_of(page, metal_of(listed["material"]), listed["nose"], listed["thickness_mm"])
        cells.append(short(test["ballistic_limit_mps"]) if test else "–")
        if shot is None:
            rows.append(cells + ["not run yet"] + ["–"] * 7)
            continue
        rows.append(cells + ["yes" if shot["perforated"] else "no", f'{shot["residual_velocity_mps"]:.1f}'] + [
            "–" if shot.get(name) is None else f"{shot[name]:.{decimals}f}" for name, decimals in
            (("plug_mass_g", 1), ("plug_thickness_mm", 1), ("dishing_mm", 1), ("kept_fraction", 2),
             ("band_temperature_K", 0), ("core_temperature_K", 0))])
    if not rows:
        return ""
    return "<h3>The shots of the picture</h3>" + table(
        ["plate", "initial, m/s", "measured limit, m/s", "perforated", "residual, m/s", "plug, g", "plug, mm",
         "dishing, mm", "kept in the way", "band, K", "plug's core, K"], rows, numbers=(1, 2, 4, 5, 6, 7, 8, 9, 10))


def constants(page, fact):
    """Fitted constants beside published ones. Both laws: a stands for n, b for m."""
    names = (("A_MPa", "A_MPa", 1), ("B_MPa", "B_MPa", 1), ("a", "n", 4), ("C", "C", 5), ("b", "m", 4))
    rows = []
    for published in fact.get("published", []):
        rows.append([escape(published["text"])] + [
            "–" if name not in published else f"{published[name]:g}" for name, _, _ in names] + ["–"])
    any_fit = False
    for fit in fact.get("fits", []):
        values = {row["parameter"]: row for row in page.results.fits if row["fit"] == fit["fit"]}
        if not values:
            continue
        any_fit, cells = True, [escape(fit["text"])]
        for name, other, decimals in names:
            row = values.get(name) or values.get(other)
            cells.append(plus_minus(row["value"], row["standard_error"], decimals) if row else "–")
        rms = values.get("rms_percent")
        rows.append(cells + [f'{rms["value"]:.2f}' if rms else "–"])
    if not rows:
        return ""
    return "<h3>Constants, ± standard errors</h3>" + table(
        ["", "A, MPa", "B, MPa", "a (n)", "C", "b (m)", "misfit, %"], rows, numbers=range(1, 7)) + (
            "" if any_fit else "<p class=note>The fits have not been run yet.</p>")


def figure_section(page, fact):
    number, results = fact["number"], page.checks_of(fact["number"])
    word, _ = status_of_figure(results)
    short_of = [f"{escape(r.statement)}: {escape(r.measured)}; asked: {escape(r.limit)}."
                for r in results if r.status == "FAIL"]
    missing = sum(r.status == "missing" for r in results)
    if missing:
        short_of.append(f"Without data so far: {missing} of {len(results)} checks.")
    short_of += [escape(text) for text in fact["short"]]
    pictures = pictures_of(page, fact)
    said = "<h3>What the paper says</h3>\n" + unordered(escape(text) for text in fact["paper"])
    checked = "<h3>Checks</h3>\n" + unordered(map(check_item, results))
    fell = "<h3>What falls short</h3>\n" + (unordered(short_of) if short_of else "<p>Nothing that was looked for.</p>")
    # Pictures of many panels have the whole width to themselves.
    above, left, right = (pictures, said + fell, checked) if fact.get("wide") else ("", pictures, said + checked + fell)
    return "\n".join([
        f'<h2 id="figure_{number}">Fig. {number}. {escape(fact["title"])} {status(word)}</h2>', above,
        '<div class="beside"><div>', left, "</div><div>", right, "</div></div>", constants(page, fact),
        limits_beside_tests(page, fact), shots_beside_tests(page, fact), picture_shots(page, fact)])


def document(page, file, title, identifier):
    text = (ROOT / "docs" / file).read_text(encoding="utf-8")
    return f"<h2 id={identifier}>{title}</h2>\n" + from_markdown(text, page.link_prefix)


def acceptance_section(page):
    rows = [[status(r.status), f"<code>{escape(r.id)}</code>",
             ", ".join("all" if f == 0 else str(f) for f in r.figures), escape(r.statement), escape(r.measured),
             escape(r.limit)] for r in page.checks]
    return ("<h2 id=acceptance>Acceptance</h2>\n<p>The checks and their limits stand in "
            "<code>docs/results/acceptance.toml</code>. "
            f"<strong>{summary(page.checks)}</strong>, missing data counted as failed; <code>scripts/accept.sh</code> "
            "prints the same.</p>" +
            table(["result", "check", "Fig.", "statement", "measured", "asked"], rows, stack=True))


def record_section(page):
    r = page.record

    def said(name, unit=""):
        value = r.get(name)
        if value is None:
            return "unknown"
        return escape(", ".join(map(str, value)) if isinstance(value, list) else f"{value}{unit}")

    rows = [["ogive", said("version")], ["compiler", said("compiler")], ["build type", said("build_type")],
            ["flags", f'<code>{said("flags")}</code>'], ["CPU", said("cpu_models")], ["cores", said("cores")],
            ["shots", said("shots")], ["threads of a shot", said("threads")],
            ["processor time of all shots", said("core_minutes", " min")]]
    shots = [[escape(shot_text(s)), short(s["residual_velocity_mps"]), short(s.get("cpu_s"), 3),
              short(s.get("threads")), short(s.get("steps")), f'<code>{escape(s.get("state_hash") or "–")}</code>']
             for s in page.results.shots]
    return "\n".join([
        "<h2 id=record>Run record</h2>", table(["", ""], rows),
        "<p class=note>Compiler and cores are those of the machine and build that made this page, CPUs those of all that "
        "made it. Other CPUs may give other last bits.</p>",
        f"<details><summary>All {len(shots)} shots</summary>",
        table(["shot", "residual, m/s", "processor time, s", "threads", "steps", "hash of the final state"], shots,
              numbers=(1, 2, 3, 4)), "</details>",
        '<p>Files: <a href="results/shots.csv">results/shots.csv</a>, '
        '<a href="results/limits.csv">results/limits.csv</a>, '
        '<a href="results/fits.csv">results/fits.csv</a>, '
        '<a href="results/projectiles.csv">results/projectiles.csv</a>, <a href="run_record.csv">run_record.csv</a>, '
        '<a href="run_record.json">run_record.json</a>.</p>'])


def whole_page(page):
    title = "Perforation of steel and aluminium plates: 14 figures computed anew"
    anchors = [("scoreboard", "Scoreboard"),
               *((f'figure_{f["number"]}', f'Fig.&nbsp;{f["number"]}') for f in page.facts), ("limits", "Limits"),
               *([("beyond", "Beyond the paper")] if page.methods_beyond else []), ("acceptance", "Acceptance"), ("assumptions", "Assumptions"), ("sensitivity", "Sensitivity"),
               ("record", "Run record")]
    usual = page.record["usual_spacing_mm"]
    coarse = "" if abs(page.spacing_mm - usual) < 1e-9 else (
        f"<p class=empty>A coarse try with particles {short(page.spacing_mm)} mm apart. The checks are meant for "
        f"{short(usual)} mm: what passes or fails here says nothing about the method.</p>")
    return "\n".join([
        "<!doctype html>", '<html lang="en"><head><meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">', f"<title>{title}</title>",
        f"<style>{STYLE}</style></head><body>", f"<h1>{title}</h1>",
        "<p>Z.S. Liu, S. Swaddiwudhipong and M.J. Islam (Nuclear Engineering and Design 250, 2012, 108–115, "
        '<a href="https://doi.org/10.1016/j.nucengdes.2012.06.026">doi</a>) computed with a commercial code how '
        "projectiles of hardened steel perforate plates of Weldox 460 E and AA5083-H116, with particles where the plate "
        "is destroyed and finite elements elsewhere. ogive is open code for the same method. This page holds its "
        "results against the tests and against what the paper's text says: every number of ours, and every "
        "judgement, is computed from the runs by <code>scripts/figures.sh</code>.</p>", coarse,
        "<p>" + " · ".join(f'<a href="#{anchor}">{text}</a>' for anchor, text in anchors) + "</p>",
        scoreboard(page), *(figure_section(page, fact) for fact in page.facts), limits_section(page),
        beyond_section(page), acceptance_section(page), document(page, "assumptions.md", "Assumptions", "assumptions"),
        document(page, "sensitivity.md", "Sensitivity", "sensitivity"), record_section(page), "</body></html>", ""])
