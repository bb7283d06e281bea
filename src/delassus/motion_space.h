#pragma once

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <vector>

#include "delassus/block_factor.h"
#include "delassus/bonds.h"
#include "delassus/problem.h"

namespace delassus {

/// Derivative −dr/du of the reactions in one region: 3x3 per contact, a number per row. Zero if
/// open or at a bound.
///
/// A disk answers to its own rows, whose entries in `rows` are zero, and through its radius to
/// those of its governor.
struct Stiffness {
  struct OfDisk {
    Mat2 own = Mat2::Zero();
    Mat23 governor = Mat23::Zero();  ///< its first column alone if the governor is a row

    /// Its product with the velocities u; unknowns of contacts come before `contactsEnd`.
    Vec2 times(const Disk& disk, const VectorXd& u, int contactsEnd) const {
      if (disk.governor < contactsEnd)
        return own * disk.of(u) + governor * u.segment<3>(disk.governor);
      return own * disk.of(u) + governor.col(0) * u[disk.governor];
    }
    bool operator==(const OfDisk& other) const {
      return own == other.own && governor == other.governor;
    }
  };
  std::vector<Mat3> contacts;
  VectorXd rows;
  std::vector<OfDisk> disks;

  /// For this problem, all zero.
  void reset(const Problem& problem);
  /// −dr_n/du of the governor of a disk.
  Eigen::RowVector3d ofNormal(const Disk& disk) const;

  std::size_t bytes() const { return bytesOf(contacts, rows, disks); }
  /// Whether all blocks are symmetric: nothing slides with friction.
  bool isSymmetric() const;

  bool operator==(const Stiffness& other) const {
    return contacts == other.contacts && rows.size() == other.rows.size() && rows == other.rows &&
           disks == other.disks;
  }
};

/// A motion space holds the motion y = J̃ᵀ r by the reactions of an island, with M = I, so that W =
/// J̃ J̃ᵀ + diag(compliance). Each offers its size, impulse (y = J̃ᵀ r), relativeVelocity (u = J̃
/// y), and the Newton matrix K = I + J̃ᵀ G J̃ of a region.

/// Bodies of a world: six columns per body; K is sparse, with 6x6 blocks over the body graph.
///
/// Contacts that are open in a region add nothing to K, and in rubble most are open. So a pair of
/// bodies gets blocks in the factor only when a contact of theirs is held or slides, and loses them
/// when many blocks have become idle; if at most twenty pairs touch, all keep theirs. In rubble
/// such a factor takes a fifth of the work of one with blocks for all that touch.
class BodyMotion {
 public:
  /// Keeps pointers to the problem, which must outlive the use and stay as it is.
  void setProblem(const Problem& problem);

  /// As BlockFactor.
  void setHands(Hands* hands) { factor_.setHands(hands); }

  int size() const { return 6 * space_->bodies; }
  void impulse(const VectorXd& r, VectorXd& y) const { space_->impulse(r, y); }
  void relativeVelocity(const VectorXd& y, VectorXd& u) const { space_->relativeVelocity(y, u); }
  bool factorise(const Stiffness& G);
  void solve(VectorXd& y) const { factor_.solve(y); }
  /// W = J̃ K⁻¹ J̃ᵀ of these unknowns, without compliance. False if K has no Cholesky factor.
  bool condense(const std::vector<int>& unknowns, KeptMatrix& W);
  /// The sign of det K.
  bool isDeterminantNegative() const { return factor_.isDeterminantNegative(); }
  std::size_t bytes() const {
    return factor_.bytes() + touches_.bytes() + joins_.bytes() +
           bytesOf(shares_, presses_, getsEdge_, edges_, blocks_, blocksBegin_);
  }

 private:
  /// The rows of a disk and of its governor for one body.
  struct DiskShare {
    int body;
    Mat36 disk;      ///< its last row is zero
    Mat36 governor;  ///< its first row alone if the governor is a row
    Mat36 answer;    ///< of the disk in a region
  };

  bool factorise(const Stiffness& G, bool asCholesky);
  /// Finds the bonds of contacts that are to have blocks in the factor of G: those that it couples,
  /// and others that have some, unless these are many. Whether just these have blocks. Notes which
  /// contacts press.
  bool hasRoomFor(const Stiffness& G);
  /// Analyses the factor for these bonds.
  void makeRoom();
  /// Adds contacts and rows to the column of a body. Several hands call this at once.
  void addTo(int body, const Stiffness& G);
  int addParts(const Stiffness& G, int firstEdge);
  void addDisks(const Stiffness& G, int firstEdge);
  void findShares(const Disk& disk);

  const BodySpace* space_ = nullptr;
  const std::vector<Disk>* disks_ = nullptr;
  int plainRows_ = 0;                     ///< rows of no disk
  std::vector<DiskShare> shares_;         ///< of one disk
  Bonds touches_, joins_;                 ///< of contacts; of rows of no disk
  std::vector<char> presses_;             ///< contact -> whether it adds to K
  std::vector<char> getsEdge_;            ///< bond of contacts -> whether it is to have an edge
  std::vector<BlockFactor::Edge> edges_;  ///< of contacts, then of rows, parts and disks
  int endOfRows_ = 0;                     ///< among the edges
  std::vector<BlockFactor::RowBlock> blocks_;  ///< scratch of condense
  std::vector<int> blocksBegin_;
  BlockFactor factor_;
  bool hasRoom_ = false;  ///< for any region yet: many problems need no factor
};

/// Explicit W: J̃ is its pivoted Cholesky factor, with rank W columns. It leaves out the asymmetry
/// and the slightly negative eigenvalues of measured matrices, which the walk sees through u = W r
/// + q.
class FactoredMotion {
 public:
  void setProblem(const Problem& problem);

  int size() const { return static_cast<int>(J_.cols()); }
  void impulse(const VectorXd& r, VectorXd& y) const {
    y.resize(J_.cols());
    y.noalias() = J_.transpose() * r;
  }
  void relativeVelocity(const VectorXd& y, VectorXd& u) const {
    u.resize(J_.rows());
    u.noalias() = J_ * y;
  }
  bool factorise(const Stiffness& G);
  void solve(VectorXd& y) const {
    if (symmetric_)
      cholesky_.solveInPlace(y);
    else
      y = lu_.solve(y).eval();
  }
  /// The factors are as large as K_.
  std::size_t bytes() const { return bytesOf(J_, GJ_, K_, K_, K_); }

 private:
  const std::vector<Disk>* disks_ = nullptr;
  MatrixXd J_, GJ_, K_;
  Eigen::PartialPivLU<MatrixXd> lu_;
  Eigen::LLT<MatrixXd> cholesky_;
  bool symmetric_ = false;
};

}  // namespace delassus
