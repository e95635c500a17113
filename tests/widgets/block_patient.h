#pragma once
// A patient for tests of the window: a block of 120 x 80 x 80 mm as the liver, held at its left end, twice as soft as
// its reference body (the atlas).

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "support/shapes.h"
#include "widgets/session/patient.h"

namespace glisson::widgets {

inline Patient block_patient(const std::array<int, 3>& bricks, std::vector<mechanics::Landmark> landmarks,
                             const std::vector<PatientStructure>& inside) {
  rehearsal::RehearsalSetup setup;
  setup.mesh = test::box_of_tetrahedra(bricks, {120, 80, 80});
  setup.patient_youngs_kPa.assign(setup.mesh.cells.size(), 4.0);
  setup.reference_youngs_kPa = 8.0;
  setup.supports = {{geometry::Box{{-1, -1, -1}, {1, 81, 81}}, mechanics::Fixed{}}};
  setup.landmarks = std::move(landmarks);
  Patient patient;
  patient.name = "Block";
  patient.structures = {{"liver", std::make_shared<geometry::Surface>(boundary_surface(setup.mesh)), 768}};
  patient.structures.insert(patient.structures.end(), inside.begin(), inside.end());
  for (const PatientStructure& structure : patient.structures) setup.structures.push_back(*structure.surface);
  patient.rehearsal_setup = std::make_shared<rehearsal::RehearsalSetup>(setup);
  auto body = rehearsal::StaticRehearsal::create(std::move(setup));
  if (!body) qFatal("%s", body.error().message().c_str());
  patient.rehearsal = std::make_shared<rehearsal::StaticRehearsal>(*std::move(body));
  return patient;
}

}  // namespace glisson::widgets
