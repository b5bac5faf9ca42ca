// SPDX-License-Identifier: BSD-3-Clause
#include "report.hpp"

#include "ogive/core/pack.hpp"
#include "ogive/version.hpp"

#include <nlohmann/json.hpp>
#include <omp.h>

#include <cstdio>

namespace bench {

namespace {

using Json = nlohmann::ordered_json;
using ogive::Phase;

Json of_nearness(const PairArithmetic &arithmetic, std::int64_t entries, double bytes, double seconds,
                 const Limits &limits) {
  const Nearness n = nearness(arithmetic, entries, bytes, seconds, limits);
  return {{"flop_per_lane_pair", arithmetic.flops},
          {"instructions_per_lane_pair", arithmetic.instructions},
          {"flop_per_s", n.flops},
          {"share_of_peak", n.of_peak},
          {"share_of_units", n.instructions},
          {"bytes", bytes},
          {"byte_per_s", n.bytes},
          {"share_of_triad", n.of_triad},
          {"bound_by", bound(n)}};
}

Json of_timing(const Timing &t, const ShotResult &shot, const Limits &limits) {
  const Work &w = shot.work;
  Json phases;
  for (std::size_t k = 0; k < ogive::phase_count; ++k)
    phases[std::string(ogive::name(static_cast<Phase>(k)))] = t.phases[k];
  char hash[32];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(t.hash));
  const auto per = [&](Phase phase, std::int64_t parts) { return t[phase] * 1e9 / static_cast<double>(parts); };
  return {{"threads", t.threads},
          {"rounds", t.rounds},
          {"step_s", t.step},
          {"step_ns_per_particle", t.step * 1e9 / static_cast<double>(w.particles)},
          {"speed_up", shot.timings[0].step / t.step},
          {"spread", t.spread},
          {"phases_s", phases},
          {"gradient_ns_per_pair", per(Phase::gradient, w.pairs)},
          {"force_ns_per_pair", per(Phase::force, w.pairs)},
          {"gradient_ns_per_lane_pair", per(Phase::gradient, w.listed * ogive::lanes<double>)},
          {"force_ns_per_lane_pair", per(Phase::force, w.within * ogive::lanes<double>)},
          {"hexes_ns_per_element", per(Phase::hexes, shot.hexes)},
          {"contact_ns_per_slave", per(Phase::contact, shot.slaves)},
          {"rebuild_s", t.rebuild},
          {"gradient", of_nearness(gradient_arithmetic, w.listed, w.gradient_bytes, t[Phase::gradient], limits)},
          {"force", of_nearness(force_arithmetic, w.within, w.force_bytes, t[Phase::force], limits)},
          {"stress_byte_per_s", w.stress_bytes / t[Phase::stress]},
          {"state_hash", hash}};
}

Json of_shot(const ShotResult &shot, const std::vector<Limits> &limits) {
  const Work &w = shot.work;
  const Memory &m = shot.memory;
  Json timings = Json::array();
  for (std::size_t k = 0; k < shot.timings.size(); ++k) timings.push_back(of_timing(shot.timings[k], shot, limits[k]));
  return {{"particles", w.particles},
          {"spacing_m", shot.spacing},
          {"images", w.images},
          {"hexes", shot.hexes},
          {"slaves", shot.slaves},
          {"flowing", w.flowing},
          {"pairs", w.pairs},
          {"clusters", w.clusters},
          {"listed", w.listed},
          {"within", w.within},
          {"start_time_s", shot.start_time},
          {"start_step", shot.start_step},
          {"steps", shot.steps},
          {"rebuilds", shot.timings[0].rebuilds},
          {"memory_bytes",
           {{"nodes", m.nodes},
            {"points", m.points},
            {"pair_data", m.pair_data},
            {"neighbours", m.neighbours},
            {"lists", m.lists},
            {"sum", sum(m)},
            {"process", m.process}}},
          {"equal_hashes", equal_hashes(shot)},
          {"timings", timings}};
}

} // namespace

std::string json(const Report &r) {
  Json limits = Json::array(), shots = Json::array();
  for (const Limits &l : r.limits)
    limits.push_back({{"threads", l.threads}, {"triad_byte_per_s", l.triad}, {"flop_per_s", l.arithmetic}});
  for (const ShotResult &shot : r.shots) shots.push_back(of_shot(shot, r.limits));
  const Json all{{"version", ogive::version},
                 {"cores", omp_get_num_procs()},
                 {"register_bits", 8 * ogive::register_bytes},
                 {"lanes", ogive::lanes<double>},
                 {"triad_bytes", r.triad_bytes},
                 {"repeats", r.repeats},
                 {"limits", limits},
                 {"pack_s",
                  {{"division", r.pack_times.division},
                   {"square_root", r.pack_times.root},
                   {"reciprocal", r.pack_times.reciprocal},
                   {"inverse_square_root", r.pack_times.inverse_root}}},
                 {"shots", shots}};
  return all.dump(2) + "\n";
}

} // namespace bench
