// SPDX-License-Identifier: BSD-3-Clause
#include "catch.hpp"
#include "io/temporary_folder.hpp"
#include "sim/small_shot.hpp"

#include "ogive/io/checkpoint.hpp"
#include "ogive/perforation/shape.hpp"

#include <algorithm>
#include <functional>
#include <omp.h>
#include <tuple>

using namespace sim_test;

namespace {

constexpr double end_time = 12e-6;

// The model of the programs; that of types which are chosen when they are compiled is in threads.cpp.
using Shot = AnyPerforationModel<double>;

Shot any_shot(FailureEffect effect, bool rigid, Nose nose = Nose::conical, const AnyDiscretisation &parts = {}) {
  return full_shot(effect, rigid, nose, parts);
}

/// What a run's observer has seen.
struct Seen {
  std::vector<double> numbers;
  bool operator==(const Seen &) const = default;
};

auto observer_into(Seen &seen) {
  return [&](const Shot &model, const Energy<double> &e) {
    for (const double number :
         {model.time, double(model.steps), e.kinetic, e.elastic, e.plastic, e.hourglass, e.viscous, e.contact,
          e.friction, model.support_impulse[2], find_fragments(model).plug_mass})
      seen.numbers.push_back(number);
    return true;
  };
}

const RunOptions<double> options{.end_time = end_time};

/// All bytes of the state but the wall times.
std::string state_bytes(const Shot &model, const RunState<double> &run) {
  checkpoint_detail::StateWriter writer;
  for_each_state_field(model, run, writer);
  std::string bytes;
  for (const auto piece : writer.pieces)
    if (piece.size() != sizeof model.times.seconds) bytes += piece;
  return bytes;
}

/// Runs a model, stops it for a checkpoint at each of `stops` (steps) and goes on in a model built anew, with another
/// number of threads; compares with a run that never stopped.
void compare(const std::function<Shot()> &make, const std::vector<std::int64_t> &stops) {
  const TemporaryFolder folder;
  const int threads = omp_get_max_threads();
  omp_set_num_threads(2);
  auto whole = make();
  const auto first_lists = plate_positions(whole);
  RunState<double> whole_run;
  Seen seen, seen_whole;
  run(whole, options, whole_run, observer_into(seen_whole), [](const auto &, const auto &) { return false; });
  REQUIRE(whole.steps > stops.back() + 5);

  auto model = make();
  RunState<double> state;
  int number = 1;
  for (const std::int64_t stop : stops) {
    omp_set_num_threads(number++ % 4 + 1);
    const auto result =
        run(model, options, state, observer_into(seen), [&](const auto &m, const auto &) { return m.steps == stop; });
    REQUIRE(result.reason == StopReason::pause);
    REQUIRE(model.steps == stop);
    write_checkpoint(folder.path / "c", model, state, "notes");
    auto fresh = make();
    RunState<double> fresh_state;
    const Checkpoint checkpoint = read_checkpoint(folder.path / "c");
    CHECK(checkpoint.notes == "notes");
    restore(checkpoint, fresh, fresh_state);
    CHECK(state_bytes(fresh, fresh_state) == state_bytes(model, state));
    CHECK(plate_particles(fresh).neighbours.list == plate_particles(model).neighbours.list);
    CHECK(fresh.contacts[0].candidates.facets == model.contacts[0].candidates.facets);
    CHECK(fresh.contacts[0].candidates.active == model.contacts[0].candidates.active);
    CHECK(total(energy(fresh)) == total(energy(model)));
    model = std::move(fresh), state = fresh_state;
  }
  omp_set_num_threads(threads);
  const auto result = run(model, options, state, observer_into(seen), [](const auto &, const auto &) { return false; });
  CHECK(result.reason == StopReason::end_time);
  CHECK(state_hash(model) == state_hash(whole));
  CHECK(state_bytes(model, state) == state_bytes(whole, whole_run));
  CHECK(seen == seen_whole);
  CHECK(total(energy(model)) == total(energy(whole)));

  // The features are there: otherwise this would prove little.
  const auto &[metal, points] = std::tie(plate_particles(whole).metal, plate_particles(whole).points);
  Index failed = 0;
  for (const double damage : points.damage) failed += is_failed(metal.damage, damage);
  CHECK(failed > 3);
  if (has_bands(metal.shear_band))
    CHECK(std::count_if(points.shear_strain.begin(), points.shear_strain.end(),
                        [onset = metal.shear_band.onset](double strain) { return strain > onset; }) > 3);
  if (has_bands(metal.shear_band))
    CHECK(std::count_if(points.band_age.begin(), points.band_age.end(), [](double age) { return age > 0; }) > 3);
  CHECK(energy(whole).friction > 0);
  CHECK(plate_particles(whole).neighbours.built_at != first_lists);
  CHECK(plate_particles(whole).neighbours.images.size() > 20);
}

} // namespace

TEST_CASE("a restarted shot ends with the bits of one that never stopped", "[sim]") {
  // At the start, one step later, between the looks at time step and state, right at and after them.
  SECTION("one point in each hex, deformable projectile, removal") {
    compare([] { return any_shot(FailureEffect::removal, false); }, {0, 1, 7, 20, 23, 61, 100});
  }
  SECTION("selective reduced hexes, rigid projectile, no tension") {
    compare([] { return any_shot(FailureEffect::no_tension, true, Nose::conical, {.rule = SelectiveReduced{}}); },
            {3, 33, 59});
  }
  SECTION("a rigid projectile that turns, removal") {
    const auto plate = brittle(library::weldox_460e_mjc<double>(), FailureEffect::removal);
    const auto make = [&] {
      return make_perforation(turning_case(Extent::half), std::vector{with_law<AnyFlowLaw<double>>(plate)},
                              with_law<AnyFlowLaw<double>>(library::arne_tool_steel<double>()), {},
                              AnyDiscretisation{});
    };
    CHECK(turns(make().rigid_parts[0]));
    compare(make, {0, 41});
  }
  SECTION("standard form, blunt nose, removal") {
    compare([] { return any_shot(FailureEffect::removal, false, Nose::blunt, {.form = StandardForm{}}); }, {2, 91});
  }
}

TEST_CASE("a run that is paused in memory goes on as if there had been no pause", "[sim]") {
  auto whole = any_shot(FailureEffect::removal, true), model = whole;
  Seen seen, seen_whole;
  run(whole, options, observer_into(seen_whole));
  RunState<double> state;
  int pauses = 0;
  for (;; ++pauses) {
    bool first = true; // one step after each pause
    const auto result = run(model, options, state, observer_into(seen),
                            [&](const auto &, const auto &) { return !std::exchange(first, false); });
    if (result.reason == StopReason::end_time) break;
    REQUIRE(result.reason == StopReason::pause);
  }
  CHECK(pauses == whole.steps);
  CHECK(state_hash(model) == state_hash(whole));
  CHECK(seen == seen_whole);
}

TEST_CASE("a run goes on beyond the end that it was given first", "[sim]") {
  const TemporaryFolder folder;
  auto whole = any_shot(FailureEffect::removal, true), model = whole;
  const auto fresh = whole;
  run(whole, options, [](const auto &, const auto &) { return true; });
  RunState<double> state;
  const auto save_at_end = [&](const auto &m, const auto &s) {
    if (m.time >= 5e-6) write_checkpoint(folder.path / "end", m, s);
    return false;
  };
  run(
      model, RunOptions<double>{.end_time = 5e-6}, state, [](const auto &, const auto &) { return true; }, save_at_end);
  model = fresh;
  restore(read_checkpoint(folder.path / "end"), model, state);
  CHECK(model.time >= 5e-6);
  run(
      model, options, state, [](const auto &, const auto &) { return true; },
      [](const auto &, const auto &) { return false; });
  CHECK(state_hash(model) == state_hash(whole));
}
