"""The sections of the page of results that compare ballistic limits."""

from accept import summary
from acceptance_kinds import percent_of, shot_text
from html_text import escape, from_markdown_line, plus_minus, signed, status, table
from ogive_results import (KEY_COLUMNS, LAWS, SERIES_COLUMNS, bracket_of, ended_by_time, half_width_mps, metal_of,
                           short)


def test_limit_of(page, metal, nose, thickness_mm):
    for row in page.tests.limits:
        if row["material"] == metal and row["nose"] == nose and abs(row["thickness_mm"] - thickness_mm) < 0.01:
            return row
    return None


def stale_limits(results):
    """Series whose limits do not belong to the shots: one line for each."""
    lines = []
    for limit in results.limits:
        shots = [s for s in results.shots if s.key(SERIES_COLUMNS) == limit.key(SERIES_COLUMNS)]
        if bracket_of(shots) != (limit["highest_stopped_mps"], limit["lowest_perforated_mps"]):
            lines.append(f"{limit['model']}, {limit['material']}, {limit['nose']}, {short(limit['thickness_mm'])} mm: "
                         "the limit is older than the shots")
    return lines


def limits_section(page):
    order = sorted(page.results.limits, key=lambda r: (metal_of(r["material"]) != "Weldox 460 E", r["nose"],
                                                       r["thickness_mm"], r["model"] != "mjc", r["method"]))
    rows, odd = [], False
    for r in order:
        limit, fit, test, paper = (r[c] for c in ("bisection_limit_mps", "fit_limit_mps", "test_limit_mps",
                                                  "paper_velocity_mps"))
        mark = "" if r["consistent"] else " †"
        odd = odd or bool(mark)
        law = LAWS.get(r["model"], r["model"]) + ("" if len(page.methods) < 2 else f', {escape(r["method"])}')

        def parameter(name, decimals=2):
            origin = r.get(f"fit_{name}_origin")
            return plus_minus(r[f"fit_{name}"], r[f"fit_{name}_se"], decimals) + (
                f" ({origin})" if origin and origin != "fitted" else "")

        rows.append([f'{short(r["thickness_mm"])} mm {metal_of(r["material"])}, {escape(r["nose"])}', law,
                     plus_minus(limit, half_width_mps(r)) + mark, plus_minus(fit, r["fit_limit_se_mps"]),
                     parameter("a"), parameter("p"), signed(fit - limit if fit and limit else None),
                     f'{r["fit_points"]:.0f}' if r["fit_points"] else "–", short(test),
                     signed(percent_of(limit, test) if limit and test else None), short(paper),
                     signed(percent_of(paper, test) if paper and test else None)])
    notes = ["Bisection: the middle of the slowest shot that perforated and the fastest below it that did not, ± half "
             "of what lies between. Fit: v_r = a (v^p − v_bl^p)^(1/p) through all shots that perforated, ± standard "
             "errors. Paper: the strike velocity that it names as close to its limit."]
    if odd:
        notes.append("† A shot was stopped above one that perforated.")
    late = [f"{shot_text(s)}: {short(s['residual_velocity_mps'])} m/s" for s in page.results.shots if ended_by_time(s)]
    if late:
        notes.append(f"Ended because time was up, undecided but for the rule in docs/method.md: {'; '.join(late)}.")
    notes += [line + "." for line in stale_limits(page.results)]
    body = table(["plate", "law", "bisection, m/s", "fit v_bl, m/s", "a", "p", "fit − bisection, m/s", "shots",
                  "test, m/s", "off, %", "paper, m/s", "off, %"], rows, numbers=range(2, 12)) if rows else (
                      "<p class=empty>No limits yet.</p>")
    return "<h2 id=limits>Ballistic limits</h2>\n" + body + "".join(f"<p class=note>{escape(n)}</p>" for n in notes)


def cost_beside_paper(page, method):
    """Processor time of a method's shots over that of the paper's method for the same shots; None without any."""
    def key(shot):
        return tuple(shot[c] for c in KEY_COLUMNS if c != "method")

    paper = {key(s): s["cpu_s"] for s in page.results.shots if s["method"] == "sfm" and s.get("cpu_s")}
    both = [(s["cpu_s"], paper[key(s)]) for s in page.results.shots
            if s["method"] == method and s.get("cpu_s") and key(s) in paper]
    return sum(ours for ours, _ in both) / sum(theirs for _, theirs in both) if both else None


def beyond_section(page):
    """Limits of the methods beyond the paper beside tests and paper's method, and their own checks."""
    if not page.methods_beyond:
        return ""
    methods = ["sfm", *page.methods_beyond]
    plates = sorted({(metal_of(r["material"]), r["nose"], r["thickness_mm"]) for r in page.results.limits
                     if r["method"] != "sfm"}, key=lambda plate: (plate[0] != "Weldox 460 E", *plate[1:]))
    rows = []
    for metal, nose, thickness in plates:
        test = test_limit_of(page, metal, nose, thickness)
        limit_mps = test["ballistic_limit_mps"] if test else None
        cells = [f"{short(thickness)} mm {escape(metal)}, {escape(nose)}", short(limit_mps)]
        for method in methods:
            row = page.limit(metal, nose, thickness, "mjc", method)
            computed = row["bisection_limit_mps"] if row else None
            cells += [plus_minus(computed, half_width_mps(row) if row else None),
                      signed(percent_of(computed, limit_mps) if computed and limit_mps else None)]
        rows.append(cells)
    names = {"sfm": "paper's method"}
    heads = [text for method in methods for text in (f"{names.get(method, method)}, m/s", "off, %")]
    costs = [f"{method}: {cost:.2f} times the processor time of the paper's method for the same shots"
             for method in page.methods_beyond if (cost := cost_beside_paper(page, method))]
    checks = [r for r in page.beyond if r.id.partition("_")[0] in page.methods_beyond]
    listed = [[status(r.status), f"<code>{escape(r.id)}</code>", escape(r.statement), escape(r.measured),
               escape(r.limit)] for r in checks]
    return "\n".join([
        "<h2 id=beyond>Beyond the paper</h2>",
        "<p>Methods that hold plates together where the paper's particles come apart, with damage; what they do and "
        f"what was seen before their parameters were fixed: {from_markdown_line('[docs/beyond.md](beyond.md)', page.link_prefix)}. The figures above keep their "
        "status, which is that of the paper's method; checks of the other methods stand in "
        f"<code>docs/results/acceptance_beyond.toml</code>: <strong>{summary(checks)}</strong>, missing data counted "
        "as failed.</p>",
        table(["plate", "test, m/s", *heads], rows, numbers=range(1, 2 + len(heads))) if rows else "",
        *(f"<p class=note>{escape(text)}.</p>" for text in costs),
        table(["result", "check", "statement", "measured", "asked"], listed, stack=True)])
