#pragma once
// A report as values: what it says, in the order in which it is read. html.h makes a page of it.

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "report/plot.h"

namespace glisson::report {

struct Paragraph {
  std::string text;
};

struct Cell {
  enum class Emphasis { none, flag, good };  // flag: what a surgeon must not overlook
  std::string text;
  Emphasis emphasis = Emphasis::none;
};

struct Table {
  std::string caption;
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;
};

struct Figure {
  std::filesystem::path png;
  std::string caption;
};

// Figures side by side.
struct FigureRow {
  std::vector<Figure> figures;
};

// Made by us, never from outside: SVG (drawing.h) that goes into the page as it is.
struct Drawing {
  std::string svg;
  std::string caption;
};

// Drawings side by side.
struct DrawingRow {
  std::vector<Drawing> drawings;
};

struct Heading {
  std::string text;
};

using Block = std::variant<Heading, Paragraph, Table, FigureRow, DrawingRow, Plot>;

struct Page {
  std::string title;
  std::string subtitle;
  std::string warning;  // on a band at the top: "SIMULATED ..."; empty for none
  std::vector<Block> blocks;
  std::string footer;
  std::string language = "en";  // as HTML has it
};

}  // namespace glisson::report
