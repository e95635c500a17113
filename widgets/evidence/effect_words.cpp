#include "widgets/evidence/effect_words.h"

#include <array>
#include <QCoreApplication>
#include <QStringList>
#include <vector>

namespace glisson::widgets {
namespace {

struct EffectWords {
  const char* kind;
  const char* label;
};

constexpr const char* effects_context = "effects";

constexpr EffectWords known[] = {
    {"stiffness-scale", QT_TRANSLATE_NOOP("effects", "Stiffer or softer throughout")},
    {"strain-stiffening", QT_TRANSLATE_NOOP("effects", "Stiffens as it deforms")},
    {"support-compliance", QT_TRANSLATE_NOOP("effects", "The support gives way")},
    {"stiff-inclusion", QT_TRANSLATE_NOOP("effects", "A hidden stiffer region")},
    {"undeclared-attachment", QT_TRANSLATE_NOOP("effects", "Held where nothing was declared")},
    {"missing-attachment", QT_TRANSLATE_NOOP("effects", "A declared attachment gives way or is missing")},
    {"viscoelastic-creep", QT_TRANSLATE_NOOP("effects", "Creeps under load")},
    {"force-bias", QT_TRANSLATE_NOOP("effects", "The force sensor is off")},
    {"frame-misalignment", QT_TRANSLATE_NOOP("effects", "Camera and specimen misaligned")},
    {"anisotropy", QT_TRANSLATE_NOOP("effects", "Stiffer along one direction")},
    {"capsule", QT_TRANSLATE_NOOP("effects", "A stiff capsule around it")},
    {"preload", QT_TRANSLATE_NOOP("effects", "Already loaded at the start")},
    {"softening", QT_TRANSLATE_NOOP("effects", "Softer once it was stretched")},
    {"hysteresis", QT_TRANSLATE_NOOP("effects", "Loading and unloading differ")},
    {"tension-compression-asymmetry", QT_TRANSLATE_NOOP("effects", "Tension and compression differ")},
    {"internal-resistance", QT_TRANSLATE_NOOP("effects", "The battery's own resistance")},
    {"rate-capacity", QT_TRANSLATE_NOOP("effects", "Less charge when emptied fast")},
    {"self-heating", QT_TRANSLATE_NOOP("effects", "It warms itself")},
    {"discharge-curve", QT_TRANSLATE_NOOP("effects", "Voltage falls as it empties")},
    {"static-power", QT_TRANSLATE_NOOP("effects", "Power drawn at rest")},
    {"dynamic-power", QT_TRANSLATE_NOOP("effects", "Power drawn by the work")},
    {"thermal-throttling", QT_TRANSLATE_NOOP("effects", "Slows down when hot")},
    {"thermal-resistance", QT_TRANSLATE_NOOP("effects", "Sheds heat better or worse")},
    {"thermal-inertia", QT_TRANSLATE_NOOP("effects", "Takes time to warm up")},
    {"supply-loss", QT_TRANSLATE_NOOP("effects", "Power lost in the supply")},
    {"viscosity", QT_TRANSLATE_NOOP("effects", "Waves lose energy on their way")},
    {"compression-waves", QT_TRANSLATE_NOOP("effects", "Long waves that compress, besides shear waves")},
    {"slice-timing", QT_TRANSLATE_NOOP("effects", "Slices seen at different moments")},
    {"boundary-layer", QT_TRANSLATE_NOOP("effects", "Another stiffness along the border")},
    {"smooth-correction", QT_TRANSLATE_NOOP("effects", "A smooth correction, no cause")},
};

}  // namespace

QString effect_label(const std::string& kind) {
  for (const EffectWords& words : known) {
    if (kind == words.kind) return QCoreApplication::translate(effects_context, words.label);
  }
  return QString::fromStdString(kind);
}

QString effect_labels(const std::vector<std::string>& kinds) {
  QStringList labels;
  for (const std::string& kind : kinds) labels << effect_label(kind);
  return labels.isEmpty() ? QString("–") : labels.join(", ");
}

QString effect_or_parameter_label(const std::string& name) {
  const QString effect = effect_label(name);
  const bool is_name = name.find(' ') == std::string::npos && name.find('_') != std::string::npos;
  return effect == QString::fromStdString(name) && is_name ? parameter_label(name) : effect;
}

QString parameter_label(const std::string& name) {
  static constexpr std::array<std::pair<const char*, const char*>, 9> units{{{"_kPa_per_mm", ", kPa/mm"},
                                                                             {"_N_per_mm", ", N/mm"},
                                                                             {"_m_s2", ", m/s²"},
                                                                             {"_per_C", ", 1/°C"},
                                                                             {"_kPa", ", kPa"},
                                                                             {"_mm", ", mm"},
                                                                             {"_deg", ", °"},
                                                                             {"_ohm", ", Ω"},
                                                                             {"_N", ", N"}}};
  QString label = QString::fromStdString(name);
  for (const auto& [ending, unit] : units) {
    if (!label.endsWith(ending)) continue;
    label = label.chopped(static_cast<qsizetype>(std::char_traits<char>::length(ending))) + QString::fromUtf8(unit);
    break;
  }
  return label.replace('_', ' ');
}

}  // namespace glisson::widgets
