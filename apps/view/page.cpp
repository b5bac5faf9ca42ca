// SPDX-License-Identifier: BSD-3-Clause
#include "page.hpp"

#include "assets.hpp"
#include "draw/frame_facts.hpp"
#include "options/given.hpp"
#include "pack.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace view {

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path &file, const std::string &remedy) {
  if (auto text = options::text_in(file)) return *text;
  throw ogive::SetupError(file.string() + ": must be a file that can be read" + remedy);
}

/// Text between tags.
std::string escaped(const std::string &text) {
  std::string html;
  for (const char c : text) html += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return html;
}

/// JSON as the text of a script: no "</script>" of a title may end it.
std::string in_script(std::string json) {
  for (auto at = json.find('<'); at != std::string::npos; at = json.find('<', at)) json.replace(at, 1, "\\u003c");
  return json;
}

/// Puts `value` into the place of `mark`, which the page has once.
void fill(std::string &page, const std::string &mark, const std::string &value) {
  const auto at = page.find(mark);
  page.replace(at, mark.size(), value);
}

std::vector<std::string> fields_of(const Result &result, const ogive::Frame &frame) {
  const auto known = common_fields(frame);
  const auto has = [&](const std::string &name) { return std::find(known.begin(), known.end(), name) != known.end(); };
  std::vector<std::string> fields;
  for (const auto &name : result.fields) {
    if (!has(name)) options::refuse("--fields", name, "must be one of " + options::joined(known));
    fields.push_back(name);
  }
  if (fields.empty()) std::copy_if(default_fields().begin(), default_fields().end(), std::back_inserter(fields), has);
  if (fields.empty() && !known.empty()) fields.push_back(known.front());
  return fields;
}

} // namespace

draw::History read_velocity(const fs::path &history) {
  const draw::History all = draw::read_history(history);
  draw::History thinned;
  for (const std::size_t k : draw::shown_frames(all.time_us.size(), 400)) {
    thinned.time_us.push_back(all.time_us[k]);
    thinned.velocity_mps.push_back(all.velocity_mps[k]);
  }
  return thinned;
}

const std::vector<std::string> &default_fields() {
  static const std::vector<std::string> names{"plastic_strain", "temperature_K", "von_mises_MPa",
                                              "pressure_MPa",   "damage",        speed_field};
  return names;
}

std::string page(const Result &result, const fs::path &three) {
  const std::string remedy = ", of three.js (Debian: libjs-three); another folder of it by --three-js";
  const std::string library = text_of(three / "three.min.js", remedy);
  const std::string controls = text_of(three / "examples/js/controls/OrbitControls.js", remedy);

  nlohmann::ordered_json model{{"title", result.title}};
  model["velocity"] = {{"time_us", result.velocity.time_us}, {"velocity_mps", result.velocity.velocity_mps}};
  model["frames"] = nlohmann::ordered_json::array();
  std::string data;
  std::vector<std::string> fields;
  for (const std::size_t k : draw::shown_frames(result.series.frames.size(), result.most_frames)) {
    const auto frame = ogive::read_frame(result.series, k, result.symmetry);
    if (model["frames"].empty()) fields = fields_of(result, frame);
    const PackedFrame one = pack(frame, fields);
    data += "<script type=\"text/plain\" id=\"frame" + std::to_string(model["frames"].size()) + "\">" + one.words +
            "</script>\n";
    model["frames"].push_back(nlohmann::ordered_json::parse(one.description));
  }
  model["fields"] = fields;

  std::string page(assets::html);
  // From the end to the start: what has been filled in may hold the text of a mark.
  fill(page, "{{SCRIPT}}", std::string(assets::script));
  fill(page, "{{CONTROLS}}", controls);
  fill(page, "{{THREE}}", library);
  fill(page, "{{FRAMES}}", data);
  fill(page, "{{MODEL}}", in_script(model.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)));
  fill(page, "{{STYLE}}", std::string(assets::css));
  fill(page, "{{TITLE}}", escaped(result.title));
  return page;
}

} // namespace view
