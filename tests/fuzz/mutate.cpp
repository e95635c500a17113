// A small fuzzer that needs no more than the compiler: takes good files, breaks each in a few places, and runs the
// target over them. The same number of a mutation gives the same bytes everywhere, so that a crash can be repeated:
//
//   fuzz_read_image [--mutations N] [--seconds S] [--only N] [--write-seeds FOLDER]

#include <unistd.h>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <Eigen/Core>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "base/files.h"
#include "fuzz/read_image_target.h"
#include "support/dicom_files.h"

namespace {

namespace fs = std::filesystem;
using glisson::test::SliceSpec;

volatile std::sig_atomic_t mutation_under_way = 0;

// Says which mutation it was, using only what a signal handler may.
void report_crash(int signal) {
  char text[64] = "fuzz_read_image: crashed; repeat with --only ";
  std::size_t length = std::strlen(text);
  char digits[16];
  int count = 0;
  for (long rest = mutation_under_way; rest > 0 || count == 0; rest /= 10) digits[count++] = char('0' + rest % 10);
  while (count > 0 && length + 2 < sizeof text) text[length++] = digits[--count];
  text[length++] = '\n';
  if (::write(STDERR_FILENO, text, length) < 0) std::_Exit(3);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

std::string saved(DcmFileFormat& file, E_TransferSyntax syntax, const fs::path& folder) {
  glisson::test::save(file, folder / "seed.dcm", syntax);
  return glisson::test::bytes_of(folder / "seed.dcm");
}

// One of each way in which the reader takes pictures.
std::vector<std::string> seeds() {
  const glisson::TemporaryFolder folder;
  std::vector<std::string> made;
  for (const E_TransferSyntax syntax : {EXS_LittleEndianImplicit, EXS_LittleEndianExplicit, EXS_BigEndianExplicit,
                                        EXS_RLELossless, EXS_JPEGProcess14SV1, EXS_JPEGLSLossless}) {
    made.push_back(saved(*glisson::test::dicom_slice({}), syntax, folder.path()));
  }
  SliceSpec bytes;
  bytes.bits_allocated = bytes.bits_stored = 8;
  bytes.columns = bytes.rows = 16;
  made.push_back(saved(*glisson::test::dicom_slice(bytes), EXS_JPEGProcess1, folder.path()));

  const std::vector<Eigen::Vector3d> places{{0, 0, 6}, {0, 0, 0}, {0, 0, 3}};
  const auto enhanced = glisson::test::enhanced_image({}, places, [](int n, int i, int j) { return 50 * n + i + j; });
  made.push_back(saved(*enhanced, EXS_LittleEndianExplicit, folder.path()));
  made.push_back(saved(*enhanced, EXS_RLELossless, folder.path()));

  SliceSpec tiles;
  tiles.columns = tiles.rows = 12;
  tiles.image_type = "ORIGINAL\\PRIMARY\\P\\ND\\MOSAIC";
  const auto mosaic = glisson::test::dicom_slice(tiles);
  mosaic->getDataset()->putAndInsertString(DCM_SpacingBetweenSlices, "2.5");
  mosaic->getDataset()->putAndInsertString(DcmTag(0x0019, 0x0010, EVR_LO), "SIEMENS MR HEADER");
  mosaic->getDataset()->putAndInsertUint16(DcmTag(0x0019, 0x100a, EVR_US), 7);
  made.push_back(saved(*mosaic, EXS_LittleEndianExplicit, folder.path()));
  return made;
}

class Mutator {
 public:
  Mutator(std::string bytes, unsigned number) : bytes_(std::move(bytes)), random_(number) {}

  std::string broken() {
    const unsigned times = 1 + random_() % 4;
    for (unsigned n = 0; n < times && !bytes_.empty(); ++n) break_once();
    return bytes_;
  }

 private:
  // Half of the time behind the preamble and before the pixels, where the structure is.
  std::size_t place() { return random_() % bytes_.size(); }

  void break_once() {
    static constexpr std::uint32_t awkward[] = {0,      1,      2,          0x7F,       0x80,       0xFF,      0x7FFF,
                                                0x8000, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFE, 0xFFFFFFFF};
    const std::size_t at = place();
    const std::uint32_t number = awkward[random_() % std::size(awkward)];
    switch (random_() % 8) {
      case 0: bytes_[at] = static_cast<char>(bytes_[at] ^ (1 << random_() % 8)); break;
      case 1: bytes_[at] = static_cast<char>(random_()); break;
      case 2: overwrite(at, number, 2); break;
      case 3: overwrite(at, number, 4); break;
      case 4: bytes_.resize(at); break;
      case 5: bytes_.erase(at, 1 + random_() % 16); break;
      case 6: bytes_.insert(at, bytes_.substr(place(), 1 + random_() % 32)); break;
      default: swap_decimals(at); break;
    }
  }
  void overwrite(std::size_t at, std::uint32_t number, std::size_t count) {
    for (std::size_t i = 0; i < count && at + i < bytes_.size(); ++i)
      bytes_[at + i] = static_cast<char>(number >> 8 * i);
  }
  // A digit of a written number becomes another, a sign or an exponent.
  void swap_decimals(std::size_t from) {
    const std::size_t digit = bytes_.find_first_of("0123456789", from);
    if (digit != std::string::npos) bytes_[digit] = "0123456789-.eE"[random_() % 14];
  }

  std::string bytes_;
  std::minstd_rand random_;
};

void run(const std::vector<std::string>& good, unsigned number) {
  mutation_under_way = static_cast<std::sig_atomic_t>(number);
  const std::string bytes = Mutator(good[number % good.size()], number + 1).broken();
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

long number_after(int count, char** words, const char* option, long otherwise) {
  for (int i = 1; i + 1 < count; ++i) {
    if (std::strcmp(words[i], option) == 0) return std::strtol(words[i + 1], nullptr, 10);
  }
  return otherwise;
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> good = seeds();
  for (int i = 1; i + 1 < count; ++i) {
    if (std::strcmp(words[i], "--write-seeds") != 0) continue;
    fs::create_directories(words[i + 1]);
    for (std::size_t n = 0; n < good.size(); ++n) {
      glisson::test::write_bytes(fs::path(words[i + 1]) / ("seed-" + std::to_string(n) + ".dcm"), good[n]);
    }
    return 0;
  }
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL}) std::signal(signal, report_crash);
  if (const long only = number_after(count, words, "--only", -1); only >= 0) {
    run(good, static_cast<unsigned>(only));
    return 0;
  }
  for (const std::string& bytes : good) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  const long mutations = number_after(count, words, "--mutations", 20000);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(number_after(count, words, "--seconds", 20));
  long done = 0;
  while (done < mutations && std::chrono::steady_clock::now() < end) run(good, static_cast<unsigned>(done++));
  std::printf("%ld mutations of %zu files, none of which brought the reader down\n", done, good.size());
  return 0;
}
