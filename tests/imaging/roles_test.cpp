// What vendors write, and what we make of it.

#include "imaging/internal/roles.h"

#include <gmock/gmock.h>

namespace glisson::imaging {
namespace {

RoleClues mr(const std::string& description, std::vector<std::string> image_type = {"ORIGINAL", "PRIMARY"}) {
  RoleClues clues;
  clues.modality = "MR";
  clues.description = description;
  clues.image_type = std::move(image_type);
  return clues;
}

// GE sends its derived series under the number of the measured one with two digits more.
RoleClues ge(int series_number, int volumes, std::vector<std::string> image_type) {
  RoleClues clues = mr("2D GRE", std::move(image_type));
  clues.manufacturer = "GE MEDICAL SYSTEMS";
  clues.ge_pulse_sequence = "fgremre";
  clues.series_number = series_number;
  clues.volumes = volumes;
  return clues;
}

TEST(Roles, OfGeElastographyFollowPulseSequenceAndSeriesNumber) {
  RoleClues stiffness = ge(701, 1, {"DERIVED", "SECONDARY", "PROCESSED"});
  stiffness.window_center = 4000;
  stiffness.window_width = 8000;
  EXPECT_EQ(role_of(stiffness).role, Role::mre_stiffness);
  EXPECT_EQ(role_of(ge(705, 8, {"DERIVED", "SECONDARY", "PROCESSED"})).role, Role::mre_wave);
  EXPECT_EQ(role_of(ge(705, 8, {"ORIGINAL", "PRIMARY", "OTHER"})).role, Role::mre_wave);  // seen so, too
  EXPECT_EQ(role_of(ge(707, 8, {"DERIVED", "SECONDARY", "PROCESSED"})).role, Role::mre_wave);
  RoleClues confidence = ge(707, 1, {"DERIVED", "SECONDARY", "PROCESSED"});
  confidence.window_center = 950;
  confidence.window_width = 100;
  EXPECT_EQ(role_of(confidence).role, Role::mre_confidence);

  RoleClues raw = ge(7, 4, {"ORIGINAL", "PRIMARY", "OTHER"});
  EXPECT_EQ(role_of(raw).role, Role::other);  // nothing says which part
  raw.component = "P";
  EXPECT_EQ(role_of(raw).role, Role::mre_phase);
  raw.component = "M";
  EXPECT_EQ(role_of(raw).role, Role::mre_magnitude);

  RoleClues screen = ge(702, 1, {"DERIVED", "SECONDARY", "SCREEN SAVE"});
  screen.is_colour = true;
  EXPECT_EQ(role_of(screen).role, Role::other);
}

TEST(Roles, OfSiemensElastographyFollowImageTypeAndDescription) {
  RoleClues phase = mr("greMRE_60Hz", {"ORIGINAL", "PRIMARY", "P", "ND"});
  phase.component = "P";
  EXPECT_EQ(role_of(phase).role, Role::mre_phase);
  RoleClues magnitude = mr("greMRE_60Hz", {"ORIGINAL", "PRIMARY", "M", "ND"});
  magnitude.component = "M";
  EXPECT_EQ(role_of(magnitude).role, Role::mre_magnitude);
  EXPECT_EQ(role_of(mr("greMRE_60Hz_STIFFNESS", {"DERIVED", "PRIMARY", "M", "ND"})).role, Role::mre_stiffness);
  EXPECT_EQ(role_of(mr("greMRE_60Hz_WAVE")).role, Role::mre_wave);
  EXPECT_EQ(role_of(mr("greMRE_60Hz_Confidence Map")).role, Role::mre_confidence);
  EXPECT_EQ(role_of(mr("greMRE Elastogram with confidence mask")).role, Role::mre_stiffness);
  RoleClues by_comment = mr("ep2d_brain", {"ORIGINAL", "PRIMARY", "P", "ND", "MOSAIC"});
  by_comment.comments = "MRE: fI[0]dI[0]az[189]";
  by_comment.component = "P";
  EXPECT_EQ(role_of(by_comment).role, Role::mre_phase);
}

TEST(Roles, OfMapsFollowTheirUnit) {
  RoleClues map = mr("eMRE result 3", {"DERIVED", "SECONDARY"});
  map.unit = "Pa";
  EXPECT_EQ(role_of(map).role, Role::mre_stiffness);
  map.description = "MRE storage modulus";
  EXPECT_EQ(role_of(map).role, Role::other);
  map.description = "MRE shear wave speed";
  map.unit = "";
  EXPECT_EQ(role_of(map).role, Role::other);
}

TEST(Roles, AreAnatomyOnlyForImagesOfTheBody) {
  EXPECT_EQ(role_of(mr("T2 HASTE cor")).role, Role::anatomy);
  EXPECT_EQ(role_of(mr("LiverLab e-Dixon water")).role, Role::anatomy);
  EXPECT_EQ(role_of(mr("localizer")).role, Role::other);
  EXPECT_EQ(role_of(mr("dwi", {"DERIVED", "PRIMARY", "ADC"})).role, Role::other);
  RoleClues flow = mr("4D flow");
  flow.component = "P";
  EXPECT_EQ(role_of(flow).role, Role::other);
  RoleClues secondary;
  secondary.modality = "OT";
  EXPECT_EQ(role_of(secondary).role, Role::other);
}

// Words that only contain the letters must not mislead: "MREA", "wavelet" in a description of an anatomy.
TEST(Roles, AreNotTakenFromOrdinaryWords) {
  EXPECT_EQ(role_of(mr("T1 wavelet denoised")).role, Role::anatomy);
  EXPECT_EQ(role_of(mr("stir cor")).role, Role::anatomy);
  EXPECT_EQ(role_of(mr("phase oversampling t2")).role, Role::anatomy);
}

TEST(Roles, OfVolumeFilesFollowTheirNames) {
  EXPECT_EQ(role_of_volume_file("example_seg_mr.nii.gz", false).role, Role::segmentation);
  EXPECT_EQ(role_of_volume_file("liver.nii.gz", true).role, Role::segmentation);
  EXPECT_EQ(role_of_volume_file("017Stiffness_warped.nii.gz", false).role, Role::mre_stiffness);
  EXPECT_EQ(role_of_volume_file("patient-ct.nrrd", false).role, Role::anatomy);
}

}  // namespace
}  // namespace glisson::imaging
