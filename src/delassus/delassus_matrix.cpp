#include "delassus/delassus_matrix.h"

#include <algorithm>
#include <utility>

#include "delassus/wide.h"

namespace delassus {
namespace {

template <int Size>
Eigen::Matrix<double, Size, Size> diagonalBlock(const DelassusMatrix::Sparse& W, int first) {
  Eigen::Matrix<double, Size, Size> block = Eigen::Matrix<double, Size, Size>::Zero();
  const int* columns = W.innerIndexPtr();
  for (int i = 0; i < Size; ++i) {
    const int end = W.outerIndexPtr()[first + i + 1];
    const int* at = std::lower_bound(columns + W.outerIndexPtr()[first + i], columns + end, first);
    for (; at != columns + end && *at < first + Size; ++at)
      block(i, *at - first) = W.valuePtr()[at - columns];
  }
  return block;
}

DELASSUS_WIDE
void addImpulses(const std::vector<ContactRows>& contacts, const VectorXd& r, VectorXd& y) {
  int at = 0;
  for (const ContactRows& c : contacts) {
    const Vec3 push = r.segment<3>(at);
    if (push[0] != 0 || push[1] != 0 || push[2] != 0) c.addImpulse(push, y);
    at += 3;
  }
}

DELASSUS_WIDE
void addImpulses(const std::vector<ScalarRow>& rows, const double* r, VectorXd& y) {
  for (const ScalarRow& c : rows) c.addImpulse(*r++, y);
}

DELASSUS_WIDE
void relativeVelocities(const std::vector<ContactRows>& contacts, const VectorXd& y, VectorXd& u) {
  int at = 0;
  for (const ContactRows& c : contacts) {
    u.segment<3>(at) = c.relativeVelocity(y);
    at += 3;
  }
}

DELASSUS_WIDE
void relativeVelocities(const std::vector<ScalarRow>& rows, const VectorXd& y, double* u) {
  for (const ScalarRow& c : rows) *u++ = c.relativeVelocity(y);
}

}  // namespace

void BodySpace::impulse(const VectorXd& r, VectorXd& y) const {
  y.setZero(6 * bodies);
  addImpulses(contacts, r, y);
  addImpulses(rows, r.data() + 3 * contacts.size(), y);
  for (const Part& p : parts)
    y.segment<6>(6 * p.body).noalias() += p.J.transpose() * r.segment(p.at, p.J.rows());
}

void BodySpace::relativeVelocity(const VectorXd& y, VectorXd& u) const {
  u.resize(compliance.size());
  relativeVelocities(contacts, y, u);
  relativeVelocities(rows, y, u.data() + 3 * contacts.size());
  for (const Part& p : parts)
    u.segment(p.at, p.J.rows()).noalias() += p.J * y.segment<6>(6 * p.body);
}

BodySpace::PartRange BodySpace::partsOf(int at) const {
  if (parts.empty()) return {nullptr, nullptr};
  const Part* first = std::lower_bound(parts.data(), parts.data() + parts.size(), at,
                                       [](const Part& p, int unknown) { return p.at < unknown; });
  const Part* last = first;
  while (last != parts.data() + parts.size() && last->at == at) ++last;
  return {first, last};
}

DelassusMatrix::DelassusMatrix(const Sparse& entries)
    : size_(static_cast<int>(entries.rows())), entries_(entries) {
  entries_.makeCompressed();
}

DelassusMatrix::DelassusMatrix(BodySpace space)
    : size_(static_cast<int>(space.compliance.size())),
      inBodySpace_(true),
      space_(std::move(space)) {}

VectorXd DelassusMatrix::operator*(const VectorXd& r) const {
  VectorXd y, u;
  multiply(r, y, u);
  return u;
}

void DelassusMatrix::multiply(const VectorXd& r, VectorXd& y, VectorXd& u) const {
  if (!inBodySpace_) {
    u.resize(size_);
    u.noalias() = entries_ * r;
    return;
  }
  bodySpace().impulse(r, y);
  bodySpace().relativeVelocity(y, u);
  u += bodySpace().compliance.cwiseProduct(r);
}

Mat3 DelassusMatrix::contactBlock(int first) const {
  Mat3 W;
  if (inBodySpace_) {
    const ContactRows& c = bodySpace().contacts[first / 3];
    W = Vec3(bodySpace().compliance.segment<3>(first)).asDiagonal();
    if (c.a >= 0) W.noalias() += c.Ja * c.Ja.transpose();
    if (c.b >= 0) W.noalias() += c.Jb * c.Jb.transpose();
    for (const BodySpace::Part& p : bodySpace().partsOf(first))
      W.noalias() += p.J * p.J.transpose();
  } else if (isFull()) {
    W = Eigen::Map<const Mat3, 0, Eigen::OuterStride<>>(entries_.valuePtr() + first * (size_ + 1),
                                                        Eigen::OuterStride<>(size_))
            .transpose();
  } else {
    W = diagonalBlock<3>(entries_, first);
  }
  return W;
}

Mat2 DelassusMatrix::pairBlock(int first) const {
  Mat2 W;
  if (!inBodySpace_) return diagonalBlock<2>(entries_, first);
  W = Vec2(bodySpace().compliance.segment<2>(first)).asDiagonal();
  const auto* rows = &bodySpace().rows[first - 3 * bodySpace().contacts.size()];
  // A block of row i adds to W(i, j) where row j has the same block.
  const auto add = [&](int i, int body, const auto& J) {
    if (body < 0) return;
    for (int j = 0; j < 2; ++j) {
      if (rows[j].a == body) W(i, j) += J.dot(rows[j].Ja);
      if (rows[j].b == body) W(i, j) += J.dot(rows[j].Jb);
      for (const BodySpace::Part& p : bodySpace().partsOf(first + j))
        if (p.body == body) W(i, j) += J.dot(p.J.row(0));
    }
  };
  for (int i = 0; i < 2; ++i) {
    add(i, rows[i].a, rows[i].Ja);
    add(i, rows[i].b, rows[i].Jb);
    for (const BodySpace::Part& p : bodySpace().partsOf(first + i)) add(i, p.body, p.J.row(0));
  }
  return W;
}

double DelassusMatrix::diagonalOfRow(int unknown) const {
  if (!inBodySpace_) return entries_.coeff(unknown, unknown);
  const ScalarRow& c = bodySpace().rows[unknown - 3 * bodySpace().contacts.size()];
  double entry = bodySpace().compliance[unknown];
  if (c.a >= 0) entry += c.Ja.squaredNorm();
  if (c.b >= 0) entry += c.Jb.squaredNorm();
  for (const BodySpace::Part& p : bodySpace().partsOf(unknown)) entry += p.J.row(0).squaredNorm();
  return entry;
}

VectorXd DelassusMatrix::diagonal() const {
  std::vector<Mat3> blocks;
  if (inBodySpace_)
    for (std::size_t i = 0; i < bodySpace().contacts.size(); ++i)
      blocks.push_back(contactBlock(static_cast<int>(3 * i)));
  VectorXd d;
  diagonal(blocks, d);
  return d;
}

void DelassusMatrix::diagonal(const std::vector<Mat3>& contactBlocks, VectorXd& d) const {
  if (!inBodySpace_) {
    d = entries_.diagonal();
    return;
  }
  d = bodySpace().compliance;
  int at = 0;
  for (const Mat3& block : contactBlocks) {
    d.segment<3>(at) = block.diagonal();
    at += 3;
  }
  const int rowsBegin = at;
  for (const ScalarRow& c : bodySpace().rows) {
    if (c.a >= 0) d[at] += c.Ja.squaredNorm();
    if (c.b >= 0) d[at] += c.Jb.squaredNorm();
    ++at;
  }
  for (const BodySpace::Part& p : bodySpace().parts)
    if (p.at >= rowsBegin) d.segment(p.at, p.J.rows()) += p.J.rowwise().squaredNorm();
}

MatrixXd DelassusMatrix::dense() const {
  if (!inBodySpace_) return MatrixXd(entries_);

  MatrixXd J = MatrixXd::Zero(size_, 6 * bodySpace().bodies);
  int at = 0;
  for (const ContactRows& c : bodySpace().contacts) {
    if (c.a >= 0) J.block<3, 6>(at, 6 * c.a) += c.Ja;
    if (c.b >= 0) J.block<3, 6>(at, 6 * c.b) += c.Jb;
    at += 3;
  }
  for (const ScalarRow& c : bodySpace().rows) {
    if (c.a >= 0) J.block<1, 6>(at, 6 * c.a) += c.Ja;
    if (c.b >= 0) J.block<1, 6>(at, 6 * c.b) += c.Jb;
    ++at;
  }
  for (const BodySpace::Part& p : bodySpace().parts)
    J.block(p.at, 6 * p.body, p.J.rows(), 6) += p.J;
  MatrixXd W = J * J.transpose();
  W.diagonal() += bodySpace().compliance;
  return W;
}

DelassusMatrix::Sparse DelassusMatrix::asEntries() const {
  if (!inBodySpace_) return entries_;

  std::vector<Eigen::Triplet<double>> jacobian;
  int row = 0;
  const auto append = [&](int body, const auto& J) {
    if (body < 0) return;
    for (int i = 0; i < J.rows(); ++i)
      for (int j = 0; j < 6; ++j) jacobian.emplace_back(row + i, 6 * body + j, J(i, j));
  };
  for (const ContactRows& c : bodySpace().contacts) {
    append(c.a, c.Ja);
    append(c.b, c.Jb);
    row += 3;
  }
  for (const ScalarRow& c : bodySpace().rows) {
    append(c.a, c.Ja);
    append(c.b, c.Jb);
    ++row;
  }
  for (const BodySpace::Part& p : bodySpace().parts) {
    row = p.at;
    append(p.body, p.J);
  }
  Sparse J(size_, 6 * bodySpace().bodies);
  J.setFromTriplets(jacobian.begin(), jacobian.end());

  std::vector<Eigen::Triplet<double>> diagonal;
  diagonal.reserve(size_);
  for (int i = 0; i < size_; ++i) diagonal.emplace_back(i, i, bodySpace().compliance[i]);
  Sparse R(size_, size_);
  R.setFromTriplets(diagonal.begin(), diagonal.end());
  return Sparse(J * Sparse(J.transpose())) + R;
}

}  // namespace delassus
