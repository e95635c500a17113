#pragma once
// A generated patient with a lesion as a case: liver, portal and hepatic veins, an artery and a tumour outlined, a
// stiffness map over most of it, and a model.

#include "anatomy/write_patient.h"
#include "casefile/model.h"
#include "small_case.h"

namespace glisson::widgets::test {

inline fs::path vascular_case(const fs::path& parent) {
  const auto fail = [](const Error& error) { qFatal("%s", error.message().c_str()); };
  anatomy::PatientOptions options;
  options.seed = 31;
  options.lesions.emplace_back();
  const auto generated = anatomy::make_patient(options);
  if (!generated) fail(generated.error());
  const fs::path files = parent / "generated", folder = parent / "generated.glisson";
  anatomy::WriteOptions labels;
  labels.label_spacing_mm = 2;
  if (const auto written = anatomy::write_patient(files, *generated, labels); !written) fail(written.error());
  auto patient = casefile::Case::create(folder);
  const auto liver = imaging::read_mask_file(files / "labels" / "liver.nrrd");
  if (!liver) fail(liver.error());
  const auto add = [&](const char* id, float inside, float outside, const char* unit) {
    imaging::Volume volume{{liver->mask.grid, {}}, unit};
    for (const std::uint8_t value : liver->mask.values) volume.values.push_back(value != 0 ? inside : outside);
    const auto added = patient->add(id, ".nrrd", {"import", {}, {}, {}, {}},
                                    [&](const fs::path& file) { return imaging::write_volume_file(file, volume); });
    if (!added) fail(added.error());
  };
  add("volumes/anatomy", 110, 20, "");
  add("volumes/stiffness", 2.4F, 0, "kPa");
  for (const char* name : {"liver", "portal-vein", "hepatic-vein", "artery", "tumour-1"}) {
    const auto taken =
        casefile::import_structure(*patient, name, files / "labels" / (std::string(name) + ".nrrd"), std::nullopt);
    if (!taken) fail(taken.error());
  }
  meshing::MeshOptions cells;
  cells.target_cells = 3000;
  if (const auto meshed = casefile::mesh_liver(*patient, cells); !meshed) fail(meshed.error());
  if (const auto given = casefile::assign_stiffness(*patient, casefile::FromMre{}); !given) fail(given.error());
  return folder;
}

}  // namespace glisson::widgets::test
