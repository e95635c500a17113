#include "report/html.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include "base/files.h"
#include "base/markup.h"

namespace glisson::report {
namespace {

// Widths in rem; light and dark by the reader's setting; prints on A4.
constexpr const char* style = R"css(
:root { color-scheme: light dark; --ink: #1b2430; --soft: #5b6673; --paper: #ffffff; --line: #d7dde4; --flag: #b3261e;
  --good: #1f6f43; --band: #fff3d6; --band-ink: #5c4300; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6ebf1; --soft: #9aa7b5; --paper: #14181e; --line: #313a45;
  --flag: #ff8a80; --good: #7bd6a3; --band: #3a2f10; --band-ink: #ffe2a0; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.55 system-ui, "DejaVu Sans", sans-serif; }
main { max-width: 66rem; margin: 0 auto; padding: 2rem 1.5rem 4rem; }
h1 { font-size: 2rem; line-height: 1.2; margin: 0 0 .25rem; }
h2 { font-size: 1.25rem; margin: 2.5rem 0 .5rem; }
p { max-width: 46rem; margin: .5rem 0; }
.subtitle, figcaption, caption, footer { color: var(--soft); }
.warning { background: var(--band); color: var(--band-ink); font-weight: 600; text-align: center; padding: .5rem 1rem; }
table { border-collapse: collapse; margin: 1rem 0; font-variant-numeric: tabular-nums; }
caption { text-align: left; padding-bottom: .4rem; font-size: .9rem; }
th, td { text-align: right; padding: .3rem .8rem; border-bottom: 1px solid var(--line); }
th:first-child, td:first-child { text-align: left; padding-left: 0; }
th { font-weight: 600; }
.flag { color: var(--flag); font-weight: 700; }
.good { color: var(--good); }
.figures { display: flex; flex-wrap: wrap; gap: 1rem; margin: 1rem 0; }
figure { flex: 1 1 20rem; margin: 0; }
.plot { max-width: 46rem; margin: 1.5rem 0; }
img { width: 100%; height: auto; display: block; border-radius: .4rem; }
figcaption { font-size: .9rem; margin-top: .4rem; }
footer { margin-top: 3rem; border-top: 1px solid var(--line); padding-top: 1rem; font-size: .85rem; }
)css";

std::string base64(const std::string& bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  const int written =
      EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                      reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(written));
  return text;
}

Result<std::string> html_of(const Figure& figure) {
  return read_text_file(figure.png, std::uint64_t{256} << 20).map([&](const std::string& bytes) {
    return fmt::format(
        "<figure><img alt=\"{0}\" src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption></figure>\n",
        escaped_markup(figure.caption), base64(bytes));
  });
}

std::string html_of(const Cell& cell) {
  switch (cell.emphasis) {
    case Cell::Emphasis::flag: return fmt::format("<td class=\"flag\">{}</td>", escaped_markup(cell.text));
    case Cell::Emphasis::good: return fmt::format("<td class=\"good\">{}</td>", escaped_markup(cell.text));
    case Cell::Emphasis::none: break;
  }
  return fmt::format("<td>{}</td>", escaped_markup(cell.text));
}

struct BlockWriter {
  Result<std::string> operator()(const Heading& heading) const {
    return fmt::format("<h2>{}</h2>\n", escaped_markup(heading.text));
  }
  Result<std::string> operator()(const Paragraph& paragraph) const {
    return fmt::format("<p>{}</p>\n", escaped_markup(paragraph.text));
  }
  Result<std::string> operator()(const Table& table) const {
    std::string html = fmt::format("<table><caption>{}</caption><thead><tr>", escaped_markup(table.caption));
    for (const std::string& column : table.columns) html += fmt::format("<th>{}</th>", escaped_markup(column));
    html += "</tr></thead><tbody>\n";
    for (const auto& row : table.rows) {
      html += "<tr>";
      for (const Cell& cell : row) html += html_of(cell);
      html += "</tr>\n";
    }
    return html + "</tbody></table>\n";
  }
  Result<std::string> operator()(const Plot& plot) const {
    return fmt::format("<figure class=\"plot\">{}<figcaption>{}</figcaption></figure>\n", svg_of(plot),
                       escaped_markup(plot.caption));
  }
  Result<std::string> operator()(const FigureRow& row) const {
    std::string html = "<div class=\"figures\">";
    for (const Figure& figure : row.figures) {
      auto made = html_of(figure);
      if (!made) return made;
      html += *made;
    }
    return html + "</div>\n";
  }
  Result<std::string> operator()(const DrawingRow& row) const {
    std::string html = "<div class=\"figures\">";
    for (const Drawing& drawing : row.drawings)
      html +=
          fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", drawing.svg, escaped_markup(drawing.caption));
    return html + "</div>\n";
  }
};

}  // namespace

Result<void> write_html(const std::filesystem::path& file, const Page& page) {
  std::string html = fmt::format(
      "<!doctype html>\n<html lang=\"{4}\"><head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><title>{0}</title><style>{1}</style>"
      "</head>\n<body>{2}<main><h1>{0}</h1><p class=\"subtitle\">{3}</p>\n",
      escaped_markup(page.title), style,
      page.warning.empty() ? "" : fmt::format("<div class=\"warning\">{}</div>", escaped_markup(page.warning)),
      escaped_markup(page.subtitle), escaped_markup(page.language));
  for (const Block& block : page.blocks) {
    auto made = std::visit(BlockWriter{}, block);
    if (!made) return failure(made.error());
    html += *made;
  }
  html += fmt::format("<footer>{}</footer></main></body></html>\n", escaped_markup(page.footer));
  return write_text_file(file, html);
}

}  // namespace glisson::report
