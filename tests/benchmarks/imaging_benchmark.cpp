// Reading 512 x 512 x 300 as ITK's series reader does it and as we do, on the same files; and scanning ten thousand.
//
//   bench_imaging --benchmark_repetitions=5 --benchmark_report_aggregates_only=true

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <itkGDCMImageIO.h>
#include <itkImageSeriesReader.h>
#include <cstdlib>
#include <random>

#include "base/files.h"
#include "imaging/read_series.h"
#include "support/dicom_files.h"

namespace glisson::imaging {
namespace {

namespace fs = std::filesystem;

constexpr int slices = 300;

// Written once, noisy as a real CT is, with a rescale.
const fs::path& series_folder() {
  static const TemporaryFolder folder;
  static const bool written = [] {
    std::minstd_rand noise(1);
    test::SliceSpec spec;
    spec.modality = "CT";
    spec.columns = spec.rows = 512;
    spec.value = [&](int i, int j) { return 1000 + i % 64 + j % 32 + static_cast<int>(noise() % 50); };
    for (int k = 0; k < slices; ++k) {
      spec.position_mm[2] = k;
      spec.instance_number = k + 1;
      const auto file = test::dicom_slice(spec);
      file->getDataset()->putAndInsertString(DCM_RescaleSlope, "1");
      file->getDataset()->putAndInsertString(DCM_RescaleIntercept, "-1024");
      test::save(*file, folder.path() / fmt::format("{:04}.dcm", k));
    }
    return true;
  }();
  if (!written) std::abort();
  return folder.path();
}

const Series& series() {
  static const Series only = scan(series_folder()).value().series.front();
  return only;
}

void read_by_glisson(benchmark::State& state) {
  series();
  for (auto _ : state) {
    const Result<Volume> volume = read_series(series());
    if (!volume) state.SkipWithError(volume.error().message().c_str());
    benchmark::DoNotOptimize(volume);
  }
}
BENCHMARK(read_by_glisson)->Unit(benchmark::kMillisecond)->UseRealTime();

// Finding, sorting and reading, since ITK reads the headers while it reads the pixels.
void scan_and_read_by_glisson(benchmark::State& state) {
  series_folder();
  for (auto _ : state) {
    const Result<Study> study = scan(series_folder());
    const Result<Volume> volume = read_series(study.value().series.front());
    benchmark::DoNotOptimize(volume);
  }
}
BENCHMARK(scan_and_read_by_glisson)->Unit(benchmark::kMillisecond)->UseRealTime();

void read_by_itk(benchmark::State& state) {
  std::vector<std::string> names;
  for (const fs::path& file : series().files) names.push_back(file.string());
  for (auto _ : state) {
    const auto reader = itk::ImageSeriesReader<itk::Image<float, 3>>::New();
    reader->SetImageIO(itk::GDCMImageIO::New());
    reader->SetFileNames(names);
    reader->Update();
    benchmark::DoNotOptimize(reader->GetOutput()->GetBufferPointer());
  }
}
BENCHMARK(read_by_itk)->Unit(benchmark::kMillisecond)->UseRealTime();

// Ten thousand small files, as a disc with many series has them.
void scan_ten_thousand_files(benchmark::State& state) {
  static const TemporaryFolder folder;
  static const bool written = [] {
    for (int s = 0; s < 100; ++s) {
      test::SliceSpec spec;
      spec.series_uid = fmt::format("1.2.3.{}", s + 1);
      spec.series_number = s + 1;
      test::save_stack(folder.path() / fmt::format("series-{}", s), 100, spec);
    }
    return true;
  }();
  for (auto _ : state) {
    const Result<Study> study = scan(folder.path());
    if (!written || study.value().series.size() != 100) state.SkipWithError("series are missing");
  }
}
BENCHMARK(scan_ten_thousand_files)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace glisson::imaging

BENCHMARK_MAIN();
