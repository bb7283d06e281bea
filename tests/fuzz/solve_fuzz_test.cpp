/// Random problems through `solve`, hard on purpose: no crash, bounded work, no wrong certificate.

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <map>

#include "delassus/island.h"
#include "delassus/problem_text.h"
#include "delassus/solver.h"
#include "tests/fuzz/fuzz.h"
#include "tests/fuzz/long_residual.h"

namespace delassus::test {
namespace {

struct Case {
  Problem problem;
  bool solvable = false;  ///< a known motion meets all demands
};

void addLaws(Case& c, int contacts, int rows, Random& random) {
  Problem& p = c.problem;
  p.friction.resize(contacts);
  const double common = uniform(random, 0, 1);
  for (double& mu : p.friction)
    mu = chance(random, 0.2) ? 0 : chance(random, 0.3) ? common : uniform(random, 0, 10);
  p.lower.resize(rows);
  p.upper.resize(rows);
  for (int i = 0; i < rows; ++i) {
    switch (pick(random, 0, 3)) {
      case 0:  // contact
        p.lower[i] = 0;
        p.upper[i] = infinity;
        break;
      case 1:  // joint
        p.lower[i] = -infinity;
        p.upper[i] = infinity;
        break;
      case 2:  // motor
        p.upper[i] = decades(random, -3, 3);
        p.lower[i] = -p.upper[i];
        break;
      case 3:  // limit
        p.lower[i] = -infinity;
        p.upper[i] = 0;
        break;
    }
  }
}

/// Velocities of some motion, plus margins that every law allows; or any velocities.
void addDemands(Case& c, const VectorXd& ofAMotion, Random& random) {
  Problem& p = c.problem;
  p.q = ofAMotion;
  c.solvable = chance(random, 0.7);
  const double size = p.q.any() ? p.q.cwiseAbs().maxCoeff() : 1;
  const int first = 3 * p.contacts();
  if (!c.solvable) {
    p.q += size * decades(random, -12, 0) * normalVector(p.size(), random);
    return;
  }
  if (chance(random, 0.5)) return;  // on the edge of what is allowed
  for (int i = 0; i < p.contacts(); ++i) p.q[3 * i] += size * uniform(random, 0, 1e-3);
  for (int i = 0; i < p.rows(); ++i) {
    const double margin = size * uniform(random, 0, 1e-3);
    if (p.upper[i] == infinity && p.lower[i] == 0) p.q[first + i] += margin;
    if (p.lower[i] == -infinity && p.upper[i] == 0) p.q[first + i] -= margin;
  }
}

/// W = J Jᵀ of any rank, with a spread of singular values or of masses; ties are deliberate.
Case explicitCase(Random& random) {
  Case c;
  const int n = pick(random, 1, 60);
  const int contacts = chance(random, 0.3) ? 0 : pick(random, 0, n / 3);
  const int freedoms = chance(random, 0.3) ? n : pick(random, 1, n);
  MatrixXd J = normalMatrix(n, freedoms, random);
  if (chance(random, 0.3)) J = J.array().round().matrix();  // ties, zeros, empty rows
  for (int i = 1; i < n; ++i)
    if (chance(random, 0.1))
      J.row(i) = J.row(pick(random, 0, i - 1)) * (chance(random, 0.5) ? 1 : -1);
  const double spread = chance(random, 0.5) ? uniform(random, 0, 7) : 0;  // of W: twice as much
  const double mass = chance(random, 0.5) ? uniform(random, 0, 9) : 0;
  for (int k = 0; k < freedoms; ++k) J.col(k) *= decades(random, -spread, 0);
  for (int i = 0; i < n; ++i) J.row(i) *= decades(random, -mass / 2, 0);
  J *= decades(random, -6, 6);
  MatrixXd W = J * J.transpose();
  c.problem.W =
      DelassusMatrix(DelassusMatrix::Sparse(MatrixXd((W + W.transpose()) / 2).sparseView()));
  addLaws(c, contacts, n - 3 * contacts, random);
  VectorXd v = normalVector(freedoms, random);
  if (chance(random, 0.2)) v = v.array().round().matrix();
  addDemands(c, J * v, random);
  // Beyond this, rounding W to double turns the demands of a motion into demands that no motion
  // meets.
  c.solvable &= spread < 3;
  return c;
}

Vec3 direction(Random& random) {
  if (chance(random, 0.3)) return Vec3::Unit(pick(random, 0, 2)) * (chance(random, 0.5) ? 1 : -1);
  return normalVector(3, random).normalized();
}

/// Bodies with masses over nine decades, with contacts and rows, assembled as those of worlds are.
Case bodyCase(Random& random) {
  Case c;
  const int count = pick(random, 1, 10);
  const double ratio = chance(random, 0.5) ? uniform(random, 0, 9) : 0;
  std::vector<Body> bodies(count);
  for (Body& body : bodies) {
    const double mass = decades(random, 0, ratio);
    body.inverseMass.setConstant(1 / mass);
    const Vec3 stretch(decades(random, 0, 1), decades(random, 0, 1), 1);
    body.inverseInertia = Mat3(stretch.asDiagonal()) * (6 / mass);
    if (chance(random, 0.1)) body.inverseMass[2] = 0;
    if (chance(random, 0.1)) body.inverseInertia.setZero();
    body.velocity = normalVector(6, random);
    if (chance(random, 0.3)) body.velocity = Vec6::Unit(1) * -0.1;
    // Motion along a locked axis cannot be stopped: then standing still would be no answer.
    body.velocity.head<3>() = body.inverseMass.array().sign() * body.velocity.head<3>().array();
    if (!body.inverseInertia.any()) body.velocity.tail<3>().setZero();
  }
  std::vector<Contact> contacts;
  std::vector<Row> rows;
  const int parts = pick(random, 1, 20);
  for (int k = 0; k < parts; ++k) {
    const int a = pick(random, 0, count - 1), b = pick(random, -1, a - 1);
    if (chance(random, 0.7)) {
      Contact contact;
      contact.a = a;
      contact.b = b;
      contact.armA = normalVector(3, random);
      contact.armB = normalVector(3, random);
      if (chance(random, 0.3)) contact.armA = contact.armA.array().round().matrix() / 2;
      const Vec3 n = direction(random), other = Vec3::Unit((pick(random, 0, 2)));
      const Vec3 t =
          n.cross(std::abs(n.dot(other)) < 0.9 ? other : Vec3(other[2], other[0], other[1]));
      contact.frame << n, t.normalized(), n.cross(t.normalized());
      contact.friction = chance(random, 0.2)   ? 0
                         : chance(random, 0.3) ? 0.5
                                               : uniform(random, 0, 10);
      if (!contacts.empty() && chance(random, 0.2))
        contact = contacts[pick(random, 0, int(contacts.size()) - 1)];
      contacts.push_back(contact);
    } else {
      Row row;
      row.a = a;
      row.b = b;
      row.jacobianA << direction(random).transpose(), normalVector(3, random).transpose();
      row.jacobianB = -row.jacobianA;
      if (chance(random, 0.3)) row.lower = 0;
      if (chance(random, 0.2)) row.upper = 1;
      if (chance(random, 0.1)) row.compliance = decades(random, -9, 3);
      if (!rows.empty() && chance(random, 0.2)) row = rows[pick(random, 0, int(rows.size()) - 1)];
      rows.push_back(row);
    }
  }
  const std::vector<Island> islands = splitIslands(bodies, contacts, rows);
  if (islands.empty()) return explicitCase(random);
  const Island& island = islands[pick(random, 0, int(islands.size()) - 1)];
  c.problem = assemble(bodies, contacts, rows, island);
  // Standing still meets contacts and rows without targets.
  c.solvable = true;
  return c;
}

void writeCase(const Problem& problem, const std::string& path) {
  Problem text = problem;
  text.name = "fuzz";
  if (text.contacts() > 0 && text.rows() > 0) return;  // no format holds both
  std::ofstream out(path);
  writeProblem(out, text);
}

/// The fault in the answer to a problem, or null. Asks for what must hold whatever the problem.
const char* faultOf(const Case& c, const Solution& s, const Options& options) {
  const Problem& p = c.problem;
  if (s.r.size() != p.size() || !s.r.allFinite() || !s.u.allFinite()) return "not finite";
  if (s.status == Status::NonFinite) return "called non-finite";
  // Rows are pivoted first, then walked: at most twice the budget.
  if (s.regions > 2 * options.newtonBudget + 64) return "more regions than the budget";
  if (s.sweeps > 2 * options.sweepBudget) return "more sweeps than the budget";

  const LongResidual truth = longResidual(p, s.r);
  if (truth.outside > (s.status == Status::Solved ? 1e-14 : 1e-10))
    return "reactions outside cones or bounds";
  if (std::abs(Long(s.residual) - truth.max) > truth.roundOff) return "the residual is another";
  if (s.status == Status::Solved) {
    const double tolerance = std::max(options.tolerance * p.q.cwiseAbs().maxCoeff(), p.roundOff);
    if (truth.max > tolerance + 2 * truth.roundOff) return "called solved";
  } else if (s.blamed.empty()) {
    return "nobody is named";
  }
  // Standing still meets all demands.
  if (c.solvable && s.status == Status::Incompatible) return "called incompatible";
  return nullptr;
}

struct Tally {
  std::map<std::string, int> shares;
  int mostRegions = 0, mostSweeps = 0;
};

void ask(const char* name, Case (*make)(Random&), int round, Tally& tally) {
  const Options options;
  Random random = fuzzRandom(round);
  const Case c = make(random);
  Solver solver(options);
  const Solution s = solver.solve(c.problem);
  ++tally.shares[(c.solvable ? "solvable: " : "anything: ") + toString(s.status)];
  tally.mostRegions = std::max(tally.mostRegions, s.regions);
  tally.mostSweeps = std::max(tally.mostSweeps, s.sweeps);
  if (const char* fault = faultOf(c, s, options)) {
    ++tally.shares[fault];
    writeCase(c.problem, std::string("fuzz_") + name + "_" + std::to_string(round));
    ADD_FAILURE() << name << " round " << round << ": " << fault << "; " << c.problem.contacts()
                  << " contacts, " << c.problem.rows() << " rows, " << toString(s.status)
                  << ", residual " << s.residual << " for demands up to "
                  << c.problem.q.cwiseAbs().maxCoeff();
  }
}

void fuzz(const char* name, Case (*make)(Random&), int usualRounds) {
  Tally tally;
  const int rounds = fuzzRounds(usualRounds);
  for (int round = 0; round < rounds; ++round) ask(name, make, round, tally);
  if (!isLongFuzz()) return;
  for (const auto& [what, count] : tally.shares)
    std::printf("%s: %s %d (%.4g %%)\n", name, what.c_str(), count, 100.0 * count / rounds);
  std::printf("%s: most regions %d, most sweeps %d\n", name, tally.mostRegions, tally.mostSweeps);
}

TEST(SolveFuzz, ExplicitMatrices) { fuzz("entries", explicitCase, 300); }

/// W is nearly singular: reactions grow long, as they do against demands that no motion meets. Some
/// such problems were once called incompatible, and one ended as NaN.
TEST(SolveFuzz, LongReactionsAreNotTakenForIncompatibleDemands) {
  Tally tally;
  for (const int round : {14747, 43374, 49458, 50724, 72024})
    ask("entries", explicitCase, round, tally);
}

TEST(SolveFuzz, BodiesOfAllMasses) { fuzz("bodies", bodyCase, 3000); }

}  // namespace
}  // namespace delassus::test
