#pragma once
// The small case with a tumour in its liver and a model: something to rehearse, resect and report.

#include "casefile/model.h"
#include "small_case.h"

namespace glisson::widgets::test {

inline fs::path modelled_case(const fs::path& parent) {
  const fs::path folder = small_case(parent);
  if (!save_ball(folder, "tumour-1", 5)) qFatal("no tumour for the test");
  auto opened = casefile::Case::open(folder);
  meshing::MeshOptions options;
  options.target_cells = 800;
  if (const auto meshed = casefile::mesh_liver(*opened, options); !meshed) {
    qFatal("%s", meshed.error().message().c_str());
  }
  if (const auto given = casefile::assign_stiffness(*opened, casefile::Uniform{6.0}); !given) {
    qFatal("%s", given.error().message().c_str());
  }
  return folder;
}

}  // namespace glisson::widgets::test
