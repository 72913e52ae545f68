#include <fmt/format.h>

#include <functional>
#include <string>

#include "sim/explain/candidate.h"
#include "sim/explain/statement_text.h"
#include "sim/explain/step_site.h"
#include "sim/motion/listing.h"

namespace hyrax {
namespace {

using Form = Statement::Form;

Component along_other_axis(Component of) {
  switch (of) {
    case Component::x:
      return Component::y;
    case Component::y:
      return Component::x;
    case Component::vx:
      return Component::vy;
    case Component::vy:
      return Component::vx;
  }
  return of;
}

bool is_product(Form form) { return form == Form::accelerate || form == Form::move; }
bool is_condition(Form form) { return form == Form::wall || form == Form::stop; }

// A change of one statement; false: its form has no such change.
using StatementEdit = std::function<bool(Statement&)>;

bool turn_sign(Statement& s) {
  if (!is_product(s.form) && s.form != Form::scale) return false;
  s.factor = -s.factor;
  return true;
}

bool fuse(Statement& s) {
  s.is_fused = is_product(s.form);
  return s.is_fused;
}

// `at_most` for `below`, `at_least` for `above`.
bool include_equality(Statement& s) {
  if (!is_condition(s.form)) return false;
  s.relation = s.relation == Relation::below ? Relation::at_most : Relation::at_least;
  return true;
}
bool turn_comparison(Statement& s) {
  if (!is_condition(s.form)) return false;
  s.relation = s.relation == Relation::below ? Relation::above : Relation::below;
  return true;
}
bool turn_and_include_equality(Statement& s) { return turn_comparison(s) && include_equality(s); }
bool compare_signed(Statement& s) {
  s.signed_source = s.form == Form::stop;
  return s.signed_source;
}

bool swap_target(Statement& s) {
  if (is_condition(s.form) && s.form != Form::stop) return false;
  if (s.form == Form::first_of) return false;
  s.target = along_other_axis(s.target);
  return true;
}
bool swap_source(Statement& s) {
  if (s.form != Form::move && !is_condition(s.form)) return false;
  s.source = along_other_axis(s.source);
  return true;
}
bool swap_both(Statement& s) { return s.form != Form::wall && swap_source(s) && swap_target(s); }
StatementEdit put_place(WallPlace place) {
  return [place](Statement& s) {
    if ((s.form != Form::clamp && s.form != Form::wall) || s.place == place) return false;
    s.place = place;
    return true;
  };
}
// The other wall of the axis: 0 for the far bound, and the far bound for 0.
bool swap_walls(Statement& s) {
  if (s.form != Form::clamp && s.form != Form::wall) return false;
  if (s.place != WallPlace::zero)
    s.place = WallPlace::zero;
  else
    s.place = s.operation == Operation::wall_x ? WallPlace::right : WallPlace::bottom;
  return true;
}
// The far bound of the other axis.
bool swap_far_bounds(Statement& s) {
  if ((s.form != Form::clamp && s.form != Form::wall) || s.place == WallPlace::zero) return false;
  s.place = s.place == WallPlace::right ? WallPlace::bottom : WallPlace::right;
  return true;
}

class StatementCandidates {
 public:
  explicit StatementCandidates(const Constants& golden)
      : base_(listing(golden)), all_(sites_of(base_)), sets_(site_sets(all_)) {}

  std::vector<Candidate> make() {
    for (const StepSites& sites : sets_) add_dropped_and_doubled(sites);
    add_added();
    for (const StepSites& sites : sets_) add_changed(sites, CauseKind::sign, turn_sign);
    for (const auto& edit : {StatementEdit(include_equality), StatementEdit(turn_comparison),
                             StatementEdit(turn_and_include_equality), StatementEdit(compare_signed)})
      for (const StepSites& sites : sets_) add_changed(sites, CauseKind::comparison, edit);
    for (const auto& edit :
         {StatementEdit(swap_target), StatementEdit(swap_source), StatementEdit(swap_both),
          StatementEdit(swap_walls), StatementEdit(swap_far_bounds), put_place(WallPlace::zero),
          put_place(WallPlace::right), put_place(WallPlace::bottom)})
      for (const StepSites& sites : with_walls()) add_changed(sites, CauseKind::swapped, edit);
    add_fused_by_compiler();
    for (const StepSites& sites : with_products()) add_changed(sites, CauseKind::fused, fuse);
    return std::move(candidates_);
  }

 private:
  void add(const StepSites& sites, CauseKind kind, const std::string& detail, StepStatements step) {
    candidates_.emplace_back(operation_at(all_, sites), kind, detail, std::move(step));
  }

  void add_dropped_and_doubled(const StepSites& sites) {
    const std::string text = text_at(all_, sites);
    add(sites, CauseKind::dropped, "dropped: " + text, edited(base_, sites, [](const StepSite& at) {
          at.list->erase(at.list->begin() + static_cast<std::ptrdiff_t>(at.index));
        }));
    add(sites, CauseKind::doubled, "twice: " + text, edited(base_, sites, [](const StepSite& at) {
          const Statement copy = at.statement();
          at.list->insert(at.list->begin() + static_cast<std::ptrdiff_t>(at.index), copy);
        }));
  }

  // The same edit at all sites, if each of them has it.
  void add_changed(const StepSites& sites, CauseKind kind, const StatementEdit& edit) {
    bool is_possible = true;
    std::string detail;
    const StepStatements step = edited(base_, sites, [&](const StepSite& at) {
      const std::string before = statement_text(at.statement());
      is_possible &= edit(at.statement());
      const std::string change = kind == CauseKind::sign ? "sign changed: " + before
                                 : kind == CauseKind::fused
                                     ? "fused: " + before
                                     : before + " -> " + statement_text(at.statement());
      detail = std::string(at.wall) + change + (detail.empty() ? "" : "; ") + detail;
    });
    if (is_possible) add(sites, kind, detail, step);
  }

  // Friction and the rest rule at the other walls; friction on vy beside that on vx.
  void add_added() {
    for (const StepSites& set : sets_) {
      if (all_[set.front()].statement().form != Form::wall) continue;
      for (const Component speed : {Component::vx, Component::vy})
        add_to_walls(set, {.form = Form::scale,
                           .operation = Operation::friction,
                           .target = speed,
                           .factor = find(Operation::friction).factor});
      add_to_walls(set, find(Operation::rest_rule));
    }
  }
  [[nodiscard]] const Statement& find(Operation operation) const {
    std::size_t site = 0;
    while (all_[site].statement().operation != operation) ++site;
    return all_[site].statement();
  }
  void add_to_walls(const StepSites& walls, const Statement& statement) {
    std::string places;
    for (const std::size_t wall : walls) places += std::string(all_[wall].wall);
    candidates_.emplace_back(
        name_of(statement.operation), CauseKind::added, "added: " + places + statement_text(statement),
        edited(base_, walls, [&](const StepSite& at) { at.statement().body.push_back(statement); }));
  }

  // Also the condition of a wall together with its clamp, and both far walls.
  [[nodiscard]] std::vector<StepSites> with_walls() const {
    std::vector<StepSites> sets = sets_;
    StepSites far;
    for (std::size_t site = 0; site + 1 < all_.size(); ++site) {
      if (all_[site].statement().form != Form::wall) continue;
      sets.push_back({site, site + 1});
      if (all_[site].statement().place != WallPlace::zero) far.insert(far.end(), {site, site + 1});
    }
    sets.push_back(far);
    return sets;
  }
  // As g++ and clang compile the replay's loop: where dt is fixed, GRAVITY * dt is taken out of it.
  void add_fused_by_compiler() {
    const auto [of_y, every] = products();
    const StepSites moves(every.begin() + 1, every.end());
    const auto fuse_at = [](const StepSite& at) { fuse(at.statement()); };
    candidates_.emplace_back(kSeveralOperations, CauseKind::fused,
                             fmt::format("fused by the compiler: {}; where frames vary, {}",
                                         text_at(all_, moves), text_at(all_, {every.front()})),
                             edited(base_, every, fuse_at));
    candidates_.back().even_step = edited(base_, moves, fuse_at);
  }
  // The multiply-adds of y, and all.
  [[nodiscard]] std::pair<StepSites, StepSites> products() const {
    StepSites of_y, every;
    for (std::size_t site = 0; site < all_.size(); ++site) {
      const Statement& s = all_[site].statement();
      if (!is_product(s.form)) continue;
      every.push_back(site);
      if (s.target != Component::x) of_y.push_back(site);
    }
    return {of_y, every};
  }
  // All first, as a compiler fuses them; then each set, and those of y.
  [[nodiscard]] std::vector<StepSites> with_products() const {
    const auto [of_y, every] = products();
    std::vector<StepSites> sets = {every};
    sets.insert(sets.end(), sets_.begin(), sets_.end());
    sets.push_back(of_y);
    return sets;
  }

  StepStatements base_;
  std::vector<StepSite> all_;
  std::vector<StepSites> sets_;
  std::vector<Candidate> candidates_;
};

}  // namespace

std::vector<Candidate> statement_candidates(const Constants& golden) {
  return StatementCandidates(golden).make();
}

}  // namespace hyrax
