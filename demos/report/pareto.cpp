#include "demos/report/pareto.h"

#include <algorithm>
#include <iterator>

namespace demos::report {

std::vector<Effort> front(std::vector<Effort> efforts) {
  std::stable_sort(efforts.begin(), efforts.end(), [](const Effort& a, const Effort& b) {
    return a.cost < b.cost || (a.cost == b.cost && a.error < b.error);
  });
  std::vector<Effort> kept;
  for (Effort& effort : efforts)
    if (kept.empty() || effort.error < kept.back().error) kept.push_back(std::move(effort));
  return kept;
}

std::vector<Effort> ofFamily(const std::vector<Effort>& efforts, const std::string& family) {
  std::vector<Effort> own;
  std::copy_if(efforts.begin(), efforts.end(), std::back_inserter(own),
               [&](const Effort& effort) { return effort.family == family; });
  return own;
}

std::vector<Effort> ofOthers(const std::vector<Effort>& efforts, const std::string& family) {
  std::vector<Effort> others;
  std::copy_if(efforts.begin(), efforts.end(), std::back_inserter(others),
               [&](const Effort& effort) { return effort.family != family; });
  return others;
}

std::vector<std::string> families(const std::vector<Effort>& efforts) {
  std::vector<std::string> names;
  for (const Effort& effort : efforts)
    if (std::find(names.begin(), names.end(), effort.family) == names.end())
      names.push_back(effort.family);
  return names;
}

const Effort* cheapest(const std::vector<Effort>& efforts, double error) {
  const Effort* best = nullptr;
  for (const Effort& effort : efforts)
    if (effort.error <= error && (best == nullptr || effort.cost < best->cost)) best = &effort;
  return best;
}

std::vector<Defeat> defeats(const std::vector<Effort>& efforts, const std::string& family,
                            double error) {
  std::vector<Defeat> list;
  for (const Effort& rival : front(ofOthers(efforts, family))) {
    if (!(rival.error < error)) continue;
    const Effort* own = nullptr;
    for (const Effort& effort : efforts)
      if (effort.family == family && effort.error <= rival.error &&
          (own == nullptr || effort.cost < own->cost))
        own = &effort;
    if (own == nullptr || own->costLow > rival.costHigh) list.push_back({rival, own});
  }
  return list;
}

}  // namespace demos::report
