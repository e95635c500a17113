// Units come as UCUM codes (real-world-value mapping), as the terms of RescaleType (PS3.3 C.11.1.1.2), or freely spelt.

#include "imaging/internal/value_mapping.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "imaging/internal/dicom_fields.h"

namespace glisson::imaging {
namespace {

struct KnownUnit {
  const char* written;  // in capitals
  const char* unit;
  double factor;
};

constexpr KnownUnit known_units[] = {{"HU", "HU", 1},
                                     {"[HNSF'U]", "HU", 1},
                                     {"PA", "Pa", 1},
                                     {"PASCAL", "Pa", 1},
                                     {"KPA", "kPa", 1},
                                     {"KILOPASCAL", "kPa", 1},
                                     {"RAD", "rad", 1},
                                     {"RADIANS", "rad", 1},
                                     {"RADIAN", "rad", 1},
                                     {"MRAD", "rad", 1e-3},
                                     {"UM", "um", 1},
                                     {"MICROMETER", "um", 1},
                                     {"MICROMETRE", "um", 1},
                                     {"MILLIRADIAN", "rad", 1e-3},
                                     {"MILLIRADIANS", "rad", 1e-3}};

void apply_unit(ValueMapping& mapping, const std::string& written, const std::string& field) {
  for (const KnownUnit& known : known_units) {
    if (upper_case(written) != known.written) continue;
    mapping.unit = known.unit;
    mapping.slope *= known.factor;
    mapping.intercept *= known.factor;
    mapping.evidence = field + " is " + written;
  }
}

ValueMapping one_real_world_mapping(DcmItem& item) {
  ValueMapping mapping;
  const auto slope = number_of(item, DCM_RealWorldValueSlope);
  const auto intercept = number_of(item, DCM_RealWorldValueIntercept);
  if (!slope || !intercept || *slope == 0) return mapping;
  mapping = {*slope, *intercept, "", "", true};
  if (DcmItem* code = item_of(item, DCM_MeasurementUnitsCodeSequence)) {
    apply_unit(mapping, text_of(*code, DCM_CodeValue), "the unit of the real-world-value mapping");
  }
  return mapping;
}

}  // namespace

ValueMapping rescale_of(DcmItem& item) {
  ValueMapping mapping;
  const auto slope = number_of(item, DCM_RescaleSlope);
  const auto intercept = number_of(item, DCM_RescaleIntercept);
  if ((!slope && !intercept) || slope.value_or(1) == 0) return mapping;
  mapping = {slope.value_or(1), intercept.value_or(0), "", "", true};
  apply_unit(mapping, text_of(item, DCM_RescaleType), "RescaleType");
  return mapping;
}

ValueMapping real_world_mapping_of(DcmItem& item) {
  ValueMapping first;
  for (unsigned n = 0; n < 16; ++n) {
    DcmItem* one = item_of(item, DCM_RealWorldValueMappingSequence, n);
    if (one == nullptr) break;
    const ValueMapping mapping = one_real_world_mapping(*one);
    if (!mapping.unit.empty()) return mapping;
    if (mapping.stated && !first.stated) first = mapping;
  }
  return first;
}

ValueMapping preferred(const ValueMapping& rescale, const ValueMapping& real_world) {
  if (!real_world.unit.empty() || (real_world.stated && !rescale.stated)) return real_world;
  return rescale;
}

void add_implied_unit(ValueMapping& mapping, const DicomImage& image) {
  if (!mapping.unit.empty() || !mapping.stated) return;
  if (image.modality == "CT") {
    mapping.unit = "HU";
    mapping.evidence = "a CT image with a rescale";
    return;
  }
  // Siemens stores phase in 12 bits and rescales it to -4096 .. 4094, which stands for -pi .. pi.
  const bool siemens_phase = upper_case(image.manufacturer).find("SIEMENS") != std::string::npos &&
                             image.image_type.size() > 2 && image.image_type[2] == "P" && mapping.slope == 2 &&
                             mapping.intercept == -4096;
  if (siemens_phase) {
    mapping.slope *= std::numbers::pi / 4096;
    mapping.intercept *= std::numbers::pi / 4096;
    mapping.unit = "rad";
    mapping.evidence = "a Siemens phase image rescaled to -4096 .. 4094, which is -pi .. pi";
  }
}

}  // namespace glisson::imaging
