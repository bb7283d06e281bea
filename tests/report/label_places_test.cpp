// Names at the ends of curves: beside their points, never on each other.
#include "demos/report/label_places.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace demos::report {
namespace {

constexpr double letter = 0.015, line = 0.04;

TEST(PlaceLabels, KeepsNamesApartAndInside) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> share(0, 0.8);
  for (int sample = 0; sample < 20; ++sample) {
    std::vector<Label> labels;
    std::vector<Dot> dots;
    for (int i = 0; i < 10; ++i)
      labels.push_back({"name " + std::to_string(i), "", share(random), share(random)});
    for (const Label& label : labels) dots.push_back({label.x, label.y});
    const std::vector<Label> placed = placeLabels(labels, dots, letter, line);
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const double end = placed[i].textX + letter * double(placed[i].text.size());
      EXPECT_GE(placed[i].textX, 0);
      EXPECT_LE(end, 1 + 1e-12);
      for (std::size_t j = 0; j < i; ++j) {
        const double other = placed[j].textX + letter * double(placed[j].text.size());
        const bool apart = placed[i].textX >= other || placed[j].textX >= end ||
                           std::abs(placed[i].textY - placed[j].textY) >= line - 1e-12;
        EXPECT_TRUE(apart) << placed[i].text << " on " << placed[j].text;
      }
    }
  }
}

TEST(PlaceLabels, PutsALonelyNameRightBesideItsPoint) {
  const std::vector<Label> placed =
      placeLabels({{"alone", "", 0.3, 0.5}}, {{0.3, 0.5}}, letter, line);
  EXPECT_GT(placed[0].textX, 0.3);
  EXPECT_LT(placed[0].textX, 0.3 + 2 * letter);
  EXPECT_EQ(placed[0].textY, 0.5);
}

}  // namespace
}  // namespace demos::report
