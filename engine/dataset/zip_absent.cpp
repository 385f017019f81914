// The zip of builds without libzip (MACULA_DATASET=OFF): an error.
#include "engine/core/error.h"
#include "engine/dataset/zip.h"

namespace macula::dataset {

bool zipSupported() {
  return false;
}

void writeZip(const std::filesystem::path& /*path*/, const std::filesystem::path& shownPath,
              std::span<const ZipEntry> /*entries*/) {
  failInput("{}: this build writes no .npz; build with -DMACULA_DATASET=ON", shownPath.string());
}

}  // namespace macula::dataset
