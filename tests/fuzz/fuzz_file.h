#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace noonmark::tests {

/// The input as text.
inline std::string_view formatText(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// This process's own folder below TMPDIR, which packaging/fuzz places in memory. The first call creates it
/// and limits TBB to one thread, so that findings are reproducible.
const std::filesystem::path& fuzzFolder();

/// Writes a file into fuzzFolder(), replacing the last one of that name.
std::filesystem::path fuzzFile(const std::string& name, std::string_view bytes);

}  // namespace noonmark::tests
