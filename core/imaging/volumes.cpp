// Pictures at the same position: several volumes, or a slice that is there twice?

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "imaging/internal/stacks.h"

namespace glisson::imaging {
namespace {

using Pictures = std::vector<PictureRef>;
using Images = std::vector<DicomImage>;

// A header field that may count the volumes, and how to speak of its value.
struct CountingField {
  std::string name;
  std::function<double(const DicomImage&, const Picture&)> value;
};

const std::vector<CountingField>& counting_fields();
std::vector<Pictures> gather_by_position(const Images& images, const Stack& stack, std::vector<double>& positions_mm);
std::size_t usual_count(const std::vector<Pictures>& at_position);
const CountingField* field_that_counts(const Images& images, const std::vector<Pictures>& at_position,
                                       std::size_t count);
void keep_complete_volumes(const Images& images, const std::vector<Pictures>& at_position, const CountingField& field,
                           Volumes& volumes);
void name_doubled_slices(const Images& images, const std::vector<Pictures>& at_position, std::size_t count,
                         Volumes& volumes);

}  // namespace

Volumes part_into_volumes(const Images& images, const Stack& stack) {
  Volumes volumes;
  const std::vector<Pictures> at_position = gather_by_position(images, stack, volumes.positions_mm);
  const std::size_t count = usual_count(at_position);

  const CountingField* field = count > 1 ? field_that_counts(images, at_position, count) : nullptr;
  if (field != nullptr) {
    keep_complete_volumes(images, at_position, *field, volumes);
    if (!volumes.of_volume.empty()) return volumes;
  }
  // Taken in their order of acquisition, as many as there are everywhere.
  name_doubled_slices(images, at_position, count, volumes);
  std::size_t everywhere = count;
  for (const Pictures& here : at_position) everywhere = std::min(everywhere, here.size());
  if (everywhere < count) {
    volumes.problems.push_back(
        fmt::format("Most positions have {} pictures but some only {}, and no header field tells "
                    "the volumes apart: the first {} of each are taken in order of acquisition.",
                    count, everywhere, everywhere));
  }
  volumes.of_volume.assign(everywhere, {});
  for (std::size_t v = 0; v < everywhere; ++v) {
    for (const Pictures& here : at_position) volumes.of_volume[v].push_back(here[v]);
    if (everywhere > 1) volumes.labels.push_back(fmt::format("picture {} at each position", v + 1));
  }
  return volumes;
}

namespace {

const std::vector<CountingField>& counting_fields() {
  static const std::vector<CountingField> fields = {
      {"temporal position", [](const DicomImage&, const Picture& p) { return double(p.temporal_position); }},
      {"acquisition", [](const DicomImage& i, const Picture&) { return double(i.acquisition_number); }},
      {"trigger time in ms", [](const DicomImage&, const Picture& p) { return p.trigger_time_ms; }},
      {"b-value", [](const DicomImage&, const Picture& p) { return p.b_value; }},
      {"echo time in ms", [](const DicomImage&, const Picture& p) { return p.echo_time_ms; }},
  };
  return fields;
}

// In order of acquisition at each position. Without positions every picture is a slice of its own, by instance number.
std::vector<Pictures> gather_by_position(const Images& images, const Stack& stack, std::vector<double>& positions_mm) {
  struct Placed {
    double position_mm;
    PictureRef ref;
  };
  const bool placed = picture_of(images, stack.pictures.front()).placed;
  std::vector<Placed> ordered;
  for (const PictureRef& ref : stack.pictures) {
    ordered.push_back({placed ? position_along_normal_mm(picture_of(images, ref)) : 0.0, ref});
  }
  const auto acquired = [&](const PictureRef& ref) {
    const DicomImage& image = images[ref.image];
    const Picture& picture = picture_of(images, ref);
    const Eigen::Vector3d along = picture.motion_along.value_or(Eigen::Vector3d::Zero());
    return std::make_tuple(picture.temporal_position, along.x(), along.y(), along.z(), image.instance_number,
                           image.acquisition_time, ref.picture, image.path);
  };
  std::sort(ordered.begin(), ordered.end(), [&](const Placed& a, const Placed& b) {
    return a.position_mm != b.position_mm ? a.position_mm < b.position_mm : acquired(a.ref) < acquired(b.ref);
  });
  // Decimals of a DICOM position; finer than any slice of a patient.
  const double pixel_mm = picture_of(images, stack.pictures.front()).column_spacing_mm;
  const double same_mm = std::min(0.01, 0.1 * pixel_mm);
  std::vector<Pictures> at_position;
  for (const Placed& next : ordered) {
    if (!placed) {
      positions_mm.push_back(static_cast<double>(positions_mm.size()));
      at_position.push_back({next.ref});
    } else if (at_position.empty() || next.position_mm - positions_mm.back() > same_mm) {
      positions_mm.push_back(next.position_mm);
      at_position.push_back({next.ref});
    } else {
      at_position.back().push_back(next.ref);
    }
  }
  for (Pictures& here : at_position) {
    std::sort(here.begin(), here.end(),
              [&](const PictureRef& a, const PictureRef& b) { return acquired(a) < acquired(b); });
  }
  return at_position;
}

// How many pictures most positions have.
std::size_t usual_count(const std::vector<Pictures>& at_position) {
  std::map<std::size_t, std::size_t> positions_with;
  for (const Pictures& here : at_position) ++positions_with[here.size()];
  const auto maximum = std::max_element(positions_with.begin(), positions_with.end(),
                                        [](const auto& a, const auto& b) { return a.second < b.second; });
  return maximum->first;
}

const CountingField* field_that_counts(const Images& images, const std::vector<Pictures>& at_position,
                                       std::size_t count) {
  for (const CountingField& field : counting_fields()) {
    std::set<double> seen;
    bool once_everywhere = true;
    for (const Pictures& here : at_position) {
      std::set<double> seen_here;
      for (const PictureRef& ref : here) {
        const double value = field.value(images[ref.image], picture_of(images, ref));
        once_everywhere = once_everywhere && seen_here.insert(value).second;
        seen.insert(value);
      }
    }
    if (once_everywhere && seen.size() == count) return &field;
  }
  return nullptr;
}

void keep_complete_volumes(const Images& images, const std::vector<Pictures>& at_position, const CountingField& field,
                           Volumes& volumes) {
  std::map<double, Pictures> slices_with;
  for (const Pictures& here : at_position) {
    for (const PictureRef& ref : here) {
      slices_with[field.value(images[ref.image], picture_of(images, ref))].push_back(ref);
    }
  }
  for (auto& [value, slices] : slices_with) {
    if (slices.size() == at_position.size()) {
      volumes.of_volume.push_back(std::move(slices));
      volumes.labels.push_back(fmt::format("{} {}", field.name, value));
    } else {
      volumes.problems.push_back(fmt::format("The volume with {} {} has only {} of {} slices and is left out.",
                                             field.name, value, slices.size(), at_position.size()));
    }
  }
}

void name_doubled_slices(const Images& images, const std::vector<Pictures>& at_position, std::size_t count,
                         Volumes& volumes) {
  for (const Pictures& here : at_position) {
    if (here.size() <= count) continue;
    volumes.problems.push_back(
        fmt::format("A slice is there twice: {} and {} stand at the same position; the first is "
                    "taken.",
                    name_of(images, here[count - 1]), name_of(images, here[count])));
  }
}

}  // namespace
}  // namespace glisson::imaging
