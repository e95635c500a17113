#include "rehearsal/internal/tools_between.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace glisson::rehearsal {
namespace {

using Eigen::Vector3d;
using mechanics::ContactTool;
using mechanics::Grasp;
using mechanics::ToolLoad;
using mechanics::TouchingTool;

// A force that stays what it is however the body moves, as jaws and patches pull; nothing of what presses or holds.
std::optional<Vector3d> pull_mN(const ContactTool& tool) {
  if (const auto* patch = std::get_if<ToolLoad>(&tool.what)) return patch->force_mN;
  const auto* grasp = std::get_if<Grasp>(&tool.what);
  const double* pull = grasp == nullptr ? nullptr : std::get_if<double>(&grasp->drawn);
  return pull == nullptr ? std::nullopt : std::optional<Vector3d>(*pull * grasp->direction.normalized());
}

void set_pull(ContactTool& tool, const Vector3d& force_mN) {
  if (auto* patch = std::get_if<ToolLoad>(&tool.what)) {
    patch->force_mN = force_mN;
    return;
  }
  auto& grasp = std::get<Grasp>(tool.what);
  grasp.drawn = force_mN.norm();
  if (force_mN.norm() > 0) grasp.direction = force_mN.normalized();
}

// Of two that pull.
bool on_the_same_patch(const ContactTool& a, const ContactTool& b) {
  if (a.id != b.id || a.what.index() != b.what.index()) return false;
  if (const auto* patch = std::get_if<ToolLoad>(&a.what)) {
    const auto& other = std::get<ToolLoad>(b.what);
    return patch->center_mm == other.center_mm && patch->radius_mm == other.radius_mm;
  }
  const auto &grasp = std::get<Grasp>(a.what), &other = std::get<Grasp>(b.what);
  return grasp.at_rest_mm == other.at_rest_mm && grasp.radius_mm == other.radius_mm;
}

Tools::const_iterator of_id(const Tools& tools, const std::string& id) {
  return std::find_if(tools.begin(), tools.end(), [&](const ContactTool& tool) { return tool.id == id; });
}

// What pulled there before.
Vector3d pull_before_mN(const Tools& from, const ContactTool& now) {
  const auto before = of_id(from, now.id);
  const auto pull = before == from.end() ? std::nullopt : pull_mN(*before);
  return pull && on_the_same_patch(*before, now) ? *pull : Vector3d(0, 0, 0);
}

// Those that pushed or pulled and do so no more, or elsewhere.
Tools let_go(const Tools& from, const Tools& to) {
  Tools gone;
  for (const ContactTool& tool : from) {
    const auto now = of_id(to, tool.id);
    const auto* touching = std::get_if<TouchingTool>(&tool.what);
    const bool pushed = touching != nullptr && touching->push_mN;
    if (pull_mN(tool) ? now == to.end() || !pull_mN(*now) || !on_the_same_patch(tool, *now)
                      : pushed && now == to.end()) {
      gone.push_back(tool);
    }
  }
  return gone;
}

}  // namespace

Tools between(const Tools& from, const Tools& to, double part) {
  Tools tools = to;
  for (ContactTool& tool : tools) {
    const auto before = of_id(from, tool.id);
    if (auto* touching = std::get_if<TouchingTool>(&tool.what)) {
      const auto* old = before == from.end() ? nullptr : std::get_if<TouchingTool>(&before->what);
      if (old == nullptr || !old->push_mN) {
        if (touching->push_mN) *touching->push_mN *= part;
      } else if (touching->push_mN) {
        *touching->push_mN = (1.0 - part) * *old->push_mN + part * *touching->push_mN;
      }
      if (old == nullptr) continue;
      touching->pose.position_mm = (1.0 - part) * old->pose.position_mm + part * touching->pose.position_mm;
    } else if (const auto pull = pull_mN(tool)) {
      if (part < 1) set_pull(tool, (1.0 - part) * pull_before_mN(from, tool) + part * *pull);
    } else {
      Vector3d& drawn_mm = std::get<Vector3d>(std::get<Grasp>(tool.what).drawn);
      const auto* old_grasp = before == from.end() ? nullptr : std::get_if<Grasp>(&before->what);
      const Vector3d* old_mm = old_grasp == nullptr ? nullptr : std::get_if<Vector3d>(&old_grasp->drawn);
      drawn_mm = (1.0 - part) * (old_mm == nullptr ? Vector3d(0, 0, 0) : *old_mm) + part * drawn_mm;
    }
  }
  if (part == 1) return tools;
  for (ContactTool& tool : let_go(from, to)) {
    if (auto* touching = std::get_if<TouchingTool>(&tool.what)) {
      *touching->push_mN *= 1.0 - part;
    } else {
      set_pull(tool, (1.0 - part) * *pull_mN(tool));
      if (of_id(to, tool.id) != to.end()) tool.id += ", let go";
    }
    tools.push_back(std::move(tool));
  }
  return tools;
}

double farthest_move_mm(const Tools& from, const Tools& to) {
  const Tools begin = between(from, to, 0.0);
  double farthest_mm = 0;
  for (std::size_t t = 0; t < to.size(); ++t) {
    if (const auto* touching = std::get_if<TouchingTool>(&to[t].what)) {
      const auto& old = std::get<TouchingTool>(begin[t].what);
      farthest_mm = std::max(farthest_mm, (touching->pose.position_mm - old.pose.position_mm).norm());
    } else if (!pull_mN(to[t])) {
      const auto drawn_mm = [](const ContactTool& tool) {
        return std::get<Vector3d>(std::get<Grasp>(tool.what).drawn);
      };
      farthest_mm = std::max(farthest_mm, (drawn_mm(to[t]) - drawn_mm(begin[t])).norm());
    }
  }
  return farthest_mm;
}

double largest_change_of_push_mN(const Tools& from, const Tools& to) {
  const Tools begin = between(from, to, 0.0);
  double largest_mN = 0;
  for (std::size_t t = 0; t < to.size(); ++t) {
    const auto* touching = std::get_if<TouchingTool>(&to[t].what);
    if (touching == nullptr || !touching->push_mN) continue;
    const double before_mN = std::get<TouchingTool>(begin[t].what).push_mN.value_or(0.0);
    largest_mN = std::max(largest_mN, std::abs(*touching->push_mN - before_mN));
  }
  return largest_mN;
}

double largest_change_of_force_mN(const Tools& from, const Tools& to) {
  double largest_mN = largest_change_of_push_mN(from, to);
  for (const ContactTool& tool : to) {
    if (const auto pull = pull_mN(tool)) largest_mN = std::max(largest_mN, (*pull - pull_before_mN(from, tool)).norm());
  }
  for (const ContactTool& tool : let_go(from, to)) {
    const auto* touching = std::get_if<TouchingTool>(&tool.what);
    largest_mN = std::max(largest_mN, touching != nullptr ? std::abs(*touching->push_mN) : pull_mN(tool)->norm());
  }
  return largest_mN;
}

}  // namespace glisson::rehearsal
