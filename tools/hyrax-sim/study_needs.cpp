#include "tools/hyrax-sim/study_needs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/study/needs.h"
#include "sim/study/needs_tables.h"
#include "tools/files/failure.h"
#include "tools/files/scenario_list.h"
#include "tools/files/scenario_reader.h"
#include "tools/hyrax-sim/command_line/progress.h"
#include "tools/hyrax-sim/machine_name.h"
#include "tools/hyrax-sim/steady_clock_ns.h"
#include "tools/report/needs_figure.h"

namespace hyrax {
namespace {

constexpr double kWithin_px = 1.0;
// Of more scenes than this the cheapest method is not looked for: each takes a second or more.
constexpr std::size_t kScenesWithMethodsMax = 4;

std::string length_text(double length_px) {
  if (!std::isfinite(length_px)) return "no bound";
  return length_px >= 1e4 ? fmt::format("{:.4g} px", length_px) : fmt::format("{:.3g} px", length_px);
}

std::string cheapest_text(const SceneNeeds& scene, double within_px) {
  if (!scene.methods)
    return scene.why_no_methods.empty() ? "" : "No cheapest method is told: " + scene.why_no_methods + ".\n";
  const SpeedError& speed = *scene.methods;
  const CheapestBelow& answer = speed.cheapest.front();
  std::string text = fmt::format("Within {:g} px of the fixed laws the cheapest is\n  ", within_px);
  if (!answer.point) return text + "nothing that was tried.\n";
  const WorkPoint& best = speed.points[*answer.point];
  text += fmt::format("{} at {:.0f} Hz, {:.0f} ns per simulated second; ", speed.methods[best.method].words,
                      best.rate_hz, best.cost.median_ns);
  if (!answer.paper_point) return text + "the paper's step is so near at no rate.\n";
  const WorkPoint& paper = speed.points[*answer.paper_point];
  return text + fmt::format("the paper's step, at {:.0f} Hz, takes {:.0f} ns.\n", paper.rate_hz,
                            paper.cost.median_ns);
}

std::string control_text(const SceneNeeds& scene, double within_px) {
  const auto left_out = std::count_if(scene.parts.begin(), scene.parts.end(), [](const PartNeed& part) {
    return part.need == Need::below || part.need == Need::not_exercised;
  });
  return fmt::format("All {} that are not needed left out at once: the path moves {}, {} {:g} px.\n",
                     left_out, length_text(scene.without_all_unneeded.path_px),
                     scene.without_all_unneeded.path_px <= within_px ? "within" : "more than", within_px);
}

std::string scene_text(const SceneNeeds& scene, double within_px) {
  std::string text = fmt::format("What {} needs, within {:g} px, over {} steps{} ({}):\n", scene.scenario,
                                 within_px, scene.steps, scene.is_cut ? ", its first" : "",
                                 scene.comes_to_rest ? "comes to rest" : "does not come to rest");
  text += fmt::format("{:<22}{:>14}{:>10}{:>14}{:>12}  {}\n", "left out", "path moves", "contacts",
                      scene.comes_to_rest ? "rest shifts" : "end shifts", "saves", "verdict");
  constexpr std::size_t kLinesMax = 30;
  for (std::size_t index = 0; index < std::min(scene.parts.size(), kLinesMax); ++index) {
    const PartNeed& part = scene.parts[index];
    const bool is_seen = part.need != Need::not_exercised;
    text += fmt::format("{:<22}{:>14}{:>10}{:>14}{:>9.2f} ns  {}\n", part.part,
                        is_seen ? length_text(part.difference.path_px) : "-",
                        is_seen ? std::to_string(part.difference.contacts_moved) : "-",
                        is_seen ? length_text(part.difference.end_px) : "-", part.saved_ns_per_step,
                        name_of(part.need));
  }
  if (scene.parts.size() > kLinesMax)
    text += fmt::format("... and {} more, in the files\n", scene.parts.size() - kLinesMax);
  text += fmt::format("A step with all parts takes {:.2f} ns on {}.\n", scene.step_ns, machine_name());
  return text + control_text(scene, within_px) + cheapest_text(scene, within_px);
}

std::string library_text(const std::vector<SceneNeeds>& scenes, double within_px) {
  std::string text = fmt::format("What {} scenarios exercise, within {:g} px:\n{:<14}{:>12}{:>12}  {}\n",
                                 scenes.size(), within_px, "part", "exercised", "needed", "by, for instance");
  std::string never;
  for (std::size_t column = 0; column < coverage_columns().size(); ++column) {
    std::size_t exercised = 0, needed = 0;
    std::string instance;
    for (const SceneNeeds& scene : scenes) {
      const Need need = coverage_of(scene)[column];
      exercised += need != Need::not_exercised;
      if (need == Need::not_exercised || need == Need::below) continue;
      ++needed;
      if (instance.empty()) instance = scene.scenario;
    }
    text += fmt::format("{:<14}{:>12}{:>12}  {}\n", coverage_columns()[column], exercised, needed, instance);
    if (exercised == 0) never += (never.empty() ? "" : ", ") + coverage_columns()[column];
  }
  text += never.empty() ? "Every part is exercised by some scenario.\n"
                        : "Exercised by no scenario: " + never + ".\n";
  const auto held =
      std::count_if(scenes.begin(), scenes.end(), [](const SceneNeeds& s) { return s.broken.empty(); });
  return text + fmt::format("{} of {} scenes agree with the replay.\n", held, scenes.size());
}

Json::Object json_of(const std::vector<SceneNeeds>& scenes, double within_px) {
  Json::Array entries;
  for (const SceneNeeds& scene : scenes) {
    Json::Array parts;
    for (const PartNeed& part : scene.parts)
      parts.push_back(Json::Object{{"part", part.part},
                                   {"verdict", name_of(part.need)},
                                   {"path_px", part.difference.path_px},
                                   {"contacts_moved", part.difference.contacts_moved},
                                   {"end_px", part.difference.end_px},
                                   {"saved_ns_per_step", part.saved_ns_per_step}});
    Json cheapest = nullptr;
    if (scene.methods && scene.methods->cheapest.front().point) {
      const WorkPoint& point = scene.methods->points[*scene.methods->cheapest.front().point];
      cheapest = Json::Object{{"method", scene.methods->methods[point.method].name},
                              {"rate_hz", point.rate_hz},
                              {"cost_ns_per_s", point.cost.median_ns}};
    }
    entries.push_back(Json::Object{{"scenario", scene.scenario},
                                   {"steps", scene.steps},
                                   {"step_ns", scene.step_ns},
                                   {"parts", std::move(parts)},
                                   {"without_all_unneeded_px", scene.without_all_unneeded.path_px},
                                   {"holds", scene.broken.empty()},
                                   {"cheapest", std::move(cheapest)}});
  }
  Json::Array never;
  for (std::size_t column = 0; column < coverage_columns().size(); ++column)
    if (std::all_of(scenes.begin(), scenes.end(),
                    [column](const SceneNeeds& s) { return coverage_of(s)[column] == Need::not_exercised; }))
      never.push_back(coverage_columns()[column]);
  return {{"within_px", within_px}, {"scenes", std::move(entries)}, {"exercised_by_none", std::move(never)}};
}

std::vector<SceneNeeds> study_all(const std::vector<std::string>& paths, const NeedsOptions& options) {
  std::vector<Scenario> scenarios;
  std::set<std::string> names;
  for (const std::string& path : paths) {
    scenarios.push_back(load_scenario(path));
    if (!names.insert(scenarios.back().name).second)
      throw Failure(ExitCode::bad_input, path + ": /name: another scenario is called " +
                                             scenarios.back().name + "; study them apart");
  }
  std::vector<SceneNeeds> scenes;
  Progress progress("scenarios", static_cast<std::int64_t>(scenarios.size()));
  for (const Scenario& scenario : scenarios) {
    progress.show(static_cast<std::int64_t>(scenes.size()));
    scenes.push_back(study_needs(scenario, options, steady_clock_ns));
  }
  return scenes;
}

}  // namespace

StudyOutcome make_needs(const StudyRequest& request) {
  if (request.scenarios.empty())
    throw Failure(
        ExitCode::bad_input,
        "hyrax-sim study needs: a scenario must be given; `hyrax-sim study needs scenarios` takes all");
  const std::vector<std::string> paths = list_scenarios(request.scenarios);
  NeedsOptions options;
  options.within_px = request.within_px.value_or(kWithin_px);
  if (request.is_quick) options.cost.sample_ns = 5'000;
  if (paths.size() <= kScenesWithMethodsMax)
    options.rates_hz =
        request.is_quick ? std::vector{15.0, 60.0, 240.0}
                         : std::vector{15.0, 30.0, 60.0, 120.0, 240.0, 480.0, 960.0, 1920.0, 3840.0, 7680.0};
  const std::vector<SceneNeeds> scenes = study_all(paths, options);

  StudyOutcome outcome;
  outcome.tables = tables_of(scenes, options.within_px);
  if (paths.size() <= kScenesWithMethodsMax) {
    for (const SceneNeeds& scene : scenes) {
      if (!outcome.verdict.empty()) outcome.verdict += "\n";
      outcome.verdict += scene_text(scene, options.within_px);
      outcome.figures.push_back({"-" + scene.scenario, needs_script(scene, options.within_px)});
    }
  } else {
    outcome.verdict = library_text(scenes, options.within_px);
    outcome.figures.push_back({"", coverage_script(scenes, options.within_px)});
  }
  for (const SceneNeeds& scene : scenes)
    for (const std::string& sentence : scene.broken)
      outcome.broken.push_back(fmt::format("{}: {}", scene.scenario, sentence));
  outcome.json = json_of(scenes, options.within_px);
  return outcome;
}

}  // namespace hyrax
