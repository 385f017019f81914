// Scenes of sheets across the view, and options of transparency, for the tests of stability.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "gl_fixture.h"

namespace macula::test {

/// An unlit rectangle that fills the view of the camera of sheets().
struct Sheet {
  float distance = 2.0F;  ///< metres ahead, on the view axis
  glm::vec4 color{1.0F, 1.0F, 1.0F, 0.5F};
  float slope = 0.0F;       ///< metres farther for each metre to the right, -0.5 .. 0.5
  float brightness = 0.0F;  ///< added to red, green and blue
  bool opaque = false;
};

/// One instance for each sheet, in this order, so that ids grow along it. Black background.
[[nodiscard]] scene::Scene sheets(const std::vector<Sheet>& list);

/// Nothing but the camera of sheets().
[[nodiscard]] scene::Scene emptyScene();

/// Adds an unlit rectangle parallel to the image. @param low, high corners, x and y in metres at
/// its distance
void addRectangle(scene::Scene& scene, float distance, glm::vec2 low, glm::vec2 high,
                  glm::vec4 color, bool opaque);

/// The scene with unlit materials: surfaces are of their own colour, and shaders compile fast.
[[nodiscard]] scene::Scene unlit(scene::Scene scene);

/// Colours that differ in every channel. @param i which
[[nodiscard]] glm::vec4 variedColor(int i, float alpha);

/// "Over" of premultiplied-by-alpha colours, nearest first, on `behind`, in float.
[[nodiscard]] glm::vec3 over(const std::vector<glm::vec4>& nearestFirst, glm::vec3 behind);

/// Linear output by these options.
[[nodiscard]] passes::RenderSettings settingsOf(const passes::OitSettings& oit);

/// The options in one line, for messages.
[[nodiscard]] std::string describe(const passes::OitSettings& oit);

/// kb-variable with utilities that a network corrects.
[[nodiscard]] passes::OitSettings learnedUtility(double kAve, int fragmentBytes = 16);

/// All combinations of tail x fill x importance x fragmentBytes x sync of the synchronised sorted
/// k-buffers that are accepted, at this budget. Without culling and predicted counts.
[[nodiscard]] std::vector<passes::OitSettings> sortedCases(double kAve);

/// The methods that store every fragment, given room for so many a pixel, and their limits.
[[nodiscard]] std::vector<passes::OitSettings> completeCases(int layers);

/// Largest absolute difference of two images of one size.
[[nodiscard]] float largestDifference(const std::vector<float>& a, const std::vector<float>& b);

/// Values that are not equal.
[[nodiscard]] std::size_t countUnlike(const std::vector<float>& a, const std::vector<float>& b);

/// Whether no value is NaN or infinite.
[[nodiscard]] bool allFinite(const std::vector<float>& values);

/// A number for the record of the test and its output, under the name of the running test.
void note(const std::string& what, double value);

}  // namespace macula::test
