// Slices of a series into one volume, several at a time.

#include "imaging/read_series.h"

#include <unistd.h>
#include <atomic>
#include <mutex>
#include <new>
#include <optional>

#include <fmt/format.h>

#include "base/parallel.h"
#include "imaging/internal/frame_reader.h"
#include "imaging/internal/voxel_layout.h"
#include "imaging/volume_file.h"

namespace glisson::imaging {
namespace {

Failure refused(const Series& series, const char* code, std::string text, std::vector<std::string> arguments,
                std::string hint = "") {
  return failure(Error{code, std::move(text), std::move(arguments), std::move(hint),
                       series.files.empty() ? std::filesystem::path() : series.files.front()});
}

std::string title_of(const Series& series) { return series.description.empty() ? series.uid : series.description; }

// Refusals that need no reading.
Result<void> check_readable(const Series& series, int volume) {
  GLISSON_ASSERT(series.layout != nullptr);
  if (volume < 0 || volume >= series.volumes) {
    return refused(series, "series-no-such-volume",
                   GLISSON_TEXT("The series {0} has {1} volumes, counted from 0, and no {2}."),
                   {title_of(series), std::to_string(series.volumes), std::to_string(volume)});
  }
  for (const PixelFile& file : series.layout->files) {
    if (file.format.bits_allocated == 1) {
      return refused(series, "dicom-segmentation", GLISSON_TEXT("The series {0} is a segmentation, not an image."),
                     {title_of(series)}, GLISSON_TEXT("Import it as labels of a structure."));
    }
    if (file.format.is_colour()) {
      return refused(series, "dicom-colour",
                     GLISSON_TEXT("The series {0} holds pictures in colour and no values to measure."),
                     {title_of(series)}, GLISSON_TEXT("Choose the grey-scale series that it was made from."));
    }
  }
  const std::uint64_t needed = std::uint64_t{sizeof(float)} * series.grid.voxels();
  const std::uint64_t installed =
      static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  if (needed > installed) {
    return refused(series, "series-too-large",
                   GLISSON_TEXT("The series {0} needs {1} GiB of memory, more than this computer has."),
                   {title_of(series), fmt::format("{:.1f}", static_cast<double>(needed) / (1 << 30))});
  }
  return {};
}

Result<Volume> read_whole_file(const Series& series) {
  Result<Volume> volume = read_volume_file(series.layout->volume_file);
  if (volume && !same_grid(volume->grid, series.grid)) {
    return refused(series, "file-changed", GLISSON_TEXT("{0} is not any more as it was when the folder was scanned."),
                   {series.layout->volume_file.string()}, GLISSON_TEXT("Scan the folder again."));
  }
  return volume;
}

Result<void> read_slice(FrameReader& reader, const VoxelLayout& layout, const SliceTerms& terms, const Grid& grid,
                        float* slice, std::vector<float>& second) {
  const auto source = [&](int index) -> const SliceSource& { return layout.sources[static_cast<std::size_t>(index)]; };
  const Result<void> read = reader.read(source(terms.first), grid.size[0], grid.size[1], slice);
  if (!read || terms.second < 0) return read;
  const std::size_t count = static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1]);
  second.resize(count);
  if (const Result<void> more = reader.read(source(terms.second), grid.size[0], grid.size[1], second.data()); !more) {
    return more;
  }
  for (std::size_t i = 0; i < count; ++i) slice[i] += terms.weight_of_second * (second[i] - slice[i]);
  return {};
}

}  // namespace

Result<Volume> read_series(const Series& series, int volume_number, const Progress& progress) {
  if (const Result<void> readable = check_readable(series, volume_number); !readable) {
    return failure(readable.error());
  }
  const VoxelLayout& layout = *series.layout;
  if (!layout.volume_file.empty()) return read_whole_file(series);

  Volume volume;
  volume.grid = series.grid;
  volume.unit = series.unit;
  volume.values.resize(series.grid.voxels());
  const auto slices = static_cast<std::size_t>(series.grid.size[2]);
  const std::size_t first_slice = slices * static_cast<std::size_t>(volume_number);

  std::mutex reporting;
  std::optional<Error> first_error;
  std::atomic<std::size_t> done{0};
  std::atomic<bool> stop{false};
  parallel_for(slices, 2, [&](std::size_t begin, std::size_t end) {
    FrameReader reader(layout);
    std::vector<float> second;
    for (std::size_t k = begin; k < end && !stop && !progress.cancelled(); ++k) {
      float* slice = volume.values.data() + series.grid.offset(0, 0, static_cast<int>(k));
      const Result<void> read = read_slice(reader, layout, layout.slices[first_slice + k], series.grid, slice, second);
      const std::scoped_lock one_at_a_time(reporting);
      if (!read && !first_error) first_error = read.error();
      if (!read) stop = true;
      progress.report(static_cast<double>(++done) / static_cast<double>(slices), GLISSON_TEXT("Reading the slices"));
    }
  });
  if (first_error) return failure(std::move(*first_error));
  if (progress.cancelled()) return cancelled();
  return volume;
}

}  // namespace glisson::imaging
