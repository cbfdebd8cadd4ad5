#include "host/render/bvh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace quell::render {
namespace {

constexpr int kBins = 16;
constexpr int kLeafSize = 2;
// Deeper nodes become leaves; kernels/render/traverse.h keeps one waiting node a level (QUELL_BVH_STACK of them).
constexpr int kMaxDepth = 44;
// Rounded outwards, since the kernels intersect boxes in single precision.
constexpr float kSlackM = 1e-5f;

class Builder {
 public:
  explicit Builder(const std::vector<Bounds>& boxes) : m_boxes(boxes) {
    m_bvh.order.resize(boxes.size());
    std::iota(m_bvh.order.begin(), m_bvh.order.end(), 0);
    m_bvh.nodes.emplace_back();
    build(0, 0, int(boxes.size()), 0);
  }

  Bvh take() { return std::move(m_bvh); }

 private:
  const Bounds& boxAt(int position) const { return m_boxes[std::size_t(m_bvh.order[std::size_t(position)])]; }

  void build(std::size_t node, int first, int count, int depth) {
    Bounds bounds;
    for (int i = first; i < first + count; ++i) bounds.include(boxAt(i));
    const int middle = count <= kLeafSize || depth >= kMaxDepth ? first : split(first, count);
    const bool leaf = middle <= first || middle >= first + count;
    RenderBvhNode& target = m_bvh.nodes[node];
    for (int axis = 0; axis < 3; ++axis) {
      target.low[axis] = float(bounds.low[axis]) - kSlackM * (1.0f + std::abs(float(bounds.low[axis])));
      target.high[axis] = float(bounds.high[axis]) + kSlackM * (1.0f + std::abs(float(bounds.high[axis])));
    }
    target.first = leaf ? first : int(m_bvh.nodes.size());
    target.count = leaf ? count : 0;
    if (leaf) {
      // An inner node is told by its count; the empty tree is a leaf of no primitives whose children are never there.
      return;
    }
    const std::size_t children = m_bvh.nodes.size();
    m_bvh.nodes.resize(children + 2);
    build(children, first, middle - first, depth + 1);
    build(children + 1, middle, first + count - middle, depth + 1);
  }

  /// Reorders the range about the best plane between bins; returns where the second half begins.
  int split(int first, int count) {
    Bounds centers;
    for (int i = first; i < first + count; ++i) {
      const glm::dvec3 c = boxAt(i).center();
      centers.include({c, c});
    }
    const glm::dvec3 extent = centers.high - centers.low;
    double bestCost = std::numeric_limits<double>::infinity();
    int bestAxis = 0, bestPlane = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (extent[axis] <= 0.0) continue;
      const auto [cost, plane] = bestPlaneOf(axis, first, count, centers);
      if (cost < bestCost) {
        bestCost = cost;
        bestAxis = axis;
        bestPlane = plane;
      }
    }
    if (bestCost == std::numeric_limits<double>::infinity()) return first + count / 2;  // all in one place
    const auto begin = m_bvh.order.begin() + first;
    const auto middle = std::stable_partition(begin, begin + count, [&](int index) {
      return binOf(m_boxes[std::size_t(index)], bestAxis, centers) < bestPlane;
    });
    return int(middle - m_bvh.order.begin());
  }

  static int binOf(const Bounds& box, int axis, const Bounds& centers) {
    const double share = (box.center()[axis] - centers.low[axis]) / (centers.high[axis] - centers.low[axis]);
    return std::clamp(int(share * kBins), 0, kBins - 1);
  }

  /// Least of (boxes * area) summed over both sides, and the bin that begins the second.
  std::pair<double, int> bestPlaneOf(int axis, int first, int count, const Bounds& centers) const {
    std::array<Bounds, kBins> bounds;
    std::array<int, kBins> counts{};
    for (int i = first; i < first + count; ++i) {
      const std::size_t bin = std::size_t(binOf(boxAt(i), axis, centers));
      bounds[bin].include(boxAt(i));
      ++counts[bin];
    }
    std::array<double, kBins> costBelow{};
    Bounds below;
    int countBelow = 0;
    for (std::size_t plane = 1; plane < kBins; ++plane) {
      below.include(bounds[plane - 1]);
      countBelow += counts[plane - 1];
      costBelow[plane] = countBelow * below.halfArea();
    }
    std::pair<double, int> best{std::numeric_limits<double>::infinity(), 0};
    Bounds above;
    int countAbove = 0;
    for (std::size_t plane = kBins - 1; plane >= 1; --plane) {
      above.include(bounds[plane]);
      countAbove += counts[plane];
      if (countAbove == 0 || countAbove == count) continue;
      const double cost = costBelow[plane] + countAbove * above.halfArea();
      if (cost < best.first) best = {cost, int(plane)};
    }
    return best;
  }

  const std::vector<Bounds>& m_boxes;
  Bvh m_bvh;
};

}  // namespace

double Bounds::halfArea() const {
  const glm::dvec3 e = high - low;
  return e.x < 0.0 ? 0.0 : e.x * e.y + e.y * e.z + e.z * e.x;
}

Bvh buildBvh(const std::vector<Bounds>& boxes) { return Builder(boxes).take(); }

}  // namespace quell::render
