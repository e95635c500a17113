// A batch that is stopped goes on where it was, and one patient's failure stays that patient's.

#include "studies/dissertation/batch.h"

#include <gmock/gmock.h>
#include <fstream>
#include <mutex>
#include <set>

#include "base/files.h"
#include "base/write_file.h"

namespace glisson::studies {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::vector<BatchPatient> patients(int count, const std::string& fingerprint = "a") {
  std::vector<BatchPatient> made;
  for (int p = 0; p < count; ++p) made.push_back({"p" + std::to_string(p), fingerprint});
  return made;
}

// Twice the patient's number, and which patients were asked for.
struct Doubling {
  std::mutex mutex;
  std::set<std::size_t> asked;
  std::function<Result<NamedNumbers>(std::size_t)> compute = [this](std::size_t p) -> Result<NamedNumbers> {
    const std::lock_guard lock(mutex);
    asked.insert(p);
    if (p == 2) return failure("test-broken", "The scan of patient {0} is broken, sadly.", {"2"});
    return NamedNumbers{{"twice", 2.0 * static_cast<double>(p)}};
  };
};

TEST(Batch, AFailureStopsNobodyElse) {
  const TemporaryFolder folder;
  Doubling doubling;
  const auto rows = run_batch(folder.path(), patients(5), doubling.compute);
  ASSERT_TRUE(rows.has_value());
  ASSERT_THAT(*rows, SizeIs(5));
  EXPECT_THAT((*rows)[2].error, HasSubstr("broken"));
  EXPECT_THAT(column_of(*rows, "twice"), testing::ElementsAre(0, 2, 6, 8));
  ASSERT_TRUE(write_batch_csv(folder.path() / "table.csv", *rows));
  const std::string csv = read_text_file(folder.path() / "table.csv").value();
  EXPECT_EQ(csv, "patient,twice,error\np0,0,\np1,2,\np2,,\"The scan of patient 2 is broken, sadly.\"\np3,6,\np4,8,\n");
}

TEST(Batch, ADiskThatIsFullIsNoPatientsFailure) {
  const TemporaryFolder folder;
  const auto full_at_2 = [](std::size_t p) -> Result<NamedNumbers> {
    if (p == 2) return file_not_writable("p2/mesh.vtu", "No space left on device");
    return NamedNumbers{{"twice", 2.0 * static_cast<double>(p)}};
  };
  const auto rows = run_batch(folder.path(), patients(5), full_at_2);
  ASSERT_FALSE(rows.has_value());
  EXPECT_EQ(rows.error().code, "file-not-writable");
  EXPECT_THAT(rows_in(folder.path()), SizeIs(4));  // the others are there, and this one is not said to have failed
}

TEST(Batch, GoesOnWhereItWasAndTriesTheFailedOnesAgain) {
  const TemporaryFolder folder;
  Doubling first;
  std::stop_source stop;
  const Progress impatient([&](double, std::string_view) { stop.request_stop(); }, stop.get_token());
  EXPECT_EQ(run_batch(folder.path(), patients(40), first.compute, {}, impatient).error().code, "cancelled");
  ASSERT_LT(first.asked.size(), 40u);
  Doubling second;
  const auto rows = run_batch(folder.path(), patients(40), second.compute);
  ASSERT_TRUE(rows.has_value());
  ASSERT_THAT(*rows, SizeIs(40));
  for (const std::size_t p : first.asked) {
    if (p == 2) continue;
    EXPECT_FALSE(second.asked.contains(p)) << p;
  }
  Doubling third;
  ASSERT_TRUE(run_batch(folder.path(), patients(40), third.compute));
  EXPECT_EQ(third.asked, std::set<std::size_t>{2});
}

TEST(Batch, ARowFromOtherInputOrHalfWrittenIsMadeAgain) {
  const TemporaryFolder folder;
  Doubling doubling;
  ASSERT_TRUE(run_batch(folder.path(), patients(2), doubling.compute));
  std::ofstream(folder.path() / "patients" / "p1.json") << "{\"patient\": \"p1\", \"finger";
  doubling.asked.clear();
  ASSERT_TRUE(run_batch(folder.path(), patients(2), doubling.compute));
  EXPECT_EQ(doubling.asked, std::set<std::size_t>{1});
  doubling.asked.clear();
  ASSERT_TRUE(run_batch(folder.path(), patients(2, "b"), doubling.compute));
  EXPECT_THAT(doubling.asked, SizeIs(2));
}

TEST(Batch, OnePatientAloneIsOneJobOfMany) {
  const TemporaryFolder folder;
  Doubling doubling;
  const auto one = run_batch(folder.path(), patients(4), doubling.compute, {"p3"});
  ASSERT_TRUE(one.has_value());
  EXPECT_THAT(*one, SizeIs(1));
  EXPECT_EQ(doubling.asked, std::set<std::size_t>{3});
  EXPECT_EQ(run_batch(folder.path(), patients(4), doubling.compute, {"nobody"}).error().code, "batch-unknown-patient");
  EXPECT_EQ(run_batch(folder.path(), {}, doubling.compute).error().code, "batch-no-patients");
}

// Chunks in any order, some of them run twice, make the table that one run makes, and each patient is computed once.
TEST(Batch, ChunksMakeTheSameTable) {
  const TemporaryFolder whole, shared;
  Doubling doubling;
  const auto rows = run_batch(whole.path(), patients(10), doubling.compute);
  ASSERT_TRUE(write_batch_csv(whole.path() / "table.csv", rows.value()));
  Doubling chunked;
  std::size_t asked = 0;
  for (const int chunk : {3, 1, 4, 2}) {
    chunked.asked.clear();
    const auto made = run_batch(shared.path(), patients(10), chunked.compute, {{}, chunk, 4});
    ASSERT_TRUE(made);
    EXPECT_EQ(made->size(), chunked.asked.size());
    asked += chunked.asked.size();
  }
  EXPECT_EQ(asked, 10u);
  EXPECT_THAT(rows_in(shared.path()), SizeIs(10));
  chunked.asked.clear();
  const auto summed = run_batch(shared.path(), patients(10), chunked.compute);
  EXPECT_EQ(chunked.asked, std::set<std::size_t>{2});  // the one that failed
  ASSERT_TRUE(write_batch_csv(shared.path() / "table.csv", summed.value()));
  EXPECT_EQ(read_text_file(shared.path() / "table.csv").value(), read_text_file(whole.path() / "table.csv").value());
}

TEST(Batch, AChunkOfOtherInputOrDamagedIsMadeAgain) {
  const TemporaryFolder folder;
  Doubling doubling;
  const auto chunk = [&](const std::string& fingerprint) {
    doubling.asked.clear();
    return run_batch(folder.path(), patients(9, fingerprint), doubling.compute, {{}, 3, 3});
  };
  ASSERT_TRUE(chunk("a"));
  EXPECT_EQ(doubling.asked, (std::set<std::size_t>{6, 7, 8}));
  const auto file = folder.path() / "chunks" / "3-of-3.json";
  const std::string first = read_text_file(file).value();
  ASSERT_TRUE(chunk("a"));
  EXPECT_THAT(doubling.asked, IsEmpty());
  std::ofstream(file) << first.substr(0, first.size() / 2);
  ASSERT_TRUE(chunk("a"));
  EXPECT_THAT(doubling.asked, SizeIs(3));
  EXPECT_EQ(read_text_file(file).value(), first);
  ASSERT_TRUE(chunk("b"));
  EXPECT_THAT(doubling.asked, SizeIs(3));
  for (const std::string_view broken : {R"({"format": "glisson-rows/1"})", R"({"format": "glisson-rows/1", "patients":
       ["p6"], "fingerprints": [], "values": {}, "errors": [null]})",
                                        R"({"format": "glisson-rows/1", "patients": ["p6"], "fingerprints": ["b"],
       "values": {"twice": [1, 2]}, "errors": [null]})",
                                        "[]", "7"}) {
    std::ofstream(file) << broken;
    EXPECT_THAT(rows_in(folder.path()), IsEmpty()) << broken;
  }
}

// A chunk that is stopped leaves nothing behind that the next could take for whole.
TEST(Batch, AChunkThatIsStoppedBeginsAgain) {
  const TemporaryFolder folder;
  Doubling doubling;
  std::stop_source stop;
  const Progress impatient([&](double, std::string_view) { stop.request_stop(); }, stop.get_token());
  EXPECT_EQ(run_batch(folder.path(), patients(40), doubling.compute, {{}, 1, 1}, impatient).error().code, "cancelled");
  EXPECT_THAT(rows_in(folder.path()), IsEmpty());
}

TEST(Batch, ATableHasAllColumnsAndEmptyCellsWhereAPatientLacksOne) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "rows.csv";
  ASSERT_TRUE(write_batch_csv(file, {{"p1", {{"a_mm", 1}, {"seconds", 3}}, {}, false},
                                     {"p2", {{"a_mm", 2}, {"b_mm", 4}, {"seconds", 5}}, {}, false},
                                     {"p3", {}, "It failed.", false}}));
  EXPECT_EQ(read_text_file(file).value(), "patient,a_mm,seconds,b_mm,error\np1,1,3,,\np2,2,5,4,\np3,,,,It failed.\n");
  ASSERT_TRUE(write_batch_csv(file, {{"p1", {{"a_mm", 1}, {"seconds", 3}}, {}, false}}, "seconds"));
  EXPECT_EQ(read_text_file(file).value(), "patient,a_mm,error\np1,1,\n");
}

}  // namespace
}  // namespace glisson::studies
