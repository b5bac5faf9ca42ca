// SPDX-License-Identifier: BSD-3-Clause
#include "commands.hpp"

#include "draw/film.hpp"
#include "options/exit_status.hpp"
#include "results.hpp"

#include "shot/files.hpp"
#include "shot/resume.hpp"
#include "shot/run.hpp"
#include "shot/signals.hpp"
#include "shot/table.hpp"

#include <iostream>

namespace commands {

const char *const exit_statuses =
    "Exit status: 0 done; 2 wrong input, nothing was run or overwritten; 3 stopped by a fault in a run\n"
    "or by a file that could not be written, after a last frame; 130, 143 or 129 interrupted by\n"
    "SIGINT (Ctrl-C), SIGTERM or SIGHUP, after a checkpoint and a last frame; 1 anything else.\n";

namespace {

/// Options of `ogive shoot` besides those of the case.
struct General {
  std::optional<std::string> restart;
  bool resume = false;
  std::filesystem::path animate;
};

// clang-format off
options::Table table_of(shot::Options &o, General &general) {
  options::Table t = shot::table_of(o);
  t.group = "General";
  options::add(t, general.restart, {.key = "restart",
      .meaning = "resume from FILE, the checkpoint.bin of a run that was interrupted; the results are "
      "bit-identical to those of an uninterrupted run. Only --end-us, --out, --output-every-us, "
      "--checkpoint-every-us, --vtk, --picture, --quiet and --threads may be given anew", .source = "none: begin",
      .brief = "resume from the checkpoint of an interrupted run", .allowed = "the name of a checkpoint file",
      .in_file = false}).placeholder = "FILE";
  options::add(t, general.resume, {.key = "resume", .meaning = "resume from the checkpoint.bin in the folder for "
      "the results if it is of an interrupted run of the same case; else begin", .source = "no: ours",
      .in_file = false});
  options::add(t, general.animate, {.key = "animate", .meaning = "draw a film of the run's section; needs ffmpeg",
      .source = "none: ogive draw --animate draws it later", .allowed = draw::film_names,
      .in_file = false}).placeholder = "FILE.mp4|webm|gif|apng";
  return t;
}
// clang-format on

/// Throws SetupError for a film that cannot be made of a run.
void check_film(const std::filesystem::path &film, const shot::Options &o) {
  if (film.empty()) return;
  const auto refuse = [&](const std::string &allowed) { options::refuse("--animate", film.string(), allowed); };
  if (!draw::is_film(film)) refuse(std::string("must be ") + draw::film_names);
  if (!o.vtk) refuse("needs the frames of the run, which --no-vtk leaves out");
  if (!draw::ffmpeg_available()) refuse("needs ffmpeg, which is not installed or not in PATH (Debian: ffmpeg)");
}

/// Draws the film of a run. The numbers are complete by then: what cannot be drawn is reported and left out.
void animate(const std::filesystem::path &film, const shot::Options &o) {
  try {
    draw::Film shown;
    shown.panel.title = case_title(o.out);
    shown.motion = motion_of(o.out);
    draw::render_film(ogive::read_series(find_pvd(o.out, "--out")), shown, film);
  } catch (const std::exception &error) {
    std::fprintf(stderr, "ogive shoot: left out: %s\n", error.what());
  }
}

} // namespace

options::Table shoot_table() { return unbound(table_of); }

std::optional<ShootCommand> parse_shoot(const options::Arguments &arguments, std::ostream &text) {
  const options::Command command{
      .name = "ogive shoot",
      .purpose = "Computes the impact of a projectile on a clamped metal plate. Prints the residual velocity and\n"
                 "writes frames for ParaView, pictures, summary.json and case.toml. \"paper\" is Liu, Swaddiwudhipong\n"
                 "& Islam, Nucl. Eng. Des. 250 (2012) 108-115; \"tests\" are the experiments that it compares with.\n",
      .usage = "[options]",
      .examples = "  ogive shoot --material aa5083_h116 --nose conical --thickness-mm 15 --velocity-mps 250\n"
                  "  ogive shoot --material my_steel.toml --thickness-mm 10 --method stabilised\n"
                  "  ogive shoot --config vtk_out/my_case/case.toml --velocity-mps 250 --out faster\n",
      .more = exit_statuses,
      .config = true};
  shot::Options defaults;
  General general;
  const options::Table table = table_of(defaults, general);
  const auto line = options::read_command_line(command, table, arguments, text);
  if (!line) return std::nullopt;
  options::Origins origins;
  for (const char *key : {"restart", "resume", "animate"})
    if (const options::Given *given = line->find(key)) options::apply(table, origins, *given);
  const auto with_film = [&](const shot::Options &o) {
    check_film(general.animate, o);
    return std::optional(ShootCommand{o, general.animate});
  };
  if (general.restart) {
    std::vector<options::Given> given = line->given;
    std::erase_if(given, [&](const options::Given &one) { return origins.contains(one.key); });
    if (line->config) given.insert(given.begin(), {"config", "--config", *line->config});
    return with_film(shot::restarted(*general.restart, given));
  }
  const shot::Options o = shot::settled(shot::levels_of(*line));
  std::error_code none;
  if (line->config && std::filesystem::equivalent(*line->config, o.out / "case.toml", none) &&
      options::text_of_file(*line->config, "--config") != shot::case_text(o))
    options::refuse("--config", *line->config,
                    "must not be case.toml in the folder for the results: that is overwritten");
  if (!general.resume) return with_film(o);
  const shot::Resumed resumed = shot::resumed(o);
  if (!resumed.obstacle.empty())
    options::refuse("--resume", o.out.string(),
                    "the checkpoint there cannot be resumed, " + resumed.obstacle +
                        "; give another --out, or leave --resume out to begin anew");
  return with_film(resumed.options);
}

int shoot(const options::Arguments &arguments) {
  const auto command = parse_shoot(arguments, std::cout);
  if (!command) return options::only_printed;
  shot::Outcome outcome;
  {
    const shot::SignalCatcher catcher;
    outcome = shot::run(command->shot, shot::Output::all);
  }
  if (!command->film.empty() && outcome.shot.interrupted_by == 0) animate(command->film, command->shot);
  return outcome.status;
}

} // namespace commands
