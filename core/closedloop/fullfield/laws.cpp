#include "closedloop/fullfield/laws.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>

#include "base/result.h"
#include "closedloop/fullfield/internal/second_order.h"

namespace glisson::closedloop {
namespace {

using Numbers = Eigen::Ref<const Eigen::VectorXd>;

SecondOrder isotropic_energy(std::string_view law, const Numbers& p, const SecondOrder& first,
                             const SecondOrder& volume);
SecondOrder fibre_energy(std::string_view law, const Numbers& p, const SecondOrder& fourth, const SecondOrder& volume);
std::vector<double> fibre_angles_deg(std::string_view law, const Numbers& p);

std::vector<double> every(double step, double first, double last) {
  std::vector<double> values;
  for (double value = first; value <= last; value += step) values.push_back(value);
  return values;
}

std::vector<LawForm> make_laws() {
  const LawParameter c10{"C10", LawNumber::shear, 0, 0, 0, {}};
  const LawParameter mu{"mu", LawNumber::shear, 0, 0, 0, {}};
  const LawParameter volume{"D", LawNumber::volume, 0, 0, 0, {}};
  const auto coefficient = [](const char* name) { return LawParameter{name, LawNumber::coefficient, 0, 0, 0, {}}; };
  const char* stiffening =
      GLISSON_TEXT("The material resists shear and change of volume by another law than the one that is declared.");
  const char* fibres = GLISSON_TEXT("The material is stiffer along fibres than across them.");
  return {
      {"neo-hookean", stiffening, {c10, volume}},
      {"mooney-rivlin", stiffening, {c10, coefficient("C01"), volume}},
      {"gent-thomas", stiffening, {c10, coefficient("C2"), volume}},
      {"gent", stiffening, {mu, volume, {"Jm", LawNumber::shape, 1e4, 0.05, 1e5, {2, 5, 20, 100}}}},
      {"arruda-boyce", stiffening, {mu, volume, {"N", LawNumber::shape, 1e4, 0.5, 1e5, {2, 5, 20, 60}}}},
      {"ogden", stiffening, {mu, volume, {"alpha", LawNumber::shape, 2, -30, 30, {-4, -2, -1, 0.5, 1.3, 3, 5, 8}}}},
      {"isihara", stiffening, {c10, coefficient("C01"), coefficient("C20"), volume}},
      {"yeoh", stiffening, {c10, coefficient("C20"), coefficient("C30"), volume}},
      {"fibre",
       fibres,
       {c10, coefficient("k"), volume, {"angle_deg", LawNumber::angle, 0, -95, 185, every(15, 0, 165)}}},
      {"haines-wilson", stiffening, {c10, coefficient("C01"), coefficient("C11"), coefficient("C30"), volume}},
      {"holzapfel",
       fibres,
       {c10,
        coefficient("k1"),
        volume,
        {"k2", LawNumber::shape, 1, 0.01, 100, {0.3, 1, 3}},
        {"angle_deg", LawNumber::angle, 45, -5, 95, every(15, 0, 90)}}},
  };
}

std::string letters_of(std::string_view name) {
  std::string letters;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return letters;
}

}  // namespace

Eigen::Index LawForm::coefficients() const {
  return std::count_if(parameters.begin(), parameters.end(), [](const LawParameter& parameter) {
    return parameter.number != LawNumber::shape && parameter.number != LawNumber::angle;
  });
}

const std::vector<LawForm>& plane_laws() {
  static const std::vector<LawForm> laws = make_laws();
  return laws;
}

const LawForm* plane_law(std::string_view name) {
  const auto& laws = plane_laws();
  std::string wanted = letters_of(name);
  if (wanted == "anisotropy" || wanted == "anisotropic" || wanted == "fiber") wanted = "fibre";
  if (wanted == "holzapfelgasserogden" || wanted == "hgo") wanted = "holzapfel";
  if (wanted == "mooney") wanted = "mooneyrivlin";
  const auto found =
      std::find_if(laws.begin(), laws.end(), [&](const LawForm& law) { return letters_of(law.name) == wanted; });
  return found == laws.end() ? nullptr : &*found;
}

void add_stress(const PlaneLaw& law, const Eigen::Vector4d& f, bool with_tangent, PlaneStress& to) {
  // J and its derivatives by F
  const double jacobian = f[0] * f[3] - f[1] * f[2];
  const Eigen::Vector4d by_volume(f[3], -f[2], -f[1], f[0]);
  const auto add = [&](const SecondOrder& w, const Eigen::Vector4d& by_x, const Eigen::Matrix4d& twice_by_x) {
    to.stress += w.x * by_x + w.y * by_volume;
    if (!with_tangent) return;
    Eigen::Matrix4d& a = to.tangent;
    a += w.xx * by_x * by_x.transpose() + w.yy * by_volume * by_volume.transpose();
    a += w.xy * (by_x * by_volume.transpose() + by_volume * by_x.transpose());
    a += w.x * twice_by_x;
    a(0, 3) += w.y;
    a(3, 0) += w.y;
    a(1, 2) -= w.y;
    a(2, 1) -= w.y;
  };
  const SecondOrder volume(jacobian, 0, 1);
  const std::string_view name = law.form->name;
  add(isotropic_energy(name, law.parameters, {f.squaredNorm() + 1, 1, 0}, volume), 2 * f,
      2 * Eigen::Matrix4d::Identity());
  for (const double angle_deg : fibre_angles_deg(name, law.parameters)) {
    const double angle = angle_deg * std::numbers::pi / 180;
    const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
    Eigen::Matrix<double, 2, 4> stretch;  // F a, as a matrix on F
    stretch << along.transpose(), Eigen::RowVector2d::Zero(), Eigen::RowVector2d::Zero(), along.transpose();
    const Eigen::Vector2d now = stretch * f;
    add(fibre_energy(name, law.parameters, {now.squaredNorm(), 1, 0}, volume), 2 * stretch.transpose() * now,
        2 * stretch.transpose() * stretch);
  }
}

double shear_modulus(const PlaneLaw& law) {
  PlaneStress at_rest;
  add_stress(law, {1, 0, 0, 1}, true, at_rest);
  return at_rest.tangent(1, 1);
}

namespace {

// l^alpha summed over the three stretches without their part of the volume, times J^(alpha/3), is p^s + q^s + 1 with
// s = alpha / 2 and p, q the squared stretches in the plane: p + q = I1 - 1, p q = J^2.
SecondOrder sum_of_powers(double s, const SecondOrder& first, const SecondOrder& volume) {
  const SecondOrder sum = first - 1.0;
  const SecondOrder difference = square(sum) - 4.0 * square(volume);
  // Equal stretches: the root has no slope there, the powers' sum, which is even in it, has.
  constexpr double nearly_equal = 1e-4;  // the next term is below 1e-12
  if (difference.value < nearly_equal * sum.value * sum.value) {
    const SecondOrder even = difference * pow(sum, -2);
    return 2.0 * pow(0.5 * sum, s) *
               (1.0 + (s * (s - 1) / 2) * even + (s * (s - 1) * (s - 2) * (s - 3) / 24) * square(even)) +
           1.0;
  }
  const SecondOrder root = sqrt(difference);
  return pow(0.5 * (sum + root), s) + pow(0.5 * (sum - root), s) + 1.0;
}

SecondOrder arruda_boyce(double chains, const SecondOrder& i) {
  constexpr std::array<double, 5> terms{1.0 / 2, 1.0 / 20, 11.0 / 1050, 19.0 / 7000, 519.0 / 673750};
  SecondOrder energy = 0.0;
  SecondOrder power = 1.0;
  double of_rest = 1, of_chains = 1;
  for (const double term : terms) {
    power = power * i;
    of_rest *= 3;
    energy = energy + (term / of_chains) * (power - of_rest);
    of_chains *= chains;
  }
  return energy;
}

SecondOrder isotropic_energy(std::string_view law, const Numbers& p, const SecondOrder& first,
                             const SecondOrder& volume) {
  const SecondOrder shape = pow(volume, -2.0 / 3);
  const SecondOrder i1 = first * shape;
  const SecondOrder k1 = i1 - 3.0;
  const auto k2 = [&] { return (first + square(volume) - 1.0) * square(shape) - 3.0; };
  const auto with_volume = [&](double d, const SecondOrder& energy) { return energy + d * square(volume - 1.0); };
  if (law == "neo-hookean") return with_volume(p[1], p[0] * k1);
  if (law == "mooney-rivlin") return with_volume(p[2], p[0] * k1 + p[1] * k2());
  if (law == "gent-thomas") return with_volume(p[2], p[0] * k1 + p[1] * log((1.0 / 3) * (k2() + 3.0)));
  if (law == "gent") return with_volume(p[1], (-0.5 * p[0] * p[2]) * log(1.0 - (1 / p[2]) * k1));
  if (law == "arruda-boyce") return with_volume(p[1], p[0] * arruda_boyce(p[2], i1));
  if (law == "ogden") {
    const double alpha = std::abs(p[2]) < 1e-3 ? 1e-3 : p[2];  // towards Hencky's law, where the powers are none
    const SecondOrder powers = sum_of_powers(alpha / 2, first, volume) * pow(volume, -alpha / 3);
    return with_volume(p[1], (2 * p[0] / (alpha * alpha)) * (powers - 3.0));
  }
  if (law == "isihara") return with_volume(p[3], p[0] * k1 + p[1] * k2() + p[2] * square(k1));
  if (law == "yeoh") return with_volume(p[3], p[0] * k1 + p[1] * square(k1) + p[2] * k1 * square(k1));
  if (law == "haines-wilson") {
    const SecondOrder second = k2();
    return with_volume(p[4], p[0] * k1 + p[1] * second + p[2] * k1 * second + p[3] * k1 * square(k1));
  }
  GLISSON_ASSERT(law == "fibre" || law == "holzapfel");
  return with_volume(p[2], p[0] * k1);
}

std::vector<double> fibre_angles_deg(std::string_view law, const Numbers& p) {
  if (law == "fibre") return {p[3]};
  if (law == "holzapfel") return {p[4], -p[4]};
  return {};
}

SecondOrder fibre_energy(std::string_view law, const Numbers& p, const SecondOrder& fourth, const SecondOrder& volume) {
  const SecondOrder strain = square(fourth * pow(volume, -2.0 / 3) - 1.0);
  if (law == "fibre") return p[1] * strain;
  return (p[1] / (2 * p[3])) * (exp(p[3] * strain) - 1.0);
}

}  // namespace
}  // namespace glisson::closedloop
