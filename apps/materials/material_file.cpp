// SPDX-License-Identifier: BSD-3-Clause
#include "material_file.hpp"

#include "material_keys.hpp"
#include "options/toml_file.hpp"

#include "ogive/material/doubts.hpp"

#include <unordered_set>

namespace materials {

namespace {

using options::Given;
using options::printable;

/// A name is a title in pictures and tables.
constexpr std::size_t longest_name = 80, longest_source = 2000;

const Given *find(const std::vector<Given> &entries, std::string_view key) {
  for (const Given &given : entries)
    if (given.key == key) return &given;
  return nullptr;
}

/// Keys of a file that do not fit its model.
struct Misfits {
  std::vector<std::string> missing, superfluous;
};

template <class M> Misfits find_misfits(const M &metal, const std::vector<Given> &entries) {
  const auto group_is_given = [&](Group group) {
    bool any = group == Group::always;
    for_each_key(metal, [&](const Key &key, const auto &) {
      any = any || (key.group == group && find(entries, key.name) != nullptr);
    });
    return any;
  };
  Misfits misfits;
  // Without an effect of the rate there is no rate that it refers to.
  const Given *C = find(entries, "C");
  const bool no_rate = C != nullptr && options::number_from(C->value) == 0.0;
  const auto is_of_rate = [](std::string_view key) { return key == "reference_rate_per_s" || key == "rate_factor"; };
  for_each_key(metal, [&](const Key &key, const auto &) {
    const bool needed = key.required && !(no_rate && is_of_rate(key.name));
    if (needed && group_is_given(key.group) && find(entries, key.name) == nullptr)
      misfits.missing.emplace_back(key.name);
  });
  for (const Given &given : entries) {
    bool known = false;
    for_each_key(metal, [&](const Key &key, const auto &) { known = known || given.key == key.name; });
    if (!known) misfits.superfluous.push_back(given.key);
  }
  return misfits;
}

/// The entries that two lists have in common, in the order of the first.
std::vector<std::string> common(std::vector<std::string> a, const std::vector<std::string> &b) {
  const std::unordered_set<std::string> in_b(b.begin(), b.end());
  std::erase_if(a, [&](const std::string &name) { return !in_b.contains(name); });
  return a;
}

/// "lacks a, b and does not know n, m"
std::string text_of(const Misfits &misfits) {
  const auto listed = [](const std::string &before, std::vector<std::string> names) {
    const std::size_t count = names.size(), most = 40;
    names.resize(std::min(count, most));
    for (std::string &name : names) name = printable(name);
    return count == 0 ? ""
                      : before + options::joined(names) +
                            (count > most ? " and " + std::to_string(count - most) + " more" : "");
  };
  std::vector<std::string> parts{listed("lacks ", misfits.missing), listed("does not know ", misfits.superfluous)};
  std::erase(parts, "");
  return options::joined(parts, " and ");
}

/// "its keys are ...; optional are ..., with + between those that belong together"
template <class M> std::string keys_of(const M &metal) {
  std::string needed, optional;
  Group last = Group::always;
  for_each_key(metal, [&](const Key &key, const auto &) {
    if (key.group == Group::always && key.required) {
      needed += (needed.empty() ? "" : ", ") + std::string(key.name);
    } else {
      const bool belongs = key.group != Group::always && key.group == last;
      optional += (optional.empty() ? "" : belongs ? " + " : ", ") + std::string(key.name);
      last = key.group;
    }
  });
  return "its keys are " + needed + "; optional are " + optional + ", with + between those that belong together";
}

/// Calls f(metal) with an empty metal of the model's type.
template <class F> AnyMetal with_model(Model model, F &&f) {
  switch (model) {
  case Model::mjc:
    return f(std::variant_alternative_t<0, AnyMetal>{});
  case Model::jc:
    return f(std::variant_alternative_t<1, AnyMetal>{});
  case Model::voce:
    return f(std::variant_alternative_t<2, AnyMetal>{});
  case Model::power_law:
    return f(std::variant_alternative_t<3, AnyMetal>{});
  case Model::bilinear:
    break;
  }
  return f(std::variant_alternative_t<4, AnyMetal>{});
}

/// Refuses a file without a model: names what every model would miss or not know.
[[noreturn]] void refuse_without_model(const std::vector<Given> &entries, const std::string &file) {
  Misfits any;
  for (const auto &model : models)
    with_model(model.value, [&](auto metal) -> AnyMetal {
      const Misfits misfits = find_misfits(metal, entries);
      const bool is_first = model.value == models.front().value;
      any.missing = is_first ? misfits.missing : common(any.missing, misfits.missing);
      any.superfluous = is_first ? misfits.superfluous : common(any.superfluous, misfits.superfluous);
      return metal;
    });
  throw ogive::SetupError(printable(file) + ": " + text_of(any) + "; model must be one of " +
                          options::names_in(models) + " and decides which keys there are");
}

void assign(const Key &key, double &value, const Given &given) {
  options::number_within(given, key.limits);
  // A zero added makes 0 of -0, which TOML has for real numbers only.
  value = *options::number_from(given.value, key.power) + 0.0;
}

void assign(const Key &key, std::string &value, const Given &given) {
  const std::size_t longest = key.required ? longest_name : longest_source;
  const std::string allowed = "text of at most " + std::to_string(longest) + " characters";
  value = options::line_given(given, allowed);
  if (value.size() > longest) refuse(given, "must be " + allowed);
}

void assign(const Key &, ogive::RateFactor &value, const Given &given) {
  value = options::choice_given(given, rate_factors);
}

void assign(const Key &, ogive::FailureRateTerm &value, const Given &given) {
  value = options::choice_given(given, rate_terms);
}

/// The model has chosen the type already.
void assign(const Key &, const Model &, const Given &) {}

/// Fills in what a law takes from the rest of its metal.
template <class M> void complete(M &) {}
void complete(ogive::Metal<double, ogive::PowerLaw<double>> &metal) { metal.flow.modulus = metal.elasticity.young; }

/// Checks what belongs together in the hardening of a law.
template <class Law> void check_hardening(const Law &law, const std::vector<Given> &entries) {
  if (!(law.A + law.B > 0)) refuse(*find(entries, "A_MPa"), "A_MPa or B_MPa must be positive");
}
void check_hardening(const ogive::Voce<double> &law, const std::vector<Given> &entries) {
  if (!(law.A + std::min(law.Q1, 0.0) + std::min(law.Q2, 0.0) > 0))
    refuse(*find(entries, "A_MPa"), "must be positive, with Q1_MPa and Q2_MPa where those are negative");
}
void check_hardening(const ogive::PowerLaw<double> &, const std::vector<Given> &) {}
void check_hardening(const ogive::Bilinear<double> &law, const std::vector<Given> &entries) {
  if (!(law.yield > 0)) refuse(*find(entries, "yield_MPa"), "must be positive");
}

/// Checks what belongs together, the constants of damage as if they were used.
template <class M> void check_all(M metal, const std::vector<Given> &entries, const std::string &file) {
  check_hardening(metal.flow, entries);
  if (!(metal.melting_temperature > metal.room_temperature))
    refuse(*find(entries, "melting_temperature_K"), "must lie above room_temperature_K");
  if (const Given *D1 = find(entries, "D1"))
    if (!(metal.damage.failure_strain.D1 > 0 || metal.damage.failure_strain.D2 > 0))
      refuse(*D1, "D1 or D2 must be positive");
  try {
    check(metal);
  } catch (const ogive::SetupError &error) {
    throw ogive::SetupError(printable(file) + ": " + error.what());
  }
}

template <class M> M metal_from(M metal, const std::vector<Given> &entries, const std::string &file) {
  const Misfits misfits = find_misfits(metal, entries);
  if (!misfits.missing.empty() || !misfits.superfluous.empty())
    throw ogive::SetupError(printable(file) + ": model \"" + name_of(model_of(metal.flow)) + "\" " + text_of(misfits) +
                            "; " + keys_of(metal));
  for_each_key(metal, [&](const Key &key, auto &value) {
    if (const Given *given = find(entries, key.name)) assign(key, value, *given);
  });
  complete(metal);
  check_all(metal, entries, file);
  return metal;
}

std::string toml_value(const Key &key, double value) { return text_of(key, value); }
template <class V> std::string toml_value(const Key &key, const V &value) {
  return options::toml_string(text_of(key, value));
}

/// Text on lines of a comment.
std::string commented(const std::string &text) {
  std::string lines = "# ";
  for (const char c : text)
    if (c == '\n')
      lines += "\n# ";
    else
      lines += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  return text.empty() ? "" : lines + "\n";
}

/// The lines with the metal's name in front.
std::vector<std::string> named(const AnyMetal &any, std::vector<std::string> lines) {
  for (std::string &line : lines) line = printable(name_of(any)) + ": " + line;
  return lines;
}

} // namespace

AnyMetal read(const std::filesystem::path &file, const std::string &what) {
  return parse(options::text_of_file(file, what), file.string());
}

AnyMetal parse(std::string_view text, const std::string &file) {
  const auto entries = options::toml_entries(text, file, "A_MPa = 503.0");
  const Given *model = find(entries, "model");
  if (model == nullptr) refuse_without_model(entries, file);
  return with_model(options::choice_given(*model, models),
                    [&](auto metal) -> AnyMetal { return metal_from(std::move(metal), entries, file); });
}

std::string to_toml(const AnyMetal &any, const std::string &comment) {
  std::string text = commented(comment);
  std::visit(
      [&](const auto &metal) {
        for_each_key(metal, [&](const Key &key, const auto &value) {
          if (!has(metal, key.group)) return;
          if (!key.required && text_of(key, value).empty()) return;
          std::string line = std::string(key.name) + " = " + toml_value(key, value);
          if (*key.meaning != 0) {
            line.resize(std::max<std::size_t>(line.size() + 1, 40), ' ');
            line += std::string("# ") + key.meaning;
          }
          text += line + "\n";
        });
      },
      any);
  return text;
}

std::vector<std::string> doubts_of_flow(const AnyMetal &any) {
  return named(any, std::visit([](const auto &metal) { return ogive::doubts_of_flow(metal); }, any));
}

std::vector<std::string> doubts_of_damage(const AnyMetal &any) {
  if (!has(any, Group::strain)) return {};
  return named(any, std::visit([](const auto &metal) { return doubts_of(metal.damage.failure_strain); }, any));
}

Model model_of(const AnyMetal &any) {
  return std::visit([](const auto &metal) { return model_of(metal.flow); }, any);
}

std::string name_of(Model model) { return options::name_in(models, model); }

std::string title_of_model(std::string_view name) {
  constexpr auto titles = options::named<std::string_view>({{"mjc", "modified Johnson-Cook"},
                                                            {"jc", "Johnson-Cook"},
                                                            {"voce", "Voce"},
                                                            {"power_law", "power law"},
                                                            {"bilinear", "bilinear hardening"}});
  const std::string title = options::name_in(titles, name);
  return title.empty() ? std::string(name) : title;
}

const std::string &name_of(const AnyMetal &any) {
  return std::visit([](const auto &metal) -> const std::string & { return metal.name; }, any);
}

} // namespace materials
