// SPDX-License-Identifier: BSD-3-Clause
#include "study/cases.hpp"
#include "sample.hpp"

#include "catch.hpp"
#include "io/temporary_folder.hpp"

#include <set>

using namespace study;

namespace {

const std::vector<shot::Level> common{level_of({{"spacing_mm", "2"}, {"vtk", "false"}})};

/// The cases of a list's text and of --vary.
CaseList cases_in(const std::string &csv, const std::vector<std::string> &varied = {}) {
  const TemporaryFolder folder;
  write(folder.path / "cases.csv", csv);
  return cases_of(common, (folder.path / "cases.csv").string(), varied);
}

/// The error of a list, from the file's name on.
std::string error_in(const std::string &csv, const std::vector<std::string> &varied = {}) {
  const std::string message = message_of([&] { cases_in(csv, varied); });
  CHECK(lines_in(message) == 0);
  return message.substr(std::min(message.find("cases.csv"), message.size()));
}

std::string error_of(const std::vector<std::string> &varied) {
  return message_of([&] { cases_of(common, {}, varied); });
}

std::vector<std::string> names_in(const CaseList &list) {
  std::vector<std::string> names;
  for (const Case &one : list.cases) names.push_back(one.name);
  return names;
}

} // namespace

TEST_CASE("Varied options multiply, the last one fastest") {
  const auto list = cases_of(common, {}, {"thickness-mm=6,8", "velocity_mps=200:400:75,500"});
  REQUIRE(list.cases.size() == 8);
  CHECK(list.own_columns.empty());
  std::vector<std::pair<double, double>> pairs;
  for (const Case &one : list.cases) pairs.emplace_back(one.options.thickness_mm, one.options.velocity_mps);
  CHECK(pairs == std::vector<std::pair<double, double>>{
                     {6, 200}, {6, 275}, {6, 350}, {6, 500}, {8, 200}, {8, 275}, {8, 350}, {8, 500}});
  for (const Case &one : list.cases) CHECK(one.options.spacing_mm == 2);
  CHECK(list.cases[1].name == "stabilised_mjc_weldox_460e_blunt_6mm_275mps_2mm");

  // The defaults of a case are those of its own nose, as for a single shot.
  const auto noses = cases_of(common, {}, {"nose=blunt,conical", "friction=0.1:0.3:0.1"});
  REQUIRE(noses.cases.size() == 6);
  CHECK(noses.own_columns == std::vector<std::string>{"friction"});
  CHECK(noses.cases[5].options.length_mm == options_with({{"nose", "conical"}}).length_mm);
  CHECK(noses.cases[5].options.friction == 0.3);
  CHECK(noses.cases[5].name == "stabilised_mjc_weldox_460e_conical_12mm_303.5mps_2mm_friction=0.3");
}

TEST_CASE("A range holds its ends, and what is no range is a value") {
  const auto velocities = [](const std::string &text) {
    std::vector<double> all;
    for (const Case &one : cases_of(common, {}, {"velocity_mps=" + text}).cases)
      all.push_back(one.options.velocity_mps);
    return all;
  };
  CHECK(velocities("200:200:1") == std::vector<double>{200});
  CHECK(velocities("200:201:0.1").size() == 11);
  CHECK(velocities("200:201:0.1").back() == 201);
  CHECK(velocities("200:249:25") == std::vector<double>{200, 225});
  for (const char *text : {"400:200:25", "200:400:0", "200:400:-5", "200:400", "200:400:25:1", "200:inf:1", "a:b:c"})
    CHECK(error_of({std::string("velocity_mps=") + text}).starts_with("--vary velocity_mps = " + std::string(text)));
}

TEST_CASE("Variations that are none are errors in one line") {
  const std::string form = "must be NAME=VALUE,VALUE,... or NAME=FIRST:LAST:STEP";
  for (const std::string text : {"thickness_mm", "=3", "thickness_mm=", ""})
    CHECK(error_of({text}) == "--vary = " + text + ": " + form);
  CHECK(error_of({"thicknes_mm=6"}) == "--vary: thicknes_mm: is not an option of a case, the nearest is thickness_mm; "
                                       "ogive shoot --help-all lists them");
  for (const char *of_the_run : {"out=a,b", "threads=1,2", "quiet=true"})
    CHECK(error_of({of_the_run}).find("is not an option of a case") != std::string::npos);
  CHECK(error_of({"thickness_mm=6,wide"}).starts_with("--vary thickness_mm = wide: must be a number"));
  CHECK(error_of({"nose=flat"}).starts_with("--vary nose = flat: must be one of "));
  CHECK(error_of({"velocity_mps=1:400:0.01", "thickness_mm=1:40:0.1"}).find("more than 100000 cases") !=
        std::string::npos);
}

TEST_CASE("The columns of a list are options of a shot") {
  const auto list = cases_in("name,text,thickness_mm,velocity_mps,friction\n"
                             "# a comment, and a blank line\n\n"
                             "thin,\"a note, with a comma\",6,150,0.1\n"
                             ",,8,,\n");
  REQUIRE(list.cases.size() == 2);
  CHECK(list.own_columns == std::vector<std::string>{"friction"});
  CHECK(names_in(list) ==
        std::vector<std::string>{"thin", "stabilised_mjc_weldox_460e_blunt_8mm_303.5mps_2mm_friction=0"});
  CHECK(list.cases[0].options.thickness_mm == 6);
  CHECK(list.cases[0].options.friction == 0.1);
  CHECK(list.cases[0].key.values ==
        std::vector<std::string>{"stabilised", "mjc", "weldox_460e", "blunt", "6", "150", "2", "0.1"});
  // An empty field leaves the option to the rest.
  CHECK(list.cases[1].options.velocity_mps == 303.5);

  // A variation comes after the row and takes part in the name.
  const auto varied = cases_in("name,thickness_mm\na,6\nb,8\n", {"velocity_mps=200,300"});
  CHECK(names_in(varied) == std::vector<std::string>{"a_velocity_mps=200", "a_velocity_mps=300", "b_velocity_mps=200",
                                                     "b_velocity_mps=300"});
}

TEST_CASE("A material file of a list counts from the folder of the list") {
  const TemporaryFolder folder;
  const auto list_of = [&](const std::string &text) {
    write(folder.path / "cases.csv", text);
    return cases_of(common, (folder.path / "cases.csv").string(), {});
  };
  CHECK(message_of([&] { list_of("material\nmine.toml\n"); }).find("mine.toml") != std::string::npos);
}

TEST_CASE("A case that is listed twice is one case, a name that is given twice an error") {
  CHECK(cases_in("thickness_mm,velocity_mps\n6,200\n8,200\n6,200\n").cases.size() == 2);
  CHECK(cases_in("name,thickness_mm\na,6\nb,6\n").cases.size() == 1);
  CHECK(error_in("name,thickness_mm\na,6\na,8\n") == "cases.csv:3: name = a: is also the name of another case");
}

TEST_CASE("A list that cannot be read is an error with file, line and column") {
  CHECK(error_in("thicknes_mm\n6\n") ==
        "cases.csv:1: thicknes_mm: is not an option of a case, the nearest is thickness_mm; "
        "ogive shoot --help-all lists them");
  CHECK(error_in("out\nelsewhere\n").starts_with("cases.csv:1: out: is not an option of a case"));
  CHECK(error_in("nose,nose\nblunt,blunt\n") == "cases.csv:1: every column must have a name of its own");
  CHECK(error_in("thickness_mm,nose\n6,blunt\n8\n") == "cases.csv:3: fields in the row = 1: must be 2");
  CHECK(error_in("thickness_mm\n6\nwide\n").starts_with("cases.csv:3: thickness_mm = wide: must be a number"));
  CHECK(error_in("thickness_mm,nose\n6,blunt\n8,flat\n").starts_with("cases.csv:3: nose = flat: must be one of "));
  CHECK(error_in("name,nose\na/b,blunt\n") == "cases.csv:2: name = a/b: must be the name of a folder");
  CHECK(error_in("name,nose\n..,blunt\n") == "cases.csv:2: name = ..: must be the name of a folder");
  CHECK(error_in("") == "cases.csv: has no cases");
  CHECK(error_in("thickness_mm\n") == "cases.csv: has no cases");
  CHECK(message_of([] { cases_of(common, "nowhere.csv", {}); }) ==
        "nowhere.csv: must be a CSV file of cases that can be read");
}

TEST_CASE("Shards part a list") {
  std::vector<int> all(17);
  for (int k = 0; k < 17; ++k) all[static_cast<std::size_t>(k)] = k;
  for (const int shards : {1, 2, 3, 17, 40}) {
    std::multiset<int> seen;
    for (int shard = 1; shard <= shards; ++shard)
      for (const int k :
           share_of(all, study_of({.jobs = 1, .shard = std::to_string(shard) + "/" + std::to_string(shards)}, "")))
        seen.insert(k);
    CHECK(std::vector<int>(seen.begin(), seen.end()) == all);
  }
  for (const char *text : {"x", "1", "1/", "/2", "0/3", "3/2", "1/3/3", "1.5/3", "-1/3", "1/99999", "1/nan"})
    CHECK(message_of([&] { study_of({.jobs = 1, .shard = text}, ""); }) ==
          "--shard = " + std::string(text) + ": must be I/N with whole numbers 1 <= I <= N");
  CHECK(study_of({}, "").jobs == cores());
}
