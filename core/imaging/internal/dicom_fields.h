#pragma once
// Single values out of a DCMTK data set, as plain C++ values.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "imaging/internal/checked_dicom.h"

namespace glisson::imaging {

// The data set that passed the gate, parsed. Null when DCMTK refuses it all the same.
[[nodiscard]] std::unique_ptr<DcmDataset> parse(const CheckedDicom& file);

// Empty or nothing where the element is absent, empty, or not of that kind. Text comes as valid UTF-8 without padding.
[[nodiscard]] std::string text_of(DcmItem& item, const DcmTagKey& key);
[[nodiscard]] std::vector<std::string> texts_of(DcmItem& item, const DcmTagKey& key);
[[nodiscard]] std::vector<double> numbers_of(DcmItem& item, const DcmTagKey& key);  // only finite ones
[[nodiscard]] std::optional<double> number_of(DcmItem& item, const DcmTagKey& key);
[[nodiscard]] int whole_number_of(DcmItem& item, const DcmTagKey& key, int otherwise);

// The n-th item of a sequence, or null.
[[nodiscard]] DcmItem* item_of(DcmItem& item, const DcmTagKey& sequence, unsigned n = 0);

// The key of a private element: its block is the one that `creator` has reserved in the group.
[[nodiscard]] std::optional<DcmTagKey> private_key(DcmItem& item, unsigned group, std::string_view creator,
                                                   unsigned element);
// The bytes of a private element, whichever value representation it was read with.
[[nodiscard]] std::string private_bytes(DcmItem& item, const DcmTagKey& key);

[[nodiscard]] std::string upper_case(std::string text);

}  // namespace glisson::imaging
