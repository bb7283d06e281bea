#include "bullet_ext/impulse_span.h"

#include <algorithm>
#include <cmath>

namespace delassus::bullet {
namespace {

double productOn(const Body& body, const Vec6& p, const Vec6& q) {
  return p.head<3>().dot(body.inverseMass.cwiseProduct(q.head<3>())) +
         p.tail<3>().dot(body.inverseInertia * q.tail<3>());
}

}  // namespace

double ImpulseSpan::product(const std::vector<Body>& bodies, const Impulse& p, const Impulse& q) {
  double sum = 0;
  if (p.a >= 0) {
    if (p.a == q.a) sum += productOn(bodies[p.a], p.onA, q.onA);
    if (p.a == q.b) sum += productOn(bodies[p.a], p.onA, q.onB);
  }
  if (p.b >= 0) {
    if (p.b == q.a) sum += productOn(bodies[p.b], p.onB, q.onA);
    if (p.b == q.b) sum += productOn(bodies[p.b], p.onB, q.onB);
  }
  return sum;
}

void ImpulseSpan::truncate(int size) {
  impulses_.resize(size);
  begins_.resize(size);
  factor_.resize(size * (size + 1) / 2);
}

void ImpulseSpan::coordinates(const std::vector<Body>& bodies, const Impulse& p,
                              std::vector<double>& of) const {
  of.clear();
  int begin = size();
  const double* row = factor_.data();
  for (int k = 0; k < size(); row += ++k) {
    double left = product(bodies, p, impulses_[k]);
    for (int j = std::max(begin, begins_[k]); j < k; ++j) left -= row[j] * of[j];
    of.push_back(left / row[k]);
    if (left != 0) begin = std::min(begin, k);
  }
}

void ImpulseSpan::add(const Impulse& p, const std::vector<double>& coordinates, double left) {
  const double root = std::sqrt(left);
  Wanted wanted;
  wanted.add(p.wanted, 1 / root);
  wanted.add(wantedAlong(coordinates), -1 / root);
  const auto begin =
      std::find_if(coordinates.begin(), coordinates.end(), [](double x) { return x != 0; });
  begins_.push_back(static_cast<int>(begin - coordinates.begin()));
  impulses_.push_back(p);
  impulses_.back().wanted = wanted;
  factor_.insert(factor_.end(), coordinates.begin(), coordinates.end());
  factor_.push_back(root);
}

}  // namespace delassus::bullet
