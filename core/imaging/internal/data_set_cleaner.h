#pragma once
// One data set without identity, by the rules of confidentiality.h.

#include <map>
#include <string>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace glisson::imaging {

class DataSetCleaner {
 public:
  // New identifiers follow from the key and the old ones. `removed` counts what was removed, emptied or replaced.
  DataSetCleaner(std::string key, std::map<std::string, int>& removed) : key_(std::move(key)), removed_(removed) {}

  // Of a data set without its pixels. `series_description` stands for what the series said of itself.
  void clean(DcmDataset& data_set, const std::string& series_description);

 private:
  void clean_item(DcmItem& item);
  // Whether the element may stay, perhaps with another value.
  bool may_stay(DcmElement& element);
  bool keep_text(DcmElement& element, const std::string& text);
  bool replace_uids(DcmElement& element);
  void count(const DcmElement& element);
  [[nodiscard]] std::string pseudonym(const std::string& kind, const std::string& old) const;

  std::string key_;
  std::map<std::string, int>& removed_;
};

}  // namespace glisson::imaging
