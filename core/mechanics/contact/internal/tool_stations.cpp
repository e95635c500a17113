#include "mechanics/contact/internal/tool_stations.h"

#include <fmt/format.h>

namespace glisson::mechanics {

LargeContact outcome(const AugmentedLagrangian& lagrangian, StaticResult state, const std::vector<ContactTool>& tools,
                     bool rested, std::size_t station, std::size_t stations, const ContactOptions& options) {
  LargeContact contact{std::move(state), lagrangian.contacts(tools), lagrangian.report()};
  contact.result.relative_residual = contact.report.relative_residual;
  contact.result.iterations = contact.report.rounds;
  contact.report.energy_uJ = contact.result.strain_energy_uJ;
  contact.report.largest_strain = contact.result.largest_strain;
  contact.report.inverted_cells = contact.result.inverted_cells;
  contact.report.converged = rested;
  contact.result.status = rested ? SolveStatus::converged : SolveStatus::not_converged;
  contact.result.why_stopped =
      rested ? fmt::format("The tools rest: the relative residual is {:.1e}, the deepest penetration {:.3f} mm.",
                           contact.result.relative_residual, contact.report.penetration_mm)
             : fmt::format(
                   "At step {} of {} of the tools' way no rest was found: a tool reaches {:.2f} mm into the "
                   "surface (tolerance {:.2f}), which still moves by {:.2f} mm.",
                   station, stations, contact.report.penetration_mm, options.penetration_tolerance_mm,
                   contact.report.movement_mm);
  return contact;
}

}  // namespace glisson::mechanics
