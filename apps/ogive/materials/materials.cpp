// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include "cards/import.hpp"
#include "materials/certificate.hpp"
#include "materials/library.hpp"
#include "ogive/commands.hpp"
#include "options/exit_status.hpp"

#include "ogive/io/atomic_file.hpp"
#include "ogive/material/shear_band.hpp"

#include <cmath>
#include <iostream>

namespace commands {

namespace {

namespace library = ::materials;
using library::AnyMetal;

AnyMetal metal_named(const std::string &name, library::Model model) {
  if (!library::is_known(name)) {
    auto names = library::library_names();
    for (std::string &of_projectile : library::projectile_metal_names()) names.push_back(std::move(of_projectile));
    throw ogive::SetupError("show = " + options::printable(name) + ": must be " + library::allowed_projectile_metals() +
                            options::nearest_text(name, names));
  }
  return library::find_metal(name, model, "show");
}

/// Strain of instability and width of bands of adiabatic shear of a metal, with the method stabilised, as text.
std::string band_text(const AnyMetal &any) {
  return std::visit(
      [](auto metal) -> std::string {
        const double strain = ogive::instability_strain(metal, 1e4);
        if (!std::isfinite(strain)) return "Bands of adiabatic shear: none, hardening outweighs heat at any strain";
        const double width_mm = 1e3 * ogive::band_width(ogive::thermal_diffusivity(metal), 50e-6);
        return "Bands of adiabatic shear: strain of instability " + options::shortest(std::round(1e3 * strain) / 1e3) +
               (width_mm > 0 ? ", " + options::shortest(std::round(1e4 * width_mm) / 1e4) + " mm wide after 50 us"
                             : ", no conductivity is known: none form");
      },
      any);
}

/// Prints a metal as a file for --material, or draws it.
void show(const metals::Options &o, const std::string &name) {
  const AnyMetal metal = metal_named(name, o.model);
  if (o.plot.empty()) {
    std::cout << library::to_toml(metal, name + "\n" + band_text(metal) +
                                             "\nA copy with other numbers is a metal for --material.");
    return;
  }
  const library::LibraryMetal *entry = library::find_library_metal(name);
  const std::string title = entry == nullptr ? options::printable(library::name_of(metal)) : std::string(entry->title);
  metals::draw_metal(metal, title + ", " + library::title_of_model(library::name_of(library::model_of(metal))), o.plot);
  std::cout << "wrote " << o.plot.string() << "\n";
}

/// Lines of notes that begin alike.
void print(std::ostream &out, const std::string &start, const std::vector<std::string> &lines) {
  for (const std::string &line : lines) out << start << line << "\n";
}

std::vector<std::string> doubts_of(const AnyMetal &metal) {
  auto doubts = library::doubts_of_flow(metal);
  for (std::string &doubt : library::doubts_of_damage(metal)) doubts.push_back(std::move(doubt));
  return doubts;
}

void check(const std::string &file) {
  const AnyMetal metal = library::read(file, "check");
  std::cout << file << ": " << library::name_of(metal) << ", model " << library::name_of(library::model_of(metal))
            << ", is a metal for --material\n";
  print(std::cout, "warning: ", doubts_of(metal));
}

/// Writes a new material file with notes on top, or prints it. Notes go where the file does not.
void deliver(const metals::Options &o, const AnyMetal &metal, const std::vector<std::string> &notes,
             std::vector<std::string> warnings) {
  const std::string text = library::to_toml(metal, options::joined(notes, "\n"));
  std::ostream &out = o.out.empty() ? std::cerr : std::cout;
  if (o.out.empty())
    std::cout << text;
  else
    ogive::write_atomically(o.out, text);
  print(out, "", notes);
  for (std::string &doubt : doubts_of(metal)) warnings.push_back(std::move(doubt));
  print(out, "warning: ", warnings);
  if (!o.out.empty()) out << "wrote " << o.out.string() << ", a metal for --material\n";
}

void import(const metals::Options &o) {
  const cards::Imported card = cards::import_card(std::filesystem::path(o.names.front()), o.units, o.name);
  auto notes = card.notes;
  for (const std::string &dropped : card.dropped) notes.push_back("dropped: " + dropped);
  deliver(o, card.metal, notes, {});
}

void from_tensile(const metals::Options &o) {
  const auto share = [](const std::optional<double> &percent) {
    return percent ? std::optional(*percent / 100) : std::nullopt;
  };
  const library::Certificate certificate{.numbers = {*o.yield_mpa * 1e6, *o.uts_mpa * 1e6, *o.young_gpa * 1e9},
                                         .elongation = share(o.elongation_pct),
                                         .uniform_elongation = share(o.uniform_elongation_pct),
                                         .reduction_of_area = share(o.reduction_of_area_pct)};
  const std::string like = o.like.empty() ? library::kind_of(certificate.numbers.young) : o.like;
  if (like.empty())
    throw ogive::SetupError("--like: is required: --young-gpa = " + options::shortest(*o.young_gpa) +
                            " is neither that of steel nor that of aluminium");
  if (!library::is_material_file(like) && library::find_library_metal(like) == nullptr)
    options::refuse("--like", like,
                    "must be " + library::allowed_materials() + options::nearest_text(like, library::library_names()));
  const auto law = o.law == metals::Hardening::voce ? library::Model::voce : library::Model::power_law;
  const auto made = library::metal_of(certificate, law, like, o.name.empty() ? "my_metal" : o.name);
  // With all checks of a file.
  library::parse(library::to_toml(made.metal, ""), "from-tensile");
  deliver(o, made.metal, made.notes, made.warnings);
}

} // namespace

options::Table materials_table() { return unbound(metals::table_of); }

int materials(const options::Arguments &arguments) {
  const auto o = metals::parse(arguments);
  if (!o) return options::only_printed;
  switch (o->action) {
  case metals::Action::list:
    std::cout << library::library_list();
    break;
  case metals::Action::show:
    for (const std::string &name : o->names) show(*o, name);
    break;
  case metals::Action::check:
    for (const std::string &name : o->names) check(name);
    break;
  case metals::Action::import:
    import(*o);
    break;
  case metals::Action::from_tensile:
    from_tensile(*o);
    break;
  }
  return o->out.empty() && o->plot.empty() ? options::only_printed : options::success;
}

} // namespace commands
