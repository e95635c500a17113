#pragma once
// What a person chose and wants again the next time; kept by QSettings. The language is kept by words/language.h, the
// theme by theme.h.

#include <filesystem>
#include <optional>
#include <QString>
#include <vector>

#include "widgets/views/grey_window.h"

namespace glisson::widgets {

// What this program keeps for itself on this computer: demo patient, log, open work. It need not be there yet.
[[nodiscard]] std::filesystem::path own_folder();

// The patient's name in pictures, movies and reports that leave the window. Off until asked for.
[[nodiscard]] bool names_shown_outside();
void show_names_outside(bool shown);

// Processors that computations may take; 0 for all.
[[nodiscard]] int kept_threads();
void keep_threads(int threads);  // at once, too

// Another program that outlines structures, and what the values of its label maps are, as a person typed both: a
// command (casefile/outlined_by_program.h) and "1=liver, 2=tumour-1". Empty until given.
struct KeptProgram {
  QString command, values;
};
[[nodiscard]] KeptProgram kept_program();
void keep_program(const KeptProgram& program);

// The file of a shape model by which Segment finds the liver (casefile/found_liver.h). Empty for nobody's.
[[nodiscard]] QString kept_shapes();
void keep_shapes(const QString& file);

// Cases opened before that are still there, the last one first; at most eight.
[[nodiscard]] std::vector<std::filesystem::path> recent_cases();
void remember_case(const std::filesystem::path& folder);
void forget_recent_cases();  // with their brightness and contrast

// Brightness and contrast that a person chose for the images of a case; those of the last hundred cases.
[[nodiscard]] std::optional<GreyWindow> kept_window(const std::filesystem::path& case_folder);
void keep_window(const std::filesystem::path& case_folder, const GreyWindow& window);

}  // namespace glisson::widgets
