// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// bench_step: times the steps of a shot and compares them with what the machine can do.

#include "report.hpp"

#include <CLI/CLI.hpp>
#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>

namespace {

struct Options {
  std::vector<double> sizes{3000, 25000, 100000, 1000000};
  bench::Plan plan;
  std::string json;
  bool quick = false;
};

Options read_options(CLI::App &app, int argc, const char *const *argv) {
  Options options;
  const auto *sizes = app.add_option("--sizes", options.sizes, "particles of the computed quarter")->delimiter(',');
  app.add_option("--threads", options.plan.threads, "numbers of threads (default: 1, 2 and one for each core)")
      ->delimiter(',')
      ->check(CLI::Range(1, 1024));
  app.add_option("--steps", options.plan.steps, "steps that are timed; 0: whole cycles of the neighbour lists")
      ->check(CLI::Range(0, 1000000));
  const auto *repeats =
      app.add_option("--repeats", options.plan.repeats, "measurements, the median counts")->check(CLI::Range(1, 1000));
  app.add_option("--json", options.json, "file for all numbers");
  app.add_flag("--quick", options.quick, "small sizes and short measurements, to see that all works");
  app.parse(argc, argv);
  for (const double size : options.sizes)
    if (!(size >= 1000 && size <= 1e8)) throw CLI::ValidationError("--sizes", "must lie between 1000 and 1e8");
  if (options.quick) {
    if (sizes->count() == 0) options.sizes = {3000, 25000};
    if (repeats->count() == 0) options.plan.repeats = 1;
    options.plan.seconds = 0.3;
  }
  auto &threads = options.plan.threads;
  if (threads.empty()) {
    const int cores = omp_get_num_procs();
    threads = {1, std::min(2, cores), cores};
  }
  std::sort(threads.begin(), threads.end());
  threads.erase(std::unique(threads.begin(), threads.end()), threads.end());
  return options;
}

int measure(const Options &options) {
  bench::Report report;
  report.repeats = options.plan.repeats;
  report.triad_bytes = bench::triad_bytes(options.quick);
  std::fprintf(stderr, "limits of the machine\n");
  for (const int threads : options.plan.threads)
    report.limits.push_back(bench::measure_limits(threads, report.triad_bytes, options.quick));
  report.pack_times = bench::measure_pack_times(options.quick);
  for (const double size : options.sizes)
    report.shots.push_back(bench::measure_shot(size, options.plan, [&](const std::string &text) {
      std::fprintf(stderr, "%.0f particles: %s\n", size, text.c_str());
    }));
  std::cout << bench::tables(report) << std::flush;
  if (!options.json.empty() && !(std::ofstream(options.json) << bench::json(report) << std::flush)) {
    std::fprintf(stderr, "bench_step: error: --json = %s: cannot be written\n", options.json.c_str());
    return 2;
  }
  if (std::all_of(report.shots.begin(), report.shots.end(), bench::equal_hashes)) return 0;
  std::fprintf(stderr, "bench_step: error: the state depends on the number of threads\n");
  return 1;
}

} // namespace

int main(int argc, char **argv) {
  CLI::App app("Times the steps of a shot and compares them with what the machine can do.", "bench_step");
  try {
    return measure(read_options(app, argc, argv));
  } catch (const CLI::ParseError &error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception &error) {
    std::fprintf(stderr, "bench_step: error: %s\n", error.what());
    return 2;
  }
}
