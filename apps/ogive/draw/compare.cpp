// SPDX-License-Identifier: BSD-3-Clause
#include "compare.hpp"

#include "../results.hpp"
#include "draw/plot.hpp"
#include "draw/section.hpp"
#include "options/out_folder.hpp"
#include "options/text.hpp"
#include "study/row.hpp"

#include "ogive/io/atomic_file.hpp"
#include "ogive/io/read_frame.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace commands::drawing {

namespace {

/// Keys and their values as text, in the order of the files.
using Facts = std::vector<std::pair<std::string, std::string>>;

const std::string *find(const Facts &facts, const std::string &key) {
  const auto found = std::find_if(facts.begin(), facts.end(), [&](const auto &fact) { return fact.first == key; });
  return found == facts.end() ? nullptr : &found->second;
}

/// Whether a key is about how a run was made, neither about its case nor about its result.
bool is_of_the_machine(const std::string &key) {
  constexpr std::array keys{"out",
                            "quiet",
                            "threads",
                            "picture",
                            "vtk",
                            "wall_s",
                            "cpu_s",
                            "ns_per_particle_step",
                            "version",
                            "output_every_us",
                            "checkpoint_every_us",
                            "peak_memory_mb"};
  return key.starts_with("phase_s") || std::find(keys.begin(), keys.end(), key) != keys.end();
}

Facts facts_of(const fs::path &folder) {
  Facts facts;
  const auto summary = study::read_summary(folder).flatten();
  const auto case_file = folder / "case.toml";
  std::error_code none;
  if (fs::exists(case_file, none))
    for (const auto &given :
         options::toml_entries(options::text_of_file(case_file, "case"), case_file.string(), "x = 1"))
      if (!summary.contains("/" + given.key) && given.key != "velocity_mps") facts.emplace_back(given.key, given.value);
  for (const auto &[path, value] : summary.items()) {
    std::string key = path.substr(1);
    std::replace(key.begin(), key.end(), '/', '.');
    facts.emplace_back(key, value.is_string()         ? value.get<std::string>()
                            : value.is_number_float() ? options::shortest(value.get<double>())
                            : value.is_null()         ? ""
                                                      : value.dump());
  }
  std::erase_if(facts, [](const auto &fact) { return is_of_the_machine(fact.first); });
  return facts;
}

/// The values of a key as numbers, if both are.
std::optional<std::array<double, 2>> numbers(const std::string &key, const std::string &first,
                                             const std::string &second) {
  const auto a = ogive::number_from(first), b = ogive::number_from(second);
  // A hash may consist of decimal digits by chance.
  return key != "state_hash" && a && b ? std::optional(std::array{*a, *b}) : std::nullopt;
}

/// Whether values differ by more than the rounding of sums.
bool differ(const std::string &key, const std::string &first, const std::string &second) {
  const auto both = numbers(key, first, second);
  if (!both) return first != second;
  const auto [a, b] = *both;
  return std::abs(a - b) > 1e-9 * std::max(std::abs(a), std::abs(b));
}

Difference difference_of(const std::string &key, const std::string &first, const std::string &second) {
  Difference difference{key, first, second, {}, {}};
  const auto both = numbers(key, first, second);
  if (!both) return difference;
  const auto [a, b] = *both;
  difference.change = b - a;
  if (a != 0) difference.percent = 100 * (b - a) / std::abs(a);
  return difference;
}

/// Numbers with six digits, other texts in full.
std::string shown(const std::string &value) {
  const auto number = ogive::number_from(value);
  return value.empty() ? "-" : number ? options::printed("%.6g", *number) : ogive::printable(value);
}

void print(const std::vector<Difference> &all, const std::string &first, const std::string &second) {
  std::vector<std::array<std::string, 5>> lines{{"", first, second, "change", "%"}};
  for (const auto &d : all)
    lines.push_back({d.key, shown(d.first), shown(d.second), d.change ? options::printed("%+.4g", *d.change) : "",
                     d.percent ? options::printed("%+.2f", *d.percent) : ""});
  std::array<std::size_t, 5> widths{};
  for (const auto &line : lines)
    for (std::size_t k = 0; k < 5; ++k) widths[k] = std::max(widths[k], line[k].size());
  for (const auto &line : lines) {
    std::string text = "  " + line[0] + std::string(widths[0] - line[0].size(), ' ');
    for (std::size_t k = 1; k < 5; ++k) text += "  " + std::string(widths[k] - line[k].size(), ' ') + line[k];
    std::printf("%s\n", text.substr(0, text.find_last_not_of(' ') + 1).c_str());
  }
}

void write(const fs::path &file, const std::vector<Difference> &all) {
  std::string text = "key,first,second,change,percent\n";
  for (const auto &d : all)
    text += study::csv_line({d.key, d.first, d.second, d.change ? options::shortest(*d.change) : "",
                             d.percent ? options::shortest(*d.percent) : ""});
  ogive::write_atomically(file, text);
}

void draw_last_frames(const Options &o, const std::vector<std::string> &names) {
  std::vector<draw::PanelCell> cells;
  draw::SeenBox box;
  for (std::size_t k = 0; k < o.compare.size(); ++k) {
    const auto series = ogive::read_series(find_pvd(o.compare[k], "--compare"));
    auto frame = ogive::read_frame(series, series.frames.size() - 1, symmetry_of(o.extent));
    box = draw::extended(box, frame);
    const std::string label = names[k] + ": " + draw::time_text(frame.time, motion_of(series.pvd.parent_path()));
    cells.push_back({std::move(frame), label});
  }
  draw::SectionPanel panel{.title = o.title, .low_mm = box.low_mm, .high_mm = box.high_mm, .radius_mm = box.radius_mm};
  draw::render_panel(cells, o.out / "sections.png", panel);
}

} // namespace

std::vector<Difference> differences(const fs::path &first, const fs::path &second) {
  const Facts a = facts_of(first), b = facts_of(second);
  std::vector<Difference> all;
  for (const auto &[key, value] : a) {
    const std::string *other = find(b, key);
    if (other == nullptr || differ(key, value, *other)) all.push_back(difference_of(key, value, other ? *other : ""));
  }
  for (const auto &[key, value] : b)
    if (find(a, key) == nullptr && !value.empty()) all.push_back(difference_of(key, "", value));
  return all;
}

void compare(const Options &o) {
  const auto all = differences(o.compare[0], o.compare[1]);
  std::vector<std::string> names;
  for (const auto &folder : o.compare)
    names.push_back(o.label.empty() ? folder_name(folder / "summary.json") : o.label[names.size()]);
  options::prepare_out(o.out, 1e6);
  print(all, names[0], names[1]);
  write(o.out / "differences.csv", all);
  const auto attempt = [](auto &&draw_one) {
    try {
      draw_one();
    } catch (const std::exception &error) {
      std::fprintf(stderr, "ogive draw: left out: %s\n", error.what());
    }
  };
  attempt([&] {
    draw::VelocityPlot plot{o.title, {}};
    for (std::size_t k = 0; k < names.size(); ++k) plot.curves.push_back({o.compare[k] / "history.csv", names[k]});
    draw::write_velocity_plot(plot, o.out / "velocity.svg");
  });
  attempt([&] { draw_last_frames(o, names); });
}

} // namespace commands::drawing
