#include "studies/gate/results.h"

#include <algorithm>
#include <set>

#include "base/csv.h"
#include "base/files.h"
#include "base/json.h"
#include "base/json_reading.h"

namespace glisson::studies {
namespace {

namespace fs = std::filesystem;

Result<Results> table_of(const fs::path& file, const std::string& text) {
  return reading("results-invalid", file, [&] {
    Results results;
    const std::vector<CsvRow> rows = csv_rows(text);
    if (rows.empty() || rows.front().cells.size() < 2 || rows.front().cells.front() != "case")
      refuse("", GLISSON_TEXT("{0} must begin with a line case,METRIC,METRIC, ..."), {file.string()});
    const std::vector<std::string_view>& names = rows.front().cells;
    std::vector<std::vector<double>*> columns;
    for (std::size_t c = 1; c < names.size(); ++c) {
      const auto [place, is_new] = results.metrics.try_emplace(std::string(names[c]));
      if (!is_new || names[c].empty())
        refuse("", GLISSON_TEXT("Column {0} of {1} has no name of its own."), {std::to_string(c + 1), file.string()});
      columns.push_back(&place->second);
    }
    std::set<std::string_view> seen;
    for (std::size_t r = 1; r < rows.size(); ++r) {
      const CsvRow& row = rows[r];
      if (row.cells.size() > names.size())
        refuse("", GLISSON_TEXT("Line {0} of {1} has more cells than the first."),
               {std::to_string(row.line), file.string()});
      if (row.cells.front().empty() || !seen.insert(row.cells.front()).second)
        refuse("", GLISSON_TEXT("Line {0} of {1} names no case, or one that was there before."),
               {std::to_string(row.line), file.string()});
      results.cases.emplace_back(row.cells.front());
      for (std::size_t c = 1; c < names.size(); ++c) columns[c - 1]->push_back(row.number(c));
    }
    if (results.cases.empty()) refuse("", GLISSON_TEXT("{0} holds no case."), {file.string()});
    return results;
  });
}

Result<void> read_about(const fs::path& file, Results& results) {
  std::error_code problem;
  if (!fs::exists(file, problem)) return {};
  const auto document = read_json_file(file);
  if (!document) return failure(document.error());
  const auto read = reading("results-invalid", file, [&] {
    only_keys(*document, {"program", "version", "data"}, "about.json");
    for (const auto& [key, into] : {std::pair{"program", &results.program}, std::pair{"version", &results.version},
                                    std::pair{"data", &results.data}}) {
      if (document->contains(key)) *into = text_in(document->at(key), key);
    }
    return true;
  });
  if (!read) return failure(read.error());
  return {};
}

// A picture lies one folder deep, in its case's.
std::map<std::string, fs::path> pictures_in(const fs::path& folder) {
  std::map<std::string, fs::path> pictures;
  std::error_code problem;
  for (fs::directory_iterator one(folder, problem), end; !problem && one != end; one.increment(problem)) {
    std::error_code inside;
    if (!one->is_directory(inside)) continue;
    for (fs::directory_iterator picture(one->path(), inside), last; !inside && picture != last;
         picture.increment(inside)) {
      const std::string extension = picture->path().extension().string();
      if (extension != ".png" && extension != ".jpg") continue;
      pictures[one->path().filename().string() + "/" + picture->path().filename().string()] = picture->path();
    }
  }
  return pictures;
}

}  // namespace

Result<Results> read_results(const fs::path& folder) {
  const fs::path file = folder / "metrics.csv";
  std::error_code problem;
  if (!fs::is_regular_file(file, problem)) {
    return failure(Error{"results-missing",
                         GLISSON_TEXT("{0} holds no metrics.csv."),
                         {folder.string()},
                         GLISSON_TEXT("Write one: a line case,METRIC,..., then a row for each case."),
                         file});
  }
  constexpr std::uint64_t limit_bytes = std::uint64_t{64} << 20;
  const auto text = read_text_file(file, limit_bytes);
  if (!text) return failure(text.error());
  auto results = table_of(file, *text);
  if (!results) return results;
  if (auto read = read_about(folder / "about.json", *results); !read) return failure(read.error());
  results->folder = folder;
  results->pictures = pictures_in(folder / "pictures");
  return results;
}

}  // namespace glisson::studies
