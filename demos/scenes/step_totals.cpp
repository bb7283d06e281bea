#include "demos/scenes/step_totals.h"

#include "bullet_ext/saturating_sum.h"

namespace demos {

void StepTotals::add(const delassus::StepReport& report) {
  using Report = delassus::StepReport;
  ++steps;
  sum.plan.add(report.plan);
  for (const auto count :
       {&Report::islands, &Report::freeIslands, &Report::keptIslands, &Report::closedForms,
        &Report::walks, &Report::matrices, &Report::regions, &Report::factorisations,
        &Report::sweeps, &Report::patches, &Report::pushIslands, &Report::softened,
        &Report::pushSoftened, &Report::held, &Report::opposed, &Report::stiffened,
        &Report::events})
    delassus::addTo(sum.*count, report.*count);
  for (const auto seconds :
       {&Report::secondsGather, &Report::secondsPlan, &Report::secondsSolve, &Report::secondsPush,
        &Report::secondsWriteBack, &Report::secondsListener})
    sum.*seconds += report.*seconds;
}

}  // namespace demos
