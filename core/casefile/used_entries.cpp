#include "casefile/used_entries.h"

#include <algorithm>

#include "geometry/mesh_file.h"
#include "imaging/volume_file.h"

namespace glisson::casefile {
namespace {

Failure of_another(const Case& patient, const std::string& id) {
  return failure(Error{"model-of-another",
                       GLISSON_TEXT("{0} was replaced by another program and does not fit the liver of this case."),
                       {id},
                       GLISSON_TEXT("Put the file back, or make it anew: glisson-cli segment, mesh, stiffness."),
                       patient.folder()});
}

bool same_points(const geometry::TetMesh& a, const geometry::TetMesh& b) {
  constexpr double near_mm = 1e-3;  // files may hold single precision
  return a.cells == b.cells && std::equal(a.points_mm.begin(), a.points_mm.end(), b.points_mm.begin(),
                                          b.points_mm.end(), [](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
                                            return (p - q).cwiseAbs().maxCoeff() <= near_mm;
                                          });
}

bool mostly_inside(const geometry::TetMesh& mesh, const imaging::Mask& label) {
  std::size_t inside = 0;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const Eigen::Vector3d index = label.grid.index_of(geometry::cell_centroid_mm(mesh, cell)).array().round();
    const Eigen::Vector3d last(label.grid.size[0] - 1, label.grid.size[1] - 1, label.grid.size[2] - 1);
    if (!(index.array() >= 0).all() || !(index.array() <= last.array()).all()) continue;
    inside += label.at(int(index[0]), int(index[1]), int(index[2])) != 0 ? 1 : 0;
  }
  return 2 * inside >= mesh.cells.size();
}

// Of what a stale entry was made from, on and on, the one whose own sources have changed.
std::string first_stale(const Case& patient, const std::string& id) {
  for (const auto& [source, content] : patient.find(id)->from_sha256) {
    if (patient.find(source) != nullptr && patient.freshness(source) == Freshness::stale) {
      return first_stale(patient, source);
    }
  }
  return id;
}

}  // namespace

std::vector<Sentence> remarks_on(const Case& patient, const std::vector<std::string>& ids) {
  std::vector<Sentence> remarks;
  for (const std::string& id : ids) {
    if (patient.find(id) == nullptr) continue;
    const Freshness freshness = patient.freshness(id);
    if (freshness == Freshness::changed_outside) {
      remarks.push_back({GLISSON_TEXT("Another program has changed {0} since it was saved."), {id}});
    } else if (freshness == Freshness::stale) {
      const std::string first = first_stale(patient, id);
      remarks.push_back(
          first == id
              ? Sentence{GLISSON_TEXT("What {0} was made from has changed since: make it anew."), {id}}
              : Sentence{GLISSON_TEXT("What {1} was made from has changed since, and {0} was made from that: make {1} "
                                      "anew, then {0}."),
                         {id, first}});
    }
  }
  return remarks;
}

std::vector<Sentence> model_remarks(const Case& patient) {
  std::vector<std::string> used{"meshes/model"};
  for (const Entry& entry : patient.entries()) {
    // That an outline is stale, the model's own staleness says.
    const bool outline = entry.id.starts_with("surfaces/") && patient.freshness(entry.id) == Freshness::changed_outside;
    if (outline || entry.id.starts_with("labels/")) used.push_back(entry.id);
  }
  return remarks_on(patient, used);
}

Result<void> check_own_mesh(const Case& patient, const geometry::TetMesh& mesh) {
  const auto replaced = [&](const char* id) {
    return patient.find(id) != nullptr && patient.freshness(id) == Freshness::changed_outside;
  };
  const bool model_replaced = replaced("meshes/model"), liver_replaced = replaced("meshes/liver");
  if (model_replaced && !liver_replaced && patient.find("meshes/liver") != nullptr) {
    const auto liver =
        patient.file_of("meshes/liver").and_then([](const auto& file) { return geometry::read_tetrahedra(file); });
    if (liver && !same_points(mesh, *liver)) return of_another(patient, "meshes/model");
  }
  const bool label_replaced = replaced("labels/liver");
  if ((model_replaced || liver_replaced || label_replaced) && patient.find("labels/liver") != nullptr) {
    const auto label =
        patient.file_of("labels/liver").and_then([](const auto& file) { return imaging::read_mask_file(file); });
    if (!label) return failure(label.error());
    if (!mostly_inside(mesh, label->mask)) return of_another(patient, label_replaced ? "labels/liver" : "meshes/model");
  }
  return {};
}

}  // namespace glisson::casefile
