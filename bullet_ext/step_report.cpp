#include "bullet_ext/step_report.h"

#include <algorithm>

#include "bullet_ext/saturating_sum.h"

namespace delassus {

void StepReport::tell(const std::string& message) {
  // A world that is broken everywhere has as many faults as parts; the first ones are enough.
  constexpr std::size_t longest = 64;
  if (messages.size() > longest) return;
  if (std::find(messages.begin(), messages.end(), message) != messages.end()) return;
  messages.push_back(messages.size() < longest ? message : "further messages are not kept");
}

void StepReport::leaveOut(const std::string& part, const char* why) {
  addTo(leftOut, 1);
  tell(part + " left out: " + why);
}

}  // namespace delassus
