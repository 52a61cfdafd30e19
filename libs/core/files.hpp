// Reading whole files with a clear error, and writing them whole or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace amiss {

/// The bytes of a file; InputError when it cannot be read, is a folder or is larger than the limit.
[[nodiscard]] std::string load_bytes(const std::filesystem::path& file, std::size_t max_bytes = std::size_t{1} << 30);

/// Temporary file in the same folder, checked write, fsync, rename. std::runtime_error when that fails; the old file
/// then is as it was.
void save_atomically(const std::filesystem::path& file, std::string_view bytes);

/// SHA-256 in lower-case hex.
[[nodiscard]] std::string sha256(std::string_view bytes);

}  // namespace amiss
