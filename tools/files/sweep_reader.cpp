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

constexpr std::string_view kVariations[] = {"uniform", "choice", "grid", "member"};

// A number of a key: whole where the key's numbers are whole.
bool is_number_of(ScenarioNumberKind kind, const Json& json) {
  return json.is_number() && std::isfinite(json.number()) &&
         (kind == ScenarioNumberKind::real || json.is_whole());
}

SweepNumber number_of(ScenarioNumberKind kind, const Json& json) {
  if (kind == ScenarioNumberKind::real) return json.number();
  if (kind == ScenarioNumberKind::seed) {
    const auto* const seed = json.get<std::uint64_t>();
    return seed != nullptr ? *seed : static_cast<std::uint64_t>(json.number());
  }
  return static_cast<std::int64_t>(json.number());
}

// Numbers of a seed that a conversion would not keep are refused here; other limits need the scenario.
bool is_convertible(ScenarioNumberKind kind, double value) {
  if (kind == ScenarioNumberKind::real) return true;
  return kind == ScenarioNumberKind::seed ? value >= 0.0 && value <= 0x1p64 : std::fabs(value) <= 0x1p62;
}

// [low, high], or [low, high, n].
std::optional<std::pair<double, double>> read_range(const JsonPlace& here, ScenarioNumberKind kind,
                                                    std::size_t size) {
  const Json::Array* const array = here.array();
  if (array == nullptr) return std::nullopt;
  const std::string form = size == 2 ? "[low, high]" : "[low, high, n]";
  const auto is_good = [&](const Json& json) {
    return is_number_of(kind, json) && is_convertible(kind, json.number());
  };
  if (array->size() != size || !is_good((*array)[0]) || !is_good((*array)[1]) ||
      (*array)[0].number() > (*array)[1].number()) {
    here.breaks_rule("must be " + form + " with low <= high, " +
                     (kind == ScenarioNumberKind::real ? "numbers" : "whole numbers, as the key holds"));
    return std::nullopt;
  }
  return std::pair{(*array)[0].number(), (*array)[1].number()};
}

UniformDraw read_uniform(const JsonPlace& here, ScenarioNumberKind kind) {
  const auto range = read_range(here, kind, 2);
  return range ? UniformDraw{range->first, range->second} : UniformDraw{};
}

ChoiceDraw read_choice(const JsonPlace& here, ScenarioNumberKind kind) {
  ChoiceDraw choice;
  const Json::Array* const array = here.array();
  if (array == nullptr) return choice;
  if (array->empty()) here.wrong("must hold at least one number (found [])");
  for (std::size_t entry = 0; entry < array->size(); ++entry) {
    const Json& json = (*array)[entry];
    if (is_number_of(kind, json) && is_convertible(kind, json.number()) &&
        (kind != ScenarioNumberKind::seed || json.get<std::uint64_t>() != nullptr || json.number() < 0x1p64))
      choice.values.push_back(number_of(kind, json));
    else
      here.element(entry).breaks_rule(
          kind == ScenarioNumberKind::real ? "must be a number" : "must be a whole number, as the key holds");
  }
  return choice;
}

GridAxis read_grid(const JsonPlace& here, ScenarioNumberKind kind) {
  const auto range = read_range(here, kind, 3);
  if (!range) return {};
  const auto count = here.element(2).integer(1, kMembersMax);
  GridAxis grid{range->first, range->second, count.value_or(1)};
  if (kind == ScenarioNumberKind::real) return grid;
  // More values than whole numbers cannot all be whole; so the loop is as short as the range is.
  const bool is_too_fine = static_cast<double>(grid.count - 1) > grid.high - grid.low && grid.high > grid.low;
  for (std::int64_t index = 0; !is_too_fine && grid.high > grid.low && index < grid.count; ++index) {
    if (std::floor(value_of(grid, index)) == value_of(grid, index)) continue;
    here.breaks_rule("must give whole numbers only, as the key holds");
    return grid;
  }
  if (is_too_fine) here.breaks_rule("must give whole numbers only, as the key holds");
  return grid;
}

VariedKey read_key(const JsonPlace& here, const std::string& pointer) {
  VariedKey key{.pointer = pointer, .kind = number_kind(pointer), .variation = MemberNumber{}};
  if (!here.is_object_of({"uniform", "choice", "grid", "member"})) return key;
  int variations = 0;
  for (const std::string_view name : kVariations) variations += here.member(name).is_there() ? 1 : 0;
  if (variations != 1) here.wrong("must hold exactly one of uniform, choice, grid and member");
  if (const JsonPlace uniform = here.member("uniform"); uniform.is_there())
    key.variation = read_uniform(uniform, key.kind);
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
  std::sort(vary.begin(), vary.end(),
            [](const VariedKey& a, const VariedKey& b) { return a.pointer < b.pointer; });
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

// One member's document, or the base with one number changed, read as a scenario.
class MemberReader {
 public:
  MemberReader(const Json& base, const Sweep& sweep, std::string source)
      : base_(base), sweep_(sweep), source_(std::move(source)) {}

  // ERRORS: Failure(bad_input) "SOURCE: member I: POINTER: ...".
  [[nodiscard]] Scenario read(std::int64_t member) const {
    const std::string place = source_ + ": member " + std::to_string(member);
    Json document = base_;
    for (std::size_t key = 0; key < sweep_.vary.size(); ++key)
      set_at(document, sweep_.vary[key].pointer, json_of(value_of(sweep_, key, member)), place);
    return to_scenario(document, place, "");
  }

  // Member 0 with another value of one key. ERRORS: Failure(bad_input) "SOURCE: /vary/KEY: POINTER: ...".
  void read_with(std::size_t changed, const SweepNumber& value) const {
    const std::string place = source_ + ": " + pointer_to("/vary", sweep_.vary[changed].pointer);
    Json document = base_;
    for (std::size_t key = 0; key < sweep_.vary.size(); ++key)
      set_at(document, sweep_.vary[key].pointer, json_of(key == changed ? value : value_of(sweep_, key, 0)),
             place);
    static_cast<void>(to_scenario(document, place, ""));
  }

 private:
  const Json& base_;
  const Sweep& sweep_;
  std::string source_;
};

// Each key names a number of the scenario. No two can name the same: a number has one pointer.
void check_keys(const Sweep& sweep, const std::string& source) {
  Scenario base = sweep.base;
  for (const VariedKey& key : sweep.vary) {
    const std::string place = source + ": " + pointer_to("/vary", key.pointer) + ": ";
    if (!number_at(base, key.pointer)) refuse_input(printable(place + "is no number of a scenario"));
  }
}

// A key whose extremes are beyond its limits: the first member that is, if it is among the first million.
void check_limits(const Sweep& sweep, const MemberReader& reader) {
  constexpr std::int64_t kSearchedMax = 1'000'000;
  Scenario base = sweep.base;
  for (std::size_t key = 0; key < sweep.vary.size(); ++key) {
    const NumberField field = *number_at(base, sweep.vary[key].pointer);
    for (const SweepNumber& extreme : extremes_of(sweep, key)) {
      if (field.allows(as_double(extreme))) continue;
      for (std::int64_t member = 0; member < std::min(sweep.members, kSearchedMax); ++member)
        if (!field.allows(as_double(value_of(sweep, key, member)))) static_cast<void>(reader.read(member));
      reader.read_with(key, extreme);
    }
  }
}

struct VariationJson {
  using Object = Json::Object;
  Json operator()(const UniformDraw& range) const {
    return Object{{"uniform", Json::Array{range.low, range.high}}};
  }
  Json operator()(const ChoiceDraw& choice) const {
    Json::Array values;
    for (const SweepNumber& value : choice.values) values.push_back(json_of(value));
    return Object{{"choice", std::move(values)}};
  }
  Json operator()(const GridAxis& grid) const {
    return Object{{"grid", Json::Array{grid.low, grid.high, grid.count}}};
  }
  Json operator()(const MemberNumber&) const { return Object{{"member", true}}; }
};

std::string canonical_text(const Sweep& sweep, const Json& base) {
  Json::Object vary;
  for (const VariedKey& key : sweep.vary)
    vary.emplace_back(key.pointer, std::visit(VariationJson{}, key.variation));
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
  const MemberReader reader(base, sweep, source);
  sweep.base = reader.read(0);
  check_keys(sweep, source);
  if (check == SweepCheck::all_members) {
    check_limits(sweep, reader);
    if (const auto member = first_inconsistent_member(sweep)) static_cast<void>(reader.read(*member));
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
