#include <zip.h>

#include <cstdint>
#include <memory>

#include "engine/core/error.h"
#include "engine/dataset/zip.h"

namespace macula::dataset {
namespace {

/// 1980-01-01, the first day that a zip can name, as two fields: years since 1980, month, day, and
/// hours, minutes, seconds. Noon: libzip takes the fields through local time and back, and no time
/// zone skips that hour.
constexpr std::uint16_t kDate = (0U << 9U) | (1U << 5U) | 1U;
constexpr std::uint16_t kTime = 12U << 11U;
/// zlib's usual effort, 1 to 9; named, so that another default does not change the bytes.
constexpr zip_uint32_t kEffort = 6;

/// Leaves nothing on the disk where the zip is not closed.
struct Discard {
  void operator()(zip_t* zip) const { zip_discard(zip); }
};

[[noreturn]] void fail(const std::filesystem::path& path, const char* reason) {
  failInput("{}: cannot be written ({}); check the folder and the space left", path.string(),
            reason);
}

/// Fails with libzip's reason where `good` is false.
void require(bool good, zip_t* zip, const std::filesystem::path& path) {
  if (!good) fail(path, zip_strerror(zip));
}

void addEntry(zip_t* zip, const ZipEntry& entry, const std::filesystem::path& path) {
  constexpr int kFreeIt = 0;  // the bytes stay the caller's
  zip_source_t* source = zip_source_buffer(zip, entry.bytes.data(), entry.bytes.size(), kFreeIt);
  require(source != nullptr, zip, path);
  const zip_int64_t added = zip_file_add(zip, entry.name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (added < 0) zip_source_free(source);  // otherwise the zip owns it
  require(added >= 0, zip, path);
  const auto index = static_cast<zip_uint64_t>(added);
  require(zip_set_file_compression(zip, index, ZIP_CM_DEFLATE, kEffort) == 0, zip, path);
  require(zip_file_set_dostime(zip, index, kTime, kDate, 0) == 0, zip, path);
}

}  // namespace

bool zipSupported() {
  return true;
}

void writeZip(const std::filesystem::path& path, const std::filesystem::path& shownPath,
              std::span<const ZipEntry> entries) {
  int code = 0;
  std::unique_ptr<zip_t, Discard> zip(zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code));
  if (!zip) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    const std::string reason = zip_error_strerror(&error);
    zip_error_fini(&error);
    fail(shownPath, reason.c_str());
  }
  for (const ZipEntry& entry : entries) addEntry(zip.get(), entry, shownPath);
  require(zip_close(zip.get()) == 0, zip.get(), shownPath);  // writes; frees only where it succeeds
  static_cast<void>(zip.release());
}

}  // namespace macula::dataset
