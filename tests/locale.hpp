// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/temporary_folder.hpp"

#include <clocale>
#include <cstdlib>
#include <locale>
#include <string>

/// Writes 1234.5 as "1.234,5", as German does.
struct GermanNumbers : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// As long as it lives, the C++ locale of the program writes numbers as German does, and where localedef can build a
/// German one the C locale, too.
struct GermanLocale {
  std::locale before_cpp = std::locale::global(std::locale(std::locale::classic(), new GermanNumbers));
  std::string before_c = std::setlocale(LC_ALL, nullptr);
  TemporaryFolder folder;
  bool also_c = false; ///< whether the C locale is German, too

  GermanLocale() {
    const std::string name = "de_DE.UTF-8", made = (folder.path / name).string();
    const std::string command = "localedef -i de_DE -f UTF-8 '" + made + "' > /dev/null 2>&1";
    // localedef has status 1 where it only warns.
    if (std::setlocale(LC_ALL, name.c_str()) == nullptr && std::system(command.c_str()) != -1) {
      ::setenv("LOCPATH", folder.path.c_str(), 1);
      std::setlocale(LC_ALL, name.c_str());
      ::unsetenv("LOCPATH");
    }
    also_c = std::string(std::localeconv()->decimal_point) == ",";
  }
  ~GermanLocale() {
    std::setlocale(LC_ALL, before_c.c_str());
    std::locale::global(before_cpp);
  }
  GermanLocale(const GermanLocale &) = delete;
  GermanLocale &operator=(const GermanLocale &) = delete;
};
