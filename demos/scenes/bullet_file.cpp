#include "demos/scenes/bullet_file.h"

#include <btBulletDynamicsCommon.h>
#include <btBulletWorldImporter.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace demos {

namespace {

std::string readBytes(const std::string& path) {
  std::error_code ignored;  // of what cannot be looked at: it cannot be opened either
  if (std::filesystem::is_directory(path, ignored))
    throw BulletFileError(path + ": is a directory, not a .bullet file");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw BulletFileError(
        path + ": cannot be opened: " + (errno != 0 ? std::strerror(errno) : "input error"));
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Bullet's importer trusts what it reads. A file goes through it only if every chunk of
///
///     "BULLET", f or d, _ or - (4 or 8 byte pointers), v or V (little or big endian), version;
///     chunks; the chunk "DNA1"
///
/// lies within the file; a chunk begins with its code, its length, a pointer and two counts.
void checkChunks(const std::string& path, const std::string& bytes) {
  constexpr std::size_t headerSize = 12, codeSize = 4;
  if (bytes.size() < headerSize || bytes.compare(0, 6, "BULLET") != 0)
    throw BulletFileError(path + ": is not a .bullet file (it should begin with 'BULLET')");
  const std::size_t chunkHead = bytes[7] == '-' ? 24 : 20;
  const bool bigEndian = bytes[8] == 'V';
  std::size_t place = headerSize;
  while (place + chunkHead <= bytes.size()) {
    std::uint32_t length = 0;
    for (int i = 0; i < 4; ++i) {
      const auto byte = static_cast<unsigned char>(bytes[place + codeSize + std::size_t(i)]);
      length |= std::uint32_t(byte) << 8 * (bigEndian ? 3 - i : i);
    }
    const bool last = bytes.compare(place, codeSize, "DNA1") == 0;
    place += chunkHead + length;
    if (last && place <= bytes.size()) return;
    if (last) break;
  }
  throw BulletFileError(path + ": ends too early or is damaged (" + std::to_string(bytes.size()) +
                        " bytes, without a whole 'DNA1' chunk at its end)");
}

/// Bullet asks a hull for its farthest point. If the hull has no points it reads invalid memory,
/// but only once something comes near.
bool hasPoints(const btCollisionShape& shape) {
  if (shape.isCompound()) {
    const auto& compound = static_cast<const btCompoundShape&>(shape);
    for (int i = 0; i < compound.getNumChildShapes(); ++i)
      if (!hasPoints(*compound.getChildShape(i))) return false;
    return true;
  }
  if (shape.getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE)
    return static_cast<const btConvexHullShape&>(shape).getNumPoints() > 0;
  if (shape.getShapeType() == MULTI_SPHERE_SHAPE_PROXYTYPE)
    return static_cast<const btMultiSphereShape&>(shape).getSphereCount() > 0;
  return true;
}

void checkShapes(const std::string& path, const btCollisionObjectArray& objects) {
  for (int i = 0; i < objects.size(); ++i)
    if (!hasPoints(*objects[i]->getCollisionShape()))
      throw BulletFileError(path + ": is damaged: the shape of object " + std::to_string(i) +
                            " has no points");
}

std::string describe(const btVector3& v) {
  std::ostringstream text;
  text << "(" << v.x() << ", " << v.y() << ", " << v.z() << ")";
  return text.str();
}

std::string describe(const btContactSolverInfo& info) {
  std::ostringstream text;
  text << info.m_numIterations << " iterations, erp " << info.m_erp << ", erp2 " << info.m_erp2
       << ", cfm " << info.m_globalCfm << ", split impulse "
       << (info.m_splitImpulse != 0 ? "on" : "off");
  return text.str();
}

}  // namespace

LoadedFile loadBulletFile(const std::string& path) {
  checkChunks(path, readBytes(path));

  LoadedFile loaded;
  loaded.world = std::make_unique<World>();
  btDiscreteDynamicsWorld& dynamics = loaded.world->dynamics();
  const btContactSolverInfo usual = dynamics.getSolverInfo();

  // The importer allocates everything it makes, and frees it only when told to.
  const auto release = [](btBulletWorldImporter* importer) {
    importer->deleteAllData();
    delete importer;
  };
  std::shared_ptr<btBulletWorldImporter> importer(new btBulletWorldImporter(&dynamics), release);
  if (!importer->loadFile(path.c_str()))
    throw BulletFileError(path +
                          ": Bullet's importer cannot read it (damaged, or of another version)");
  loaded.world->keep(importer);
  checkShapes(path, dynamics.getCollisionObjectArray());

  const std::string inFile = describe(dynamics.getSolverInfo());
  dynamics.getSolverInfo() = usual;
  loaded.notes.push_back(std::to_string(importer->getNumRigidBodies()) + " bodies, " +
                         std::to_string(importer->getNumConstraints()) + " joints");
  loaded.notes.push_back("kept from the file: gravity " + describe(dynamics.getGravity()) +
                         " m/s^2, masses, materials, joints");
  loaded.notes.push_back("not kept: its solver settings (" + inFile + "); instead " +
                         describe(usual));
  return loaded;
}

}  // namespace demos
