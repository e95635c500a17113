#include "studies/review/internal/review_page.h"

#include <fmt/format.h>
#include <algorithm>

#include "base/files.h"
#include "base/markup.h"

namespace glisson::studies {
namespace {

using registration_quality::StoredQuality;

// fmt wants its own braces doubled: the page is put together from pieces that hold none of its fields.
constexpr const char* head = R"html(<!doctype html>
<html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>Two registrations</title>
<style>
:root { color-scheme: light dark; --ink: #1b2430; --soft: #5b6673; --paper: #fff; --line: #d7dde4; --a: #0b6bcb; --b: #c2570c; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6ebf1; --soft: #9aa7b5; --paper: #14181e; --line: #313a45; --a: #6db3f8; --b: #ffa45c; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink); font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; }
main { max-width: 90rem; margin: 0 auto; padding: 1.5rem; }
h1 { font-size: 1.5rem; margin: 0 0 .25rem; }
p { margin: .25rem 0; color: var(--soft); }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 1rem; margin: 1rem 0; }
figure { margin: 0; } img { width: 100%; display: block; border-radius: .3rem; }
.a { color: var(--a); } .b { color: var(--b); }
.line { display: flex; gap: 1rem; align-items: center; } input { flex: 1; } button { font: inherit; padding: .2rem 1rem; }
svg { width: 100%; height: auto; margin: .5rem 0; } polyline { fill: none; stroke-width: 2; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; } td, th { padding: .2rem 1rem .2rem 0; text-align: right; border-bottom: 1px solid var(--line); }
th:first-child, td:first-child { text-align: left; }
</style><main>
)html";

constexpr const char* script = R"html(<script>
const slider = document.getElementById("time"), play = document.getElementById("play"), cursors = document.querySelectorAll(".cursor");
const last = Number(slider.max); let timer = null;
function show() {
  const name = String(slider.value).padStart(3, "0");
  document.getElementById("a").src = "a" + name + ".jpg"; document.getElementById("b").src = "b" + name + ".jpg";
  document.getElementById("frame").textContent = slider.value;
  for (const cursor of cursors) { const x = 60 + 920 * slider.value / Math.max(1, last); cursor.setAttribute("x1", x); cursor.setAttribute("x2", x); }
}
slider.addEventListener("input", show);
play.addEventListener("click", () => {
  if (timer) { clearInterval(timer); timer = null; play.textContent = "Play"; return; }
  play.textContent = "Pause"; timer = setInterval(() => { slider.value = (Number(slider.value) + 1) % (last + 1); show(); }, 100);
});
show();
</script></main></html>
)html";

std::string curve(const std::vector<double>& values, double largest, const char* eye) {
  std::string points;
  for (std::size_t t = 0; t < values.size(); ++t) {
    const double x =
        60 + 920.0 * static_cast<double>(t) / static_cast<double>(std::max<std::size_t>(1, values.size() - 1));
    points += fmt::format("{:.1f},{:.1f} ", x, 120 - 100 * values[t] / largest);
  }
  return fmt::format("<polyline points=\"{}\" style=\"stroke: var(--{})\"/>", points, eye);
}

// Both curves over the frames, from 0 to the largest value.
std::string chart(const std::string& title, const std::vector<double>& a, const std::vector<double>& b) {
  if (a.empty() || b.empty()) return {};
  const double largest = std::max({*std::max_element(a.begin(), a.end()), *std::max_element(b.begin(), b.end()), 1e-9});
  return fmt::format(
      "<p>{0}</p><svg viewBox=\"0 0 1000 140\" role=\"img\" aria-label=\"{0}\">"
      "<line x1=\"60\" y1=\"120\" x2=\"980\" y2=\"120\" stroke=\"var(--line)\"/>"
      "<text x=\"52\" y=\"25\" text-anchor=\"end\" font-size=\"14\" fill=\"currentColor\">{1:.1f}</text>"
      "<text x=\"52\" y=\"124\" text-anchor=\"end\" font-size=\"14\" fill=\"currentColor\">0</text>{2}{3}"
      "<line class=\"cursor\" y1=\"15\" y2=\"125\" x1=\"60\" x2=\"60\" stroke=\"currentColor\"/></svg>\n",
      escaped_markup(title), largest, curve(a, largest, "a"), curve(b, largest, "b"));
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

std::string row(const StoredQuality& judged, const char* eye, double tolerance_mm) {
  const auto& errors_mm = judged.quality.error_mm;
  const auto off = std::count_if(errors_mm.begin(), errors_mm.end(), [&](double mm) { return mm >= tolerance_mm; });
  return fmt::format("<tr><td class=\"{}\">{}</td><td>{:.3f}</td><td>{:.0f} %</td><td>{:.2f}</td><td>{}</td></tr>\n",
                     eye, escaped_markup(judged.method), judged.quality.mean_correlation,
                     errors_mm.empty() ? 0.0 : 100.0 * static_cast<double>(off) / static_cast<double>(errors_mm.size()),
                     mean(judged.quality.tre_mm),
                     judged.quality.rmse_mm.empty() ? "-" : fmt::format("{:.2f}", mean(judged.quality.rmse_mm)));
}

}  // namespace

Result<void> write_review_page(const std::filesystem::path& file, const StoredQuality& a, const StoredQuality& b,
                               double tolerance_mm) {
  std::string page = head;
  page += fmt::format(
      "<h1>Two registrations of one video</h1><p>{}. One colour scale for both; light green is good, dark blue is bad; "
      "grey "
      "triangles are off by {:g} mm or more.</p>\n",
      escaped_markup(a.sequence.string()), tolerance_mm);
  page += fmt::format(
      "<div class=\"pair\"><figure><img id=\"a\" alt=\"{0}\" src=\"a000.jpg\"><figcaption "
      "class=\"a\">{0}</figcaption></figure>"
      "<figure><img id=\"b\" alt=\"{1}\" src=\"b000.jpg\"><figcaption class=\"b\">{1}</figcaption></figure></div>\n",
      escaped_markup(a.method), escaped_markup(b.method));
  page += fmt::format(
      "<div class=\"line\"><button id=\"play\">Play</button><input id=\"time\" type=\"range\" min=\"0\" max=\"{}\" "
      "value=\"0\" aria-label=\"Frame\"><span>frame <b id=\"frame\">0</b></span></div>\n",
      a.quality.mesh_in_frames_mm.size() - 1);
  page += chart("Target registration error of the landmarks (mm)", a.quality.tre_mm, b.quality.tre_mm);
  page += chart("Distance from the model, RMSE (mm)", a.quality.rmse_mm, b.quality.rmse_mm);
  page += fmt::format(
      "<table><tr><th>Registration</th><th>mean correlation</th><th>off by {:g} mm or more</th><th>TRE (mm)</th>"
      "<th>RMSE (mm)</th></tr>\n",
      tolerance_mm);
  page += row(a, "a", tolerance_mm) + row(b, "b", tolerance_mm) + "</table>\n";
  page += script;
  return write_text_file(file, page);
}

}  // namespace glisson::studies
