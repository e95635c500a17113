#pragma once
// How far two places of a body are from each other, as its material sees it: the compliance distance of F. Faure, B.
// Gilles, G. Bousquet, D. K. Pai, Sparse Meshless Models of Complex Deformable Solids, ACM Trans. Graph. 30(4), 2011.
// It is the shortest integral of 1/E along any path inside the body (mm/kPa). What is stiff is short, because it passes
// motion on, and what is soft is long. On a grid of voxels, by fast marching (J. A. Sethian, A fast marching level set
// method for monotonically advancing fronts, PNAS 93, 1996): first order, |grad d| = 1/E.
//
// A cut is a surface that no path may cross. Nothing else of the body changes with it.

#include <cstdint>
#include <Eigen/Core>
#include <limits>
#include <vector>

#include "geometry/tetrahedra.h"
#include "imaging/image.h"
#include "mechanics/scenario/cut.h"

namespace glisson::mechanics {

// A body as cubes. `youngs_kPa` has one value a voxel of the grid, and is read inside the body alone.
struct VoxelBody {
  imaging::Mask body;
  std::vector<float> youngs_kPa;
};

// A voxel is inside where its centre lies in a tetrahedron. So that thin parts are not lost, it is also inside where it
// holds a point of the mesh. The grid is axis-aligned, its voxels cubes of the given edge, with an empty layer all
// around. The mesh must have passed check_tetrahedra, and the grid must not exceed 2^31 voxels.
[[nodiscard]] VoxelBody voxelise(const geometry::TetMesh& mesh, const std::vector<double>& youngs_kPa,
                                 double spacing_mm);

// Voxels waiting with their distances, taken out by and by from near to far. They come in the order of buckets of one
// width, and within a bucket in any (L. Yatziv, A. Bartesaghi, G. Sapiro, O(N) implementation of the fast marching
// algorithm, J. Comput. Phys. 212, 2006), five times as fast as a heap. What is put in is no nearer than what was taken
// out last.
class Front {
 public:
  struct Waiting {
    float distance;
    std::uint32_t voxel;
  };
  void start(float width);
  void put(float distance, std::size_t voxel);
  // False where none waits.
  bool take(Waiting& next);

 private:
  static constexpr std::size_t maximum_buckets = 4096;  // what is farther waits apart

  float width_ = 1, first_ = 0;  // the first bucket begins at `first_`
  std::size_t bucket_ = 0;       // being emptied
  std::vector<std::vector<Waiting>> buckets_;
  std::vector<Waiting> beyond_;
};

class ComplianceDistance {
 public:
  // The cuts must be ones that can be made (CutInSpace::of).
  explicit ComplianceDistance(const VoxelBody& body, const std::vector<Cut>& cuts = {});

  static constexpr float unreached = std::numeric_limits<float>::infinity();

  // Which of the seeds each voxel is nearest to, and how far (mm/kPa). It is -1 and `unreached` outside the body, and
  // where no seed can be reached from. Seeds stand in voxels of the body.
  struct Voronoi {
    std::vector<int> owner;
    std::vector<float> distance;
  };
  [[nodiscard]] Voronoi voronoi(const std::vector<Eigen::Vector3d>& seeds_mm) const;

  // Every voxel (by its offset in the grid) within `limit` of one seed. They come from near to far, but for 1/8 of what
  // it costs to cross the stiffest voxel. `workspace` belongs to one thread and is kept from call to call.
  struct Reached {
    std::size_t voxel;
    float distance;
  };
  class Workspace;
  [[nodiscard]] std::vector<Reached> within(const Eigen::Vector3d& seed_mm, float limit, Workspace& workspace) const;

  // The step from a place in a voxel to the centre of a voxel beside it, or `unreached` where a cut stands between.
  // `seen_from_mm` is the place itself, or beside it, where the place lies on a cut.
  [[nodiscard]] float step(const Eigen::Vector3d& place_mm, const Eigen::Vector3d& seen_from_mm,
                           std::size_t voxel) const;

  [[nodiscard]] const imaging::Grid& grid() const { return body_->body.grid; }
  [[nodiscard]] bool inside(std::size_t voxel) const { return body_->body.values[voxel] != 0; }
  [[nodiscard]] std::size_t voxel_at(const Eigen::Vector3d& place_mm) const;
  [[nodiscard]] Eigen::Vector3d center_mm(std::size_t voxel) const;
  // The voxels around a voxel and itself, those inside the body (at most 27).
  [[nodiscard]] std::vector<std::size_t> around(std::size_t voxel) const;
  // Those that share a face with it, inside the body and behind no cut (at most 6).
  [[nodiscard]] std::vector<std::size_t> beside(std::size_t voxel) const;

  class Workspace {
   public:
    explicit Workspace(std::size_t voxels)
        : offered_(voxels, unreached), fixed_(voxels, unreached), owner_(voxels, -1) {}

   private:
    friend class ComplianceDistance;
    std::vector<float> offered_, fixed_;  // the best distance so far, and the one that stays
    std::vector<int> owner_;
    std::vector<std::size_t> touched_;
    Front front_;
  };

 private:
  void offer_around(const Eigen::Vector3d& seed_mm, int owner, Workspace& workspace) const;
  template <typename Visit>
  void march(float limit, Workspace& workspace, const Visit& visit) const;
  template <bool has_cuts, typename Visit>
  void march_past(float limit, Workspace& workspace, const Visit& visit) const;
  static void offer(std::size_t voxel, float distance, int owner, Workspace& workspace);
  template <bool has_cuts>
  [[nodiscard]] float upwind(std::size_t voxel, int& owner, const Workspace& workspace) const;
  [[nodiscard]] bool open(std::size_t from, int axis, int sign) const;

  const VoxelBody* body_;
  std::vector<float> across_;  // what it costs to cross a voxel (mm/kPa); unreached outside the body
  float minimum_across_ = unreached;
  std::vector<CutInSpace> cuts_;
  std::array<std::ptrdiff_t, 3> stride_;
  std::vector<std::uint8_t> blocked_;  // bit a: the way from a voxel to the next along axis a is cut; empty: no cuts
};

}  // namespace glisson::mechanics
