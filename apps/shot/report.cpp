// SPDX-License-Identifier: BSD-3-Clause
#include "report.hpp"

#include "defaults.hpp"
#include "draw/plot.hpp"
#include "draw/process.hpp"
#include "draw/section.hpp"
#include "materials/library.hpp"
#include "ogive/io/atomic_file.hpp"
#include "ogive/version.hpp"
#include "parts.hpp"
#include "plates.hpp"
#include "projectile.hpp"
#include "table.hpp"
#include "title.hpp"

#include <nlohmann/json.hpp>
#include <omp.h>
#include <sys/resource.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace shot {

Verdict verdict(const Result &shot) {
  using enum ogive::FlightState;
  if (shot.flight.state == in_progress) return Verdict::undecided;
  return shot.flight.state == perforated ? Verdict::perforated : Verdict::stopped;
}

std::optional<double> dishing_at_rest_mm(const Result &shot) {
  const double time_us = shot.swing.until_us - shot.swing.begun_us;
  if (shot.swing.begun_us < 0 || !(time_us > 0)) return std::nullopt;
  return shot.swing.integral_mm_us / time_us;
}

std::optional<double> residual_mps(const Result &shot) {
  if (verdict(shot) == Verdict::undecided) return std::nullopt;
  return verdict(shot) == Verdict::perforated ? shot.flight.samples.back().velocity : 0.0;
}

namespace {

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

double ns_per_particle_step(const Result &s) {
  return s.loop_s * 1e9 / std::max(1.0, static_cast<double>(s.steps) * static_cast<double>(s.sizes.particles));
}

/// "neighbours 3 %, gradient 20 %, ...": of the time loop.
std::string shares(const Result &s) {
  const double total = std::accumulate(s.times.seconds.begin(), s.times.seconds.end(), 0.0);
  std::string text;
  for (std::size_t k = 0; k < ogive::phase_count; ++k) {
    const auto phase = static_cast<ogive::Phase>(k);
    char share[64];
    std::snprintf(share, sizeof share, "%s%s %.0f %%", text.empty() ? "" : ", ",
                  std::string(ogive::name(phase)).c_str(), 100 * s.times[phase] / total);
    text += share;
  }
  return text;
}

/// Reason for the end of the run.
const char *ending(const Result &s) {
  if (s.fault) return "fault";
  switch (s.flight.state) {
  case ogive::FlightState::perforated:
    return s.flight.sharp ? "the tail left the plate" : "the velocity is steady";
  case ogive::FlightState::stopped:
    return s.flight.samples.back().advance < 0 ? "the projectile rebounds" : "the projectile rests in the plate";
  default:
    return "end of time";
  }
}

/// Reason why a shot is undecided, one line; empty if it is decided.
std::string undecided_reason(const Result &s) {
  if (verdict(s) != Verdict::undecided) return "";
  if (s.fault) return "a fault stopped the run";
  const auto &last = s.flight.samples.back();
  const bool moves = last.velocity > ogive::rest_share * s.flight.initial_velocity;
  const char *what = !moves                                                   ? "and hardly moves"
                     : !s.way.clear                                           ? "into what still hangs on the plate"
                     : last.tail < s.flight.plate_thickness && s.flight.sharp ? "with its tail still in the plate"
                                                                              : "and its velocity has not settled";
  return options::printed("at %.4g us the projectile moves at %.1f m/s %s", s.simulated_us, last.velocity, what);
}

/// The part that the velocity is of if the parts of the projectile touch; else empty.
std::string followed_part(const Result &s) {
  for (const PartResult &part : s.parts)
    if (part.is_followed) return part.name;
  return "";
}

/// A section takes some seconds, most of them on a machine without a graphics card.
constexpr double most_drawing_s = 120;

void add_shape(nlohmann::ordered_json &j, const ogive::PlateShape<double> &shape) {
  j["plug_thickness_mm"] = shape.plug_thickness * 1e3;
  j["dishing_mm"] = shape.dishing * 1e3;
  j["kept_fraction"] = shape.kept_fraction;
  j["petal_height_mm"] = shape.petal_height * 1e3;
  j["petals"] = shape.petals;
  j["hole_diameter_mm"] = shape.hole_diameter * 1e3;
  j["band_temperature_K"] = shape.band_temperature;
  j["core_temperature_K"] = shape.core_temperature;
  j["most_temperature_K"] = shape.most_temperature;
}

/// The case in the names of the options, for the terminal.
std::string case_line(const Options &o, const Result &s) {
  std::string sizes = options::shortest(o.thickness_mm) + " mm, ";
  if (!o.layers_mm.empty()) sizes = joined(o.layers_mm, " + ") + " mm, ";
  if (target_depth_mm(o) > o.thickness_mm) sizes += joined(o.gaps_mm, ", ") + " mm apart, ";
  return s.material + ", " + name_of(o.model) + ", " + projectile_label(o) + ", " + sizes +
         options::shortest(o.velocity_mps) + " m/s" +
         (o.obliquity_deg == 0 ? "" : " at " + options::shortest(o.obliquity_deg) + " deg") + ", method " +
         name_of(o.method);
}

} // namespace

std::optional<experiment::Residual> find_test(const Options &o) {
  const materials::LibraryMetal *metal = materials::find_library_metal(o.material);
  if (metal == nullptr || !is_of_the_tests(o) || !o.layers_mm.empty()) return std::nullopt;
  return experiment::find_residual(std::string(metal->title), std::string(ogive::name(o.nose)), o.thickness_mm,
                                   o.velocity_mps);
}

void announce(const Options &o, const Result &shot) {
  if (o.quiet) return;
  const Sizes &s = shot.sizes;
  std::printf("%s\n", case_line(o, shot).c_str());
  std::printf("  particle distance   %.4f mm (target %g), %ld particles, %ld hexes\n", s.spacing_mm, o.spacing_mm,
              s.particles, s.hexes);
  std::printf("  projectile          %.2f g%s", s.projectile_mass_g, is_of_the_tests(o) ? " (197 g in the tests)" : "");
  if (s.added_mass_g > 1e-6) std::printf(", and %.2f g added to thin hexes at the tip", s.added_mass_g);
  std::printf(", %.1f mm3, least scaled Jacobian %.2f", s.projectile_volume_mm3, s.projectile_jacobian);
  for (const auto &[name, mass_g] : s.part_masses_g) std::printf("\n    %-17s %.2f g", name.c_str(), mass_g);
  std::printf("\n  first time step     %.4f us, threads %d\n", s.time_step_us, omp_get_max_threads());
  if (o.restart) std::printf("  resumes from        %.3f us, %s\n", o.restart->time_us, o.restart->file.c_str());
  std::fflush(stdout);
}

nlohmann::ordered_json summary_of(const Options &o, const Result &s, const std::optional<experiment::Residual> &test) {
  char hash[20];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(s.state_hash));
  nlohmann::ordered_json j;
  j["version"] = ogive::version;
  j["material"] = s.material;
  j["model"] = name_of(o.model);
  j["method"] = name_of(o.method);
  j["damage"] = name_of(o.damage);
  j["failure"] = name_of(o.failure);
  j["nose"] = std::string(ogive::name(o.nose));
  j["diameter_mm"] = o.diameter_mm;
  j["length_mm"] = o.length_mm;
  j["nose_length_mm"] = o.nose_length_mm;
  j["tip_diameter_mm"] = o.tip_diameter_mm;
  j["edge_radius_mm"] = o.edge_radius_mm;
  j["tail_length_mm"] = o.tail_length_mm;
  j["tail_diameter_mm"] = o.tail_diameter_mm;
  j["obliquity_deg"] = o.obliquity_deg;
  j["pitch_deg"] = o.pitch_deg;
  j["yaw_deg"] = o.yaw_deg;
  j["projectile"] = o.rigid ? "rigid" : "deformable";
  j["projectile_name"] = projectile_label(o);
  j["projectile_metal"] = part_metals_label(o);
  j["thickness_mm"] = o.thickness_mm;
  j["spacing_mm"] = s.sizes.spacing_mm;
  j["friction"] = o.friction;
  j["initial_velocity_mps"] = o.velocity_mps;
  j["residual_velocity_mps"] = nullptr;
  if (const auto residual = residual_mps(s)) j["residual_velocity_mps"] = *residual;
  j["final_velocity_mps"] = s.flight.samples.back().velocity;
  j["final_speed_mps"] = s.motion.speed;
  j["final_direction"] = {s.motion.direction[0], s.motion.direction[1], s.motion.direction[2]};
  j["deflection_deg"] = in_degrees(s.motion.deflection);
  j["turn_deg"] = in_degrees(s.motion.turn);
  j["spin_rad_per_s"] = {s.motion.spin[0], s.motion.spin[1], s.motion.spin[2]};
  j["velocity_at_shoulder_mps"] = nullptr;
  j["velocity_at_tail_mps"] = nullptr;
  if (s.flight.velocity_at_shoulder) j["velocity_at_shoulder_mps"] = *s.flight.velocity_at_shoulder;
  if (s.flight.velocity_at_tail) j["velocity_at_tail_mps"] = *s.flight.velocity_at_tail;
  const auto names = std::array{"perforated", "stopped", "undecided"};
  j["verdict"] = names[static_cast<std::size_t>(verdict(s))];
  j["undecided_because"] = nullptr;
  j["perforated"] = nullptr;
  if (verdict(s) == Verdict::undecided)
    j["undecided_because"] = undecided_reason(s);
  else
    j["perforated"] = verdict(s) == Verdict::perforated;
  j["ending"] = ending(s);
  j["fault"] = nullptr;
  if (s.fault)
    j["fault"] = {{"what", s.fault->what}, {"body", s.fault->body}, {"id", s.fault->id}, {"time_us", s.fault->time_us}};
  j["test_residual_velocity_mps"] = nullptr;
  if (test) j["test_residual_velocity_mps"] = test->residual_mps, j["test_origin"] = test->origin;
  j["plug_mass_g"] = s.fragments.plug_mass * 1e3;
  j["plug_velocity_mps"] = s.fragments.plug_velocity;
  if (s.layers.size() == 1) add_shape(j, s.layers.front().shape);
  if (const auto rest = dishing_at_rest_mm(s)) j["dishing_at_rest_mm"] = *rest;
  j["debris_mass_g"] = s.fragments.debris_mass * 1e3;
  j["failed_mass_g"] = s.fragments.failed_mass * 1e3;
  j["failed_particles"] = s.fragments.failed;
  j["projectile_mass_g"] = s.sizes.projectile_mass_g;
  j["projectile_volume_mm3"] = s.sizes.projectile_volume_mm3;
  for (const auto &[name, mass_g] : s.sizes.part_masses_g) j["projectile_part_masses_g"][name] = mass_g;
  for (const PartResult &part : s.parts) {
    if (part.is_followed) j["followed_part"] = part.name;
    j["parts"].push_back({{"name", part.name}, {"mass_g", part.mass_g}, {"velocity_mps", part.velocity_mps}});
  }
  j["removed_hexes"] = s.removed_hexes;
  j["removed_mass_g"] = s.removed_mass_g;
  j["added_mass_g"] = s.sizes.added_mass_g;
  j["projectile_scaled_jacobian"] = s.sizes.projectile_jacobian;
  j["largest_intrusion_mm"] = s.intrusion_mm;
  j["hourglass_fraction"] = s.hourglass_fraction;
  j["energy_error"] = s.energy_error;
  j["momentum_error"] = s.momentum_error;
  j["particles"] = s.sizes.particles;
  j["elements"] = s.sizes.hexes;
  j["steps"] = s.steps;
  j["simulated_us"] = s.simulated_us;
  j["wall_s"] = s.wall_s;
  j["cpu_s"] = s.cpu_s;
  j["threads"] = omp_get_max_threads();
  j["ns_per_particle_step"] = ns_per_particle_step(s);
  for (std::size_t k = 0; k < ogive::phase_count; ++k) {
    const auto phase = static_cast<ogive::Phase>(k);
    j["phase_s"][std::string(ogive::name(phase))] = s.times[phase];
  }
  j["peak_memory_mb"] = peak_memory_mb();
  j["state_hash"] = hash;
  for (std::size_t k = 0; k < o.layers_mm.size(); ++k) {
    const LayerResult &layer = s.layers[k];
    nlohmann::ordered_json entry;
    entry["material"] = layer.material;
    entry["thickness_mm"] = o.layers_mm[k];
    entry["gap_before_mm"] = k == 0 ? 0 : o.gaps_mm[k - 1];
    entry["plug_mass_g"] = layer.fragments.plug_mass * 1e3;
    entry["plug_velocity_mps"] = layer.fragments.plug_velocity;
    add_shape(entry, layer.shape);
    entry["debris_mass_g"] = layer.fragments.debris_mass * 1e3;
    entry["failed_mass_g"] = layer.fragments.failed_mass * 1e3;
    j["layers"].push_back(entry);
  }
  return j;
}

void write_summary(const Options &o, const Result &s, const std::optional<experiment::Residual> &test) {
  ogive::write_atomically(o.out / "summary.json", summary_of(o, s, test).dump(2) + "\n");
}

std::string draw(const Options &o, const Result &s, const std::optional<experiment::Residual> &test) {
  if (!o.picture) return {};
  std::string left_out;
  const std::string title = title_of(summary_of(o, s, test));
  const auto attempt = [&](auto &&draw_one) {
    try {
      draw_one();
    } catch (const std::exception &error) {
      left_out += std::string(left_out.empty() ? "" : "\n") + error.what();
    }
  };
  attempt([&] {
    const auto picture = o.out / "section.png";
    const std::string part = followed_part(s);
    const std::string when = options::printed("%.1f µs, %.1f m/s", s.simulated_us, s.flight.samples.back().velocity) +
                             (part.empty() ? "" : " (" + part + ")");
    const double low_mm = std::min(-target_depth_mm(o), -s.flight.samples.back().nose * 1e3) - 14;
    // Sharp noses leave petals, which a section cuts through.
    const auto rear = s.flight.sharp ? draw::Rear::shown : draw::Rear::left_out;
    draw::draw_apart(picture, most_drawing_s, [&] {
      draw::render_section({s.last_frame, when}, title, low_mm, picture, rear);
    });
  });
  attempt([&] {
    draw::VelocityPlot plot{title, {{o.out / "history.csv"}}};
    if (test && test->residual_mps > 0) plot.measured_residual_m_per_s = test->residual_mps;
    draw::write_velocity_plot(plot, o.out / "velocity.svg");
  });
  return left_out;
}

void print_table(const Options &o, const Result &s, const std::optional<experiment::Residual> &test) {
  if (const auto residual = residual_mps(s)) {
    const std::string part = followed_part(s);
    std::printf("\n  %-22s %s\n", "perforated", verdict(s) == Verdict::perforated ? "yes" : "no");
    std::printf("  %-22s %.1f m/s%s\n", "residual velocity", *residual,
                (part.empty() ? "" : ", of the part " + part).c_str());
  } else {
    std::printf("\n  %-22s undecided: %s\n", "perforated", undecided_reason(s).c_str());
    if (!s.fault)
      std::printf(
          "  %-22s %s\n", "to decide it",
          ("--resume --end-us " + options::shortest(std::min(20 * std::ceil(s.simulated_us / 10), 100000.0))).c_str());
  }
  if (o.extent != Extent::quarter) {
    std::printf("  %-22s %.1f m/s, %.2f deg from the line of flight\n", "speed and direction", s.motion.speed,
                in_degrees(s.motion.deflection));
    std::printf("  %-22s turned by %.2f deg, spin %.4g rad/s\n", "projectile's axis", in_degrees(s.motion.turn),
                s.motion.spin.norm());
  }
  if (test) std::printf("  %-22s %.1f m/s (%s)\n", "test", test->residual_mps, test->origin.c_str());
  if (s.flight.velocity_at_shoulder)
    std::printf("  %-22s %.1f m/s\n", "when the shoulder left", *s.flight.velocity_at_shoulder);
  if (s.flight.velocity_at_tail) std::printf("  %-22s %.1f m/s\n", "when the tail left", *s.flight.velocity_at_tail);
  std::printf("  %-22s %s, %.1f us\n", "end of the run", ending(s), s.simulated_us);
  if (s.fragments.plug_mass > 0 && s.fragments.plug_velocity > 0)
    std::printf("  %-22s %.3g g at %.1f m/s, debris %.3g g\n", "plug", s.fragments.plug_mass * 1e3,
                s.fragments.plug_velocity, s.fragments.debris_mass * 1e3);
  for (const PartResult &part : s.parts)
    if (!part.is_followed)
      std::printf("  %-22s %.3g g at %.1f m/s\n", part.name.c_str(), part.mass_g, part.velocity_mps);
  if (s.removed_hexes > 0)
    std::printf("  %-22s %ld of those computed, %.3g g, %.2g %% of the projectile\n", "removed hexes", s.removed_hexes,
                s.removed_mass_g, 100 * s.removed_mass_g / s.sizes.projectile_mass_g);
  for (std::size_t k = 0; k < o.layers_mm.size(); ++k)
    std::printf("  %-22s %.2f g at %.1f m/s, %g mm of %s\n", ("  of plate " + std::to_string(k + 1)).c_str(),
                s.layers[k].fragments.plug_mass * 1e3, s.layers[k].fragments.plug_velocity, o.layers_mm[k],
                s.layers[k].material.c_str());
  if (o.damage != DamageLaw::none)
    std::printf("  %-22s %.2f g, %ld of the particles computed\n", "failed", s.fragments.failed_mass * 1e3,
                static_cast<long>(s.fragments.failed));
  if (const auto rest = dishing_at_rest_mm(s))
    std::printf("  %-22s %.2f mm at rest, mean over %.0f us\n", "dishing", *rest, s.swing.until_us - s.swing.begun_us);
  std::printf("  %-22s %.4f %%\n", "largest energy error", s.energy_error * 100);
  std::printf("  %-22s %.1e\n", "momentum error", s.momentum_error);
  std::printf("  %-22s %.3f mm\n", "deepest intrusion", s.intrusion_mm);
  std::printf("  %-22s %.1f s, %ld steps, %.0f ns per particle and step, %.0f MB\n", "cost", s.wall_s, s.steps,
              ns_per_particle_step(s), peak_memory_mb());
  std::printf("  %-22s %s\n", "shares", shares(s).c_str());
  std::printf("  %-22s %s\n", "files", o.out.string().c_str());
  // The pictures come next; who reads through a pipe need not wait for them.
  std::fflush(stdout);
}

} // namespace shot
