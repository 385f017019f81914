// Linked programs, made from the shader files and cached by file and defines.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/gl/objects.h"
#include "engine/gl/program_binaries.h"
#include "engine/gl/shader_source.h"

namespace macula::gl {

/// Which program: files relative to the shader folder, and what is defined for all of them.
struct ProgramKey {
  std::vector<std::string> files;
  Defines defines;
  std::vector<std::string> extensions;
  auto operator<=>(const ProgramKey&) const = default;
};

/// Compiles and links on first use, or loads what an earlier run has linked. Lives as long as the
/// context.
class ProgramCache {
 public:
  /// Called twice for each program while they are made. @param done steps, from 1 · @param total
  using Progress = std::function<void(std::size_t done, std::size_t total)>;

  /// @param binaries of earlier runs
  explicit ProgramCache(std::filesystem::path shaderFolder, ProgramBinaries binaries = {});
  /// @returns the GL name of the program, which is linked unless a batch lives
  /// @throws std::runtime_error with the compiler's messages (a mistake in Macula or the driver)
  GLuint get(const ProgramKey& key);
  /// From now on, defines for every program besides those of its key: what the device asks for.
  void setDefines(Defines defines) { defines_ = std::move(defines); }
  /// From now on, programs that get() returns are also noted here; nullptr ends it.
  void record(std::vector<GLuint>* into) { record_ = into; }
  void onProgress(Progress progress) { progress_ = std::move(progress); }
  [[nodiscard]] const ProgramBinaries& binaries() const { return binaries_; }

  /// While it lives, get() only names programs. finish() compiles and links them together, so that
  /// a driver may use several threads (GL_KHR_parallel_shader_compile); without finish(), those
  /// that are not linked are forgotten.
  class Batch {
   public:
    explicit Batch(ProgramCache& programs) : programs_(programs) { programs_.batched_ = true; }
    ~Batch() { programs_.endBatch(); }
    Batch(const Batch&) = delete;
    Batch& operator=(const Batch&) = delete;
    /// @throws std::runtime_error as get()
    void finish() { programs_.makeWaiting(); }

   private:
    ProgramCache& programs_;
  };

 private:
  /// A program between get() and its link.
  struct Job {
    ProgramKey key;
    GLuint program = 0;
    std::string binary;  ///< its name among the binaries
    bool loaded = false;
  };
  void makeWaiting();
  void endBatch();
  void issue(Job& job);
  void complete(const Job& job);

  std::vector<GLuint>* record_ = nullptr;
  std::filesystem::path folder_;
  ProgramBinaries binaries_;
  Progress progress_;
  Defines defines_;
  std::map<ProgramKey, ProgramId> programs_;
  std::vector<Job> waiting_;  ///< named and not linked
  bool batched_ = false;
};

}  // namespace macula::gl
