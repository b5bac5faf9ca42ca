"""Figs. 1 to 3: fits of the laws to the computed curves in apps/data, and their tables beside the paper's Tables 1 and 2."""

import shutil
import subprocess

from .data import PROGRAMS, ROOT, TESTS, build, markdown_table, read_json
from .insert import insert

STEEL = ["--data", TESTS / "synthetic_weldox_460e.csv", "--name", "Weldox 460 E computed", "--melting-K", 1800, "--density",
         7850, "--specific-heat", 452, "--young-GPa", 200, "--poisson", 0.33, "--leave-out-from-K", 473,
         "--leave-out-to-K", 673, "--predict-rates-per-s", "0.0015,4.44,21.6,577"]
ALUMINIUM = ["--data", TESTS / "synthetic_aa5083_h116.csv", "--name", "AA5083-H116 computed", "--melting-K", 893, "--density",
             2700, "--specific-heat", 910, "--young-GPa", 70, "--poisson", 0.3]
FITS = {
    "weldox": [*STEEL, "--simultaneous"],
    "weldox_isothermal": [*STEEL, "--isothermal"],
    "weldox_power": [*STEEL, "--model", "jc", "--rate-factor", "power", "--reference-rate-per-s", 5e-4],
    "weldox_logarithmic": [*STEEL, "--model", "jc", "--reference-rate-per-s", 5e-4],
    "aluminium": ALUMINIUM,
    "aluminium_isothermal": [*ALUMINIUM, "--isothermal"],
    "aluminium_power": [*ALUMINIUM, "--model", "jc", "--rate-factor", "power", "--reference-rate-per-s", 1],
}
PICTURES = [("weldox", name) for name in ("hardening", "rate_exponent", "thermal_exponent", "prediction")] + [
    ("aluminium", "plates")]
PAGE = ROOT / "docs" / "calibration.md"


def are_done(folder, program, page_only=False):
    """Whether the last fit is there and, unless `page_only`, newer than the curves and the program."""
    last = folder / list(FITS)[-1] / "fit.json"
    sources = [] if page_only else [program, *TESTS.glob("synthetic_*")]
    return last.exists() and all(source.stat().st_mtime <= last.stat().st_mtime for source in sources)


def run_fits(folder, program):
    folder.mkdir(parents=True, exist_ok=True)
    for name, options in FITS.items():
        with open(folder / f"{name}.log", "w", encoding="utf-8") as log:
            subprocess.run(list(map(str, [program, "calibrate", *options, "--out", folder / name])), check=True, stdout=log)


def tables(folder):
    fits = {name: read_json(folder / name / "fit.json") for name in FITS}

    def row(text, name, third="a", fifth="b"):
        fit, error = fits[name], fits[name]["standard_error"]
        return [text, *(f"{fit[key]:.{digits}f} ± {error[key]:.{digits}f}" for key, digits in (
            ("A_MPa", 1), ("B_MPa", 1), (third, 4), ("C", 5), (fifth, 4))), f"{fit['rms_percent']:.2f}"]

    steel, once = fits["weldox"], fits["weldox"]["simultaneous"]
    header = ["", "A, MPa", "B, MPa", "a (n)", "C", "b (m)", "rms, %"]
    return "\n\n".join([
        f"Made by `scripts/results.sh fits` with ogive {steel['version']}.", "Weldox 460 E:",
        markdown_table(header, [
            ["paper, Table 1", "503", "581", "0.481", "0.01", "0.94", ""],
            row("MJC", "weldox"),
            ["MJC at 7.4e-4 1/s (Fig. 1a read as it stands)",
             *(f"{steel['quasi_static'][key]:.1f}" for key in ("A_MPa", "B_MPa")), f"{steel['a']:.4f}", "", "", ""],
            ["MJC, all parameters at once", *(f"{once[key]:.{digits}f}" for key, digits in (
                ("A_MPa", 1), ("B_MPa", 1), ("a", 4), ("C", 5), ("b", 4), ("rms_percent", 2)))],
            row("MJC, `--isothermal`", "weldox_isothermal"),
            row("JC, power rate factor", "weldox_power", "n", "m"),
            ["law that made the curves", "490", "383", "0.45", "0.0123", "0.94", ""],
            row("JC, logarithmic rate factor", "weldox_logarithmic", "n", "m")]),
        "AA5083-H116, A, B and a of the 15 mm plate:",
        markdown_table(header, [
            ["paper, Table 2", "image", "image", "image", "0.0114", "0.56", ""],
            row("MJC", "aluminium"),
            row("MJC, `--isothermal`", "aluminium_isothermal"),
            row("JC, power rate factor", "aluminium_power", "n", "m"),
            ["law that made the curves", "167", "596", "0.551", "0.001", "0.859", ""]])])


def make_fits(folder, program, put_in=False):
    """Runs all fits and prints the tables; puts them and the pictures into docs/."""
    if program is None:
        build("ogive_main")
    run_fits(folder, program or PROGRAMS / "ogive")
    print(tables(folder))
    if put_in:
        insert(PAGE, tables(folder), "tables: scripts/results.sh fits")
        for fit, name in PICTURES:
            shutil.copyfile(folder / fit / f"{name}.svg", PAGE.parent / "calibration" / f"{fit}_{name}.svg")
