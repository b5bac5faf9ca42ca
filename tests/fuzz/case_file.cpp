// SPDX-License-Identifier: BSD-3-Clause
#include "options/toml_file.hpp"
#include "shot/options.hpp"
#include "shot/table.hpp"

#include "fuzz/memory_file.hpp"
#include "fuzz/must.hpp"
#include "fuzz/targets.hpp"

namespace {

/// The options in a case file.
shot::Options read(fuzz::MemoryFile &file, std::string_view text) {
  file.write(text);
  options::CommandLine line;
  line.config = file.path;
  return shot::settled(shot::levels_of(line));
}

} // namespace

/// A case file; one that is read is written and read again.
void fuzz::try_case_file(std::string_view bytes) {
  static MemoryFile file;
  shot::Options options;
  try {
    options::toml_entries(bytes, "case.toml", shot::toml_example); // what is no TOML ends here, before the table
    options = read(file, bytes);
  } catch (const ogive::SetupError &) {
    return;
  }
  must(read(file, shot::to_toml(options)) == options, "options that were written read back as the same");
}
