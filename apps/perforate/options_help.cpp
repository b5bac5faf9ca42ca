// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"
#include "options_material.hpp"
#include "options_table.hpp"

namespace perforate {

namespace {

using input::help_item;

std::string shown(double value) { return shortest(value); }
std::string shown(const std::string &value) { return value; }
std::string shown(const std::vector<double> &) { return "none"; }
std::string shown(const std::vector<std::string> &) { return "none"; }
std::string shown(bool value) { return value ? "yes" : "no"; }
template <class E> std::string shown(E value) { return choice_name(value); }

std::string placeholder(double) { return " X"; }
std::string placeholder(const std::string &) { return " NAME|FILE.toml"; }
std::string placeholder(bool) { return ""; }
std::string placeholder(const std::optional<double> &) { return " X"; }
std::string placeholder(const std::optional<int> &) { return " N"; }
std::string placeholder(const std::filesystem::path &) { return " FOLDER"; }
std::string placeholder(const std::vector<double> &) { return " X,X,..."; }
std::string placeholder(const std::vector<std::string> &) { return " NAME,NAME,..."; }
template <class E> std::string placeholder(E) { return " NAME"; }

std::string allowed(const Entry &entry, double) { return "; " + text_of(entry.limits, " to "); }
std::string allowed(const Entry &entry, const std::optional<double> &) { return allowed(entry, 0.0); }
std::string allowed(const Entry &entry, const std::optional<int> &) { return "; " + text_of(entry.limits, " to "); }
std::string allowed(const Entry &entry, bool) { return "; --no-" + flag_of(entry.key).substr(2) + " for not"; }
std::string allowed(const Entry &, const std::filesystem::path &) { return ""; }
std::string allowed(const Entry &, const std::string &) {
  return ": " + allowed_materials() + "; \"list\" prints all constants of the library";
}
std::string allowed(const Entry &entry, const std::vector<double> &) {
  return "; numbers " + text_of(entry.limits, " to ") + " with commas between them";
}
std::string allowed(const Entry &, const std::vector<std::string> &) {
  return ": as for --material, with commas between them";
}
template <class E> std::string allowed(const Entry &, E kind) { return ": " + choice_names(kind); }

/// The default and its source; where the default depends on other options the source says all.
template <class V> std::string default_text(const Entry &entry, const V &value) {
  if constexpr (requires { shown(value); } && !std::is_same_v<V, std::filesystem::path> && !is_optional<V>)
    if (std::string_view(entry.source).find(':') == std::string_view::npos)
      return " [" + shown(value) + ": " + entry.source + "]";
  return std::string(" [") + entry.source + "]";
}

} // namespace

std::string help() {
  std::string text = "perforate [options]: a projectile strikes a clamped metal plate.\n\n"
                     "Prints the residual velocity and writes the frames, a section picture and case.toml.\n"
                     "In brackets: the default, and where it comes from. \"paper\" is Liu, Swaddiwudhipong & Islam,\n"
                     "Nucl. Eng. Des. 250 (2012) 108-115; \"tests\" are those that it compares with.\n";
  Options defaults;
  const char *group = "";
  for_each_option(defaults, [&](const Entry &entry, auto &value) {
    if (group != entry.group) text += std::string("\n") + entry.group + ":\n";
    group = entry.group;
    text += help_item(flag_of(entry.key) + placeholder(value),
                      entry.meaning + allowed(entry, value) + default_text(entry, value));
  });
  text += "\nGeneral:\n";
  text += help_item("--config FILE.toml", "read options from FILE.toml, under the names of the flags with underscores "
                                          "(thickness_mm = 12.0); the command line overrides them");
  std::string checkpoint = checkpoint_name;
  text +=
      help_item("--restart FILE", "go on from FILE, the " + checkpoint +
                                      " of a run that was interrupted, to the bits of one that was not. The case is "
                                      "FILE's, the results go on in its folder; only --end-us, --out, "
                                      "--output-every-us, --checkpoint-every-us, --vtk, --picture, --quiet and "
                                      "--threads may be given anew");
  text += help_item("--resume", "go on from the " + checkpoint +
                                    " in the folder for the results, if an interrupted run of this very case left one "
                                    "there; else begin");
  text += help_item("--version", "print the version");
  text += help_item("--help", "print this text");
  text += "\nCommands:\n";
  text +=
      help_item("limit", "find the ballistic limit of a case by bisection, shoot some times above it, print and draw "
                         "the fitted curve of the residual velocity; options as above, --velocity-mps is the first "
                         "shot [90 + 9 for each mm of the plate: ours], --width-mps X that of the bracket "
                         "[5: ours]. Run again, it goes on");
  text += help_item("mesh", "write the model of a case for ParaView and print its sizes and the quality of the hexes, "
                            "without running it; options as above");
  text += "\nExamples:\n"
          "  perforate\n"
          "  perforate --material aa5083_h116 --nose conical --thickness-mm 15 --velocity-mps 214\n"
          "  perforate --layers-mm 6,6 --gaps-mm 10 --velocity-mps 250\n"
          "  perforate --layers-mm 4,8 --layer-materials weldox_460e,aa5083_h116\n"
          "  perforate --material my_steel.toml --thickness-mm 10 --damage jc\n"
          "  perforate --nose ogival --diameter-mm 7.62 --calibre-radius-head 3 --mass-g 10 --obliquity-deg 30\n"
          "            --extent half --thickness-mm 6 --velocity-mps 800\n"
          "  perforate limit --thickness-mm 8\n"
          "  perforate --config vtk_out/my_case/case.toml --velocity-mps 250 --out vtk_out/my_case_250\n"
          "  perforate --restart vtk_out/my_case/" +
          checkpoint +
          "\n"
          "\nExit status: 0 done; 2 wrong input, nothing was run or overwritten; 3 stopped by a fault in the\n"
          "run or by a file that could not be written, after a last frame; 130, 143 or 129 interrupted by\n"
          "SIGINT (Ctrl-C), SIGTERM or SIGHUP, after a checkpoint and a last frame; 1 anything else.\n";
  return text;
}

} // namespace perforate
