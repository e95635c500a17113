#pragma once
// A liver that is an ellipsoid with a ball in it, as the files that make a case of it: little enough for tests that run
// the program many times.

#include <filesystem>
#include <functional>
#include <string>

#include "base/files.h"

namespace glisson::test {

// Voxels of 5 mm around the origin; `voxel` gives each one's bytes.
inline std::string nrrd(const std::string& type, const std::function<std::string(double, double, double)>& voxel) {
  std::string file = "NRRD0004\ntype: " + type +
                     "\ndimension: 3\nspace: left-posterior-superior\nsizes: 34 26 26\n"
                     "space directions: (5,0,0) (0,5,0) (0,0,5)\nspace origin: (-82.5,-62.5,-62.5)\n"
                     "kinds: domain domain domain\nendian: little\nencoding: raw\n\n";
  for (int k = 0; k < 26; ++k) {
    for (int j = 0; j < 26; ++j) {
      for (int i = 0; i < 34; ++i) file += voxel(-82.5 + 5 * i, -62.5 + 5 * j, -62.5 + 5 * k);
    }
  }
  return file;
}

// scan.nrrd, liver.nrrd and tumour.nrrd.
inline Result<void> write_small_liver(const std::filesystem::path& folder) {
  const auto two_bytes = [](int value) -> std::string {
    return {static_cast<char>(value & 255), static_cast<char>(value >> 8)};
  };
  const auto label = [](bool inside) -> std::string { return {inside ? '\1' : '\0'}; };
  const auto in_liver = [](double x, double y, double z) { return x * x / 4900 + y * y / 2500 + z * z / 2500 < 1; };
  return write_text_file(folder / "scan.nrrd",
                         nrrd("int16",
                              [&](double x, double y, double z) {
                                return two_bytes((in_liver(x, y, z) ? 300 : 40) + static_cast<int>(x + 100) / 10);
                              }))
      .and_then([&] {
        return write_text_file(folder / "liver.nrrd",
                               nrrd("uint8", [&](double x, double y, double z) { return label(in_liver(x, y, z)); }));
      })
      .and_then([&] {
        return write_text_file(folder / "tumour.nrrd", nrrd("uint8", [&](double x, double y, double z) {
                                 return label((x + 40) * (x + 40) + y * y + z * z < 15 * 15);
                               }));
      });
}

}  // namespace glisson::test
