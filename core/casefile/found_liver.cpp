#include "casefile/found_liver.h"

#include <fmt/format.h>

#include "base/files.h"
#include "casefile/internal/structure_making.h"
#include "segmentation/plausibility.h"
#include "shapes/find_liver.h"
#include "shapes/model_file.h"
#include "shapes/smooth_model.h"

namespace glisson::casefile {
namespace {

std::vector<Sentence> notes_on(const shapes::FoundLiver& found, const imaging::Volume& anatomy, bool has_seeds) {
  std::vector<Sentence> notes;
  if (!has_seeds) {
    notes.push_back({GLISSON_TEXT("The liver was found without a point: look at it before you trust it, and give a "
                                  "point inside it where it is wrong."),
                     {}});
  }
  const auto odd = segmentation::doubt_of_liver(found.liver.mask, anatomy);
  if (odd) notes.push_back(*odd);
  for (const auto& doubt : found.liver.doubts) {
    if (!odd || doubt.kind != segmentation::GrowthDoubt::too_small) notes.push_back(doubt.sentence);
  }
  if (found.by_brightness_alone) {
    notes.push_back({GLISSON_TEXT("The liver is what grew by brightness alone: no shape made its border surer."), {}});
    return notes;
  }
  constexpr double half = 0.5;
  if (found.seen_fraction < half) {
    notes.push_back({GLISSON_TEXT("The image shows {0} % of the liver's border; elsewhere the shape leads."),
                     {fmt::format("{:.0f}", 100 * found.seen_fraction)}});
  }
  return notes;
}

}  // namespace

Result<SavedStructure> find_liver(Case& patient, const segmentation::GivenPoints& points, const std::string& shapes,
                                  const Progress& progress) {
  const auto anatomy = patient.volume("volumes/anatomy");
  if (!anatomy) return failure(anatomy.error());
  const bool simulated = shapes == simulated_shapes;
  const auto model = simulated ? shapes::smooth_model() : shapes::read_model(shapes);
  if (!model) return failure(model.error());
  auto found = shapes::find_liver(*anatomy, *model, points, {}, progress);
  if (!found) return failure(found.error());

  Provenance made = made_from_seeds("shape", points.inside_mm);
  keep_points(made, "not", points.outside_mm);
  if (simulated) {
    made.options["shapes"] = simulated_shapes;
  } else {
    const std::filesystem::path file = shapes;
    made.sources[file.filename().string()] = sha256_of_file(file).value_or("unreadable");
  }
  std::vector<Sentence> notes = notes_on(*found, *anatomy, !points.inside_mm.empty());
  auto whole = with_known_lesions(patient, std::move(found->liver.mask), made, notes);
  if (!whole) return failure(whole.error());
  made.notes = notes;
  auto saved = save_structure(patient, segmentation::make_structure("liver", std::move(*whole)), std::move(made));
  if (saved) saved->notes = std::move(notes);
  return saved;
}

}  // namespace glisson::casefile
