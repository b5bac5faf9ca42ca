// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// bench_step: times the steps of a shot and what the machine can do, and writes both as JSON in SI units.
/// bench/performance.sh makes tables of it.

#include "limits.hpp"
#include "shot.hpp"

#include "ogive/version.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <iostream>
#include <string>

namespace {

using bench::Json;

bench::Plan read_options(CLI::App &app, int argc, const char *const *argv) {
  bench::Plan plan;
  const auto *sizes = app.add_option("--sizes", plan.sizes, "particles of the computed quarter")
                          ->delimiter(',')
                          ->check(CLI::Range(1000.0, 1e8));
  app.add_option("--threads", plan.threads, "numbers of threads (default: 1, 2 and one for each core)")
      ->delimiter(',')
      ->check(CLI::Range(1, 1024));
  app.add_option("--steps", plan.steps, "steps that are timed; 0: whole cycles of the neighbour lists")
      ->check(CLI::Range(0, 1000000));
  const auto *repeats =
      app.add_option("--repeats", plan.repeats, "measurements, the median counts")->check(CLI::Range(1, 1000));
  app.add_option("--methods", plan.methods, "methods of the plate (default: paper,stabilised)")
      ->delimiter(',')
      ->check(CLI::IsMember({"paper", "stabilised"}));
  app.add_flag("--quick", plan.quick, "small sizes and short measurements, to see that all works");
  app.parse(argc, argv);
  if (plan.quick) {
    if (sizes->count() == 0) plan.sizes = {3000, 25000};
    if (repeats->count() == 0) plan.repeats = 1;
    plan.seconds = 0.3;
  }
  auto &threads = plan.threads;
  if (threads.empty()) {
    const int cores = omp_get_num_procs();
    threads = {1, std::min(2, cores), cores};
  }
  std::sort(threads.begin(), threads.end());
  threads.erase(std::unique(threads.begin(), threads.end()), threads.end());
  return plan;
}

/// True if all numbers of threads led to the same state.
bool equal_states(const Json &shot) {
  const auto &first = shot["timings"][0]["state_hash"];
  return std::all_of(shot["timings"].begin(), shot["timings"].end(),
                     [&](const Json &t) { return t["state_hash"] == first && first != "0000000000000000"; });
}

int measure(const bench::Plan &plan) {
  const bool quick = plan.quick;
  const std::size_t bytes = bench::triad_bytes(quick);
  Json limits = Json::array(), shots = Json::array();
  std::fprintf(stderr, "limits of the machine\n");
  for (const int threads : plan.threads)
    limits.push_back({{"threads", threads},
                      {"triad_byte_per_s", bench::measure_triad(threads, bytes, quick)},
                      {"flop_per_s", bench::measure_arithmetic(threads, quick)}});
  bool equal = true;
  for (const std::string &method : plan.methods)
    for (const double size : plan.sizes) {
      shots.push_back(bench::measure_shot(size, method, plan, [&](const std::string &text) {
        std::fprintf(stderr, "%s, %.0f particles: %s\n", method.c_str(), size, text.c_str());
      }));
      equal = equal && equal_states(shots.back());
    }
  const Json all{{"version", ogive::version},
                 {"cores", omp_get_num_procs()},
                 {"register_bits", 8 * ogive::register_bytes},
                 {"lane_pairs_of_entry", ogive::lanes<float>},
                 {"triad_bytes", bytes},
                 {"repeats", plan.repeats},
                 {"limits", limits},
                 {"shots", shots}};
  std::cout << all.dump(2) << std::endl;
  if (equal) return 0;
  std::fprintf(stderr, "bench_step: error: the state depends on the number of threads\n");
  return 1;
}

} // namespace

int main(int argc, char **argv) {
  CLI::App app("Times the steps of a shot and what the machine can do; prints JSON.", "bench_step");
  try {
    return measure(read_options(app, argc, argv));
  } catch (const CLI::Success &success) {
    return app.exit(success);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "bench_step: error: %s\n", error.what());
    return 2;
  }
}
