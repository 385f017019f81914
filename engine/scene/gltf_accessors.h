// Checked reading of glTF accessors: specification section 3.6.2.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/scene/gltf_document.h"

namespace macula::scene::gltf {

/// An accessor's elements as floats, tightly packed.
struct Elements {
  std::size_t count = 0;
  std::size_t components = 0;  ///< per element: 1..4, or 16 for MAT4
  std::vector<float> values;   ///< count * components

  /// Component c of element i.
  [[nodiscard]] float at(std::size_t i, std::size_t c) const { return values[i * components + c]; }
};

/// How integers become floats.
enum class Integers : std::uint8_t {
  AsDeclared,  ///< divided by their maximum where the accessor is marked normalized
  Normalized   ///< always divided, for attributes that have no other meaning as integers
};

/// The accessor itself. @throws InputError where the index leads nowhere
[[nodiscard]] const tinygltf::Accessor& accessorAt(const Document& document, std::int32_t index,
                                                   std::string_view place);

/// Reads the first `count` elements: any component type, stride and sparse substitution; zeros
/// where no buffer view stands behind them.
/// @param count at most the accessor's count, bounded by the caller
/// @throws InputError where the data do not lie inside their buffer
[[nodiscard]] Elements readElements(const Document& document, std::int32_t index, std::size_t count,
                                    std::string_view place,
                                    Integers integers = Integers::AsDeclared);

/// Reads an index accessor: SCALAR of unsigned 8, 16 or 32 bits.
/// @throws InputError also on the primitive restart value, which glTF forbids
[[nodiscard]] std::vector<std::uint32_t> readIndices(const Document& document, std::int32_t index,
                                                     std::string_view place);

}  // namespace macula::scene::gltf
