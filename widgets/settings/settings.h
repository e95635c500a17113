#pragma once
// What a person chose and wants again the next time; kept by QSettings. The language is kept by words/language.h, the
// theme by theme.h.

#include <filesystem>
#include <vector>

namespace glisson::widgets {

// What this program keeps for itself on this computer: demo patient, log, open work. It need not be there yet.
[[nodiscard]] std::filesystem::path own_folder();

// The patient's name in pictures, movies and reports that leave the window. Off until asked for.
[[nodiscard]] bool names_shown_outside();
void show_names_outside(bool shown);

// Processors that computations may take; 0 for all.
[[nodiscard]] int kept_threads();
void keep_threads(int threads);  // at once, too

// Cases opened before that are still there, the last one first; at most eight.
[[nodiscard]] std::vector<std::filesystem::path> recent_cases();
void remember_case(const std::filesystem::path& folder);
void forget_recent_cases();

}  // namespace glisson::widgets
