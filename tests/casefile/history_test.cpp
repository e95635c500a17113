// What was done to a case can be undone, now and after the case was closed, and no kill tears case and history apart.

#include "casefile/history.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>

#include "base/files.h"
#include "casefile/contents.h"
#include "casefile/structures.h"
#include "segmentation/edit.h"

namespace glisson::casefile {
namespace {

namespace fs = std::filesystem;
using imaging::Mask;
using testing::HasSubstr;

Mask ball_at(const Eigen::Vector3d& center_mm, double radius_mm) {
  Mask mask;
  mask.grid.size = {40, 32, 20};
  mask.grid.spacing_mm = {1.5, 1.5, 3.1};
  mask.grid.origin_mm = {-30.123456789, 7.1, 100.25};
  mask.values.assign(mask.grid.voxels(), 0);
  return segmentation::paint(std::move(mask), {mask.grid.origin_mm + center_mm, radius_mm});
}

Result<void> save(const fs::path& folder, const std::string& name, const Mask& mask) {
  auto opened = Case::open(folder);
  if (!opened) return failure(opened.error());
  return save_structure(*opened, segmentation::make_structure(name, mask),
                        {"segment", {{"method", "brush"}}, {}, {}, {}})
      .map([](const SavedStructure&) {});
}

Result<void> write_text(const fs::path& folder, const std::string& id, const std::string& text) {
  auto opened = Case::open(folder);
  return opened->add(id, ".vtu", {"mesh", {}, {}, {}, {}}, [&](const fs::path& file) -> Result<void> {
    std::ofstream(file) << text;
    return {};
  });
}

using test::contents;

Sentence named(const std::string& text) { return {text, {}}; }

class HistoryTest : public testing::Test {
 protected:
  HistoryTest() { (void)Case::create(folder_).value(); }
  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path() / "patient.glisson";
};

TEST_F(HistoryTest, IsKeptThroughNoLink) {
  const fs::path elsewhere = temporary_.path() / "elsewhere";
  ASSERT_TRUE(write_text_file(elsewhere / "journal.json", "theirs"));
  for (const char* place : {"history", "history/steps", "history/kept"}) {
    fs::remove_all(folder_ / "history");
    fs::create_directories((folder_ / place).parent_path());
    fs::create_directory_symlink(elsewhere, folder_ / place);
    const auto history = History::open(folder_);
    ASSERT_FALSE(history) << place;
    EXPECT_EQ(history.error().code, "case-link") << place;
  }
  EXPECT_EQ(read_text_file(elsewhere / "journal.json").value(), "theirs");
  EXPECT_EQ(std::distance(fs::directory_iterator(elsewhere), fs::directory_iterator()), 1);
}

TEST_F(HistoryTest, UndoesAndRedoesWhatWasDoneAlsoAfterReopening) {
  std::vector<std::map<std::string, std::string>> states{contents(folder_)};
  {
    auto history = History::open(folder_);
    ASSERT_TRUE(history);
    const auto step = [&](const std::string& name, const std::function<Result<void>()>& change) {
      ASSERT_TRUE((*history)->record(named(name), change));
      states.push_back(contents(folder_));
    };
    step("add liver", [&] { return save(folder_, "liver", ball_at({30, 24, 30}, 12)); });
    step("brush", [&] { return save(folder_, "liver", ball_at({30, 24, 30}, 14)); });
    step("mesh", [&] { return write_text(folder_, "meshes/liver", "first mesh"); });
    step("mesh again", [&] { return write_text(folder_, "meshes/liver", "second mesh"); });
    step("tumour", [&] { return save(folder_, "tumour-1", ball_at({20, 24, 30}, 5)); });
    step("rename", [&]() -> Result<void> {
      auto saved = save(folder_, "cyst-1", ball_at({20, 24, 30}, 5));
      return saved ? Case::open(folder_)->remove("labels/tumour-1") : saved;
    });
  }
  auto history = History::open(folder_);
  ASSERT_TRUE(history);
  EXPECT_EQ((*history)->undo_name()->text, "rename");
  for (std::size_t n = states.size() - 1; n-- > 0;) {
    ASSERT_TRUE((*history)->undo());
    EXPECT_EQ(contents(folder_), states[n]);
  }
  EXPECT_EQ((*history)->undo().error().code, "history-nothing-left");
  history->reset();
  history = History::open(folder_);
  for (std::size_t n = 1; n < states.size(); ++n) {
    ASSERT_TRUE((*history)->redo());
    EXPECT_EQ(contents(folder_), states[n]);
  }
}

TEST_F(HistoryTest, AStrokeTakesAKilobyteAndNoVolume) {
  auto history = History::open(folder_);
  ASSERT_TRUE((*history)->record(named("add"), [&] { return save(folder_, "liver", ball_at({30, 24, 30}, 12)); }));
  const auto before = (*history)->disk_bytes();
  ASSERT_TRUE((*history)->record(named("brush"), [&] { return save(folder_, "liver", ball_at({30, 24, 30}, 13)); }));
  EXPECT_LT((*history)->disk_bytes() - before, 3000u);
  EXPECT_TRUE(fs::is_empty(folder_ / "history/kept"));
}

TEST_F(HistoryTest, AnEditAfterAnUndoDropsWhatWasUndone) {
  auto history = History::open(folder_);
  ASSERT_TRUE((*history)->record(named("one"), [&] { return write_text(folder_, "meshes/liver", "one"); }));
  ASSERT_TRUE((*history)->record(named("two"), [&] { return write_text(folder_, "meshes/liver", "two"); }));
  ASSERT_TRUE((*history)->undo());
  ASSERT_TRUE((*history)->record(named("three"), [&] { return write_text(folder_, "meshes/liver", "three"); }));
  EXPECT_EQ((*history)->steps_to_redo(), 0u);
  EXPECT_EQ((*history)->steps_to_undo(), 2u);
  ASSERT_TRUE((*history)->undo());
  EXPECT_EQ(read_text_file(folder_ / "meshes/liver.vtu").value(), "one");
}

TEST_F(HistoryTest, BeyondItsCapsTheOldestStepsGoAndTheRestStillUndoes) {
  auto history = History::open(folder_, {.disk_bytes = 40'000, .steps = 1000});
  for (int n = 0; n < 12; ++n) {
    ASSERT_TRUE((*history)->record(named("mesh"), [&] {
      return write_text(folder_, "meshes/liver", std::string(10'000, static_cast<char>('a' + n)));
    }));
  }
  EXPECT_LT((*history)->disk_bytes(), 40'000u + 10'000u);
  EXPECT_GE((*history)->steps_to_undo(), 2u);
  EXPECT_LE((*history)->steps_to_undo(), 4u);
  while ((*history)->undo()) {
  }
  EXPECT_EQ((*history)->steps_to_undo(), 0u);
  EXPECT_EQ(contents(folder_).size(), 1u);

  history->reset();
  history = History::open(folder_, {.disk_bytes = 1 << 20, .steps = 5});
  for (int n = 0; n < 12; ++n) {
    ASSERT_TRUE((*history)->record_values(named("tool"), {{"tool", std::to_string(n), std::to_string(n + 1)}}));
  }
  EXPECT_EQ((*history)->steps_to_undo(), 5u);
}

TEST_F(HistoryTest, ValuesComeBackAndADraggedSliderIsOneStep) {
  auto history = History::open(folder_);
  ASSERT_TRUE((*history)->record_values(named("place"), {{"tool", "", "[1,2,3]"}}));
  for (int n = 1; n <= 5; ++n) {
    ASSERT_TRUE((*history)->record_values(named("force"), {{"force", std::to_string(n - 1), std::to_string(n)}},
                                          History::Joins::last_of_same_keys));
  }
  EXPECT_EQ((*history)->steps_to_undo(), 2u);
  history->reset();
  history = History::open(folder_);
  EXPECT_EQ((*history)->value_of("force"), "5");
  const auto moved = (*history)->undo();
  ASSERT_TRUE(moved);
  ASSERT_EQ(moved->values.size(), 1u);
  EXPECT_EQ(moved->values.front().key, "force");
  EXPECT_EQ(moved->values.front().after, "0");
  EXPECT_EQ((*history)->value_of("force"), "0");
  ASSERT_TRUE((*history)->undo());
  EXPECT_EQ((*history)->value_of("tool"), "");
}

TEST_F(HistoryTest, AFailedChangeLeavesNoStepButWhatItHadDone) {
  auto history = History::open(folder_);
  EXPECT_FALSE((*history)->record(named("nothing"), []() -> Result<void> { return failure("test", "no"); }));
  EXPECT_EQ((*history)->steps_to_undo(), 0u);
  EXPECT_FALSE((*history)->record(named("half"), [&]() -> Result<void> {
    (void)write_text(folder_, "meshes/liver", "half");
    return failure("test", "no");
  }));
  EXPECT_EQ((*history)->steps_to_undo(), 1u);
  ASSERT_TRUE((*history)->undo());
  EXPECT_TRUE(contents(folder_).empty());
}

TEST_F(HistoryTest, WhatAnotherProgramChangedIsNotOverwritten) {
  auto history = History::open(folder_);
  ASSERT_TRUE((*history)->record(named("one"), [&] { return write_text(folder_, "meshes/liver", "one"); }));
  std::ofstream(folder_ / "meshes/liver.vtu") << "from elsewhere";
  EXPECT_EQ((*history)->undo().error().code, "history-overtaken");
  EXPECT_EQ(read_text_file(folder_ / "meshes/liver.vtu").value(), "from elsewhere");
  EXPECT_FALSE((*history)->undo_name());
}

// results/resection is no entry of the case; what it holds belongs to the step that wrote it all the same.
TEST_F(HistoryTest, ThePlanThatIsFollowedGoesWithItsStep) {
  const fs::path plan = folder_ / "results" / "resection" / "resection.json";
  const auto keep = [&](const std::string& id, const std::string& followed) {
    return [&, id, followed] {
      return write_text(folder_, id, id).and_then([&] {
        fs::create_directories(plan.parent_path());
        return write_text_file(plan, followed);
      });
    };
  };
  {
    auto history = History::open(folder_);
    ASSERT_TRUE((*history)->record(named("first"), keep("plans/one", "at 40 mm")));
    ASSERT_TRUE((*history)->record(named("second"), keep("plans/two", "at 50 mm")));
    ASSERT_TRUE((*history)->record(named("stroke"),
                                   [&] {
                                     return save(folder_, "liver", ball_at({30, 24, 30}, 9));
                                   },
                                   {"labels/liver"}));
    ASSERT_TRUE((*history)->undo());
    EXPECT_EQ(read_text_file(plan).value(), "at 50 mm");
    const auto moved = (*history)->undo();
    ASSERT_TRUE(moved);
    EXPECT_THAT(moved->entries, testing::UnorderedElementsAre("plans/two", "results/resection/resection.json"));
    EXPECT_EQ(read_text_file(plan).value(), "at 40 mm");
  }
  auto history = History::open(folder_);
  ASSERT_TRUE((*history)->undo());
  EXPECT_FALSE(fs::exists(plan.parent_path()));
  ASSERT_TRUE((*history)->redo());
  ASSERT_TRUE((*history)->redo());
  EXPECT_EQ(read_text_file(plan).value(), "at 50 mm");
  // What somebody else planned since is not overwritten.
  ASSERT_TRUE(write_text_file(plan, "at 60 mm"));
  const auto refused = (*history)->undo();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, "history-overtaken");
  EXPECT_EQ(read_text_file(plan).value(), "at 60 mm");
  EXPECT_NE(Case::open(folder_)->find("plans/two"), nullptr);
}

TEST_F(HistoryTest, OneWindowAtATimeAndADamagedHistoryKeepsNobodyFromTheCase) {
  auto history = History::open(folder_);
  ASSERT_TRUE((*history)->record(named("one"), [&] { return write_text(folder_, "meshes/liver", "one"); }));
  EXPECT_EQ(History::open(folder_).error().code, "history-in-use");
  history->reset();
  std::ofstream(folder_ / "history/journal.json") << "{ not a journal";
  history = History::open(folder_);
  ASSERT_TRUE(history);
  EXPECT_EQ((*history)->steps_to_undo(), 0u);
  EXPECT_TRUE(fs::exists(folder_ / "history.damaged/journal.json"));
}

// The child of the test below: edits, undoes and redoes until it is killed.
TEST(HistoryWorker, DISABLED_WorksUntilKilled) {
  const char* folder = std::getenv("GLISSON_TEST_CASE");
  ASSERT_NE(folder, nullptr);
  auto history = History::open(folder);
  ASSERT_TRUE(history);
  std::mt19937 random(std::random_device{}());
  std::ofstream(fs::path(folder) / "../ready") << "yes";
  for (;;) {
    const auto draw = random() % 10;
    const double at = static_cast<double>(random() % 300) / 10;
    const double radius = 3 + static_cast<double>(random() % 100) / 10;
    if (draw < 4) {
      (void)(*history)->record({"brush", {}}, [&] { return save(folder, "liver", ball_at({at, 24, 30}, radius)); });
    } else if (draw < 6) {
      (void)(*history)->record({"model", {}}, [&]() -> Result<void> {
        auto first = write_text(folder, "meshes/liver", std::string(20'000, static_cast<char>('a' + random() % 26)));
        return first ? write_text(folder, "meshes/model", std::to_string(random())) : first;
      });
    } else if (draw == 6) {
      (void)(*history)->record({"remove", {}}, [&] { return Case::open(folder)->remove("meshes/model"); });
    } else if (draw == 7) {
      (void)(*history)->record_values({"tool", {}}, {{"tool", "0", std::to_string(random())}});
    } else if (draw == 8) {
      (void)(*history)->undo();
    } else {
      (void)(*history)->redo();
    }
  }
}

TEST_F(HistoryTest, KilledAtAnyMomentCaseAndHistoryOpenTogether) {
  const auto start = contents(folder_);
  std::mt19937 random(20261121);
  std::size_t maximum_steps = 0;
  for (int round = 0; round < 25; ++round) {
    std::error_code ignored;
    fs::remove(temporary_.path() / "ready", ignored);
    const pid_t child = ::fork();
    if (child == 0) {
      ::setenv("GLISSON_TEST_CASE", folder_.c_str(), 1);
      ::setenv("TMPDIR", temporary_.path().c_str(), 1);  // what a killed child leaves goes with the test
      ::execl("/proc/self/exe", "history", "--gtest_also_run_disabled_tests", "--gtest_filter=HistoryWorker.*",
              "--gtest_brief=1", nullptr);
      ::_exit(9);
    }
    for (int wait = 0; wait < 2000 && !fs::exists(temporary_.path() / "ready"); ++wait) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 150'000));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);

    auto history = History::open(folder_);
    ASSERT_TRUE(history) << history.error().message();
    ASSERT_FALSE(fs::exists(folder_ / "history.damaged"));
    const auto found = contents(folder_);  // expects each file to be the one that case.json names
    std::size_t steps = 0, forward = (*history)->steps_to_redo();
    for (std::size_t n = 0; n < forward; ++n) ASSERT_TRUE((*history)->redo()) << "round " << round;
    while ((*history)->steps_to_undo() > 0) {
      const auto moved = (*history)->undo();
      ASSERT_TRUE(moved) << "round " << round << ": " << moved.error().message();
      ++steps;
    }
    EXPECT_EQ(contents(folder_), start);
    for (std::size_t n = forward; n < steps; ++n) ASSERT_TRUE((*history)->redo());
    EXPECT_EQ(contents(folder_), found);
    maximum_steps = std::max(maximum_steps, steps);
  }
  EXPECT_GE(maximum_steps, 5u);  // it was killed at work, not before
}

}  // namespace
}  // namespace glisson::casefile
