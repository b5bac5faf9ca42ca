// SPDX-License-Identifier: BSD-3-Clause
#include "apps/parse.hpp"
#include "catch.hpp"

#include "ogive/version.hpp"
#include "options/text.hpp"

#include <set>

namespace {

/// The flags that a help lists, in its order.
std::vector<std::string> flags_in(const std::string &help) {
  std::vector<std::string> flags;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  --")) flags.push_back(line.substr(2, line.find_first_of(" \n", 2) - 2));
  return flags;
}

bool fits_a_terminal(const std::string &text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.size() > 100) return false;
  return true;
}

} // namespace

TEST_CASE("asked for its version, the program prints it and ends") {
  std::ostringstream version;
  CHECK_FALSE(parse({"--version"}, version));
  CHECK(version.str() == std::string("ogive shoot ") + ogive::version + "\n");
}

TEST_CASE("the short help has one line for each of the options that most users need") {
  std::ostringstream text, same;
  CHECK_FALSE(parse({"--quiet", "--help"}, text));
  CHECK_FALSE(parse({"-h"}, same));
  CHECK(text.str() == same.str());
  std::vector<std::string> expected;
  for (const options::Option &option : commands::shoot_table().options)
    if (*option.brief != 0) expected.push_back(options::flag_of(option.key));
  CHECK(expected.size() >= 10);
  CHECK(expected.size() <= 16);
  expected.emplace_back("--help-all");
  CHECK(flags_in(text.str()) == expected);
  CHECK_THAT(text.str(), Catch::Matchers::StartsWith("ogive shoot [options]\n"));
  CHECK(fits_a_terminal(text.str()));

  // Every flag has its text on the same line, and nothing is continued on the next.
  std::istringstream lines(text.str());
  for (std::string line; std::getline(lines, line) && line != "Examples:";) {
    if (line.starts_with("  --")) CHECK(line.find_first_not_of(' ', line.find("  ", 4)) < line.size());
    CHECK_FALSE(line.starts_with("   "));
  }
}

TEST_CASE("the long help has every option, with its source, and fits a terminal") {
  std::ostringstream text;
  CHECK_FALSE(parse({"--help-all", "--quiet"}, text));
  std::vector<std::string> expected;
  for (const options::Option &option : commands::shoot_table().options) {
    expected.push_back(options::flag_of(option.key));
    CHECK(*option.meaning != 0);
    CHECK(*option.source != 0);
  }
  CHECK(expected.size() >= 50);
  expected.insert(expected.end(), {"--config", "--version", "--help", "--help-all"});
  auto found = flags_in(text.str());
  CHECK(std::set(found.begin(), found.end()) == std::set(expected.begin(), expected.end()));
  CHECK(found.size() == expected.size());
  CHECK(fits_a_terminal(text.str()));
  CHECK(text.str().find("\nGeneral:\n") == text.str().rfind("\nGeneral:\n"));
  for (const char *part :
       {"; 0.05 to 500 mm", "conical, ogival,", "--no-vtk", "paper, Fig. 11", "Exit status: 0 done", "\nProjectile:\n"})
    CHECK_THAT(text.str(), Catch::Matchers::Contains(part));
}

TEST_CASE("an option that stands twice in the table would hide one") {
  for (const auto table : {commands::shoot_table, commands::limit_table, commands::sweep_table, commands::mesh_table,
                           commands::draw_table, commands::calibrate_table, commands::materials_table}) {
    std::set<std::string> keys;
    for (const options::Option &option : table().options) CHECK(keys.insert(option.key).second);
  }
}

TEST_CASE("the nearest name is found for letters that are swapped, missing, superfluous or wrong, and for units") {
  const std::vector<std::string> known{"--thickness-mm", "--nose", "--nose-length-mm", "--velocity-mps", "--vtk"};
  const auto nearest = [&](const char *name) { return options::nearest(name, known); };
  CHECK(nearest("--thickness-mm") == "--thickness-mm");
  CHECK(nearest("--thikcness-mm") == "--thickness-mm");
  CHECK(nearest("--thicknes-mm") == "--thickness-mm");
  CHECK(nearest("--thicknesss-mm") == "--thickness-mm");
  CHECK(nearest("--thickmess-mm") == "--thickness-mm");
  CHECK(nearest("--thickness") == "--thickness-mm");
  CHECK(nearest("--velocity") == "--velocity-mps");
  CHECK(nearest("--velocity-ms") == "--velocity-mps");
  CHECK(nearest("--nsoe") == "--nose");
  CHECK(nearest("--nose-length") == "--nose-length-mm");
  CHECK(nearest("--vkt") == "--vtk");
  CHECK(nearest("--bullets").empty());
  CHECK(nearest("").empty());
  CHECK(nearest("--").empty());
  CHECK(options::nearest("--nose", {}).empty());
  CHECK(nearest(std::string(5000, 'n').c_str()).empty());
  CHECK(options::nearest_text("--nsoe", known) == ", the nearest is --nose");
  CHECK(options::nearest_text("--bullets", known).empty());
}
