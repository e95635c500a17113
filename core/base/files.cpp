#include "base/files.h"

#include <openssl/evp.h>
#include <array>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <system_error>

namespace glisson {
namespace fs = std::filesystem;
namespace {

std::string hexadecimal(const unsigned char* bytes, unsigned count) {
  static constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (unsigned i = 0; i < count; ++i) {
    text += digits[bytes[i] >> 4];
    text += digits[bytes[i] & 15];
  }
  return text;
}

class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) { EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr); }
  void add(const char* data, std::size_t size) { EVP_DigestUpdate(context_.get(), data, size); }
  std::string digest() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
    unsigned count = 0;
    EVP_DigestFinal_ex(context_.get(), bytes.data(), &count);
    return hexadecimal(bytes.data(), count);
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

Failure cannot_read(const fs::path& file) {
  return failure(Error{"file-not-readable",
                       GLISSON_TEXT("The file {0} cannot be read."),
                       {file.string()},
                       GLISSON_TEXT("Check that it exists and that you may read it."),
                       file});
}

}  // namespace

Result<std::string> read_text_file(const fs::path& file, std::uint64_t limit_bytes) {
  std::error_code problem;
  const auto size = fs::file_size(file, problem);
  if (problem || !fs::is_regular_file(file, problem)) return cannot_read(file);
  if (size > limit_bytes) {
    return failure(Error{"file-too-large",
                         GLISSON_TEXT("The file {0} has {1} bytes; at most {2} are read."),
                         {file.string(), std::to_string(size), std::to_string(limit_bytes)},
                         {},
                         file});
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return cannot_read(file);
  std::string text(size, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(size));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

Result<std::string> sha256_of_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return cannot_read(file);
  Sha256 hash;
  std::array<char, 1 << 16> block{};
  do {
    stream.read(block.data(), block.size());
    hash.add(block.data(), static_cast<std::size_t>(stream.gcount()));
  } while (stream);
  if (stream.bad()) return cannot_read(file);
  return hash.digest();
}

std::string sha256_of_text(std::string_view text) {
  Sha256 hash;
  hash.add(text.data(), text.size());
  return hash.digest();
}

Result<fs::path> resource_folder() {
  std::error_code problem;
  if (const char* chosen = std::getenv("GLISSON_RESOURCES")) return fs::path(chosen);
  const fs::path program = fs::read_symlink("/proc/self/exe", problem);
  if (!problem) {
    const fs::path installed = program.parent_path().parent_path() / "share" / "glisson" / "resources";
    if (fs::is_directory(installed, problem)) return installed;
    for (fs::path folder = program.parent_path(); folder != folder.parent_path(); folder = folder.parent_path()) {
      if (fs::is_directory(folder / "resources" / "devices", problem)) return folder / "resources";
    }
  }
  return failure(Error{"resources-missing",
                       GLISSON_TEXT("The files that ship with Glisson were not found."),
                       {},
                       GLISSON_TEXT("Set GLISSON_RESOURCES to the folder named resources."),
                       {}});
}

std::string version() { return GLISSON_VERSION; }

}  // namespace glisson
