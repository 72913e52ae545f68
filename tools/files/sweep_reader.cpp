#include "tools/files/sweep_reader.h"

#include <algorithm>
#include <cmath>

#include "tools/files/failure.h"
#include "tools/files/json_pointer.h"
#include "tools/files/json_reader.h"
#include "tools/files/path.h"
#include "tools/files/printable.h"
#include "tools/files/scenario_reader.h"
#include "tools/files/text_file.h"
#include "tools/files/unknown_word.h"

namespace hyrax {
namespace {

// The number in the type of the key; nothing where that type does not hold it.
std::optional<SweepNumber> number_of(ScenarioNumberKind kind, const Json& json) {
  if (!json.is_number() || !std::isfinite(json.number())) return std::nullopt;
  const double value = json.number();
  if (kind == ScenarioNumberKind::real) return value;
  if (!json.is_whole()) return std::nullopt;
  const auto* const whole = json.get<std::uint64_t>();
  if (kind == ScenarioNumberKind::seed) {
    if (whole != nullptr) return *whole;
    return value >= 0.0 && value < 0x1p64 ? std::optional<SweepNumber>(static_cast<std::uint64_t>(value))
                                          : std::nullopt;
  }
  if (std::fabs(value) > 0x1p62) return std::nullopt;
  return whole != nullptr ? static_cast<std::int64_t>(*whole) : static_cast<std::int64_t>(value);
}

// [low, high], or [low, high, n].
std::optional<UniformDraw> read_range(const JsonPlace& here, ScenarioNumberKind kind, std::size_t size) {
  const Json::Array* const array = here.array();
  if (array == nullptr) return std::nullopt;
  if (array->size() == size) {
    const auto low = number_of(kind, (*array)[0]);
    const auto high = number_of(kind, (*array)[1]);
    if (low && high && *low <= *high) return UniformDraw{*low, *high};
  }
  return here.breaks_rule(std::string("must be ") + (size == 2 ? "[low, high]" : "[low, high, n]") +
                          " with low <= high, " +
                          (kind == ScenarioNumberKind::real ? "numbers" : "whole numbers, as the key holds"));
}

ChoiceDraw read_choice(const JsonPlace& here, ScenarioNumberKind kind) {
  ChoiceDraw choice;
  const Json::Array* const array = here.array();
  if (array == nullptr) return choice;
  if (array->empty()) here.wrong("must hold at least one number (found [])");
  for (std::size_t entry = 0; entry < array->size(); ++entry) {
    if (const auto number = number_of(kind, (*array)[entry]))
      choice.values.push_back(*number);
    else
      here.element(entry).breaks_rule(
          kind == ScenarioNumberKind::real ? "must be a number" : "must be a whole number, as the key holds");
  }
  return choice;
}

GridAxis read_grid(const JsonPlace& here, ScenarioNumberKind kind) {
  const auto range = read_range(here, kind, 3);
  if (!range) return {};
  const GridAxis grid{range->low, range->high, here.element(2).integer(1, kMembersMax).value_or(1)};
  if (kind != ScenarioNumberKind::real && grid.count > 1 &&
      whole_distance(grid.low, grid.high) % static_cast<std::uint64_t>(grid.count - 1) != 0)
    here.breaks_rule("must give whole numbers only, as the key holds");
  return grid;
}

VariedKey read_key(const JsonPlace& here, const std::string& pointer) {
  VariedKey key{.pointer = pointer, .kind = number_kind(pointer), .variation = MemberNumber{}};
  const std::vector<std::string_view> variations = {"uniform", "choice", "grid", "member"};
  if (!here.is_object_of(variations)) return key;
  if (std::ranges::count_if(variations, [&](auto name) { return here.member(name).is_there(); }) != 1)
    here.wrong("must hold exactly one of uniform, choice, grid and member");
  if (const JsonPlace uniform = here.member("uniform"); uniform.is_there())
    key.variation = read_range(uniform, key.kind, 2).value_or(UniformDraw{});
  else if (const JsonPlace choice = here.member("choice"); choice.is_there())
    key.variation = read_choice(choice, key.kind);
  else if (const JsonPlace grid = here.member("grid"); grid.is_there())
    key.variation = read_grid(grid, key.kind);
  else if (const JsonPlace member = here.member("member"); member.boolean() == false)
    member.breaks_rule("must be true");
  return key;
}

std::vector<VariedKey> read_vary(const JsonPlace& here) {
  std::vector<VariedKey> vary;
  here.each_member([&](const std::string& pointer, const JsonPlace& place) {
    if (pointer == "/expect" || pointer.starts_with("/expect/"))
      place.wrong("the members have no expect; it is dropped from the base");
    vary.push_back(read_key(place, pointer));
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

void read_members(const JsonPlace& document, Sweep& sweep) {
  const std::int64_t product = set_repeats(document.member("vary"), sweep.vary);
  const JsonPlace members = document.member("members");
  sweep.members = members.is_there() ? members.integer(1, kMembersMax).value_or(0) : product;
  if (sweep.members % product != 0)
    members.breaks_rule("must be a multiple of the grids' combinations, " + std::to_string(product));
}

// What a sweep document says, before any member is looked at: the base, and in `file` all else.
Json read_sweep(const JsonPlace& document, const std::string& source, SweepFile& file) {
  if (!document.is_object_of({"$schema", "format", "base", "members", "seed", "vary", "keep"})) return {};
  const auto format = document.required("format").text();
  if (format && *format != kSweepFormat)
    document.member("format").wrong(unknown_word("format", *format, {kSweepFormat}));
  Json base = read_base(document.required("base"), source, file.base_path);
  Sweep& sweep = file.sweep;
  sweep.vary = read_vary(document.required("vary"));
  read_members(document, sweep);
  const bool is_drawn = std::any_of(sweep.vary.begin(), sweep.vary.end(), [](const VariedKey& key) {
    return std::holds_alternative<UniformDraw>(key.variation) ||
           std::holds_alternative<ChoiceDraw>(key.variation);
  });
  sweep.seed = (is_drawn ? document.required("seed") : document.member("seed")).seed().value_or(0);
  sweep.keep = read_keep(document.member("keep"));
  return base;
}

Json json_of(const SweepNumber& number) {
  return std::visit([](auto value) { return Json(value); }, number);
}

// ERRORS: Failure(bad_input) "PLACE: POINTER: ...".
Json member_document(const Json& base, const Sweep& sweep, std::int64_t member, const std::string& place) {
  Json document = base;
  for (std::size_t key = 0; key < sweep.vary.size(); ++key)
    set_at(document, sweep.vary[key].pointer, json_of(value_of(sweep, key, member)), place);
  return document;
}

// ERRORS: Failure(bad_input) "SOURCE: member I: POINTER: ...".
Scenario read_member(const Json& base, const Sweep& sweep, std::int64_t member, const std::string& source) {
  const std::string place = source + ": member " + std::to_string(member);
  return to_scenario(member_document(base, sweep, member, place), place, "");
}

// Each key names a number of the scenario. No two can name the same: a number has one pointer.
void check_keys(const Sweep& sweep, const std::string& source) {
  Scenario base = sweep.base;
  for (const VariedKey& key : sweep.vary) {
    const std::string place = source + ": " + pointer_to("/vary", key.pointer) + ": ";
    if (!number_at(base, key.pointer)) refuse_input(printable(place + "is no number of a scenario"));
  }
}

// A key whose extremes are beyond its limits: the first member that is, if it is among the first million;
// else member 0 with that extreme, named by its key.
void check_limits(const Json& document, const Sweep& sweep, const std::string& source) {
  constexpr std::int64_t kSearchedMax = 1'000'000;
  Scenario base = sweep.base;
  for (std::size_t key = 0; key < sweep.vary.size(); ++key) {
    const std::string& pointer = sweep.vary[key].pointer;
    const NumberField field = *number_at(base, pointer);
    for (const SweepNumber& extreme : extremes_of(sweep, key)) {
      if (field.allows(as_double(extreme))) continue;
      for (std::int64_t member = 0; member < std::min(sweep.members, kSearchedMax); ++member)
        if (!field.allows(as_double(value_of(sweep, key, member))))
          static_cast<void>(read_member(document, sweep, member, source));
      const std::string place = source + ": " + pointer_to("/vary", pointer);
      Json changed = member_document(document, sweep, 0, place);
      set_at(changed, pointer, json_of(extreme), place);
      static_cast<void>(to_scenario(changed, place, ""));
    }
  }
}

Json json_of(const VariedKey& key) {
  if (const auto* const range = std::get_if<UniformDraw>(&key.variation))
    return Json::Object{{"uniform", Json::Array{json_of(range->low), json_of(range->high)}}};
  if (const auto* const grid = std::get_if<GridAxis>(&key.variation))
    return Json::Object{{"grid", Json::Array{json_of(grid->low), json_of(grid->high), grid->count}}};
  if (const auto* const choice = std::get_if<ChoiceDraw>(&key.variation))
    return Json::Object{
        {"choice", list_of(choice->values, [](const SweepNumber& value) { return json_of(value); })}};
  return Json::Object{{"member", true}};
}

std::string canonical_text(const Sweep& sweep, const Json& base) {
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

}  // namespace

SweepFile parse_sweep(std::string_view text, const std::string& source, SweepCheck check) {
  const Json document = parse_json(text, source);
  JsonProblems problems;
  SweepFile file;
  const Json base = read_sweep(JsonPlace(&document, "", problems), source, file);
  problems.throw_if_any(source);
  Sweep& sweep = file.sweep;
  sweep.base = read_member(base, sweep, 0, source);
  check_keys(sweep, source);
  if (check == SweepCheck::all_members) {
    check_limits(base, sweep, source);
    if (const auto member = first_inconsistent_member(sweep))
      static_cast<void>(read_member(base, sweep, *member, source));
  }
  file.text = canonical_text(sweep, base);
  return file;
}

SweepFile load_sweep(const std::string& path) { return parse_sweep(read_text_file(path), path); }

Scenario member_scenario(const Sweep& sweep, std::int64_t member) {
  Scenario scenario = SweepMembers(sweep).scenario(member);
  const std::string suffix = "-member-" + std::to_string(member);
  scenario.name = scenario.name.substr(0, static_cast<std::size_t>(kNameLengthMax) - suffix.size()) + suffix;
  return scenario;
}

}  // namespace hyrax
