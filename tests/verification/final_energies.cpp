// SPDX-License-Identifier: BSD-3-Clause
#include "compiler.hpp"
#include "record.hpp"
#include "sim/small_shot.hpp"

#include "ogive/io/csv_rows.hpp"
#include "ogive/sim/energy.hpp"
#include "ogive/sim/run.hpp"
#include "ogive/sim/step.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace verification {

namespace {

using namespace sim_test;

/// The end of a run: kinetic, elastic, plastic and total energy (J), and the hash of the state.
struct End {
  std::string name;
  std::array<double, 4> energies{};
  std::string hash;
};

std::string digits(double value, const char *format) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

template <class M> End run_for(const std::string &name, M model) {
  while (model.time < 10e-6) step(model, stable_time_step(model));
  const Energy<double> e = energy(model);
  char hash[32];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(state_hash(model)));
  return {name, {e.kinetic, e.elastic, e.plastic, total(e)}, hash};
}

std::vector<End> all_runs() {
  const auto plate = library::weldox_460e_mjc<double>();
  const auto steel = library::arne_tool_steel<double>();
  const auto blunt = small_case(Nose::blunt, Extent::quarter), conical = small_case(Nose::conical, Extent::quarter);
  std::vector<End> ends;
  for (const Nose nose : paper_noses)
    ends.push_back(run_for(std::string(name(nose)), small_shot(small_case(nose, Extent::quarter))));
  auto rigid = blunt;
  rigid.rigid_projectile = true;
  ends.push_back(run_for("blunt, rigid", small_shot(rigid)));
  auto half = blunt;
  half.extent = Extent::half;
  ends.push_back(run_for("blunt, half computed", small_shot(half)));
  auto cubic = blunt;
  cubic.lattice = Lattice::cubic;
  ends.push_back(run_for("blunt, cubic lattice", small_shot(cubic)));
  ends.push_back(run_for("conical, removal", make_perforation(conical, brittle(plate, FailureEffect::removal), steel)));
  // As the program runs them: their models are compiled once for all files.
  const auto any = [&](const std::string &name, const auto &metal, const AnyDiscretisation &parts) {
    const std::vector metals{with_law<AnyFlowLaw<double>>(metal)};
    ends.push_back(run_for(name, make_perforation(blunt, metals, with_law<AnyFlowLaw<double>>(steel), {}, parts)));
  };
  any("blunt, Johnson–Cook", library::weldox_460e_jc<double>(), {});
  any("blunt, standard form", plate, {.form = StandardForm{}});
  any("blunt, 2×2×2 points", plate, {.rule = SelectiveReduced{}});
  return ends;
}

std::vector<End> read_reference(const std::string &file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("--reference = " + file + ": cannot be read");
  std::stringstream text;
  text << stream.rdbuf();
  std::vector<End> ends;
  ogive::for_each_csv_row(text.str(), file, 6, [&](const ogive::CsvRow &row) {
    if (row.fields.size() != 6) throw std::runtime_error(file + ": each row must have 6 fields");
    if (row.fields[0] == "run") return;
    End end{row.fields[0], {}, row.fields[5]};
    for (std::size_t k = 0; k < end.energies.size(); ++k) end.energies[k] = std::stod(row.fields[k + 1]);
    ends.push_back(end);
  });
  return ends;
}

void write_reference(const std::string &file, const std::vector<End> &ends) {
  std::ofstream stream(file);
  stream << "# Written by verification --accept, " << made_with()
         << ".\nrun,kinetic_J,elastic_J,plastic_J,total_J,hash\n";
  for (const End &end : ends) {
    stream << '"' << end.name << '"';
    for (const double e : end.energies) stream << ',' << digits(e, "%.17g");
    stream << ',' << end.hash << '\n';
  }
  if (!(stream << std::flush)) throw std::runtime_error("--reference = " + file + ": cannot be written");
}

} // namespace

Rung final_energies(const std::string &reference, bool write) {
  const std::vector<End> ends = all_runs();
  if (write) write_reference(reference, ends);
  const std::vector<End> expected = read_reference(reference);
  Rung rung;
  rung.name = "final_energies";
  rung.titles = {"run", "kinetic, J", "elastic, J", "plastic, J", "total, J", "hash", "difference", "at most", "bits"};
  for (const End &end : ends) {
    const auto old = std::find_if(expected.begin(), expected.end(), [&](const End &e) { return e.name == end.name; });
    Line line{{end.name}, false};
    for (const double e : end.energies) line.cells.push_back(digits(e, "%#.10g"));
    line.cells.push_back("`" + end.hash + "`");
    // The reference is that of eight doubles in a pack. Other packs add the pairs, of single precision, in another
    // order: 1.2e-6 was measured with four, in the standard form.
    constexpr double bound = lanes<double> == 8 ? 1e-7 : 3e-6;
    if (old == expected.end()) {
      line.cells.insert(line.cells.end(), {"no reference", roughly(bound), ""});
    } else {
      double difference = 0;
      for (std::size_t k = 0; k < end.energies.size(); ++k)
        difference = std::max(difference, std::abs(end.energies[k] - old->energies[k]) / old->energies.back());
      line.cells.insert(line.cells.end(),
                        {roughly(difference), roughly(bound), end.hash == old->hash ? "same" : "others"});
      line.ok = difference <= bound;
    }
    rung.lines.push_back(line);
  }
  return rung;
}

} // namespace verification
