// A generated patient keeps its promises: the volume asked for, closed surfaces, vessels that obey Murray's law, stay
// in the liver, meet nothing and know their segment; and it is the same every time.

#include <gmock/gmock.h>
#include <cmath>
#include <map>
#include <set>

#include "anatomy/internal/capsules.h"
#include "anatomy/landmarks.h"
#include "anatomy/patient.h"
#include "base/parallel.h"

namespace glisson::anatomy {
namespace {

using Eigen::Vector3d;
using geometry::Surface;

const Patient& patient_of(std::uint64_t seed) {
  static std::map<std::uint64_t, Patient> made;
  const auto found = made.find(seed);
  if (found != made.end()) return found->second;
  PatientOptions options;
  options.seed = seed;
  options.lesions = {{LesionKind::tumour, 28, {}, {}}, {LesionKind::tumour, 12, 4, {}}, {LesionKind::cyst, 12, 6, {}}};
  return made.emplace(seed, make_patient(options).value()).first->second;
}

std::vector<const VesselTree*> trees_of(const Patient& patient) {
  return {&patient.portal_vein, &patient.hepatic_vein, &patient.artery};
}

TEST(LevelSurface, OfABallHasItsVolumeAndIsClosed) {
  const Field ball = sampled(grid_over({Vector3d::Constant(-16), Vector3d::Constant(16)}, 1),
                             [](const Vector3d& p) { return p.norm() - 10; });
  const Surface surface = level_surface(ball);
  EXPECT_TRUE(geometry::is_watertight(surface));
  // A net cuts corners off: it lies inside a ball by less than h^2 / 2R.
  EXPECT_NEAR(geometry::volume_mm3(surface), 4.0 / 3 * 3.14159265 * 1000, 4 * 3.14159265 * 100 / 20);
}

TEST(LevelSurface, OfBallsThatTouchAcrossCornersIsAManifold) {
  Field field{grid_over({Vector3d::Zero(), Vector3d::Constant(9)}, 1), {}};
  field.values.assign(field.grid.voxels(), 1);
  field.at(4, 4, 4) = field.at(5, 5, 4) = -0.5f;  // meet along an edge
  field.at(3, 3, 3) = -0.5f;                      // meets the first in a point
  const Surface surface = level_surface(field);
  EXPECT_TRUE(geometry::is_watertight(surface));
  EXPECT_THAT(geometry::pinched_points(surface), testing::IsEmpty());
}

// The standard fixes the engine: its 10,000th value from the default seed. Ours is drawn from the same bits everywhere.
TEST(PortableRandom, GivesTheseNumbersOnEveryMachine) {
  Random random(5489);
  double last = 0;
  for (int i = 0; i < 10000; ++i) last = random.uniform();
  EXPECT_EQ(last, static_cast<double>(9981545732273789042ULL >> 11) * 0x1p-53);
}

TEST(GeneratedPatient, HasTheVolumeAskedFor) {
  for (const double volume_ml : {800.0, 1500.0, 2800.0}) {
    PatientOptions options;
    options.seed = 3;
    options.volume_ml = volume_ml;
    const Patient patient = make_patient(options).value();
    EXPECT_NEAR(geometry::volume_mm3(patient.liver->surface) / 1000, volume_ml, 0.01 * volume_ml);
    double segments_ml = 0;
    for (int segment = 1; segment <= 8; ++segment) segments_ml += patient.segments->volume_ml(segment);
    EXPECT_NEAR(segments_ml, volume_ml, 0.02 * volume_ml);  // counted in voxels of 3 mm
  }
}

TEST(GeneratedPatient, RefusesWhatNoLiverIs) {
  PatientOptions options;
  options.volume_ml = 700;
  EXPECT_EQ(make_patient(options).error().code, "anatomy-volume");
  options.volume_ml = 1500;
  options.tissue.fibrosis_stage = 5;
  EXPECT_EQ(make_patient(options).error().code, "anatomy-tissue");
  options.tissue.fibrosis_stage = 4;
  options.lesions = {{LesionKind::tumour, 140, 1, {}}};
  EXPECT_EQ(make_patient(options).error().code, "anatomy-lesion-no-room");
}

TEST(GeneratedPatient, IsTheSameEveryTimeOnAnyNumberOfThreads) {
  const Patient& first = patient_of(1);
  set_thread_count(1);
  const Patient second = make_patient(first.options).value();
  set_thread_count(0);
  EXPECT_EQ(first.liver->surface.points_mm, second.liver->surface.points_mm);
  for (std::size_t t = 0; t < 3; ++t) {
    const VesselTree &a = *trees_of(first)[t], &b = *trees_of(second)[t];
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    for (std::size_t i = 0; i < a.nodes.size(); ++i) EXPECT_EQ(a.nodes[i].position_mm, b.nodes[i].position_mm);
  }
  EXPECT_NE(first.liver->surface.points_mm, patient_of(2).liver->surface.points_mm);
}

TEST(GeneratedPatient, HasClosedSurfacesOfOnePieceEach) {
  for (const NamedSurface& named : surfaces_of(patient_of(1))) {
    EXPECT_TRUE(geometry::is_watertight(named.surface)) << named.name;
    EXPECT_THAT(geometry::pinched_points(named.surface), testing::IsEmpty()) << named.name;
    EXPECT_GT(geometry::volume_mm3(named.surface), 100) << named.name;
    // Hepatic veins enter the vena cava by themselves.
    if (named.name == "hepatic-vein") continue;
    EXPECT_EQ(geometry::connected_pieces(named.surface).size(), 1u) << named.name;
  }
}

TEST(GeneratedPatient, LiesAsAPatientLies) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Patient& patient = patient_of(seed);
    const Segments& s = *patient.segments;
    for (int segment = 1; segment <= 8; ++segment) EXPECT_GT(s.volume_ml(segment), 5) << segment;
    EXPECT_LT(s.centroid_mm(6).x(), s.centroid_mm(3).x());  // right and left
    EXPECT_GT(s.centroid_mm(7).z(), s.centroid_mm(6).z());  // up and down
    EXPECT_GT(s.centroid_mm(8).z(), s.centroid_mm(5).z());
    EXPECT_LT(s.centroid_mm(5).y(), s.centroid_mm(6).y());  // front and back
    EXPECT_LT(s.centroid_mm(8).y(), s.centroid_mm(7).y());
    const double right = s.volume_ml(5) + s.volume_ml(6) + s.volume_ml(7) + s.volume_ml(8);
    EXPECT_GT(right / patient.options.volume_ml, 0.49);  // Abdalla et al. 2004: 49 to 82 %
    EXPECT_LT(right / patient.options.volume_ml, 0.82);
  }
}

TEST(GeneratedVessels, FollowMurraysLawAtEveryDivision) {
  for (const VesselTree* tree : trees_of(patient_of(1))) {
    const std::vector<int> children = tree->children_counts();
    std::vector<double> cubes(tree->nodes.size(), 0);
    for (std::size_t i = 0; i < tree->nodes.size(); ++i) {
      const VesselNode& node = tree->nodes[i];
      ASSERT_LT(node.parent, static_cast<int>(i));
      if (node.parent >= 0) cubes[static_cast<std::size_t>(node.parent)] += std::pow(node.radius_mm, 3);
    }
    for (std::size_t i = 0; i < tree->nodes.size(); ++i) {
      if (children[i] == 0) continue;
      EXPECT_NEAR(cubes[i], std::pow(tree->nodes[i].radius_mm, 3), 1e-6 * cubes[i]);
    }
    EXPECT_GT(branches_of(*tree).size(), 60u) << system_name(tree->system);
  }
}

TEST(GeneratedVessels, MeetNeitherEachOtherNorThemselves) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Patient& patient = patient_of(seed);
    for (const VesselTree* tree : trees_of(patient)) {
      EXPECT_THAT(meetings_within(*tree, 0), testing::IsEmpty()) << system_name(tree->system) << " of seed " << seed;
    }
    EXPECT_THAT(meetings(patient.portal_vein, patient.hepatic_vein, 0), testing::IsEmpty()) << seed;
    EXPECT_THAT(meetings(patient.portal_vein, patient.artery, 0), testing::IsEmpty()) << seed;
    EXPECT_THAT(meetings(patient.hepatic_vein, patient.artery, 0), testing::IsEmpty()) << seed;
  }
}

TEST(GeneratedVessels, StayInTheLiverAndOutOfLesions) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Patient& patient = patient_of(seed);
    for (const VesselTree* tree : trees_of(patient)) {
      for (const VesselNode& node : tree->nodes) {
        if (node.trunk) continue;  // enters through the porta
        EXPECT_GT(patient.liver->depth_mm(node.position_mm), 0);
        for (const Lesion& lesion : patient.lesions) EXPECT_GT(lesion.distance_mm(node.position_mm), 0);
      }
    }
  }
}

// Every twig of the portal vein ends in the segment that it says it feeds, and every segment has its own pedicle.
TEST(GeneratedVessels, KnowTheirSegment) {
  const Patient& patient = patient_of(1);
  const std::vector<int> children = patient.portal_vein.children_counts();
  std::map<int, int> ends;
  for (std::size_t i = 0; i < patient.portal_vein.nodes.size(); ++i) {
    const VesselNode& node = patient.portal_vein.nodes[i];
    if (children[i] > 0) continue;
    ++ends[node.segment];
    if (node.trunk) continue;  // a pedicle that a lesion cuts short may end before its segment
    EXPECT_EQ(node.segment, patient.segments->at(node.position_mm));
  }
  for (int segment = 1; segment <= 8; ++segment) EXPECT_GE(ends[segment], 1) << segment;
}

// The right hepatic vein runs between the anterior and the posterior segments, the middle one between right and left.
TEST(GeneratedVessels, HepaticVeinsRunBetweenSegments) {
  const Patient& patient = patient_of(1);
  const auto either_side = [&](const VesselNode& node) {
    std::set<int> found;
    for (const double by : {-9.0, 9.0}) {
      found.insert(patient.segments->at(node.position_mm + Vector3d(by, 0, 0)));
      found.insert(patient.segments->at(node.position_mm + Vector3d(0, by, 0)));
    }
    return found.size() > 1;
  };
  int trunks = 0, between = 0;
  for (const VesselNode& node : patient.hepatic_vein.nodes) {
    if (!node.trunk || node.segment != 0) continue;
    ++trunks;
    between += either_side(node) ? 1 : 0;
  }
  EXPECT_GT(trunks, 15);
  EXPECT_GE(between, 0.9 * trunks);
}

TEST(GeneratedLesions, LieWhereTheyWereWishedAndApart) {
  const Patient& patient = patient_of(1);
  ASSERT_EQ(patient.lesions.size(), 3u);
  EXPECT_EQ(patient.lesions[1].segment, 4);
  EXPECT_EQ(patient.lesions[2].segment, 6);
  EXPECT_EQ(patient.lesions[2].name, "cyst-1");
  for (std::size_t a = 0; a < 3; ++a) {
    EXPECT_GT(patient.liver->depth_mm(patient.lesions[a].center_mm), patient.lesions[a].radius_mm);
    for (std::size_t b = 0; b < a; ++b) {
      EXPECT_GT((patient.lesions[a].center_mm - patient.lesions[b].center_mm).norm(),
                patient.lesions[a].radius_mm + patient.lesions[b].radius_mm);
    }
  }
}

TEST(GeneratedVariants, LackTheirLobeOrAreMirrored) {
  PatientOptions options;
  options.seed = 2;
  options.volume_ml = 1400;
  const auto share_of_left = [](const Patient& p) {
    return (p.segments->volume_ml(2) + p.segments->volume_ml(3)) / p.options.volume_ml;
  };
  const Patient usual = make_patient(options).value();
  options.lobes = LobeVariant::no_left_lobe;
  EXPECT_LT(share_of_left(make_patient(options).value()), 0.5 * share_of_left(usual));
  options.lobes = LobeVariant::small_right_lobe;
  EXPECT_GT(share_of_left(make_patient(options).value()), 1.3 * share_of_left(usual));
  options.lobes = LobeVariant::turned;
  const Patient turned = make_patient(options).value();
  const Surface mirrored = surfaces_of(turned).front().surface;
  EXPECT_NEAR(geometry::volume_mm3(mirrored), 1.4e6, 100);  // still outwards
  for (std::size_t i = 0; i < mirrored.points_mm.size(); i += 100) {
    EXPECT_EQ(mirrored.points_mm[i].x(), -usual.liver->surface.points_mm[i].x());
  }
}

TEST(GeneratedPatient, HasTheSameLiverWithoutItsVessels) {
  for (const LobeVariant lobes : {LobeVariant::usual, LobeVariant::turned}) {
    PatientOptions options;
    options.seed = 2;
    options.lobes = lobes;
    options.portal_terminals = options.hepatic_terminals = options.arterial_terminals = 2;
    const Surface whole = surfaces_of(make_patient(options).value()).front().surface;
    const Surface alone = make_liver_surface(options).value();
    EXPECT_EQ(alone.points_mm, whole.points_mm);
    EXPECT_EQ(alone.triangles, whole.triangles);
  }
  PatientOptions impossible;
  impossible.volume_ml = 5000;
  EXPECT_EQ(make_liver_surface(impossible).error().code, "anatomy-volume");
}

// Which segments the twigs beyond a node feed, by following each twig back to the entry.
std::set<int> fed_beyond(const VesselTree& tree, std::size_t node) {
  std::set<int> segments;
  const std::vector<int> children = tree.children_counts();
  for (std::size_t twig = 0; twig < tree.nodes.size(); ++twig) {
    if (children[twig] > 0) continue;
    int at = static_cast<int>(twig);
    while (at >= 0 && at != static_cast<int>(node)) at = tree.nodes[static_cast<std::size_t>(at)].parent;
    if (at >= 0) segments.insert(tree.nodes[twig].segment);
  }
  return segments;
}

TEST(GeneratedLandmarks, LieWhereTheVesselsThatTheyNamePart) {
  const std::map<std::string, std::set<int>> feeds = {
      {"portal-right-division", {5, 6, 7, 8}},     {"portal-right-anterior-division", {5, 8}},
      {"portal-right-posterior-division", {6, 7}}, {"portal-left-division", {2, 3, 4}},
      {"portal-umbilical-division", {3, 4}},       {"portal-segment-2-division", {2}},
      {"portal-segment-6-division", {6}}};
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Patient& patient = patient_of(seed);
    const std::vector<Landmark> landmarks = landmarks_of(patient);
    std::set<std::string> names;
    for (const Landmark& landmark : landmarks) {
      EXPECT_TRUE(names.insert(landmark.id).second) << landmark.id;
      EXPECT_GE(patient.liver->depth_mm(landmark.position_mm), 3) << landmark.id;
      const VesselTree& tree = landmark.structure == "portal-vein" ? patient.portal_vein : patient.hepatic_vein;
      const auto node = std::find_if(tree.nodes.begin(), tree.nodes.end(),
                                     [&](const VesselNode& one) { return one.position_mm == landmark.position_mm; });
      ASSERT_NE(node, tree.nodes.end()) << landmark.id << " lies on no vessel";
      const auto index = static_cast<std::size_t>(node - tree.nodes.begin());
      EXPECT_GE(tree.children_counts()[index], 2) << landmark.id << " is no division";
      if (feeds.contains(landmark.id)) {
        EXPECT_EQ(fed_beyond(tree, index), feeds.at(landmark.id)) << landmark.id;
      }
    }
    EXPECT_TRUE(names.contains("portal-right-anterior-division") && names.contains("hepatic-confluence")) << seed;
    const auto height_mm = [&](const std::string& id) {
      const auto found =
          std::find_if(landmarks.begin(), landmarks.end(), [&](const auto& one) { return one.id == id; });
      return found == landmarks.end() ? -1e9 : found->position_mm.z();
    };
    if (names.contains("hepatic-right-inferior-division")) {
      EXPECT_LT(height_mm("hepatic-right-inferior-division"), height_mm("hepatic-right-division"));
    }
  }
}

}  // namespace
}  // namespace glisson::anatomy
