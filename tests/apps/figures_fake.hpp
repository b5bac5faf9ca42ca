// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "figures/campaign.hpp"

#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "parse.hpp"

#include <cstdio>
#include <map>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

/// \file
/// A stand-in for perforate, and processes, for the tests of the campaigns.

/// A folder for a campaign, with a shell script in place of perforate: it notes its start in the file `starts`, does
/// what `behaviour` says and leaves the summary of a shot that perforated above 187 m/s.
struct FakeWorkshop {
  TemporaryFolder folder;
  figures::Workshop workshop{folder.path / "out", folder.path / "out/shots.csv", folder.path / "perforate", 2, 1};

  explicit FakeWorkshop(const std::string &behaviour = "") { behave(behaviour); }

  void behave(const std::string &behaviour) const {
    std::string numbers;
    figures::for_each_column(figures::ShotRow{}, [&]<class V>(const std::string &name, const V &) {
      if (std::is_same_v<V, double> && name != "perforated" && !name.ends_with("velocity_mps") &&
          name != "thickness_mm" && name != "spacing_mm")
        numbers += ", \"" + name + "\": 1.5";
    });
    write(workshop.perforate, "#!/bin/sh\nhere=" + folder.path.string() + R"(
for option; do
  value=${option#*=}
  case $option in
    --out=*) out=$value ;; --model=*) model=$value ;; --material=*) material=$value ;; --nose=*) nose=$value ;;
    --thickness-mm=*) thickness=$value ;; --velocity-mps=*) velocity=$value ;; --output-every-us=*) frames=$value ;;
  esac
done
echo "$model $nose $thickness $velocity" >> "$here/starts"
mkdir -p "$out"
rm -f "$out/summary.json" "$out/perforation.pvd"
fault=null perforated=false residual=0
if [ "${velocity%.*}" -ge 187 ]; then perforated=true residual=100; fi
if [ -n "$frames" ]; then echo > "$out/perforation.pvd"; fi
)" + behaviour + R"(
cat > "$out/part" <<END
{"version": "0.1.0", "state_hash": "00ff", "model": "$model", "material": "$material", "nose": "$nose", "fault": $fault,
 "thickness_mm": $thickness, "initial_velocity_mps": $velocity, "residual_velocity_mps": $residual,
 "perforated": $perforated)" + numbers +
                                  "}\nEND\nmv \"$out/part\" \"$out/summary.json\"\n");
    std::filesystem::permissions(workshop.perforate, std::filesystem::perms::owner_all);
  }

  figures::Outcome run(const std::vector<figures::Task> &tasks, std::vector<std::string> *said = nullptr) const {
    return figures::run_shots(workshop, tasks, [&](const std::string &line) {
      if (said != nullptr) said->push_back(line);
    });
  }

  /// How often each shot was started.
  std::map<std::string, int> starts() const {
    std::istringstream text(read_text(folder.path / "starts"));
    std::map<std::string, int> count;
    for (std::string line; std::getline(text, line);) ++count[line];
    return count;
  }

  std::vector<figures::ShotRow> rows() const { return figures::read_rows(workshop.rows); }
};

inline figures::Task task_at(double velocity, double frames_us = 0) {
  return {{"sfm", "mjc", "weldox_460e", "blunt", 12, velocity, 2}, frames_us};
}

inline std::vector<figures::Task> tasks_from(int first, int count) {
  std::vector<figures::Task> tasks;
  for (int k = 0; k < count; ++k) tasks.push_back(task_at(first + k));
  return tasks;
}

/// A process of its own that ends with what `f` returns, 99 if it throws.
template <class F> pid_t in_child(F &&f) {
  std::fflush(nullptr);
  const pid_t child = ::fork();
  if (child != 0) return child;
  try {
    ::_exit(f());
  } catch (...) {
    ::_exit(99);
  }
}

/// The status of a process as a shell tells it: its exit status, or 128 and the signal.
inline int shell_status(pid_t child) {
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

inline bool is_alive(const std::string &process) {
  const std::string stat = read_text("/proc/" + process + "/stat");
  return !stat.empty() && stat[stat.rfind(')') + 2] != 'Z';
}
