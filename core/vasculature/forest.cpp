#include "vasculature/internal/forest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace glisson::vasculature {

namespace {

using Eigen::Vector3d;

// Tuned on generated patients 1 to 10 (docs/territories.md). Energies are in units of the logarithm of a probability.
struct ForestCosts {
  double free_turn_deg = 15, turn_deg = 25;        // beyond Murray's angle
  double widening = 3;                             // a factor of e, on the way
  double radius_error_mm = 0.1, thinner = 0.25;    // of radii at forks; how much thinner children may be, a logarithm
  double hidden_mm3 = 2;                           // cubes of the radii of children too thin to be seen
  double end = 1.5;                                // a factor of e by which an end is wider than most ends are
  double entry = 3, far_entry = 6, entry_mm = 25;  // where a tree begins
  double inner_entry = 6;                          // where other vessels go on, far from where the system enters
  double shared_entry = 0.5;                       // one more tree at the same place
  double contact = 0.5, neck = 2, gap = 0.3, gap_per_mm = 0.05;
};
constexpr ForestCosts forest_costs;
constexpr std::int64_t moves_a_piece = 375, most_moves = 1'500'000;  // the latter for masks that are mostly noise
constexpr double hot = 2, cold = 0.15;
constexpr int other_forests = 50;
constexpr std::int64_t moves_between = 6, most_moves_between = 120'000;  // a piece, and of all
constexpr double warm = 2.2;

// Quadratic, and linear beyond `linear_from`: one odd place is no proof (Huber 1964, Ann Math Stat 35:73).
double robust(double off, double linear_from) {
  return off < linear_from ? 0.5 * off * off : linear_from * (off - 0.5 * linear_from);
}

// The angle at which a branch of r times the parent's radius leaves it at least work, the rest of the blood in one
// other.
double murray_angle_deg(double r) {
  if (r <= 0 || r >= 1) return 0;
  const double rest = std::cbrt(1 - r * r * r);
  const double cosine = (1 + std::pow(r, 4) - std::pow(rest, 4)) / (2 * r * r);
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
}

class ForestWalk {
 public:
  ForestWalk(const Junctions& junctions, const VesselEntries& entries, const KnownPieces& known, std::uint64_t seed);
  void cool();
  void begin_with(const Forest& forest);
  [[nodiscard]] std::vector<double> look_around();  // how many of the likely forests around agree, of each piece
  [[nodiscard]] Forest forest() const;

 private:
  // The ends of a piece: where its blood comes in or, of hepatic veins, goes out, and the other.
  [[nodiscard]] int near(int p) const { return 2 * p + near_[at(p)]; }
  [[nodiscard]] int far(int p) const { return 2 * p + 1 - near_[at(p)]; }
  [[nodiscard]] int junction(int end) const { return junctions_.end(end).junction; }
  [[nodiscard]] bool hangs_on(int p, int top) const;
  [[nodiscard]] int top_of(int p) const;
  [[nodiscard]] bool keeps_known() const;

  // The energy's terms: of joining two ends, of a piece with what hangs on it, of what begins in a junction.
  [[nodiscard]] double joining(int from_end, int to_end, const Passage& passage) const;
  [[nodiscard]] double of_piece(int p) const;
  [[nodiscard]] double of_entries(int junction) const;
  [[nodiscard]] double of_pieces(std::initializer_list<int> pieces) const;  // negative and repeated ones left out

  void hang(int p, int parent);
  [[nodiscard]] bool accepted(double change);  // of a move that is made
  [[nodiscard]] double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  // Moves of piece p: to another parent, to a tree of its own, all trees at its entry to the other system, and its way
  // up to some ancestor turned round, so that the blood comes in at its far end.
  void move();
  void hang_elsewhere(int p);
  void begin_here(int p);
  void change_system(int p);
  void turn_round(int p);
  struct Turn;
  void apply(const Turn& turn);
  void undo(const Turn& turn);

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  const Junctions& junctions_;
  KnownPieces known_;
  std::vector<std::vector<double>> joining_;  // as Junctions::passages
  std::array<std::vector<double>, 2> entry_;  // by junction
  std::vector<int> parent_, near_, system_;   // the system counts where a tree begins
  std::vector<std::vector<int>> children_;
  double end_mm_ = 1;  // the radius of most ends
  double temperature_ = 1;
  std::mt19937_64 engine_;
};

ForestWalk::ForestWalk(const Junctions& junctions, const VesselEntries& entries, const KnownPieces& known,
                       std::uint64_t seed)
    : junctions_(junctions),
      known_(known),
      parent_(junctions.pieces.size(), -1),
      near_(junctions.pieces.size(), 0),
      system_(junctions.pieces.size(), 0),
      children_(junctions.pieces.size()),
      engine_(seed) {
  std::vector<double> ends_mm;
  for (std::size_t j = 0; j < junctions_.ends_at.size(); ++j) {
    const std::vector<int>& ends = junctions_.ends_at[j];
    if (ends.size() == 1) ends_mm.push_back(junctions_.end(ends.front()).radius_mm);
    std::vector<double>& joining = joining_.emplace_back();
    std::array<double, 2> away = {1e9, 1e9};
    for (const int from : ends) {
      const Vector3d& place = junctions_.end(from).position_mm;
      away[0] = std::min(away[0], (place - entries.portal_mm).norm());
      away[1] = std::min(away[1], (place - entries.hepatic_mm).norm());
      for (const int to : ends) joining.push_back(this->joining(from, to, junctions_.passages[j][joining.size()]));
    }
    for (std::size_t s = 0; s < 2; ++s) {
      const double spreads = away[s] / (forest_costs.entry_mm * entries.scale);
      const double most = forest_costs.far_entry + (ends.size() > 1 ? forest_costs.inner_entry : 0);
      entry_[s].push_back(forest_costs.entry + most * (1 - std::exp(-0.5 * spreads * spreads)) + 0.002 * spreads);
    }
  }
  if (!ends_mm.empty()) {
    std::nth_element(ends_mm.begin(), ends_mm.begin() + static_cast<std::ptrdiff_t>(ends_mm.size() / 2), ends_mm.end());
    end_mm_ = std::clamp(ends_mm[ends_mm.size() / 2], 1.0, 2.5);
  }
  for (int p = 0; p < static_cast<int>(parent_.size()); ++p) {
    const Piece& piece = junctions_.pieces[at(p)];
    near_[at(p)] = piece.ends[1].radius_mm > piece.ends[0].radius_mm ? 1 : 0;
    const std::size_t j = at(junction(near(p)));
    system_[at(p)] = entry_[1][j] < entry_[0][j] ? 1 : 0;
  }
  for (const auto& [p, system] : known_) system_[at(p)] = static_cast<int>(system);
}

bool ForestWalk::keeps_known() const {
  return std::all_of(known_.begin(), known_.end(), [&](const auto& known) {
    return system_[at(top_of(known.first))] == static_cast<int>(known.second);
  });
}

bool ForestWalk::hangs_on(int p, int top) const {
  while (p >= 0 && p != top) p = parent_[at(p)];
  return p == top;
}

int ForestWalk::top_of(int p) const {
  while (parent_[at(p)] >= 0) p = parent_[at(p)];
  return p;
}

double ForestWalk::joining(int from_end, int to_end, const Passage& passage) const {
  const PieceEnd &from = junctions_.end(from_end), &to = junctions_.end(to_end);
  const double straight = std::clamp(-from.outwards.dot(to.outwards), -1.0, 1.0);
  const double turn_deg = std::acos(straight) * 180 / std::numbers::pi;
  const double free_deg = murray_angle_deg(to.radius_mm / from.radius_mm) + forest_costs.free_turn_deg;
  double cost = robust(std::max(0.0, turn_deg - free_deg) / forest_costs.turn_deg, 4);
  if (passage.contact) cost += forest_costs.contact + forest_costs.neck * std::max(0.0, 1 - passage.neck);
  if (passage.gap_mm > 0) cost += forest_costs.gap + forest_costs.gap_per_mm * passage.gap_mm;
  return cost;
}

double ForestWalk::of_piece(int p) const {
  double cost = forest_costs.widening * junctions_.pieces[at(p)].widens.at(at(near_[at(p)]));
  const PieceEnd& end = junctions_.end(far(p));
  if (children_[at(p)].empty()) {
    return cost + forest_costs.end * std::max(0.0, std::log(end.radius_mm / end_mm_));
  }
  double cubes = 0;
  for (const int child : children_[at(p)]) {
    cost += joining_[at(end.junction)][junctions_.between(far(p), near(child))];
    cubes += std::pow(junctions_.end(near(child)).radius_mm, 3);
  }
  const double cube = std::pow(end.radius_mm, 3), error = 0.05 + forest_costs.radius_error_mm / end.radius_mm;
  if (cubes > cube) return cost + robust(std::log(cubes / cube) / 3 / error, 3);
  const double missing = -std::log((cubes + forest_costs.hidden_mm3) / cube) / 3;
  return cost + robust(std::max(0.0, missing) / (error + forest_costs.thinner), 3);
}

double ForestWalk::of_entries(int junction) const {
  std::array<int, 2> begin{};
  for (const int end : junctions_.ends_at[at(junction)]) {
    const int p = end / 2;
    if (parent_[at(p)] < 0 && near(p) == end) ++begin.at(at(system_[at(p)]));
  }
  double cost = 0;
  for (std::size_t s = 0; s < 2; ++s) {
    if (begin[s] > 0) cost += entry_[s][at(junction)] + forest_costs.shared_entry * (begin[s] - 1);
  }
  return cost;
}

double ForestWalk::of_pieces(std::initializer_list<int> pieces) const {
  double cost = 0;
  for (const int* p = pieces.begin(); p != pieces.end(); ++p) {
    if (*p >= 0 && std::find(pieces.begin(), p, *p) == p) cost += of_piece(*p);
  }
  return cost;
}

void ForestWalk::hang(int p, int parent) {
  if (parent_[at(p)] >= 0) {
    std::vector<int>& siblings = children_[at(parent_[at(p)])];
    siblings.erase(std::find(siblings.begin(), siblings.end(), p));
  }
  parent_[at(p)] = parent;
  if (parent >= 0) children_[at(parent)].push_back(p);
}

bool ForestWalk::accepted(double change) {
  return (change <= 0 || uniform() < std::exp(-change / temperature_)) && keeps_known();
}

void ForestWalk::hang_elsewhere(int p) {
  const int j = junction(near(p)), old = parent_[at(p)];
  const std::vector<int>& ends = junctions_.ends_at[at(j)];
  const int end = ends[engine_() % ends.size()], parent = end / 2;
  if (parent == p || parent == old || far(parent) != end || hangs_on(parent, p)) return;
  const double before = of_pieces({parent, old}) + of_entries(j);
  hang(p, parent);
  if (!accepted(of_pieces({parent, old}) + of_entries(j) - before)) hang(p, old);
}

void ForestWalk::begin_here(int p) {
  const int j = junction(near(p)), old = parent_[at(p)], old_system = system_[at(p)];
  const double before = of_pieces({old}) + of_entries(j);
  hang(p, -1);
  system_[at(p)] = uniform() < 0.5 ? 0 : 1;
  if (accepted(of_pieces({old}) + of_entries(j) - before)) return;
  hang(p, old);
  system_[at(p)] = old_system;
}

void ForestWalk::change_system(int p) {
  const int top = top_of(p), j = junction(near(top)), system = system_[at(top)];
  std::vector<int> changed;
  for (const int end : junctions_.ends_at[at(j)]) {
    const int other = end / 2;
    if (parent_[at(other)] < 0 && near(other) == end && system_[at(other)] == system) changed.push_back(other);
  }
  const double before = of_entries(j);
  for (const int other : changed) system_[at(other)] = 1 - system;
  if (accepted(of_entries(j) - before)) return;
  for (const int other : changed) system_[at(other)] = system;
}

// path: from the piece up to the ancestor; beside: what else hangs on the ancestors, with the piece's place on the
// path.
struct ForestWalk::Turn {
  std::vector<int> path, children;
  std::vector<std::pair<int, std::size_t>> beside;
  int parent = -1, old_parent = -1, system = 0, old_system = 0, old_top_system = 0;
};

void ForestWalk::apply(const Turn& turn) {
  for (const int p : turn.path) hang(p, -1);
  for (const int child : turn.children) hang(child, turn.parent);
  for (const int p : turn.path) near_[at(p)] = 1 - near_[at(p)];
  for (const auto& [p, place] : turn.beside) hang(p, turn.path[place - 1]);
  for (std::size_t i = 1; i < turn.path.size(); ++i) hang(turn.path[i], turn.path[i - 1]);
  hang(turn.path.front(), turn.parent);
  if (turn.parent < 0) system_[at(turn.path.front())] = turn.system;
}

void ForestWalk::undo(const Turn& turn) {
  for (const int p : turn.path) hang(p, -1);
  for (const int p : turn.path) near_[at(p)] = 1 - near_[at(p)];
  for (const auto& [p, place] : turn.beside) hang(p, turn.path[place]);
  for (std::size_t i = 1; i < turn.path.size(); ++i) hang(turn.path[i - 1], turn.path[i]);
  for (const int child : turn.children) hang(child, turn.path.front());
  hang(turn.path.back(), turn.old_parent);
  system_[at(turn.path.front())] = turn.old_system;
  system_[at(turn.path.back())] = turn.old_top_system;
}

void ForestWalk::turn_round(int p) {
  Turn turn;
  int depth = 0, steps = 0;
  for (int q = p; parent_[at(q)] >= 0; q = parent_[at(q)]) ++depth;
  if (uniform() < 0.5) {
    while (steps < depth && uniform() < 0.5) ++steps;
  } else {
    steps = static_cast<int>(engine_() % static_cast<std::uint64_t>(depth + 1));
  }
  turn.path = {p};
  for (int i = 0; i < steps; ++i) turn.path.push_back(parent_[at(turn.path.back())]);
  const int top = turn.path.back();
  const std::vector<int>& ends = junctions_.ends_at[at(junction(far(p)))];
  const std::size_t pick = engine_() % (ends.size() + 1);
  if (pick < ends.size()) {
    turn.parent = ends[pick] / 2;
    if (turn.parent == p || far(turn.parent) != ends[pick] || hangs_on(turn.parent, top)) return;
  } else if (!children_[at(p)].empty()) {
    return;
  }
  turn.system = uniform() < 0.5 ? 0 : 1;
  turn.children = children_[at(p)];
  turn.old_parent = parent_[at(top)];
  turn.old_system = system_[at(p)];
  turn.old_top_system = system_[at(top)];
  for (std::size_t i = 1; i < turn.path.size(); ++i) {
    for (const int child : children_[at(turn.path[i])]) {
      if (child != turn.path[i - 1]) turn.beside.emplace_back(child, i);
    }
  }
  const int first = junction(near(top)), last = junction(far(p));
  const auto cost = [&] {
    double sum = of_pieces({turn.parent, turn.old_parent}) + of_entries(first) + (last != first ? of_entries(last) : 0);
    for (const int q : turn.path) sum += of_piece(q);
    return sum;
  };
  const double before = cost();
  apply(turn);
  if (!accepted(cost() - before)) undo(turn);
}

void ForestWalk::move() {
  const int p = static_cast<int>(engine_() % static_cast<std::uint64_t>(parent_.size()));
  const double which = uniform();
  if (which < 0.4) {
    hang_elsewhere(p);
  } else if (which < 0.9) {
    turn_round(p);
  } else if (which < 0.95) {
    begin_here(p);
  } else {
    change_system(p);
  }
}

void ForestWalk::cool() {
  const std::int64_t moves = std::min(static_cast<std::int64_t>(parent_.size()) * moves_a_piece, most_moves);
  for (std::int64_t m = 0; m < moves; ++m) {
    temperature_ = hot * std::pow(cold / hot, static_cast<double>(m) / static_cast<double>(moves));
    move();
  }
}

void ForestWalk::begin_with(const Forest& forest) {
  near_ = forest.near_end;
  for (int p = 0; p < static_cast<int>(parent_.size()); ++p) {
    system_[at(p)] = forest.system[at(p)] == System::portal_vein ? 0 : 1;
    hang(p, forest.parent[at(p)]);
  }
}

std::vector<double> ForestWalk::look_around() {
  const std::vector<System> begun = forest().system;
  std::vector<double> sure(parent_.size(), 0);
  temperature_ = warm;
  const std::int64_t between = std::min(static_cast<std::int64_t>(parent_.size()) * moves_between, most_moves_between);
  for (int n = 0; n < other_forests; ++n) {
    for (std::int64_t m = 0; m < between; ++m) move();
    for (int p = 0; p < static_cast<int>(parent_.size()); ++p) {
      const System system = system_[at(top_of(p))] == 0 ? System::portal_vein : System::hepatic_vein;
      if (system == begun[at(p)]) sure[at(p)] += 1.0 / other_forests;
    }
  }
  return sure;
}

Forest ForestWalk::forest() const {
  Forest forest{parent_, near_, {}, 0};
  for (int p = 0; p < static_cast<int>(parent_.size()); ++p) {
    forest.energy += of_piece(p);
    forest.system.push_back(system_[at(top_of(p))] == 0 ? System::portal_vein : System::hepatic_vein);
  }
  for (int j = 0; j < static_cast<int>(junctions_.ends_at.size()); ++j) forest.energy += of_entries(j);
  return forest;
}

}  // namespace

Forest cooled_forest(const Junctions& junctions, const VesselEntries& entries, const KnownPieces& known,
                     std::uint64_t seed) {
  ForestWalk walk(junctions, entries, known, seed);
  walk.cool();
  return walk.forest();
}

std::vector<double> sure_of(const Junctions& junctions, const VesselEntries& entries, const KnownPieces& known,
                            const Forest& forest) {
  ForestWalk walk(junctions, entries, known, 1);
  walk.begin_with(forest);
  return walk.look_around();
}

}  // namespace glisson::vasculature
