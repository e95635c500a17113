#pragma once
// A report's page as a text document, to be read in the window and printed: black on white, as on paper.

#include <memory>
#include <QTextDocument>

#include "report/page.h"

namespace glisson::widgets {

[[nodiscard]] std::unique_ptr<QTextDocument> document_of(const report::Page& page);

}  // namespace glisson::widgets
