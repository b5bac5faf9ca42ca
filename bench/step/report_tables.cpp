// SPDX-License-Identifier: BSD-3-Clause
#include "report.hpp"

#include "ogive/core/pack.hpp"
#include "ogive/version.hpp"

#include <omp.h>

#include <algorithm>
#include <cstdio>

namespace bench {

namespace {

using ogive::Phase;

/// A table in Markdown whose columns stand one below the other.
struct Table {
  std::vector<std::vector<std::string>> rows; ///< the first one has the titles
};

std::string text_of(const Table &table) {
  std::vector<std::size_t> width(table.rows[0].size(), 3);
  for (const auto &row : table.rows)
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
  std::string text;
  const auto line = [&](auto &&cell) {
    for (std::size_t c = 0; c < width.size(); ++c) text += (c == 0 ? "| " : " | ") + cell(c);
    text += " |\n";
  };
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    line([&](std::size_t c) { return std::string(width[c] - table.rows[r][c].size(), ' ') + table.rows[r][c]; });
    if (r == 0) line([&](std::size_t c) { return std::string(width[c] - 1, '-') + ":"; });
  }
  return text + "\n";
}

std::string number(double value, int digits = 0) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}
std::string percent(double share) { return number(100 * share); }

std::string of_machine(const Report &r) {
  Table table{{{"threads", "triad, GB/s", "multiply-add, Gflop/s"}}};
  for (const Limits &l : r.limits)
    table.rows.push_back({std::to_string(l.threads), number(l.triad * 1e-9, 1), number(l.arithmetic * 1e-9, 1)});
  const auto ns = [](double seconds) { return number(seconds * 1e9, 2) + " ns"; };
  std::string text = "Limits of the machine: registers of " + std::to_string(8 * ogive::register_bytes) + " bits, " +
                     std::to_string(ogive::lanes<double>) + " doubles in a pack, " +
                     std::to_string(omp_get_num_procs()) + " cores, triad over " +
                     number(static_cast<double>(r.triad_bytes) / (1 << 20)) + " MiB:\n\n" + text_of(table);
  return text + "One thread needs for a pack: division " + ns(r.pack_times.division) + ", square root " +
         ns(r.pack_times.root) + ", `reciprocal` " + ns(r.pack_times.reciprocal) + ", `inverse_sqrt` " +
         ns(r.pack_times.inverse_root) + ".\n\n";
}

std::string of_steps(const Report &r) {
  std::vector<std::string> titles{"particles", "threads", "all"};
  constexpr auto shown = static_cast<std::size_t>(Phase::observer);
  for (std::size_t k = 0; k < shown; ++k) titles.emplace_back(ogive::name(static_cast<Phase>(k)));
  titles.insert(titles.end(), {"speed-up", "spread, %"});
  Table table{{titles}};
  for (const ShotResult &shot : r.shots)
    for (const Timing &t : shot.timings) {
      const double unit = 1e9 / static_cast<double>(shot.work.particles);
      std::vector<std::string> row{std::to_string(shot.work.particles), std::to_string(t.threads),
                                   number(t.step * unit)};
      for (std::size_t k = 0; k < shown; ++k) row.push_back(number(t.phases[k] * unit, 1));
      row.push_back(number(shot.timings[0].step / t.step, 2));
      row.push_back(number(100 * t.spread, 1));
      table.rows.push_back(row);
    }
  return "Wall time, ns per particle and step:\n\n" + text_of(table);
}

std::string of_parts(const Report &r) {
  Table table{{{"particles", "threads", "gradient, ns/pair", "force, ns/pair", "hexes, ns/element", "contact, ns/slave",
                "new lists, ms", "new lists, ns/particle"}}};
  for (const ShotResult &shot : r.shots)
    for (const Timing &t : shot.timings) {
      const auto per = [&](Phase phase, std::int64_t parts) {
        return number(t[phase] * 1e9 / static_cast<double>(parts), 2);
      };
      table.rows.push_back({std::to_string(shot.work.particles), std::to_string(t.threads),
                            per(Phase::gradient, shot.work.pairs), per(Phase::force, shot.work.pairs),
                            per(Phase::hexes, shot.hexes), per(Phase::contact, shot.slaves), number(t.rebuild * 1e3, 2),
                            number(t.rebuild * 1e9 / static_cast<double>(shot.work.particles))});
    }
  return "Wall time of a step's parts, and what a step takes longer in which the lists are built anew:\n\n" +
         text_of(table);
}

std::string of_bounds(const Report &r) {
  Table table{{{"particles", "threads", "loop", "Gflop/s", "of peak, %", "units busy, %", "byte/particle", "GB/s",
                "of triad, %", "bound by"}}};
  for (const ShotResult &shot : r.shots)
    for (std::size_t k = 0; k < shot.timings.size(); ++k) {
      const Timing &t = shot.timings[k];
      const auto row = [&](Phase phase, const PairArithmetic *arithmetic, std::int64_t entries, double bytes) {
        const Nearness n =
            nearness(arithmetic ? *arithmetic : PairArithmetic{0, 0}, entries, bytes, t[phase], r.limits[k]);
        const auto if_counted = [&](const std::string &text) { return arithmetic ? text : "not counted"; };
        table.rows.push_back({std::to_string(shot.work.particles), std::to_string(t.threads),
                              std::string(ogive::name(phase)), if_counted(number(n.flops * 1e-9, 1)),
                              if_counted(percent(n.of_peak)), if_counted(percent(n.instructions)),
                              number(bytes / static_cast<double>(shot.work.particles)), number(n.bytes * 1e-9, 1),
                              percent(n.of_triad), arithmetic || n.of_triad > 0.5 ? bound(n) : "not memory"});
      };
      row(Phase::gradient, &gradient_arithmetic, shot.work.listed, shot.work.gradient_bytes);
      row(Phase::force, &force_arithmetic, shot.work.within, shot.work.force_bytes);
      row(Phase::stress, nullptr, 0, shot.work.stress_bytes);
    }
  return "Against the limits of the machine with as many threads:\n\n" + text_of(table);
}

std::string of_work(const Report &r) {
  Table table{{{"particles", "spacing, mm", "images", "hexes", "flowing, %", "neighbours", "list", "within",
                "gradient, %", "force, %", "first step", "at, us", "steps", "new lists"}}};
  for (const ShotResult &shot : r.shots) {
    const Work &w = shot.work;
    const auto particles = static_cast<double>(w.particles), pairs = static_cast<double>(w.pairs);
    table.rows.push_back(
        {std::to_string(w.particles), number(shot.spacing * 1e3, 3), std::to_string(w.images),
         std::to_string(shot.hexes), number(100 * static_cast<double>(w.flowing) / particles, 1),
         number(pairs / particles, 1), number(static_cast<double>(w.listed) / static_cast<double>(w.clusters), 1),
         number(static_cast<double>(w.within) / static_cast<double>(w.clusters), 1),
         percent(pairs / lane_pairs(w.listed)), percent(pairs / lane_pairs(w.within)), std::to_string(shot.start_step),
         number(shot.start_time * 1e6, 2), std::to_string(shot.steps), std::to_string(shot.timings[0].rebuilds)});
  }
  return "What was computed: neighbours of a particle within the support, entries in the list of a cluster and "
         "those within the support of one of its particles, and how many of the pairs that the two loops compute "
         "count:\n\n" +
         text_of(table);
}

std::string of_memory(const Report &r) {
  Table table{{{"particles", "nodes", "points", "pair data", "places", "lists", "sum", "process, MB",
                "process, byte/particle"}}};
  for (const ShotResult &shot : r.shots) {
    const auto particles = static_cast<double>(shot.work.particles);
    const Memory &m = shot.memory;
    const auto each = [&](double bytes) { return number(bytes / particles); };
    table.rows.push_back({std::to_string(shot.work.particles), each(m.nodes), each(m.points), each(m.pair_data),
                          each(m.neighbours), each(m.lists), each(sum(m)), number(m.process * 1e-6), each(m.process)});
  }
  return "Memory of the disc, byte per particle, and the most that the process took, with hexes, contact and what is "
         "needed for a while only:\n\n" +
         text_of(table);
}

std::string of_states(const Report &r) {
  Table table{{{"particles", "hash of the state", "threads that lead to it"}}};
  for (const ShotResult &shot : r.shots)
    for (const Timing &t : shot.timings) {
      char hash[32];
      std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(t.hash));
      const std::string particles = std::to_string(shot.work.particles), threads = std::to_string(t.threads);
      if (auto &last = table.rows.back(); last[0] == particles && last[1] == hash)
        last[2] += ", " + threads;
      else
        table.rows.push_back({particles, hash, threads});
    }
  return "State after the steps that were timed:\n\n" + text_of(table);
}

} // namespace

Nearness nearness(const PairArithmetic &arithmetic, std::int64_t entries, double bytes, double seconds,
                  const Limits &limits) {
  Nearness n;
  const double lane_pairs = bench::lane_pairs(entries);
  n.flops = arithmetic.flops * lane_pairs / seconds;
  n.of_peak = n.flops / limits.arithmetic;
  n.instructions = 2 * arithmetic.instructions * lane_pairs / seconds / limits.arithmetic;
  n.bytes = bytes / seconds;
  n.of_triad = n.bytes / limits.triad;
  return n;
}

std::string bound(const Nearness &n) {
  if (std::max(n.instructions, n.of_triad) <= 0.5) return "neither";
  return n.instructions > n.of_triad ? "arithmetic" : "memory";
}

std::string tables(const Report &r) {
  std::string text = "Made by `bench/performance.sh` with ogive " + std::string(ogive::version) + " on " +
                     std::to_string(omp_get_num_procs()) + " cores; medians of " + std::to_string(r.repeats) +
                     (r.repeats == 1 ? " measurement.\n\n" : " measurements.\n\n");
  text += of_machine(r) + of_steps(r) + of_parts(r) + of_bounds(r) + of_work(r) + of_memory(r) + of_states(r);
  text.pop_back();
  return text;
}

} // namespace bench
