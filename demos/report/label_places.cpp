#include "demos/report/label_places.h"

#include <algorithm>
#include <cmath>

namespace demos::report {

namespace {

bool overlap(const Label& a, const Label& b, double letter, double line) {
  const double endA = a.textX + letter * double(a.text.size()),
               endB = b.textX + letter * double(b.text.size());
  return a.textX < endB && b.textX < endA && std::abs(a.textY - b.textY) < line;
}

bool covers(const Label& label, const Dot& dot, double letter, double line) {
  return dot.x > label.textX - letter / 2 &&
         dot.x < label.textX + letter * double(label.text.size()) &&
         std::abs(dot.y - label.textY) < line / 2;
}

}  // namespace

std::vector<Label> placeLabels(std::vector<Label> labels, const std::vector<Dot>& dots,
                               double letter, double line) {
  std::stable_sort(labels.begin(), labels.end(),
                   [](const Label& a, const Label& b) { return a.y < b.y; });
  for (auto label = labels.begin(); label != labels.end(); ++label) {
    const double length = letter * double(label->text.size());
    const double right = label->x + 1.2 * letter, left = label->x - 1.2 * letter - length;
    const auto put = [&](double x, double y, bool overDots) {
      if (x < 0 || x + length > 1 || y < line / 2 || y > 1 - line / 2) return false;
      label->textX = x;
      label->textY = y;
      return std::none_of(
                 labels.begin(), label,
                 [&](const Label& other) { return overlap(*label, other, letter, line); }) &&
             (overDots || std::none_of(dots.begin(), dots.end(), [&](const Dot& dot) {
                return covers(*label, dot, letter, line);
              }));
    };
    const double wanted = std::clamp(label->y, line / 2, 1 - line / 2);
    bool placed = false;
    // Takes the nearest free place, and one over a curve rather than one far away.
    for (const bool overDots : {false, true}) {
      const double furthest = overDots ? 1 : 6 * line;
      for (double away = 0; !placed && away < furthest; away += line / 4)
        for (const double x : {right, left})
          for (const double y : {wanted + away, wanted - away})
            placed = placed || put(x, y, overDots);
    }
    if (!placed) {
      label->textX = std::clamp(right, 0.0, std::max(0.0, 1 - length));
      label->textY = wanted;
    }
  }
  return labels;
}

}  // namespace demos::report
