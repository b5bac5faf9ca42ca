"""Figs. 1 to 3: fits of the laws to the synthetic curves in apps/data or to measured ones, and their tables beside the
paper's Tables 1 and 2."""

import shutil
import subprocess

from .data import PROGRAMS, ROOT, TESTS, InputError, build, markdown_table, read_json
from .insert import insert

STEEL = ["--melting-K", 1800, "--density", 7850, "--specific-heat", 452, "--young-GPa", 200, "--poisson", 0.33,
         "--leave-out-from-K", 473, "--leave-out-to-K", 673, "--predict-rates-per-s", "0.0015,4.44,21.6,577"]
ALUMINIUM = ["--melting-K", 893, "--density", 2700, "--specific-heat", 910, "--young-GPa", 70, "--poisson", 0.3]
METALS = {"weldox": ("Weldox 460 E", "weldox_460e.csv", STEEL), "aluminium": ("AA5083-H116", "aa5083_h116.csv", ALUMINIUM)}
FITS = {
    "weldox": ["--simultaneous"],
    "weldox_isothermal": ["--isothermal"],
    "weldox_power": ["--model", "jc", "--rate-factor", "power", "--reference-rate-per-s", 5e-4],
    "weldox_logarithmic": ["--model", "jc", "--reference-rate-per-s", 5e-4],
    "aluminium": [],
    "aluminium_isothermal": ["--isothermal"],
    "aluminium_power": ["--model", "jc", "--rate-factor", "power", "--reference-rate-per-s", 1],
}
PICTURES = [("weldox", name) for name in ("hardening", "rate_exponent", "thermal_exponent", "prediction")] + [
    ("aluminium", "plates")]
PAGE = ROOT / "docs" / "calibration.md"


def are_done(folder, program, page_only=False):
    """Whether the last fit is there and, unless `page_only`, newer than the curves and the program."""
    last = folder / list(FITS)[-1] / "fit.json"
    sources = [] if page_only else [program, *TESTS.glob("synthetic_*")]
    return last.exists() and all(source.stat().st_mtime <= last.stat().st_mtime for source in sources)


def metal_of_fit(name):
    return name.split("_")[0]


def curves_of(folder):
    """The files with curves of each metal: synthetic ones, or the measured ones that a folder holds."""
    if folder is None:
        return {metal: TESTS / f"synthetic_{file}" for metal, (_, file, _) in METALS.items()}
    found = {metal: folder / file for metal, (_, file, _) in METALS.items() if (folder / file).exists()}
    if not found:
        files = " or ".join(file for _, file, _ in METALS.values())
        raise InputError(f"--curves = {folder}: must be a folder that holds {files}")
    return found


def run_fits(folder, program, curves=None):
    """Fits the laws to the curves in `curves`, or to the synthetic ones; gives the names of the fits."""
    files = curves_of(curves)
    folder.mkdir(parents=True, exist_ok=True)
    names = [name for name in FITS if metal_of_fit(name) in files]
    for name in names:
        metal, _, options = METALS[metal_of_fit(name)]
        command = [program, "calibrate", "--data", files[metal_of_fit(name)], "--name",
                   metal if curves else f"{metal} synthetic", *options, *FITS[name], "--out", folder / name]
        with open(folder / f"{name}.log", "w", encoding="utf-8") as log:
            subprocess.run(list(map(str, command)), check=True, stdout=log)
    return names


def tables(folder, names, synthetic=True):
    """The fitted constants beside the paper's; beside those of the law that made the curves, if they are synthetic."""
    fits = {name: read_json(folder / name / "fit.json") for name in names}

    def row(text, name, third="a", fifth="b"):
        fit, error = fits[name], fits[name]["standard_error"]
        return [text, *(f"{fit[key]:.{digits}f} ± {error[key]:.{digits}f}" for key, digits in (
            ("A_MPa", 1), ("B_MPa", 1), (third, 4), ("C", 5), (fifth, 4))), f"{fit['rms_percent']:.2f}"]

    def made_by(*constants):
        return [["law that made the curves", *constants, ""]] if synthetic else []

    def steel():
        fit, once = fits["weldox"], fits["weldox"]["simultaneous"]
        return [
            ["paper, Table 1", "503", "581", "0.481", "0.01", "0.94", ""],
            row("MJC", "weldox"),
            [f"MJC at {fit['quasi_static']['rate_per_s']:g} 1/s (Fig. 1a read directly)",
             *(f"{fit['quasi_static'][key]:.1f}" for key in ("A_MPa", "B_MPa")), f"{fit['a']:.4f}", "", "", ""],
            ["MJC, all parameters at once", *(f"{once[key]:.{digits}f}" for key, digits in (
                ("A_MPa", 1), ("B_MPa", 1), ("a", 4), ("C", 5), ("b", 4), ("rms_percent", 2)))],
            row("MJC, `--isothermal`", "weldox_isothermal"),
            row("JC, power rate factor", "weldox_power", "n", "m"),
            *made_by("490", "383", "0.45", "0.0123", "0.94"),
            row("JC, logarithmic rate factor", "weldox_logarithmic", "n", "m")]

    def aluminium():
        return [
            ["paper, Table 2", "image", "image", "image", "0.0114", "0.56", ""],
            row("MJC", "aluminium"),
            row("MJC, `--isothermal`", "aluminium_isothermal"),
            row("JC, power rate factor", "aluminium_power", "n", "m"),
            *made_by("167", "596", "0.551", "0.001", "0.859")]

    header = ["", "A, MPa", "B, MPa", "a (n)", "C", "b (m)", "rms, %"]
    about, plate = ("synthetic curves", "15 mm plate") if synthetic else ("measured curves", "first plate")
    version = next(iter(fits.values()))["version"]
    texts = [f"Made by `scripts/results.sh fits` with ogive {version}, from {about}."]
    for name, title, rows in (("weldox", "Weldox 460 E:", steel),
                              ("aluminium", f"AA5083-H116, A, B and a of the {plate}:", aluminium)):
        if name in fits:
            texts += [title, markdown_table(header, rows())]
    return "\n\n".join(texts)


def make_fits(folder, program, curves=None, put_in=False):
    """Runs all fits and prints the tables; puts them and the pictures into docs/."""
    if curves and put_in:
        raise InputError("--insert: is for the synthetic curves of docs/calibration.md: must not go with --curves")
    curves_of(curves)
    if program is None:
        build("ogive_main")
    text = tables(folder, run_fits(folder, program or PROGRAMS / "ogive", curves), curves is None)
    print(text)
    if put_in:
        insert(PAGE, text, "tables: scripts/results.sh fits")
        for fit, name in PICTURES:
            shutil.copyfile(folder / fit / f"{name}.svg", PAGE.parent / "calibration" / f"{fit}_{name}.svg")
