#include "engine/measure/oracle.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <stdexcept>
#include <utility>

namespace macula::measure {
namespace {

double squaredDistance(const glm::vec3& a, const glm::vec3& b) {
  const glm::dvec3 difference = glm::dvec3(a) - glm::dvec3(b);
  return glm::dot(difference, difference);
}

}  // namespace

std::span<const double> ErrorCurve::of(std::size_t pixel) {
  const std::span<const glm::vec3> colours = sweep_.colours(image_, pixel);
  const glm::vec3 exact = display_(colours.back());
  errors_.clear();
  for (const glm::vec3& colour : colours) {
    // What lies behind an opaque layer changes nothing; encoding is the expensive part.
    errors_.push_back(colour == colours.back() ? 0.0 : squaredDistance(display_(colour), exact));
  }
  return errors_;
}

LayerChoice evaluate(const FragmentImage& image, std::vector<std::uint32_t> k, Tail tail,
                     const DisplayTransform& display) {
  requireConsistent(image);
  if (k.size() != image.pixels()) {
    throw std::invalid_argument("numbers of slots for an image of another size");
  }
  LayerChoice choice;
  choice.k = std::move(k);
  choice.image.reserve(image.pixels());
  LayerSweep sweep(tail);
  double squares = 0.0;
  for (std::size_t pixel = 0; pixel < image.pixels(); ++pixel) {
    std::uint32_t& slots = choice.k[pixel];
    slots = std::min(slots, image.depth(pixel));
    choice.slots += slots;
    const std::span<const glm::vec3> colours = sweep.colours(image, pixel);
    choice.image.push_back(display(colours[slots]));
    if (slots < image.depth(pixel)) {
      squares += squaredDistance(choice.image.back(), display(colours.back()));
    }
  }
  choice.rmse = std::sqrt(squares / (3.0 * static_cast<double>(image.pixels())));
  return choice;
}

LayerChoice optimalK(const FragmentImage& image, std::uint64_t budget,
                     const DisplayTransform& display) {
  requireConsistent(image);
  // cd(p) grows with the squared error, so the squares stand in its place.
  std::vector<double> errors(image.fragments.size());  // at offset + k: e(k), k = 0 .. depth - 1
  std::vector<std::uint32_t> k(image.pixels());
  using Node = std::pair<double, std::uint32_t>;  // error after the next removal, pixel
  std::vector<Node> nodes;
  ErrorCurve curve(image, Tail::None, display);
  for (std::size_t pixel = 0; pixel < image.pixels(); ++pixel) {
    k[pixel] = image.depth(pixel);
    if (k[pixel] < 2) continue;
    const std::span<const double> e = curve.of(pixel);
    std::copy_n(e.begin(), k[pixel],
                errors.begin() + static_cast<std::ptrdiff_t>(image.offsets[pixel]));
    nodes.emplace_back(e[k[pixel] - 1], static_cast<std::uint32_t>(pixel));
  }
  std::priority_queue heap(std::greater<Node>{}, std::move(nodes));
  for (std::uint64_t left = image.fragments.size(); left > budget && !heap.empty(); --left) {
    const std::uint32_t pixel = heap.top().second;
    heap.pop();
    if (--k[pixel] > 1) heap.emplace(errors[image.offsets[pixel] + k[pixel] - 1], pixel);
  }
  return evaluate(image, std::move(k), Tail::None, display);
}

}  // namespace macula::measure
