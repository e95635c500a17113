#include "mechanics/solvers/cholesky_factor.h"

#include <cholmod.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <functional>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>

#include "mechanics/solvers/internal/fill_in.h"
#include "mechanics/solvers/internal/principal_part.h"
#include "mechanics/solvers/internal/single_precision_factor.h"
#include "mechanics/solvers/internal/supernodes.h"

namespace glisson::mechanics {
namespace {

// OpenBLAS shares each of thousands of small products out among its threads, which spin until all are done: on a
// machine that has other work a solve of one second then takes a hundred. On one thread a factor is also the same to
// the bit whatever the number of cores. With another BLAS there is nothing to set.
void keep_blas_on_one_thread() {
  static const bool once = [] {
    if (void* set = dlsym(RTLD_DEFAULT, "openblas_set_num_threads")) reinterpret_cast<void (*)(int)>(set)(1);
    return true;
  }();
  static_cast<void>(once);
}

// CHOLMOD's own loops go to four OpenMP threads, whatever the machine has, and wait for each other by spinning: of a
// factor on one of two busy cores a third of the processor's time went there. A setting of the thread that calls.
void keep_cholmod_on_this_thread() {
  static auto* const set = reinterpret_cast<void (*)(int)>(dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"));
  if (set != nullptr) set(0);
}

void begin(cholmod_common& common) {
  keep_blas_on_one_thread();
  cholmod_start(&common);
  common.supernodal = CHOLMOD_SUPERNODAL;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_METIS;
  common.postorder = 1;
  common.print = 0;  // what went wrong is in common.status
}

}  // namespace

class EliminationOrder {
 public:
  // Of the matrix that `factor` was analysed from; neither is kept.
  EliminationOrder(const cholmod_sparse& matrix, cholmod_factor* factor, cholmod_common& analysed)
      : entries(analysed.lnz), pattern_(fingerprint(matrix)) {
    begin(common_);
    factor_ = cholmod_copy_factor(factor, &common_);
  }
  ~EliminationOrder() {
    cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
  }
  EliminationOrder(const EliminationOrder&) = delete;
  EliminationOrder& operator=(const EliminationOrder&) = delete;

  [[nodiscard]] bool belongs_to(const cholmod_sparse& matrix) const {
    return factor_ != nullptr && factor_->n == matrix.nrow && pattern_ == fingerprint(matrix);
  }
  // For the numbers to be filled in.
  [[nodiscard]] cholmod_factor* empty_factor(cholmod_common& common) const {
    return cholmod_copy_factor(factor_, &common);
  }
  const double entries;  // of the factor

 private:
  using Fingerprint = std::array<std::size_t, 3>;
  static Fingerprint fingerprint(const cholmod_sparse& matrix) {
    const auto of = [](const void* integers, std::size_t count) {
      return std::hash<std::string_view>()({static_cast<const char*>(integers), count * sizeof(int)});
    };
    return {matrix.nzmax, of(matrix.p, matrix.ncol + 1), of(matrix.i, matrix.nzmax)};
  }

  cholmod_common common_{};  // what the copy's memory is counted in
  cholmod_factor* factor_ = nullptr;
  Fingerprint pattern_;
};

struct CholeskyFactor::State {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  std::shared_ptr<const EliminationOrder> order;
  std::optional<SinglePrecisionFactor> rounded;  // in the place of `factor`, which then is freed
  int last = 0;                                  // how many unknowns were to be eliminated last
  double reciprocal_condition = 0;
  std::uint64_t bytes = 0;
  std::mutex one_at_a_time;  // cholmod_common is the workspace of every call

  State() { begin(common); }
  ~State() {
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
};

namespace {

// The matrix as CHOLMOD sees it; nothing is copied and nothing written.
cholmod_sparse view_of(const Eigen::SparseMatrix<double>& lower) {
  cholmod_sparse view{};
  view.nrow = static_cast<std::size_t>(lower.rows());
  view.ncol = static_cast<std::size_t>(lower.cols());
  view.nzmax = static_cast<std::size_t>(lower.nonZeros());
  view.p = const_cast<int*>(lower.outerIndexPtr());
  view.i = const_cast<int*>(lower.innerIndexPtr());
  view.x = const_cast<double*>(lower.valuePtr());
  view.stype = -1;  // the lower triangle
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

double gigabytes(double bytes) { return bytes / (1 << 30); }

// Of a panel, in columns: narrower ones waste still less, and take more time to be put together.
constexpr int widest_panel = 256;

// METIS's order of the others, then the last ones as they stand.
std::vector<int> order_with_last(const Eigen::SparseMatrix<double>& lower, const std::vector<int>& last,
                                 cholmod_common& common);

}  // namespace

// LAPACK's inverse of A from its Cholesky factor, in place.
extern "C" void dpotri_(const char* triangle, const int* size, double* a, const int* leading, int* info);

Result<CholeskyFactor> CholeskyFactor::create(const Eigen::SparseMatrix<double>& lower,
                                              std::uint64_t memory_limit_bytes, const Progress& progress,
                                              std::shared_ptr<const EliminationOrder> known,
                                              const std::vector<int>& last) {
  GLISSON_ASSERT(lower.isCompressed() && lower.rows() == lower.cols());
  keep_cholmod_on_this_thread();
  auto state = std::make_shared<State>();
  cholmod_common& common = state->common;
  cholmod_sparse matrix = view_of(lower);

  progress.report(0.0, GLISSON_TEXT("Ordering the equations"));
  if (progress.cancelled()) return cancelled();
  if (!last.empty()) {
    std::vector<int> order = order_with_last(lower, last, common);
    common.method[0].ordering = CHOLMOD_GIVEN;
    common.postorder = 0;  // METIS's is in postorder already, and the last ones must stay where they are
    state->factor = cholmod_analyze_p(&matrix, order.data(), nullptr, 0, &common);
    if (state->factor != nullptr) split_wide_supernodes(*state->factor, widest_panel, common);
    state->last = static_cast<int>(last.size());
  } else if (known && known->belongs_to(matrix)) {
    state->factor = known->empty_factor(common);
    state->order = std::move(known);
  } else {
    state->factor = cholmod_analyze(&matrix, &common);
    if (state->factor != nullptr) {
      split_wide_supernodes(*state->factor, widest_panel, common);
      state->order = std::make_shared<const EliminationOrder>(matrix, state->factor, common);
    }
  }
  const double corner_bytes = 8.0 * static_cast<double>(last.size()) * static_cast<double>(last.size());
  const double needed_bytes = state->order ? 8.0 * state->order->entries : 8.0 * common.lnz + corner_bytes;
  if (state->factor != nullptr && needed_bytes > static_cast<double>(memory_limit_bytes)) {
    return failure(Error{"too-large",
                         GLISSON_TEXT("Solving for {0} unknowns would take {1} GB of memory; the limit is {2} GB."),
                         {std::to_string(lower.rows()), fmt::format("{:.1f}", gigabytes(needed_bytes)),
                          fmt::format("{:.1f}", gigabytes(static_cast<double>(memory_limit_bytes)))},
                         GLISSON_TEXT("Mesh with fewer cells."),
                         {}});
  }

  progress.report(0.1, GLISSON_TEXT("Factorising"));
  if (progress.cancelled()) return cancelled();
  if (state->factor != nullptr) cholmod_factorize(&matrix, state->factor, &common);
  if (common.status == CHOLMOD_NOT_POSDEF) {
    return failure(
        Error{"factorisation-failed",
              GLISSON_TEXT("The stiffness matrix is not positive definite (column {0} of {1})."),
              {std::to_string(state->factor->minor), std::to_string(lower.rows())},
              GLISSON_TEXT("Poisson's ratio may be too near 1/2, or cells may be flat: look at the mesh's quality."),
              {}});
  }
  if (state->factor == nullptr || common.status < CHOLMOD_OK) {
    return failure("factorisation-failed", GLISSON_TEXT("The solver ran out of memory for {0} unknowns."),
                   {std::to_string(lower.rows())});
  }
  state->reciprocal_condition = cholmod_rcond(state->factor, &common);
  state->bytes = static_cast<std::uint64_t>(state->factor->xsize) * sizeof(double);
  progress.report(1.0, GLISSON_TEXT("Factorised"));
  return CholeskyFactor(std::move(state));
}

void CholeskyFactor::keep_in_single_precision() {
  GLISSON_ASSERT(state_->last == 0);
  if (state_->rounded) return;
  state_->rounded.emplace(*state_->factor);
  state_->bytes = state_->rounded->bytes();
  cholmod_free_factor(&state_->factor, &state_->common);
}

bool CholeskyFactor::in_single_precision() const { return state_->rounded.has_value(); }

Eigen::MatrixXd CholeskyFactor::solve(const Eigen::MatrixXd& right_hand_sides) const {
  if (state_->rounded)
    return right_hand_sides.cols() == 0 ? right_hand_sides : state_->rounded->solve(right_hand_sides);
  GLISSON_ASSERT(static_cast<std::size_t>(right_hand_sides.rows()) == state_->factor->n);
  if (right_hand_sides.cols() == 0) return right_hand_sides;
  cholmod_dense view{};
  view.nrow = static_cast<std::size_t>(right_hand_sides.rows());
  view.ncol = static_cast<std::size_t>(right_hand_sides.cols());
  view.nzmax = view.nrow * view.ncol;
  view.d = view.nrow;
  view.x = const_cast<double*>(right_hand_sides.data());
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;

  keep_cholmod_on_this_thread();
  const std::lock_guard lock(state_->one_at_a_time);
  cholmod_dense* solution = cholmod_solve(CHOLMOD_A, state_->factor, &view, &state_->common);
  if (solution == nullptr) throw std::bad_alloc();
  Eigen::MatrixXd columns = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(solution->x),
                                                              right_hand_sides.rows(), right_hand_sides.cols());
  cholmod_free_dense(&solution, &state_->common);
  return columns;
}

Eigen::MatrixXd CholeskyFactor::inverse_of_last() const {
  GLISSON_ASSERT(!state_->rounded);
  const cholmod_factor& factor = *state_->factor;
  const int size = state_->last, before = static_cast<int>(factor.n) - size;
  Eigen::MatrixXd corner = Eigen::MatrixXd::Zero(size, size);
  if (size == 0) return corner;
  const auto* first_column = static_cast<const int*>(factor.super);
  const auto* first_row = static_cast<const int*>(factor.pi);
  const auto* first_value = static_cast<const int*>(factor.px);
  const auto* row = static_cast<const int*>(factor.s);
  const auto* value = static_cast<const double*>(factor.x);
  for (std::size_t k = 0; k < factor.nsuper; ++k) {
    const int rows = first_row[k + 1] - first_row[k];
    for (int column = std::max(first_column[k], before); column < first_column[k + 1]; ++column) {
      const int begin = column - first_column[k];  // above the diagonal a supernode holds nothing
      const double* values = value + first_value[k] + static_cast<std::ptrdiff_t>(begin) * rows;
      for (int i = begin; i < rows; ++i) corner(row[first_row[k] + i] - before, column - before) = values[i];
    }
  }
  int info = 0;
  dpotri_("L", &size, corner.data(), &size, &info);
  GLISSON_ASSERT(info == 0);
  corner.triangularView<Eigen::StrictlyUpper>() = corner.transpose();
  return corner;
}

FillIn fill_in_of(const Eigen::SparseMatrix<double>& lower) {
  cholmod_common common{};
  begin(common);
  cholmod_sparse matrix = view_of(lower);
  cholmod_factor* pattern = cholmod_analyze(&matrix, &common);
  const FillIn fill_in{common.lnz, common.fl};
  cholmod_free_factor(&pattern, &common);
  cholmod_finish(&common);
  return fill_in;
}

std::shared_ptr<const EliminationOrder> CholeskyFactor::order() const { return state_->order; }

double CholeskyFactor::reciprocal_condition() const { return state_->reciprocal_condition; }

std::uint64_t CholeskyFactor::bytes() const { return state_->bytes; }

namespace {

std::vector<int> order_with_last(const Eigen::SparseMatrix<double>& lower, const std::vector<int>& last,
                                 cholmod_common& common) {
  std::vector<std::uint8_t> is_last(static_cast<std::size_t>(lower.rows()), 0);
  for (const int unknown : last) is_last[unknown] = 1;
  std::vector<int> others;
  for (std::size_t i = 0; i < is_last.size(); ++i) {
    if (is_last[i] == 0) others.push_back(static_cast<int>(i));
  }
  const Eigen::SparseMatrix<double> part = principal_part(lower, others);
  cholmod_sparse view = view_of(part);
  std::vector<int> order(others.size());
  if (!others.empty()) cholmod_metis(&view, nullptr, 0, 1, order.data(), &common);
  for (int& unknown : order) unknown = others[unknown];
  order.insert(order.end(), last.begin(), last.end());
  return order;
}

}  // namespace

}  // namespace glisson::mechanics
