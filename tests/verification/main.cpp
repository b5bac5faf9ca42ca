// SPDX-License-Identifier: BSD-3-Clause
/// \file
/// verification: computes the ladder of docs/verification.md, rung by rung, and prints its tables.

#include "compiler.hpp"
#include "record.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>

namespace {

using verification::Rung;

struct Options {
  std::vector<std::string> only;
  std::string reference = OGIVE_FINAL_ENERGIES;
  bool quick = false, accept = false;
};

struct NamedRung {
  std::string name;
  bool quick; ///< a matter of seconds
  std::function<Rung(const Options &)> compute;
};

std::vector<NamedRung> ladder() {
  using namespace verification;
  const auto plain = [](Rung (*rung)()) { return [=](const Options &) { return rung(); }; };
  return {{"kernel_sums", true, plain(kernel_sums)},
          {"gradients", true, plain(gradients)},
          {"one_point", true, plain(one_point)},
          {"waves", true, plain(waves)},
          {"beams", true, plain(beams)},
          {"patches", true, plain(patches)},
          {"sliding", true, plain(sliding)},
          {"balances", true, plain(balances)},
          {"taylor_bars", false, plain(taylor_bars)},
          {"final_energies", true, [](const Options &o) { return final_energies(o.reference, o.accept); }}};
}

Options read_options(CLI::App &app, int argc, const char *const *argv) {
  Options options;
  std::vector<std::string> names;
  for (const auto &rung : ladder()) names.push_back(rung.name);
  app.add_option("--only", options.only, "rungs to compute")->delimiter(',')->check(CLI::IsMember(names));
  app.add_flag("--quick", options.quick, "leave out the rungs that take long");
  app.add_option("--reference", options.reference, "file with the final energies to compare with");
  app.add_flag("--accept", options.accept, "write that file anew");
  app.parse(argc, argv);
  return options;
}

bool is_wanted(const NamedRung &rung, const Options &options) {
  if (!options.only.empty()) return std::count(options.only.begin(), options.only.end(), rung.name) > 0;
  return rung.quick || !options.quick;
}

int verify(const Options &options) {
  std::size_t lines = 0, off = 0;
  for (const auto &rung : ladder()) {
    if (!is_wanted(rung, options)) continue;
    const auto begin = std::chrono::steady_clock::now();
    const Rung found = rung.compute(options);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::cout << markdown(found) << '\n' << std::flush;
    const auto wrong = static_cast<std::size_t>(
        std::count_if(found.lines.begin(), found.lines.end(), [](const auto &line) { return !line.ok; }));
    std::fprintf(stderr, "%s: %zu lines, %zu off, %.1f s\n", rung.name.c_str(), found.lines.size(), wrong, seconds);
    lines += found.lines.size(), off += wrong;
  }
  std::fprintf(stderr, "%zu lines, %zu off\n", lines, off);
  if (options.only.empty() && !options.quick) {
    const std::string mark = "<!-- table: summary (tests/verification.sh) -->\n";
    std::cout << mark << "Made by `tests/verification.sh` with " << verification::made_with() << ": " << lines
              << " lines, " << off << " off.\n"
              << mark << std::flush;
  }
  return off == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
  CLI::App app("Computes what theory or others know, and says how far off it is.", "verification");
  try {
    return verify(read_options(app, argc, argv));
  } catch (const CLI::ParseError &error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception &error) {
    std::fprintf(stderr, "verification: error: %s\n", error.what());
    return 2;
  }
}
