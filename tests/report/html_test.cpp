// A report stands by itself and lets nothing through that came in as text.

#include <gmock/gmock.h>

#include "base/files.h"
#include "report/html.h"

namespace glisson::report {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Html, HoldsItsPicturesAndNoReferenceToAnythingElse) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_text_file(folder.path() / "p.png", "Man"));
  const Page page{"Title", "", "SIMULATED", {FigureRow{{{folder.path() / "p.png", "a picture"}}}}, ""};
  ASSERT_TRUE(write_html(folder.path() / "r.html", page));
  const std::string html = read_text_file(folder.path() / "r.html").value();
  EXPECT_THAT(html, HasSubstr("data:image/png;base64,TWFu\""));  // RFC 4648: "Man" is TWFu
  EXPECT_THAT(html, HasSubstr("SIMULATED"));
  EXPECT_THAT(html, Not(HasSubstr("http")));
  EXPECT_THAT(html, Not(HasSubstr("<script")));
}

TEST(Html, APatientNameCannotBecomeMarkup) {
  const TemporaryFolder folder;
  const std::string name = "<img src=x onerror=\"alert('1')\">&";
  const Page page{
      name, name, name, {Heading{name}, Paragraph{name}, Table{name, {name}, {{{name, Cell::Emphasis::flag}}}}}, name};
  ASSERT_TRUE(write_html(folder.path() / "r.html", page));
  EXPECT_THAT(read_text_file(folder.path() / "r.html").value(), Not(HasSubstr("<img")));
}

TEST(Html, AMissingPictureIsSaid) {
  const TemporaryFolder folder;
  const Page page{"", "", "", {FigureRow{{{folder.path() / "absent.png", ""}}}}, ""};
  EXPECT_EQ(write_html(folder.path() / "r.html", page).error().code, "file-not-readable");
}

}  // namespace
}  // namespace glisson::report
