// SPDX-License-Identifier: BSD-3-Clause
#include "study/prediction.hpp"

#include "fuzz/memory_file.hpp"
#include "fuzz/targets.hpp"

#include <nlohmann/json.hpp>

namespace {

/// The record with the hash that its reader asks for; the bytes themselves if they are no record.
std::string with_hash(std::string_view bytes, const std::filesystem::path &file) {
  constexpr std::string_view before = "its hash is ";
  try {
    study::read_prediction(file, "prediction");
  } catch (const ogive::SetupError &error) {
    const std::string message = error.what();
    const std::size_t begin = message.find(before);
    auto record = nlohmann::ordered_json::parse(bytes, nullptr, false);
    if (begin == std::string::npos || !record.is_object()) return std::string(bytes);
    record["hash"] = message.substr(begin + before.size(), 16);
    return record.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  }
  return std::string(bytes);
}

} // namespace

/// The record of a ballistic limit, under the hash that it should have; one that is read is compared with a case and
/// with itself.
void fuzz::try_prediction(std::string_view bytes) {
  static MemoryFile file;
  static const shot::Options options;
  file.write(bytes);
  file.write(with_hash(bytes, file.path));
  try {
    const study::Prediction prediction = study::read_prediction(file.path, "prediction");
    study::compared(prediction, prediction);
    study::require_same_case(prediction, options, 2, "prediction");
  } catch (const ogive::SetupError &) {
  }
}
