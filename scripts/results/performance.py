"""The tables of docs/performance.md from what bench_step has measured."""

from .data import ROOT, read_json
from .insert import insert

SHOWN = ("neighbours", "gradient", "stress", "force", "hexes", "contact", "motion", "checks")


def aligned(header, rows):
    """A table in Markdown, flush right, that is readable on a terminal too."""
    widths = [max(3, *(len(row[k]) for row in [header, *rows])) for k in range(len(header))]

    def line(cells):
        return "| " + " | ".join(cell.rjust(width) for cell, width in zip(cells, widths)) + " |"

    return "\n".join([line(header), line(["-" * (width - 1) + ":" for width in widths]), *map(line, rows)])


def bounds(shot, timing, limits):
    """Rows of the loops over pairs and of the stress: shares of what the machine can do with as many threads."""
    for loop, entries in (("gradient", shot["listed"]), ("force", shot["within"]), ("stress", None)):
        work, seconds = shot[loop], timing["phases_s"][loop]
        of_triad = work["bytes"] / seconds / limits["triad_byte_per_s"]
        counts, bound = ["not counted"] * 3, "memory" if of_triad > 0.5 else "not memory"
        if entries is not None:
            lane_pairs, peak = entries * shot["lanes"] / seconds, limits["flop_per_s"]
            flops = work["flop_per_lane_pair"] * lane_pairs
            busy = 2 * work["instructions_per_lane_pair"] * lane_pairs / peak
            counts = [f"{flops * 1e-9:.1f}", f"{100 * flops / peak:.0f}", f"{100 * busy:.0f}"]
            # What would take more than half of the time by itself.
            bound = "neither" if max(busy, of_triad) <= 0.5 else "arithmetic" if busy > of_triad else "memory"
        yield [loop, *counts, f"{work['bytes'] / shot['particles']:.0f}", f"{work['bytes'] / seconds * 1e-9:.1f}",
               f"{100 * of_triad:.0f}", bound]


def states(shot):
    """Each hash with the numbers of threads that lead to it."""
    pairs = [(timing["state_hash"], str(timing["threads"])) for timing in shot["timings"]]
    return [[str(shot["particles"]), found, ", ".join(threads for other, threads in pairs if other == found)]
            for found in dict(pairs)]


def tables(report):
    shots = [{**shot, "lanes": report["lanes"]} for shot in report["shots"]]
    every = [(shot, timing, limits) for shot in shots for timing, limits in zip(shot["timings"], report["limits"])]

    def each(header, cells):
        return aligned(["particles", "threads", *header],
                       [[str(shot["particles"]), str(timing["threads"]), *cells(shot, timing)] for shot, timing, _ in every])

    def steps(shot, timing):
        ns = 1e9 / shot["particles"]
        return [f"{timing['step_s'] * ns:.0f}", *(f"{timing['phases_s'][phase] * ns:.1f}" for phase in SHOWN),
                f"{shot['timings'][0]['step_s'] / timing['step_s']:.2f}", f"{100 * timing['spread']:.1f}"]

    def parts(shot, timing):
        phases, rebuild = timing["phases_s"], timing["rebuild_s"]
        return [*(f"{phases[phase] * 1e9 / shot[things]:.2f}" for phase, things in (
            ("gradient", "pairs"), ("force", "pairs"), ("hexes", "hexes"), ("contact", "slaves"))),
            f"{rebuild * 1e3:.2f}", f"{rebuild * 1e9 / shot['particles']:.0f}"]

    def work(shot):
        def lane_share(entries):
            return f"{100 * shot['pairs'] / (shot[entries] * shot['lanes']):.0f}"

        return [str(shot["particles"]), f"{shot['spacing_m'] * 1e3:.3f}", str(shot["images"]), str(shot["hexes"]),
                f"{100 * shot['flowing'] / shot['particles']:.1f}", f"{shot['pairs'] / shot['particles']:.1f}",
                *(f"{shot[entries] / shot['clusters']:.1f}" for entries in ("listed", "within")), lane_share("listed"),
                lane_share("within"), str(shot["start_step"]), f"{shot['start_time_s'] * 1e6:.2f}", str(shot["steps"]),
                str(shot["rebuilds"])]

    def memory(shot):
        m = shot["memory_bytes"]
        names = ("nodes", "points", "pair_data", "neighbours", "lists")
        return [str(shot["particles"]), *(f"{value / shot['particles']:.0f}" for value in (
            *(m[name] for name in names), sum(m[name] for name in names))), f"{m['process'] * 1e-6:.0f}",
            f"{m['process'] / shot['particles']:.0f}"]

    packs = {name: f"{seconds * 1e9:.2f} ns" for name, seconds in report["pack_s"].items()}
    return "\n\n".join([
        f"Made by `bench/performance.sh` with ogive {report['version']} on {report['cores']} cores; medians of "
        f"{report['repeats']} measurement{'' if report['repeats'] == 1 else 's'}.",
        f"Limits of the machine: registers of {report['register_bits']} bits, {report['lanes']} doubles in a pack, "
        f"{report['cores']} cores, triad over {report['triad_bytes'] / 2**20:.0f} MiB:",
        aligned(["threads", "triad, GB/s", "multiply-add, Gflop/s"],
                [[str(m["threads"]), f"{m['triad_byte_per_s'] * 1e-9:.1f}", f"{m['flop_per_s'] * 1e-9:.1f}"]
                 for m in report["limits"]]),
        f"One thread needs for a pack: division {packs['division']}, square root {packs['square_root']}, `reciprocal` "
        f"{packs['reciprocal']}, `inverse_sqrt` {packs['inverse_square_root']}.",
        "Wall time, ns per particle and step:", each(["all", *SHOWN, "speed-up", "spread, %"], steps),
        "Wall time of a step's parts, and what a step takes longer in which the lists are built anew:",
        each(["gradient, ns/pair", "force, ns/pair", "hexes, ns/element", "contact, ns/slave", "new lists, ms",
              "new lists, ns/particle"], parts),
        "Against the limits of the machine with as many threads:",
        aligned(["particles", "threads", "loop", "Gflop/s", "of peak, %", "units busy, %", "byte/particle", "GB/s",
                 "of triad, %", "bound by"],
                [[str(shot["particles"]), str(timing["threads"]), *row] for shot, timing, limits in every
                 for row in bounds(shot, timing, limits)]),
        "What was computed: neighbours of a particle within the support, entries in the list of a cluster and those within "
        "the support of one of its particles, and how many of the pairs that the two loops compute count:",
        aligned(["particles", "spacing, mm", "images", "hexes", "flowing, %", "neighbours", "list", "within", "gradient, %",
                 "force, %", "first step", "at, us", "steps", "new lists"], list(map(work, shots))),
        "Memory of the disc, byte per particle, and the most that the process took, with hexes, contact and what is needed for "
        "a while only:",
        aligned(["particles", "nodes", "points", "pair data", "places", "lists", "sum", "process, MB",
                 "process, byte/particle"], list(map(memory, shots))),
        "State after the steps that were timed:",
        aligned(["particles", "hash of the state", "threads that lead to it"],
                [row for shot in shots for row in states(shot)])])


def make_tables(file, put_in=False):
    """Prints the tables of a measurement, and puts them into their page."""
    text = tables(read_json(file))
    print(text)
    if put_in:
        insert(ROOT / "docs" / "performance.md", text, "tables: bench/performance.sh")
