#pragma once
// What closing the loop found, as its report says it. It is read from report.json, model.json and report.html, whether
// they were written a moment ago or a year.

#include <filesystem>
#include <optional>
#include <QString>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/sentence.h"

namespace glisson::widgets {

struct EvidenceErrors {
  double rms = 0, mean = 0, p95 = 0, noise = 0, reduced_chi2 = 0;
  std::optional<double> held_out_rms, held_out_low, held_out_high;
  std::optional<double> hidden_target_mm;  // mean, of guidance whose hidden targets are known
};

struct EvidenceParameter {
  std::string name;
  std::string value, std, low, high;  // as they are shown: a vector is "(1, 2, 3)"; empty for none
  bool determined = true;
};

struct EvidenceEffect {
  std::string kind;
  std::string law;
  std::string sentence;
  std::vector<EvidenceParameter> parameters;
  std::optional<double> delta_bic, held_out_rms, held_out_rms_without;
  std::vector<std::string> alike;
};

struct EvidenceCandidate {
  std::string kind;
  std::string law;
  std::optional<double> rms, held_out_rms, delta_bic;
  std::vector<std::string> alike;
  std::string removed;  // why it is out of the running
};

struct EvidenceDrawing {
  std::string svg;
  QString caption;
};

struct EvidenceProbability {
  std::optional<std::vector<std::string>>
      kinds;  // what acts together; empty: nothing is missing; absent: something else
  double probability = 0;
};

// From which value on an effect would have been seen in nine of ten such experiments.
struct EvidenceVisible {
  std::string kind, law, parameter;
  int component = 0;  // of a parameter that is a vector, from 1; else 0
  double no_effect = 0;
  std::optional<double> value;  // absent: at none in the parameter's range
};

// A report of an older version has the sentence alone, in English, the kinds in it.
struct EvidenceNextTrial {
  Sentence sentence;
  std::vector<std::string> tells_apart;  // kinds
  std::optional<double> doubt_removed;   // share
};

struct EvidenceRecord {
  std::filesystem::path folder;
  std::string experiment_kind;  // "palpation", "material", "platform", "guidance", "full-field", "elastography"
  std::string learnt_from;      // name of the experiment's file
  std::string title;            // of the experiment; of an old report that file's name
  std::string verdict;          // "nothing-missing", "explained", "unexplained"
  std::string unit;             // "mm", "kPa", "noise"
  EvidenceErrors before, after;
  std::vector<std::string> shape_before, shape_after;  // in what the rest is not noise; empty for noise
  std::vector<EvidenceEffect> effects;
  std::vector<EvidenceCandidate> ranking;
  std::vector<EvidenceProbability> probabilities;  // the likeliest first; of an old report none
  std::vector<EvidenceVisible> visible;            // where nothing is missing; of an old report none
  std::vector<EvidenceNextTrial> next;             // what to measure next, one after the other
  std::vector<Sentence> notes;
  std::vector<EvidenceDrawing> drawings;
};

// Fails with "not-a-report": a file is missing, or is not what explain writes.
Result<EvidenceRecord> read_evidence(const std::filesystem::path& folder);

}  // namespace glisson::widgets
