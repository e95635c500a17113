#pragma once
// What stands open, kept on disk while the window lives. So it is found again when the window ends without saying so: a
// crash, a kill, a power cut. What is in the case is safe by itself (casefile); this is where one was.

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>

#include "base/result.h"

namespace glisson::widgets {

struct OpenWork {
  struct Tool {
    Eigen::Vector3d center_mm{0, 0, 0};
    double radius_mm = 0;
    double force_N = 0;
    Eigen::Vector3d direction{0, -1, 0};
  };
  std::filesystem::path case_folder;
  std::string workspace;
  std::optional<Tool> tool;
};

// One file a running window, in a folder that windows share.
class OpenWorkFile {
 public:
  // The folder is made when it is missing.
  explicit OpenWorkFile(std::filesystem::path folder);
  ~OpenWorkFile();  // an end that says so: the file goes
  OpenWorkFile(const OpenWorkFile&) = delete;
  OpenWorkFile& operator=(const OpenWorkFile&) = delete;

  Result<void> keep(const OpenWork& work);
  void forget();

  // What a window left behind that is no longer running, and whose case is still there; the newest where there are
  // several. It is handed out once: what is read is gone from the folder.
  [[nodiscard]] std::optional<OpenWork> take_lost();

 private:
  std::filesystem::path folder_;
};

}  // namespace glisson::widgets
