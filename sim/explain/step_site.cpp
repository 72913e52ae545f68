#include "sim/explain/step_site.h"

#include <algorithm>

#include "sim/explain/statement_text.h"

namespace hyrax {
namespace {

// The walls of an axis are two, the one at 0 first.
std::string_view wall_name(const Statement& first_of, std::size_t index) {
  const bool is_far = index % 2 != 0;
  if (first_of.operation == Operation::wall_x) return is_far ? "right wall: " : "left wall: ";
  return is_far ? "ground: " : "top: ";
}

void add_sites(StepStatements& list, std::string_view wall, std::vector<StepSite>& sites) {
  for (std::size_t index = 0; index < list.size(); ++index) {
    sites.push_back({&list, index, wall});
    Statement& statement = list[index];
    if (statement.form != Statement::Form::first_of) {
      add_sites(statement.body, wall, sites);
      continue;
    }
    for (std::size_t at = 0; at < statement.body.size(); ++at) {
      sites.push_back({&statement.body, at, wall_name(statement, at)});
      add_sites(statement.body[at].body, wall_name(statement, at), sites);
    }
  }
}

template <class Takes>
void add_set(const std::vector<StepSite>& all, std::vector<StepSites>& sets, const Takes& takes) {
  StepSites set;
  for (std::size_t site = 0; site < all.size(); ++site)
    if (takes(all[site])) set.push_back(site);
  if (set.size() > 1 && std::ranges::find(sets, set) == sets.end()) sets.push_back(std::move(set));
}

bool is_in_x(const StepSite& site) { return site.wall.starts_with("left") || site.wall.starts_with("right"); }

}  // namespace

std::vector<StepSite> sites_of(StepStatements& step) {
  std::vector<StepSite> sites;
  add_sites(step, "", sites);
  return sites;
}

std::string_view operation_at(const std::vector<StepSite>& all, const StepSites& sites) {
  const Operation first = all[sites.front()].statement().operation;
  const bool is_one =
      std::ranges::all_of(sites, [&](std::size_t site) { return all[site].statement().operation == first; });
  return is_one ? name_of(first) : kSeveralOperations;
}

std::string text_at(const std::vector<StepSite>& all, const StepSites& sites) {
  std::string text;
  for (const std::size_t site : sites) {
    if (!text.empty()) text += "; ";
    text += std::string(all[site].wall) + statement_text(all[site].statement());
  }
  return text;
}

std::vector<StepSites> site_sets(const std::vector<StepSite>& all) {
  std::vector<StepSites> sets;
  for (std::size_t site = 0; site < all.size(); ++site) sets.push_back({site});
  for (const StepSite& like : all) {
    const Statement& model = like.statement();
    const auto is_like = [&](const StepSite& site) {
      return site.statement().operation == model.operation && site.statement().form == model.form;
    };
    add_set(all, sets, [&](const StepSite& site) { return is_like(site) && is_in_x(site) == is_in_x(like); });
    add_set(all, sets, is_like);
  }
  add_set(all, sets, [](const StepSite& site) { return site.statement().form == Statement::Form::wall; });
  return sets;
}

}  // namespace hyrax
