// Bytes reach a disk whole, or the error says so and what was there stays.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <cstdlib>
#include <fstream>

#include "base/files.h"
#include "base/internal/abandoned_folders.h"
#include "base/new_folder.h"
#include "base/write_file.h"

namespace glisson {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// No file may grow beyond this many bytes: a disk that is full, as far as a writer can tell.
class FullAfter {
 public:
  explicit FullAfter(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullAfter() { ::setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(WriteFile, AFullDiskIsAnErrorThatNamesTheFileAndLeavesTheOldOne) {
  const TemporaryFolder folder;
  const fs::path target = folder.path() / "mesh.vtu";
  ASSERT_TRUE(write_file(target, "old"));
  Result<void> written;
  {
    const FullAfter full(4096);
    written = write_file(target, std::string(1 << 20, 'x'));
  }
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, "file-not-writable");
  EXPECT_THAT(written.error().message(), HasSubstr(target.string()));
  EXPECT_THAT(written.error().advice(), HasSubstr("free space"));
  EXPECT_EQ(read_text_file(target).value(), "old");
  EXPECT_EQ(files_in(folder.path()), 1u);
}

// Libraries look at neither their writes nor their closing; where they write, no disk can be full.
TEST(WriteFile, AFullDiskIsNoticedWhereALibraryDoesNot) {
  const TemporaryFolder folder;
  const fs::path target = folder.path() / "volume.nii.gz";
  const auto careless = [](const fs::path& beside) -> Result<void> {
    EXPECT_EQ(beside.extension(), ".gz");
    EXPECT_EQ(beside.stem().extension(), ".nii");
    std::ofstream(beside) << std::string(1 << 20, 'x');
    return {};
  };
  ASSERT_TRUE(write_atomically(target, careless));
  EXPECT_EQ(fs::file_size(target), 1u << 20);
  fs::remove(target);
  Result<void> written;
  {
    const FullAfter full(1 << 19);
    written = write_atomically(target, [](const fs::path& beside) -> Result<void> {
      std::ofstream stream(beside);
      for (int part = 0; part < 4; ++part) stream << std::string(1 << 18, 'x');
      return {};
    });
  }
  EXPECT_FALSE(written);
  EXPECT_EQ(files_in(folder.path()), 0u);
}

// Some libraries go on where they cannot open a file, and report success.
TEST(WriteFile, AWriterThatWroteNothingIsAnError) {
  const TemporaryFolder folder;
  const fs::path target = folder.path() / "volume.nii.gz";
  ASSERT_TRUE(write_file(target, "old"));
  const auto written = write_atomically(target, [](const fs::path&) { return Result<void>(); });
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message(), HasSubstr(target.string()));
  EXPECT_EQ(read_text_file(target).value(), "old");
}

TEST(WriteFile, WhatAKilledWriterLeftIsTakenOverAndALivingOnesIsLeftAlone) {
  const TemporaryFolder folder;
  const fs::path target = folder.path() / "case.json", part = folder.path() / ".part-case.json";
  std::ofstream(part) << "much longer than what is written now, and cut short by a ki";
  ASSERT_TRUE(write_file(target, "whole"));
  EXPECT_EQ(read_text_file(target).value(), "whole");
  EXPECT_EQ(files_in(folder.path()), 1u);

  std::ofstream(part) << "by one who lives";
  const int held = ::open(part.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(::flock(held, LOCK_EX | LOCK_NB), 0);
  ASSERT_TRUE(write_file(target, "by another"));
  remove_abandoned_parts(folder.path());
  EXPECT_EQ(read_text_file(part).value(), "by one who lives");
  ::close(held);
  remove_abandoned_parts(folder.path());
  EXPECT_EQ(read_text_file(target).value(), "by another");
  EXPECT_EQ(files_in(folder.path()), 1u);
}

// Whatever it was writing: nobody may ever write a file of that name again.
TEST(WriteFile, WhatAKilledWriterOfAnotherNameLeftGoes) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / ".part-old.vtu", filled = folder.path() / ".part-results",
                 living = folder.path() / ".part-1-old.vtu", below = folder.path() / "below";
  fs::create_directories(filled / "meshes");
  fs::create_directory(below);
  for (const fs::path& part : {file, living, filled / "meshes" / "half.vtu", below / ".part-another.vtu"}) {
    std::ofstream(part) << "half a fi";
  }
  fs::create_symlink(below, folder.path() / ".part-link");
  const int held = ::open(living.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(::flock(held, LOCK_EX | LOCK_NB), 0);
  ASSERT_TRUE(write_file(folder.path() / "new.json", "{}"));
  EXPECT_FALSE(fs::exists(file));
  EXPECT_FALSE(fs::exists(filled));
  EXPECT_TRUE(fs::exists(living));
  EXPECT_TRUE(fs::exists(below / ".part-another.vtu"));
  ::close(held);
}

TEST(NewFolder, IsFilledBesideItsPlaceAndGoesUnlessItIsPut) {
  const TemporaryFolder folder;
  const fs::path target = folder.path() / "sequence";
  {
    const auto left = NewFolder::begin(target);
    ASSERT_TRUE(left);
    std::ofstream(left->path() / "frame.ply") << "ply";
    remove_abandoned_parts(folder.path());  // its maker lives
    EXPECT_TRUE(fs::exists(left->path() / "frame.ply"));
  }
  EXPECT_EQ(files_in(folder.path()), 0u);
  auto kept = NewFolder::begin(target);
  ASSERT_TRUE(kept);
  std::ofstream(kept->path() / "frame.ply") << "ply";
  EXPECT_EQ(kept->put_in_place(), 0);
  EXPECT_EQ(read_text_file(target / "frame.ply").value(), "ply");
  auto second = NewFolder::begin(target);
  ASSERT_TRUE(second);
  EXPECT_NE(second->put_in_place(), 0);
}

TEST(WriteFile, NamesAsLongAsTheSystemTakesAreWritten) {
  const TemporaryFolder folder;
  const fs::path longest = folder.path() / (std::string(251, 'n') + ".vtp");
  EXPECT_TRUE(write_file(longest, "whole"));
  EXPECT_EQ(read_text_file(longest).value(), "whole");
  EXPECT_FALSE(write_file(folder.path() / std::string(300, 'n'), "too long"));
  EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(WriteFile, FilesWrittenTogetherAreAllThereOrNone) {
  const TemporaryFolder folder;
  const fs::path one = folder.path() / "result.vtu", two = folder.path() / "result.json";
  ASSERT_TRUE(write_file(one, "old mesh"));
  const auto failed = write_together([&] {
    return write_file(one, "new mesh").and_then([]() -> Result<void> { return failure("test", "no space left"); });
  });
  EXPECT_FALSE(failed);
  EXPECT_EQ(read_text_file(one).value(), "old mesh");
  EXPECT_EQ(files_in(folder.path()), 1u);

  ASSERT_TRUE(write_together([&] {
    return write_file(one, "new mesh").and_then([&] {
      EXPECT_EQ(read_text_file(one).value(), "old mesh");
      return write_file(two, "{}");
    });
  }));
  EXPECT_EQ(read_text_file(one).value(), "new mesh");
  EXPECT_EQ(files_in(folder.path()), 2u);
}

// All of a new folder, or nothing of it: whoever waits for the folder finds it whole.
TEST(WriteFile, AFileGoesWithThoseWrittenTogetherOrStays) {
  const TemporaryFolder folder;
  const fs::path old = folder.path() / "tumour-2.vtp", other = folder.path() / "truth.json";
  ASSERT_TRUE(write_file(old, "old"));
  const auto change = [&](bool ends_well) {
    return write_together([&]() -> Result<void> {
      if (auto removed = remove_file(old); !removed) return removed;
      if (auto written = write_file(other, "new"); !written) return written;
      if (!ends_well) return failure("test", "no");
      return {};
    });
  };
  EXPECT_FALSE(change(false));
  EXPECT_EQ(read_text_file(old).value(), "old");
  EXPECT_FALSE(fs::exists(other));
  // One that is not there to be removed brings back those that were removed before it.
  const fs::path never_there = folder.path() / "cyst-9.vtp";
  EXPECT_FALSE(write_together([&] { return remove_file(old).and_then([&] { return remove_file(never_there); }); }));
  EXPECT_EQ(read_text_file(old).value(), "old");
  EXPECT_EQ(files_in(folder.path()), 1u);
  EXPECT_TRUE(change(true));
  EXPECT_FALSE(fs::exists(old));
  EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(WriteFile, ANewFolderWrittenTogetherTakesItsPlaceAsAWhole) {
  const TemporaryFolder folder;
  const fs::path results = folder.path() / "2026" / "results", mesh = results / "meshes" / "result.vtu";
  const auto write = [&](const Result<void>& end) {
    return write_together([&] {
      return write_file(mesh, "mesh").and_then([&] {
        EXPECT_FALSE(fs::exists(folder.path() / "2026"));
        return write_file(results / "result.json", "{}").and_then([&] { return end; });
      });
    });
  };
  EXPECT_FALSE(write(failure("test", "no space left")));
  EXPECT_EQ(files_in(folder.path()), 0u);

  fs::create_directories(folder.path() / ".part-2026" / "left by a killed one");
  ASSERT_TRUE(write({}));
  EXPECT_EQ(read_text_file(mesh).value(), "mesh");
  EXPECT_EQ(read_text_file(results / "result.json").value(), "{}");
  EXPECT_EQ(files_in(folder.path()), 1u);
  EXPECT_EQ(files_in(folder.path() / "2026"), 1u);
  EXPECT_EQ(files_in(results), 2u);
}

TEST(WriteFile, AFolderThatAnotherMadeMeanwhileIsNotReplaced) {
  const TemporaryFolder folder;
  const fs::path results = folder.path() / "results";
  const auto written = write_together([&] {
    return write_file(results / "a.json", "ours").and_then([&] {
      fs::create_directory(results);
      std::ofstream(results / "b.json") << "theirs";
      return Result<void>();
    });
  });
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message(), HasSubstr(results.string()));
  EXPECT_EQ(files_in(results), 1u);
  EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(WriteFile, ALinkIsReplacedAndNotWrittenThrough) {
  const TemporaryFolder folder;
  const fs::path outside = folder.path() / "outside.txt", link = folder.path() / "link.txt";
  ASSERT_TRUE(write_file(outside, "theirs"));
  fs::create_symlink(outside, link);
  ASSERT_TRUE(write_file(link, "ours"));
  EXPECT_EQ(read_text_file(outside).value(), "theirs");
  EXPECT_FALSE(fs::is_symlink(link));
}

// The child makes a temporary folder and lives until it is killed.
TEST(TemporaryFolder, OfAKilledProgramGoesAndOfALivingOneStays) {
  const TemporaryFolder place;
  int ends[2];
  ASSERT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::setenv("TMPDIR", place.path().c_str(), 1);
    const auto folder = TemporaryFolder::make();
    const bool made = folder && std::ofstream(folder->path() / "film.mp4").put('x').good();
    if (::write(ends[1], made ? "y" : "n", 1) != 1) ::_exit(1);
    ::pause();
  }
  char answer = 0;
  ASSERT_EQ(::read(ends[0], &answer, 1), 1);
  ASSERT_EQ(answer, 'y');
  const fs::path anothers = place.path() / "glisson.of-somebody";
  fs::create_directory(anothers);
  remove_abandoned_folders(place.path());
  EXPECT_EQ(files_in(place.path()), 2u);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  remove_abandoned_folders(place.path());
  EXPECT_EQ(files_in(place.path()), 1u);
  EXPECT_TRUE(fs::exists(anothers));
  for (const int end : ends) ::close(end);
}

TEST(TemporaryFolder, IsGoneWithItsFilesWhenItIsDestroyed) {
  fs::path path;
  {
    const TemporaryFolder folder;
    path = folder.path();
    const auto memory = MemoryFile::create("a.nii.gz");
    ASSERT_TRUE(memory);
    EXPECT_EQ(memory->path().parent_path().parent_path(), path.parent_path());
    std::ofstream(path / "file") << "x";
    remove_abandoned_folders(path.parent_path());
    EXPECT_TRUE(fs::exists(path / "file"));
    EXPECT_TRUE(fs::is_symlink(memory->path()));
    path = memory->path().parent_path();
  }
  EXPECT_FALSE(fs::exists(path));
}

}  // namespace
}  // namespace glisson
