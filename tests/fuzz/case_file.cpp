// SPDX-License-Identifier: BSD-3-Clause
#include "perforate/options.hpp"
#include "perforate/options_table.hpp"

#include "fuzz/memory_file.hpp"
#include "fuzz/must.hpp"
#include "fuzz/target.hpp"

#include <array>
#include <sstream>

namespace {

/// The options in a case file.
perforate::Options read(fuzz::MemoryFile &file, std::string_view text) {
  file.write(text);
  const std::array arguments{"perforate", "--config", file.path.c_str()};
  std::ostringstream ignored;
  return perforate::parse(static_cast<int>(arguments.size()), arguments.data(), ignored).value();
}

} // namespace

/// A case file; one that is read is written and read again.
void fuzz::try_input(std::string_view bytes) {
  static MemoryFile file;
  perforate::Options options;
  try {
    perforate::entries_of(bytes, "case.toml"); // what is no TOML ends here, before the slow command line
    options = read(file, bytes);
  } catch (const ogive::SetupError &) {
    return;
  }
  must(read(file, perforate::to_toml(options)) == options, "options that were written read back as the same");
}
