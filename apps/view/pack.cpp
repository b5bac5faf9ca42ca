// SPDX-License-Identifier: BSD-3-Clause
#include "pack.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <vtkBase64Utilities.h>
#include <vtkNew.h>
#include <vtkZLibDataCompressor.h>

namespace view {

namespace {

using Json = nlohmann::ordered_json;
constexpr double last_step = 65535;

/// Adds values to the words and returns the range that they need.
Json append(Words &words, const std::vector<float> &values) {
  const Steps steps = steps_of(values);
  for (const float value : values) words.push_back(step_of(value, steps));
  return {steps.low, steps.size};
}

Json append_positions(Words &words, const std::vector<ogive::Vec3<float>> &positions) {
  Json ranges = Json::array();
  std::vector<float> values(positions.size());
  for (int k = 0; k < 3; ++k) {
    std::transform(positions.begin(), positions.end(), values.begin(), [&](const auto &x) { return 1e3F * x[k]; });
    ranges.push_back(append(words, values));
  }
  return ranges;
}

constexpr char velocity_name[] = "velocity_m_per_s";

bool has_field(const std::vector<ogive::Field> &fields, std::string_view name, int components) {
  return std::any_of(fields.begin(), fields.end(),
                     [&](const ogive::Field &field) { return field.name == name && field.components == components; });
}

/// The amount of the mean velocity of each group of points.
template <class Groups> std::vector<float> speeds(const ogive::Field &velocity, const Groups &groups) {
  std::vector<float> values;
  for (const auto &points : groups) {
    ogive::Vec3<double> mean = ogive::Vec3<double>::Zero();
    for (const auto n : points)
      for (int k = 0; k < 3; ++k)
        mean[k] += velocity.values[3 * static_cast<std::size_t>(n) + static_cast<std::size_t>(k)];
    values.push_back(static_cast<float>(mean.norm() / static_cast<double>(points.size())));
  }
  return values;
}

std::vector<float> values_of(const ogive::PointCloud &cloud, const std::string &field) {
  if (field != speed_field) return ogive::find_field(cloud.fields, field, cloud.name).values;
  std::vector<std::array<ogive::Index, 1>> each(cloud.positions.size());
  for (std::size_t i = 0; i < each.size(); ++i) each[i] = {static_cast<ogive::Index>(i)};
  return speeds(ogive::find_field(cloud.fields, velocity_name, cloud.name), each);
}

std::vector<float> values_of(const ogive::HexGrid &grid, const std::string &field) {
  if (field != speed_field) return ogive::find_field(grid.cell_fields, field, grid.name).values;
  return speeds(ogive::find_field(grid.point_fields, velocity_name, grid.name), grid.hexes);
}

template <class Part>
void append_fields(Json &part, Words &words, const Part &from, std::size_t count,
                   const std::vector<std::string> &fields) {
  part["fields"] = Json::array();
  for (const std::string &name : fields) {
    const auto values = values_of(from, name);
    ogive::require(values.size() == count, from.name + " " + name + " values", values.size(),
                   "must be one for each of " + std::to_string(count));
    part["fields"].push_back(append(words, values));
  }
}

Json append_part(Words &words, const ogive::PointCloud &cloud, const std::vector<std::string> &fields) {
  Json part{{"name", cloud.name}, {"points", cloud.positions.size()}, {"diameter_mm", 1e3 * double(cloud.diameter)}};
  part["position_mm"] = append_positions(words, cloud.positions);
  append_fields(part, words, cloud, cloud.positions.size(), fields);
  return part;
}

Json append_part(Words &words, const ogive::HexGrid &grid, const std::vector<std::string> &fields) {
  Json part{{"name", grid.name}, {"points", grid.positions.size()}, {"hexes", grid.hexes.size()}};
  part["position_mm"] = append_positions(words, grid.positions);
  for (int shift = 0; shift < (grid.positions.size() > 65536 ? 32 : 16); shift += 16)
    for (std::size_t corner = 0; corner < 8; ++corner)
      for (const auto &hex : grid.hexes)
        words.push_back(static_cast<std::uint16_t>(static_cast<std::uint32_t>(hex[corner]) >> shift));
  append_fields(part, words, grid, grid.hexes.size(), fields);
  return part;
}

} // namespace

Steps steps_of(const std::vector<float> &values) {
  double low = INFINITY, high = -INFINITY;
  for (const float value : values)
    if (std::isfinite(value)) low = std::min(low, double(value)), high = std::max(high, double(value));
  return low <= high ? Steps{low, high - low} : Steps{};
}

std::uint16_t step_of(double value, const Steps &steps) {
  if (!std::isfinite(value) || !(steps.size > 0)) return 0;
  return static_cast<std::uint16_t>(std::lround(last_step * std::clamp((value - steps.low) / steps.size, 0.0, 1.0)));
}

std::string packed(const Words &words) {
  std::vector<unsigned char> bytes;
  bytes.reserve(2 * words.size());
  for (const int shift : {0, 8})
    for (const std::uint16_t word : words) bytes.push_back(static_cast<unsigned char>(word >> shift));
  vtkNew<vtkZLibDataCompressor> zlib;
  zlib->SetCompressionLevel(9);
  std::vector<unsigned char> small(zlib->GetMaximumCompressionSpace(bytes.size()));
  small.resize(zlib->Compress(bytes.data(), bytes.size(), small.data(), small.size()));
  std::string text(4 * ((small.size() + 2) / 3), '\0');
  vtkBase64Utilities::Encode(small.data(), static_cast<unsigned long>(small.size()),
                             reinterpret_cast<unsigned char *>(text.data()));
  return text;
}

std::vector<std::string> common_fields(const ogive::Frame &frame) {
  std::vector<const std::vector<ogive::Field> *> all;
  bool speed = true;
  for (const auto &cloud : frame.clouds) {
    all.push_back(&cloud.fields);
    speed = speed && has_field(cloud.fields, velocity_name, 3);
  }
  for (const auto &grid : frame.grids) {
    all.push_back(&grid.cell_fields);
    speed = speed && has_field(grid.point_fields, velocity_name, 3);
  }
  std::vector<std::string> names;
  if (all.empty()) return names;
  for (const auto &field : *all.front())
    if (std::all_of(all.begin(), all.end(), [&](const auto *fields) { return has_field(*fields, field.name, 1); }))
      names.push_back(field.name);
  if (speed) names.emplace_back(speed_field);
  return names;
}

PackedFrame pack(const ogive::Frame &frame, const std::vector<std::string> &fields) {
  Words words;
  Json description{{"time_us", 1e6 * frame.time}, {"mirrored_x", frame.symmetry.x}, {"mirrored_y", frame.symmetry.y}};
  description["parts"] = Json::array();
  for (const auto &cloud : frame.clouds) description["parts"].push_back(append_part(words, cloud, fields));
  for (const auto &grid : frame.grids) description["parts"].push_back(append_part(words, grid, fields));
  description["words"] = words.size();
  return {description.dump(), packed(words)};
}

} // namespace view
