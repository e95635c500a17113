#include "widgets/report/page_document.h"

#include <algorithm>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>
#include <QTextCursor>
#include <QTextTable>

#include "widgets/words/paths.h"

namespace glisson::widgets {
namespace {

// Of paper, whatever the window's theme.
const QColor ink(0x1b, 0x24, 0x30), soft(0x5b, 0x66, 0x73), line(0xd7, 0xdd, 0xe4), flag(0xb3, 0x26, 0x1e),
    good(0x1f, 0x6f, 0x43), band(0xff, 0xf3, 0xd6), band_ink(0x5c, 0x43, 0x00);
constexpr double page_width_px = 640;  // of text, at 96 dots an inch on A4

QString text(const std::string& words) { return QString::fromStdString(words); }

class Writer {
 public:
  explicit Writer(QTextDocument& document) : document_(document), cursor_(&document) {}

  void paragraph(const QString& words, double points, const QColor& colour, bool bold = false, double above_px = 4) {
    QTextBlockFormat block;
    block.setTopMargin(above_px);
    block.setBottomMargin(4);
    next_block(block);
    cursor_.insertText(words, letters(points, colour, bold));
  }

  void warning(const QString& words) {
    QTextBlockFormat block;
    block.setBackground(band);
    block.setAlignment(Qt::AlignCenter);
    block.setBottomMargin(10);
    next_block(block);
    cursor_.insertText(words, letters(9.5, band_ink, true));
  }

  void operator()(const report::Heading& heading) { paragraph(text(heading.text), 13, ink, true, 18); }
  void operator()(const report::Paragraph& words) { paragraph(text(words.text), 9.5, ink); }

  void operator()(const report::Table& table) {
    if (!table.caption.empty()) paragraph(text(table.caption), 8.5, soft);
    const bool headed =
        std::any_of(table.columns.begin(), table.columns.end(), [](const auto& name) { return !name.empty(); });
    QTextTableFormat format;
    format.setBorderStyle(QTextFrameFormat::BorderStyle_None);
    format.setCellPadding(3);
    format.setCellSpacing(0);
    format.setBottomMargin(6);
    if (headed) format.setHeaderRowCount(1);
    const int rows = static_cast<int>(table.rows.size()) + (headed ? 1 : 0);
    if (rows == 0) return;
    next_block({});
    QTextTable* made = cursor_.insertTable(rows, static_cast<int>(table.columns.size()), format);
    const auto put = [&](int row, int column, const QString& words, const QTextCharFormat& look) {
      QTextTableCell cell = made->cellAt(row, column);
      QTextTableCellFormat border;
      border.setBottomBorder(0.5);
      border.setBottomBorderStyle(QTextFrameFormat::BorderStyle_Solid);
      border.setBottomBorderBrush(line);
      cell.setFormat(border);
      QTextCursor at = cell.firstCursorPosition();
      QTextBlockFormat aligned;
      aligned.setAlignment(column == 0 || table.columns.size() == 2 ? Qt::AlignLeft : Qt::AlignRight);
      at.setBlockFormat(aligned);
      at.insertText(words, look);
    };
    for (int column = 0; headed && column < static_cast<int>(table.columns.size()); ++column) {
      put(0, column, text(table.columns[static_cast<std::size_t>(column)]), letters(8.5, ink, true));
    }
    for (int row = headed ? 1 : 0; row < rows; ++row) {
      const auto& cells = table.rows[static_cast<std::size_t>(row - (headed ? 1 : 0))];
      for (int column = 0; column < static_cast<int>(cells.size()); ++column) {
        const report::Cell& cell = cells[static_cast<std::size_t>(column)];
        const bool flagged = cell.emphasis == report::Cell::Emphasis::flag;
        put(row, column, text(cell.text),
            letters(8.5,
                    flagged                                         ? flag
                    : cell.emphasis == report::Cell::Emphasis::good ? good
                                                                    : ink,
                    flagged));
      }
    }
    cursor_.movePosition(QTextCursor::End);
  }

  // Beside each other, each with its caption below it; one alone leaves room for what follows on the page.
  void operator()(const report::FigureRow& row) {
    if (row.figures.size() == 1) {
      const report::Figure& figure = row.figures.front();
      return picture(QImage(text_of(figure.png)), text(figure.caption), 0.55 * page_width_px);
    }
    const int columns = static_cast<int>(row.figures.size());
    next_block({});
    QTextTableFormat format;
    format.setBorder(0);
    format.setCellPadding(2);
    format.setWidth(QTextLength(QTextLength::PercentageLength, 100));
    QTextTable* table = cursor_.insertTable(1, columns, format);
    for (int column = 0; column < columns; ++column) {
      const report::Figure& figure = row.figures[static_cast<std::size_t>(column)];
      const QImage image(text_of(figure.png));
      QTextCursor at = table->cellAt(0, column).firstCursorPosition();
      if (!image.isNull()) at.insertImage(image_format(image, page_width_px / columns - 10));
      at.insertBlock();
      at.insertText(text(figure.caption), letters(8.5, soft, false));
    }
    cursor_.movePosition(QTextCursor::End);
  }
  void operator()(const report::DrawingRow& row) {
    for (const report::Drawing& drawing : row.drawings) svg(drawing.svg, text(drawing.caption));
  }
  void operator()(const report::Plot& plot) { svg(report::svg_of(plot), text(plot.caption)); }

 private:
  static QTextCharFormat letters(double points, const QColor& colour, bool bold) {
    QTextCharFormat format;
    format.setFontPointSize(points);
    format.setForeground(colour);
    format.setFontWeight(bold ? QFont::DemiBold : QFont::Normal);
    return format;
  }
  void next_block(const QTextBlockFormat& format) {
    if (begun_) {
      cursor_.insertBlock(format);
    } else {
      cursor_.setBlockFormat(format);
    }
    begun_ = true;
  }
  QTextImageFormat image_format(const QImage& image, double width_px) {
    const QString name = QString("picture-%1").arg(pictures_++);
    document_.addResource(QTextDocument::ImageResource, QUrl(name), image);
    QTextImageFormat format;
    format.setName(name);
    format.setWidth(width_px);
    format.setHeight(width_px * image.height() / image.width());
    return format;
  }
  void picture(const QImage& image, const QString& caption, double width_px) {
    if (image.isNull()) return;
    next_block({});
    cursor_.insertImage(image_format(image, width_px));
    if (!caption.isEmpty()) paragraph(caption, 8.5, soft);
  }
  void svg(const std::string& drawing, const QString& caption) {
    QByteArray bytes = QByteArray::fromStdString(drawing);
    bytes.replace("currentColor", ink.name().toUtf8());
    bytes.replace("<svg ", "<svg xmlns=\"http://www.w3.org/2000/svg\" ");  // not translated
    QSvgRenderer renderer(bytes);
    constexpr int print_scale = 3;  // dots of the drawing for one of the page
    QImage image(renderer.defaultSize() * print_scale, QImage::Format_ARGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    renderer.render(&painter);
    painter.end();
    picture(image, caption, 0.8 * page_width_px);
  }

  QTextDocument& document_;
  QTextCursor cursor_;
  bool begun_ = false;
  int pictures_ = 0;
};

}  // namespace

std::unique_ptr<QTextDocument> document_of(const report::Page& page) {
  auto document = std::make_unique<QTextDocument>();
  document->setDocumentMargin(28);
  Writer writer(*document);
  if (!page.warning.empty()) writer.warning(text(page.warning));
  writer.paragraph(text(page.title), 20, ink, true);
  writer.paragraph(text(page.subtitle), 10, soft);
  for (const report::Block& block : page.blocks) std::visit(writer, block);
  writer.paragraph(text(page.footer), 8, soft, false, 18);
  return document;
}

}  // namespace glisson::widgets
