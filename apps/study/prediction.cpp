// SPDX-License-Identifier: BSD-3-Clause
#include "prediction.hpp"

#include "options/toml_file.hpp"
#include "shot/plates.hpp"

#include "ogive/fit/repeated_limit.hpp"
#include "ogive/sim/hash.hpp"
#include "ogive/version.hpp"

#include <nlohmann/json.hpp>

#include <sstream>

namespace study {

namespace {

using Json = nlohmann::ordered_json;

std::string hash_of(Json record) {
  record.erase("hash");
  return options::printed("%016llx",
                          static_cast<unsigned long long>(ogive::hash_bytes(ogive::hash_start, record.dump())));
}

/// The case without what changes no result.
Json inputs(const shot::Options &options, double width_mps) {
  shot::Options o = options;
  const shot::Options usual;
  o.out = "OUT", o.threads.reset(), o.vtk = usual.vtk, o.picture = usual.picture, o.quiet = usual.quiet;
  o.output_every_us = usual.output_every_us, o.checkpoint_every_us = usual.checkpoint_every_us;
  return {{"case", to_complete_toml(o)}, {"metals", metals_text(o, plates_of(o))}, {"width_mps", width_mps}};
}

Json search_of(const Series &series, const std::vector<Row> &rows) {
  Json shots = Json::array();
  for (const Row &row : rows) {
    if (series_key(row.key) != series.key || is_undecided(row)) continue;
    shots.push_back({{"velocity_mps", row.key.values[velocity_column]},
                     {"perforated", text_of(row, "perforated") == "1"},
                     {"residual_velocity_mps", text_of(row, "residual_velocity_mps")},
                     {"state_hash", text_of(row, "state_hash")}});
  }
  Json search{{"seed", series.options.seed}};
  const auto limits = limits_in({series}, rows);
  if (const auto limit = limits.empty() ? std::nullopt : ogive::limit_estimate(limits.front().bracket))
    search["limit_mps"] = limit->limit, search["half_width_mps"] = limit->half_width;
  search["shots"] = shots;
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

Prediction predicted(const shot::Options &o, double width_mps, const std::vector<Series> &series,
                     const std::vector<Row> &rows) {
  Json record{{"ogive", ogive::version}};
  record.update(inputs(o, width_mps));
  std::vector<ogive::LimitEstimate<double>> limits;
  for (const Series &one : series) {
    record["searches"].push_back(search_of(one, rows));
    const Json &found = record["searches"].back();
    if (found.contains("limit_mps")) limits.push_back({found["limit_mps"], found["half_width_mps"]});
  }
  if (limits.size() > 1) {
    const auto all = ogive::repeated_limit(limits);
    record["mean_mps"] = all.mean, record["standard_deviation_mps"] = *all.deviation;
    record["interval_90_percent_mps"] = {all.mean - *all.half_interval, all.mean + *all.half_interval};
  }
  record["hash"] = hash_of(record);
  return {record.dump(2) + "\n", {}};
}

Prediction read_prediction(const std::filesystem::path &file, const std::string &origin) {
  const std::string text = options::text_of_file(file, origin, "JSON");
  const Json record = Json::parse(text, nullptr, false);
  if (!record.is_object() || !record.contains("hash") || !record["hash"].is_string())
    options::refuse(origin, file.string(), "must be a prediction.json of ogive limit");
  if (const std::string hash = hash_of(record); hash != record["hash"])
    options::refuse(origin, file.string(),
                    "was changed after it was written: its hash is " + hash + ", not " +
                        record["hash"].get<std::string>());
  return {text, file.string()};
}

void require_same_case(const Prediction &prediction, const shot::Options &o, double width_mps,
                       const std::string &origin) {
  const Json then = Json::parse(prediction.text), now = inputs(o, width_mps);
  for (const auto &[key, value] : now.items()) {
    if (value == then.value(key, Json())) continue;
    const auto text = [](const Json &any) { return any.is_string() ? any.get<std::string>() : any.dump(); };
    options::refuse(origin, prediction.file,
                    "is of another case: " + first_difference(text(value), text(then.value(key, Json()))));
  }
}

Comparison compared(const Prediction &now, const Prediction &earlier) {
  const Json a = Json::parse(now.text), b = Json::parse(earlier.text);
  Comparison result;
  int same = 0, shots = 0;
  for (const Json &then : b["searches"])
    for (const Json &search : a["searches"]) {
      if (search["seed"] != then["seed"]) continue;
      for (const Json &shot : then["shots"])
        ++shots, same += std::count(search["shots"].begin(), search["shots"].end(), shot) > 0;
      if (!search.contains("limit_mps") || !then.contains("limit_mps")) {
        result.confirmed = result.confirmed && !then.contains("limit_mps");
        continue;
      }
      const double apart = std::abs(search["limit_mps"].get<double>() - then["limit_mps"].get<double>());
      const double widths = search["half_width_mps"].get<double>() + then["half_width_mps"].get<double>();
      result.confirmed = result.confirmed && apart <= widths * (1 + 1e-9);
    }
  result.confirmed = result.confirmed && shots > 0;
  result.text = std::string(result.confirmed ? "confirmed" : "not confirmed") +
                options::printed(", %d of %d shots bit-identical", same, shots);
  return result;
}

} // namespace study
