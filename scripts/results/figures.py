"""Runs or resumes all shots of the paper's figures, draws them and makes the page."""

import math
import os
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

from . import fits
from .data import PAGE, PROGRAMS, ROOT, InputError, Tests, build, metal_of, read_table, short
from .page import make_page
from .published import keep, keep_pictures, take_kept, take_published

CAMPAIGNS = ("steel_blunt", "nose_shapes", "aluminium_conical")
METHODS = ("paper", "stabilised")


class Shot:
    """A shot of a picture, of the modified law, in the folder that the programs of the figures give it."""

    def __init__(self, figures, method, material, nose, thickness, velocity, spacing):
        name = f"{method}_mjc_{material}_{nose}_{thickness}mm_{velocity}mps_{short(spacing)}mm"
        self.thickness, self.velocity, self.folder = thickness, velocity, figures / "shots" / name
        self.series = self.folder / "perforation.pvd"

    def is_there(self, number):
        """Whether it has frames; if not, that is said unless the picture is there already."""
        if self.series.exists() and (self.folder / "summary.json").exists():
            return True
        if not (self.folder.parents[1] / f"figure_{number}.png").exists():
            print(f"figure {number} is left out: no shot with frames in {self.folder}")
        return False

    def last_us(self):
        return max((float(frame.get("timestep")) for frame in xml.parse(self.series).iter("DataSet")), default=-math.inf)

    def velocity_mps(self, time_us):
        """Of the projectile, at the row of the history nearest to the time."""
        rows = read_table(self.folder / "history.csv", ("time_us", "velocity_m_per_s"))
        return min(rows, key=lambda row: abs(row["time_us"] - time_us))["velocity_m_per_s"]


def times(shots, wanted):
    """Those times that lie well before the last frames of all the series."""
    last = min(shot.last_us() for shot in shots)
    return [time for time in wanted if time < 0.95 * last]


class Campaign:
    """Where a campaign is, and the steps of it that failed."""

    def __init__(self, figures, programs, spacing_mm=None):
        self.figures, self.programs, self.tests, self.failed = figures, programs, Tests(spacing_mm), []

    def attempt(self, text, *command, **options):
        """Runs a command; if it fails that is reported at the end."""
        try:
            subprocess.run(list(map(str, command)), check=True, **options)
        except subprocess.CalledProcessError as error:
            self.failed.append(f"{text} (exit status {error.returncode})")
        except OSError as error:
            self.failed.append(f"{text} ({error.filename}: {error.strerror})")

    def fit(self, page_only):
        folder, program = self.figures / "figures_1_to_3", self.programs / "ogive"
        if fits.are_done(folder, program, page_only):
            return
        try:
            fits.run_fits(folder, program)
            print(f"figures 1 to 3: {folder}")
        except (OSError, subprocess.CalledProcessError) as error:
            self.failed.append(f"figures 1 to 3 ({error})")

    def draw_model(self):
        """Fig. 5: the model of the 12 mm plate before the shot."""
        model = self.figures / "model"
        if (self.figures / "figure_5.png").exists():
            return
        self.attempt("figure 5", self.programs / "ogive", "mesh", "--method", "paper", "--thickness-mm", 12, "--spacing-mm",
                     self.tests.distance_mm("blunt"), "--out", model, stdout=subprocess.DEVNULL)
        self.draw(5, [], "--mesh", model)

    def film(self, number, shot, *options):
        """Draws a shot as a film where there is ffmpeg."""
        if shutil.which("ffmpeg"):
            self.draw(number, [shot], *options, flag="--animate", ending="webm")

    def draw(self, number, shots, *options, flag="--out", ending="png"):
        """Draws a figure unless it is newer than the series."""
        picture = self.figures / f"figure_{number}.{ending}"
        if picture.exists() and all(shot.series.stat().st_mtime <= picture.stat().st_mtime for shot in shots):
            return
        self.figures.mkdir(parents=True, exist_ok=True)
        series = ["--series", *(shot.folder for shot in shots)] if shots else []
        self.attempt(picture, self.programs / "ogive", "draw", *series, *options, flag, picture)
        if picture.exists():
            if ending == "png":
                self.reduce_colours(picture)
            print(f"figure: {picture}")

    def reduce_colours(self, picture):
        """Gives a picture 256 colours where there is ffmpeg: it looks the same and has two thirds of the bytes or less."""
        if not shutil.which("ffmpeg"):
            return
        reduced = picture.with_name(f"reduced_{picture.name}")
        self.attempt(f"colours of {picture}", "ffmpeg", "-y", "-loglevel", "error", "-i", picture, "-vf",
                     "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none", reduced)
        if reduced.exists():
            reduced.replace(picture)

    def pictures(self, method):
        """Figs. 7, 8, 10 and 14 with a method."""
        suffix, text = ("", "") if method == "paper" else (f"_{method}", f", {method}")

        def shot(material, nose, thickness, velocity):
            distance = self.tests.distance_mm(nose, metal_of(material), thickness)
            return Shot(self.figures, method, material, nose, thickness, velocity, distance)

        def at(shots, wanted):
            return ["--times-us", ",".join([*map(str, times(shots, wanted)), "last"])]

        steel_10, steel_6 = shot("weldox_460e", "blunt", 10, 180), shot("weldox_460e", "blunt", 6, 160)
        if steel_10.is_there(f"7{suffix}"):
            title = ["--title", f"Fig. 7: 10 mm Weldox 460 E, blunt, 180 m/s{text}"]
            options = [*at([steel_10], (0, 10, 20, 40, 60, 100, 150)), *title]
            self.draw(f"7{suffix}", [steel_10], *options)
            self.draw(f"7_temperature{suffix}", [steel_10], "--colour", "temperature", *options)
            self.film(f"7{suffix}", steel_10, *title)
        if all([steel_6.is_there(f"8{suffix}"), steel_10.is_there(f"8{suffix}")]):
            both, frames = [steel_6, steel_10], times([steel_6, steel_10], (0, 15, 30, 60, 100))
            labels = [f"{plate}, {round(time)} µs, {round(one.velocity_mps(time))} m/s"
                      for plate, one in (("(a) 6 mm", steel_6), ("(b) 10 mm", steel_10)) for time in (*frames, one.last_us())]
            self.draw(f"8{suffix}", both, *at(both, frames), "--label", *labels, "--columns", len(frames) + 1, "--title",
                      f"Fig. 8: Weldox 460 E, blunt: (a) 6 mm, 160 m/s; (b) 10 mm, 180 m/s{text}")
        sections = [shot("weldox_460e", "blunt", *pair)
                    for pair in ((6, 110), (8, 135), (10, 160), (12, 195), (16, 240), (20, 310))]
        if all([section.is_there(f"10{suffix}") for section in sections]):
            labels = [f"{s.thickness} mm, {s.velocity} to {round(s.velocity_mps(s.last_us()))} m/s" for s in sections]
            self.draw(f"10{suffix}", sections, "--label", *labels, "--columns", 3, "--times-us", "last", "--title",
                      f"Fig. 10: Weldox 460 E, blunt, last frame{text}")
            self.draw(f"10_plates{suffix}", sections, "--label", *labels, "--columns", 1, "--times-us", "last",
                      "--view-mm=-45,25,255", "--title", f"Fig. 10: whole plates{text}")
        aluminium = shot("aa5083_h116", "conical", 15, 214)
        if aluminium.is_there(f"14{suffix}"):
            title = ["--title", f"Fig. 14: 15 mm AA5083-H116, conical, 214 m/s{text}"]
            self.draw(f"14{suffix}", [aluminium], *at([aluminium], (0, 40, 80, 120, 200, 360, 600)),
                      "--view-mm=-60,22,28", *title)
            self.draw(f"14_behind{suffix}", [aluminium], "--from", "behind", "--pixels", 900, *title)
            self.film(f"14{suffix}", aluminium, *title)


def make_figures(quick, page_only, published, method, jobs):
    """All of it. FIGURES, PAGE and PROGRAMS name other folders for the shots, the page and the programs. Programs that fail
    do not stop the others; the status is then 3. Rows of the default folder are kept in bench/rows/figures."""
    figures = Path(os.environ.get("FIGURES") or ROOT / "vtk_out" / ("figures_quick" if quick else "figures")).resolve()
    page = Path(os.environ.get("PAGE") or (figures / "page" if quick else PAGE)).resolve()
    programs = Path(os.environ.get("PROGRAMS") or PROGRAMS).resolve()
    if not os.environ.get("PROGRAMS"):
        build("ogive_main", *CAMPAIGNS)
    sys.stdout.reconfigure(line_buffering=True)
    keeps = not quick and not os.environ.get("FIGURES")
    if keeps:
        take_kept(figures)
    if published:
        take_published(page, figures)
    spacing_mm = 1.5 if quick else None
    campaign = Campaign(figures, programs, spacing_mm)
    options = ["--method", method, "--out", figures, *(["--quick"] if quick else []),
               *(["--no-pictures"] if published else []), *(["--no-run"] if page_only else ["--jobs", jobs] if jobs else [])]
    for name in CAMPAIGNS:
        campaign.attempt(name, programs / name, *options, stdout=subprocess.DEVNULL if page_only else None)
    if keeps and not published:
        keep(figures)
    campaign.fit(page_only)
    campaign.draw(4, [], "--projectiles")
    campaign.draw_model()
    for name in METHODS:
        if name == "paper" or any(figures.glob(f"shots/{name}_*")):
            campaign.pictures(name)
    if keeps and not published:
        keep_pictures(picture for number in (7, 8, 10, 14) for ending in ("png", "webm")
                      for picture in figures.glob(f"figure_{number}[._]*{ending}"))
    try:
        make_page(figures, page, spacing_mm=spacing_mm)
    except InputError as error:
        campaign.failed.append(f"page ({error})")
    for text in campaign.failed:
        print(f"figures: failed: {text}", file=sys.stderr)
    return 3 if campaign.failed else 0
