#include "tools/files/sweep_reader.h"

#include <algorithm>
#include <cmath>

#include "tools/files/failure.h"
#include "tools/files/json_pointer.h"
#include "tools/files/json_reader.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/text_file.h"
#include "tools/files/unknown_word.h"
#include "tools/platform/path.h"

namespace hyrax {
namespace {

// The number in the type of the key; nothing where that type does not hold it.
std::optional<SweepNumber> number_of(const VariedKey& key, const Json& json) {
  if (key.kind == ScenarioNumberKind::boolean) {
    const auto* const truth = json.get<bool>();
    return truth != nullptr ? std::optional(in_kind(key.kind, *truth ? 1 : 0)) : std::nullopt;
  }
  if (const auto* const name = json.get<std::string>()) {
    const auto found = std::ranges::find(key.names, *name);
    if (found == key.names.end()) return std::nullopt;
    return in_kind(key.kind, found - key.names.begin());
  }
  if (!json.is_number() || !std::isfinite(json.number())) return std::nullopt;
  const double value = json.number();
  if (key.kind == ScenarioNumberKind::real) return value;
  if (!json.is_whole()) return std::nullopt;
  const auto* const whole = json.get<std::uint64_t>();
  if (key.kind == ScenarioNumberKind::seed) {
    if (whole != nullptr) return *whole;
    return value >= 0.0 && value < 0x1p64 ? std::optional<SweepNumber>(static_cast<std::uint64_t>(value))
                                          : std::nullopt;
  }
  if (const auto* const negative = json.get<std::int64_t>()) return *negative;
  const bool is_held = whole != nullptr ? *whole >> 63 == 0 : std::fabs(value) < 0x1p63;
  if (!is_held) return std::nullopt;
  return whole != nullptr ? static_cast<std::int64_t>(*whole) : static_cast<std::int64_t>(value);
}

// What a value of the key must be.
std::string value_rule(const VariedKey& key) {
  if (key.kind == ScenarioNumberKind::boolean) return "must be true or false";
  std::string rule =
      key.kind == ScenarioNumberKind::real ? "must be a number" : "must be a whole number, as the key holds";
  if (!key.names.empty())
    rule += ", or one of " + listed(std::vector<std::string_view>(key.names.begin(), key.names.end()));
  return rule;
}

// [low, high], or [low, high, n].
std::optional<UniformDraw> read_range(const JsonPlace& here, const VariedKey& key, std::size_t size) {
  const Json::Array* const array = here.array();
  if (array == nullptr) return std::nullopt;
  if (array->size() == size) {
    const auto low = number_of(key, (*array)[0]);
    const auto high = number_of(key, (*array)[1]);
    if (low && high && *low <= *high) return UniformDraw{*low, *high};
  }
  return here.breaks_rule(
      std::string("must be ") + (size == 2 ? "[low, high]" : "[low, high, n]") + " with low <= high, " +
      (key.kind == ScenarioNumberKind::real ? "numbers" : "whole numbers, as the key holds"));
}

ChoiceDraw read_choice(const JsonPlace& here, const VariedKey& key) {
  ChoiceDraw choice;
  const Json::Array* const array = here.array();
  if (array == nullptr) return choice;
  if (array->empty()) here.wrong("must hold at least one number (found [])");
  for (std::size_t entry = 0; entry < array->size(); ++entry) {
    if (const auto number = number_of(key, (*array)[entry]))
      choice.values.push_back(*number);
    else
      here.element(entry).breaks_rule(value_rule(key));
  }
  return choice;
}

GridAxis read_grid(const JsonPlace& here, const VariedKey& key) {
  const auto range = read_range(here, key, 3);
  if (!range) return {};
  const GridAxis grid{range->low, range->high, here.element(2).integer(1, kMembersMax).value_or(1)};
  if (key.kind != ScenarioNumberKind::real && grid.count > 1 &&
      whole_distance(grid.low, grid.high) % static_cast<std::uint64_t>(grid.count - 1) != 0)
    here.breaks_rule("must give whole numbers only, as the key holds");
  return grid;
}

VariedKey read_key(const JsonPlace& here, VariedKey key) {
  const std::vector<std::string_view> variations = {"uniform", "choice", "grid", "member"};
  if (!here.is_object_of(variations)) return key;
  if (std::ranges::count_if(variations, [&](auto name) { return here.member(name).is_there(); }) != 1)
    here.wrong("must hold exactly one of uniform, choice, grid and member");
  if (key.kind == ScenarioNumberKind::boolean && !here.member("choice").is_there())
    here.breaks_rule("must be a choice of true and false, as the key holds");
  else if (const JsonPlace uniform = here.member("uniform"); uniform.is_there())
    key.variation = read_range(uniform, key, 2).value_or(UniformDraw{});
  else if (const JsonPlace choice = here.member("choice"); choice.is_there())
    key.variation = read_choice(choice, key);
  else if (const JsonPlace grid = here.member("grid"); grid.is_there())
    key.variation = read_grid(grid, key);
  else if (const JsonPlace member = here.member("member"); member.boolean() == false)
    member.breaks_rule("must be true");
  return key;
}

std::vector<VariedKey> read_vary(const JsonPlace& here, const SweptScenarios& scenarios) {
  std::vector<VariedKey> vary;
  here.each_member([&](const std::string& pointer, const JsonPlace& place) {
    if (pointer == "/expect" || pointer.starts_with("/expect/"))
      place.wrong("the members have no expect; it is dropped from the base");
    vary.push_back(read_key(place, scenarios.key_at(pointer)));
  });
  std::ranges::sort(vary, {}, &VariedKey::pointer);
  return vary;
}

KeepSet read_keep(const JsonPlace& here) {
  KeepSet keep;
  if (!here.is_there()) {
    for (const Keep each : {Keep::final, Keep::contacts, Keep::at_rest}) keep.add(each);
    return keep;
  }
  const Json::Array* const array = here.array();
  for (std::size_t entry = 0; array != nullptr && entry < array->size(); ++entry) {
    const JsonPlace place = here.element(entry);
    const auto name = place.text();
    const auto known = std::find(kKeepNames.begin(), kKeepNames.end(), name.value_or(""));
    if (known != kKeepNames.end())
      keep.add(static_cast<Keep>(known - kKeepNames.begin()));
    else if (name)
      place.wrong(unknown_word("value", *name, {kKeepNames.begin(), kKeepNames.end()}));
  }
  if (array != nullptr && array->empty()) here.wrong("must hold at least one value (found [])");
  return keep;
}

// A base inside the file needs no name; it is then the file's stem, as far as a name can have its characters.
std::string name_from(std::string_view stem) {
  std::string name;
  for (const char c : stem.substr(0, static_cast<std::size_t>(kNameLengthMax)))
    name += (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ? c : '-';
  return name;
}

// The base without `expect`; sets its path.
Json read_base(const JsonPlace& here, const std::string& source, std::string& base_path) {
  if (!here.is_there()) return {};
  Json base = *here.json();
  if (const auto* const path = here.json()->get<std::string>()) {
    const bool is_absolute = path->starts_with('/');
    base_path = (is_absolute ? "" : std::string(file_name(source).folder)) + *path;
    base = parse_json(read_text_file(base_path), base_path);
  }
  auto* const object = base.get<Json::Object>();
  if (object == nullptr) {
    here.wrong("must be a scenario, or the path of one");
    return base;
  }
  std::erase_if(*object, [](const auto& member) { return member.first == "expect"; });
  if (base.find("name") == nullptr)
    object->emplace_back("name", base_path.empty() ? name_from(file_name(source).stem)
                                                   : std::string(file_name(base_path).stem));
  return base;
}

// Members for which one value of a grid repeats, and with that the product of all counts.
std::int64_t set_repeats(const JsonPlace& vary, std::vector<VariedKey>& keys) {
  std::int64_t product = 1;
  for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
    auto* const grid = std::get_if<GridAxis>(&key->variation);
    if (grid == nullptr) continue;
    grid->repeats = product;
    if (grid->count > kMembersMax / product) {
      vary.wrong("the grids have more than 1e12 combinations");
      return 1;
    }
    product *= grid->count;
  }
  return product;
}

void read_members(const JsonPlace& document, SweepPlan& sweep) {
  const std::int64_t product = set_repeats(document.member("vary"), sweep.vary);
  const JsonPlace members = document.member("members");
  sweep.members = members.is_there() ? members.integer(1, kMembersMax).value_or(0) : product;
  if (sweep.members % product != 0)
    members.breaks_rule("must be a multiple of the grids' combinations, " + std::to_string(product));
}

// What a sweep document says, before any member is looked at.
SweepDocument read_document(const JsonPlace& document, const std::string& source,
                            const SweptScenarios& scenarios) {
  SweepDocument file;
  if (!document.is_object_of({"$schema", "format", "base", "members", "seed", "vary", "keep"})) return file;
  const auto format = document.required("format").text();
  if (format && *format != kSweepFormat)
    document.member("format").wrong(unknown_word("format", *format, {kSweepFormat}));
  file.base = read_base(document.required("base"), source, file.base_path);
  SweepPlan& sweep = file.plan;
  sweep.vary = read_vary(document.required("vary"), scenarios);
  read_members(document, sweep);
  const bool is_drawn = std::any_of(sweep.vary.begin(), sweep.vary.end(), [](const VariedKey& key) {
    return std::holds_alternative<UniformDraw>(key.variation) ||
           std::holds_alternative<ChoiceDraw>(key.variation);
  });
  sweep.seed = (is_drawn ? document.required("seed") : document.member("seed")).seed().value_or(0);
  sweep.keep = read_keep(document.member("keep"));
  return file;
}

Json json_of(const VariedKey& key, const SweepNumber& number) {
  if (key.kind == ScenarioNumberKind::boolean) return std::get<std::uint64_t>(number) != 0;
  return std::visit([](auto value) { return Json(value); }, number);
}

// Each key names a number of the scenario. No two can name the same: a number has one pointer.
void check_keys(SweptScenarios& scenarios, const SweepPlan& sweep, const std::string& source) {
  for (const VariedKey& key : sweep.vary) {
    const std::string place = source + ": " + pointer_to("/vary", key.pointer) + ": ";
    if (!scenarios.has_number(key)) refuse_input(printable(place + "is no number of a scenario"));
  }
}

// A key whose extremes are beyond its limits: the first member that is, if it is among the first million;
// else member 0 with that extreme, named by its key.
void check_limits(SweptScenarios& scenarios, const SweepDocument& file, const std::string& source) {
  constexpr std::int64_t kSearchedMax = 1'000'000;
  const SweepPlan& sweep = file.plan;
  for (std::size_t index = 0; index < sweep.vary.size(); ++index) {
    const VariedKey& key = sweep.vary[index];
    for (const SweepNumber& extreme : extremes_of(sweep, index)) {
      if (scenarios.allows(key, extreme)) continue;
      for (std::int64_t member = 0; member < std::min(sweep.members, kSearchedMax); ++member)
        if (!scenarios.allows(key, value_of(sweep, index, member)))
          read_member(scenarios, file, member, source);
      const std::string place = source + ": " + pointer_to("/vary", key.pointer);
      Json changed = file.base;
      set_member(sweep, 0, place, changed);
      set_at(changed, key.pointer, json_of(key, extreme), place);
      scenarios.read(changed, place);
    }
  }
}

Json json_of(const VariedKey& key) {
  const auto json = [&key](const SweepNumber& number) { return json_of(key, number); };
  if (const auto* const range = std::get_if<UniformDraw>(&key.variation))
    return Json::Object{{"uniform", Json::Array{json(range->low), json(range->high)}}};
  if (const auto* const grid = std::get_if<GridAxis>(&key.variation))
    return Json::Object{{"grid", Json::Array{json(grid->low), json(grid->high), grid->count}}};
  if (const auto* const choice = std::get_if<ChoiceDraw>(&key.variation))
    return Json::Object{{"choice", list_of(choice->values, json)}};
  return Json::Object{{"member", true}};
}

std::string canonical_text(const SweepPlan& sweep, const Json& base) {
  Json::Object vary;
  for (const VariedKey& key : sweep.vary) vary.emplace_back(key.pointer, json_of(key));
  Json::Array keep;
  for (std::size_t each = 0; each < kKeepNames.size(); ++each)
    if (sweep.keep.has(static_cast<Keep>(each))) keep.emplace_back(kKeepNames[each]);
  return to_text(Json::Object{{"format", kSweepFormat},
                              {"base", base},
                              {"members", sweep.members},
                              {"seed", sweep.seed},
                              {"vary", std::move(vary)},
                              {"keep", std::move(keep)}},
                 1);
}

// Scenarios of the paper's interface.
class PaperScenarios final : public SweptScenarios {
 public:
  [[nodiscard]] VariedKey key_at(const std::string& pointer) const override {
    return {.pointer = pointer, .kind = number_kind(pointer), .variation = MemberNumber{}};
  }
  void read(const Json& document, const std::string& source) override {
    Scenario scenario = to_scenario(document, source, "");
    if (!base_) base_ = std::move(scenario);
  }
  [[nodiscard]] bool has_number(const VariedKey& key) override {
    return number_at(*base_, key.pointer).has_value();
  }
  [[nodiscard]] bool allows(const VariedKey& key, const SweepNumber& number) override {
    return number_at(*base_, key.pointer)->allows(as_double(number));
  }
  void check_members(const SweepDocument& sweep, const std::string& source) override {
    if (const auto member = first_inconsistent_member({sweep.plan, *base_}))
      read_member(*this, sweep, *member, source);
  }
  [[nodiscard]] Scenario& base() { return *base_; }

 private:
  std::optional<Scenario> base_ = {};
};

}  // namespace

void set_member(const SweepPlan& plan, std::int64_t member, const std::string& source, Json& document) {
  for (std::size_t key = 0; key < plan.vary.size(); ++key)
    set_at(document, plan.vary[key].pointer, json_of(plan.vary[key], value_of(plan, key, member)), source);
}

void read_member(SweptScenarios& scenarios, const SweepDocument& sweep, std::int64_t member,
                 const std::string& source) {
  const std::string place = source + ": member " + std::to_string(member);
  Json document = sweep.base;
  set_member(sweep.plan, member, place, document);
  scenarios.read(document, place);
}

SweepDocument read_sweep(SweptScenarios& scenarios, std::string_view text, const std::string& source,
                         SweepCheck check) {
  const Json document = parse_json(text, source);
  JsonProblems problems;
  SweepDocument sweep = read_document(JsonPlace(&document, "", problems), source, scenarios);
  problems.throw_if_any(source);
  read_member(scenarios, sweep, 0, source);
  check_keys(scenarios, sweep.plan, source);
  if (check == SweepCheck::all_members) {
    check_limits(scenarios, sweep, source);
    scenarios.check_members(sweep, source);
  }
  sweep.text = canonical_text(sweep.plan, sweep.base);
  return sweep;
}

SweepFile parse_sweep(std::string_view text, const std::string& source, SweepCheck check) {
  PaperScenarios scenarios;
  SweepDocument sweep = read_sweep(scenarios, text, source, check);
  return {{std::move(sweep.plan), std::move(scenarios.base())},
          std::move(sweep.text),
          std::move(sweep.base_path)};
}

SweepFile load_sweep(const std::string& path) { return parse_sweep(read_text_file(path), path); }

Scenario member_scenario(const Sweep& sweep, std::int64_t member) {
  Scenario scenario = SweepMembers(sweep).scenario(member);
  name_member(scenario, member);
  return scenario;
}

}  // namespace hyrax
