#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "delassus/types.h"
#include "demos/scenes/world.h"

/// The simulations behind the figures. Every dot of the atlas is a Bullet world that was stepped.
namespace demos::atlas {

constexpr double timeStep = 1.0 / 60;  ///< s

/// The fate of a contact in one step, by the velocity that the solver left it with.
enum class Fate : unsigned char { Kept, Released, Sunk };

/// Opening velocities below this part of the velocity that the force alone gives in the step count
/// as zero.
constexpr double keptTolerance = 0.003;

/// The fate for an opening velocity, given as a part of that velocity.
Fate fateOf(double opening);
std::vector<Fate> fatesOf(const delassus::VectorXd& openings);

/// One step of a bead of 1 kg that touches planes of these normals, under `force`: the opening
/// velocity of each contact, as a part of the velocity h F that the force alone would give.
delassus::VectorXd stepBead(const std::vector<btVector3>& normals, const btVector3& force,
                            const std::string& solver);

/// The places of the bead of such a world (x, y; m), at the start and after each step on our
/// solver.
std::vector<Eigen::Vector2d> trackBead(std::unique_ptr<World> world, double seconds);

/// A rod that leans on rough ground with its lower end: the paper's single contact with friction
/// added. It leans in the plane of x and y (up); its centre of mass is up and to the right of the
/// contact.
struct LeaningRod {
  double lean;      ///< from the horizontal, radians
  double friction;  ///< Coulomb's μ
};

/// The contact of the leaning rod as Bullet's world describes it before a step, and as the step
/// leaves it: normal (y) first, then x, z.
struct RodStep {
  delassus::Mat3 W;
  delassus::Vec3 q, u;
};

/// One step under `force` at the centre of mass (x, y; N) and nothing else.
RodStep stepLeaningRod(const LeaningRod& rod, const Eigen::Vector2d& force);

/// A force on the rod on two supports: `up` newtons (negative: a weight) at `x` metres right of its
/// middle.
struct Load {
  double x, up;
};

/// One step of the rod that rests on supports at ±a. Contact 1 is the right one.
struct SupportStep {
  Eigen::Matrix2d W;
  Eigen::Vector2d q;         ///< m/s
  Eigen::Vector2d reaction;  ///< that the solver wrote, N·s
};
SupportStep stepRodOnSupports(double a, const Load& load);

/// The place of the rod: middle and inclination, m and radians.
struct RodPose {
  double x, y, angle;
};

/// The rod's pose after `seconds` under a moving load.
RodPose runRodOnSupports(double a, const std::function<Load(double time)>& load, double seconds);

}  // namespace demos::atlas
