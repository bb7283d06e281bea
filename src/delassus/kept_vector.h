#pragma once

#include <Eigen/Core>

namespace delassus {

/// A vector that keeps its storage when its size changes: islands of all sizes follow each other in
/// one workspace, and only the largest takes memory. (Eigen's own vectors take memory at every
/// change.) To Eigen it is a map of its first entries. It can be made and assigned from any
/// expression, and copies the entries.
class KeptVector : public Eigen::Map<Eigen::VectorXd, Eigen::Aligned16> {
 public:
  using Index = Eigen::Index;
  using Map = Eigen::Map<Eigen::VectorXd, Eigen::Aligned16>;

  KeptVector() : Map(nullptr, 0) {}
  explicit KeptVector(Index size) : KeptVector() { resize(size); }
  KeptVector(const KeptVector& other) : KeptVector() { *this = other; }
  KeptVector(KeptVector&& other) noexcept : KeptVector() { swap(other); }
  template <class Expression>
  KeptVector(const Eigen::EigenBase<Expression>& expression)  // NOLINT: as Eigen's vectors do
      : KeptVector() {
    *this = expression;
  }
  ~KeptVector() = default;

  KeptVector& operator=(const KeptVector& other) {
    if (this == &other) return *this;
    resize(other.size());
    Map::operator=(other);
    return *this;
  }
  KeptVector& operator=(KeptVector&& other) noexcept {
    swap(other);
    return *this;
  }
  /// The expression may use this vector's own entries if the size stays the same.
  template <class Expression>
  KeptVector& operator=(const Eigen::EigenBase<Expression>& expression) {
    resize(expression.derived().rows());
    Map::operator=(expression.derived());
    return *this;
  }

  /// The entries are undefined afterwards. If there is no memory, the vector is empty.
  void resize(Index size) {
    if (size > storage_.size()) {
      view(0);
      storage_.resize(0);  // Eigen would keep a pointer to what it has freed
      storage_.resize(size);
    }
    view(size);
  }
  using Map::setConstant;
  using Map::setZero;
  KeptVector& setZero(Index size) { return setConstant(size, 0); }
  KeptVector& setConstant(Index size, double value) {
    resize(size);
    Map::setConstant(value);
    return *this;
  }

  void swap(KeptVector& other) noexcept {
    const Index size = this->size(), otherSize = other.size();
    storage_.swap(other.storage_);
    view(otherSize);
    other.view(size);
  }

  std::size_t bytes() const { return sizeof(double) * static_cast<std::size_t>(storage_.size()); }

 private:
  /// Eigen's way to give a map another place.
  void view(Index size) { new (static_cast<Map*>(this)) Map(storage_.data(), size); }

  Eigen::VectorXd storage_;
};

}  // namespace delassus
