// SPDX-License-Identifier: BSD-3-Clause
#include "card_text.hpp"

namespace cards {

namespace {

/// An option with its parameters and its lines of data.
struct Option {
  std::string name; ///< "*PLASTIC"
  std::vector<std::string> parameters;
  std::size_t line = 0;
  std::vector<Line> data;
};

/// The options of a file; blanks and small letters have no meaning in them.
std::vector<Option> options_of(std::string_view text) {
  std::vector<Option> all;
  bool continues = false;
  for (const Line &line : lines_of(text, "**")) {
    if (!line.text.starts_with('*') && !continues) {
      if (!all.empty()) all.back().data.push_back(line);
      continue;
    }
    const std::string squeezed_line = squeezed(line.text);
    auto parts = ::options::split(squeezed_line, ',');
    if (!continues) {
      all.push_back({parts.front(), {}, line.number, {}});
      parts.erase(parts.begin());
    }
    std::erase(parts, "");
    all.back().parameters.insert(all.back().parameters.end(), parts.begin(), parts.end());
    continues = squeezed_line.ends_with(',');
  }
  return all;
}

/// Value of a parameter of a keyword line; empty if the line lacks it.
std::string parameter(const Option &option, const std::string &name) {
  for (const std::string &p : option.parameters)
    if (p.starts_with(name + "=")) return p.substr(name.size() + 1);
  return "";
}

bool is_plasticity(const Option &o) { return o.name == "*PLASTIC" && parameter(o, "HARDENING") == "JOHNSONCOOK"; }

/// The numbers of an option in the order of `names`; further lines, which are for other temperatures, are left out.
std::vector<std::optional<Number>> numbers_of(const Option &option, const std::vector<std::string> &names, Card &card,
                                              const std::string &file) {
  std::vector<std::optional<Number>> numbers(names.size());
  if (option.data.empty()) refuse_line(file, option.line, option.name + ": has no data");
  const auto fields = ::options::split(option.data.front().text, ',');
  for (std::size_t k = 0; k < std::min(fields.size(), names.size()); ++k)
    numbers[k] = number_in(fields[k], names[k], file, option.data.front().number);
  if (option.data.size() > 1)
    card.dropped.push_back(option.name + ": further lines from line " + std::to_string(option.data[1].number));
  return numbers;
}

/// The options of the one material with this plasticity.
std::vector<Option> material_of(std::string_view text, Card &card, const std::string &file) {
  std::vector<Option> found, now;
  std::string name;
  const auto close = [&] {
    for (const Option &o : now)
      if (is_plasticity(o)) {
        if (card.line > 0)
          refuse_line(file, o.line,
                      "is a second material of this kind, the first is in line " + std::to_string(card.line) +
                          "; keep one of them");
        card.line = o.line, card.title = title_of(name), found = now;
      }
    now.clear();
  };
  for (Option &o : options_of(text)) {
    if (o.name == "*MATERIAL") {
      close();
      name = parameter(o, "NAME");
    } else {
      now.push_back(std::move(o));
    }
  }
  close();
  return found;
}

} // namespace

Card read_abaqus(std::string_view text, const std::string &file) {
  Card card{.format = "Abaqus *PLASTIC, HARDENING=JOHNSON COOK"};
  for (const Option &o : material_of(text, card, file)) {
    const auto numbers = [&](const std::vector<std::string> &names) { return numbers_of(o, names, card, file); };
    if (is_plasticity(o)) {
      const auto n = numbers({"A", "B", "n", "m", "melting temperature", "transition temperature"});
      card.A = n[0], card.B = n[1], card.n = n[2], card.m = n[3], card.melting = n[4], card.room = n[5];
    } else if (o.name == "*RATEDEPENDENT") {
      if (parameter(o, "TYPE") != "JOHNSONCOOK")
        refuse_line(file, o.line, "*RATE DEPENDENT: must have TYPE=JOHNSON COOK, others cannot be imported");
      const auto n = numbers({"C", "reference rate"});
      card.C = n[0], card.reference_rate = n[1];
    } else if (o.name == "*DAMAGEINITIATION" && parameter(o, "CRITERION") == "JOHNSONCOOK") {
      const auto n = numbers({"d1", "d2", "d3", "d4", "d5", "melting temperature", "transition temperature",
                              "reference rate of the damage"});
      card.damage.clear();
      for (std::size_t k = 0; k < 5; ++k)
        card.damage.push_back(n[k].value_or(Number{"d" + std::to_string(k + 1), "0", 0, o.line}));
      card.damage_reference_rate = n[7];
      card.negates_D3 = true;
      const auto differs = [](const auto &a, const auto &b) {
        return is_given(a) && is_given(b) && a->value != b->value;
      };
      if (differs(n[5], card.melting) || differs(n[6], card.room))
        card.dropped.push_back("temperatures of the damage (line " + std::to_string(o.line) +
                               "): those of the plasticity hold for both");
    } else if (o.name == "*DENSITY") {
      card.density = numbers({"density"})[0];
    } else if (o.name == "*ELASTIC") {
      const std::string type = parameter(o, "TYPE");
      if (!type.empty() && type != "ISOTROPIC" && type != "ISO")
        refuse_line(file, o.line, "*ELASTIC: must be isotropic");
      const auto n = numbers({"Young's modulus", "Poisson's ratio"});
      card.young = n[0], card.poisson = n[1];
    } else if (o.name == "*SPECIFICHEAT") {
      card.specific_heat = numbers({"specific heat"})[0];
    } else if (o.name == "*INELASTICHEATFRACTION") {
      card.heat_fraction = numbers({"inelastic heat fraction"})[0];
    } else {
      const std::string parameters = o.parameters.empty() ? "" : ", " + ::options::joined(o.parameters);
      card.dropped.push_back(::options::printable(o.name + parameters) + " (line " + std::to_string(o.line) + ")");
    }
  }
  return card;
}

} // namespace cards
