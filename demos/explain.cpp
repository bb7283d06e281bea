#include "demos/explain.h"

#include "demos/table.h"

namespace demos {

std::vector<Need> needsOf(const StepTotals& totals) {
  const delassus::Plan& plan = totals.sum.plan;
  const auto need = [&](const char* key, const char* name, int sum, const std::string& there,
                        const char* none) {
    return Need{key, name, totals.aStep(sum), sum > 0 ? there : none};
  };
  const char* noPush = plan.pushContacts > 0 ? "a push problem all the same" : "no push problem";
  const char* noEvents = plan.events ? "events all the same" : "no events";
  return {
      need("frictional", "contacts with friction", plan.frictional, "tangents", "no tangents"),
      need("frictionless", "contacts without", plan.frictionless, "normals alone", ""),
      need("bouncing", "contacts with restitution", plan.bouncing, "velocities of approach",
           "no velocities of approach"),
      need("soft", "soft contacts", plan.soft, "compliance in W", "no compliance in W"),
      need("deep", "penetrations that split", plan.deep, "a push problem of these", noPush),
      need("rolling", "rolling friction", plan.rolling, "two unknowns each", "no unknowns"),
      need("spinning", "spinning friction", plan.spinning, "one unknown each", "no unknowns"),
      need("joints", "joints", plan.joints, "their rows", "no rows"),
      need("rows", "rows of joints", plan.rows, "one unknown each", ""),
      need("bounded_rows", "rows with bounds", plan.boundedRows, "states at a bound", ""),
      need("soft_rows", "soft rows", plan.softRows, "compliance in W", ""),
      need("obsolete", "constraints without rows", plan.obsolete, "turns with the rest",
           "no turns"),
      need("listeners", "listeners", plan.heard ? totals.steps : 0, "events", noEvents),
      need("islands", "islands", plan.islands,
           "each on its own, of " + std::to_string(plan.largestIsland) + " unknowns at most",
           "nothing to solve"),
      need("unknowns", "unknowns", plan.unknowns, "", ""),
  };
}

std::vector<Cost> costsOf(const StepTotals& totals) {
  const delassus::StepReport& sum = totals.sum;
  const auto count = [&](const char* name, int total) {
    return std::string(name) + " " + shortNumber(totals.aStep(total));
  };
  const auto cost = [&](const char* key, const char* name, double seconds,
                        const std::string& work) {
    return Cost{key, name, 1e6 * totals.aStep(seconds), work};
  };
  return {
      cost("gather", "gather", sum.secondsGather,
           (sum.stiffened > 0 ? count("bodies stiffened", sum.stiffened) + "; " : "") +
               count("contacts: opposed", sum.opposed) + count(", held by joints", sum.held)),
      cost("plan", "plan and check", sum.secondsPlan,
           count("islands: free", sum.freeIslands) + count(", kept", sum.keptIslands)),
      cost("solve", "solve", sum.secondsSolve,
           count("islands: with W", sum.matrices) + count(", by formula", sum.closedForms) +
               count(", walked", sum.walks) + count("; sweeps", sum.sweeps) +
               count(", patches", sum.patches) + count(", regions", sum.regions) +
               count(", factorisations", sum.factorisations) + count("; softened", sum.softened)),
      cost("push", "push", sum.secondsPush,
           count("islands", sum.pushIslands) + count(", softened", sum.pushSoftened)),
      cost("write_back", "write back", sum.secondsWriteBack, count("events", sum.events)),
      cost("listener", "listener", sum.secondsListener, ""),
  };
}

std::string explain(const StepTotals& totals) {
  Table asked({"asked for", "a step", "therefore"});
  for (const Need& need : needsOf(totals))
    asked.add({need.name, shortNumber(need.aStep, 4), need.therefore});
  Table spent({"part", "µs a step", "on"});
  for (const Cost& cost : costsOf(totals))
    spent.add({cost.name, shortNumber(cost.microseconds), cost.work});
  return asked.text() + "\n" + spent.text();
}

}  // namespace demos
