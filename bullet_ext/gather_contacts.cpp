#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "BulletCollision/BroadphaseCollision/btDispatcher.h"
#include "BulletCollision/NarrowPhaseCollision/btPersistentManifold.h"
#include "BulletDynamics/ConstraintSolver/btContactSolverInfo.h"
#include "BulletDynamics/Dynamics/btRigidBody.h"
#include "bullet_ext/contact_frame.h"
#include "bullet_ext/convert.h"
#include "bullet_ext/first_room.h"
#include "bullet_ext/gather.h"
#include "bullet_ext/names.h"
#include "bullet_ext/prefetch.h"
#include "bullet_ext/response.h"
#include "bullet_ext/saturating_sum.h"
#include "bullet_ext/softness.h"

namespace delassus::bullet {
namespace {

// Users write "infinite" friction. In this cone a contact slides only if it leaves within a
// thousandth of a radian of the surface; wider cones cost digits.
constexpr double largestFriction = 1e3;

/// How hard a contact is: the coefficients that both of Bullet's descriptions come down to.
struct Softness {
  double erp, cfm;
  bool own;  ///< the point brings a compliance of its own
};

Softness softnessOf(const btManifoldPoint& point, const btContactSolverInfo& info) {
  Softness soft{info.m_erp2, info.m_globalCfm, false};
  const int flags = point.m_contactPointFlags;
  if (flags & (BT_CONTACT_FLAG_HAS_CONTACT_CFM | BT_CONTACT_FLAG_HAS_CONTACT_ERP)) {
    if (flags & BT_CONTACT_FLAG_HAS_CONTACT_CFM) {
      soft.cfm = point.m_contactCFM;
      soft.own = soft.cfm > 0;
    }
    if (flags & BT_CONTACT_FLAG_HAS_CONTACT_ERP) soft.erp = point.m_contactERP;
  } else if (flags & BT_CONTACT_FLAG_CONTACT_STIFFNESS_DAMPING) {
    // An implicit spring and damper: r/h = −k (d + h u) − c u.
    const double spring = static_cast<double>(info.m_timeStep) * point.m_combinedContactStiffness1;
    const double both = std::max<double>(spring + point.m_combinedContactDamping1, SIMD_EPSILON);
    soft = {spring / both, 1 / both, true};
  }
  return soft;
}

/// One manifold and its bodies.
struct Pair {
  btPersistentManifold& manifold;
  int a, b;
  Vec3 centreA, centreB;
  Vec6 beforeA, beforeB;  ///< velocities before forces; with links: after
  bool stands;            ///< these are zero
  double rounding;        ///< of a distance of its points, m
  double negligible;      ///< a distance of hard bodies below this is none, m
  bool joined;            ///< a joint holds the two bodies together
  ContactFrames frames;
};

/// The rounding of a distance between points that lie where this one does, m; 0 if its place is not
/// finite or absurd.
double roundingAt(const btManifoldPoint& point) {
  constexpr double roundings = 4;
  const double places = toCore(point.getPositionWorldOnA()).cwiseAbs().maxCoeff() +
                        toCore(point.getPositionWorldOnB()).cwiseAbs().maxCoeff();
  return places <= largestNumber ? roundings * SIMD_EPSILON * places : 0;
}

/// A share of the distance at which Bullet drops a point; for boxes of a metre, 0.3 microns. A step
/// takes back only a part of each overlap. If there were no end to this, piles would creep for
/// ever, slide as they creep, and take a search in each step, however slowly they do.
constexpr double negligibleShare = 2e-5;

Pair pairOf(const Group& group, btPersistentManifold& manifold, int a, int b,
            const btContactSolverInfo& info) {
  const btCollisionObject &objectA = *manifold.getBody0(), &objectB = *manifold.getBody1();
  // Bullet has added forces to the velocities of links already; beside these it takes rigid bodies
  // with forces, too.
  const bool withForces = group.isLimb(a) || group.isLimb(b);
  const auto before = [&](int body) -> Vec6 {
    if (body < 0) return Vec6::Zero();
    return withForces ? group.bodies[body].velocity : group.bodySources[body].before;
  };
  const Vec6 beforeA = before(a), beforeB = before(b);
  const double rounding = roundingAt(manifold.getContactPoint(0));
  return {manifold,
          a,
          b,
          toCore(objectA.getWorldTransform().getOrigin()),
          toCore(objectB.getWorldTransform().getOrigin()),
          beforeA,
          beforeB,
          beforeA.isZero(0) && beforeB.isZero(0),
          rounding,
          std::max<double>(rounding, negligibleShare * manifold.getContactBreakingThreshold()),
          group.joined.areJoined(objectA, objectB),
          ContactFrames(anisotropyOf(objectA, objectB), info)};
}

/// The velocity of the first body's point relative to the second's, from the velocities of the
/// pair.
Vec3 slipBefore(const Pair& pair, const Contact& c) {
  return pair.beforeA.head<3>() + pair.beforeA.tail<3>().cross(c.armA) - pair.beforeB.head<3>() -
         pair.beforeB.tail<3>().cross(c.armB);
}

/// The velocity at which the bodies leave each other after a bounce.
double bounceOf(const Pair& pair, const btManifoldPoint& point, const btContactSolverInfo& info,
                const Contact& c) {
  if (point.m_combinedRestitution == 0) return 0;
  const double a = c.frame.col(0).dot(slipBefore(pair, c));
  if (std::abs(a) < info.m_restitutionVelocityThreshold) return 0;
  return std::max(0.0, -a * point.m_combinedRestitution);
}

double tangentialResponse(const Group& group, const Contact& c, int column) {
  const Vec3 t = c.frame.col(column);
  return responseOf(group, c.a, c.armA, t) + responseOf(group, c.b, c.armB, t);
}

/// The distance of the bodies, m. It is 0 if it is within the rounding of their places, or
/// negligible between hard bodies, and if they slip by no more than that in a step. (Soft bodies
/// would sink as far each time before they recover.)
double distanceOf(const Pair& pair, const btManifoldPoint& point, const btContactSolverInfo& info,
                  bool isSoft, const Contact& c) {
  const double d = static_cast<double>(point.getDistance()) + info.m_linearSlop;
  const double least = isSoft ? pair.rounding : pair.negligible;
  const auto moves = [&] {
    return slipBefore(pair, c).norm() * static_cast<double>(info.m_timeStep) > least;
  };
  const bool touches = std::abs(d) <= least && (pair.stands || !moves());
  return touches ? 0 : d;
}

/// Fills the contact and returns its push velocity; the contact's numbers may be NaN.
double fillContact(const Group& group, Pair& pair, const btManifoldPoint& point,
                   const btContactSolverInfo& info, Contact& c) {
  const ContactFrame& frame = pair.frames.of(point);
  c.a = pair.a;
  c.b = pair.b;
  c.armA = toCore(point.getPositionWorldOnA()) - pair.centreA;
  c.armB = toCore(point.getPositionWorldOnB()) - pair.centreB;
  c.frame = frame.axes;
  c.friction = std::clamp<double>(point.m_combinedFriction, 0, largestFriction);

  const double h = info.m_timeStep;
  const Softness soft = softnessOf(point, info);
  const double d = distanceOf(pair, point, info, soft.cfm > 0, c);
  // The push moves only rigid bodies.
  const bool split = info.m_splitImpulse && d <= info.m_splitImpulsePenetrationThreshold &&
                     !soft.own && !pair.joined && !group.isLimb(c.a) && !group.isLimb(c.b);
  const double recovery = d < 0 ? -d * soft.erp / h : 0;
  c.target = {bounceOf(pair, point, info, c) - std::max(d, 0.0) / h + (split ? 0 : recovery),
              frame.motion1, frame.motion2};
  c.compliance = soft.cfm < 0 ? 0 : soft.cfm / h;
  // By the lesser response: a heavy body does not sink into a light one.
  if (pair.joined) c.compliance += joinedSoftness * lesserResponse(group, c);
  if (group.isLimb(c.a) || group.isLimb(c.b))  // rigid bodies use the point's own
    c.slipCompliance = std::max<double>(info.m_frictionCFM, 0) / h;
  if (frame.softness > 0)
    c.slipCompliance +=
        0.5 * frame.softness * (tangentialResponse(group, c, 1) + tangentialResponse(group, c, 2));
  return split ? recovery : 0;
}

// Float normals are unit to 1e-6; beyond this a normal is a mistake, not rounding.
constexpr double unitTolerance = 1e-3;

/// Bullet keeps positions and distance consistent: (x_A − x_B)·n = d. If the signs are opposite, n
/// points from a to b.
bool isInverted(const btManifoldPoint& point) {
  const Vec3 a = toCore(point.getPositionWorldOnA()), b = toCore(point.getPositionWorldOnB());
  const double gap = (a - b).dot(toCore(point.m_normalWorldOnB)), d = point.getDistance();
  const double noise = 1e3 * SIMD_EPSILON * (a.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff());
  return std::abs(d) > noise && std::abs(gap + d) < unitTolerance * std::abs(d);
}

/// The fault of a contact point that is not sound.
const char* faultOfPoint(const btManifoldPoint& point, const Contact& c, double push) {
  const Vec3 normal = toCore(point.m_normalWorldOnB);
  if (!normal.allFinite()) return "its normal is not finite";
  if (std::abs(normal.squaredNorm() - 1) > unitTolerance) return "its normal is not a unit vector";
  if (isInverted(point)) return "its normal points into the other body";
  if (!std::isfinite(point.getDistance())) return "its distance is not finite";
  if (!c.armA.allFinite() || !c.armB.allFinite()) return "its position is not finite";
  if (!std::isfinite(c.friction)) return "its friction is not finite";
  if (!c.frame.allFinite()) return "its friction directions are not finite";
  if (!std::isfinite(point.m_combinedRestitution)) return "its restitution is not finite";
  if (!c.target.tail<2>().allFinite()) return "its wanted sliding velocity is not finite";
  if (!std::isfinite(c.target[0]) || !std::isfinite(c.compliance) ||
      !std::isfinite(c.slipCompliance) || !std::isfinite(push))
    return "its softness is not finite";
  return "its numbers are too large";
}

/// Whether a contact may be used.
bool sound(const btManifoldPoint& point, const Contact& c, double push) {
  const double lengthError = static_cast<double>(point.m_normalWorldOnB.length2()) - 1;
  const double size = c.armA.cwiseAbs().sum() + c.armB.cwiseAbs().sum() + c.frame.cwiseAbs().sum() +
                      c.target.cwiseAbs().sum() + c.friction + c.compliance + c.slipCompliance +
                      push + std::abs(point.getDistance()) + std::abs(point.m_combinedRestitution);
  return std::abs(lengthError) <= unitTolerance && size <= largestNumber && !isInverted(point);
}

Vec3 guessOf(const btManifoldPoint& point, const btContactSolverInfo& info) {
  if (!warmStarts(info)) return Vec3::Zero();
  const Vec3 last{point.m_appliedImpulse, point.m_appliedImpulseLateral1,
                  point.m_appliedImpulseLateral2};
  return std::isfinite(last.sum()) ? last : Vec3::Zero();
}

/// Asks the dispatcher, as a world does when it splits groups itself; an unsplit group comes
/// unfiltered.
bool responds(btDispatcher* dispatcher, const btCollisionObject& a, const btCollisionObject& b) {
  return dispatcher ? dispatcher->needsResponse(&a, &b)
                    : a.hasContactResponse() && b.hasContactResponse();
}

/// Bodies may be told not to collide while they touch, as a joint does with
/// disableCollisionsBetweenLinkedBodies. Bullet then neither moves nor removes their points, which
/// stay where they were.
bool mayCollide(const btCollisionObject& a, const btCollisionObject& b) {
  return a.checkCollideWith(&b) && b.checkCollideWith(&a);
}

/// Whether a push along the normal may move nothing: the body is locked along some axis, or a link.
bool isLocked(const Group& group, int body) {
  return !group.movable(body) || group.isLimb(body) ||
         group.bodies[body].inverseMass.minCoeff() == 0;
}

/// Whether the contact's push cannot move this body.
bool isDeaf(const Group& group, int index, const Vec3& arm, const Vec3& n) {
  if (!group.movable(index)) return true;
  if (const Articulation::Limb* limb = group.articulation.limbOf(index))
    return responseOf(group, index, arm, n) <=
           inVain * (limb->motion.topRows<3>().squaredNorm() +
                     arm.squaredNorm() * limb->motion.bottomRows<3>().squaredNorm());
  const Body& body = group.bodies[index];
  const Vec3 turn = arm.cross(n);
  return n.dot(body.inverseMass.cwiseProduct(n)) + turn.dot(body.inverseInertia * turn) <=
         inVain * group.bodySources[index].rigid->getInvMass();
}

/// Whether the contact's push cannot move its bodies apart, since they are limbs of one tree that
/// no joint lets part along the normal.
bool movesAsOne(const Group& group, const Contact& c, const Vec3& n) {
  const Articulation::Limb *a = group.articulation.limbOf(c.a), *b = group.articulation.limbOf(c.b);
  if (!a || !b || a->tree != b->tree) return false;
  const Vec3 turnA = c.armA.cross(n), turnB = c.armB.cross(n);
  double apart = 0, each = 0;
  for (Eigen::Index k = 0; k < a->motion.cols(); ++k) {
    const double ofA = motionAlong(*a, k, n, turnA), ofB = motionAlong(*b, k, n, turnB);
    apart += (ofA - ofB) * (ofA - ofB);
    each += ofA * ofA + ofB * ofB;
  }
  return apart <= inVain * each;
}

/// Whether the contact's push moves nothing: in a plane world the contact of two bodies one behind
/// the other, or that of a link beside its rail, or of two links with a fixed joint between them.
bool pushesNothing(const Group& group, const Contact& c) {
  const Vec3 n = c.frame.col(0);
  return (isDeaf(group, c.a, c.armA, n) && isDeaf(group, c.b, c.armB, n)) ||
         movesAsOne(group, c, n);
}

/// A body that may turn but keeps its place does not collide with standing bodies, as in Bullet.
bool canBePushed(const Group& group, int body) {
  return group.movable(body) && (group.isLimb(body) || group.bodies[body].inverseMass.any());
}

void gatherManifold(Group& group, Pair pair, const btContactSolverInfo& info, StepReport& report) {
  btPersistentManifold& manifold = pair.manifold;
  const bool brokenBody = pair.a == leftOut || pair.b == leftOut;
  const bool takesPart = !brokenBody && mayCollide(*manifold.getBody0(), *manifold.getBody1()) &&
                         (canBePushed(group, pair.a) || canBePushed(group, pair.b));
  const bool mayPushNothing = takesPart && isLocked(group, pair.a) && isLocked(group, pair.b);
  for (int i = 0; i < manifold.getNumContacts(); ++i) {
    const btManifoldPoint& point = manifold.getContactPoint(i);
    const bool tooFar = point.getDistance() > manifold.getContactProcessingThreshold();
    if (!takesPart || tooFar) {
      group.idle.push_back({&manifold, i, brokenBody ? Trouble::LeftOut : Trouble::None});
      continue;
    }
    Contact& contact = group.contacts.emplace_back();
    const double push = fillContact(group, pair, point, info, contact);
    if (!sound(point, contact, push)) {
      const PointSource source{&manifold, i, Trouble::LeftOut};
      report.leaveOut(nameOf(source), faultOfPoint(point, contact, push));
      group.contacts.pop_back();
      group.idle.push_back(source);
      continue;
    }
    if (mayPushNothing && pushesNothing(group, contact)) {
      group.contacts.pop_back();
      group.idle.push_back({&manifold, i});
      continue;
    }
    const bool fresh = point.getLifeTime() <= 1;
    group.contactSources.push_back(
        {&manifold, i, Trouble::None, fresh, manifold.getBody0(), manifold.getBody1()});
    group.pushes.push_back(push);
    group.bouncing += point.m_combinedRestitution != 0;
    group.turning += point.m_combinedRollingFriction > 0 || point.m_combinedSpinningFriction > 0;
    group.guess.push_back(guessOf(point, info));
  }
}

/// Prefetches the end of a manifold, where its bodies and the number of its points are.
void prefetchEnd(const btPersistentManifold& manifold) {
  constexpr std::ptrdiff_t bytes = 64;
  const auto* end = reinterpret_cast<const char*>(&manifold + 1);
  prefetch(end - bytes, end);
}

void prefetchPoints(const btPersistentManifold& manifold) {
  const int points = manifold.getNumContacts();
  if (points > 0) prefetch(&manifold.getContactPoint(0), &manifold.getContactPoint(points - 1) + 1);
}

std::size_t pointsOf(const GroupInput& input) {
  std::size_t points = 0;
  for (int i = 0; i < input.manifoldCount; ++i) points += input.manifolds[i]->getNumContacts();
  return points;
}

}  // namespace

bool warmStarts(const btContactSolverInfo& info) {
  return (info.m_solverMode & SOLVER_USE_WARMSTARTING) && info.m_warmstartingFactor > 0;
}

void gatherContacts(Group& group, const GroupInput& input, StepReport& report) {
  // Most manifolds use only the first of their points: these are prefetched once their number has
  // come.
  constexpr int ahead = 6, farAhead = 16;
  const btContactSolverInfo& info = *input.info;
  const int count = input.manifoldCount;
  makeFirstRoom([&] { return pointsOf(input); }, group.contacts, group.contactSources, group.pushes,
                group.guess);
  for (int i = 0; i < count; ++i) {
    btPersistentManifold& manifold = *input.manifolds[i];
    if (i + farAhead < count) prefetchEnd(*input.manifolds[i + farAhead]);
    if (i + ahead < count) prefetchPoints(*input.manifolds[i + ahead]);
    if (manifold.getNumContacts() == 0) continue;
    // Manifolds hold their bodies as const; as in all of Bullet's solvers, this is cast away.
    auto& a = const_cast<btCollisionObject&>(*manifold.getBody0());
    auto& b = const_cast<btCollisionObject&>(*manifold.getBody1());
    if (!responds(input.dispatcher, a, b)) continue;
    const int indexA = bodyIndex(group, a, info, report);
    const int indexB = bodyIndex(group, b, info, report);
    const auto first = static_cast<int>(group.contacts.size());
    gatherManifold(group, pairOf(group, manifold, indexA, indexB, info), info, report);
    group.opposed.note(group, a, indexA, b, indexB, first);
  }
  addTo(report.opposed, group.opposed.soften(group));
}

}  // namespace delassus::bullet
