#include "studies/dissertation/internal/landmark_columns.h"

#include <algorithm>

namespace glisson::studies {
namespace {

using Eigen::Vector3d;
using rehearsal::Comparison;
using rehearsal::LandmarkDifference;

// The liver's groups, and those of the first that lie near the tool.
std::vector<LandmarkGroup> groups_of(const MeasuredLiver& liver, const Retraction& retraction) {
  std::vector<LandmarkGroup> groups = liver.groups;
  groups.push_back({"near_tool_" + groups.front().name, {}});
  const auto& tool = std::get<mechanics::ToolLoad>(retraction.measured.scenario.loads.front());
  for (const std::size_t landmark : groups.front().members) {
    const Vector3d& rest_mm = liver.landmarks[landmark].position_mm;
    if ((rest_mm - tool.center_mm).norm() <= 2 * tool.radius_mm) groups.back().members.push_back(landmark);
  }
  return groups;
}

double farthest_mm(const Comparison& compared, const LandmarkGroup& group) {
  double mm = 0;
  for (const std::size_t landmark : group.members) mm = std::max(mm, compared.landmarks[landmark].difference_mm);
  return mm;
}

void add_distances(const std::string& prefix, const Comparison& compared, const LandmarkGroup& group,
                   NamedNumbers& row) {
  if (group.members.empty()) return;
  double sum_mm = 0;
  for (const std::size_t landmark : group.members) sum_mm += compared.landmarks[landmark].difference_mm;
  row.emplace_back(prefix + "_mean_mm", sum_mm / static_cast<double>(group.members.size()));
  row.emplace_back(prefix + "_max_mm", farthest_mm(compared, group));
}

}  // namespace

void add_landmark_columns(const MeasuredLiver& liver, const Retraction& retraction, NamedNumbers& row) {
  const std::vector<LandmarkGroup> groups = groups_of(liver, retraction);
  for (const LandmarkGroup& group : groups) {
    row.emplace_back(group.name + "_count", static_cast<double>(group.members.size()));
    add_distances(group.name, retraction.measured_against_reference, group, row);
  }
  const auto mean_of = [](const std::vector<LandmarkDifference>& all, const auto& value_of) {
    double sum = 0;
    for (const LandmarkDifference& one : all) sum += value_of(one);
    return sum / static_cast<double>(all.size());
  };
  const auto apart = [](const LandmarkDifference& one) { return one.difference_mm; };
  const Comparison& linear = retraction.linear_measured_against_reference;
  row.emplace_back("linear_landmarks_max_mm", farthest_mm(linear, groups.front()));
  row.emplace_back("moved_mm", mean_of(linear.landmarks, [](const auto& one) { return one.displacement_a_mm; }));
  row.emplace_back("atlas_moved_mm", mean_of(linear.landmarks, [](const auto& one) { return one.displacement_b_mm; }));
  row.emplace_back("by_stiffness_mm", mean_of(retraction.mean_against_reference.landmarks, apart));
  row.emplace_back("by_texture_mm", mean_of(retraction.measured_against_mean.landmarks, apart));
  row.emplace_back("by_supports_mm", mean_of(retraction.soft_against_stiff_wall->landmarks, apart));
}

void add_engine_columns(const MeasuredLiver& liver, const Retraction& retraction, NamedNumbers& row) {
  row.emplace_back("meshfree_answered", retraction.meshfree ? 1 : 0);
  if (!retraction.meshfree) return;
  const MeshfreeRetraction& meshfree = *retraction.meshfree;
  row.emplace_back("meshfree_lifted_mm", meshfree.measured.result.max_displacement_mm);
  row.emplace_back("meshfree_atlas_lifted_mm", meshfree.reference.result.max_displacement_mm);
  row.emplace_back("meshfree_strain", meshfree.measured.result.largest_strain);
  for (const auto& [prefix, compared] : {std::pair{"meshfree_atlas", &meshfree.measured_against_reference},
                                         std::pair{"engines", &meshfree.against_elements}}) {
    row.emplace_back(std::string(prefix) + "_mean_mm", compared->mean_mm);
    row.emplace_back(std::string(prefix) + "_near_tool_mm", compared->max_near_tool_mm.value_or(0));
    row.emplace_back(std::string(prefix) + "_max_mm", compared->max_mm);
  }
  if (liver.landmarks.empty()) return;
  for (const LandmarkGroup& group : groups_of(liver, retraction)) {
    add_distances("meshfree_" + group.name, meshfree.measured_against_reference, group, row);
    add_distances("engines_" + group.name, meshfree.against_elements, group, row);
  }
}

}  // namespace glisson::studies
