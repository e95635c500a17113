#include "base/json_reading.h"

#include <gmock/gmock.h>

namespace glisson {
namespace {

struct Lens {
  std::string name;
  double radius_mm = 0;
  Eigen::Vector3d center_mm{0, 0, 0};
  bool coated = false;
};

Lens lens_from(const Json& json, const std::string& where) {
  only_keys(json, {"name", "radius_mm", "center_mm", "coating"}, where);
  Lens lens;
  lens.name = name_in(required(json, "name", where), where + ", name");
  lens.radius_mm = positive_in(required(json, "radius_mm", where), where + ", radius_mm");
  if (json.contains("center_mm")) lens.center_mm = vector_in(json["center_mm"], where + ", center_mm");
  if (json.contains("coating"))
    lens.coated = one_of<bool>(json["coating"], where + ", coating", {{"none", false}, {"full", true}});
  return lens;
}

Result<std::vector<Lens>> read(const std::string& text) {
  const Json document = parse_json(text).value();
  return reading("lens-invalid", "lenses.json", [&] { return list_of<Lens>(document, "lenses", "lens", lens_from); });
}

TEST(JsonReading, GivesTheValues) {
  const auto lenses = read(R"({"lenses": [{"name": "a", "radius_mm": 2, "center_mm": [1, 2, 3], "coating": "full"},
                                          {"name": "b", "radius_mm": 0.5}]})");
  ASSERT_TRUE(lenses) << lenses.error().message();
  ASSERT_EQ(lenses->size(), 2u);
  EXPECT_EQ((*lenses)[0].radius_mm, 2);
  EXPECT_EQ((*lenses)[0].center_mm, Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE((*lenses)[0].coated);
  EXPECT_EQ((*lenses)[1].name, "b");
  EXPECT_TRUE(read("{}")->empty());
}

// The first refusal comes out, with its place, under the format's code and in its file.
TEST(JsonReading, SaysWhereAndWhatIsWrong) {
  const auto said = [](const std::string& lens) {
    const auto refused = read(R"({"lenses": [{"name": "a", "radius_mm": 1}, )" + lens + "]}");
    EXPECT_FALSE(refused) << lens;
    if (refused) return std::string();
    EXPECT_EQ(refused.error().code, "lens-invalid");
    EXPECT_EQ(refused.error().file, "lenses.json");
    return refused.error().message();
  };
  EXPECT_EQ(said("7"), "lens 2 must be an object in braces.");
  EXPECT_EQ(said(R"({"name": "b"})"), "lens 2 lacks \"radius_mm\".");
  EXPECT_EQ(said(R"({"name": "", "radius_mm": 1})"), "lens 2, name must be a name in quotes.");
  EXPECT_EQ(said(R"({"name": "b", "radius_mm": "1"})"), "lens 2, radius_mm must be a finite number.");
  EXPECT_EQ(said(R"({"name": "b", "radius_mm": 0})"), "lens 2, radius_mm must be above zero.");
  EXPECT_EQ(said(R"({"name": "b", "radius_mm": 1, "center_mm": [1, 2]})"),
            "lens 2, center_mm must be three numbers [x, y, z].");
  EXPECT_EQ(said(R"({"name": "b", "radius_mm": 1, "coating": "half"})"),
            "lens 2, coating must be one of \"none\", \"full\".");
  EXPECT_EQ(said(R"({"name": "b", "radius_mn": 1})"), "lens 2 has a key that is not known: \"radius_mn\".");
  EXPECT_FALSE(read(R"({"lenses": 1})"));
}

TEST(JsonReading, ARefusalKeepsItsOwnCodeAndFile) {
  const auto refused = reading("lens-invalid", "lenses.json", []() -> int {
    return taken(Result<int>(failure(Error{"mesh-empty", "It is empty.", {}, {}, "mesh.vtu"})));
  });
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "mesh-empty");
  EXPECT_EQ(refused.error().file, "mesh.vtu");
}

}  // namespace
}  // namespace glisson
