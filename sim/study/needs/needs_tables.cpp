#include "sim/study/needs/needs_tables.h"

#include <algorithm>
#include <limits>

#include "sim/result/table.h"

namespace hyrax {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct PartRow {
  const SceneNeeds* scene;
  const PartNeed* part;
};

Table parts_table(const std::vector<SceneNeeds>& scenes) {
  std::vector<PartRow> rows;
  for (const SceneNeeds& scene : scenes)
    for (const PartNeed& part : scene.parts) rows.push_back({&scene, &part});
  using R = const PartRow&;
  return {
      "parts",
      "every part of model and scene left out in turn",
      {column_of<std::string>("scenario", "", "what is played", rows, [](R r) { return r.scene->scenario; }),
       column_of<std::string>("part", "", "what is left out", rows, [](R r) { return r.part->part; }),
       column_of<std::string>("verdict", "",
                              "needed, alone or with others left out; below the tolerance; or not exercised",
                              rows, [](R r) { return std::string(name_of(r.part->need)); }),
       column_of<double>("path_difference", "px", "largest distance of two rows", rows,
                         [](R r) { return r.part->difference.path_px; }),
       column_of<std::int64_t>("first_step", "1", "first row that differs; -1: none", rows,
                               [](R r) { return r.part->difference.first_step; }),
       column_of<std::int64_t>("contacts_moved", "1", "contacts that moved, appeared or vanished", rows,
                               [](R r) { return r.part->difference.contacts_moved; }),
       column_of<double>("end_shift", "px", "distance of the last rows", rows,
                         [](R r) { return r.part->difference.end_px; }),
       column_of<double>("saved", "ns", "time saved per step", rows,
                         [](R r) { return r.part->saved_ns_per_step; }),
       column_of<double>("step", "ns", "time of a step with all parts", rows,
                         [](R r) { return r.scene->step_ns; })}};
}

Table coverage_table(const std::vector<SceneNeeds>& scenes) {
  using S = const SceneNeeds&;
  Table table{
      "coverage",
      "which scenario exercises what: 2 needed, 1 below the tolerance, 0 not exercised",
      {column_of<std::string>("scenario", "", "what is played", scenes, [](S s) { return s.scenario; })}};
  for (std::size_t index = 0; index < coverage_columns().size(); ++index) {
    std::string name = coverage_columns()[index];
    std::replace(name.begin(), name.end(), ' ', '_');
    table.columns.push_back(column_of<std::int64_t>(
        name, "1", coverage_columns()[index] + ": 2 needed, 1 below the tolerance, 0 not exercised", scenes,
        [&](S s) {
          const Need need = coverage_of(s)[index];
          return std::int64_t{need == Need::not_exercised ? 0 : need == Need::below ? 1 : 2};
        }));
  }
  return table;
}

Table control_table(const std::vector<SceneNeeds>& scenes, double within_px) {
  using S = const SceneNeeds&;
  return {"control",
          "everything that is not needed left out at once",
          {column_of<std::string>("scenario", "", "what is played", scenes, [](S s) { return s.scenario; }),
           column_of<std::int64_t>("steps", "1", "frames played", scenes, [](S s) { return s.steps; }),
           column_of<std::int64_t>("left_out", "1", "parts left out", scenes,
                                   [](S s) {
                                     return static_cast<std::int64_t>(
                                         std::count_if(s.parts.begin(), s.parts.end(), [](const PartNeed& p) {
                                           return p.need == Need::below || p.need == Need::not_exercised;
                                         }));
                                   }),
           column_of<double>("path_difference", "px", "largest distance of two rows", scenes,
                             [](S s) { return s.without_all_unneeded.path_px; }),
           column_of<double>("tolerance", "px", "that it has to keep", scenes, [&](S) { return within_px; }),
           column_of<std::int64_t>("holds", "1", "1: the scene agrees with the replay", scenes,
                                   [](S s) { return std::int64_t{s.broken.empty()}; })}};
}

// The cheapest point of a scene's methods; nullptr where there is none.
const WorkPoint* cheapest_of(const SceneNeeds& scene, bool of_paper) {
  if (!scene.methods || scene.methods->cheapest.empty()) return nullptr;
  const CheapestBelow& answer = scene.methods->cheapest.front();
  const std::optional<std::size_t>& point = of_paper ? answer.paper_point : answer.point;
  return point ? &scene.methods->points[*point] : nullptr;
}

Table cheapest_table(const std::vector<SceneNeeds>& scenes) {
  std::vector<const SceneNeeds*> asked;
  for (const SceneNeeds& scene : scenes)
    if (scene.methods) asked.push_back(&scene);
  using S = const SceneNeeds*;
  const auto rate = [](const WorkPoint* point) { return point != nullptr ? point->rate_hz : kNone; };
  const auto cost = [](const WorkPoint* point) { return point != nullptr ? point->cost.median_ns : kNone; };
  return {"cheapest",
          "the cheapest method and rate within the tolerance of the fixed laws",
          {column_of<std::string>("scenario", "", "what is played", asked, [](S s) { return s->scenario; }),
           column_of<std::string>("method", "", "the cheapest", asked,
                                  [](S s) {
                                    const WorkPoint* point = cheapest_of(*s, false);
                                    return point != nullptr ? s->methods->methods[point->method].name
                                                            : "none";
                                  }),
           column_of<double>("rate", "Hz", "its frames per second", asked,
                             [&](S s) { return rate(cheapest_of(*s, false)); }),
           column_of<double>("cost", "ns/s", "its median cost", asked,
                             [&](S s) { return cost(cheapest_of(*s, false)); }),
           column_of<double>("paper_rate", "Hz", "of the paper's step; none: at no rate", asked,
                             [&](S s) { return rate(cheapest_of(*s, true)); }),
           column_of<double>("paper_cost", "ns/s", "its median cost", asked,
                             [&](S s) { return cost(cheapest_of(*s, true)); })}};
}

}  // namespace

std::string_view name_of(Need need) {
  switch (need) {
    case Need::needed:
      return "needed";
    case Need::needed_jointly:
      return "needed with others left out";
    case Need::below:
      return "below the tolerance";
    case Need::not_exercised:
      return "not exercised";
  }
  return "";
}

const std::vector<std::string>& coverage_columns() {
  static const std::vector<std::string> columns = [] {
    std::vector<std::string> names(kPartNames.begin(), kPartNames.end());
    for (const char* name : {"jitter", "fling", "place", "stop", "resize", "hitch", "hold"})
      names.emplace_back(name);
    return names;
  }();
  return columns;
}

std::vector<Need> coverage_of(const SceneNeeds& scene) {
  std::vector<Need> coverage(coverage_columns().size(), Need::not_exercised);
  for (const PartNeed& part : scene.parts) {
    const std::string kind = part.part.substr(0, part.part.find(','));
    const auto at =
        std::find(coverage_columns().begin(), coverage_columns().end(), kind) - coverage_columns().begin();
    Need& most = coverage[static_cast<std::size_t>(at)];
    most = std::min(most, part.need);  // `needed` comes first.
  }
  return coverage;
}

std::vector<Table> tables_of(const std::vector<SceneNeeds>& scenes, double within_px) {
  return {parts_table(scenes), coverage_table(scenes), control_table(scenes, within_px),
          cheapest_table(scenes)};
}

}  // namespace hyrax
