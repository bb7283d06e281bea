#include "delassus/contact_form.h"

#include <Eigen/QR>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "delassus/disjoint_sets.h"

namespace delassus {
namespace {

using Sparse = DelassusMatrix::Sparse;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// An unknown r in the contact form: r = offset + sign x, with x the unknown at `place`.
struct Image {
  int place = -1;  ///< −1: it is eliminated
  double sign = 1, offset = 0;
};

/// Gives each unknown its place in the contact form, and collects μ of the form's contacts.
std::vector<Image> imagesOf(const Problem& problem, std::vector<double>& friction) {
  const int contactsEnd = 3 * problem.contacts();
  std::vector<Image> images(problem.size());
  for (int i = 0; i < contactsEnd; ++i) images[i].place = i;
  for (int i = 0; i < problem.contacts(); ++i) friction.push_back(problem.friction[i]);
  for (int k = 0; k < problem.rows(); ++k) {
    const double lower = problem.lower[k], upper = problem.upper[k];
    if (std::isinf(lower) && std::isinf(upper)) continue;
    const int first = 3 * static_cast<int>(friction.size());
    Image& image = images[contactsEnd + k];
    if (std::isinf(upper))
      image = {first, 1, lower};
    else if (std::isinf(lower))
      image = {first, -1, upper};
    else
      image = {first + 1, 1, lower + (upper - lower) / 2};
    friction.push_back(std::isinf(lower) || std::isinf(upper) ? 0 : (upper - lower) / 2);
  }
  return images;
}

/// Substitutes the reactions of some equations in W and q of the unknowns that feel them: adds
/// −W_ce W_ee⁺ W_ec to `changes`.
void eliminate(const Sparse& W, const std::vector<Image>& images, const std::vector<int>& equations,
               VectorXd& q, Triplets& changes) {
  std::vector<int> others, column(images.size(), -1);
  for (const int e : equations)
    for (Sparse::InnerIterator w(W, e); w; ++w) {
      const auto i = static_cast<int>(w.col());
      if (images[i].place < 0 || column[i] >= 0 || w.value() == 0) continue;
      column[i] = static_cast<int>(others.size());
      others.push_back(i);
    }
  const auto count = static_cast<Eigen::Index>(equations.size());
  for (Eigen::Index k = 0; k < count; ++k) column[equations[k]] = static_cast<int>(k);

  const auto numberOfOthers = static_cast<Eigen::Index>(others.size());
  MatrixXd own = MatrixXd::Zero(count, count), felt = MatrixXd::Zero(count, numberOfOthers + 1);
  for (Eigen::Index k = 0; k < count; ++k) {
    for (Sparse::InnerIterator w(W, equations[k]); w; ++w)
      if (w.value() != 0) (images[w.col()].place < 0 ? own : felt)(k, column[w.col()]) = w.value();
    felt(k, numberOfOthers) = q[equations[k]];
  }
  // Rows of joints are in m/s and in rad/s: dependence is judged in energy.
  const VectorXd scale =
      own.diagonal().unaryExpr([](double w) { return w > 0 ? 1 / std::sqrt(w) : 1; });
  own = scale.asDiagonal() * own * scale.asDiagonal();
  felt = scale.asDiagonal() * felt;
  const MatrixXd answer = own.completeOrthogonalDecomposition().solve(felt);
  constexpr double met = 1e-9;
  const VectorXd demand = felt.rightCols<1>();
  if ((own * answer.rightCols<1>() - demand).norm() > met * demand.norm())
    throw std::invalid_argument("no reactions meet the equations of its joints");

  const MatrixXd change = felt.leftCols(numberOfOthers).transpose() * answer;
  for (Eigen::Index i = 0; i < numberOfOthers; ++i) {
    q[others[i]] -= change(i, numberOfOthers);
    for (Eigen::Index j = 0; j < numberOfOthers; ++j)
      changes.emplace_back(others[i], others[j], -change(i, j));
  }
}

/// Eliminates all equations, in groups that feel each other.
void eliminateEquations(Sparse& W, const std::vector<Image>& images, VectorXd& q) {
  const auto size = static_cast<int>(images.size());
  DisjointSets coupled(size);
  for (int i = 0; i < size; ++i)
    for (Sparse::InnerIterator w(W, i); w && images[i].place < 0; ++w)
      if (images[w.col()].place < 0 && w.value() != 0) coupled.join(i, static_cast<int>(w.col()));
  std::vector<std::vector<int>> sets(size);
  for (int i = 0; i < size; ++i)
    if (images[i].place < 0) sets[coupled.root(i)].push_back(i);
  Triplets changes;
  for (const std::vector<int>& set : sets)
    if (!set.empty()) eliminate(W, images, set, q, changes);
  Sparse sum(size, size);
  sum.setFromTriplets(changes.begin(), changes.end());
  W += sum;
}

bool isSymmetric(const Sparse& W) {
  constexpr double rounding = 1e-9;
  const VectorXd scale = W.diagonal().cwiseAbs().cwiseSqrt();
  const Sparse mirrored = W.transpose(), difference = W - mirrored;
  for (int i = 0; i < difference.rows(); ++i)
    for (Sparse::InnerIterator w(difference, i); w; ++w)
      if (!(std::abs(w.value()) <= rounding * scale[i] * scale[w.col()])) return false;
  return true;
}

}  // namespace

Problem contactForm(const Problem& problem) {
  if (!problem.disks.empty())
    throw std::invalid_argument("rolling and spinning friction have no form in contacts alone");
  if (!problem.W.inBodySpace() && !isSymmetric(problem.W.entries()))
    throw std::invalid_argument("its W is not symmetric");
  std::vector<double> friction;
  const std::vector<Image> images = imagesOf(problem, friction);
  VectorXd offset(problem.size());
  for (int i = 0; i < problem.size(); ++i) offset[i] = images[i].offset;
  Sparse W = problem.W.asEntries();
  VectorXd q = problem.q + W * offset;
  eliminateEquations(W, images, q);

  Problem form;
  form.name = problem.name;
  form.roundOff = problem.roundOff;
  form.leastDemand = problem.leastDemand;
  form.friction = Eigen::Map<const Eigen::VectorXd>(friction.data(),
                                                    static_cast<Eigen::Index>(friction.size()));
  form.q.setZero(3 * form.contacts());
  Triplets entries;
  for (int i = 0; i < problem.size(); ++i) {
    const Image& image = images[i];
    if (image.place < 0) continue;
    form.q[image.place] = image.sign * q[i];
    double own = 0;
    for (Sparse::InnerIterator w(W, i); w; ++w) {
      const Image& other = images[w.col()];
      if (other.place < 0) continue;
      entries.emplace_back(image.place, other.place, image.sign * other.sign * w.value());
      if (w.col() == i) own = w.value();
    }
    if (i < 3 * problem.contacts()) continue;
    const int first = image.place - image.place % 3;
    const bool pressed = image.place != first;
    if (pressed) form.q[first] = -1;
    entries.emplace_back(first + 2, first + 2, own);
    entries.emplace_back(pressed ? first : first + 1, pressed ? first : first + 1,
                         pressed ? 1 : own);
  }
  Sparse matrix(form.size(), form.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  form.W = DelassusMatrix(matrix);
  return form;
}

}  // namespace delassus
