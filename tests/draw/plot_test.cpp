// SPDX-License-Identifier: BSD-3-Clause
#include "draw/plot.hpp"

#include "io/temporary_folder.hpp"
#include "locale.hpp"
#include "ogive/io/csv.hpp"

#include "catch.hpp"

#include <cstdlib>

using namespace draw;

namespace {

std::filesystem::path sample_history(const std::filesystem::path &folder, const std::string &name = "history.csv") {
  auto csv = ogive::continue_csv(folder / name, {"step", "time_us", "velocity_m_per_s"});
  for (int k = 0; k <= 20; ++k) ogive::add_row(csv, {100.0 * k, 5.0 * k, 303.5 - (k < 12 ? 14.0 * k : 160.0)});
  return csv.path;
}

bool has(const std::string &text, const std::string &part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("the velocity of a history becomes an SVG with names and units") {
  if (!gnuplot_available()) {
    WARN("skipped: there is no gnuplot");
    return;
  }
  const TemporaryFolder folder;
  const auto history = sample_history(folder.path);
  VelocityPlot plot{"", {{history}}};
  plot.title = "Weldox_460 E, 12 mm";
  plot.measured_residual_m_per_s = 199.7;
  write_velocity_plot(plot, folder.path / "velocity.svg");
  const std::string svg = read_text(folder.path / "velocity.svg");
  CHECK(has(svg, "</svg>"));
  for (const char *text : {"time / µs", "projectile velocity / (m/s)", "Weldox_460 E, 12 mm", "computed",
                           "measured residual velocity: 199.7 m/s"})
    CHECK(has(svg, text));
  CHECK(count_files(folder.path) == 2);
  write_velocity_plot({"", {{history}}}, folder.path / "velocity.svg");
  CHECK_FALSE(has(read_text(folder.path / "velocity.svg"), "measured"));
}

TEST_CASE("the velocities of several histories become one plot") {
  if (!gnuplot_available()) {
    WARN("skipped: there is no gnuplot");
    return;
  }
  const TemporaryFolder folder;
  const auto first = sample_history(folder.path, "a.csv"), second = sample_history(folder.path, "b.csv");
  write_velocity_plot({"two shots", {{first, "12 mm"}, {second, "16 mm"}}}, folder.path / "both.svg");
  const std::string svg = read_text(folder.path / "both.svg");
  for (const char *text : {"two shots", "12 mm", "16 mm"}) CHECK(has(svg, text));
  CHECK_FALSE(has(svg, "computed"));
}

TEST_CASE("plots have a decimal point whatever the locale of the program") {
  if (!gnuplot_available()) {
    WARN("skipped: there is no gnuplot");
    return;
  }
  const TemporaryFolder folder;
  const GermanLocale german;
  VelocityPlot plot{"", {{sample_history(folder.path)}}};
  plot.measured_residual_m_per_s = 199.75;
  write_velocity_plot(plot, folder.path / "velocity.svg");
  CHECK(has(read_text(folder.path / "velocity.svg"), "measured residual velocity: 199.75 m/s"));
}

TEST_CASE("a plot does not read the settings of the user") {
  if (!gnuplot_available()) {
    WARN("skipped: there is no gnuplot");
    return;
  }
  const TemporaryFolder folder;
  const char *const home = std::getenv("HOME");
  const std::string before = home == nullptr ? "" : home;
  write_velocity_plot({"", {{sample_history(folder.path)}}}, folder.path / "plain.svg");
  std::ofstream(folder.path / ".gnuplot") << "set title 'of the user'\nset label 'of the user' at graph 0.5, 0.5\n";
  ::setenv("HOME", folder.path.c_str(), 1);
  write_velocity_plot({"", {{sample_history(folder.path)}}}, folder.path / "velocity.svg");
  std::ofstream(folder.path / ".gnuplot") << "exit status 3\n";
  const bool drawn = gnuplot_available();
  write_velocity_plot({"", {{sample_history(folder.path)}}}, folder.path / "again.svg");
  home == nullptr ? ::unsetenv("HOME") : ::setenv("HOME", before.c_str(), 1);
  CHECK(drawn);
  CHECK(read_text(folder.path / "velocity.svg") == read_text(folder.path / "plain.svg"));
  CHECK(read_text(folder.path / "again.svg") == read_text(folder.path / "plain.svg"));
}

TEST_CASE("names and titles are data to gnuplot, never commands") {
  if (!gnuplot_available()) {
    WARN("skipped: there is no gnuplot");
    return;
  }
  const TemporaryFolder folder;
  const auto history = sample_history(folder.path, "it's; `touch x` \"$HOME\".csv");
  VelocityPlot plot{"", {{history}}};
  plot.title = "'; system('touch " + (folder.path / "broken_in").string() + "'); '`id` <b>";
  write_velocity_plot(plot, folder.path / "o'clock & \\n.svg");
  CHECK(has(read_text(folder.path / "o'clock & \\n.svg"), "</svg>"));
  CHECK_FALSE(std::filesystem::exists(folder.path / "broken_in"));
  const auto here = std::filesystem::current_path();
  std::filesystem::current_path(folder.path);
  const auto piped = sample_history("", "< touch broken_in");
  CHECK_NOTHROW(write_velocity_plot({"", {{piped}}}, "| touch broken_in"));
  std::filesystem::current_path(here);
  CHECK(std::filesystem::exists(folder.path / "| touch broken_in"));
  CHECK_FALSE(std::filesystem::exists(folder.path / "broken_in"));
  plot.title = "two\nlines";
  CHECK_THROWS_AS(write_velocity_plot(plot, folder.path / "a.svg"), ogive::SetupError);
}

TEST_CASE("digits that follow other characters stay digits in names and titles") {
  CHECK(gnuplot_quoted("6+6 (20)") == "\"6\\053\\066 \\050\\062\\060\\051\"");
  if (!gnuplot_available()) {
    WARN("skipped: there is no gnuplot");
    return;
  }
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path / "6+6mm");
  const auto history = sample_history(folder.path / "6+6mm");
  VelocityPlot plot{"", {{history}}};
  plot.title = "6+6 mm (20 mm apart)";
  write_velocity_plot(plot, folder.path / "6+6mm" / "velocity.svg");
  CHECK(has(read_text(folder.path / "6+6mm" / "velocity.svg"), plot.title));
}

TEST_CASE("a history without the columns, or none, is refused") {
  const TemporaryFolder folder;
  const auto history = sample_history(folder.path);
  CHECK(csv_column(history, "step") == 1);
  CHECK(csv_column(history, "velocity_m_per_s") == 3);
  CHECK_THROWS_WITH(csv_column(history, "time"),
                    history.string() + " column = time: must be one of step,time_us,velocity_m_per_s");
  CHECK_THROWS_AS(write_velocity_plot({"", {{folder.path / "none.csv"}}}, folder.path / "a.svg"), ogive::SetupError);
}

TEST_CASE("a plot that gnuplot cannot draw leaves the old one") {
  const TemporaryFolder folder;
  const auto history = sample_history(folder.path);
  const auto empty = folder.path / "empty.csv";
  { const auto csv = ogive::continue_csv(empty, {"time_us", "velocity_m_per_s"}); }
  ogive::write_atomically(folder.path / "old.svg", "old");
  CHECK_THROWS_AS(write_velocity_plot({"", {{empty}}}, folder.path / "old.svg"), ogive::WriteError);
  CHECK(read_text(folder.path / "old.svg") == "old");
  CHECK_THROWS_AS(write_velocity_plot({"", {{history}}}, folder.path / "gone" / "a.svg"), ogive::WriteError);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder.path.c_str(), 1);
  CHECK_FALSE(gnuplot_available());
  CHECK_THROWS_WITH(write_velocity_plot({"", {{history}}}, folder.path / "old.svg"),
                    Catch::Contains("gnuplot is not installed"));
  ::setenv("PATH", path.c_str(), 1);
  CHECK(count_files(folder.path) == 3);
}
