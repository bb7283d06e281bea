#pragma once

#include <array>
#include <memory>
#include <random>
#include <vector>

#include "demos/scenes/scene.h"

namespace demos {

/// Coulomb's coefficient between any two bodies, unless a scene says otherwise.
constexpr double usualFriction = 0.5;

/// The default of all scenes: half size 0.5 m, 1 kg.
constexpr double unitHalf = 0.5;

/// Numbers of at most `size` that displace bodies, so that a pile has no preferred direction. They
/// are the same in every run, on every machine.
class Jitter {
 public:
  explicit Jitter(double size) : size_(size) {}
  double operator()();

 private:
  std::mt19937_64 random_{1920};
  double size_;
};

/// Half the side of the ground of most scenes, m.
constexpr double usualGround = 50;

/// A slab whose upper face is the plane y = 0; `mu` is the friction that bodies of the same surface
/// find on it.
btRigidBody& addGround(World& world, double mu = usualFriction, double halfSize = usualGround);

/// A box of `mass` kg centred at (x, y, z), with friction `mu` against its like.
btRigidBody& addBox(World& world, const btVector3& halfSize, btScalar mass, const btTransform& pose,
                    double mu = usualFriction);

// --- The paper's bodies
// -----------------------------------------------------------------------------------------

/// The weight that the forces on a 1 kg bead have in these scenes, N.
constexpr double beadForce = 9.81;

/// A frictionless bead of 1 kg and radius 0.5 m at the origin. It touches one plane for each unit
/// normal (pointing from the plane to the bead), under the constant force `force` and no other.
std::unique_ptr<World> buildBead(const std::vector<btVector3>& normals, const btVector3& force);

/// Two planes with n1·n2 = cosine: n1 = e_y, n2 in the plane x, y.
std::array<btVector3, 2> angleNormals(double cosine);
/// The bead in that angle, pulled in the direction (cos a, sin a, 0), a = `forceAngle` in radians.
std::unique_ptr<World> buildBeadInAngle(double cosine, double forceAngle);

/// Three planes around e_y, each leaning so that n_i·e_y = `height` (0 < height < 1).
std::array<btVector3, 3> trihedronNormals(double height);
std::unique_ptr<World> buildBeadInTrihedron(double height, const btVector3& direction);

/// A frictionless rod of 1 kg and 4 m on two supports at x = ±a; `pull` N pull its end at x = +2 m
/// up. Supports further apart than the radius of gyration feel each other with B < 0, closer ones
/// with B > 0.
std::unique_ptr<World> buildRodOnSupports(double a, double pull);

/// A frictionless ball of radius 0.25 m at rest on a fixed one of radius 0.75 m, its centre line at
/// `startAngle` from the vertical. It leaves where cos θ = 2/3 cos(startAngle).
std::unique_ptr<World> buildBallOffBall(double startAngle);

/// A rod of 2 m between their ends' centres, leaning without friction on a wall and a floor at
/// `startAngle` from the horizontal. Its centre starts at height sin(startAngle) and leaves the
/// wall at two thirds of it.
std::unique_ptr<World> buildSlidingLadder(double startAngle);

// --- Friction
// -------------------------------------------------------------------------------------------------

/// A unit box on a slope, turned by `heading` about the slope's normal. Radians.
struct Slope {
  double angle = 0;
  double heading = 0;
};
/// One slope a lane, falling towards +x, lanes 4 m apart along z.
std::unique_ptr<World> buildInclines(const std::vector<Slope>& slopes, double mu = usualFriction);
/// The friction angle atan μ, radians.
double frictionAngle(double mu = usualFriction);

/// `count` unit boxes, all with the same orientation, pushed outwards at `speed` from a circle of
/// radius 4 m.
std::unique_ptr<World> buildBoxHeadings(int count, double speed);
constexpr double headingsRadius = 4;

/// A ball of radius 0.5 m whose rolling friction is κ times its load.
struct RollingBall {
  double kappa = 0;  ///< m
  double mass = 1;
};
/// One ball a lane, rolling towards +x from x = 0 without slip. It runs v² / (10/7 κ g / R) far.
std::unique_ptr<World> buildRollingBalls(const std::vector<RollingBall>& balls, double speed);
constexpr double rollingRadius = 0.5;

// --- Boxes
// -------------------------------------------------------------------------------------------------

/// `side` x `side` unit boxes on the ground, `spacing` apart.
std::unique_ptr<World> buildGridOfBoxes(int side, double spacing);
/// `count` unit boxes one on the other; all weigh 1 kg except the top one.
std::unique_ptr<World> buildStack(int count, double topMass);
/// A wall-like pyramid: `base` unit boxes in the lowest row, 1.05 m apart, one less in each row
/// above.
std::unique_ptr<World> buildPyramid(int base);
std::unique_ptr<World> buildWall(int columns, int rows);
std::unique_ptr<World> buildDominoRun(int count);
std::unique_ptr<World> buildCardHouse(int storeys);
/// A bin of 4 x 3 m that contains boxes of 1 kg and half a metre. After two seconds one of its
/// walls closes at 0.5 m/s, whatever is in its way, until 2.2 x 3 m are left.
std::unique_ptr<World> buildCompactor(int boxes);

// --- Round and hung things
// --------------------------------------------------------------------------------------

/// side³ spheres of radius 0.45 m poured into a bin of side x side metres.
std::unique_ptr<World> buildSpheresBin(int side);
std::unique_ptr<World> buildHeavyBallChain(int links, double ballMass);
/// Planks of 2 kg and a metre between two posts, straight, with hinges at their ends; a crate falls
/// on their middle from 15 cm.
std::unique_ptr<World> buildPlankBridge(int planks, double loadMass);
std::unique_ptr<World> buildNewtonCradle(int balls);
/// A doll of eleven limbs of 1 kg, 1.9 m tall at scale 1, with its feet at `place` and friction
/// `mu` against its like.
void addDoll(World& world, const btTransform& place, double scale = 1, double mu = usualFriction);
std::unique_ptr<World> buildRagdolls(int count);
std::unique_ptr<World> buildGripper();

/// A semicircular arch of centre-line radius 5 m and friction 0.7.
std::unique_ptr<World> buildArch(int voussoirs, double thickness);

}  // namespace demos
