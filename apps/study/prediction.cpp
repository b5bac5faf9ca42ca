// SPDX-License-Identifier: BSD-3-Clause
#include "prediction.hpp"

#include "options/toml_file.hpp"
#include "shot/resume.hpp"

#include "ogive/fit/repeated_limit.hpp"
#include "ogive/sim/hash.hpp"
#include "ogive/version.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace study {

namespace {

using Json = nlohmann::ordered_json;

std::string hash_of(std::string_view bytes) {
  return options::printed("%016llx", static_cast<unsigned long long>(ogive::hash_bytes(ogive::hash_start, bytes)));
}

/// Texts of users may have bytes that are not UTF-8.
std::string dumped(const Json &json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string hash_of_record(Json record) {
  record.erase("hash");
  return hash_of(dumped(record));
}

/// All inputs that the limit follows from.
Json inputs(const shot::Options &o, double width_mps) {
  Json all{{"width_mps", width_mps}};
  for (const auto &[key, value] : shot::case_values(o))
    if (key != "velocity_mps" && key != "seed") all[key] = value;
  all["metals"] = shot::all_metals_text(o);
  if (o.own_mesh.read) all["mesh_hash"] = hash_of(o.own_mesh.read->bytes);
  return all;
}

/// A row with the hash of the state that its results have; throws if they are not there.
Json shot_on_record(const Study &study, const Series &series, const Row &row) {
  const Case shot = shot_of(series, number(row.key, velocity_column), study.own_columns);
  const auto folder = folder_of(study, shot);
  if (const std::string reason = conflict(study, shot); !reason.empty()) throw ogive::SetupError(reason);
  if (read_summary(folder).value("state_hash", "") != text_of(row, "state_hash"))
    throw ogive::SetupError(folder.string() + ": holds no results of this shot, which has a row");
  return {{"velocity_mps", row.key.values[velocity_column]},
          {"perforated", text_of(row, "perforated") == "1"},
          {"residual_velocity_mps", text_of(row, "residual_velocity_mps")},
          {"state_hash", text_of(row, "state_hash")}};
}

Json search_of(const Study &study, const Series &series, const std::vector<Row> &rows, double width_mps) {
  const auto limits = limits_in({series}, rows);
  const auto limit = limits.empty() ? std::nullopt : ogive::limit_estimate(limits.front().bracket);
  if (!limit || 2 * limit->half_width > width_mps * (1 + 1e-9))
    throw ogive::SetupError("a limit is not known to " + options::shortest(width_mps) + " m/s");
  Json search{
      {"seed", series.options.seed}, {"limit_mps", limit->limit}, {"half_width_mps", limit->half_width}, {"shots", {}}};
  for (const Row &row : rows)
    if (series_key(row.key) == series.key && !is_undecided(row))
      search["shots"].push_back(shot_on_record(study, series, row));
  return search;
}

/// The first line that two texts do not share.
std::string first_difference(const std::string &now, const std::string &then) {
  std::istringstream a(now), b(then);
  for (std::string one, other;;) {
    const bool more = bool(std::getline(a, one)), others = bool(std::getline(b, other));
    if (!more && !others) return "";
    if (!more) one = "nothing";
    if (!others) other = "nothing";
    if (one != other) return one + " instead of " + other;
  }
}

} // namespace

Prediction predicted(const Study &study, const shot::Options &o, double width_mps, const std::vector<Series> &series) {
  const auto rows = read_all_rows(study.out, study.own_columns);
  Json record{{"ogive", ogive::version}, {"inputs", inputs(o, width_mps)}};
  std::vector<ogive::LimitEstimate<double>> limits;
  for (const Series &one : series) {
    record["searches"].push_back(search_of(study, one, rows, width_mps));
    const Json &found = record["searches"].back();
    limits.push_back({found["limit_mps"], found["half_width_mps"]});
  }
  if (limits.size() > 1) {
    const auto all = ogive::repeated_limit(limits);
    record["mean_mps"] = all.mean, record["standard_deviation_mps"] = *all.deviation;
    record["interval_90_percent_mps"] = {all.mean - *all.half_interval, all.mean + *all.half_interval};
  }
  record["hash"] = hash_of_record(record);
  return {dumped(record, 2) + "\n"};
}

Prediction read_prediction(const std::filesystem::path &file, const std::string &origin) {
  const std::string text = options::text_of_file(file, origin, "JSON");
  // No record is nested deeper.
  const Json record = Json::parse(
      text, [](int depth, Json::parse_event_t, Json &) { return depth < 8; }, false);
  const std::string allowed = "must be a prediction.json of ogive limit";
  try {
    if (const std::string hash = hash_of_record(record); hash != record.at("hash").get<std::string>())
      options::refuse(origin, file.string(),
                      allowed + ", unchanged: its hash is " + hash + ", not " + record["hash"].get<std::string>());
    if (!record.at("inputs").is_object() || record.at("searches").empty())
      options::refuse(origin, file.string(), allowed);
    for (const Json &search : record["searches"])
      if (!search.at("seed").is_number() || !search.at("limit_mps").is_number() ||
          !search.at("half_width_mps").is_number() || !search.at("shots").is_array())
        options::refuse(origin, file.string(), allowed);
  } catch (const nlohmann::json::exception &) {
    options::refuse(origin, file.string(), allowed);
  }
  return {text, file.string()};
}

void require_same_case(const Prediction &prediction, const shot::Options &o, double width_mps,
                       const std::string &origin) {
  const Json record = Json::parse(prediction.text), now = Json::parse(dumped(inputs(o, width_mps)));
  const Json &then = record["inputs"];
  const auto text = [](const Json &any) { return any.is_string() ? any.get<std::string>() : dumped(any); };
  for (const auto &[key, value] : now.items())
    if (const Json other = then.value(key, Json()); value != other)
      options::refuse(origin, prediction.file,
                      "must be of this case: " + key + " is " + first_difference(text(value), text(other)));
}

Comparison compared(const Prediction &now, const Prediction &earlier) {
  const Json a = Json::parse(now.text), b = Json::parse(earlier.text);
  Comparison result;
  int same = 0, shots = 0;
  for (const Json &then : b["searches"]) {
    const auto &all = a["searches"];
    const auto search =
        std::find_if(all.begin(), all.end(), [&](const Json &one) { return one["seed"] == then["seed"]; });
    if (search == all.end()) return {"not confirmed: seed " + dumped(then["seed"]) + " was not searched", false};
    for (const Json &shot : then["shots"])
      ++shots, same += std::count((*search)["shots"].begin(), (*search)["shots"].end(), shot) > 0;
    const double apart = std::abs((*search)["limit_mps"].get<double>() - then["limit_mps"].get<double>());
    const double widths = (*search)["half_width_mps"].get<double>() + then["half_width_mps"].get<double>();
    result.confirmed = result.confirmed && apart <= widths * (1 + 1e-9);
  }
  result.text = std::string(result.confirmed ? "confirmed" : "not confirmed") +
                options::printed(", %d of %d shots bit-identical", same, shots);
  return result;
}

} // namespace study
