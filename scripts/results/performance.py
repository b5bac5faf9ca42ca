"""The tables of docs/performance.md from what bench_step has measured."""

from pathlib import Path

from .data import ROOT, read_json
from .insert import insert

SHOWN = ("neighbours", "gradient", "stress", "force", "hexes", "contact", "motion", "checks")


def aligned(header, rows):
    """A table in Markdown, flush right, that is readable on a terminal too. Columns without any value are left out."""
    used = [k for k in range(len(header)) if any(row[k] for row in rows)]
    header, rows = [header[k] for k in used], [[row[k] for k in used] for row in rows]
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
            lane_pairs, peak = entries * shot["lane_pairs_of_entry"], limits["flop_per_s"]
            flops = work["flop_per_lane_pair"] * lane_pairs / seconds
            busy = 2 * work["instructions_per_lane_pair"] * lane_pairs / seconds / peak
            counts = [f"{100 * shot['pairs'] / lane_pairs:.0f}", f"{flops * 1e-9:.1f}", f"{100 * busy:.0f}"]
            # What would take more than half of the time by itself.
            bound = "neither" if max(busy, of_triad) <= 0.5 else "arithmetic" if busy > of_triad else "memory"
        yield [loop, *counts, f"{work['bytes'] / shot['particles']:.0f}", f"{100 * of_triad:.0f}", bound]


def tables(report, earlier=None, name=""):
    """All tables; with an earlier measurement, the times of that one, of the version `name`, beside those of `report`."""
    shots = [{"method": "paper", "lane_pairs_of_entry": report["lane_pairs_of_entry"], **shot} for shot in report["shots"]]
    every = [(shot, timing, limits) for shot in shots for timing, limits in zip(shot["timings"], report["limits"])]
    before = {(shot.get("method", "paper"), round(shot["particles"], -3), timing["threads"]): (shot, timing)
              for shot in (earlier or {"shots": []})["shots"] for timing in shot["timings"]}

    def of_case(shot, timing):
        return [shot["method"], str(shot["particles"]), str(timing["threads"])]

    def steps():
        for shot, timing, _ in every:
            found = before.get((shot["method"], round(shot["particles"], -3), timing["threads"]))
            cases = ([("before", *found)] if found else []) + [("now" if earlier else "", shot, timing)]
            for label, one, times in cases:
                ns = 1e9 / one["particles"]
                ratio = f"{timing['step_s'] / shot['particles'] / found[1]['step_s'] * found[0]['particles']:.2f}" \
                    if found and one is shot else ""
                yield [*of_case(shot, timing), label, f"{times['step_s'] * ns:.0f}", ratio,
                       *(f"{times['phases_s'][phase] * ns:.1f}" for phase in SHOWN), f"{times['rebuild_s'] * ns:.0f}",
                       f"{times['phases_s']['hexes'] * 1e9 / one['hexes']:.0f}",
                       f"{times['phases_s']['contact'] * 1e9 / one['slaves']:.1f}"]

    def memory():
        for shot in shots:
            m = shot["memory_bytes"]
            names = [name for name in ("nodes", "points", "pair_data", "neighbours", "lists", "bonds") if name in m]
            found = before.get((shot["method"], round(shot["particles"], -3), shot["timings"][0]["threads"]))
            old = found and f"{found[0]['memory_bytes']['process'] / found[0]['particles']:.0f}"
            yield [shot["method"], str(shot["particles"]), *(f"{m[name] / shot['particles']:.0f}" for name in names),
                   f"{sum(m[name] for name in names) / shot['particles']:.0f}",
                   f"{m['process'] / shot['particles']:.0f}", old or ""]

    return "\n\n".join([
        f"Made by `bench/performance.sh` with ogive {report['version']} on {report['cores']} cores, registers of "
        f"{report['register_bits']} bits; medians of {report['repeats']} "
        f"measurement{'' if report['repeats'] == 1 else 's'}{f'; *before* is commit {name}' if earlier else ''}. The machine: "
        + "; ".join(f"{m['threads']} thread{'' if m['threads'] == 1 else 's'}: triad {m['triad_byte_per_s'] * 1e-9:.1f} GB/s, "
                    f"multiply-adds {m['flop_per_s'] * 1e-9:.0f} Gflop/s" for m in report["limits"]) + ".",
        "Wall time, ns per particle and step; *lists* is what a step takes longer in which the lists are built anew; "
        "hexes in ns per hex, contact in ns per slave too:",
        aligned(["method", "particles", "threads", "", "all", "ratio", *SHOWN, "lists", "per hex", "per slave"], list(steps())),
        "The loops against the machine with as many threads: the share of the computed pairs that lie within the support, "
        "the share of the time that the arithmetic units are busy, and of the memory's throughput:",
        aligned(["method", "particles", "threads", "loop", "pairs, %", "Gflop/s", "units busy, %", "byte/particle",
                 "of triad, %", "bound by"],
                [[*of_case(shot, timing), *row] for shot, timing, limits in every for row in bounds(shot, timing, limits)]),
        "Memory of the disc, byte per particle, and the most that the process took, with hexes, contact and what is needed "
        "for a while only:",
        aligned(["method", "particles", "nodes", "points", "pair data", "places", "lists", "bonds", "sum", "process",
                 "before"], list(memory()))])


def make_tables(file, put_in=False, before=None):
    """Prints the tables of a measurement, and puts them into their page."""
    text = tables(read_json(file), read_json(before), Path(before).stem) if before else tables(read_json(file))
    print(text)
    if put_in:
        insert(ROOT / "docs" / "performance.md", text, "tables: bench/performance.sh")
