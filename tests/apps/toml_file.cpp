// SPDX-License-Identifier: BSD-3-Clause
#include "options/toml_file.hpp"
#include "apps/parse.hpp"
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "locale.hpp"
#include "materials/material_file.hpp"
#include "shot/experiment.hpp"
#include "study/row.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

namespace {

std::string repeated(const std::string &text, int times) {
  std::string all;
  for (int k = 0; k < times; ++k) all += text;
  return all;
}

std::string refusal_of(const std::string &text) {
  return message_of([&] { options::toml_entries(text, "case.toml", "nose = \"blunt\""); });
}

const std::string too_many_parts = "case.toml:2: a key must have at most 16 parts";
const std::string too_deep = "case.toml:2: brackets must lie at most 16 deep";

} // namespace

TEST_CASE("a key of many parts is refused by its line, wherever it may be") {
  for (const int parts : {17, 40000}) {
    const std::string key = "a" + repeated(".a", parts - 1), quoted = "'a'" + repeated(" . \"a\"", parts - 1);
    CHECK(refusal_of("x = 1\n" + key + " = 1\n") == too_many_parts);
    CHECK(refusal_of("x = 1\n" + quoted + " = 1\n") == too_many_parts);
    CHECK(refusal_of("x = 1\n[" + key + "]\n") == too_many_parts);
    CHECK(refusal_of("x = 1\n[[" + key + "]]\n") == too_many_parts);
    CHECK(refusal_of("x = 1\ny = {" + key + " = 1}\n") == too_many_parts);
    CHECK(refusal_of("x = 1\ny = {z = \"\"\"a\"\"\"\"\", " + key + " = 1}\n") == too_many_parts);
    CHECK(refusal_of("x = 1\ny = [{z = '''a'''', " + key + " = 1}]\n") == too_many_parts);
    CHECK(refusal_of("x = 'it \\'\n" + key + " = 1\n") == too_many_parts);
  }
}

TEST_CASE("brackets within many others are refused by their line") {
  for (const int depth : {17, 40000}) {
    CHECK(refusal_of("x = 1\ny = " + repeated("[", depth) + repeated("]", depth) + "\n") == too_deep);
    CHECK(refusal_of("x = 1\ny = " + repeated("{y = ", depth) + "1" + repeated("}", depth) + "\n") == too_deep);
  }
}

TEST_CASE("points and brackets in texts, comments and numbers are no parts and no depth") {
  const std::string points = repeated(".", 50), brackets = repeated("[{", 50);
  std::string text = "# " + points + brackets + "\n";
  text += "a = \"" + points + brackets + "\\\"" + points + "\"\n";
  text += "b = '" + points + brackets + "'\n";
  text += "c = \"\"\"\n" + points + "\n\"" + brackets + "\n\\\"\"\" " + points + "\"\"\"\n";
  text += "d = '''\n" + points + "'\n" + brackets + "'''\n";
  text += "e = [" + repeated("1.5, ", 50) + "2.5]\n";
  text += "f = 1979-05-27T07:32:00.999 # it's " + points + "\n";
  text += "g = [1.0,\n  2.0, # ]\n  3.0]\n";
  const auto entries = options::toml_entries(text, "case.toml", "");
  REQUIRE(entries.size() == 7);
  CHECK(entries[0].value == points + brackets + "\"" + points);
  CHECK(entries[4].entries.size() == 51);
  CHECK(entries[6].entries.size() == 3);
}

TEST_CASE("text that ends within quotes is refused as damaged") {
  for (const char *text :
       {"a = \"", "a = '", "a = \"\"\"", "a = '''", "a = \"\\", "a = \"b\n.c = 1\n", "'", "\"\"\"\""})
    CHECK(message_of([&] { options::toml_entries(text, "case.toml", ""); }).find("case.toml:") == 0);
}

TEST_CASE("options, metals, tables and summaries read alike whatever the locale of the program") {
  const TemporaryFolder folder;
  std::ofstream(folder.path / "case.toml") << "thickness_mm = 8.25\nvelocity_mps = 1234.5\n";
  std::ofstream(folder.path / "summary.json") << "{\"residual_velocity_mps\": 1234.5}\n";
  const std::string config = (folder.path / "case.toml").string();
  const GermanLocale german;
  const auto o = options_of({"--config", config.c_str(), "--spacing-mm", "1.25"});
  CHECK(o.thickness_mm == 8.25);
  CHECK(o.velocity_mps == 1234.5);
  CHECK(o.spacing_mm == 1.25);
  CHECK(shot::to_toml(o).find("velocity_mps = 1234.5\n") != std::string::npos);
  CHECK(message_of([] { options_of({"--spacing-mm", "1,25"}); }) != "");
  const auto test = experiment::find_residual("Weldox 460 E", "blunt", 6, 300);
  REQUIRE(test);
  CHECK(test->residual_mps > 200);
  CHECK(study::read_summary(folder.path).at("residual_velocity_mps") == 1234.5);
  CHECK(study::read_summary(folder.path).dump() == "{\"residual_velocity_mps\":1234.5}");
}
