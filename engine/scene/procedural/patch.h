// Curved surfaces given by a grid of points: car bodies, animals, wings.
#pragma once

#include <cstddef>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "engine/scene/scene.h"

namespace macula::scene {

struct PatchPoint {
  glm::vec3 position{0.0F};  ///< metres
  glm::vec2 uv{0.0F};
  glm::vec4 color{1.0F};  ///< linear RGB and alpha
};

/// Points in rows and columns, at least two of each. The surface faces to
/// cross(next column, next row).
class Patch {
 public:
  Patch(int rows, int columns)
      : rows_(rows),
        columns_(columns),
        points_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns)) {}

  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int columns() const { return columns_; }
  [[nodiscard]] PatchPoint& at(int row, int column) { return points_[index(row, column)]; }
  [[nodiscard]] const PatchPoint& at(int row, int column) const {
    return points_[index(row, column)];
  }
  [[nodiscard]] std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

 private:
  int rows_;
  int columns_;
  std::vector<PatchPoint> points_;
};

/// Whether the cell between (row, column) and (row + 1, column + 1) is wanted.
using ChooseCell = std::function<bool(int row, int column)>;

/// Appends a patch with smooth normals: the sum of the adjoining triangles' by area. Where the last
/// column lies on the first one, and where all points of an end row coincide, the seam is smooth
/// too. Triangles that stand across the normals of their corners are flat; those without area are
/// left out.
/// @param choose cells to append, all where it is empty; the normals are those of the whole patch
void addPatch(Primitive& mesh, const Patch& patch, const ChooseCell& choose = {});

/// A curve through points (x, y) with x increasing, monotone between them: Fritsch & Butland 1984,
/// "A Method for Constructing Local Monotone Piecewise Cubic Interpolants", in its simplest form,
/// the harmonic mean of both slopes. Constant beyond its ends.
/// @param keys at least one
[[nodiscard]] float curveAt(std::span<const glm::vec2> keys, float x);

/// Catmull-Rom spline (Catmull & Rom 1974) from p1 (t = 0) to p2 (t = 1).
[[nodiscard]] glm::vec3 splineBetween(const glm::vec3& p0, const glm::vec3& p1, const glm::vec3& p2,
                                      const glm::vec3& p3, float t);

}  // namespace macula::scene
